#include "maps/height_field.h"

#include "maps/deterministic.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace vp::maps {
namespace {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

}  // namespace

HeightField::HeightField(int size, double spacing, double height)
    : size_(size), spacing_(spacing), heights_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), height) {}

int HeightField::nearest(double coordinate) const {
  return std::clamp(static_cast<int>(std::lround(coordinate / spacing_ + (size_ - 1) / 2.0)), 0, size_ - 1);
}

double HeightField::lowest() const {
  return *std::min_element(heights_.begin(), heights_.end());
}

double HeightField::highest() const {
  return *std::max_element(heights_.begin(), heights_.end());
}

void HeightField::stretchTo(double low, double high) {
  const double from = lowest();
  const double factor = (high - low) / (highest() - from);
  for (double& height : heights_) {
    height = low + (height - from) * factor;
  }
}

void HeightField::roundHeights(double unit) {
  for (double& height : heights_) {
    height = roundTo(height, unit);
  }
}

Result<void> writeGeoTiff(const HeightField& field, const geo::LocalFrame& frame, SampleType type, const std::string& path) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr) {
    return fail(Errc::Unsupported, "this GDAL has no GeoTIFF driver; install a complete GDAL", path);
  }
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("ZLEVEL", "9");
  options.SetNameValue("PREDICTOR", type == SampleType::Int16 ? "2" : "3");
  const GDALDataType gdalType = type == SampleType::Int16 ? GDT_Int16 : GDT_Float32;
  const std::unique_ptr<GDALDataset, CloseDataset> dataset(driver->Create(path.c_str(), field.size(), field.size(), 1, gdalType, options.List()));
  if (!dataset) {
    return fail(Errc::OutputFailed, "cannot be created; check that the folder exists and can be written", path);
  }
  OGRSpatialReference reference;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  reference.SetProjCS("Local metric frame (azimuthal equidistant)");
  reference.SetWellKnownGeogCS("WGS84");
  reference.SetAE(frame.origin().latitude_deg, frame.origin().longitude_deg, 0.0, 0.0);
  const double edge = field.size() * field.spacing() / 2.0;
  std::array<double, 6> transform{-edge, field.spacing(), 0.0, edge, 0.0, -field.spacing()};
  bool written = dataset->SetSpatialRef(&reference) == CE_None && dataset->SetGeoTransform(transform.data()) == CE_None;
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetUnitType("m");
  std::vector<double> line(static_cast<std::size_t>(field.size()));
  for (int row = 0; row < field.size() && written; ++row) {
    for (int i = 0; i < field.size(); ++i) {
      line[static_cast<std::size_t>(i)] = field.at(i, field.size() - 1 - row);
    }
    written = band->RasterIO(GF_Write, 0, row, field.size(), 1, line.data(), field.size(), 1, GDT_Float64, 0, 0, nullptr) == CE_None;
  }
  CPLErrorReset();
  dataset->FlushCache();
  if (!written || CPLGetLastErrorType() >= CE_Failure) {
    return fail(Errc::OutputFailed, "cannot be written to the end; check the free space", path);
  }
  return {};
}

}  // namespace vp::maps
