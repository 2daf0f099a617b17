#pragma once
// Glides flown in a given wind by the equations of motion, step by step: what the bounds of planner and checker are held against.
// Shares nothing with either but the numbers of the aircraft.

#include "core/aircraft/aircraft_profile.h"
#include "core/aircraft/course_loss.h"
#include "core/base/quantity.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace vp::test {

inline constexpr double kKnot = 1852.0 / 3600.0;  // m/s

/** The aircraft as sin(gamma) = a + b n^2. */
inline aircraft::GlidePolar polarOf(const aircraft::AircraftProfile& profile) {
  const double v = profile.bestGlideSpeed.si();
  const double qs = 0.5 * profile.airDensity_kgm3 * v * v * profile.wingArea_m2;
  const double weight = profile.mass_kg * kGravity.si();
  return {v, qs * profile.zeroLiftDrag / weight, profile.inducedDrag * weight / qs};
}

struct SteadyWind {
  double east = 0.0;   ///< m/s, towards
  double north = 0.0;  ///< m/s
};

/** Height lost per metre of track in one wind, from the crab angle and the turn rate of the heading that the track asks for.
 *  @param radius  of the turn over ground, 0: straight */
inline double lossInWind(const aircraft::GlidePolar& polar, SteadyWind wind, double course, double radius) {
  const double v = polar.airspeed;
  const auto acrossAt = [&](double chi) { return wind.east * std::sin(chi) - wind.north * std::cos(chi); };
  const auto groundSpeed = [&](double air) {
    const double across = acrossAt(course);
    return std::sqrt(air * air - across * across) + wind.east * std::cos(course) + wind.north * std::sin(course);
  };
  double load = 1.0;
  if (radius > 0.0) {
    constexpr double kStep = 1e-5;
    const double crabs = std::asin(acrossAt(course + kStep) / v) - std::asin(acrossAt(course - kStep) / v);
    const double headingPerCourse = 1.0 + crabs / (2.0 * kStep);
    load = std::hypot(1.0, v * headingPerCourse * groundSpeed(v) / radius / kGravity.si());
  }
  const double sine = polar.parasite + polar.induced * load * load;
  return v * sine / groundSpeed(v * std::sqrt(1.0 - sine * sine));
}

/** The same in a wind that changes with height: what the aircraft needs beside the air's forces and its weight is its acceleration over ground, of
 * which the part along its airspeed is the drag's and the rest the lift's.
 *  @param change  of the wind per metre of height [1/s]   @param side  +1 left, -1 right; straight where the radius is 0
 *  @return infinity where no airspeed is left to get on with */
