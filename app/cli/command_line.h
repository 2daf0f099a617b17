#pragma once

#include "app/cli/console.h"

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace vp::cli {

/** Gives `app` all that volplane-cli understands: its name, its options and its commands. The program parses with it, the
 *  manual page is made from it. A command that is chosen sets `status` to its exit status.
 *  @param version  makes the text of --version, only when that is asked for */
void defineCommandLine(CLI::App& app, Common& common, int& status, std::function<std::string()> version);

}  // namespace vp::cli
