#pragma once
// The 616 problems of [4] section 3.1 made anew: four emergencies, each with two ranges (one of them with one), two bank limits and two descent
// limits, 22 runway ends each. Weather, runways and ground are generated; what differs from the paper stands in tests/bench/README.md.

#include "core/emergency/landing_request.h"
#include "core/risk/weather.h"
#include "tests/support/landing_cases.h"
#include "tests/support/mountain.h"

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace vp::test {

inline constexpr double kMile = 1852.0;                 // m
inline constexpr double kEmergencyAltitude = 9000.0;    // m MSL
inline constexpr std::size_t kRunwaysOfEmergency = 22;  // 28 versions of them are 616

/// What the versions of one emergency share.
struct Emergency {
  std::string name;
  std::shared_ptr<const terrain::ElevationGrid> grid;
  std::shared_ptr<const risk::Weather> weather;
  std::vector<mission::SiteInFrame> sites;
  geo::Pose pose;
};

/// One version: what the aircraft still can.
struct EmergencyVersion {
  std::size_t emergency = 0;  ///< by its index
  double range = 0.0;         ///< m
  bool isBankLimited = false;
  bool isDescentLimited = false;
};

namespace emergency_detail {

/// A polygon around a place [nautical miles]: star-shaped, so no sides cross.
inline mission::WeatherCell cell(std::mt19937_64& random, double x, double y, double width, double height, double success, double floor, double top) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const geo::LocalFrame frame(kLandingOrigin);
  mission::WeatherCell made;
  constexpr int kCorners = 7;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * Angle::kPi * (i + 0.4 * unit(random)) / kCorners;
    const double far = 0.8 + 0.2 * unit(random);
    made.outline.push_back(frame.toLatLon({kMile * (x + 0.5 * width * far * std::cos(angle)), kMile * (y + 0.5 * height * far * std::sin(angle))}));
  }
  made.success = success;
  made.perDistance = kMile;
  if (floor > 0.0) {
    made.floor = floor;
  }
  if (top > 0.0) {
    made.top = top;
  }
  return made;
}

/// Airports at random distances [nautical miles], to either side of a direction: those on the far side from the weather are trivial.
inline std::vector<mission::SiteInFrame> sites(std::mt19937_64& random, double nearest, double farthest, double direction, double spread,
                                               const terrain::ElevationGrid& grid) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<mission::SiteInFrame> all;
  while (all.size() < kRunwaysOfEmergency) {
    const double angle = direction + spread * (2.0 * unit(random) - 1.0);
    const double far = kMile * std::sqrt(nearest * nearest + (farthest * farthest - nearest * nearest) * unit(random));
    const double course = 2.0 * Angle::kPi * unit(random);
    const geo::Point middle{far * std::cos(angle), far * std::sin(angle)};
    constexpr double kHalf = 1000.0;  // m of runway
    for (const double end : {0.0, Angle::kPi}) {
      const double heading = wrapTwoPi(course + end);
      const geo::Pose pose{middle.x - kHalf * std::cos(heading), middle.y - kHalf * std::sin(heading), heading};
      const std::string id = "R" + std::to_string(all.size() / 2) + (end == 0.0 ? "/A" : "/B");
      all.push_back(placedSite(id.c_str(), pose, grid.upperAt(pose.point())));
    }
  }
  return all;
}

}  // namespace emergency_detail

