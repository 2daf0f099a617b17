#include "core/fetch/note_file.h"

#include "core/formats/atomic_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <fstream>

namespace vp::fetch {

Notes readNotes(const std::string& path) {
  Notes notes;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (const std::size_t colon = line.find(": "); colon != std::string::npos) {
      notes[line.substr(0, colon)] = line.substr(colon + 2);
    }
  }
  return notes;
}

Result<void> writeNotes(const std::string& path, const Notes& notes) {
  std::string text;
  for (const auto& [key, value] : notes) {
    text += fmt::format("{}: {}\n", key, value);
  }
  return formats::writeFileAtomically(path, text);
}

std::string timeNow() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace vp::fetch
