// Landing sites from X-Plane's apt.dat.
#include "core/formats/airfield_candidates.h"
#include "core/formats/csv.h"
#include "core/formats/surface.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::formats {
namespace {

using geo::LatLon;
using mission::Surface;

constexpr std::size_t kMostRunways = 1000;  // of an airport; Chicago has 8

/// Splits a line at blanks into at most N words; the last keeps the rest of the line.
template <std::size_t N>
struct Words {
  std::array<std::string_view, N> at{};
  std::size_t count = 0;

  explicit Words(std::string_view line) {
    for (line = trimmed(line); !line.empty() && count < N; line = trimmed(line)) {
      const std::size_t end = count + 1 == N ? line.size() : std::min(line.find_first_of(" \t"), line.size());
      at[count++] = line.substr(0, end);
      line.remove_prefix(end);
    }
  }
};

/// Codes of X-Plane 12; below 20 those of version 850.
Surface surfaceOfCode(std::string_view code) {
  const std::optional<double> number = parseNumber(code);
  const int n = number && *number >= 0.0 && *number < 100.0 ? static_cast<int>(*number) : 0;
  if (n == 1 || n == 2 || (n >= 20 && n <= 38) || (n >= 50 && n <= 57)) {
    return Surface::Hard;
  }
  switch (n) {
    case 3:
      return Surface::Grass;
    case 4:
    case 12:  // dry lakebed
      return Surface::Dirt;
    case 5:
      return Surface::Gravel;
    case 13:
      return Surface::Water;
    case 14:
      return Surface::Snow;
    default:
      return Surface::Unknown;  // 15 is transparent: whatever the scenery shows
  }
}

std::optional<LatLon> placeOf(std::string_view latitude, std::string_view longitude) {
  const std::optional<double> north = parseNumber(latitude);
  const std::optional<double> east = parseNumber(longitude);
  if (!north || !east || std::fabs(*north) > 90.0 || std::fabs(*east) > 180.0) {
    return std::nullopt;
  }
  return LatLon{*north, *east};
}

/// Where the words of one end of a runway stand.
struct EndWords {
  std::size_t ident;
  std::size_t displaced;  ///< 0 = the row has none
};

class AptReader {
public:
  AptReader(std::string source, const std::optional<geo::GeoBox>& area) : near_(grownArea(area)), source_(std::move(source)) {}

  void readLine(std::string_view line, std::size_t number) {
    const std::string_view code = Words<2>(line).at[0];
    if (code == "1" || code == "16" || code == "17") {
      finishAirport();
      startAirport(line, code, number);
    } else if (code == "100") {
      readRunway<26>(line, {8, 11}, {17, 20}, 25, number);
    } else if (code == "101") {
      readRunway<9>(line, {3, 0}, {6, 0}, 9, number);
    } else if (code == "102" && inAirport_) {
      leftOut.add("helipad", ident_ + "/" + std::string(Words<3>(line).at[1]));
    } else if (code == "1302") {
      const Words<3> words(line);
      if (words.at[1] == "icao_code" && !words.at[2].empty()) {
        ident_ = words.at[2];
      }
    } else if (code == "99") {
      finishAirport();
    }
  }

  /// Puts the runways of the airport read last among the candidates: its code may stand behind them.
  void finishAirport() {
    for (auto& [runway, common] : runways_) {
      common.site.airportIdent = ident_;
      addRunway(runway, common, candidates, leftOut);
    }
    runways_.clear();
    inAirport_ = false;
  }

  std::vector<Candidate> candidates;
  LeftOut leftOut;
  std::size_t airports = 0;

private:
  void startAirport(std::string_view line, std::string_view code, std::size_t number) {
    const Words<6> words(line);
    if (words.count < 5) {
      leftOut.add("header of an airport cut short", fmt::format("line {}", number));
      return;
    }
    ident_ = words.at[4];
    name_ = words.count > 5 ? words.at[5] : std::string_view();
    isClosed_ = name_.starts_with("[X]");
    isHeliport_ = code == "17";
    const std::optional<double> feet = parseNumber(words.at[1]);
    elevation_ = feet && *feet > -1500.0 && *feet < 20000.0 ? std::optional(geo::HeightMsl::fromMetres(*feet * kMetresPerFoot)) : std::nullopt;
    inAirport_ = true;
    ++airports;
  }

