// volplane-cli: the whole job without a window. Exit status: 0 done, 1 no solution, 2 bad input or usage,
// 3 verification failed, 130 stopped.
#include "app/cli/commands.h"
#include "core/formats/atomic_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <system_error>

namespace vp::cli {

std::string programVersion() {
  return "volplane-cli " VOLPLANE_VERSION;
}

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Plans closed surveillance tours from every point of which the aircraft can glide to a runway.", "volplane-cli"};
  app.set_version_flag("--version", programVersion());
  app.require_subcommand(1);
  app.fallthrough();
  Common common;
  app.add_flag("--json", common.json, "Print results as JSON");
  app.add_flag("-q,--quiet", common.quiet, "Print errors only");
  int status = kDone;
  addPlanCommand(app, common, status);
  addVerifyCommand(app, common, status);
  addExportCommand(app, common, status);
  addRenderCommand(app, common, status);
  addBriefCommand(app, common, status);
  addInfoCommand(app, common, status);
  addFetchTerrainCommand(app, common, status);
  addFetchAirfieldsCommand(app, common, status);
  addNewMissionCommand(app, common, status);
  addSafeAltitudeCommand(app, common, status);
  addImportTargetsCommand(app, common, status);
  addLandCommand(app, common, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  return status;
}

}  // namespace
}  // namespace vp::cli

namespace {

/// What was printed and could not be written (a full disk behind a redirection) must not pass for done.
int outputFailed(int code) {
  fmt::print(stderr, "volplane-cli: the results cannot be written: {}\n", vp::formats::writeFailureReason(code));
  return vp::cli::kBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int status = vp::cli::run(argc, argv);
    errno = 0;
    return std::fflush(stdout) != 0 || std::ferror(stdout) != 0 ? outputFailed(errno != 0 ? errno : EIO) : status;
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) {
      const auto* why = dynamic_cast<const std::system_error*>(&error);
      return outputFailed(why != nullptr ? why->code().value() : EIO);
    }
    fmt::print(stderr, "volplane-cli: {}; please report this\n", error.what());
    return vp::cli::kBadInput;
  }
}
