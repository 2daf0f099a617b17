#pragma once

#include "core/air/wind.h"
#include "core/geo/pose.h"

#include <vector>

namespace vp::flight {

enum class Turn : signed char { Right = -1, Straight = 0, Left = 1 };

/** Part of a horizontal curve flown with one bank angle.
 *  radius [m], 0 for straight parts; length along the air path [m], >= 0. */
struct Piece {
  Turn turn = Turn::Straight;
  double radius = 0.0;
  double length = 0.0;
  bool operator==(const Piece&) const = default;
};

/** A horizontal curve: a start and the pieces flown from it, one after the other.
 *  The pieces are air-mass curves that carry their wind; in calm air (wind zero) air path and ground track are one.
 *  A value type; poseAfter() and friends live in curve_sampling.h. */
struct Curve {
  geo::Pose start;
  std::vector<Piece> pieces;
  air::Wind wind;
  bool operator==(const Curve&) const = default;
};

}  // namespace vp::flight