  template <std::size_t N>
  void readRunway(std::string_view line, EndWords low, EndWords high, std::size_t least, std::size_t number) {
    const Words<N> words(line);
    const std::string where = fmt::format("{} in line {}", inAirport_ ? ident_ : std::string("?"), number);
    if (!inAirport_ || words.count < least) {
      leftOut.add(inAirport_ ? "row of a runway cut short" : "runway outside an airport", where);
      return;
    }
    RunwayGeometry runway;
    Candidate common;
    for (const auto& [end, at] : {std::pair(&runway.low, low), std::pair(&runway.high, high)}) {
      end->ident = words.at[at.ident];
      end->place = placeOf(words.at[at.ident + 1], words.at[at.ident + 2]);
      const std::optional<double> displaced = at.displaced > 0 ? parseNumber(words.at[at.displaced]) : std::optional(0.0);
      if (!end->place || !displaced || *displaced < 0.0 || *displaced > 15000.0) {
        leftOut.add("a value of the runway makes no sense", where);
        return;
      }
      end->displaced = Length::fromSi(*displaced);
    }
    if (near_ && !near_->contains(*runway.low.place)) {
      return;
    }
    const std::optional<double> width = parseNumber(words.at[1]);
    common.runway = count_++;
    common.closed = isClosed_;
    common.site.airportName = name_;
    common.site.source = source_;
    common.site.width = width && *width > 0.0 && *width < 1000.0 ? std::optional(Length::fromSi(*width)) : std::nullopt;
    common.site.surface = N == 9 ? Surface::Water : surfaceOfCode(words.at[2]);
    common.site.lighted = N != 9 && words.at[6] != "0";
    runway.centre = *runway.low.place;
    runway.elevation = elevation_;
    if (isHeliport_) {
      leftOut.add("runway of a heliport", where);
      return;
    }
    if (runways_.size() >= kMostRunways) {
      leftOut.add("more runways than an airport has", where);
      return;
    }
    runways_.emplace_back(std::move(runway), std::move(common));
  }

  std::optional<geo::GeoBox> near_;
  std::string source_;
  std::string ident_;
  std::string name_;
  std::optional<geo::HeightMsl> elevation_;
  bool isClosed_ = false;
  bool isHeliport_ = false;
  bool inAirport_ = false;
  int count_ = 0;
  std::vector<std::pair<RunwayGeometry, Candidate>> runways_;
};

/// The next line, without its end; the text that is left begins behind it.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const bool isPair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
  text.remove_prefix(std::min(text.size(), end + (isPair ? 2 : 1)));
  return line;
}

}  // namespace

Result<AirfieldReport> readAptDat(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area) {
  const Result<std::string> text = readText(path, kMostFileBytes);  // the world's is the largest text there is
  if (!text) {
    return forward(text);
  }
  std::string_view rest = *text;
  const std::string_view origin = trimmed(takeLine(rest));
  const std::string_view versionLine = takeLine(rest);
  const std::optional<double> version = parseNumber(Words<2>(versionLine).at[0]);
  if ((origin != "I" && origin != "A") || !version) {
    return fail(Errc::BadFormat, "this is no apt.dat: it begins with I or A, and its second line with the version, for example \"1100 Version\"",
                path + ", line 1");
  }
  if (*version < 850.0 || *version > 1299.0) {
    return fail(Errc::BadFormat, fmt::format("version {:.0f} of apt.dat is not read; 850 to 1299 are", *version), path + ", line 2");
  }
  AptReader reader(fileName(path), area);
  for (std::size_t number = 3; !rest.empty(); ++number) {
    reader.readLine(takeLine(rest), number);
  }
  reader.finishAirport();
  if (reader.airports == 0) {
    return fail(Errc::BadFormat, "there is no airport in this apt.dat; the file may be cut short", path);
  }
  return applyFilter(std::move(reader.candidates), filter, area, std::move(reader.leftOut));
}

}  // namespace vp::formats
