#include "core/fetch/raster_output.h"

#include "core/formats/atomic_file.h"
#include "core/terrain/gdal_support.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <unistd.h>
#include <utility>

namespace vp::fetch {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> refused(const std::string& path, const std::string& why) {
  return fail(Errc::OutputFailed, "cannot be written: " + why, path);
}

}  // namespace

RasterOutput::RasterOutput() = default;

RasterOutput::RasterOutput(RasterOutput&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::move(other.temporary_)), columns_(other.columns_), raster_(std::move(other.raster_)) {}

RasterOutput::~RasterOutput() {
  const terrain::detail::GdalMessages silence;
  raster_.reset();
}

Result<RasterOutput> RasterOutput::create(const std::string& path, const RasterPlace& place, const std::map<std::string, std::string>& words) {
  std::error_code code;
  if (fs::is_directory(path, code)) {
    return refused(path, "a folder has this name; choose another file name");
  }
  if (fs::exists(path, code) && ::access(path.c_str(), W_OK) != 0) {
    return refused(path, "the file is write-protected; remove the protection or choose another name");
  }
  RasterOutput output;
  output.path_ = path;
  output.columns_ = place.columns;
  int number = 0;
  const fs::path folder = fs::path(path).parent_path();
  if (auto file = formats::TemporaryFile::create(folder.empty() ? "." : folder.string(), "tif", number)) {
    output.temporary_.emplace(std::move(*file));
  } else {
    return refused(path, formats::writeFailureReason(number));
  }
  const terrain::detail::GdalMessages messages;
  CPLStringList options;
  for (const char* option : {"TILED=YES", "BLOCKXSIZE=512", "BLOCKYSIZE=512", "COMPRESS=DEFLATE", "PREDICTOR=3", "BIGTIFF=IF_SAFER"}) {
    options.AddString(option);
  }
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  output.raster_.reset(driver->Create(output.temporary_->path().c_str(), place.columns, place.rows, 1, GDT_Float32, options.List()));
  if (output.raster_ == nullptr) {
    return refused(path, "the raster could not be made" + messages.inBrackets());
  }
  std::array<double, 6> at{place.west, place.stepX, 0.0, place.north, 0.0, -place.stepY};
  OGRSpatialReference degrees;
  degrees.importFromEPSG(4326);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  GDALRasterBand* band = output.raster_->GetRasterBand(1);
  output.raster_->SetGeoTransform(at.data());
  output.raster_->SetSpatialRef(&degrees);
  output.raster_->SetMetadataItem("AREA_OR_POINT", "Point");
  band->SetNoDataValue(static_cast<double>(kNoHeight));
  band->SetUnitType("m");
  for (const auto& [key, value] : words) {
    output.raster_->SetMetadataItem(key.c_str(), value.c_str());
    if (key == "VOLPLANE_KIND") {
      band->SetMetadataItem(key.c_str(), value.c_str());
    }
  }
  return output;
}

Result<void> RasterOutput::writeRows(int first, int count, const std::vector<float>& heights) {
  const terrain::detail::GdalMessages messages;
  errno = 0;
  auto* values = const_cast<float*>(heights.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast): GDAL reads only when it writes
  const CPLErr state = raster_->GetRasterBand(1)->RasterIO(GF_Write, 0, first, columns_, count, values, columns_, count, GDT_Float32, 0, 0, nullptr);
  if (state != CE_None || !messages.text().empty()) {
    return refused(path_, errno != 0 ? formats::writeFailureReason(errno) : "the raster was not taken" + messages.inBrackets());
  }
  return {};
}

Result<void> RasterOutput::finish() {
  const terrain::detail::GdalMessages messages;
  errno = 0;
  raster_->FlushCache(true);
  raster_.reset();
  if (!messages.text().empty()) {
    return refused(path_, errno != 0 ? formats::writeFailureReason(errno) : "the raster was not taken" + messages.inBrackets());
  }
  if (::fsync(temporary_->descriptor()) != 0) {
    return refused(path_, formats::writeFailureReason(errno));
  }
  if (const int number = temporary_->moveTo(path_); number != 0) {
    return refused(path_, formats::writeFailureReason(number));
  }
  return {};
}

}  // namespace vp::fetch
