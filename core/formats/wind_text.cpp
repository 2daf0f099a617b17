// Wind as text: layers, and the way back.
#include "core/formats/wind_text.h"

#include "core/aircraft/wind_check.h"
#include "core/base/expect.h"
#include "core/formats/wind_group.h"
#include "core/formats/wind_reports.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace vp::formats {
namespace {

constexpr double kHundreds = 100.0;  // ft that an altitude without a unit is a whole number of

struct Altitude {
  geo::HeightMsl height;
  bool isFlightLevel = false;
};

/// One layer of a text and where it begins there.
struct ReadLayer {
  std::size_t at = 0;
  std::optional<Altitude> altitude;
  air::WindSector wind;
};

Altitude inFeet(double feet) {
  return {geo::HeightMsl::fromMetres(feet * kMetresPerFoot)};
}

/// An altitude without a unit: a number with a wind behind it.
Result<std::optional<Altitude>> bareAltitude(WindScanner& scanner, std::size_t start, double number) {
  const std::size_t behind = scanner.at();
  scanner.skipSpaces();
  const char next = scanner.peek();
  const bool isAltitude = scanner.at() > behind && ((next >= '0' && next <= '9') || next == 'V' || next == 'C');
  if (!isAltitude) {
    scanner.moveTo(start);
    return std::optional<Altitude>();
  }
  if (std::fmod(number, kHundreds) != 0.0) {
    return scanner.fault(Errc::BadFormat, start, "a wind, or an altitude in whole hundreds of feet or with its unit, ft or m, is expected");
  }
  return inFeet(number);
}

/// The altitude that a layer begins with, if it has one.
Result<std::optional<Altitude>> readAltitude(WindScanner& scanner) {
  const std::size_t start = scanner.at();
  if (scanner.take("FL")) {
    const std::string_view digits = scanner.takeDigits();
    if (digits.size() < 2 || digits.size() > 3) {
      return scanner.fault(Errc::BadFormat, start, "a flight level of two or three digits is expected, such as FL095");
    }
    Altitude level = inFeet(kHundreds * std::stod(std::string(digits)));
    level.isFlightLevel = true;
    return level;
  }
  const bool isNegative = scanner.take("-");
  const std::optional<double> number = scanner.takeNumber();
  const std::size_t behind = scanner.at();
  if (number) {
    scanner.skipSpaces();
    const std::string unit = scanner.takeLetters();
    const double value = isNegative ? -*number : *number;
    if (unit == "FT" || unit == "FEET") {
      return inFeet(value);
    }
    if (unit == "M") {
      return Altitude{geo::HeightMsl::fromMetres(value)};
    }
  }
  if (isNegative || !number) {
    scanner.moveTo(start);
    return std::optional<Altitude>();
  }
  scanner.moveTo(behind);
  return bareAltitude(scanner, start, *number);
}

Result<ReadLayer> readLayer(WindScanner& scanner) {
  ReadLayer layer;
  layer.at = scanner.at();
  const Result<std::optional<Altitude>> altitude = readAltitude(scanner);
  if (!altitude) {
    return forward(altitude);
  }
  layer.altitude = *altitude;
  if (layer.altitude) {
    scanner.skipSpaces();
    if (scanner.take("MSL") || scanner.take("AMSL")) {
      scanner.skipSpaces();
    }
    scanner.take(":");
    scanner.skipSpaces();
  }
  const Result<air::WindSector> wind = readWind(scanner);
  if (!wind) {
    return forward(wind);
  }
  layer.wind = *wind;
  scanner.skipSpaces();
  if (!scanner.atEnd() && scanner.peek() != ';' && scanner.peek() != '\n') {
    return scanner.fault("the wind should end here, or a semicolon and the next layer follow");
  }
  return layer;
}

void skipSeparators(WindScanner& scanner) {
  for (scanner.skipSpaces(); scanner.take(";") || scanner.take("\n"); scanner.skipSpaces()) {
  }
}

Result<WindReading> joinLayers(const WindScanner& scanner, const std::vector<ReadLayer>& layers) {
  WindReading reading;
  if (layers.size() == 1 && !layers[0].altitude) {
    if (!(layers[0].wind == air::WindSector{})) {
      reading.layers = {{geo::HeightMsl(), layers[0].wind}};
    }
    return reading;
  }
  bool hasFlightLevel = false;
  for (const ReadLayer& layer : layers) {
    if (!layer.altitude) {
      return scanner.fault(Errc::BadFormat, layer.at, "with several layers each needs its altitude, such as 5000ft 290/25kt");
    }
    hasFlightLevel = hasFlightLevel || layer.altitude->isFlightLevel;
    reading.layers.push_back({layer.altitude->height, layer.wind});
  }
  if (const auto fault = aircraft::windFault(reading.layers)) {
    return scanner.fault(Errc::OutOfRange, layers[fault->layer].at, fault->sentence);
  }
  if (hasFlightLevel) {
    reading.notes.emplace_back("flight levels are taken as heights above mean sea level");
  }
  return reading;
}

/// The shortest decimal without an exponent that reads back as this.
std::string decimal(double value) {
  std::array<char, 512> digits{};
  const auto [end, code] = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  VP_EXPECT(code == std::errc());
  return {digits.data(), end};
}

/// A decimal with few digits that times the unit gives exactly the value; nothing if there is none.
template <typename ToSi>
std::optional<std::string> shortDecimal(double value, double guess, const ToSi& toSi) {
  for (int digits = 0; digits <= 4; ++digits) {
    const std::string text = fmt::format("{:.{}f}", guess, digits);
    double number = 0.0;  // not by std::stod: where the locale has a decimal comma it stops at the point
    std::from_chars(text.data(), text.data() + text.size(), number);
    if (toSi(number) == value) {
      return text;
    }
  }
  return std::nullopt;
}

const char* nameOf(WindUnits::Speed unit) {
  return unit == WindUnits::Speed::Knots ? "kt" : unit == WindUnits::Speed::MetresPerSecond ? "mps" : "km/h";
}

double inUnit(double speed, WindUnits::Speed unit) {
  return speed / windSpeed(1.0, unit);
}

std::string speedText(const air::WindSector& wind, WindUnits::Speed unit, bool always) {
  const auto text = [unit](double speed) {
    return shortDecimal(speed, inUnit(speed, unit), [unit](double number) { return windSpeed(number, unit); });
  };
  std::optional<std::string> least = text(std::abs(wind.leastSpeed));  // a negative zero is zero
  std::optional<std::string> most = text(std::abs(wind.mostSpeed));
  if (!least || !most) {
    least = decimal(std::abs(wind.leastSpeed));
    most = decimal(std::abs(wind.mostSpeed));
    unit = WindUnits::Speed::MetresPerSecond;
  }
  return (always || wind.leastSpeed != wind.mostSpeed ? *least + "-" : "") + *most + nameOf(unit);
}

std::string sectorText(const air::WindSector& wind, WindUnits units) {
  if (wind == air::WindSector{}) {
    return "calm";
  }
  if (wind.from_deg == 0.0 && wind.spread_deg == 180.0) {
    return "VRB/" + speedText(wind, units.speed, true);
  }
  std::string direction = decimal(std::abs(wind.from_deg));
  direction.insert(0, 3 - std::min<std::size_t>(3, direction.substr(0, direction.find('.')).size()), '0');
  const std::string spread = wind.spread_deg != 0.0 ? "\xC2\xB1" + decimal(wind.spread_deg) : "";
  return direction + spread + "/" + speedText(wind, units.speed, false);
}

std::string altitudeText(geo::HeightMsl altitude, WindUnits::Height unit) {
  if (unit == WindUnits::Height::Feet) {
    if (const auto feet = shortDecimal(altitude.metres(), altitude.feet(), [](double number) { return number * kMetresPerFoot; })) {
      return *feet + "ft";
    }
  }
  return decimal(altitude.metres()) + "m";
}

std::string speedWords(const air::WindSector& wind, WindUnits::Speed unit) {
  const auto rounded = [unit](double speed) { return decimal(std::round(inUnit(speed, unit) * 10.0) / 10.0); };
  const std::string least = rounded(wind.leastSpeed);
  const std::string most = rounded(wind.mostSpeed);
  return (least == most ? "" : least + " to ") + most + " " + (unit == WindUnits::Speed::MetresPerSecond ? "m/s" : nameOf(unit));
}

std::string sectorWords(const air::WindSector& wind, WindUnits units) {
  if (wind.isCalm()) {
    return "calm";
  }
  const std::string speed = speedWords(wind, units.speed) + " from ";
  if (wind.spread_deg >= 180.0) {
    return speed + "any direction";
  }
  const auto degrees = [](double value) {
    const double around = std::fmod(value + 360.0, 360.0);
    return fmt::format("{:03.0f}", around == 0.0 ? 360.0 : around);
  };
  if (wind.spread_deg == 0.0) {
    return speed + degrees(std::round(wind.from_deg)) + " degrees";
  }
  return speed + degrees(std::floor(wind.from_deg - wind.spread_deg)) + " to " + degrees(std::ceil(wind.from_deg + wind.spread_deg)) + " degrees";
}

}  // namespace

