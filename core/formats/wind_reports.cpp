// Winds out of weather reports and forecasts.
#include "core/formats/wind_reports.h"

#include "core/aircraft/wind_check.h"
#include "core/base/plain_text.h"
#include "core/formats/wind_group.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace vp::formats {
namespace {

constexpr double kLightAndVariable = 5.0;    // kt, 9900 stands for less
constexpr double kPressureAltitude = 18000;  // ft, winds aloft are given on flight levels from there on
constexpr double kFastGroup = 100.0;         // kt that 50 added to the direction stands for

struct Token {
  std::string text;      ///< in upper case
  std::size_t at = 0;    ///< in the whole text
  std::size_t line = 0;  ///< from 0
  std::size_t columnEnd = 0;
};

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ';';
}

bool isDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool isLetter(char c) {
  return c >= 'A' && c <= 'Z';
}

/// Words; lines end at line ends and semicolons.
std::vector<Token> tokensOf(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t line = 0;
  std::size_t lineStart = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (isSpace(text[i])) {
      if (text[i] == '\n' || text[i] == ';') {
        ++line;
        lineStart = i + 1;
      }
      ++i;
      continue;
    }
    Token token{"", i, line, 0};
    for (; i < text.size() && !isSpace(text[i]); ++i) {
      token.text += static_cast<char>(std::toupper(static_cast<unsigned char>(text[i])));
    }
    token.columnEnd = i - lineStart;
    tokens.push_back(std::move(token));
  }
  return tokens;
}

tl::unexpected<Error> faultAt(std::string_view text, std::size_t at, Errc code, const std::string& expected) {
  return WindScanner(text).fault(code, at, expected);
}

bool isStation(const std::string& word) {
  return word.size() == 4 && isLetter(word[0]) && std::all_of(word.begin(), word.end(), [](char c) { return isLetter(c) || (c >= '0' && c <= '9'); });
}

bool isTime(const std::string& word) {
  return word.size() == 7 && word.back() == 'Z' && isDigits(word.substr(0, 6));
}

bool isReportName(const std::string& word) {
  return word == "METAR" || word == "SPECI";
}

/// The words from one on, without the sign that ends a report.
std::string joined(const std::vector<Token>& tokens, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < tokens.size(); ++i) {
    text += (text.empty() ? "" : " ") + tokens[i].text;
  }
  return text.ends_with('=') ? text.substr(0, text.size() - 1) : text;
}

/// Winds of trends and remarks among the ignored words.
std::vector<std::string> otherWinds(const std::vector<Token>& tokens, std::size_t first) {
  std::vector<std::string> winds;
  for (std::size_t i = first; i < tokens.size(); ++i) {
    const std::string word = tokens[i].text.substr(0, tokens[i].text.find('='));
    WindScanner scanner(word);
    if (word.size() > 5 && readWind(scanner, true) && scanner.atEnd()) {
      winds.push_back(word);
    } else if (word == "WND" && i + 1 < tokens.size()) {
      winds.push_back("peak wind " + tokens[i + 1].text);
    }
  }
  return winds;
}

/// The token that the wind of a report should be: behind its name, place and time.
std::size_t windToken(const std::vector<Token>& tokens) {
  std::size_t next = 0;
  const auto skip = [&](const auto& matches) { next += next < tokens.size() && matches(tokens[next].text) ? 1 : 0; };
  const auto isMark = [](const std::string& word) { return word == "COR" || word == "AUTO"; };
  skip(isReportName);
  skip(isMark);
  if (next + 1 < tokens.size() && isStation(tokens[next].text) && isTime(tokens[next + 1].text)) {
    next += 2;
  }
  skip(isMark);
  skip(isMark);
  return next;
}

constexpr std::size_t kLongestQuote = 300;  // bytes

std::vector<std::string> reportNotes(const std::vector<Token>& tokens, std::size_t ignored) {
  std::vector<std::string> notes{"the wind of the report is measured near the ground and is taken for all heights"};
  if (const std::string rest = joined(tokens, ignored); !rest.empty()) {
    notes.push_back("ignored: " + plainText(rest, kLongestQuote));
  }
  if (const std::vector<std::string> others = otherWinds(tokens, ignored); !others.empty()) {
    notes.push_back("other winds of the report are not taken: " + plainText(fmt::format("{}", fmt::join(others, ", ")), kLongestQuote));
  }
  return notes;
}

