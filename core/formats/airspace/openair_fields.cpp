#include "core/formats/airspace/openair_fields.h"

#include "core/base/quantity.h"
#include "core/formats/airfield_candidates.h"
#include "core/formats/csv.h"

#include <algorithm>
#include <cmath>

namespace vp::formats {
namespace {

using mission::AirspaceLimit;
using Kind = mission::AirspaceLimit::Kind;

constexpr double kMostFeet = 200000.0;  // more is a slip of the pen, above all that flies by wings

std::string upper(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return out;
}

/// Degrees of "DD:MM:SS", "DD:MM.mmm" or "DD.ddd"; nothing if a part is none.
std::optional<double> degreesOf(std::string_view text) {
  double value = 0.0;
  double unit = 1.0;
  text = trimmed(text);
  for (int part = 0; part < 3; ++part) {
    const std::size_t colon = text.find(':');
    const std::optional<double> number = parseNumber(trimmed(text.substr(0, std::min(colon, text.size()))));
    if (!number || *number < 0.0 || (part > 0 && *number > 60.0)) {
      return std::nullopt;
    }
    value += *number / unit;
    unit *= 60.0;
    if (colon == std::string_view::npos) {
      return value;
    }
    text.remove_prefix(colon + 1);
  }
  return std::nullopt;
}

/// "4,500 FT" is 4500 feet, not 4.
std::string withoutThousandsCommas(std::string text) {
  const auto isDigit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == ',' && isDigit(i - 1) && isDigit(i + 1) && isDigit(i + 2) && isDigit(i + 3) && !isDigit(i + 4)) {
      text.erase(i, 1);
    }
  }
  return text;
}

bool has(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

OpenAirLine::OpenAirLine(std::string_view line) {
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  code = upper(line.substr(0, end));
  value = trimmed(line.substr(end));
}

std::optional<geo::LatLon> parseOpenAirPlace(std::string_view text) {
  const std::size_t north = text.find_first_of("NSns");
  const std::size_t east = text.find_first_of("EWew", north == std::string_view::npos ? 0 : north);
  if (north == std::string_view::npos || east == std::string_view::npos || !trimmed(text.substr(east + 1)).empty()) {
    return std::nullopt;
  }
  std::string_view second = trimmed(text.substr(north + 1, east - north - 1));
  second.remove_prefix(second.starts_with(',') ? 1 : 0);
  const std::optional<double> latitude = degreesOf(text.substr(0, north));
  const std::optional<double> longitude = degreesOf(second);
  if (!latitude || !longitude || *latitude > 90.0 || *longitude > 180.0) {
    return std::nullopt;
  }
  return geo::LatLon{text[north] == 'N' || text[north] == 'n' ? *latitude : -*latitude,
                     text[east] == 'E' || text[east] == 'e' ? *longitude : -*longitude};
}

AirspaceLimit parseOpenAirLimit(std::string_view text, bool isFloor) {
  const std::string words = withoutThousandsCommas(upper(trimmed(text)));
  const std::size_t digit = words.find_first_of("0123456789");
  if (digit == std::string::npos) {
    const bool isGround = has(words, "SFC") || has(words, "GND") || has(words, "GROUND") || has(words, "SURFACE");
    const bool isUnlimited = has(words, "UNL");
    return {isGround ? Kind::Surface : isUnlimited && !isFloor ? Kind::Unlimited : Kind::Unknown, 0.0};
  }
  const std::size_t end = std::min(words.find_first_not_of("0123456789.", digit), words.size());
  const bool isNegative = digit > 0 && words[digit - 1] == '-';
  const std::size_t begin = isNegative ? digit - 1 : digit;
  const std::optional<double> number = parseNumber(std::string_view(words).substr(begin, end - begin));
  const bool goesOn = end < words.size() && (words[end] == ',' || words[end] == '\'' || words[end] == 'E');  // "1E5", "4'500"
  if (!number || goesOn || std::abs(*number) > kMostFeet || has(words, "UNL")) {
    return {has(words, "UNL") && !isFloor ? Kind::Unlimited : Kind::Unknown, 0.0};
  }
  if (has(words, "FL") || has(words, "STD")) {
    const double feet = has(words, "FL") ? *number * 100.0 : *number;
    return feet >= 0.0 && feet <= kMostFeet ? AirspaceLimit{Kind::FlightLevel, feet * kMetresPerFoot} : AirspaceLimit{Kind::Unknown, 0.0};
  }
  const std::string_view unit = trimmed(std::string_view(words).substr(end));
  const bool isMetres = unit.starts_with("M") && !unit.starts_with("MSL");
  const double metres = *number * (isMetres ? 1.0 : kMetresPerFoot);
  if (std::abs(metres) > kMostFeet * kMetresPerFoot) {
    return {Kind::Unknown, 0.0};
  }
  const bool isAboveGround = has(words, "AGL") || has(words, "GND") || has(words, "SFC");
  if (isAboveGround && metres <= 0.0) {
    return {Kind::Surface, 0.0};
  }
  return {isAboveGround ? Kind::AboveGround : Kind::Msl, metres};
}

std::vector<std::string_view> splitAtCommas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    parts.push_back(trimmed(text.substr(0, std::min(comma, text.size()))));
    if (comma == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(comma + 1);
  }
}

}  // namespace vp::formats
