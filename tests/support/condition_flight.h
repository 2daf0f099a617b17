#pragma once
// Glides of a plan flown by the equations of motion on one day: one mass, one wind, the air of every height, a pilot who reacts late, and
// the approach that the mission asks for. Shares nothing with planner and checker but the numbers of the mission.

#include "core/mission/glide_conditions.h"
#include "core/mission/plan.h"
#include "tests/support/band_flight.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vp::test {

/** The point mass of one day: this mass, flown at the indicated speed that is best for it, at one altitude. */
inline aircraft::GlidePolar polarAt(const aircraft::AircraftProfile& profile, const aircraft::GlideConditions& conditions, double mass,
                                    double altitude) {
  aircraft::AircraftProfile one = profile;
  one.mass_kg = mass;
  if (conditions.air) {
    const double within = std::clamp(altitude, conditions.air->lowest.metres(), conditions.air->highest.metres());
    one.airDensity_kgm3 = air::density(conditions.air->atmosphere, geo::HeightMsl::fromMetres(within));
  }
  one.bestGlideSpeed = Speed::fromSi(profile.bestGlideSpeed.si() * std::sqrt(mass / profile.mass_kg * profile.airDensity_kgm3 / one.airDensity_kgm3));
  one.zeroLiftDrag = aircraft::zeroLiftDragOf(profile, conditions.propeller);
  aircraft::GlidePolar polar = polarOf(one);
  polar.parasite *= conditions.dragFactor;
  polar.induced *= conditions.dragFactor;
  return polar;
}

struct Day {
  double mass = 0.0;
  DayWinds winds;
};

/** A mass and winds of the mission, evenly at random. */
template <typename Random>
Day dayOf(const mission::Mission& mission, Random& random) {
  const aircraft::AircraftProfile& profile = mission.aircraft;
  const double least = profile.leastMass_kg.value_or(profile.mass_kg);
  const double most = profile.mostMass_kg.value_or(profile.mass_kg);
  const double mass = std::uniform_real_distribution<double>(0.0, 1.0)(random) * (most - least) + least;
  return {mass, dayWinds(mission.wind, random)};
}

/** Metres before the touchdown point that the approach of a glide begins at. */
inline double approachLength(const mission::ApproachSettings& approach, const std::vector<flight::Piece>& pieces) {
  switch (approach.kind) {
    case mission::ApproachKind::Straight:
      return approach.finalLength.si();
    case mission::ApproachKind::Overhead:
      return pieces.empty() ? 0.0 : pieces.back().length;
    case mission::ApproachKind::Threshold:
      break;
  }
  return 0.0;
}

struct ConditionOutcome : Outcome {
  double gateAltitude = 0.0;  ///< where the approach begins
  geo::Pose gate;
  bool isGateStraight = true;  ///< no turn on the approach, for ApproachKind::Straight
};

/** Flies a glide to its end, in steps of two metres at most; no step goes over the beginning of the approach. */
inline ConditionOutcome flyGlide(const mission::Plan& plan, const aircraft::GlideConditions& conditions, const Day& day,
                                 const terrain::ElevationGrid& terrain, geo::Pose pose, double altitude, const std::vector<flight::Piece>& pieces) {
  const mission::ApproachSettings& asked = plan.mission.approach;
  const double clearance = plan.mission.safety.clearance.si();
  double toGo = 0.0;
  for (const flight::Piece& piece : pieces) {
    toGo += piece.length;
  }
  const double last = approachLength(asked, pieces);
  ConditionOutcome outcome;
  outcome.gateAltitude = altitude;
  outcome.gate = pose;
  const auto look = [&] {
    const bool isTapered = asked.surfaceSlope && toGo <= last + 1e-6;
    const double wanted = isTapered ? std::min(clearance, *asked.surfaceSlope * std::max(0.0, toGo - asked.surfaceStart.si())) : clearance;
    outcome.leastSpare = std::min(outcome.leastSpare, altitude - wanted - terrain.upperAt(pose.point()));
  };
  look();
  for (const flight::Piece& piece : pieces) {
    double left = piece.length;
    while (left > 1e-9) {
      const double untilGate = toGo - last;
      double length = std::min({2.0, left, untilGate > 1e-6 ? untilGate : 2.0});
      const bool isFinal = untilGate <= 1e-6;
      const double side = static_cast<double>(static_cast<int>(piece.turn));
      const double ahead = side == 0.0 ? 0.0 : 0.5 * side * length / piece.radius;
      const double flown = lossInWind(polarAt(plan.mission.aircraft, conditions, day.mass, altitude), day.winds.at(altitude),
                                      day.winds.changeAt(altitude), pose.heading + ahead, side, side == 0.0 ? 0.0 : piece.radius);
      length = std::min(length, std::max(1e-6, (altitude - day.winds.edgeBelow(altitude)) / flown));  // no step goes through a layer
      const double turned = side == 0.0 ? 0.0 : side * length / piece.radius;
      const double middle = pose.heading + 0.5 * turned;
      const double chord = side == 0.0 ? length : 2.0 * piece.radius * std::sin(0.5 * length / piece.radius);
      const bool isChosen = isFinal && asked.slope && asked.kind == mission::ApproachKind::Straight;
      altitude -= length * (isChosen ? tan(*asked.slope) : flown);
      pose = {pose.x + chord * std::cos(middle), pose.y + chord * std::sin(middle), pose.heading + turned};
      toGo -= length;
      left -= length;
      outcome.isGateStraight = outcome.isGateStraight && (!isFinal || side == 0.0);
      if (!isFinal) {
        outcome.gateAltitude = altitude;
        outcome.gate = pose;
      }
      look();
    }
  }
  outcome.endAltitude = altitude;
  outcome.end = pose;
  return outcome;
}

/** Curvature of a path of pieces after so many metres [1/m]; 0 behind its end. */
template <typename Pieces, typename PieceOf>
double curvatureAt(const Pieces& pieces, PieceOf pieceOf, double distance) {
  for (const auto& one : pieces) {
    const flight::Piece& piece = pieceOf(one);
    if (distance < piece.length) {
      return piece.turn == flight::Turn::Straight ? 0.0 : static_cast<double>(static_cast<int>(piece.turn)) / piece.radius;
    }
    distance -= piece.length;
  }
  return 0.0;
}

/** Whether the glide of a point of a path turns before the pilot has reacted: until then it follows the path, or goes straight, or first the one
 *  and then the other. @param path  from that point on   @param length  flown until then, m */
inline bool turnsTooEarly(const std::vector<flight::Piece>& path, const std::vector<flight::Piece>& glide, double length) {
  const auto self = [](const flight::Piece& piece) -> const flight::Piece& { return piece; };
  bool isOnPath = true;
  for (double at = 0.5; at < length - 1e-6; at += 1.0) {
    const double bends = curvatureAt(glide, self, at);
    // where one piece ends within this metre, either counts
    const bool follows = std::abs(bends - curvatureAt(path, self, at - 0.5)) < 1e-9 || std::abs(bends - curvatureAt(path, self, at)) < 1e-9 ||
                         std::abs(bends - curvatureAt(path, self, at + 0.5)) < 1e-9;
    isOnPath = isOnPath && follows;
    if (!isOnPath && bends != 0.0) {
      return true;
    }
  }
  return false;
}

}  // namespace vp::test
