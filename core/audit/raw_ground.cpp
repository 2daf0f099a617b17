#include "core/audit/raw_ground.h"

#include <fmt/core.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::audit {
namespace {

constexpr double kLowestGround = -500.0;   // m MSL; the lowest land, the shore of the Dead Sea, is at -440
constexpr double kHighestGround = 9000.0;  // m MSL; the highest is at 8849
constexpr double kSameLattice = 1e-2;      // of a post: files this near to one lattice are on it
constexpr double kSameSpacing = 1e-6;      // relative
constexpr int kLinesPerPoll = 64;          // of a file

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(GDALDataset::ToHandle(dataset)); }
};
struct TransformCloser {
  void operator()(OGRCoordinateTransformation* transform) const { OGRCoordinateTransformation::DestroyCT(transform); }
};
using Transform = std::unique_ptr<OGRCoordinateTransformation, TransformCloser>;

/** One file: posts row by row from its first line, NaN where void. */
struct Raster {
  int columns = 0;
  int rows = 0;
  std::array<double, 6> toMap{};   ///< GDAL's geotransform, of pixel corners
  std::array<double, 6> toPost{};  ///< its inverse
  std::vector<float> posts;
  OGRSpatialReference crs;
  double turn = 0.0;  ///< what a full circle of longitude is in its coordinates; 0 if they are no angles

