// Where ways from and to home may meet the tour, and which pair of them is flown. Of home_path.cpp only.
#pragma once

#include "core/mission/plan.h"
#include "core/tour/segment.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vp::tour {

/** Places in the detours of the ways: the runway's end, the threshold, and the joins in order. */
inline constexpr int kHomeFrom = 0;
inline constexpr int kHomeTo = 1;
inline constexpr int kFirstJoin = 2;

/** A point of the tour, with its number in the detours. */
struct Join {
  std::size_t point = 0;
  VisitPose visit;
};

/** Evenly spaced decision points of a tour and all visits of targets. */
class HomeJoins {
public:
  /** @param plan  outlives this; its tour is complete */
  explicit HomeJoins(const mission::Plan& plan);

  [[nodiscard]] const std::vector<Join>& all() const { return joins_; }

  /** The joins of departure and arrival with which least is flown in all; nothing if either has no way.
   *  @param departures, arrivals  metres of the way over each join; infinite: there is none */
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> bestPair(const std::vector<double>& departures,
                                                                            const std::vector<double>& arrivals) const;

private:
  /// Metres of the tour that are flown when it is joined at one point and left at another, all targets visited.
  [[nodiscard]] double flown(std::size_t joined, std::size_t left) const;

  const mission::Plan& plan_;
  std::vector<Join> joins_;
  std::vector<double> along_;  ///< m from the first point of the tour to each
  double loop_ = 0.0;
};

}  // namespace vp::tour
