#include "core/terrain/raster_file.h"

#include "core/base/expect.h"
#include "core/base/local_file.h"
#include "core/base/quantity.h"
#include "core/terrain/elevation_grid.h"
#include "core/terrain/gdal_support.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace vp::terrain::detail {
namespace {

constexpr double kLowestGround = -12'000.0;               // m; the deepest sea floor is at -10.9 km
constexpr double kHighestGround = 9'500.0;                // m; Everest is 8,849 m
constexpr double kMetresPerSurveyFoot = 1200.0 / 3937.0;  // US survey foot, exact (1893)

/// What writers of elevation files put where they have no height, declared or not.
bool isVoidCode(double raw) {
  return raw == -32768.0 || raw == -32767.0 || raw == -9999.0 || raw == -99999.0;
}

std::optional<double> metresPerUnit(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  struct Unit {
    std::string_view name;
    double metres;
  };
  static constexpr std::array<Unit, 24> kUnits{{{"", 1.0},
                                                {"m", 1.0},
                                                {"metre", 1.0},
                                                {"metres", 1.0},
                                                {"meter", 1.0},
                                                {"meters", 1.0},
                                                {"dm", 0.1},
                                                {"decimetre", 0.1},
                                                {"decimeter", 0.1},
                                                {"cm", 0.01},
                                                {"centimetre", 0.01},
                                                {"centimeter", 0.01},
                                                {"km", 1000.0},
                                                {"ft", kMetresPerFoot},
                                                {"foot", kMetresPerFoot},
                                                {"feet", kMetresPerFoot},
                                                {"international foot", kMetresPerFoot},
                                                {"ft (international)", kMetresPerFoot},
                                                {"us-ft", kMetresPerSurveyFoot},
                                                {"ftus", kMetresPerSurveyFoot},
                                                {"sft", kMetresPerSurveyFoot},
                                                {"foot_us", kMetresPerSurveyFoot},
                                                {"us survey foot", kMetresPerSurveyFoot},
                                                {"us_survey_foot", kMetresPerSurveyFoot}}};
  const auto* const found = std::find_if(kUnits.begin(), kUnits.end(), [&name](const Unit& unit) { return unit.name == name; });
  return found == kUnits.end() ? std::nullopt : std::optional<double>(found->metres);
}

tl::unexpected<Error> damaged(const std::string& path, const GdalMessages& messages) {
  return fail(Errc::BadFile, "the file is truncated or damaged; fetch it again" + messages.inBrackets(), path);
}

}  // namespace

std::optional<PostTransform> PostTransform::inverse() const {
  const double determinant = xPerColumn * yPerRow - xPerRow * yPerColumn;
  const double size = std::hypot(xPerColumn, yPerColumn) * std::hypot(xPerRow, yPerRow);
  if (!(std::abs(determinant) > 1e-6 * size) || !std::isfinite(size) || !std::isfinite(x0) || !std::isfinite(y0)) {
    return std::nullopt;
  }
  PostTransform inverted;
  inverted.xPerColumn = yPerRow / determinant;
  inverted.xPerRow = -xPerRow / determinant;
  inverted.yPerColumn = -yPerColumn / determinant;
  inverted.yPerRow = xPerColumn / determinant;
  inverted.x0 = -(inverted.xPerColumn * x0 + inverted.xPerRow * y0);
  inverted.y0 = -(inverted.yPerColumn * x0 + inverted.yPerRow * y0);
  return inverted;
}

Result<RasterFile> RasterFile::open(const std::string& path) {
  const FileKind kind = kindOfFile(path);
  if (kind == FileKind::Missing) {
    return fail(Errc::BadFile, "there is no such file; correct the path of the terrain file", path);
  }
  if (kind == FileKind::Folder) {
    return fail(Errc::BadFile, "this is a folder; name the terrain files in it one by one", path);
  }
  GdalMessages messages;
  RasterFile file;
  file.header_.path = path;
  const Result<GDALDataset*> opened = openDataset(path, Content::Raster);
  if (!opened) {
    return forward(opened);
  }
  file.dataset_.reset(*opened);
  if (!file.dataset_) {
    return fail(Errc::BadFile,
                "this is not a complete raster in a format that is read; give a GeoTIFF, HGT, DTED or ASCII grid" + messages.inBrackets(), path);
  }
  if (const auto header = file.readHeader(); !header) {
    return forward(header);
  }
  return file;
}

