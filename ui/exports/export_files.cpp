#include "ui/exports/export_files.h"

#include "core/base/expect.h"
#include "core/formats/atomic_file.h"

#include <QCoreApplication>
#include <QString>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

namespace vp::exports {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Exports)
};

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

/// @return 0 or errno
int copyOver(const std::string& from, const std::string& to) {
  std::error_code error;
  const bool isCopied = std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, error);
  return isCopied && !error ? 0 : error ? error.value() : EIO;
}

/// What there was before an export. Unless told to forget it, puts it back in the end: files, copies and folders.
class Undo {
public:
  Undo() = default;
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;
  ~Undo();

  /// Makes a folder and what it lies in; "" is no folder.
  Result<void> makeFolder(const std::string& folder);
  /// @return false if there is a file that cannot be read
  bool remember(const std::string& path);
  void forget() {
    files_.clear();
    folders_.clear();
  }

private:
  struct File {
    std::string path;
    std::optional<std::string> before;
  };
  std::vector<File> files_;
  std::vector<std::filesystem::path> folders_;
};

Undo::~Undo() {
  std::error_code ignored;  // of an error already: more than to try cannot be done
  for (; !files_.empty(); files_.pop_back()) {
    const File& file = files_.back();
    if (file.before) {
      (void)formats::writeFileAtomically(file.path, *file.before);
    } else {
      std::filesystem::remove(file.path, ignored);
    }
  }
  for (; !folders_.empty(); folders_.pop_back()) {
    std::filesystem::remove(folders_.back(), ignored);
  }
}

Result<void> Undo::makeFolder(const std::string& folder) {
  std::filesystem::path path;
  for (const std::filesystem::path& part : std::filesystem::path(folder)) {
    path /= part;
    std::error_code error;
    if (part.empty() || std::filesystem::is_directory(path, error)) {
      continue;
    }
    if (std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
      return fail(Errc::OutputFailed,
                  Words::tr("the folder cannot be made: a file has the name %1; choose another folder")
                      .arg(QString::fromStdString(path.string()))
                      .toStdString(),
                  folder);
    }
    if (!std::filesystem::create_directory(path, error)) {
      return fail(Errc::OutputFailed,
                  Words::tr("the folder cannot be made: %1").arg(QString::fromStdString(formats::writeFailureReason(error.value()))).toStdString(),
                  folder);
    }
    folders_.push_back(path);
  }
  return {};
}

bool Undo::remember(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    files_.push_back({path, std::nullopt});
    return true;
  }
  if (!std::filesystem::is_regular_file(path, error)) {
    return true;  // a device, or a folder in the way: nothing of it is changed
  }
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.is_open() || file.bad()) {
    return false;
  }
  files_.push_back({path, std::move(bytes)});
  return true;
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

Result<std::vector<std::string>> writeExports(const PreparedExport& prepared, const std::vector<std::string>& paths, const std::string& folder) {
  VP_EXPECT(paths.size() == prepared.files.size());
  Undo undo;
  if (const Result<void> made = undo.makeFolder(folder); !made) {
    return forward(made);
  }
  std::vector<std::string> backups;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::error_code error;
    const bool isThere = std::filesystem::is_regular_file(paths[i], error);
    backups.push_back(isThere ? paths[i] + "~" : "");
    if (isThere) {
      if (!undo.remember(backups.back())) {
        return fail(Errc::OutputFailed, Words::tr("the backup that is there cannot be read; nothing was overwritten").toStdString(), backups.back());
      }
      if (const int code = copyOver(paths[i], backups.back()); code != 0) {
        return fail(Errc::OutputFailed,
                    Words::tr("the file that is there could not be copied to a backup; nothing was overwritten").toStdString() + ": " +
                        formats::writeFailureReason(code),
                    backups.back());
      }
    }
    if (!undo.remember(paths[i])) {
      return fail(Errc::OutputFailed, Words::tr("the file that is there cannot be read; nothing was overwritten").toStdString(), paths[i]);
    }
    if (const Result<void> written = formats::writeFileAtomically(paths[i], prepared.files[i].bytes); !written) {
      return forward(written);
    }
  }
  undo.forget();
  return backups;
}

}  // namespace vp::exports