  [[nodiscard]] bool has(long column, long row) const { return column >= 0 && row >= 0 && column < columns && row < rows; }
  [[nodiscard]] float at(long column, long row) const {
    return posts[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
};

/** Another file on the lattice of one: its column is the one's plus this. */
struct Neighbour {
  std::size_t raster = 0;
  long columns = 0;
  long rows = 0;
};

OGRSpatialReference frameOf(geo::LatLon origin) {
  OGRSpatialReference frame;
  frame.importFromProj4(
      fmt::format("+proj=aeqd +lat_0={:.12f} +lon_0={:.12f} +datum=WGS84 +units=m +no_defs", origin.latitude_deg, origin.longitude_deg).c_str());
  return frame;
}

Result<Transform> transformBetween(const OGRSpatialReference& from, const OGRSpatialReference& to) {
  OGRCoordinateTransformationOptions options;
  options.SetBallparkAllowed(false);
  Transform transform(OGRCreateCoordinateTransformation(&from, &to, options));
  if (!transform) {
    return fail(Errc::Unsupported, "there is no transformation into the coordinates of a terrain file; warp it to EPSG:4326 with gdalwarp");
  }
  return transform;
}

Result<double> metresOf(const std::string& unit, const std::string& path) {
  if (unit.empty() || unit == "m" || unit == "metre" || unit == "meter" || unit == "metres" || unit == "meters") {
    return 1.0;
  }
  if (unit == "ft" || unit == "foot" || unit == "feet") {
    return 0.3048;  // international foot
  }
  return fail(Errc::BadFile, fmt::format("heights in \"{}\" are not understood here; convert the raster to metres", unit), path);
}

bool isVoid(double raw) {
  return raw == -9999.0 || raw == -99999.0 || raw == -32767.0 || raw == -32768.0;
}

Result<void> readHeights(GDALRasterBand& band, Raster& raster, const std::string& path, const Job& job) {
  const char* unitText = band.GetUnitType();
  const Result<double> metres = metresOf(unitText != nullptr ? unitText : "", path);
  if (!metres) {
    return forward(metres);
  }
  int hasNoData = 0;
  const double noData = band.GetNoDataValue(&hasNoData);
  const double scale = band.GetScale();
  const double offset = band.GetOffset();
  std::vector<double> line(static_cast<std::size_t>(raster.columns));
  std::vector<GByte> mask(line.size(), 255);
  raster.posts.reserve(line.size() * static_cast<std::size_t>(raster.rows));
  for (int row = 0; row < raster.rows; ++row) {
    if (row % kLinesPerPoll == 0 && job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the terrain was stopped");
    }
    if (band.RasterIO(GF_Read, 0, row, raster.columns, 1, line.data(), raster.columns, 1, GDT_Float64, 0, 0, nullptr) != CE_None ||
        band.GetMaskBand()->RasterIO(GF_Read, 0, row, raster.columns, 1, mask.data(), raster.columns, 1, GDT_Byte, 0, 0, nullptr) != CE_None) {
      return fail(Errc::BadFile, fmt::format("line {} of the raster cannot be read; fetch the file again", row + 1), path);
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
      const double height = (line[i] * scale + offset) * *metres;
      const bool isKnown =
          mask[i] != 0 && !(hasNoData != 0 && line[i] == noData) && !isVoid(line[i]) && height >= kLowestGround && height <= kHighestGround;
      raster.posts.push_back(isKnown ? static_cast<float>(height) : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return {};
}

Result<Raster> readRaster(const std::string& path, const Job& job) {
  const std::unique_ptr<GDALDataset, DatasetCloser> dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!dataset || dataset->GetRasterCount() < 1) {
    return fail(Errc::BadFile, "this is no raster that GDAL reads; give a GeoTIFF, HGT, DTED or ASCII grid", path);
  }
  Raster raster;
  raster.columns = dataset->GetRasterXSize();
  raster.rows = dataset->GetRasterYSize();
  const OGRSpatialReference* crs = dataset->GetSpatialRef();
  if (crs == nullptr || dataset->GetGeoTransform(raster.toMap.data()) != CE_None ||
      GDALInvGeoTransform(raster.toMap.data(), raster.toPost.data()) == 0) {
    return fail(Errc::BadFile, "the raster does not say where on Earth it lies; give it a coordinate system and a georeference", path);
  }
  raster.crs = *crs;
  raster.crs.StripVertical();
  raster.crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  raster.turn = raster.crs.IsGeographic() != 0 ? 2.0 * Angle::kPi / raster.crs.GetAngularUnits() : 0.0;
  if (const Result<void> heights = readHeights(*dataset->GetRasterBand(1), raster, path, job); !heights) {
    return forward(heights);
  }
  return raster;
}

/// @return where the lattice of `other` lies in that of `one`, if it is the same
bool isOneLattice(const Raster& one, const Raster& other, Neighbour& found) {
  if (one.crs.IsSame(&other.crs) == 0) {
    return false;
  }
  for (const std::size_t i : {1U, 2U, 4U, 5U}) {
    const double spacing = std::hypot(one.toMap[1], one.toMap[4]);
    if (std::abs(one.toMap[i] - other.toMap[i]) > kSameSpacing * spacing) {
      return false;
    }
  }
  double column = 0.0;
  double row = 0.0;
  GDALApplyGeoTransform(const_cast<double*>(other.toPost.data()), one.toMap[0], one.toMap[3], &column, &row);
  found.columns = std::lround(column);
  found.rows = std::lround(row);
  return std::abs(column - static_cast<double>(found.columns)) < kSameLattice && std::abs(row - static_cast<double>(found.rows)) < kSameLattice;
}

}  // namespace

struct RawGround::Posts {
  geo::LatLon origin;
  std::vector<Raster> rasters;
  std::vector<std::vector<Neighbour>> neighbours;  ///< of each raster

  [[nodiscard]] float post(std::size_t index, long column, long row) const {
    float highest = rasters[index].has(column, row) ? rasters[index].at(column, row) : std::numeric_limits<float>::quiet_NaN();
    for (const Neighbour& next : neighbours[index]) {
      const Raster& other = rasters[next.raster];
      if (other.has(column + next.columns, row + next.rows)) {
        highest = std::fmax(highest, other.at(column + next.columns, row + next.rows));  // the number, if one is none
      }
    }
    return highest;
  }

  /// Highest of the posts around map coordinates; NaN if one of them is not known.
  [[nodiscard]] double highestAround(std::size_t index, double x, double y) const {
    const Raster& raster = rasters[index];
    const auto& to = raster.toPost;
    const double u = to[0] + to[1] * x + to[2] * y - 0.5;
    const double v = to[3] + to[4] * x + to[5] * y - 0.5;
    if (!(u > -1.0 && v > -1.0 && u < raster.columns && v < raster.rows)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double left = std::floor(u);
    const double top = std::floor(v);
    const auto column = static_cast<long>(left);
    const auto row = static_cast<long>(top);
    double highest = -std::numeric_limits<double>::infinity();
    for (const long r : {row, v > top ? row + 1 : row}) {
      for (const long c : {column, u > left ? column + 1 : column}) {
        const float height = post(index, c, r);
        if (std::isnan(height)) {
          return std::numeric_limits<double>::quiet_NaN();
        }
        highest = std::max(highest, static_cast<double>(height));
      }
    }
    return highest;
  }
};

Result<RawGround> RawGround::read(const std::vector<std::string>& files, geo::LatLon origin, const Job& job) {
  GDALAllRegister();
  auto posts = std::make_shared<Posts>();
  posts->origin = origin;
  for (const std::string& file : files) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the terrain was stopped");
    }
    job.progress(static_cast<double>(posts->rasters.size()) / static_cast<double>(files.size()), "second opinion: terrain");
    Result<Raster> raster = readRaster(file, job);
    if (!raster) {
      return forward(raster);
    }
    posts->rasters.push_back(std::move(*raster));
  }
  posts->neighbours.resize(posts->rasters.size());
  for (std::size_t i = 0; i < posts->rasters.size(); ++i) {
    for (std::size_t k = 0; k < posts->rasters.size(); ++k) {
      Neighbour next{k, 0, 0};
      if (i != k && isOneLattice(posts->rasters[i], posts->rasters[k], next)) {
        posts->neighbours[i].push_back(next);
      }
    }
  }
  RawGround ground;
  ground.posts_ = std::move(posts);
  return ground;
}

Result<GroundLookup> RawGround::lookup() const {
  const OGRSpatialReference frame = frameOf(posts_->origin);
  auto transforms = std::make_shared<std::vector<Transform>>();
  for (const Raster& raster : posts_->rasters) {
    Result<Transform> transform = transformBetween(frame, raster.crs);
    if (!transform) {
      return forward(transform);
    }
    transforms->push_back(std::move(*transform));
  }
  return [posts = posts_, transforms, x = std::vector<double>(), y = std::vector<double>()](const std::vector<geo::Point>& places,
                                                                                            std::vector<double>& heights) mutable {
    heights.assign(places.size(), -kUnknownGround);
    for (std::size_t k = 0; k < posts->rasters.size(); ++k) {
      const Raster& raster = posts->rasters[k];
      if (k == 0 || raster.crs.IsSame(&posts->rasters[k - 1].crs) == 0) {
        x.resize(places.size());
        y.resize(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
          x[i] = places[i].x;
          y[i] = places[i].y;
        }
        std::vector<int> done(places.size());
        (*transforms)[k]->Transform(static_cast<int>(places.size()), x.data(), y.data(), nullptr, done.data());
        for (std::size_t i = 0; i < places.size(); ++i) {
          x[i] = done[i] != 0 ? x[i] : std::numeric_limits<double>::quiet_NaN();
        }
      }
      for (std::size_t i = 0; i < places.size(); ++i) {
        double height = posts->highestAround(k, x[i], y[i]);
        for (const double turned : {x[i] - raster.turn, x[i] + raster.turn}) {
          height = std::isnan(height) && raster.turn > 0.0 ? posts->highestAround(k, turned, y[i]) : height;
        }
        heights[i] = std::isnan(height) ? heights[i] : std::max(heights[i], height);
      }
    }
    for (double& height : heights) {
      height = height == -kUnknownGround ? kUnknownGround : height;
    }
  };
}

Result<std::vector<geo::Point>> RawGround::toFrame(geo::LatLon origin, const std::vector<geo::LatLon>& places) {
  OGRSpatialReference degrees;
  degrees.SetWellKnownGeogCS("WGS84");
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const Result<Transform> transform = transformBetween(degrees, frameOf(origin));
  if (!transform) {
    return forward(transform);
  }
  std::vector<geo::Point> points;
  for (const geo::LatLon& place : places) {
    double x = place.longitude_deg;
    double y = place.latitude_deg;
    if ((*transform)->Transform(1, &x, &y) == 0) {
      return fail(Errc::Unsupported, "a place of the plan has none in its local frame");
    }
    points.push_back({x, y});
  }
  return points;
}

}  // namespace vp::audit
