#include "core/fetch/tile_raster.h"

#include "core/fetch/raster_output.h"
#include "core/terrain/gdal_support.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace vp::fetch {
namespace {

constexpr int kRows = 3600;

Result<void> checkPlace(GDALDataset& raster, const std::string& path, TileId tile) {
  std::array<double, 6> at{};
  const OGRSpatialReference* crs = raster.GetSpatialRef();
  if (raster.GetRasterCount() != 1 || crs == nullptr || crs->IsGeographic() == 0 || raster.GetGeoTransform(at.data()) != CE_None) {
    return fail(Errc::BadFile, "what the server sent is no terrain tile: it must be one band in degrees; choose another server", path);
  }
  constexpr double kSlack = 0.01;  // degree; tiles are shifted by half a post, some kinds overlap by one
  const double east = at[0] + at[1] * raster.GetRasterXSize();
  const double south = at[3] + at[5] * raster.GetRasterYSize();
  const bool fits = std::abs(at[0] - tile.west) < kSlack && std::abs(at[3] - (tile.south + 1)) < kSlack &&
                    std::abs(east - (tile.west + 1)) < kSlack && std::abs(south - tile.south) < kSlack && at[2] == 0.0 && at[4] == 0.0;
  if (!fits) {
    return fail(Errc::BadFile, fmt::format("what the server sent lies elsewhere than tile {}; choose another server", shortNameOf(tile)), path);
  }
  return {};
}

}  // namespace

Result<void> checkTiffStart(std::string_view bytes, const std::string& url) {
  using namespace std::string_view_literals;
  for (const std::string_view start : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
    if (bytes.substr(0, start.size()) == start) {
      return {};
    }
  }
  const bool isText = bytes.find('<') < 64;
  return fail(
      Errc::BadFile,
      fmt::format("the server sends no GeoTIFF{}; check the address, and whether the network wants a login first", isText ? " but a web page" : ""),
      url);
}

Result<void> checkTile(const std::string& path, TileId tile, const Job& job) {
  const terrain::detail::GdalMessages messages;
  const std::array<const char*, 2> drivers{"GTiff", nullptr};
  const std::unique_ptr<GDALDataset> raster(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data()));
  if (raster == nullptr) {
    return fail(Errc::BadFile, "what the server sent is no GeoTIFF" + messages.inBrackets() + "; try again, or choose another server", path);
  }
  if (Result<void> placed = checkPlace(*raster, path, tile); !placed) {
    return placed;
  }
  constexpr int kAtOnce = 512;  // rows: whole blocks of a cloud-optimised file
  const int columns = raster->GetRasterXSize();
  std::vector<float> heights(static_cast<std::size_t>(columns) * kAtOnce);
  for (int row = 0; row < raster->GetRasterYSize(); row += kAtOnce) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "fetching was stopped; what came so far is kept and will be continued");
    }
    const int rows = std::min(kAtOnce, raster->GetRasterYSize() - row);
    if (raster->GetRasterBand(1)->RasterIO(GF_Read, 0, row, columns, rows, heights.data(), columns, rows, GDT_Float32, 0, 0, nullptr) != CE_None) {
      return fail(Errc::BadFile, "what the server sent is damaged" + messages.inBrackets() + "; try again, or choose another server", path);
    }
  }
  return {};
}

Result<void> makeTile(const std::string& path, TileId tile, MadeTile kind) {
  const bool isSea = kind == MadeTile::Ocean;
  const int columns = columnsOf(tile);
  RasterPlace place;
  place.columns = columns;
  place.rows = kRows;
  place.stepX = 1.0 / columns;
  place.stepY = 1.0 / kRows;
  place.west = tile.west - place.stepX / 2.0;  // posts on full degrees in the west and north, as in the tiles of the server
  place.north = tile.south + 1 + place.stepY / 2.0;
  const std::map<std::string, std::string> words{
      {"VOLPLANE_KIND", isSea ? "ocean" : "unknown"},
      {"TIFFTAG_IMAGEDESCRIPTION",
       fmt::format("{}: {}", shortNameOf(tile),
                   isSea ? "no such tile on the server, so sea: zero everywhere" : "not published: nothing is known here")}};
  Result<RasterOutput> output = RasterOutput::create(path, place, words);
  if (!output) {
    return forward(output);
  }
  const std::vector<float> row(static_cast<std::size_t>(columns), isSea ? 0.0F : kNoHeight);
  for (int line = 0; line < kRows; ++line) {
    if (Result<void> written = output->writeRows(line, 1, row); !written) {
      return written;
    }
  }
  return output->finish();
}

}  // namespace vp::fetch
