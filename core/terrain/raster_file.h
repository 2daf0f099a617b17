#pragma once

#include "core/base/result.h"
#include "core/geo/pose.h"
#include "core/terrain/crs_transform.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class GDALDataset;
class GDALRasterBand;

namespace vp::terrain::detail {

/** Affine map from post coordinates (column to the right, row downwards in the file, posts at the integers) to the
 *  coordinates of the file's CRS, x east. */
struct PostTransform {
  double x0 = 0.0, xPerColumn = 1.0, xPerRow = 0.0;
  double y0 = 0.0, yPerColumn = 0.0, yPerRow = 1.0;

  /** Takes (column, row) to (x, y); the inverse takes (x, y) to (column, row). */
  [[nodiscard]] geo::Point apply(geo::Point p) const { return {x0 + xPerColumn * p.x + xPerRow * p.y, y0 + yPerColumn * p.x + yPerRow * p.y}; }
  /** Empty if the posts lie on one line or in one point. */
  [[nodiscard]] std::optional<PostTransform> inverse() const;
};

/** What a raster says about itself. */
struct RasterHeader {
  std::string path;
  std::string driver;  ///< GDAL short name
  std::string crsName;
  Crs crs;
  double turn = 0.0;  ///< 360 degrees in the unit of a geographic CRS; 0 for a projected one
  int columns = 0;    ///< posts
  int rows = 0;
  PostTransform posts;
};

/** An open terrain raster: one band of heights with a coordinate system. Internal to core/terrain.
 *  @threads one thread at a time */
class RasterFile {
public:
  /** @errors BadFile: not there, no raster, no CRS, no band or several, a unit that is not one of length */
  static Result<RasterFile> open(const std::string& path);

  [[nodiscard]] const RasterHeader& header() const { return header_; }
  /** How many rows to ask for at a time: whole blocks of the file. */
  [[nodiscard]] int rowsPerRead() const { return rowsPerRead_; }

  /** Heights of rows [first, first + count) in m, none below the file's own value, unknown as kUnknownUpper.
   *  Unknown are: declared no-data, masked, never written, not a number, the customary void codes -32768, -32767, -9999,
   *  -99999 even if the file does not declare them, and what no ground on earth has (below -12 km or above 9.5 km).
   *  @errors BadFile: the file is truncated or damaged */
  Result<void> readRows(int first, int count, std::vector<float>& heights);

private:
  struct Closer {
    void operator()(GDALDataset* dataset) const;
  };
  struct Decoding {
    double scale = 1.0;
    double offset = 0.0;
    double metres = 1.0;  ///< per unit
    std::optional<double> noData;
    bool isMasked = false;
  };
  RasterFile() = default;
  Result<void> readHeader();
  Result<void> findBand();
  Result<void> readDecoding();
  void dropUnwritten(int first, int count, std::vector<float>& heights) const;
  [[nodiscard]] float decode(double raw) const;

  RasterHeader header_;
  Decoding decoding_;
  int rowsPerRead_ = 1;
  std::unique_ptr<GDALDataset, Closer> dataset_;
  GDALRasterBand* band_ = nullptr;
  std::vector<double> raw_;
  std::vector<std::uint8_t> mask_;
};

}  // namespace vp::terrain::detail
