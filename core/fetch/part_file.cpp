#include "core/fetch/part_file.h"

#include "core/formats/atomic_file.h"

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace vp::fetch {
namespace {

tl::unexpected<Error> refused(const std::string& path, int code) {
  return fail(Errc::OutputFailed, "cannot be written: " + formats::writeFailureReason(code), path);
}

/// Lets a moment pass, or less if a stop is asked for.
void waitAMoment(const Job& job) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  never.wait_for(lock, job.stopToken(), std::chrono::milliseconds(50), [] { return false; });
}

}  // namespace

Result<PartFile> PartFile::acquire(const std::string& path, const Job& job) {
  for (;;) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      return refused(path, errno);
    }
    PartFile file(descriptor, path);
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      if (const int code = errno; code != EWOULDBLOCK && code != EINTR) {
        file.close();
        return refused(path, code);
      }
      if (job.stopRequested()) {
        file.close();  // not ours to remove
        return fail(Errc::Cancelled, "stopped while another program fetches the same file");
      }
      job.progress(0.0, "waiting for another program that fetches the same");
      waitAMoment(job);
    }
    if (file.isStillNamed()) {
      return file;
    }
    file.close();  // whoever had it has finished it; look again
  }
}

PartFile::PartFile(PartFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

PartFile::~PartFile() {
  if (descriptor_ >= 0 && size() == 0) {
    drop();
  }
  close();
}

void PartFile::close() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    descriptor_ = -1;
  }
}

bool PartFile::isStillNamed() const {
  struct stat mine {};
  struct stat named {};
  return ::fstat(descriptor_, &mine) == 0 && ::stat(path_.c_str(), &named) == 0 && mine.st_ino == named.st_ino && mine.st_dev == named.st_dev;
}

std::uint64_t PartFile::size() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

Result<void> PartFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      return refused(path_, errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> PartFile::clear() {
  if (::ftruncate(descriptor_, 0) != 0) {
    return refused(path_, errno);
  }
  return {};
}

Result<void> PartFile::finish(const std::string& name) {
  if (::fsync(descriptor_) != 0 || ::rename(path_.c_str(), name.c_str()) != 0) {
    return refused(name, errno);
  }
  ::unlink((path_ + ".source").c_str());
  close();
  return {};
}

void PartFile::drop() {
  if (descriptor_ >= 0) {
    ::unlink((path_ + ".source").c_str());
    ::unlink(path_.c_str());
    close();
  }
}

Result<void> makeFolder(const std::string& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (code) {
    return fail(Errc::OutputFailed, "the folder cannot be made: " + formats::writeFailureReason(code.value()), path);
  }
  return {};
}

}  // namespace vp::fetch
