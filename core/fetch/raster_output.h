#pragma once

#include "core/base/result.h"
#include "core/formats/temporary_file.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class GDALDataset;

namespace vp::fetch {

/// What stands in written rasters where nothing is known; the terrain reader takes it as unknown.
inline constexpr float kNoHeight = -32767.0F;

/** Where a raster in degrees lies (EPSG:4326): its outer corner and the distance of its posts, which are the pixel centres. */
struct RasterPlace {
  double west = 0.0;
  double north = 0.0;
  double stepX = 0.0;
  double stepY = 0.0;  ///< positive, southwards
  int columns = 0;
  int rows = 0;
};

/** A GeoTIFF of heights (float32, metres, EGM2008) that appears whole or not at all: written under a name of its own in the same folder
 *  and renamed at the end. @threads one */
class RasterOutput {
public:
  /** @param words  metadata of the file; `VOLPLANE_KIND` goes to the band as well   @errors OutputFailed */
  static Result<RasterOutput> create(const std::string& path, const RasterPlace& place, const std::map<std::string, std::string>& words);
  RasterOutput(RasterOutput&&) noexcept;
  RasterOutput& operator=(RasterOutput&&) = delete;
  RasterOutput(const RasterOutput&) = delete;
  RasterOutput& operator=(const RasterOutput&) = delete;
  ~RasterOutput();

  /** @errors OutputFailed */
  Result<void> writeRows(int first, int count, const std::vector<float>& heights);
  /** Closes the file and gives it its name. @errors OutputFailed: disk full, no permission, ... */
  Result<void> finish();

private:
  RasterOutput();
  std::string path_;
  std::optional<formats::TemporaryFile> temporary_;  ///< none: it has its name
  int columns_ = 0;
  std::unique_ptr<GDALDataset> raster_;
};

}  // namespace vp::fetch
