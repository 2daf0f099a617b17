// Landing sites of tables and GeoJSON that people write themselves.
#include "core/formats/own_fields.h"

#include "core/formats/airfield_candidates.h"
#include "core/formats/geojson_features.h"
#include "core/formats/named_fields.h"
#include "core/formats/runway_names.h"
#include "core/formats/surface.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::formats {
namespace {

using geo::LatLon;

enum Field {
  Airport,
  Name,
  Runway,
  Latitude,
  Longitude,
  EndLatitude,
  EndLongitude,
  Course,
  ElevationM,
  ElevationFt,
  LengthM,
  LengthFt,
  WidthM,
  WidthFt,
  DisplacedM,
  DisplacedFt,
  SurfaceText,
  Lighted,
  Closed,
  OneWay
};

const FieldNames& fieldNames() {
  static const FieldNames names({{"airport", "ident", "icao", "code", "id"},
                                 {"name", "title"},
                                 {"runway", "rwy", "runway_ident"},
                                 {"latitude", "lat", "latitude_deg"},
                                 {"longitude", "lon", "lng", "long", "longitude_deg"},
                                 {"end_latitude", "end_lat", "latitude2", "lat2"},
                                 {"end_longitude", "end_lon", "longitude2", "lon2"},
                                 {"course_deg", "course", "landing_course", "landing_course_deg", "heading", "heading_deg", "direction", "rwdir"},
                                 {"elevation_m", "elevation", "elev", "elev_m", "ele"},
                                 {"elevation_ft", "elev_ft"},
                                 {"length_m", "length", "rwlen"},
                                 {"length_ft"},
                                 {"width_m", "width", "rwwidth"},
                                 {"width_ft"},
                                 {"displaced_m", "displaced", "displaced_threshold_m"},
                                 {"displaced_ft", "displaced_threshold_ft"},
                                 {"surface"},
                                 {"lighted", "lights", "lit"},
                                 {"closed"},
                                 {"one_way"}});
  return names;
}

/// What one row or feature is called in notes.
struct Row {
  const FieldValues& values;
  std::string where;  ///< "row 12"

