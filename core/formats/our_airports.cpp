// Landing sites from airports.csv and runways.csv of OurAirports.
#include "core/base/plain_text.h"
#include "core/formats/airfield_candidates.h"
#include "core/formats/csv.h"
#include "core/formats/limits.h"
#include "core/formats/runway_names.h"
#include "core/formats/surface.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace vp::formats {
namespace {

using geo::LatLon;

struct Airport {
  std::string name;
  LatLon position;
  std::optional<geo::HeightMsl> elevation;
  bool closed = false;
  bool seaplanes = false;
};
using Airports = std::unordered_map<std::string, Airport>;

/// A CSV text with its header read.
struct Table {
  std::string path;
  std::string text;
};

geo::HeightMsl fromFeet(double feet) {
  return geo::HeightMsl::fromMetres(feet * kMetresPerFoot);
}

tl::unexpected<Error> missingColumn(const std::string& path, const std::string& name, const CsvColumns& columns, bool wantsRunways) {
  const bool isRunways = columns.find({"le_ident"}) >= 0;
  const bool isAirports = columns.find({"elevation_ft"}) >= 0 && !isRunways;
  std::string remedy = "export the file from ourairports.com/data again";
  if (wantsRunways && isAirports) {
    remedy = "this is an airports file; name runways.csv as \"runways\"";
  } else if (!wantsRunways && isRunways) {
    remedy = "this is a runways file; name airports.csv as \"airports\" and this one as \"runways\"";
  }
  return fail(Errc::BadFormat, fmt::format("the header has no column \"{}\"; {}", name, remedy), csvPlace(path, 1, 1, {}));
}

tl::unexpected<Error> wrongCount(const std::string& path, const CsvRecord& record, std::size_t expected) {
  return fail(Errc::BadFormat,
              fmt::format("the row has {} fields and the header {}; a comma or a quote is missing or too many", record.fields.size(), expected),
              csvPlace(path, record.row, record.fields.size(), {}));
}

tl::unexpected<Error> noNumber(const std::string& path, const CsvRecord& record, int column, const std::string& name) {
  return fail(Errc::BadFormat, fmt::format("\"{}\" is not a number of degrees; correct it or remove the row", plainText(fieldOf(record, column), 40)),
              csvPlace(path, record.row, static_cast<std::size_t>(column) + 1, name));
}

/// Reads latitude and longitude; nothing if one is empty or out of range.
Result<std::optional<LatLon>> readPlace(const std::string& path, const CsvRecord& record, std::pair<int, int> columns, const std::string& prefix) {
  std::array<std::optional<double>, 2> degrees;
  const std::array<std::pair<int, const char*>, 2> fields{{{columns.first, "latitude_deg"}, {columns.second, "longitude_deg"}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string_view field = fieldOf(record, fields[i].first);
    degrees[i] = parseNumber(field);
    if (!field.empty() && !degrees[i]) {
      return noNumber(path, record, fields[i].first, prefix + fields[i].second);
    }
  }
  if (!degrees[0] || !degrees[1] || std::fabs(*degrees[0]) > 90.0 || std::fabs(*degrees[1]) > 180.0) {
    return std::optional<LatLon>();
  }
  return std::optional<LatLon>(LatLon{*degrees[0], *degrees[1]});
}

/// Elevation in feet if the field holds a plausible one. Lowest airfield: Bar Yehuda -1266 ft; highest: Daocheng 14472 ft.
std::optional<geo::HeightMsl> readElevation(std::string_view field) {
  const std::optional<double> feet = parseNumber(field);
  return feet && *feet > -1500.0 && *feet < 20000.0 ? std::optional(fromFeet(*feet)) : std::nullopt;
}

Result<Airports> readAirportTable(const Table& file, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area, LeftOut& leftOut) {
  CsvReader csv(file.text, file.path, CsvQuotes::Strict);
  CsvRecord record;
  Result<bool> more = csv.next(record);
  if (!more) {
    return forward(more);
  }
  CsvColumns columns(file.path, record);
  const std::size_t width = record.fields.size();
  const int ident = columns.require("ident");
  const int type = columns.require("type");
  const int name = columns.require("name");
  const std::pair<int, int> place{columns.require("latitude_deg"), columns.require("longitude_deg")};
  const int elevation = columns.require("elevation_ft");
  if (!columns.missing().empty()) {
    return missingColumn(file.path, columns.missing(), columns, false);
  }
  Airports airports;
  for (more = csv.next(record); more && *more; more = csv.next(record)) {
    if (record.fields.size() != width) {
      return wrongCount(file.path, record, width);
    }
    const Result<std::optional<LatLon>> position = readPlace(file.path, record, place, "");
    if (!position) {
      return forward(position);
    }
    const std::string key(fieldOf(record, ident));
    if (*position && area && !area->contains(**position)) {
      continue;
    }
    const std::string_view kind = fieldOf(record, type);
    const bool closed = kind == "closed" || kind == "closed_airport";
    if (!*position) {
      leftOut.add("airport without a usable position", key);
    } else if (kind == "heliport") {
      leftOut.add("heliport", key);
    } else if (kind == "balloonport") {
      leftOut.add("balloonport", key);
    } else if (closed && !filter.closed) {
      leftOut.add("airport closed", key);
    } else if (kind == "seaplane_base" && !filter.water) {
      leftOut.add("seaplane base", key);
    } else if (airports.size() >= kMostAirports) {
      leftOut.add(fmt::format("more than {} airports; take the part of the file for the region", kMostAirports), key);
    } else if (!key.empty()) {
      airports.emplace(
          key, Airport{std::string(fieldOf(record, name)), **position, readElevation(fieldOf(record, elevation)), closed, kind == "seaplane_base"});
    }
  }
  if (!more) {
    return forward(more);
  }
  return airports;
}

/// Places of the columns of runways.csv.
struct RunwayColumns {
  struct End {
    int ident = -1;
    std::pair<int, int> place{-1, -1};
    int elevation = -1;
    int heading = -1;
    int displaced = -1;
  };
  int airport = -1;
  int length = -1;
  int width = -1;
  int surface = -1;
  int lighted = -1;
  int closed = -1;
  End low;
  End high;
  std::size_t count = 0;

  static RunwayColumns from(CsvColumns& columns, std::size_t count) {
    const auto end = [&](const std::string& prefix) {
      return End{columns.require(prefix + "_ident"),
                 {columns.require(prefix + "_latitude_deg"), columns.require(prefix + "_longitude_deg")},
                 columns.require(prefix + "_elevation_ft"),
                 columns.require(prefix + "_heading_degT"),
                 columns.require(prefix + "_displaced_threshold_ft")};
    };
    return {columns.require("airport_ident"),
            columns.require("length_ft"),
            columns.require("width_ft"),
            columns.require("surface"),
            columns.require("lighted"),
            columns.require("closed"),
            end("le"),
            end("he"),
            count};
  }
};

std::optional<double> readHeading(std::string_view field) {
  const std::optional<double> heading = parseNumber(field);
  return heading && *heading >= 0.0 && *heading <= 360.0 ? std::optional(std::fmod(*heading, 360.0)) : std::nullopt;
}

std::optional<double> reversed(std::optional<double> course) {
  return course ? std::optional(std::fmod(*course + 180.0, 360.0)) : std::nullopt;
}

/// True course from the low to the high end, from headings, else from the runway's name (then marked).
std::optional<Angle> findCourse(const CsvRecord& record, const RunwayColumns& columns, bool bothEnds, LatLon place,
                                std::vector<std::string>& approximations) {
  const std::optional<double> low = readHeading(fieldOf(record, columns.low.heading));
  const std::optional<double> high = reversed(readHeading(fieldOf(record, columns.high.heading)));
  const std::string_view lowIdent = fieldOf(record, columns.low.ident);
  const std::string_view highIdent = fieldOf(record, columns.high.ident);
  std::optional<double> named = courseOfIdent(lowIdent);
  named = named ? named : reversed(courseOfIdent(highIdent));
  const std::optional<double> heading = low ? low : high;
  if (bothEnds) {
    return heading ? std::optional(Angle::degrees(*heading)) : std::nullopt;  // the ends count; the heading is only compared
  }
  if (!heading) {
    if (const std::optional<NamedCourse> derived = courseFromName(lowIdent, place)) {
      approximations.push_back(derived->how);
      return derived->course;
    }
    if (const std::optional<NamedCourse> derived = courseFromName(highIdent, place)) {
      approximations.push_back(derived->how);
      return Angle::degrees(*reversed(derived->course.degrees()));
    }
    return std::nullopt;
  }
  if (low && high && courseDifference(*low, *high) > 5.0) {
    approximations.emplace_back("headings of the two ends are not opposite; the first counts");
  }
  if (named && courseDifference(*heading, *named) > 45.0) {  // more than any magnetic variation where runways are numbered magnetic
    approximations.emplace_back("heading disagrees with the runway number; the heading counts");
  }
  return Angle::degrees(*heading);
}

bool isHelipad(std::string_view ident) {
  return ident.starts_with('H') || ident == "PAD";
}

/// Runways of water are marked by a W after the number ("18W").
bool isWaterLane(std::string_view ident) {
  return ident.size() >= 2 && ident.back() == 'W' && ident[ident.size() - 2] >= '0' && ident[ident.size() - 2] <= '9';
}

/// An end of a runway; the places must have been read already.
RunwayGeometry::End readEnd(const CsvRecord& record, const RunwayColumns::End& columns, std::optional<LatLon> place, bool& nonsense) {
  RunwayGeometry::End end;
  end.ident = fieldOf(record, columns.ident);
  end.place = place;
  const std::string_view elevation = fieldOf(record, columns.elevation);
  end.elevation = readElevation(elevation);
  const std::string_view displaced = fieldOf(record, columns.displaced);
  const std::optional<double> feet = parseNumber(displaced);
  end.displaced = Length::fromSi(feet.value_or(0.0) * kMetresPerFoot);
  const bool outside = !place && !(fieldOf(record, columns.place.first).empty() || fieldOf(record, columns.place.second).empty());
  const std::string_view heading = fieldOf(record, columns.heading);
  nonsense =
      nonsense || outside || (!elevation.empty() && !end.elevation) || (!displaced.empty() && !feet) || (!heading.empty() && !readHeading(heading));
  return end;
}

Result<void> readRunwayRow(const std::string& path, const CsvRecord& record, const RunwayColumns& columns, const Airport& airport, int number,
                           std::vector<Candidate>& candidates, LeftOut& leftOut) {
  const Result<std::optional<LatLon>> low = readPlace(path, record, columns.low.place, "le_");
  const Result<std::optional<LatLon>> high = readPlace(path, record, columns.high.place, "he_");
  if (!low || !high) {
    return !low ? forward(low) : forward(high);
  }
  Candidate common;
  common.runway = number;
  common.site.airportIdent = fieldOf(record, columns.airport);
  common.site.airportName = airport.name;
  common.site.source = fileName(path);
  bool nonsense = false;
  RunwayGeometry runway;
  runway.low = readEnd(record, columns.low, *low, nonsense);
  runway.high = readEnd(record, columns.high, *high, nonsense);
  const std::string name = common.site.airportIdent + "/" + runway.low.ident;
  if (isHelipad(runway.low.ident) || (runway.low.ident.empty() && isHelipad(runway.high.ident))) {
    leftOut.add("helipad", name);
    return {};
  }
  if (runway.low.ident.empty() && runway.high.ident.empty()) {
    leftOut.add("runway without a name", name);
    return {};
  }
  const std::string_view lengthField = fieldOf(record, columns.length);
  const std::optional<double> length = parseNumber(lengthField);
  const std::optional<double> width = parseNumber(fieldOf(record, columns.width));
  nonsense = nonsense || (!lengthField.empty() && (!length || *length < 0.0 || *length > 50000.0));
  if (nonsense) {
    leftOut.add("a value of the runway makes no sense", fmt::format("{} in row {}", name, record.row));
    return {};
  }
  if (length && *length > 0.0) {
    runway.length = Length::fromSi(*length * kMetresPerFoot);
  }
  if (width && *width > 0.0) {
    common.site.width = Length::fromSi(*width * kMetresPerFoot);
  }
  const std::string_view surface = fieldOf(record, columns.surface);
  const bool water = airport.seaplanes || isWaterLane(runway.low.ident) || isWaterLane(runway.high.ident);
  common.site.surface = water ? mission::Surface::Water : surfaceFromText(surface);
  common.site.lighted = fieldOf(record, columns.lighted) == "1";
  common.closed = airport.closed || fieldOf(record, columns.closed) == "1" || surface == "CLOSED";
  runway.centre = airport.position;
  runway.elevation = airport.elevation;
  runway.course = findCourse(record, columns, runway.low.place && runway.high.place, airport.position, common.site.approximations);
  if (runway.low.ident.empty() || runway.high.ident.empty()) {
    leftOut.add("opposite end not in the file", name);
  }
  addRunway(runway, common, candidates, leftOut);
  return {};
}

Result<std::vector<Candidate>> readRunwayTable(const Table& file, const Airports& airports, LeftOut& leftOut) {
  CsvReader csv(file.text, file.path, CsvQuotes::Strict);
  CsvRecord record;
  Result<bool> more = csv.next(record);
  if (!more) {
    return forward(more);
  }
  CsvColumns header(file.path, record);
  const RunwayColumns columns = RunwayColumns::from(header, record.fields.size());
  if (!header.missing().empty()) {
    return missingColumn(file.path, header.missing(), header, true);
  }
  std::vector<Candidate> candidates;
  int number = 0;
  for (more = csv.next(record); more && *more; more = csv.next(record)) {
    if (record.fields.size() != columns.count) {
      return wrongCount(file.path, record, columns.count);
    }
    const auto airport = airports.find(std::string(fieldOf(record, columns.airport)));
    if (airport == airports.end()) {
      continue;
    }
    if (const Result<void> read = readRunwayRow(file.path, record, columns, airport->second, number++, candidates, leftOut); !read) {
      return forward(read);
    }
  }
  if (!more) {
    return forward(more);
  }
  return candidates;
}

}  // namespace

Result<AirfieldReport> readOurAirports(const std::string& airportsCsv, const std::string& runwaysCsv, const mission::SiteFilter& filter,
                                       const std::optional<geo::GeoBox>& area) {
  Result<std::string> airportsText = readText(airportsCsv);
  if (!airportsText) {
    return forward(airportsText);
  }
  Result<std::string> runwaysText = readText(runwaysCsv);
  if (!runwaysText) {
    return forward(runwaysText);
  }
  LeftOut leftOut;
  const Result<Airports> airports = readAirportTable({airportsCsv, std::move(*airportsText)}, filter, grownArea(area), leftOut);
  if (!airports) {
    return forward(airports);
  }
  Result<std::vector<Candidate>> candidates = readRunwayTable({runwaysCsv, std::move(*runwaysText)}, *airports, leftOut);
  if (!candidates) {
    return forward(candidates);
  }
  return applyFilter(std::move(*candidates), filter, area, std::move(leftOut));
}

}  // namespace vp::formats
