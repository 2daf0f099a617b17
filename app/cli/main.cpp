// volplane-cli: the whole job without a window. Exit status: 0 done, 1 no solution, 2 bad input or usage,
// 3 verification failed, 130 stopped.
#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "ui/about/commit.h"
#include "ui/about/program_info.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <exception>

namespace vp::cli {
namespace {

std::string versionText() {
  const std::string_view commit = about::builtCommit();
  return about::versionText(QString::fromStdString(programVersion()), QString::fromLatin1(commit.data(), static_cast<qsizetype>(commit.size())))
      .toStdString();
}

int run(int argc, char** argv) {
  CLI::App app;
  Common common;
  int status = kDone;
  defineCommandLine(app, common, status, versionText);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  return status;
}

}  // namespace
}  // namespace vp::cli

int main(int argc, char** argv) {
  try {
    return vp::cli::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "volplane-cli: {}; please report this\n", error.what());
    return vp::cli::kBadInput;
  }
}
