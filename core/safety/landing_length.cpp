#include "core/safety/landing_length.h"

#include "core/safety/standard_air.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vp::safety {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

// What the profile's landing distance is for: sea level in the standard atmosphere (ICAO Doc 7488/3).
constexpr double kReferenceDensity = 1.225;  // kg/m^3
constexpr double kApproachOverStall = 1.3;   // 14 CFR 23.73
constexpr double kTailwindCounts = 1.5;      // AC 23-8
constexpr double kHeadwindCounts = 0.5;      // AC 23-8
constexpr double kPerPercentDown = 0.05;     // UK CAA, Safety Sense Leaflet 7: 2 % downhill adds 10 %

/// Greatest value of speed * part(angle from the landing course that the wind comes from) over a sector; `part` has one hump each half turn,
/// so its greatest value is at an edge of the sector or at one of `peaks`.
template <typename Part>
double greatestOf(const air::WindSector& wind, double course_deg, const std::vector<double>& peaks, Part part) {
  const double middle = wind.from_deg - course_deg;
  std::vector<double> angles{middle - wind.spread_deg, middle + wind.spread_deg};
  for (const double peak : peaks) {
    if (std::abs(std::remainder(peak - middle, 360.0)) <= wind.spread_deg) {
      angles.push_back(peak);
    }
  }
  double most = -kNothing;
  for (const double angle : angles) {
    const double value = part(Angle::degrees(angle).radians());
    most = std::max({most, wind.leastSpeed * value, wind.mostSpeed * value});
  }
  return most;
}

/// UK CAA, Safety Sense Leaflet 7: dry grass 1.15 (and so gravel), wet grass 1.35, soft ground or snow 1.25; nobody knows which it is.
double surfaceFactor(mission::Surface surface) {
  switch (surface) {
    case mission::Surface::Hard:
      return 1.0;
    case mission::Surface::Gravel:
      return 1.15;
    case mission::Surface::Dirt:
    case mission::Surface::Snow:
      return 1.25;
    case mission::Surface::Grass:
    case mission::Surface::Unknown:
    case mission::Surface::Water:
      break;
  }
  return 1.35;
}

double windFactor(const mission::Mission& mission, const mission::LandingSite& site, double density) {
  const aircraft::AircraftProfile& profile = mission.aircraft;
  const double indicated = profile.stallSpeed ? kApproachOverStall * profile.stallSpeed->si() : profile.bestGlideSpeed.si();
  const double airspeed = indicated * std::sqrt(profile.airDensity_kgm3 / density);
  const double tail = runwayWinds(mission, site).tail;
  const double ground = airspeed + (tail > 0.0 ? kTailwindCounts : kHeadwindCounts) * tail;
  const double ratio = std::max(0.0, ground) / airspeed;
  return ratio * ratio;
}

/// Elevation of the other end of a runway, where that is a site too.
const mission::LandingSite* otherEnd(const mission::Plan& plan, const mission::LandingSite& site) {
  const std::string other = oppositeEnd(site.runwayIdent);
  const auto isOther = [&](const mission::LandingSite& end) {
    return !other.empty() && end.airportIdent == site.airportIdent && oppositeEnd(oppositeEnd(end.runwayIdent)) == other;
  };
  for (const mission::SiteInFrame& end : plan.sites) {
    if (isOther(end.site)) {
      return &end.site;
    }
  }
  const auto given = std::find_if(plan.mission.sites.begin(), plan.mission.sites.end(), isOther);
  return given != plan.mission.sites.end() ? &*given : nullptr;
}

double slopeFactor(const mission::Plan& plan, const mission::LandingSite& site) {
  const mission::LandingSite* other = otherEnd(plan, site);
  if (other == nullptr || !site.length || !(site.length->si() > 0.0)) {
    return 1.0;
  }
  const double downhillPercent = 100.0 * (site.elevation.metres() - other->elevation.metres()) / site.length->si();
  return 1.0 + kPerPercentDown * std::max(0.0, downhillPercent);
}

}  // namespace

/// "21L" -> "03R"; empty if it is no runway number.
std::string oppositeEnd(const std::string& ident) {
  if (ident.empty() || ident[0] < '0' || ident[0] > '9') {
    return {};
  }
  std::size_t digits = 0;
  int number = 0;
  while (digits < ident.size() && digits < 2 && ident[digits] >= '0' && ident[digits] <= '9') {
    number = 10 * number + (ident[digits++] - '0');
  }
  const std::string side = ident.substr(digits);
  if (number < 1 || number > 36 || side.size() > 1) {
    return {};
  }
  const char swapped = side == "L" ? 'R' : side == "R" ? 'L' : side.empty() ? ' ' : side[0];
  return fmt::format("{:02}{}", number > 18 ? number - 18 : number + 18, side.empty() ? std::string() : std::string(1, swapped));
}

RunwayWinds runwayWinds(const mission::Mission& mission, const mission::LandingSite& site) {
  if (mission.wind.empty()) {
    return {};
  }
  RunwayWinds most{-kNothing, -kNothing};
  for (std::size_t i = 0; i < mission.wind.size(); ++i) {
    const bool isFarAbove = i > 0 && mission.wind[i - 1].altitude > site.elevation;
    const bool isFarBelow = i + 1 < mission.wind.size() && mission.wind[i + 1].altitude <= site.elevation;
    if (isFarAbove || isFarBelow) {
      continue;
    }
    const air::WindSector& wind = mission.wind[i].wind;
    const double course = site.landingCourse.degrees();
    most.tail = std::max(most.tail, greatestOf(wind, course, {180.0}, [](double angle) { return -std::cos(angle); }));
    most.cross = std::max(most.cross, greatestOf(wind, course, {90.0, -90.0}, [](double angle) { return std::abs(std::sin(angle)); }));
  }
  return most;
}

std::optional<double> landingLength(const mission::Plan& plan, const mission::LandingSite& site) {
  const std::optional<Length>& distance = plan.mission.aircraft.landingDistance;
  if (!distance || site.surface == mission::Surface::Water) {
    return {};
  }
  const double density = densityAt(plan.mission.atmosphere.value_or(air::Atmosphere()), site.elevation.metres());
  return distance->si() * (kReferenceDensity / density) * windFactor(plan.mission, site, density) * slopeFactor(plan, site) *
         surfaceFactor(site.surface);
}

}  // namespace vp::safety