Result<WindReading> parseWind(std::string_view text) {
  if (isWeatherReport(text)) {
    return readWeatherReport(text);
  }
  if (isWindsAloft(text)) {
    return readWindsAloft(text);
  }
  WindScanner scanner(text);
  skipSeparators(scanner);
  if (scanner.atEnd()) {
    return fail(Errc::BadFormat, "the wind is empty; write for example 270/15kt, 27015G25KT, 0ft 270/15kt; 5000ft 290/25kt, or calm");
  }
  std::vector<ReadLayer> layers;
  for (; !scanner.atEnd(); skipSeparators(scanner)) {
    Result<ReadLayer> layer = readLayer(scanner);
    if (!layer) {
      return forward(layer);
    }
    layers.push_back(*layer);
  }
  return joinLayers(scanner, layers);
}

std::string windText(const std::vector<air::WindLayer>& layers, WindUnits units) {
  if (layers.empty()) {
    return "calm";
  }
  if (layers.size() == 1 && layers[0].altitude == geo::HeightMsl() && !(layers[0].wind == air::WindSector{})) {
    return sectorText(layers[0].wind, units);
  }
  std::string text;
  for (const air::WindLayer& layer : layers) {
    text += (text.empty() ? "" : "; ") + altitudeText(layer.altitude, units.height) + " " + sectorText(layer.wind, units);
  }
  return text;
}

