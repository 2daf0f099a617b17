#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace vp::fetch {

/** A file that is being fetched: it keeps what has come, across breaks and program ends, until it is whole and takes its name.
 *  Locked, so that of two programs that want the same file one fetches it and the other waits. Unlocked when it goes out of scope;
 *  an empty one is removed then. @threads one */
class PartFile {
public:
  /** Opens or makes `path`, waiting for whoever has it. @errors OutputFailed, Cancelled */
  static Result<PartFile> acquire(const std::string& path, const Job& job);
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::uint64_t size() const;
  /** @errors OutputFailed: disk full, ... What was there before stays */
  Result<void> append(std::string_view bytes);
  Result<void> clear();
  /** Flushes it to the disk and gives it its name; the lock goes with it. @errors OutputFailed */
  Result<void> finish(const std::string& name);
  /** Removes it, with the notes about it (PATH.source), as finish does. */
  void drop();

private:
  PartFile(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  [[nodiscard]] bool isStillNamed() const;
  void close();

  int descriptor_ = -1;
  std::string path_;
};

/** Makes a folder with all above it. @errors OutputFailed */
Result<void> makeFolder(const std::string& path);

}  // namespace vp::fetch
