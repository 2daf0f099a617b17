#include "tests/core/terrain/raster_fixture.h"

#include <QByteArray>
#include <QFileInfo>
#include <QTemporaryDir>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace vp::terrain::test {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

void require(bool isTrue, const std::string& what) {
  if (!isTrue) {
    throw std::runtime_error(what + ": " + CPLGetLastErrorMsg());
  }
}

OGRSpatialReference crsOf(const std::string& definition) {
  OGRSpatialReference crs;
  require(crs.SetFromUserInput(definition.c_str()) == OGRERR_NONE, definition);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

}  // namespace

RasterSpec& RasterSpec::withPosts(double x, double y, double spacingX, double spacingY) {
  geotransform = {x - 0.5 * spacingX, spacingX, 0.0, y + 0.5 * spacingY, 0.0, -spacingY};
  return *this;
}

RasterSpec& RasterSpec::filled(int columnCount, int rowCount, const std::function<double(int column, int row)>& height) {
  columns = columnCount;
  rows = rowCount;
  heights.clear();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      heights.push_back(height(column, row));
    }
  }
  return *this;
}

std::string writeRaster(const QTemporaryDir& folder, const RasterSpec& spec) {
  GDALAllRegister();
  const std::string path = folder.filePath(QString::fromStdString(spec.name)).toStdString();
  // Formats such as HGT and ASCII grid can only be copied into, from memory.
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(spec.driver.c_str());
  require(driver != nullptr, spec.driver);
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  std::unique_ptr<GDALDataset> raster(memory->Create("", spec.columns, spec.rows, spec.bands, GDALGetDataTypeByName(spec.type.c_str()), nullptr));
  require(raster != nullptr, path);
  std::array<double, 6> geotransform = spec.geotransform;
  if (spec.hasPlace) {
    raster->SetGeoTransform(geotransform.data());
  }
  if (!spec.crs.empty()) {
    const OGRSpatialReference crs = crsOf(spec.crs);
    raster->SetSpatialRef(&crs);
  }
  for (int i = 1; i <= spec.bands; ++i) {
    GDALRasterBand* band = raster->GetRasterBand(i);
    std::vector<double> heights = spec.heights;
    require(band->RasterIO(GF_Write, 0, 0, spec.columns, spec.rows, heights.data(), spec.columns, spec.rows, GDT_Float64, 0, 0, nullptr) == CE_None,
            path);
    if (spec.noData) {
      band->SetNoDataValue(*spec.noData);
    }
    if (spec.scale) {
      band->SetScale(*spec.scale);
    }
    if (spec.offset) {
      band->SetOffset(*spec.offset);
    }
    if (!spec.unit.empty()) {
      band->SetUnitType(spec.unit.c_str());
    }
  }
  CPLStringList options;
  for (const std::string& option : spec.options) {
    options.AddString(option.c_str());
  }
  const std::unique_ptr<GDALDataset> written(driver->CreateCopy(path.c_str(), raster.get(), FALSE, options.List(), nullptr, nullptr));
  require(written != nullptr, path);
  return path;
}

SourceOracle::SourceOracle(const std::string& path, const geo::LocalFrame& frame, std::function<bool(double)> isVoid) : isVoid_(std::move(isVoid)) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  require(file != nullptr, path);
  columns_ = file->GetRasterXSize();
  rows_ = file->GetRasterYSize();
  file->GetGeoTransform(geotransform_.data());
  posts_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  require(file->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns_, rows_, posts_.data(), columns_, rows_, GDT_Float64, 0, 0, nullptr) == CE_None,
          path);
  OGRSpatialReference source(*file->GetSpatialRef());
  source.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  isGeographic_ = source.IsGeographic() != 0;
  const OGRSpatialReference local = crsOf(frame.projString());
  toSource_ = OGRCreateCoordinateTransformation(&local, &source);
  toFrame_ = OGRCreateCoordinateTransformation(&source, &local);
  require(toSource_ != nullptr && toFrame_ != nullptr, path);
}

SourceOracle::~SourceOracle() {
  OGRCoordinateTransformation::DestroyCT(toSource_);
  OGRCoordinateTransformation::DestroyCT(toFrame_);
}

double SourceOracle::post(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) {
    return kUnknown;
  }
  const double raw = posts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  return isVoid_(raw) ? kUnknown : raw;
}

geo::Point SourceOracle::placeOf(double column, double row) {
  const auto& g = geotransform_;
  double x = g[0] + (column + 0.5) * g[1] + (row + 0.5) * g[2];
  double y = g[3] + (column + 0.5) * g[4] + (row + 0.5) * g[5];
  require(toFrame_->Transform(1, &x, &y) != 0, "post to frame");
  return {x, y};
}

geo::Point SourceOracle::postOf(geo::Point place) {
  require(toSource_->Transform(1, &place.x, &place.y) != 0, "frame to post");
  const auto& g = geotransform_;
  if (isGeographic_) {  // longitude nearest to the raster, in degrees or grads
    const double middle = g[0] + 0.5 * columns_ * g[1];
    for (const double turn : {360.0, 400.0}) {
      if (std::abs(place.x - middle) > 0.5 * turn) {
        place.x += std::copysign(turn, middle - place.x);
        break;
      }
    }
  }
  const double dx = place.x - g[0];
  const double dy = place.y - g[3];
  const double determinant = g[1] * g[5] - g[2] * g[4];
  return {(dx * g[5] - dy * g[2]) / determinant - 0.5, (dy * g[1] - dx * g[4]) / determinant - 0.5};
}

double SourceOracle::highestIn(double column0, double column1, double row0, double row1) const {
  double value = -kUnknown;
  for (int row = static_cast<int>(row0); row <= static_cast<int>(row1); ++row) {
    for (int column = static_cast<int>(column0); column <= static_cast<int>(column1); ++column) {
      value = std::max(value, post(column, row));
    }
  }
  return value;
}

double SourceOracle::highestAround(geo::Point place) {
  constexpr double kNoise = 3e-6;  // posts: on the line between two posts either side may round
  const geo::Point at = postOf(place);
  return highestIn(std::floor(at.x + kNoise), std::ceil(at.x - kNoise), std::floor(at.y + kNoise), std::ceil(at.y - kNoise));
}

double SourceOracle::highestWithin(geo::Point place, double columns, double rows) {
  const geo::Point at = postOf(place);
  return highestIn(std::floor(at.x - columns), std::ceil(at.x + columns), std::floor(at.y - rows), std::ceil(at.y + rows));
}

double SourceOracle::highest() const {
  double value = -kUnknown;
  for (const double raw : posts_) {
    value = isVoid_(raw) ? value : std::max(value, raw);
  }
  return value;
}

std::string realDataFolder(const std::string& sourceFolder) {
  const QByteArray set = qgetenv("VOLPLANE_DATA");
  for (const std::string& folder : {set.toStdString(), sourceFolder + "/../../shared/data", sourceFolder + "/../shared/data"}) {
    if (!folder.empty() && QFileInfo::exists(QString::fromStdString(folder + "/dem"))) {
      return folder;
    }
  }
  return {};
}

}  // namespace vp::terrain::test
