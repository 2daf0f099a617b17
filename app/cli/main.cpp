// volplane-cli: the whole job without a window. Exit status: 0 done, 1 no solution, 2 bad input or usage,
// 3 verification failed, 130 stopped.
#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "core/formats/atomic_file.h"
#include "ui/about/commit.h"
#include "ui/about/program_info.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <system_error>

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
