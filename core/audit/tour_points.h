#pragma once

#include "core/mission/plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vp::audit {

/** The way from one decision point of a plan to the next, on which the glide is promised. */
struct Interval {
  const char* track = "";  ///< "tour", "departure" or "arrival"
  std::size_t number = 0;  ///< of its first point on that track
  const std::vector<mission::DecisionPoint>* points = nullptr;
  bool isClosed = false;
  double begins = 0.0;  ///< m along the ground from the first of all intervals

  [[nodiscard]] std::size_t next() const { return number + 1 < points->size() ? number + 1 : 0; }
  [[nodiscard]] const mission::DecisionPoint& from() const { return (*points)[number]; }
  [[nodiscard]] const mission::DecisionPoint& to() const { return (*points)[next()]; }
  [[nodiscard]] double length() const { return from().onward.length; }
};

/** All ways of a plan on which an engine may stop: the closed tour, and the ways from and to home as far as the plan promises a glide there.
 *  Spirals are left out: the guarantee is suspended in them. Intervals of no length are left out. */
std::vector<Interval> intervalsOf(const mission::Plan& plan);

/** How far the glide at the end of an interval keeps to what the aircraft does anyway: along the tour, or having left it once straight on [m];
 * infinity if it never turns by itself. */
double firstOwnTurn(const Interval& interval);

}  // namespace vp::audit
