#pragma once

#include "core/geo/local_frame.h"
#include "core/geo/pose.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class GDALDataset;
class OGRCoordinateTransformation;
class QTemporaryDir;

namespace vp::terrain::test {

/// A small raster to be written for a test; heights row-major in file order.
struct RasterSpec {
  std::string name = "terrain.tif";
  std::string driver = "GTiff";
  std::string type = "Float32";  ///< GDAL's name of the data type
  std::string crs;               ///< anything that GDAL understands; empty for none
  std::array<double, 6> geotransform{0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
  bool hasPlace = true;  ///< whether the geotransform is written
  int columns = 0;
  int rows = 0;
  int bands = 1;
  std::vector<double> heights;
  std::optional<double> noData;
  std::optional<double> scale;
  std::optional<double> offset;
  std::string unit;
  std::vector<std::string> options;

  /// Sets the geotransform so that post (0, 0) lies at a place and the posts run east and south.
  RasterSpec& withPosts(double x, double y, double spacingX, double spacingY);
  /// Sets the size and fills the posts from a function of column and row.
  RasterSpec& filled(int columnCount, int rowCount, const std::function<double(int column, int row)>& height);
};

/** Writes a raster into a folder and returns its path. Throws std::runtime_error if GDAL cannot. */
std::string writeRaster(const QTemporaryDir& folder, const RasterSpec& spec);

/** Judge of a warped grid: reads a file's posts plainly and asks OGR for one point at a time, so it shares neither the
 *  lattice nor the mosaic with the reader. Void is what isVoid says about the raw value. */
class SourceOracle {
public:
  SourceOracle(const std::string& path, const geo::LocalFrame& frame, std::function<bool(double)> isVoid);
  ~SourceOracle();
  SourceOracle(const SourceOracle&) = delete;
  SourceOracle& operator=(const SourceOracle&) = delete;

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double post(int column, int row) const;
  /** Place of a post in the local frame, by OGR. */
  [[nodiscard]] geo::Point placeOf(double column, double row);
  /** Post coordinates of a place in the local frame, by OGR. */
  [[nodiscard]] geo::Point postOf(geo::Point place);
  /** Highest post that surrounds a point, infinity if one of them is void or outside. */
  [[nodiscard]] double highestAround(geo::Point place);
  /** The same over all posts not farther away in post coordinates than given. */
  [[nodiscard]] double highestWithin(geo::Point place, double columns, double rows);
  /** Highest post of the file that is not void. */
  [[nodiscard]] double highest() const;

private:
  [[nodiscard]] double highestIn(double column0, double column1, double row0, double row1) const;

  int columns_ = 0;
  int rows_ = 0;
  bool isGeographic_ = false;
  std::array<double, 6> geotransform_{};
  std::vector<double> posts_;
  std::function<bool(double)> isVoid_;
  OGRCoordinateTransformation* toSource_ = nullptr;
  OGRCoordinateTransformation* toFrame_ = nullptr;
};

/** Folder of the real data for tests, or empty: environment VOLPLANE_DATA, else beside the checkout. */
std::string realDataFolder(const std::string& sourceFolder);

}  // namespace vp::terrain::test
