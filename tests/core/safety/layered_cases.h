#pragma once

// Random missions whose winds and air depend on the altitude, and one weather out of each: a wind and an airspeed at every height.

#include "core/safety/cell_walk.h"
#include "core/safety/glide_rates.h"
#include "core/safety/ground_path.h"
#include "core/safety/plan_conditions.h"
#include "core/terrain/elevation_grid.h"
#include "tests/core/safety/motion_flight.h"
#include "tests/core/safety/wind_cases.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace vp::test {

inline constexpr double kLeastMass = 900.0;
inline constexpr double kMostMass = 1157.0;

class LayeredCases : public WindCases {
public:
  using WindCases::WindCases;

  double between(double low, double high) { return low + (high - low) * unit(); }

  /// Nothing but what conditions depend on: altitudes from 0 to 3500 m, two to four layers, sometimes one, most with an atmosphere.
  mission::Plan plan() {
    mission::Plan plan;
    plan.mission.aircraft = cessna();
    if (below(2) == 0) {
      plan.mission.aircraft.leastMass_kg = kLeastMass;
      plan.mission.aircraft.mostMass_kg = kMostMass;
    }
    if (below(3) != 0) {
      plan.mission.atmosphere = air::Atmosphere{between(-30.0, 25.0), between(980.0, 1040.0)};
    }
    plan.sites.emplace_back().site.elevation = geo::HeightMsl::fromMetres(0.0);
    plan.tour.emplace_back().altitude = 3500.0;
    double altitude = between(100.0, 700.0);
    for (int count = 1 + below(4); count > 0; --count) {
      air::WindLayer one = layer(altitude);
      one.wind.leastSpeed *= 0.7;
      one.wind.mostSpeed *= 0.7;
      plan.mission.wind.push_back(one);
      altitude += between(400.0, 900.0);
    }
    return plan;
  }

  /// One weather of a mission for an aircraft of one mass: of each layer one wind, and between two layers on the way from one to the other: evenly,
  /// or, where the wind then nowhere changes faster than it may, more at one end.
  std::function<AirThere(double)> weather(const mission::Mission& mission, double mass_kg) {
    std::vector<double> altitudes;
    std::vector<air::Wind> winds;
    for (const air::WindLayer& one : mission.wind) {
      altitudes.push_back(one.altitude.metres());
      winds.push_back(wind({one}));
    }
    const double drawn = std::array<double, 3>{0.6, 1.0, 1.7}[static_cast<std::size_t>(below(3))];
    std::vector<double> powers;  // of each layer and the next
    for (std::size_t i = 0; i + 1 < winds.size(); ++i) {
      const double steepest = 1.7 * std::hypot(winds[i + 1].east - winds[i].east, winds[i + 1].north - winds[i].north);
      powers.push_back(steepest <= furthestApart(mission.wind[i].wind, mission.wind[i + 1].wind) ? drawn : 1.0);
    }
    return [=, profile = mission.aircraft, air = mission.atmosphere](double height) {
      std::size_t above = 0;
      while (above < altitudes.size() && altitudes[above] < height) {
        ++above;
      }
      const std::size_t low = above == 0 ? 0 : above - 1;
      const std::size_t high = std::min(above, altitudes.size() - 1);
      double part = 0.0;
      double partPerMetre = 0.0;
      if (low < high) {
        const double share = (height - altitudes[low]) / (altitudes[high] - altitudes[low]);
        const double power = powers[low];
        part = power < 1.0 ? 1.0 - std::pow(1.0 - share, 1.0 / power) : std::pow(share, power);
        partPerMetre = (power < 1.0 ? std::pow(1.0 - share, 1.0 / power - 1.0) / power : power * std::pow(share, power - 1.0)) /
                       (altitudes[high] - altitudes[low]);
      }
      AirThere there;
      there.wind = {winds[low].east + part * (winds[high].east - winds[low].east), winds[low].north + part * (winds[high].north - winds[low].north)};
      there.change = {partPerMetre * (winds[high].east - winds[low].east), partPerMetre * (winds[high].north - winds[low].north)};
      there.airspeed = profile.bestGlideSpeed.si() * std::sqrt(mass_kg / profile.mass_kg);
      if (air) {
        const double temperature = 288.15 - 0.0065 * height;
        const double pressure = 100.0 * air->qnh_hPa * std::pow(temperature / 288.15, 5.25588);
        there.airspeed *= std::sqrt(profile.airDensity_kgm3 * 287.05287 * (temperature + air->temperatureOffset_K) / pressure);
      }
      return there;
    };
  }

