#include "core/formats/airfields.h"

#include "core/formats/csv.h"
#include "core/formats/mission_file.h"
#include "core/formats/named_fields.h"
#include "core/formats/own_fields.h"
#include "core/formats/text_file.h"

#include <algorithm>

namespace vp::formats {
namespace {

std::string_view firstLine(std::string_view text) {
  while (!text.empty() && (text.front() == '\n' || text.front() == '\r')) {
    text.remove_prefix(1);
  }
  return text.substr(0, std::min(text.find_first_of("\r\n"), text.size()));
}

bool isAptDat(std::string_view text) {
  const std::string_view origin = trimmed(firstLine(text));
  if (origin != "I" && origin != "A") {
    return false;
  }
  text.remove_prefix(std::min(text.size(), text.find(origin) + 1));
  const std::string_view version = trimmed(firstLine(text.substr(std::min(text.size(), text.find_first_of("\r\n")))));
  return version.size() > 3 && version.substr(0, 4).find_first_not_of("0123456789 ") == std::string_view::npos && version.front() != ' ' &&
         version.find("ADEP") == std::string_view::npos;
}

AirfieldFile kindOfTable(std::string_view text) {
  const std::string_view line = firstLine(text);
  CsvReader csv(line, {}, CsvQuotes::Lenient, separatorOf(line));
  CsvRecord header;
  if (const Result<bool> read = csv.next(header); !read || !*read) {
    return AirfieldFile::None;
  }
  const CsvColumns columns({}, header);
  const auto has = [&](const std::vector<std::string>& names) { return columns.find(names) >= 0; };
  if (has({"le_ident"}) || has({"airport_ref"})) {
    return AirfieldFile::Runways;
  }
  if (has({"latitude_deg"}) && has({"ident"}) && has({"type"})) {
    return AirfieldFile::Airports;
  }
  if (has({"lat", "latitude"}) && has({"style"})) {
    return AirfieldFile::SeeYou;
  }
  return isOwnTableHeader(header) ? AirfieldFile::OwnTable : AirfieldFile::None;
}

Result<AirfieldReport> readAlone(AirfieldFile kind, const std::string& path, const mission::SiteFilter& filter,
                                 const std::optional<geo::GeoBox>& area) {
  switch (kind) {
    case AirfieldFile::SeeYou:
      return readCup(path, filter, area);
    case AirfieldFile::AptDat:
      return readAptDat(path, filter, area);
    case AirfieldFile::OwnTable:
      return readOwnTable(path, filter, area);
    default:
      return readOwnGeoJson(path, filter, area);
  }
}

/// By the name, where the content tells nothing: its reader then says what is wrong with it.
AirfieldFile kindByName(const std::string& path) {
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  lower = lower.ends_with(".gz") ? lower.substr(0, lower.size() - 3) : lower;
  return lower.ends_with(".cup")                                   ? AirfieldFile::SeeYou
         : lower.ends_with(".dat")                                 ? AirfieldFile::AptDat
         : lower.ends_with(".json") || lower.ends_with(".geojson") ? AirfieldFile::GeoJson
                                                                   : AirfieldFile::None;
}

}  // namespace

AirfieldFile airfieldFileOf(const std::string& path) {
  constexpr std::size_t kEnough = 65536;
  const Result<std::string> start = readStart(path, kEnough);
  if (!start || start->find('\0') != std::string::npos) {
    return AirfieldFile::None;
  }
  std::string_view text = *start;
  text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '{') {
    return mentionsRunways(text) ? AirfieldFile::GeoJson : AirfieldFile::None;
  }
  return isAptDat(text) ? AirfieldFile::AptDat : kindOfTable(text);
}

Result<AirfieldReport> readAirfields(const mission::AirfieldSource& source, const std::string& folder, const mission::SiteFilter& filter,
                                     const std::optional<geo::GeoBox>& area) {
  const std::string airports = resolvePath(folder, source.airports);
  AirfieldFile kind = airfieldFileOf(airports);
  kind = kind == AirfieldFile::None ? kindByName(airports) : kind;
  if (kind == AirfieldFile::Airports || kind == AirfieldFile::Runways || (kind == AirfieldFile::None && !source.runways.empty())) {
    if (source.runways.empty() && kind == AirfieldFile::Airports) {
      return fail(Errc::BadFormat, "an OurAirports file needs its runways file too; add \"runways\": \"runways.csv\" beside it", airports);
    }
    return readOurAirports(airports, source.runways.empty() ? airports : resolvePath(folder, source.runways), filter, area);
  }
  if (const Result<std::string> start = readStart(airports, 1); !start) {
    return forward(readText(airports));
  }
  if (kind == AirfieldFile::None) {
    return fail(Errc::BadFormat,
                "this is no file of airfields that the program knows: OurAirports .csv, X-Plane apt.dat, SeeYou .cup, or a table or GeoJSON of own "
                "fields with the columns latitude, longitude and course_deg",
                airports);
  }
  if (!source.runways.empty()) {
    return fail(Errc::BadFormat,
                "only the airports file of OurAirports goes with a runways file; this one holds its runways itself, remove \"runways\"", airports);
  }
  return readAlone(kind, airports, filter, area);
}

}  // namespace vp::formats