Result<void> RasterFile::readHeader() {
  const std::string& path = header_.path;
  header_.driver = dataset_->GetDriver() != nullptr ? dataset_->GetDriver()->GetDescription() : "";
  header_.columns = dataset_->GetRasterXSize();
  header_.rows = dataset_->GetRasterYSize();
  if (const auto band = findBand(); !band) {
    return band;
  }
  const OGRSpatialReference* crs = dataset_->GetSpatialRef();
  if (crs == nullptr || crs->IsEmpty()) {
    return fail(Errc::BadFile,
                "the raster has no coordinate system; add it, for example with gdal_edit.py -a_srs EPSG:4326, or a .prj file beside it", path);
  }
  if (crs->IsLocal() != 0) {
    return fail(Errc::BadFile, "the raster's coordinate system is not tied to the earth; give one, for example with gdal_edit.py -a_srs", path);
  }
  std::array<double, 6> edges{};
  if (dataset_->GetGeoTransform(edges.data()) != CE_None) {
    return fail(Errc::BadFile, "the raster does not say where on the map its pixels lie; rectify it, for example with gdalwarp", path);
  }
  header_.posts = {edges[0] + 0.5 * (edges[1] + edges[2]), edges[1], edges[2], edges[3] + 0.5 * (edges[4] + edges[5]), edges[4], edges[5]};
  if (!header_.posts.inverse()) {
    return fail(Errc::BadFile, "the raster's pixels have no extent on the map; its georeference is damaged, fetch it again", path);
  }
  if (header_.columns < 2 || header_.rows < 2) {
    return fail(Errc::BadFile, fmt::format("the raster has {} x {} heights, and terrain needs at least 2 x 2", header_.columns, header_.rows), path);
  }
  auto horizontal = std::make_shared<OGRSpatialReference>(*crs);
  horizontal->StripVertical();
  horizontal->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  header_.crsName = horizontal->GetName() != nullptr ? horizontal->GetName() : "unnamed";
  header_.turn = horizontal->IsGeographic() != 0 ? 2.0 * Angle::kPi / horizontal->GetAngularUnits() : 0.0;
  header_.crs = std::move(horizontal);
  return readDecoding();
}

Result<void> RasterFile::findBand() {
  const int bands = dataset_->GetRasterCount();
  int heights = 0;
  for (int i = 1; i <= bands; ++i) {
    GDALRasterBand* band = dataset_->GetRasterBand(i);
    if (band->GetColorInterpretation() != GCI_AlphaBand) {
      ++heights;
      band_ = band;
    }
  }
  if (heights == 0) {
    return fail(Errc::BadFile, "the file holds no band of heights; if it is a container, extract the elevation raster with gdal_translate",
                header_.path);
  }
  if (heights > 1) {
    return fail(Errc::BadFile, fmt::format("the raster has {} bands where terrain has one; extract the heights with gdal_translate -b", heights),
                header_.path);
  }
  if (band_->GetColorTable() != nullptr || GDALDataTypeIsComplex(band_->GetRasterDataType()) != 0) {
    return fail(Errc::BadFile, "the raster holds colours or complex numbers, not heights; give an elevation raster", header_.path);
  }
  return {};
}

Result<void> RasterFile::readDecoding() {
  int isSet = 0;
  const double noData = band_->GetNoDataValue(&isSet);
  if (isSet != 0) {
    decoding_.noData = noData;
  }
  decoding_.scale = band_->GetScale();
  decoding_.offset = band_->GetOffset();
  if (!std::isfinite(decoding_.scale) || decoding_.scale == 0.0 || !std::isfinite(decoding_.offset)) {
    return fail(Errc::BadFile,
                fmt::format("the raster's scale {} and offset {} give no heights; correct them with gdal_edit.py", decoding_.scale, decoding_.offset),
                header_.path);
  }
  const char* unit = band_->GetUnitType();
  const std::string unitName = unit != nullptr ? unit : "";
  const auto metres = metresPerUnit(unitName);
  if (!metres) {
    return fail(Errc::BadFile,
                fmt::format("the raster's unit \"{}\" is not one of length that is known here; set it to m or ft with gdal_edit.py -units", unitName),
                header_.path);
  }
  decoding_.metres = *metres;
  const int mask = band_->GetMaskFlags();
  decoding_.isMasked = (mask & (GMF_PER_DATASET | GMF_ALPHA)) != 0 || (mask & (GMF_ALL_VALID | GMF_NODATA)) == 0;

  constexpr int kRows = 64;
  int blockColumns = 1;
  int blockRows = 1;
  band_->GetBlockSize(&blockColumns, &blockRows);
  blockRows = std::max(blockRows, 1);
  constexpr int kMostPosts = 16'000'000;  // 128 MB as they are decoded
  rowsPerRead_ = blockRows > 4 * kRows ? kRows : (kRows + blockRows - 1) / blockRows * blockRows;
  rowsPerRead_ = std::clamp(kMostPosts / header_.columns, 1, rowsPerRead_);
  return {};
}

