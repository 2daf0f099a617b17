#include "tests/core/fetch/bucket.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace vp::fetch::test {
namespace {

std::unique_ptr<GDALDataset> opened(const std::string& path) {
  GDALAllRegister();
  std::unique_ptr<GDALDataset> raster(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  if (!raster) {
    throw std::runtime_error("no raster: " + path);
  }
  return raster;
}

}  // namespace

std::string tileBytes(TileId tile, int columns, int rows, const std::function<float(double, double)>& height) {
  GDALAllRegister();
  const std::string path = "/vsimem/" + nameOf(tile) + ".tif";
  OGRSpatialReference degrees;
  degrees.importFromEPSG(4326);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  std::unique_ptr<GDALDataset> raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, 1, GDT_Float32, nullptr));
  const double dx = 1.0 / columns;
  const double dy = 1.0 / rows;
  std::array<double, 6> at{tile.west - dx / 2.0, dx, 0.0, tile.south + 1 + dy / 2.0, 0.0, -dy};
  raster->SetGeoTransform(at.data());
  raster->SetSpatialRef(&degrees);
  std::vector<float> heights;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      heights.push_back(height(tile.south + 1 - r * dy, tile.west + c * dx));
    }
  }
  if (raster->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, heights.data(), columns, rows, GDT_Float32, 0, 0, nullptr) != CE_None) {
    throw std::runtime_error("the tile could not be written");
  }
  raster.reset();
  vsi_l_offset length = 0;
  const GByte* bytes = VSIGetMemFileBuffer(path.c_str(), &length, FALSE);
  std::string result(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length));
  VSIUnlink(path.c_str());
  return result;
}

float wavyHeight(double latitude, double longitude) {
  return static_cast<float>(std::round(1500.0 + 700.0 * std::sin(37.0 * latitude) + 600.0 * std::cos(53.0 * longitude)));
}

void stock(vp::test::FileServer& server, const std::vector<TileId>& tiles, int columns, int rows) {
  std::string list;
  for (const TileId tile : tiles) {
    list += nameOf(tile) + "\r\n";
    server.put("/" + nameOf(tile) + "/" + nameOf(tile) + ".tif", tileBytes(tile, columns, rows, &wavyHeight));
  }
  server.put("/tileList.txt", list + nameOf({1, 1}) + "\n");
}

float postAt(const std::string& path, double latitude, double longitude) {
  const std::unique_ptr<GDALDataset> raster = opened(path);
  std::array<double, 6> at{};
  raster->GetGeoTransform(at.data());
  const double column = (longitude - at[0]) / at[1] - 0.5;
  const double row = (latitude - at[3]) / at[5] - 0.5;
  if (std::abs(column - std::round(column)) > 1e-3 || std::abs(row - std::round(row)) > 1e-3) {
    throw std::runtime_error("no post there");
  }
  float value = 0.0F;
  if (raster->GetRasterBand(1)->RasterIO(GF_Read, static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row)), 1, 1, &value, 1, 1,
                                         GDT_Float32, 0, 0, nullptr) != CE_None) {
    throw std::runtime_error("no such post");
  }
  return value;
}

RasterFacts factsOf(const std::string& path) {
  const std::unique_ptr<GDALDataset> raster = opened(path);
  std::array<double, 6> at{};
  raster->GetGeoTransform(at.data());
  const auto text = [](const char* value) { return std::string(value != nullptr ? value : ""); };
  return {raster->GetRasterXSize(),
          raster->GetRasterYSize(),
          at[1],
          -at[5],
          at[0] + at[1] / 2.0,
          at[3] + at[5] / 2.0,
          text(raster->GetRasterBand(1)->GetMetadataItem("VOLPLANE_KIND")),
          text(raster->GetMetadataItem("VOLPLANE_OCEAN_TILES"))};
}

TerrainRequest requestFor(const vp::test::FileServer& server, const QTemporaryDir& folder, const geo::GeoBox& area) {
  TerrainRequest request;
  request.area = area;
  request.server = server.address();
  request.cache = folder.filePath("cache").toStdString();
  request.patience = {2, 1};
  return request;
}

Result<FetchedTerrain> fetchAll(const TerrainRequest& request, const std::string& output, const Job& job) {
  const Result<TerrainEstimate> estimate = estimateTerrain(request, job);
  if (!estimate) {
    return forward(estimate);
  }
  return fetchTerrain(request, *estimate, output, job);
}

std::vector<std::string> filesUnder(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, code)) {
    if (entry.is_regular_file()) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace vp::fetch::test
