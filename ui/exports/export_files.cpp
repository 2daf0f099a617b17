#include "ui/exports/export_files.h"

#include "core/base/expect.h"
#include "core/formats/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace vp::exports {
namespace {

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

std::string partText(int part, int parts) {
  return parts > 1 ? fmt::format("{}of{}", part, parts) : "";
}

/// What no file system of ours or of a memory card takes; a name of dots alone would be a folder.
std::string safeName(std::string name) {
  for (char& c : name) {
    const bool isForbidden = static_cast<unsigned char>(c) < 0x20 || std::string("/\\:*?\"<>|").find(c) != std::string::npos;
    c = isForbidden ? '-' : c;
  }
  constexpr std::size_t kLongest = 120;  // bytes; file systems take 255 with everything that is appended
  std::size_t end = std::min(name.size(), kLongest);
  while (end < name.size() && end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u) {
    --end;
  }
  name.resize(end);
  const std::size_t first = name.find_first_not_of(". ");
  return first == std::string::npos ? "tour" : name.substr(first);
}

}  // namespace

std::string fileNameOf(const std::string& pattern, const std::string& mission, const formats::ExportFormat& format, int part, int parts) {
  std::string name = pattern.empty() ? kNamePattern : pattern;
  if (parts > 1 && name.find("{part}") == std::string::npos) {
    name += "-{part}";
  }
  replaceAll(name, "{format}", format.name);
  replaceAll(name, "{part}", partText(part, parts));
  replaceAll(name, "{mission}", mission.empty() ? "tour" : mission);
  return safeName(std::move(name)) + "." + format.extension;
}

std::vector<std::string> pathsOf(const PreparedExport& prepared, const std::string& folder, const std::string& pattern, const std::string& mission) {
  std::vector<std::string> paths;
  for (const ExportFile& file : prepared.files) {
    const auto pathFor = [&](const std::string& p) {
      return (std::filesystem::path(folder) / fileNameOf(p, mission, *file.format, file.part, file.parts)).string();
    };
    std::string path = pathFor(pattern);
    if (std::find(paths.begin(), paths.end(), path) != paths.end()) {
      path = pathFor((pattern.empty() ? std::string(kNamePattern) : pattern) + "-{format}");
    }
    paths.push_back(path);
  }
  return paths;
}

std::vector<std::string> pathsOf(const PreparedExport& prepared, const std::string& path) {
  std::vector<std::string> paths;
  for (const ExportFile& file : prepared.files) {
    std::filesystem::path own(path);
    if (file.parts > 1) {
      own.replace_filename(own.stem().string() + "-" + partText(file.part, file.parts) + own.extension().string());
    }
    paths.push_back(own.string());
  }
  return paths;
}

Result<std::vector<std::string>> writeExports(const PreparedExport& prepared, const std::vector<std::string>& paths) {
  VP_EXPECT(paths.size() == prepared.files.size());
  std::vector<std::string> backups;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::string backup;
    std::error_code error;
    if (std::filesystem::is_regular_file(paths[i], error)) {
      backup = paths[i] + "~";
      std::filesystem::copy_file(paths[i], backup, std::filesystem::copy_options::overwrite_existing, error);
      if (error) {
        return fail(Errc::OutputFailed, "the file that is there could not be copied to a backup (" + error.message() + "); nothing was overwritten",
                    backup);
      }
    }
    if (const Result<void> written = formats::writeFileAtomically(paths[i], prepared.files[i].bytes); !written) {
      return forward(written);
    }
    backups.push_back(backup);
  }
  return backups;
}

}  // namespace vp::exports
