#pragma once

#include "core/flight/curve.h"
#include "core/geo/pose.h"

#include <vector>

namespace vp::mission {

/** One part of a landing path: a piece over ground, along which altitude changes linearly with distance. */
struct LandingLeg {
  flight::Piece piece;
  double endAltitude = 0.0;  ///< m MSL
  bool operator==(const LandingLeg&) const = default;
};

/** The way down that is flown after an engine failure: local frame, over ground, with the altitudes that are planned for it. What a planner of
 *  emergency landings proposes; no proof of anything until core/safety (landing_check.h) has judged it. A hold is legs of whole circles. */
struct LandingPath {
  geo::Pose start;
  double altitude = 0.0;  ///< m MSL, at the start
  std::vector<LandingLeg> legs;
  int site = -1;  ///< that it lands at, by its index among the sites that the planner was given; -1: it reaches no runway
  bool operator==(const LandingPath&) const = default;
};

}  // namespace vp::mission