Result<void> RasterFile::readRows(int first, int count, std::vector<float>& heights) {
  VP_EXPECT(first >= 0 && count > 0 && first + count <= header_.rows);
  const std::size_t posts = static_cast<std::size_t>(count) * static_cast<std::size_t>(header_.columns);
  GdalMessages messages;
  raw_.resize(posts);
  if (band_->RasterIO(GF_Read, 0, first, header_.columns, count, raw_.data(), header_.columns, count, GDT_Float64, 0, 0, nullptr) != CE_None) {
    return damaged(header_.path, messages);
  }
  heights.resize(posts);
  std::transform(raw_.begin(), raw_.end(), heights.begin(), [this](double raw) { return decode(raw); });
  if (decoding_.isMasked) {
    mask_.resize(posts);
    const CPLErr read =
        band_->GetMaskBand()->RasterIO(GF_Read, 0, first, header_.columns, count, mask_.data(), header_.columns, count, GDT_Byte, 0, 0, nullptr);
    if (read != CE_None) {
      return damaged(header_.path, messages);
    }
    for (std::size_t i = 0; i < posts; ++i) {
      heights[i] = mask_[i] == 0 ? kUnknownUpper : heights[i];
    }
  }
  dropUnwritten(first, count, heights);
  return {};
}

/// A block that its writer never reached reads as zero, a false sea level, unless no-data is declared.
void RasterFile::dropUnwritten(int first, int count, std::vector<float>& heights) const {
  const auto isEmpty = [this](int column, int row, int columns, int rows) {
    return (band_->GetDataCoverageStatus(column, row, columns, rows) & GDAL_DATA_COVERAGE_STATUS_EMPTY) != 0;
  };
  if (!isEmpty(0, first, header_.columns, count)) {
    return;
  }
  int blockColumns = 1;
  int blockRows = 1;
  band_->GetBlockSize(&blockColumns, &blockRows);
  const int last = first + count;
  for (int row = first / blockRows * blockRows; row < last; row += blockRows) {
    const int rowFrom = std::max(row, first);
    const int rowTo = std::min(row + blockRows, last);
    for (int column = 0; column < header_.columns; column += blockColumns) {
      const int width = std::min(blockColumns, header_.columns - column);
      if (!isEmpty(column, rowFrom, width, rowTo - rowFrom)) {
        continue;
      }
      for (int r = rowFrom; r < rowTo; ++r) {
        auto* const at = heights.data() + static_cast<std::size_t>(r - first) * static_cast<std::size_t>(header_.columns) + column;
        std::fill(at, at + width, kUnknownUpper);
      }
    }
  }
}

float RasterFile::decode(double raw) const {
  // a no-data value kept as text or double beside 4-byte posts may differ from them by the rounding of a float
  const bool isNoData = decoding_.noData && (raw == *decoding_.noData || std::abs(raw - *decoding_.noData) <= 1.2e-7 * std::abs(*decoding_.noData));
  if (isNoData || isVoidCode(raw)) {
    return kUnknownUpper;
  }
  const double height = (raw * decoding_.scale + decoding_.offset) * decoding_.metres;
  if (!(height >= kLowestGround && height <= kHighestGround)) {
    return kUnknownUpper;  // not-a-number and infinity too
  }
  const float rounded = static_cast<float>(height);
  return static_cast<double>(rounded) < height ? std::nextafter(rounded, kUnknownUpper) : rounded;
}

void RasterFile::Closer::operator()(GDALDataset* dataset) const {
  GDALClose(GDALDataset::ToHandle(dataset));
}

}  // namespace vp::terrain::detail
