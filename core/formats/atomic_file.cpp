#include "core/formats/atomic_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace vp::formats {
namespace {

namespace fs = std::filesystem;

/// An open file that is closed, and removed unless kept, when it goes out of scope.
class TemporaryFile {
public:
  TemporaryFile(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    close();
    if (!path_.empty()) {
      ::unlink(path_.c_str());
    }
  }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  bool close() {
    const bool good = descriptor_ < 0 || ::close(descriptor_) == 0;
    descriptor_ = -1;
    return good;
  }
  void keep() { path_.clear(); }

private:
  int descriptor_;
  std::string path_;
};

tl::unexpected<Error> refused(const std::string& path, const std::string& why) {
  return fail(Errc::OutputFailed, "cannot be written: " + why, path);
}

/// 0, or the error number.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) {
        continue;
      }
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

Result<void> writeDirectly(const std::string& path, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return refused(path, writeFailureReason(errno));
  }
  TemporaryFile file(descriptor, {});
  if (const int code = writeAll(file.descriptor(), bytes); code != 0) {
    return refused(path, writeFailureReason(code));
  }
  if (!file.close()) {
    return refused(path, writeFailureReason(errno));
  }
  return {};
}

/// Creates a file that nobody else has, with the permissions that the process gives to new files; -1 and errno if not.
int createTemporary(const std::string& folder, std::string& path) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    path = fmt::format("{}/.volplane-{}-{}.tmp", folder, ::getpid(), attempt);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) {
      return descriptor;
    }
  }
  return -1;
}

/// Flushes the folder entry, so that the rename survives a power cut. Some file systems cannot; the data is safe by then.
void flushFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

Result<void> replace(const std::string& path, const std::string& target, std::string_view bytes, std::optional<mode_t> oldMode) {
  const fs::path targetPath(target);
  const std::string folder = targetPath.has_parent_path() ? targetPath.parent_path().string() : ".";
  std::string temporary;
  const int descriptor = createTemporary(folder, temporary);
  if (descriptor < 0) {
    return refused(path, writeFailureReason(errno));
  }
  TemporaryFile file(descriptor, temporary);
  if (const int code = writeAll(file.descriptor(), bytes); code != 0) {
    return refused(path, writeFailureReason(code));
  }
  if ((oldMode && ::fchmod(file.descriptor(), *oldMode) != 0) || ::fsync(file.descriptor()) != 0 || !file.close()) {
    return refused(path, writeFailureReason(errno));
  }
  if (::rename(file.path().c_str(), target.c_str()) != 0) {
    return refused(path, writeFailureReason(errno));
  }
  file.keep();
  flushFolder(folder);
  return {};
}

}  // namespace

std::string writeFailureReason(int code) {
  switch (code) {
    case EACCES:
    case EPERM:
      return "there is no permission to write there; choose another folder or change its permissions";
    case EROFS:
      return "the file system is read-only; choose another folder";
    case ENOSPC:
    case EDQUOT:
      return "the disk is full; free some space or choose another folder";
    case EFBIG:
      return "the file would be larger than the system allows";
    case ENOENT:
    case ENOTDIR:
      return "there is no such folder; create it first";
    case ENAMETOOLONG:
      return "the file name is too long; choose a shorter one";
    default:
      return std::generic_category().message(code) + "; choose another place";
  }
}

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes) {
  if (path.empty()) {
    return fail(Errc::OutputFailed, "no file name was given for the output");
  }
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) {
      return refused(path, writeFailureReason(errno));
    }
    return path.back() == '/' ? refused(path, "this names a folder; add a file name") : replace(path, path, bytes, std::nullopt);
  }
  if (S_ISDIR(status.st_mode)) {
    return refused(path, "a folder has this name; choose another file name");
  }
  if (!S_ISREG(status.st_mode)) {
    return writeDirectly(path, bytes);
  }
  if (::access(path.c_str(), W_OK) != 0) {
    return refused(path, errno == EROFS ? writeFailureReason(errno) : "the file is write-protected; remove the protection or choose another name");
  }
  std::error_code code;
  const fs::path target = fs::canonical(path, code);
  return replace(path, code ? path : target.string(), bytes, status.st_mode & 07777);
}

}  // namespace vp::formats