  /// Greatest difference of two winds of two sectors that is found on a grid of both [m/s]: not above the greatest there is.
  static double furthestApart(const air::WindSector& a, const air::WindSector& b) {
    constexpr int kDirections = 12;
    const auto windsOf = [](const air::WindSector& sector) {
      std::vector<air::Wind> winds;
      for (int i = 0; i <= kDirections; ++i) {
        const double from = (sector.from_deg + sector.spread_deg * (2.0 * i / kDirections - 1.0)) * Angle::kPi / 180.0;
        winds.push_back({-sector.mostSpeed * std::sin(from), -sector.mostSpeed * std::cos(from)});
        winds.push_back({-sector.leastSpeed * std::sin(from), -sector.leastSpeed * std::cos(from)});
      }
      return winds;
    };
    double most = 0.0;
    for (const air::Wind& p : windsOf(a)) {
      for (const air::Wind& q : windsOf(b)) {
        most = std::max(most, std::hypot(p.east - q.east, p.north - q.north));
      }
    }
    return most;
  }

  double mass(const mission::Mission& mission) {
    const double least = mission.aircraft.leastMass_kg.value_or(mission.aircraft.mass_kg);
    const double most = mission.aircraft.mostMass_kg.value_or(mission.aircraft.mass_kg);
    const int kind = below(4);
    return kind == 0 ? least : kind == 1 ? most : between(least, most);
  }

  std::vector<flight::Piece> pieces(const std::array<double, 2>& radii) {
    std::vector<flight::Piece> all;
    for (int count = 1 + below(5); count > 0; --count) {
      const auto turn = static_cast<flight::Turn>(below(3) - 1);
      all.push_back({turn, turn == flight::Turn::Straight ? 0.0 : radii[static_cast<std::size_t>(below(2))], 700.0 * unit()});
    }
    return all;
  }

  /// 6 x 6 km about the origin, cells of 60 m.
  terrain::ElevationGrid ground(double highest) {
    std::vector<float> values(100 * 100);
    for (float& value : values) {
      value = static_cast<float>(highest * unit() * unit());
    }
    return {-3000.0, -3000.0, 60.0, 100, 100, values};
  }
  geo::Pose start() { return {600.0 * (unit() - 0.5), 600.0 * (unit() - 0.5), 6.0 * unit()}; }
};

/// A_w as the sum of losses from the start, every wind, its greatest change and every airspeed counted at every height: what held before altitudes
/// were told apart.
inline double addedUp(geo::Pose pose, const std::vector<flight::Piece>& pieces, double arrival, const terrain::ElevationGrid& grid, double clearance,
                      safety::GlideRates& rates) {
  double loss = 0.0;
  double most = grid.upperAt(pose.point()) + clearance;
  safety::CellWalk walk(grid);
  for (const flight::Piece& piece : pieces) {
    const safety::LossAlong along = rates.along(pose.heading, piece);
    walk.start(pose, piece);
    for (safety::Span span; walk.next(span);) {
      most = std::max(most, span.ground + clearance + loss + along.upTo(span.to));
    }
    loss += along.upTo(piece.length);
    pose = safety::endOfPiece(pose, piece);
  }
  return std::max(arrival + loss, most);
}

}  // namespace vp::test
