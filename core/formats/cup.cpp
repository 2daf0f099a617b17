// Landing sites from SeeYou .cup files.
#include "core/base/plain_text.h"
#include "core/formats/airfield_candidates.h"
#include "core/formats/csv.h"
#include "core/formats/cup_fields.h"
#include "core/formats/named_fields.h"
#include "core/formats/runway_names.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::formats {
namespace {

using geo::LatLon;

/// A unit is required: without one metres and feet cannot be told apart.
std::optional<Length> parseLength(std::string_view text) {
  return parseLengthWithUnit(text, 0.0);
}

mission::Surface surfaceOfStyle(std::string_view style) {
  return style == "2" ? mission::Surface::Grass : style == "5" ? mission::Surface::Hard : mission::Surface::Unknown;
}

bool isLandable(std::string_view style) {
  return style == "2" || style == "3" || style == "4" || style == "5";
}

tl::unexpected<Error> badCoordinate(const std::string& path, const CsvRecord& record, int column, bool isLatitude) {
  return fail(Errc::BadFormat,
              fmt::format("\"{}\" is not a {}; write it like {}", plainText(fieldOf(record, column), 40), isLatitude ? "latitude" : "longitude",
                          isLatitude ? "4632.046N" : "00953.046E"),
              csvPlace(path, record.row, static_cast<std::size_t>(column) + 1, isLatitude ? "lat" : "lon"));
}

void readPoint(const CsvRecord& record, const CupColumns& columns, LatLon place, Candidate common, std::vector<Candidate>& candidates,
               LeftOut& leftOut) {
  const std::string name = common.site.airportIdent;
  const std::string_view directionField = fieldOf(record, columns.direction);
  const std::string_view lengthField = fieldOf(record, columns.length);
  const std::optional<double> direction = parseNumber(directionField);
  const std::optional<Length> elevation = parseLength(fieldOf(record, columns.elevation));
  std::optional<Length> length = parseLength(lengthField);
  if (!elevation || elevation->si() < -500.0 || elevation->si() > 9000.0) {
    leftOut.add("no usable elevation with a unit", name);
    return;
  }
  if (length && length->si() > 30000.0) {
    length.reset();  // such values are frequencies or slips
  }
  if (length && length->si() <= 0.0) {
    length.reset();
  }
  const bool zeroMeansNone = direction && *direction == 0.0 && !length;  // 0 stands for "no runway" in many files, north is 360
  if (!direction || *direction < 0.0 || *direction > 360.0 || zeroMeansNone) {
    leftOut.add(directionField.empty() || zeroMeansNone ? "no runway direction" : "runway direction makes no sense", name);
    return;
  }
  mission::LandingSite& site = common.site;
  site.approximations.emplace_back("runway direction published to whole degrees at best");
  if (fieldOf(record, columns.style) == "3") {
    site.approximations.emplace_back("outlanding field, not an aerodrome");
  }
  if (elevation->si() == 0.0) {
    site.approximations.emplace_back("elevation 0 in the file, which may stand for unknown");
  }
  if (const auto width = parseLength(fieldOf(record, columns.width)); width && width->si() > 0.0) {
    site.width = width;
  }
  RunwayGeometry runway;
  runway.centre = place;
  runway.course = Angle::degrees(std::fmod(*direction, 360.0));
  runway.length = length;
  runway.low.ident = runwayNumber(*direction);
  runway.high.ident = runwayNumber(std::fmod(*direction + 180.0, 360.0));
  runway.low.elevation = runway.high.elevation = runway.elevation = geo::HeightMsl::fromMetres(elevation->si());
  addRunway(runway, common, candidates, leftOut);
}

}  // namespace

Result<AirfieldReport> readCup(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  CsvReader csv(*text, path, CsvQuotes::Lenient);
  CsvRecord record;
  Result<bool> more = csv.next(record);
  if (!more) {
    return forward(more);
  }
  const CupColumns columns(CsvColumns(path, record));
  if (const char* missing = columns.missing()) {
    return fail(Errc::BadFormat,
                fmt::format("the header has no column \"{}\"; a .cup file begins with name,code,country,lat,lon,elev,style,rwdir,rwlen,...", missing),
                csvPlace(path, 1, 1, {}));
  }
  LeftOut leftOut;
  std::vector<Candidate> candidates;
  int number = 0;
  const std::optional<geo::GeoBox> near = grownArea(area);
  while (!beginsCupTasks(csv)) {
    more = csv.next(record);
    if (!more) {
      return forward(more);
    }
    if (!*more) {
      break;
    }
    const std::string_view style = fieldOf(record, columns.style);
    if (!isLandable(style)) {
      continue;
    }
    const std::optional<double> latitude = parseCupAngle(fieldOf(record, columns.latitude), 2, "NS");
    const std::optional<double> longitude = parseCupAngle(fieldOf(record, columns.longitude), 3, "EW");
    if (!latitude || !longitude) {
      return badCoordinate(path, record, latitude ? columns.longitude : columns.latitude, !latitude);
    }
    if (near && !near->contains({*latitude, *longitude})) {
      continue;
    }
    Candidate common;
    common.runway = number++;
    const std::string_view code = fieldOf(record, columns.code);
    common.site.airportName = fieldOf(record, columns.name);
    common.site.airportIdent = code.empty() ? common.site.airportName : std::string(code);
    common.site.surface = surfaceOfStyle(style);
    common.site.source = fileName(path);
    readPoint(record, columns, {*latitude, *longitude}, std::move(common), candidates, leftOut);
  }
  return applyFilter(std::move(candidates), filter, area, std::move(leftOut));
}

}  // namespace vp::formats
