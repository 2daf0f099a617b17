// Where an airfield is, by its code.
#include "core/fetch/airfield_fetch.h"
#include "core/formats/airfields.h"
#include "core/formats/csv.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>

namespace vp::fetch {
namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

tl::unexpected<Error> unknown(const std::string& file, const std::string& code) {
  return fail(Errc::OutOfRange, fmt::format("there is no airfield \"{}\"; check the code, or give latitude,longitude instead", code), file);
}

std::optional<double> numberIn(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

Result<geo::LatLon> placeInCup(const std::string& file, const std::string& code) {
  const Result<formats::AirfieldReport> report = formats::readCup(file, {}, std::nullopt);
  if (!report) {
    return forward(report);
  }
  for (const mission::LandingSite& site : report->sites) {
    if (upper(site.airportIdent) == upper(code)) {
      return site.touchdown;
    }
  }
  return unknown(file, code);
}

}  // namespace

Result<geo::LatLon> placeOfAirfield(const std::string& file, const std::string& code) {
  const std::string wanted = upper(formats::trimmed(code));
  if (wanted.empty()) {
    return unknown(file, code);
  }
  if (upper(std::filesystem::path(file).extension().string()) == ".CUP") {
    return placeInCup(file, code);
  }
  const Result<std::string> text = formats::readText(file);
  if (!text) {
    return forward(text);
  }
  formats::CsvReader reader(*text, file, formats::CsvQuotes::Strict);
  formats::CsvRecord record;
  Result<bool> more = reader.next(record);
  if (!more) {
    return forward(more);
  }
  formats::CsvColumns columns(file, record);
  const int latitude = columns.require("latitude_deg");
  const int longitude = columns.require("longitude_deg");
  const std::array<int, 5> codes{columns.require("ident"), columns.find({"icao_code"}), columns.find({"gps_code"}), columns.find({"iata_code"}),
                                 columns.find({"local_code"})};
  if (!columns.missing().empty()) {
    return fail(Errc::BadFormat, fmt::format("the header has no column \"{}\"; name airports.csv of OurAirports or a .cup file", columns.missing()),
                file);
  }
  std::size_t best = codes.size();
  geo::LatLon place;
  for (more = reader.next(record); more && *more && best > 0; more = reader.next(record)) {
    for (std::size_t rank = 0; rank < best; ++rank) {
      const std::optional<double> north = numberIn(formats::fieldOf(record, latitude));
      const std::optional<double> east = numberIn(formats::fieldOf(record, longitude));
      if (codes[rank] >= 0 && north && east && upper(formats::fieldOf(record, codes[rank])) == wanted) {
        best = rank;
        place = {*north, *east};
      }
    }
  }
  if (!more) {
    return forward(more);
  }
  return best < codes.size() ? Result<geo::LatLon>(place) : unknown(file, code);
}

}  // namespace vp::fetch
