#include "app/cli/values.h"

#include "core/aircraft/wind_check.h"
#include "core/mission/glide_conditions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

namespace vp::cli {
namespace {

/// A number that is the whole text.
bool isNumber(const std::string& text, double& value) {
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data() + (text.starts_with('+') ? 1 : 0), end, value);
  return code == std::errc() && stop == end && std::isfinite(value);
}

/// A number and what follows it, without spaces between.
std::pair<std::string, std::string> amountAndUnit(const std::string& text) {
  const std::size_t unitAt = text.find_first_not_of("0123456789.+-");
  const std::size_t first = unitAt == std::string::npos ? unitAt : text.find_first_not_of(' ', unitAt);
  return {text.substr(0, unitAt), first == std::string::npos ? "" : text.substr(first)};
}

}  // namespace

std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text + ",");
  std::string part;
  while (std::getline(in, part, ',')) {
    const std::size_t first = part.find_first_not_of(' ');
    parts.push_back(first == std::string::npos ? "" : part.substr(first, part.find_last_not_of(' ') - first + 1));
  }
  return parts;
}

Result<std::vector<double>> numbersIn(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : partsOf(text)) {
    double value = 0.0;
    if (!isNumber(part, value)) {
      return fail(Errc::OutOfRange, fmt::format("\"{}\" is not a number", part));
    }
    numbers.push_back(value);
  }
  if (numbers.size() != count) {
    return fail(Errc::OutOfRange, fmt::format("{} numbers with commas between them are needed, not {}", count, numbers.size()));
  }
  return numbers;
}

Result<geo::LatLon> placeFrom(double latitude, double longitude, const std::string& option) {
  if (std::abs(latitude) > 90.0 || std::abs(longitude) > 180.0) {
    return fail(Errc::OutOfRange,
                fmt::format("{},{} is not on earth; give latitude,longitude in degrees, north and east positive", latitude, longitude), option);
  }
  return geo::LatLon{latitude, longitude};
}

Result<double> distanceIn(const std::string& text, const std::string& option) {
  const std::size_t unitAt = text.find_first_not_of("0123456789.+-");
  const std::string unit = unitAt == std::string::npos ? "km" : text.substr(text.find_first_not_of(' ', unitAt));
  const std::string amount = text.substr(0, unitAt);
  const double metres = unit == "km" ? 1000.0 : unit == "m" ? 1.0 : unit == "nm" || unit == "NM" ? 1852.0 : 0.0;
  double value = 0.0;
  if (metres == 0.0 || !isNumber(amount, value) || value <= 0.0) {
    return fail(Errc::OutOfRange, fmt::format("\"{}\" is no distance; give for example 30km, 20nm or 5000m", text), option);
  }
  return value * metres;
}

Result<double> altitudeIn(const std::string& text, const std::string& option) {
  const auto [amount, unit] = amountAndUnit(text);
  const double metres = unit.empty() || unit == "m" ? 1.0 : unit == "ft" ? kMetresPerFoot : unit == "km" ? 1000.0 : 0.0;
  double value = 0.0;
  if (metres == 0.0 || !isNumber(amount, value)) {
    return fail(Errc::OutOfRange, fmt::format("\"{}\" is no altitude; give for example 2400m or 8000ft, above mean sea level", text), option);
  }
  return value * metres;
}

Result<double> secondsIn(const std::string& text, const std::string& option) {
  const auto [amount, unit] = amountAndUnit(text);
  const double seconds = unit.empty() || unit == "s" ? 1.0 : unit == "ms" ? 1e-3 : 0.0;
  double value = 0.0;
  if (seconds == 0.0 || !isNumber(amount, value) || value < 0.0) {
    return fail(Errc::OutOfRange, fmt::format("\"{}\" is no time; give for example 1s or 200ms", text), option);
  }
  return value * seconds;
}

Result<void> applyWind(const std::vector<std::string>& texts, mission::Mission& mission, std::vector<std::string>& notes) {
  constexpr const char* kOption = "--wind";
  if (!texts.empty()) {
    Result<formats::WindReading> reading = formats::parseWind(fmt::format("{}", fmt::join(texts, "; ")));
    if (!reading) {
      return fail(reading.error().code, reading.error().what, kOption);
    }
    mission.wind = std::move(reading->layers);
    for (const std::string& note : reading->notes) {
      notes.push_back(fmt::format("{}: {}", kOption, note));
    }
  }
  if (const auto fault = aircraft::windFault(mission.aircraft, mission::glideConditionsOf(mission, {}))) {
    return fail(Errc::OutOfRange, fault->sentence, texts.empty() ? "" : kOption);
  }
  return {};
}

}  // namespace vp::cli
