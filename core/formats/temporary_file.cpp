#include "core/formats/temporary_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace vp::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".volplane-";
constexpr int kAttempts = 1000;

bool isOurs(const std::string& name) {
  return name.starts_with(kPrefix) && (name.ends_with(".tmp") || name.ends_with(".tif"));
}

/// Whether the open file still has that name: somebody may have removed it between open and lock.
bool hasName(int descriptor, const std::string& path) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

bool removeIfAbandoned(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    return false;
  }
  const bool isAbandoned = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && hasName(descriptor, path) && ::unlink(path.c_str()) == 0;
  ::close(descriptor);
  return isAbandoned;
}

}  // namespace

TemporaryFile::TemporaryFile(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::exchange(other.path_, {})) {}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) {
    ::unlink(path_.c_str());
  }
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

std::optional<TemporaryFile> TemporaryFile::create(const std::string& folder, std::string_view ending, int& code) {
  removeAbandonedFiles(folder);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::string path = fmt::format("{}/{}{}-{}.{}", folder, kPrefix, ::getpid(), attempt, ending);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      if (errno == EEXIST) {
        continue;
      }
      code = errno;
      return std::nullopt;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor);  // taken for an abandoned one in the moment of its birth, and removed
      continue;
    }
    if (hasName(descriptor, path)) {
      return TemporaryFile(descriptor, path);
    }
    ::close(descriptor);
  }
  code = EEXIST;
  return std::nullopt;
}

int TemporaryFile::moveTo(const std::string& target) {
  if (std::rename(path_.c_str(), target.c_str()) != 0) {
    return errno;
  }
  path_.clear();
  ::close(std::exchange(descriptor_, -1));
  return 0;
}

int removeAbandonedFiles(const std::string& folder) {
  int removed = 0;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    if (isOurs(entry->path().filename().string()) && removeIfAbandoned(entry->path().string())) {
      ++removed;
    }
  }
  return removed;
}

}  // namespace vp::formats