inline double lossInWind(const aircraft::GlidePolar& polar, SteadyWind wind, SteadyWind change, double course, double side, double radius) {
  if (change.east == 0.0 && change.north == 0.0) {
    return lossInWind(polar, wind, course, radius);
  }
  constexpr double kMoment = 1e-4;  // s, to each side
  const double v = polar.airspeed;
  double sine = polar.parasite + polar.induced;
  double ground = 0.0;
  for (int round = 0; round < 60; ++round) {
    const double flat = v * std::sqrt(1.0 - sine * sine);
    const auto groundSpeed = [&](double chi, double later) {
      const double east = wind.east - change.east * v * sine * later;
      const double north = wind.north - change.north * v * sine * later;
      const double across = east * std::sin(chi) - north * std::cos(chi);
      return std::sqrt(flat * flat - across * across) + east * std::cos(chi) + north * std::sin(chi);
    };
    ground = groundSpeed(course, 0.0);
    const double turning = radius > 0.0 ? side * ground / radius : 0.0;
    const auto velocity = [&](double later) {
      const double chi = course + turning * later;
      const double speed = groundSpeed(chi, later);
      return SteadyWind{speed * std::cos(chi), speed * std::sin(chi)};
    };
    const SteadyWind before = velocity(-kMoment);
    const SteadyWind after = velocity(kMoment);
    const double ax = (after.east - before.east) / (2.0 * kMoment);
    const double ay = (after.north - before.north) / (2.0 * kMoment);
    const double ux = (ground * std::cos(course) - wind.east) / v;
    const double uy = (ground * std::sin(course) - wind.north) / v;
    const double gravity = kGravity.si();
    const double along = ax * ux + ay * uy - gravity * sine;  // of acceleration less gravity: minus drag / mass
    const double lift = std::sqrt(ax * ax + ay * ay + gravity * gravity - along * along) / gravity;
    const double next = polar.parasite + polar.induced * lift * lift + (ax * ux + ay * uy) / gravity;
    if (!(next < 1.0) || !(ground > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    sine = next;
  }
  return v * sine / ground;
}

/** A wind of a sector, evenly at random. */
template <typename Random>
SteadyWind windOf(const air::WindSector& sector, Random& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double towards = sector.towards() + (2.0 * unit(random) - 1.0) * sector.spread();
  const double speed = sector.leastSpeed + unit(random) * (sector.mostSpeed - sector.leastSpeed);
  return {speed * std::cos(towards), speed * std::sin(towards)};
}

/** A wind between one of each layer, evenly at random. */
template <typename Random>
SteadyWind windOf(const std::vector<air::WindLayer>& layers, Random& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  SteadyWind wind;
  double sum = 0.0;
  for (const air::WindLayer& layer : layers) {
    const double weight = layers.size() > 1 ? -std::log(1.0 - unit(random)) : 1.0;
    const SteadyWind one = windOf(layer.wind, random);
    wind = {wind.east + weight * one.east, wind.north + weight * one.north};
    sum += weight;
  }
  return sum > 0.0 ? SteadyWind{wind.east / sum, wind.north / sum} : wind;
}

/** What a glide leaves: the least height above ground + clearance on the way, and the height at its end. */
struct Outcome {
  double leastSpare = 1e9;  ///< m, below zero: too low
  double endAltitude = 0.0;
  geo::Pose end;
};

/** Flies pieces from a pose and altitude in steps of at most `step` metres, each with the loss at its middle. */
inline Outcome fly(const aircraft::GlidePolar& polar, SteadyWind wind, geo::Pose pose, double altitude, const std::vector<flight::Piece>& pieces,
                   const terrain::ElevationGrid& terrain, double clearance, double step = 2.0) {
  Outcome outcome;
  const auto look = [&] { outcome.leastSpare = std::min(outcome.leastSpare, altitude - clearance - terrain.upperAt(pose.point())); };
  look();
  for (const flight::Piece& piece : pieces) {
    const int steps = std::max(1, static_cast<int>(std::ceil(piece.length / step)));
    const double length = piece.length / steps;
    const double side = static_cast<double>(static_cast<int>(piece.turn));
    const double turned = side == 0.0 ? 0.0 : side * length / piece.radius;
    for (int i = 0; i < steps; ++i) {
      const double middle = pose.heading + 0.5 * turned;
      const double chord = side == 0.0 ? length : 2.0 * piece.radius * std::sin(0.5 * length / piece.radius);
      altitude -= length * lossInWind(polar, wind, middle, side == 0.0 ? 0.0 : piece.radius);
      pose = {pose.x + chord * std::cos(middle), pose.y + chord * std::sin(middle), pose.heading + turned};
      look();
    }
  }
  outcome.endAltitude = altitude;
  outcome.end = pose;
  return outcome;
}

/** Engine failure at a place of the tour, flown in one wind: on along the tour to the next decision point and its glide, or at
 *  the point the glide itself. @param part  of the way from the point to the next, in [0, 1) */
inline Outcome failAt(const mission::Plan& plan, const terrain::ElevationGrid& terrain, std::size_t point, double part, SteadyWind wind) {
  const mission::DecisionPoint& from = plan.tour[point];
  const mission::DecisionPoint& next = plan.tour[(point + 1) % plan.tour.size()];
  geo::Pose pose = from.pose;
  std::vector<flight::Piece> pieces = from.witness.pieces;
  if (part > 0.0) {
    const double flown = part * from.onward.length;
    const double side = static_cast<double>(static_cast<int>(from.onward.turn));
    const double turned = side == 0.0 ? 0.0 : side * flown / from.onward.radius;
    const double chord = side == 0.0 ? flown : 2.0 * from.onward.radius * std::sin(0.5 * flown / from.onward.radius);
    pose = {pose.x + chord * std::cos(pose.heading + 0.5 * turned), pose.y + chord * std::sin(pose.heading + 0.5 * turned), pose.heading + turned};
    pieces = {{from.onward.turn, from.onward.radius, from.onward.length - flown}};
    pieces.insert(pieces.end(), next.witness.pieces.begin(), next.witness.pieces.end());
  }
  const double altitude = from.altitude + part * (next.altitude - from.altitude);
  return fly(polarOf(plan.mission.aircraft), wind, pose, altitude, pieces, terrain, plan.mission.safety.clearance.si());
}

}  // namespace vp::test
