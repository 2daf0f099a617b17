#pragma once

#include "core/base/result.h"
#include "core/tour/noon_bean.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vp::tour {

/** The transformed problem as a TSPLIB file (TYPE ATSP, EXPLICIT, FULL_MATRIX). */
std::string toTsplib(const NoonBean& atsp);

/** A tour as a TSPLIB TOUR file; nodes count from 0 here. */
std::string toTourFile(const std::vector<int>& tour);

/** Reads a TSPLIB TOUR file of `nodes` nodes. @errors BadFile, with `where` as the place */
Result<std::vector<int>> parseTourFile(std::string_view text, int nodes, const std::string& where);

/** Writes and reads whole files. @errors OutputFailed; BadFile */
Result<void> writeText(const std::filesystem::path& file, const std::string& text);
Result<std::string> readText(const std::filesystem::path& file);

/** A folder of its own for temporary files, removed with all that is in it when this object goes. */
class TemporaryFolder {
public:
  static Result<TemporaryFolder> make();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace vp::tour
