// Places of tables and GeoJSON whose columns and properties are named.
#include "core/formats/csv.h"
#include "core/formats/named_fields.h"
#include "core/formats/targets/found_targets.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::formats {
namespace {

enum Field { Name, Latitude, Longitude, HeightM, HeightFt, AltitudeM, AltitudeFt, Reference };

const FieldNames& fieldNames() {
  static const FieldNames names({{"name", "target", "ident", "title", "id"},
                                 {"latitude", "lat", "latitude_deg"},
                                 {"longitude", "lon", "lng", "long", "longitude_deg"},
                                 {"height_m", "height", "agl", "agl_m", "height_agl_m", "alt_agl_m"},
                                 {"height_ft", "agl_ft", "height_agl_ft", "alt_agl_ft"},
                                 {"altitude_m", "altitude", "alt", "alt_m", "msl", "msl_m", "alt_msl_m", "altitude_msl_m"},
                                 {"altitude_ft", "alt_ft", "msl_ft", "alt_msl_ft", "altitude_msl_ft"},
                                 {"reference", "datum"}});
  return names;
}

/// Sets the height that a row gives; false if it gives one that makes no sense.
bool readHeight(const FieldValues& values, FoundTargets::Place& place) {
  for (const Field field : {HeightM, HeightFt, AltitudeM, AltitudeFt}) {
    const std::string_view text = trimmed(values[field]);
    if (text.empty()) {
      continue;
    }
    const std::optional<Length> length = parseLengthWithUnit(text, field == HeightFt || field == AltitudeFt ? kMetresPerFoot : 1.0);
    if (!length || length->si() < -500.0 || length->si() > 20000.0) {
      return false;
    }
    const std::string_view reference = trimmed(values[Reference]);
    bool isMsl = field == AltitudeM || field == AltitudeFt;
    if (!reference.empty()) {
      isMsl = reference == "msl" || reference == "MSL" || reference == "amsl" || reference == "AMSL";
      if (!isMsl && reference != "agl" && reference != "AGL") {
        return false;
      }
    }
    (isMsl ? place.heightMsl_m : place.heightAboveGround_m) = length->si();
    return true;
  }
  return true;
}

void addPlace(const FieldValues& values, geo::LatLon position, const std::string& where, FoundTargets& found) {
  FoundTargets::Place place{std::string(trimmed(values[Name])), position, {}, {}};
  if (!readHeight(values, place)) {
    found.leftOut.add("height makes no sense (metres, or with a unit; reference agl or msl)", where);
    return;
  }
  found.places.push_back(std::move(place));
}

std::vector<int> columnsOf(const CsvRecord& header) {
  std::vector<int> columns;
  for (const std::string& name : header.fields) {
    const int field = fieldNames().find(name);
    columns.push_back(std::find(columns.begin(), columns.end(), field) == columns.end() ? field : -1);
  }
  return columns;
}

bool hasPlaces(const std::vector<int>& columns) {
  return std::find(columns.begin(), columns.end(), Latitude) != columns.end() &&
         std::find(columns.begin(), columns.end(), Longitude) != columns.end();
}

std::vector<geo::LatLon> positionsOf(const std::vector<GeoPlace>& places) {
  std::vector<geo::LatLon> positions;
  std::transform(places.begin(), places.end(), std::back_inserter(positions), [](const GeoPlace& place) { return place.position; });
  return positions;
}

}  // namespace

std::optional<geo::LatLon> placeOfDegrees(std::string_view latitude, std::string_view longitude) {
  const std::optional<double> north = parseDecimal(trimmed(latitude));
  const std::optional<double> east = parseDecimal(trimmed(longitude));
  if (!north || !east || std::fabs(*north) > 90.0 || std::fabs(*east) > 180.0) {
    return std::nullopt;
  }
  return geo::LatLon{*north, *east};
}

bool isTargetTableHeader(std::string_view line) {
  CsvReader csv(line, {}, CsvQuotes::Lenient, separatorOf(line));
  CsvRecord header;
  const Result<bool> read = csv.next(header);
  return read && *read && hasPlaces(columnsOf(header));
}

Result<void> findTableTargets(const std::string& path, const std::string& text, FoundTargets& found) {
  CsvReader csv(text, path, CsvQuotes::Strict, separatorOf(std::string_view(text).substr(0, text.find_first_of("\r\n"))));
  CsvRecord record;
  Result<bool> more = csv.next(record);
  if (!more) {
    return forward(more);
  }
  const std::vector<int> columns = columnsOf(record);
  if (!hasPlaces(columns)) {
    return fail(Errc::BadFormat, "the header has no columns latitude and longitude", csvPlace(path, 1, 1, {}));
  }
  found.heightsAreFlown = true;
  FieldValues values(fieldNames().count());
  for (more = csv.next(record); more && *more; more = csv.next(record)) {
    if (found.job.stopRequested()) {
      return readingStopped();
    }
    std::fill(values.begin(), values.end(), std::string());
    for (std::size_t i = 0; i < std::min(columns.size(), record.fields.size()); ++i) {
      if (columns[i] >= 0) {
        values[static_cast<std::size_t>(columns[i])] = record.fields[i];
      }
    }
    const std::string where = fmt::format("row {}", record.row);
    if (const std::optional<geo::LatLon> position = placeOfDegrees(values[Latitude], values[Longitude])) {
      addPlace(values, *position, where, found);
    } else {
      found.leftOut.add("latitude and longitude are no place in degrees", where);
    }
  }
  return more ? Result<void>() : forward(more);
}

Result<void> findGeoJsonTargets(const std::string& path, FoundTargets& found) {
  const Result<std::vector<GeoFeature>> features = readGeoFeatures(path, fieldNames());
  if (!features) {
    return forward(features);
  }
  found.heightsAreFlown = true;
  for (const GeoFeature& feature : *features) {
    if (found.job.stopRequested()) {
      return readingStopped();
    }
    const std::string where = fmt::format("line {}", feature.line);
    switch (feature.kind) {
      case GeoFeature::Kind::None:
        found.leftOut.add(feature.fault, where);
        break;
      case GeoFeature::Kind::Polygon: {
        FoundTargets::Area area{std::string(trimmed(feature.values[Name])), positionsOf(feature.places), {}};
        std::transform(feature.holes.begin(), feature.holes.end(), std::back_inserter(area.holes), positionsOf);
        found.areas.push_back(std::move(area));
        break;
      }
      default:
        for (const GeoPlace& place : feature.places) {
          addPlace(feature.values, place.position, where, found);
        }
    }
  }
  return {};
}

}  // namespace vp::formats