  [[nodiscard]] std::string_view text(Field field) const { return trimmed(values[field]); }
  [[nodiscard]] bool has(Field field) const { return !text(field).empty(); }
};

/// A length in metres or feet by its column; false if there is text that is none.
bool readLength(const Row& row, Field metres, Field feet, std::optional<Length>& length) {
  if (row.has(metres)) {
    length = parseLengthWithUnit(row.text(metres), 1.0);
    return length.has_value();
  }
  if (row.has(feet)) {
    length = parseLengthWithUnit(row.text(feet), kMetresPerFoot);
    return length.has_value();
  }
  return true;
}

bool isBetween(const std::optional<Length>& length, double low, double high) {
  return !length || (length->si() >= low && length->si() <= high);
}

/// The values that describe a runway apart from where it lies; "" or what is wrong.
std::string readValues(const Row& row, RunwayGeometry& runway, Candidate& common) {
  std::optional<Length> elevation;
  std::optional<Length> displaced;
  mission::LandingSite& site = common.site;
  if (!readLength(row, ElevationM, ElevationFt, elevation) || !isBetween(elevation, -500.0, 9000.0)) {
    return "elevation makes no sense";
  }
  if (!readLength(row, LengthM, LengthFt, runway.length) || !isBetween(runway.length, 1.0, 15000.0)) {
    return "length makes no sense";
  }
  if (!readLength(row, WidthM, WidthFt, site.width) || !isBetween(site.width, 1.0, 1000.0)) {
    return "width makes no sense";
  }
  if (!readLength(row, DisplacedM, DisplacedFt, displaced) || !isBetween(displaced, 0.0, 15000.0)) {
    return "displaced threshold makes no sense";
  }
  const std::optional<bool> lighted = parseYesNo(row.text(Lighted));
  const std::optional<bool> closed = parseYesNo(row.text(Closed));
  if (!lighted || !closed || !parseYesNo(row.text(OneWay))) {
    return "lighted, closed and one_way take yes or no";
  }
  site.lighted = *lighted;
  common.closed = *closed;
  site.surface = surfaceFromText(row.text(SurfaceText));
  runway.low.displaced = displaced.value_or(Length());
  if (elevation) {
    runway.low.elevation = runway.high.elevation = runway.elevation = geo::HeightMsl::fromMetres(elevation->si());
  }
  return {};
}

/// The course, given or by the runway's name; "" or what is wrong.
std::string readCourse(const Row& row, RunwayGeometry& runway, Candidate& common) {
  if (row.has(Course)) {
    std::string_view text = row.text(Course);
    text.remove_suffix(text.ends_with("\xC2\xB0") ? 2 : 0);
    const std::optional<double> course = parseDecimal(trimmed(text));
    if (!course || *course < 0.0 || *course > 360.0) {
      return "course is no number of 0 to 360 degrees";
    }
    runway.course = Angle::degrees(std::fmod(*course, 360.0));
  } else if (!runway.high.place) {
    const std::optional<NamedCourse> named = courseFromName(row.text(Runway), *runway.low.place);
    if (!named) {
      return "neither a course nor the other end nor a runway number";
    }
    runway.course = named->course;
    common.site.approximations.push_back(named->how);
  }
  return {};
}

void nameEnds(const Row& row, RunwayGeometry& runway) {
  const LatLon place = *runway.low.place;
  const double course = runway.high.place ? geo::geodesicCourse(place, *runway.high.place).degrees() : runway.course->degrees();
  const double magnetic = std::fmod(course - variationForRunways(place).degrees() + 360.0, 360.0);
  runway.low.ident = row.has(Runway) ? std::string(row.text(Runway)) : runwayNumber(magnetic);
  if (parseYesNo(row.text(OneWay)).value_or(false)) {
    return;
  }
  runway.high.ident = oppositeIdent(runway.low.ident);
  if (runway.high.ident.empty()) {
    runway.high.ident = runwayNumber(std::fmod(magnetic + 180.0, 360.0));
  }
}

/// Adds what a row describes, or notes why not.
void addRow(const Row& row, std::optional<LatLon> low, std::optional<LatLon> high, Candidate common, std::vector<Candidate>& candidates,
            LeftOut& leftOut) {
  RunwayGeometry runway;
  if (!low) {
    leftOut.add("latitude and longitude are no place in degrees", row.where);
    return;
  }
  runway.low.place = low;
  runway.high.place = high;
  runway.centre = *low;
  std::string fault = readValues(row, runway, common);
  fault = fault.empty() ? readCourse(row, runway, common) : fault;
  if (!fault.empty()) {
    leftOut.add(fault, row.where);
    return;
  }
  nameEnds(row, runway);
  common.site.airportName = row.text(Name);
  common.site.airportIdent = row.has(Airport) ? row.text(Airport) : row.has(Name) ? row.text(Name) : std::string_view("field of " + row.where);
  addRunway(runway, common, candidates, leftOut);
}

/// The place in two fields; nothing if it is none.
std::optional<LatLon> placeOf(const Row& row, Field latitude, Field longitude) {
  const std::optional<double> north = parseDecimal(row.text(latitude));
  const std::optional<double> east = parseDecimal(row.text(longitude));
  if (!north || !east || std::fabs(*north) > 90.0 || std::fabs(*east) > 180.0) {
    return std::nullopt;
  }
  return LatLon{*north, *east};
}

struct OwnColumns {
  std::vector<int> field;  ///< of each column, -1 = not one of ours
  std::array<bool, OneWay + 1> has{};

