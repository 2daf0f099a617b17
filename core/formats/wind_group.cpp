// One wind as pilots and weather services write it.
#include "core/formats/wind_group.h"

#include "core/aircraft/wind_check.h"
#include "core/formats/json_value.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace vp::formats {
namespace {

constexpr const char* kWind = "a wind such as 270/15kt, 27015G25KT, 270+-20/10-20kt, VRB05KT or calm is expected";
constexpr const char* kUnits = "kt, mps or km/h";

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isLetter(char c) {
  return c >= 'A' && c <= 'Z';
}

double valueOf(std::string_view digits) {
  double value = 0.0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

/// Speeds of one wind, in its unit.
struct Speeds {
  double least = 0.0;
  double most = 0.0;
  std::size_t at = 0;
};

/// The unit that is next, or nothing; other letters are a fault.
Result<std::optional<WindUnits::Speed>> takeUnit(WindScanner& scanner) {
  const std::size_t before = scanner.at();
  scanner.skipSpaces();
  const std::size_t at = scanner.at();
  std::string word = scanner.takeLetters();
  if (word == "M" && scanner.take("/S")) {
    word = "MPS";
  } else if (word == "KM" && scanner.take("/H")) {
    word = "KMH";
  }
  if (word == "KT" || word == "KTS" || word == "KN") {
    return WindUnits::Speed::Knots;
  }
  if (word == "MPS") {
    return WindUnits::Speed::MetresPerSecond;
  }
  if (word == "KMH" || word == "KPH") {
    return WindUnits::Speed::KilometresPerHour;
  }
  if (!word.empty()) {
    return scanner.fault(Errc::BadFormat, at, fmt::format("{} is no unit of speed here; {} is expected", quoteJson(word), kUnits));
  }
  scanner.moveTo(before);
  return std::optional<WindUnits::Speed>();
}

/// Unit and limits; what both notations end with.
Result<air::WindSector> finished(WindScanner& scanner, air::WindSector wind, const Speeds& speeds, bool needsUnit) {
  const Result<std::optional<WindUnits::Speed>> unit = takeUnit(scanner);
  if (!unit) {
    return forward(unit);
  }
  if (needsUnit && !*unit) {
    return scanner.fault(fmt::format("the unit of the speed is expected, {}", kUnits));
  }
  if (isDigit(scanner.peek()) || isLetter(scanner.peek()) || scanner.peek() == '/') {
    return scanner.fault("the wind should end here");
  }
  wind.leastSpeed = windSpeed(speeds.least, unit->value_or(WindUnits::Speed::Knots));
  wind.mostSpeed = windSpeed(speeds.most, unit->value_or(WindUnits::Speed::Knots));
  if (!(wind.mostSpeed <= aircraft::kMostWind)) {
    return scanner.fault(Errc::OutOfRange, speeds.at, "the speed is above 200 kt; a wind of 0 to 200 kt is expected");
  }
  return wind;
}

/// A speed of two or three digits, as in a METAR.
Result<double> takeGroupSpeed(WindScanner& scanner) {
  const std::size_t at = scanner.at();
  if (scanner.peek() == 'P') {
    return scanner.fault(Errc::OutOfRange, at, "P stands for more than the speed after it, and a wind without an upper limit cannot be planned for");
  }
  const std::string_view digits = scanner.takeDigits();
  if (digits.size() != 2 && digits.size() != 3) {
    return scanner.fault(Errc::BadFormat, at, "a speed of two or three digits is expected");
  }
  return valueOf(digits);
}

/// 27015KT, 27015G25KT, VRB05KT from behind the direction on. @param direction  nothing: variable
Result<air::WindSector> readGroup(WindScanner& scanner, std::optional<double> direction, std::size_t start, bool needsUnit) {
  Speeds speeds{0.0, 0.0, scanner.at()};
  const Result<double> mean = takeGroupSpeed(scanner);
  if (!mean) {
    return forward(mean);
  }
  needsUnit = needsUnit || scanner.at() - speeds.at == 3;  // dddfff without a unit could be ddfftt of a winds-aloft forecast
  speeds.least = direction ? *mean : 0.0;
  speeds.most = *mean;
  if (scanner.take("G")) {
    const std::size_t at = scanner.at();
    const Result<double> gust = takeGroupSpeed(scanner);
    if (!gust) {
      return forward(gust);
    }
    if (*gust <= *mean) {
      return scanner.fault(Errc::OutOfRange, at, "gusts must be stronger than the wind before them");
    }
    speeds.most = *gust;
  }
  if (direction == 0.0 && speeds.most > 0.0) {
    return scanner.fault(Errc::OutOfRange, start, "direction 000 stands for calm, 00000KT; a wind from the north is written 360");
  }
  if (speeds.most == 0.0) {
    direction = 0.0;
  }
  return finished(scanner, {direction.value_or(0.0), direction ? 0.0 : 180.0}, speeds, needsUnit);
}

/// The speed behind the slash: 15, 10-20, 15G25, 15+-5.
Result<Speeds> takeSpeeds(WindScanner& scanner, bool isVariable) {
  scanner.skipSpaces();
  Speeds speeds{0.0, 0.0, scanner.at()};
  if (scanner.peek() == '-') {
    return scanner.fault(Errc::OutOfRange, speeds.at, "a speed cannot be below zero");
  }
  const std::optional<double> first = scanner.takeNumber();
  if (!first) {
    return scanner.fault("a speed is expected, such as 15, 10-20, 15G25 or 15+-5");
  }
  speeds.least = isVariable ? 0.0 : *first;
  speeds.most = *first;
  const std::size_t at = scanner.at();
  const bool isRange = !scanner.takePlusMinus();
  if (isRange && !scanner.take("-") && !scanner.take("G")) {
    return speeds;
  }
  const bool isGust = isRange && scanner.text()[at] != '-';
  const std::optional<double> second = scanner.takeNumber();
  if (!second) {
    return scanner.fault("a number is expected here");
  }
  if (isRange && (isGust ? *second <= *first : *second < *first)) {
    return scanner.fault(Errc::OutOfRange, at, isGust ? "gusts must be stronger than the wind before them" : "the lower speed goes first");
  }
  if (!isRange && *second > *first) {
    return scanner.fault(Errc::OutOfRange, at, "the speed would go below zero; write the range, such as 0-15kt");
  }
  speeds.least = isRange ? (isGust && isVariable ? 0.0 : *first) : *first - *second;
  speeds.most = isRange ? *second : *first + *second;
  return speeds;
}

/// 270/15kt, 270+-20/10-20kt, VRB/0-5kt from behind the direction on.
Result<air::WindSector> readSlash(WindScanner& scanner, std::optional<double> direction, bool needsUnit) {
  air::WindSector wind{direction.value_or(0.0), direction ? 0.0 : 180.0};
  scanner.take("\xC2\xB0");
  if (direction && scanner.takePlusMinus()) {
    const std::size_t at = scanner.at();
    const std::optional<double> spread = scanner.takeNumber();
    if (!spread) {
      return scanner.fault("degrees to each side of the direction are expected, such as 270+-20/15kt");
    }
    if (*spread > 180.0) {
      return scanner.fault(Errc::OutOfRange, at, "a spread of 0 to 180 degrees to each side is expected");
    }
    wind.spread_deg = *spread;
    scanner.take("\xC2\xB0");
  }
  scanner.skipSpaces();
  if (!scanner.take("/")) {
    return scanner.fault("a slash and a speed are expected after the direction, such as 270/15kt");
  }
  const Result<Speeds> speeds = takeSpeeds(scanner, !direction);
  return speeds ? finished(scanner, wind, *speeds, needsUnit) : forward(speeds);
}

/// Direction, three digits and perhaps decimals; the scanner stands behind it then.
Result<double> takeDirection(WindScanner& scanner) {
  const std::size_t start = scanner.at();
  const std::string_view digits = scanner.takeDigits();
  if (digits.size() == 4) {
    return scanner.fault(Errc::BadFormat, start,
                         "four digits are a wind of a winds-aloft forecast, which needs its line of altitudes; else a direction of three digits and "
                         "a speed are expected, such as 270/15kt");
  }
  if (digits.size() < 3 || digits.size() > 6) {
    return scanner.fault(Errc::BadFormat, start,
                         digits.empty() ? kWind : "a direction of three digits is expected, such as 027 or 270, and a speed, such as 270/15kt");
  }
  scanner.moveTo(start + 3);
  double direction = valueOf(digits.substr(0, 3));
  if (digits.size() == 3 && scanner.peek() == '.') {
    scanner.moveTo(start);
    direction = scanner.takeNumber().value_or(0.0);
  }
  if (direction > 360.0) {
    return scanner.fault(Errc::OutOfRange, start, "the direction is above 360; 000 to 360 degrees are expected");
  }
  return direction;
}

/// 240V300 if it is next: directions clockwise.
Result<void> readVariation(WindScanner& scanner, air::WindSector& wind) {
  const std::size_t before = scanner.at();
  scanner.skipSpaces();
  const std::size_t at = scanner.at();
  const std::string_view first = scanner.takeDigits();
  if (first.size() != 3 || !scanner.take("V")) {
    scanner.moveTo(before);
    return {};
  }
  const std::string_view second = scanner.takeDigits();
  if (second.size() != 3 || isLetter(scanner.peek()) || isDigit(scanner.peek())) {
    return scanner.fault(Errc::BadFormat, at, "a range of directions is expected, such as 240V300");
  }
  const double from = valueOf(first);
  const double to = valueOf(second);
  if (from > 360.0 || to > 360.0) {
    return scanner.fault(Errc::OutOfRange, at, "the direction is above 360; 000 to 360 degrees are expected");
  }
  if (wind.spread_deg == 180.0) {
    return {};  // any direction holds these
  }
  const double width = std::fmod(to - from + 360.0, 360.0);
  const double mean = std::fmod(wind.from_deg - from + 720.0, 360.0);
  if (mean > width || wind.spread_deg > 0.0) {
    return scanner.fault(Errc::OutOfRange, at, "the direction of the wind does not lie in this range, which goes clockwise");
  }
  wind.spread_deg = width / 2.0;
  wind.from_deg = std::fmod(from + width / 2.0, 360.0);
  return {};
}

}  // namespace

double windSpeed(double number, WindUnits::Speed unit) {
  switch (unit) {
    case WindUnits::Speed::Knots:
      return number * kMpsPerKnot;
    case WindUnits::Speed::KilometresPerHour:
      return number / 3.6;
    case WindUnits::Speed::MetresPerSecond:
      break;
  }
  return number;
}

Result<air::WindSector> readWind(WindScanner& scanner, bool needsUnit) {
  const std::size_t start = scanner.at();
  if (scanner.take("CALM")) {
    return isLetter(scanner.peek()) || isDigit(scanner.peek()) ? Result<air::WindSector>(scanner.fault("the wind should end here"))
                                                               : Result<air::WindSector>(air::WindSector{});
  }
  if (scanner.peek() == '/') {
    return scanner.fault("the direction is missing here; 000 to 360 degrees or VRB are expected");
  }
  std::optional<double> direction;
  if (!scanner.take("VRB")) {
    const Result<double> taken = takeDirection(scanner);
    if (!taken) {
      return forward(taken);
    }
    direction = *taken;
  }
  const bool isGroup = isDigit(scanner.peek()) || scanner.peek() == 'P';
  Result<air::WindSector> wind = isGroup ? readGroup(scanner, direction, start, needsUnit) : readSlash(scanner, direction, needsUnit);
  if (wind) {
    if (const Result<void> varied = readVariation(scanner, *wind); !varied) {
      return forward(varied);
    }
  }
  return wind;
}

}  // namespace vp::formats
