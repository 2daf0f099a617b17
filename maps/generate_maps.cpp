// Writes the bundled maps and missions into a folder. The same bytes on every machine: see deterministic.h.
#include "maps/alpine.h"
#include "maps/mountain.h"
#include "maps/worlds.h"

#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

vp::Result<void> generate(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return vp::fail(vp::Errc::OutputFailed, "cannot be created: " + error.message(), folder);
  }
  for (const auto write : {vp::maps::writeMountain, vp::maps::writeWorlds, vp::maps::writeAlpine}) {
    if (const auto written = write(folder); !written) {
      return written;
    }
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: generate_maps FOLDER\n");
    return 2;
  }
  try {
    if (const auto done = generate(argv[1]); !done) {
      fmt::print(stderr, "{}\n", done.error().message());
      return 2;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