std::vector<std::string> windWords(const std::vector<air::WindLayer>& layers, WindUnits units) {
  if (layers.empty()) {
    return {"still air"};
  }
  if (layers.size() == 1) {
    return {sectorWords(layers[0].wind, units) + " at every height"};
  }
  std::vector<std::string> lines;
  for (const air::WindLayer& layer : layers) {
    const bool isFeet = units.height == WindUnits::Height::Feet;
    lines.push_back(
        fmt::format("{:.0f} {}: {}", isFeet ? layer.altitude.feet() : layer.altitude.metres(), isFeet ? "ft" : "m", sectorWords(layer.wind, units)));
  }
  return lines;
}

std::string airPhrase(const std::vector<air::WindLayer>& layers, WindUnits units) {
  if (std::all_of(layers.begin(), layers.end(), [](const air::WindLayer& layer) { return layer.wind.isCalm(); })) {
    return "calm air";
  }
  if (layers.size() == 1) {
    const air::WindSector& wind = layers.front().wind;
    const bool isOne = wind.spread_deg == 0.0 && wind.leastSpeed == wind.mostSpeed;
    return fmt::format("{} of {}{}", isOne ? "a wind" : "every wind", sectorWords(wind, units), wind.spread_deg < 180.0 ? " true" : "");
  }
  return fmt::format("every wind between the layers of the forecast ({}; true)", fmt::join(windWords(layers, units), "; "));
}

}  // namespace vp::formats