/// The altitudes of a winds-aloft forecast, and where its station stands among the tokens.
struct AloftHeader {
  std::vector<Token> altitudes;
  std::size_t first = 0;  ///< token, FT itself
  std::size_t next = 0;
};

std::optional<std::size_t> findAloftHeader(const std::vector<Token>& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool beginsLine = i == 0 || tokens[i - 1].line != tokens[i].line;
    if (beginsLine && tokens[i].text == "FT" && tokens[i + 1].line == tokens[i].line && isDigits(tokens[i + 1].text)) {
      return i;
    }
  }
  return std::nullopt;
}

/// ddff, ddfftt or ddff+tt. @param hasTemperature  set where there is one
Result<air::WindSector> readAloftGroup(std::string_view text, const Token& group, bool& hasTemperature) {
  const std::string digits = group.text.substr(0, group.text.find_first_of("+-"));
  const std::string rest = group.text.substr(digits.size());
  const bool fits =
      isDigits(digits) && (digits.size() == 4 ? rest.empty() || (rest.size() == 3 && isDigits(rest.substr(1))) : digits.size() == 6 && rest.empty());
  if (!fits) {
    return faultAt(text, group.at, Errc::BadFormat, "a wind of a winds-aloft forecast is expected, such as 2715, 2725+00 or 283045");
  }
  hasTemperature = hasTemperature || digits.size() == 6 || !rest.empty();
  int tens = std::stoi(digits.substr(0, 2));
  double speed = std::stoi(digits.substr(2, 2));
  if (tens == 99 && speed == 0.0) {
    return air::WindSector{0.0, 180.0, 0.0, windSpeed(kLightAndVariable, WindUnits::Speed::Knots)};
  }
  if (tens > 50) {
    tens -= 50;
    speed += kFastGroup;
  }
  if (tens < 1 || tens > 36) {
    return faultAt(text, group.at, Errc::OutOfRange, "the first two digits are a direction in tens of degrees: 01 to 36, or 51 to 86 from 100 kt on");
  }
  if (speed >= 2.0 * kFastGroup - 1.0) {
    return faultAt(text, group.at, Errc::OutOfRange, "this stands for 199 kt or more, and a wind without an upper limit cannot be planned for");
  }
  const double knots = windSpeed(speed, WindUnits::Speed::Knots);
  return air::WindSector{10.0 * tens, 0.0, knots, knots};
}

/// The altitude of each group: in turn where there are as many, else by the columns.
Result<std::vector<Token>> altitudesOf(std::string_view text, const AloftHeader& header, const std::vector<Token>& groups) {
  if (groups.size() == header.altitudes.size()) {
    return header.altitudes;
  }
  const auto mismatch = [&] {
    return faultAt(text, groups.front().at, Errc::BadFormat,
                   fmt::format("{} winds for {} altitudes; take out the altitudes that have none, or keep each wind below its altitude",
                               groups.size(), header.altitudes.size()));
  };
  std::vector<Token> altitudes;
  for (const Token& group : groups) {
    // a wind ends, with its temperature, where the name of its altitude ends
    const auto above =
        std::find_if(header.altitudes.begin(), header.altitudes.end(), [&](const Token& altitude) { return altitude.columnEnd == group.columnEnd; });
    if (above == header.altitudes.end()) {
      return mismatch();
    }
    altitudes.push_back(*above);
  }
  return altitudes;
}

/// Station and its groups: the words of one line, or those behind the altitudes on theirs.
Result<std::vector<Token>> stationGroups(std::string_view text, const std::vector<Token>& tokens, const AloftHeader& header) {
  if (header.next >= tokens.size() || !isLetter(tokens[header.next].text[0])) {
    return faultAt(text, header.next < tokens.size() ? tokens[header.next].at : text.size(), Errc::BadFormat,
                   "a station and its winds are expected after the altitudes, such as BRL 2715 2725+00");
  }
  std::vector<Token> groups(tokens.begin() + static_cast<std::ptrdiff_t>(header.next) + 1, tokens.end());
  for (const Token& group : groups) {
    if (isLetter(group.text[0])) {
      return faultAt(text, group.at, Errc::BadFormat, "the winds of one station are expected; take out the others");
    }
  }
  if (groups.empty()) {
    return faultAt(text, text.size(), Errc::BadFormat, "the winds of the station are expected, such as 2715 2725+00");
  }
  return groups;
}

