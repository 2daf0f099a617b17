#pragma once

// Inside of core/safety: numbers of a plan or a path against what the checker's arithmetic is proved for.

#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

namespace vp::safety {

/** Says for each number of a part of the plan whether it is finite and within what the checker's arithmetic is proved for. */
class NumberCheck {
public:
  NumberCheck(CheckContext& context, std::string part, int tourPoint = -1) : context_(context), part_(std::move(part)), tourPoint_(tourPoint) {}

  void within(std::string_view name, double value, double low, double high) {
    if (!(value >= low && value <= high)) {  // also false for NaN
      context_.findings.violated(rule::kPlanNumber, fmt::format("{}: {} is {}, must be between {} and {}", part_, name, value, low, high),
                                 {tourPoint_, {}});
    }
  }
  void altitude(std::string_view name, double value) { within(name, value, kLowestAltitude, kHighestAltitude); }
  void place(geo::LatLon place) {
    within("latitude", place.latitude_deg, -90.0, 90.0);
    within("longitude", place.longitude_deg, -180.0, 180.0);
  }
  void point(geo::Point point) {
    within("x", point.x, -kFarthest, kFarthest);
    within("y", point.y, -kFarthest, kFarthest);
  }
  void pose(const geo::Pose& pose) {
    point(pose.point());
    within("heading", pose.heading, -kLargestHeading, kLargestHeading);
  }
  void piece(const flight::Piece& piece) {
    within("length of a piece", piece.length, 0.0, kLongestPath);
    within("radius of a piece", piece.radius, 0.0, kLargestRadius);
  }

private:
  CheckContext& context_;
  std::string part_;
  int tourPoint_;
};

}  // namespace vp::safety