inline std::vector<Emergency> emergencies() {
  using emergency_detail::cell;
  const geo::LocalFrame frame(kLandingOrigin);
  const auto weather = [&](const std::vector<mission::WeatherCell>& cells) { return *risk::Weather::from(cells, frame); };
  const auto flat = makeGrid(640000.0, 4000.0, [](double, double) { return 0.0; });
  // "some minor terrain obstacles at lower altitudes"
  const auto ridges = makeGrid(640000.0, 2000.0, [](double x, double y) {
    return std::max(0.0, 2200.0 * std::exp(-std::pow((y - 60000.0 - 0.4 * x) / 9000.0, 2.0)) * (0.6 + 0.4 * std::sin(x / 17000.0)));
  });
  std::vector<Emergency> all;
  std::mt19937_64 random(2011);
  // 1: large thunderstorms to the north and west, and a small gap between them; few airports
  std::vector<mission::WeatherCell> storms{cell(random, 8.0, 42.0, 78.0, 40.0, 0.94, 0.0, 13000.0),
                                           cell(random, -46.0, 2.0, 36.0, 66.0, 0.94, 0.0, 13000.0),
                                           cell(random, -14.0, -55.0, 24.0, 18.0, 0.97, 0.0, 7000.0)};
  all.push_back({"two storms and a gap",
                 ridges,
                 weather(storms),
                 emergency_detail::sites(random, 40.0, 150.0, 0.7 * Angle::kPi, 2.2, *ridges),
                 {0.0, 0.0, 1.9}});
  // 2: the same with the storms merged
  storms.push_back(cell(random, -30.0, 32.0, 40.0, 36.0, 0.94, 0.0, 13000.0));
  all.push_back({"storms merged", ridges, weather(storms), all[0].sites, all[0].pose});
  // 3: regions of turbulence, icing and rain, and restricted areas; many airports
  std::vector<mission::WeatherCell> regions;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 14; ++i) {
    const double x = 150.0 * unit(random) - 75.0;
    const double y = 150.0 * unit(random) - 75.0;
    const double size = 15.0 + 35.0 * unit(random);
    switch (i % 4) {
      case 0:  // turbulence
        regions.push_back(cell(random, x, y, size, size, 0.985, 2000.0, 8000.0));
        break;
      case 1:  // icing
        regions.push_back(cell(random, x, y, size, 0.8 * size, 0.97, 3000.0, 6000.0));
        break;
      case 2:  // rain
        regions.push_back(cell(random, x, y, 1.3 * size, size, 0.96, 0.0, 4500.0));
        break;
      default:  // restricted
        regions.push_back(cell(random, x, y, 0.4 * size, 0.4 * size, 0.8, 0.0, 5500.0));
        break;
    }
  }
  all.push_back(
      {"turbulence, icing, rain", flat, weather(regions), emergency_detail::sites(random, 25.0, 100.0, 0.0, Angle::kPi, *flat), {0.0, 0.0, -0.7}});
  // 4: some large cells to the north; an average number of airports
  std::vector<mission::WeatherCell> cells;
  for (int i = 0; i < 6; ++i) {
    cells.push_back(cell(random, 34.0 * i - 85.0 + 10.0 * unit(random), 34.0 + 34.0 * unit(random), 28.0 + 14.0 * unit(random),
                         26.0 + 20.0 * unit(random), 0.95, 0.0, 8000.0 + 6000.0 * unit(random)));
  }
  all.push_back(
      {"cells to the north", flat, weather(cells), emergency_detail::sites(random, 40.0, 150.0, 0.5 * Angle::kPi, 2.0, *flat), {0.0, 0.0, 0.3}});
  return all;
}

inline std::vector<EmergencyVersion> emergencyVersions() {
  std::vector<EmergencyVersion> all;
  for (std::size_t emergency = 0; emergency < 4; ++emergency) {
    for (const double range : {90.0, 150.0}) {
      for (int limits = 0; limits < 4; ++limits) {
        if (emergency != 2 || range == 90.0) {  // [4] footnote 11
          all.push_back({emergency, range * kMile, limits % 2 == 1, limits / 2 == 1});
        }
      }
    }
  }
  return all;
}

/** A jet without engines whose best glide from the emergency's altitude to sea level is exactly the range.
 *  60 t, 120 m^2, 120 m/s true at a density of 0.9 kg/m^3: about a medium airliner half-way down; [4] tells no aircraft. */
inline mission::Mission emergencyMission(const EmergencyVersion& version) {
  mission::Mission mission = landingMission();
  aircraft::AircraftProfile& craft = mission.aircraft;
  craft.id = "jet";
  craft.name = "Jet without engines";
  craft.mass_kg = 60000.0;
  craft.wingArea_m2 = 120.0;
  craft.airDensity_kgm3 = 0.9;
  craft.bestGlideSpeed = Speed::fromSi(120.0);
  craft.glideBanks = {Angle::degrees(version.isBankLimited ? 5.0 : 45.0)};
  craft.tourBank = Angle::degrees(version.isBankLimited ? 5.0 : 30.0);
  craft.inducedDrag = 0.01;
  const double slope = kEmergencyAltitude / version.range;
  const double force = 0.5 * craft.airDensity_kgm3 * 120.0 * 120.0 * craft.wingArea_m2;
  const double weight = craft.mass_kg * kGravity.si();
  const double lift = weight / force;
  craft.zeroLiftDrag = weight * std::sin(std::atan(slope)) / force - craft.inducedDrag * lift * lift;
  // "effectively unconstrained, or severly limited"
  craft.steepestDescent = version.isDescentLimited ? Angle::radians(std::atan(1.1 * slope)) : Angle::degrees(12.0);
  return mission;
}

/** The request of one version, to whichever runway; `onlySite` makes it one of the problems. */
inline emergency::LandingRequest emergencyRequest(const Emergency& emergency, const EmergencyVersion& version) {
  emergency::LandingRequest request = landingRequest(emergencyMission(version), emergency.sites, emergency.grid, emergency.pose, kEmergencyAltitude);
  request.weather = emergency.weather;
  return request;
}

}  // namespace vp::test
