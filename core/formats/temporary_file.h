#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vp::formats {

/** A file `.volplane-PID-N.ENDING` that nobody else has, in the folder where it is to appear under another name; removed
 *  unless it was moved there. It is locked (flock) as long as it is held, so one that a killed process left behind can be
 *  told from one that is being written: making a file removes the abandoned ones of the same folder. On a file system
 *  without locks none are removed.
 *  @threads one object per thread */
class TemporaryFile {
public:
  /** @param ending  "tmp", "tif"   @param code  receives errno if there is none */
  static std::optional<TemporaryFile> create(const std::string& folder, std::string_view ending, int& code);
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /** Gives it its name, over what is there, and lets go of it. @return 0 or errno; then it is still held */
  int moveTo(const std::string& target);

private:
  TemporaryFile(int descriptor, std::string path);

  int descriptor_;
  std::string path_;
};

/** Removes the files of TemporaryFile that no process holds any more. @return how many */
int removeAbandonedFiles(const std::string& folder);

}  // namespace vp::formats