std::vector<std::string> aloftNotes(const std::vector<Token>& tokens, const AloftHeader& header, const std::vector<Token>& altitudes,
                                    bool temperatures) {
  std::vector<std::string> notes;
  if (header.first > 0) {
    notes.emplace_back("what stands before the altitudes is ignored: check that the forecast is valid for the flight");
  }
  if (temperatures) {
    notes.emplace_back("temperatures are ignored");
  }
  notes.push_back(
      fmt::format("station {}: below {} ft its lowest wind is taken", plainText(tokens[header.next].text, kLongestQuote), altitudes.front().text));
  if (std::stod(altitudes.back().text) >= kPressureAltitude) {
    notes.emplace_back("altitudes from 18000 ft up are flight levels and are taken as heights above mean sea level");
  }
  return notes;
}

}  // namespace

bool isWeatherReport(std::string_view text) {
  const std::vector<Token> tokens = tokensOf(text);
  return !tokens.empty() && (isReportName(tokens[0].text) || (tokens.size() > 1 && isStation(tokens[0].text) && isTime(tokens[1].text)));
}

Result<WindReading> readWeatherReport(std::string_view text) {
  const std::vector<Token> tokens = tokensOf(text);
  std::size_t next = windToken(tokens);
  if (next >= tokens.size()) {
    return faultAt(text, text.size(), Errc::BadFormat, "the wind of the report is expected here, such as 27015KT");
  }
  const auto endOf = [&](std::size_t i) { return tokens[i].at + tokens[i].text.size(); };
  const std::size_t last = std::min(next + 1, tokens.size() - 1);  // may be the range of directions
  WindScanner scanner(text.substr(0, endOf(last)), tokens[next].at);
  const Result<air::WindSector> wind = readWind(scanner, true);
  if (!wind) {
    return forward(wind);
  }
  scanner.take("=");
  if (scanner.at() != endOf(next) && scanner.at() != endOf(last)) {
    return faultAt(text, scanner.at(), Errc::BadFormat, "the wind should end here");
  }
  next = scanner.at() == endOf(next) ? next + 1 : last + 1;
  const auto second =
      std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(next), tokens.end(), [](const Token& token) { return isReportName(token.text); });
  if (second != tokens.end()) {
    return faultAt(text, second->at, Errc::BadFormat, "one report is expected; take out the others");
  }
  WindReading reading;
  if (!(*wind == air::WindSector{})) {
    reading.layers = {{geo::HeightMsl(), *wind}};
  }
  reading.notes = reportNotes(tokens, next);
  return reading;
}

bool isWindsAloft(std::string_view text) {
  return findAloftHeader(tokensOf(text)).has_value();
}

Result<WindReading> readWindsAloft(std::string_view text) {
  const std::vector<Token> tokens = tokensOf(text);
  AloftHeader header;
  header.first = findAloftHeader(tokens).value_or(0);
  for (header.next = header.first + 1; header.next < tokens.size() && isDigits(tokens[header.next].text); ++header.next) {
    const Token& altitude = tokens[header.next];
    if (altitude.line != tokens[header.first].line || altitude.text.size() > 5 || !altitude.text.ends_with("00")) {
      return faultAt(text, altitude.at, Errc::BadFormat, "an altitude in whole hundreds of feet, or the station behind the altitudes, is expected");
    }
    header.altitudes.push_back(altitude);
  }
  const Result<std::vector<Token>> groups = stationGroups(text, tokens, header);
  if (!groups) {
    return forward(groups);
  }
  const Result<std::vector<Token>> altitudes = altitudesOf(text, header, *groups);
  if (!altitudes) {
    return forward(altitudes);
  }
  WindReading reading;
  bool temperatures = false;
  for (std::size_t i = 0; i < groups->size(); ++i) {
    const Result<air::WindSector> wind = readAloftGroup(text, (*groups)[i], temperatures);
    if (!wind) {
      return forward(wind);
    }
    reading.layers.push_back({geo::HeightMsl::fromMetres(std::stod((*altitudes)[i].text) * kMetresPerFoot), *wind});
  }
  if (const auto fault = aircraft::windFault(reading.layers)) {
    return faultAt(text, (*altitudes)[fault->layer].at, Errc::OutOfRange, fault->sentence);
  }
  reading.notes = aloftNotes(tokens, header, *altitudes, temperatures);
  return reading;
}

}  // namespace vp::formats
