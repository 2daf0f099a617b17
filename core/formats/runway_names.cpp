#include "core/formats/runway_names.h"

#include "core/geo/magnetic_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::formats {
namespace {

constexpr std::array<std::string_view, 16> kRose{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
constexpr double kEpoch = 2025.0;           // of the World Magnetic Model 2025
constexpr double kCautionZone_nT = 6000.0;  // horizontal field below which compasses are unreliable, WMM2025 report

struct Number {
  int value = 0;
  std::size_t digits = 0;
};

Number numberOf(std::string_view ident) {
  Number number;
  while (number.digits < ident.size() && number.digits < 4 && ident[number.digits] >= '0' && ident[number.digits] <= '9') {
    number.value = number.value * 10 + (ident[number.digits] - '0');
    ++number.digits;
  }
  return number;
}

bool isRunwayNumber(const Number& number) {
  return number.digits >= 1 && number.digits <= 2 && number.value >= 1 && number.value <= 36;
}

}  // namespace

std::optional<double> courseOfIdent(std::string_view ident) {
  const auto* const direction = std::find(kRose.begin(), kRose.end(), ident);
  if (direction != kRose.end()) {
    return 22.5 * static_cast<double>(direction - kRose.begin());
  }
  const Number number = numberOf(ident);
  if (number.digits == 3 && number.value >= 1 && number.value <= 360) {
    return std::fmod(number.value, 360.0);  // some strips are named by their course in degrees
  }
  return isRunwayNumber(number) ? std::optional(std::fmod(number.value * 10.0, 360.0)) : std::nullopt;
}

Angle variationForRunways(geo::LatLon place) {
  const geo::MagneticField field = geo::magneticField(place, geo::HeightMsl(), kEpoch);
  return field.horizontal() < kCautionZone_nT ? Angle() : field.variation();
}

std::optional<NamedCourse> courseFromName(std::string_view ident, geo::LatLon place) {
  const std::optional<double> named = courseOfIdent(ident);
  if (!named) {
    return std::nullopt;
  }
  if (std::find(kRose.begin(), kRose.end(), ident) != kRose.end()) {
    return NamedCourse{Angle::degrees(*named), "heading derived from the runway's name, a direction of the wind rose"};
  }
  const double variation = variationForRunways(place).degrees();
  if (variation == 0.0) {
    return NamedCourse{Angle::degrees(*named), "heading derived from the runway number, taken as true: compasses are unreliable here"};
  }
  return NamedCourse{Angle::degrees(std::fmod(*named + variation + 360.0, 360.0)),
                     fmt::format("heading derived from the runway number and the magnetic variation of {:.0f} degrees {}", std::fabs(variation),
                                 variation < 0.0 ? "west" : "east")};
}

std::string oppositeIdent(std::string_view ident) {
  const auto* const direction = std::find(kRose.begin(), kRose.end(), ident);
  if (direction != kRose.end()) {
    return std::string(kRose[static_cast<std::size_t>(direction - kRose.begin() + 8) % kRose.size()]);
  }
  const Number number = numberOf(ident);
  if (!isRunwayNumber(number)) {
    return {};
  }
  std::string side(ident.substr(number.digits));
  if (side == "L" || side == "R") {
    side = side == "L" ? "R" : "L";
  }
  return fmt::format("{:02}{}", number.value > 18 ? number.value - 18 : number.value + 18, side);
}

std::string runwayNumber(double course_deg) {
  const int number = static_cast<int>(std::lround(course_deg / 10.0)) % 36;
  return fmt::format("{:02}", number == 0 ? 36 : number);
}

}  // namespace vp::formats