  explicit OwnColumns(const CsvRecord& header) {
    for (const std::string& name : header.fields) {
      const int found = fieldNames().find(name);
      field.push_back(found >= 0 && !has[static_cast<std::size_t>(found)] ? found : -1);  // of two with one meaning the first counts
      if (found >= 0) {
        has[static_cast<std::size_t>(found)] = true;
      }
    }
  }
  [[nodiscard]] bool isOwnTable() const { return has[Latitude] && has[Longitude] && (has[Course] || has[EndLatitude] || has[Runway]); }
};

}  // namespace

bool isOwnTableHeader(const CsvRecord& header) {
  return OwnColumns(header).isOwnTable();
}

bool mentionsRunways(std::string_view json) {
  for (std::size_t at = json.find('"'); at != std::string_view::npos; at = json.find('"', at + 1)) {
    const std::size_t end = json.find('"', at + 1);
    if (end == std::string_view::npos) {
      return false;
    }
    const int field = fieldNames().find(json.substr(at + 1, end - at - 1));
    if (field == Runway || field == Course) {
      return true;
    }
    at = end;
  }
  return false;
}

Result<AirfieldReport> readOwnTable(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  CsvReader csv(*text, path, CsvQuotes::Strict, separatorOf(std::string_view(*text).substr(0, text->find_first_of("\r\n"))));
  CsvRecord record;
  Result<bool> more = csv.next(record);
  if (!more) {
    return forward(more);
  }
  const OwnColumns columns(record);
  if (!columns.isOwnTable()) {
    return fail(Errc::BadFormat, "the header lacks latitude and longitude, or course_deg (or end_latitude and end_longitude, or runway)",
                csvPlace(path, 1, 1, {}));
  }
  LeftOut leftOut;
  std::vector<Candidate> candidates;
  const std::optional<geo::GeoBox> near = grownArea(area);
  FieldValues values(fieldNames().count());
  Candidate common;
  common.site.source = fileName(path);
  for (more = csv.next(record); more && *more; more = csv.next(record)) {
    std::fill(values.begin(), values.end(), std::string());
    for (std::size_t i = 0; i < std::min(columns.field.size(), record.fields.size()); ++i) {
      if (columns.field[i] >= 0) {
        values[static_cast<std::size_t>(columns.field[i])] = record.fields[i];
      }
    }
    const Row row{values, fmt::format("row {}", record.row)};
    const std::optional<LatLon> low = placeOf(row, Latitude, Longitude);
    if (low && near && !near->contains(*low)) {
      continue;
    }
    ++common.runway;
    addRow(row, low, placeOf(row, EndLatitude, EndLongitude), common, candidates, leftOut);
  }
  if (!more) {
    return forward(more);
  }
  return applyFilter(std::move(candidates), filter, area, std::move(leftOut));
}

Result<AirfieldReport> readOwnGeoJson(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area) {
  const Result<std::vector<GeoFeature>> features = readGeoFeatures(path, fieldNames());
  if (!features) {
    return forward(features);
  }
  LeftOut leftOut;
  std::vector<Candidate> candidates;
  const std::optional<geo::GeoBox> near = grownArea(area);
  Candidate common;
  common.site.source = fileName(path);
  for (const GeoFeature& feature : *features) {
    const Row row{feature.values, fmt::format("line {}", feature.line)};
    const bool isLine = feature.kind == GeoFeature::Kind::Line && feature.places.size() >= 2;
    if (!isLine && feature.kind != GeoFeature::Kind::Point) {
      leftOut.add(feature.fault.empty() ? "neither a point nor a line" : feature.fault, row.where);
      continue;
    }
    if (near && !near->contains(feature.places.front().position)) {
      continue;
    }
    ++common.runway;
    const std::optional<LatLon> high = isLine ? std::optional(feature.places.back().position) : placeOf(row, EndLatitude, EndLongitude);
    addRow(row, feature.places.front().position, high, common, candidates, leftOut);
  }
  return applyFilter(std::move(candidates), filter, area, std::move(leftOut));
}

}  // namespace vp::formats
