// What terrain files cover, from their headers alone.
#include "core/geo/local_frame.h"
#include "core/terrain/conservative_warp.h"
#include "core/terrain/raster_file.h"
#include "core/terrain/terrain_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::terrain {
namespace {

using detail::CrsTransform;
using detail::RasterHeader;

double nearLongitude(double longitude, double reference) {
  return reference + std::remainder(longitude - reference, 360.0);
}

double wrapLongitude(double longitude) {
  return longitude < -180.0 || longitude > 180.0 ? std::remainder(longitude, 360.0) : longitude;
}

/// Extent in degrees with longitudes that run on past 180, so that files on both sides of the date line join.
struct Extent {
  double south = std::numeric_limits<double>::infinity();
  double north = -std::numeric_limits<double>::infinity();
  double west = std::numeric_limits<double>::infinity();
  double east = -std::numeric_limits<double>::infinity();

  void add(double latitude, double longitude) {
    south = std::min(south, latitude);
    north = std::max(north, latitude);
    west = std::min(west, longitude);
    east = std::max(east, longitude);
  }
  [[nodiscard]] geo::LatLon southWest() const { return {south, wrapLongitude(west)}; }
  [[nodiscard]] geo::LatLon northEast() const { return {north, wrapLongitude(east)}; }
};

/// The smaller distance on the ground from the middle post to its neighbour along a row and along a column.
double groundSpacing(const RasterHeader& header, CrsTransform& toDegrees) {
  const double column = 0.5 * (header.columns - 2);
  const double row = 0.5 * (header.rows - 2);
  std::vector<double> x;
  std::vector<double> y;
  for (const geo::Point post : {geo::Point{column, row}, geo::Point{column + 1.0, row}, geo::Point{column, row + 1.0}}) {
    const geo::Point at = header.posts.apply(post);
    x.push_back(at.x);
    y.push_back(at.y);
  }
  toDegrees.apply(x, y);
  const auto spacing = [&x, &y](std::size_t i) { return geo::geodesicDistance({y[0], x[0]}, {y[i], x[i]}).si(); };
  return std::min(spacing(1), spacing(2));
}

Result<TerrainInfo::File> describe(const RasterHeader& header, double referenceLongitude, Extent& all) {
  const auto degrees = detail::crsFrom("EPSG:4326");
  if (!degrees) {
    return forward(degrees);
  }
  auto transform = CrsTransform::between(header.crs, *degrees);
  if (!transform) {
    return fail(Errc::BadFile, transform.error().what, header.path);
  }
  std::vector<double> x;
  std::vector<double> y;
  for (const geo::Point& post : detail::outline(header.columns, header.rows)) {
    const geo::Point at = header.posts.apply(post);
    x.push_back(at.x);
    y.push_back(at.y);
  }
  transform->apply(x, y);
  Extent extent;
  const double middle = std::isfinite(referenceLongitude) ? nearLongitude(x.front(), referenceLongitude) : x.front();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || std::abs(y[i]) > 90.0 + 1e-9) {
      return fail(Errc::BadFile, "the raster's corners do not lie on the earth in its coordinate system; correct the one or the other", header.path);
    }
    extent.add(y[i], nearLongitude(x[i], middle));
    all.add(y[i], nearLongitude(x[i], middle));
  }
  TerrainInfo::File file{header.path, header.driver, header.crsName, header.columns, header.rows, 0.0, extent.southWest(), extent.northEast()};
  file.spacing_m = groundSpacing(header, *transform);
  return file;
}

}  // namespace

geo::LatLon TerrainInfo::centre() const {
  const double east = northEast.longitude_deg < southWest.longitude_deg ? northEast.longitude_deg + 360.0 : northEast.longitude_deg;
  const auto rounded = [](double degrees) { return std::round(degrees * 1000.0) / 1000.0; };
  return {rounded(0.5 * (southWest.latitude_deg + northEast.latitude_deg)), wrapLongitude(rounded(0.5 * (southWest.longitude_deg + east)))};
}

Result<TerrainInfo> inspectTerrain(const std::vector<std::string>& files) {
  if (files.empty()) {
    return fail(Errc::BadFile, "no terrain file is named; give at least one elevation raster");
  }
  TerrainInfo info;
  Extent all;
  info.spacing_m = std::numeric_limits<double>::infinity();
  for (const std::string& path : files) {
    const auto raster = detail::RasterFile::open(path);
    if (!raster) {
      return forward(raster);
    }
    auto file =
        describe(raster->header(), info.files.empty() ? std::numeric_limits<double>::quiet_NaN() : info.files.front().southWest.longitude_deg, all);
    if (!file) {
      return forward(file);
    }
    info.spacing_m = std::min(info.spacing_m, file->spacing_m);
    info.files.push_back(std::move(*file));
  }
  info.southWest = all.southWest();
  info.northEast = all.northEast();
  return info;
}

}  // namespace vp::terrain
