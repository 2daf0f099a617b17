#include "core/fetch/tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace vp::fetch {

std::string nameOf(TileId tile) {
  return fmt::format("Copernicus_DSM_COG_10_{}{:02d}_00_{}{:03d}_00_DEM", tile.south < 0 ? 'S' : 'N', std::abs(tile.south), tile.west < 0 ? 'W' : 'E',
                     std::abs(tile.west));
}

std::string shortNameOf(TileId tile) {
  return fmt::format("{}{:02d}{}{:03d}", tile.south < 0 ? 'S' : 'N', std::abs(tile.south), tile.west < 0 ? 'W' : 'E', std::abs(tile.west));
}

std::string urlOf(const std::string& base, TileId tile) {
  return fmt::format("{}/{}/{}.tif", base, nameOf(tile), nameOf(tile));
}

int columnsOf(TileId tile) {
  struct Band {
    int below;  ///< degrees of latitude of the edge nearer to the equator
    int columns;
  };
  static constexpr std::array<Band, 5> kBands{{{50, 3600}, {60, 2400}, {70, 1800}, {80, 1200}, {85, 720}}};
  const int edge = tile.south >= 0 ? tile.south : -(tile.south + 1);
  const auto* band = std::find_if(kBands.begin(), kBands.end(), [edge](const Band& b) { return edge < b.below; });
  return band == kBands.end() ? 360 : band->columns;
}

bool isWithheld(TileId tile) {
  return tile.south >= 38 && tile.south <= 41 && tile.west >= 43 && tile.west <= 50;
}

Result<std::vector<TileId>> tilesUnder(const geo::GeoBox& box) {
  const double west = box.southWest.longitude_deg;
  const double east = box.northEast.longitude_deg;
  const double south = box.southWest.latitude_deg;
  const double north = box.northEast.latitude_deg;
  const bool finite = std::isfinite(west) && std::isfinite(east) && std::isfinite(south) && std::isfinite(north);
  if (!finite || south < -90.0 || north > 90.0 || west < -180.0 || east > 180.0) {
    return fail(Errc::OutOfRange, "the area is not on earth; give west, south, east, north in degrees, -180 to 180 and -90 to 90");
  }
  if (west > east) {
    return fail(Errc::OutOfRange, "west lies east of east; exchange them, and fetch an area across the 180th meridian in two parts");
  }
  constexpr double kLeast = 0.001;  // degree: a hundred metres
  if (north - south < kLeast || east - west < kLeast) {
    return fail(Errc::OutOfRange, "the area is empty or less than 0.001 degrees wide; give west, south, east, north");
  }
  const auto first = [](double degrees) { return static_cast<int>(std::floor(degrees)); };
  const auto last = [](double degrees) { return static_cast<int>(std::ceil(degrees)) - 1; };
  const int count = (last(north) - first(south) + 1) * (last(east) - first(west) + 1);
  if (count > kMostTiles) {
    return fail(Errc::OutOfRange,
                fmt::format("the area covers {} tiles of one degree, at most {} can be fetched at once; choose a smaller area", count, kMostTiles));
  }
  std::vector<TileId> tiles;
  for (int row = last(north); row >= first(south); --row) {
    for (int column = first(west); column <= last(east); ++column) {
      tiles.push_back({row, column});
    }
  }
  return tiles;
}

Result<geo::GeoBox> boxAround(geo::LatLon place, double radius_m) {
  if (!(radius_m >= 100.0 && radius_m <= 300'000.0)) {
    return fail(Errc::OutOfRange, "the radius must be 0.1 to 300 km");
  }
  const double north = geo::geodesicDestination(place, Angle::degrees(0.0), Length::fromSi(radius_m)).latitude_deg;
  const double south = geo::geodesicDestination(place, Angle::degrees(180.0), Length::fromSi(radius_m)).latitude_deg;
  // Half the width of the circle in longitude is asin(sin(r) / cos(latitude)) on the sphere; the smaller radius of the earth keeps it an upper bound.
  constexpr double kSmallRadius = 6'335'000.0;  // m, least radius of curvature of WGS 84: along the meridian at the equator
  const double turn = std::sin(radius_m / kSmallRadius) / std::cos(place.latitude_deg * Angle::kPi / 180.0);
  if (!(turn < 1.0) || north <= place.latitude_deg || south >= place.latitude_deg) {
    return fail(Errc::OutOfRange, "the circle holds a pole; choose a smaller radius");
  }
  const double half = std::asin(turn) * 180.0 / Angle::kPi;
  if (place.longitude_deg - half < -180.0 || place.longitude_deg + half > 180.0) {
    return fail(Errc::OutOfRange, "the area crosses the 180th meridian; fetch it in two parts, each given by its corners");
  }
  return geo::GeoBox{{south, place.longitude_deg - half}, {north, place.longitude_deg + half}};
}

}  // namespace vp::fetch
