// Segments beside forbidden airspace.
#include "core/tour/segment.h"

#include <algorithm>
#include <limits>

namespace vp::tour {

/// Gates of an interval. @return false if there is no way past one of them
bool SegmentBuilder::addGates(std::size_t interval) {
  const Interval& i = intervals_[interval];
  nearGates_.clear();
  settings_.forbidden->addGates(world_.terrain, i.start, i.piece, i.ground, nearGates_);
  for (const HeightGate& gate : nearGates_) {
    if (!gate.isPassed(std::numeric_limits<double>::lowest(), i.ground + world_.clearance) && gate.ceiling > settings_.ceiling) {
      return false;
    }
    gates_.push_back({interval, gate});
  }
  return true;
}

/** Raises floor_ over the airspaces that the lowest profile is not under. A profile is continuous, so where the lowest one is
 *  above a floor every other must be over the ceiling. profile_ is the lowest one that passes all. @return false if it is above the ceiling */
bool SegmentBuilder::passGates(bool& isRaised) {
  for (bool again = true; again;) {
    again = false;
    updateProfile();
    for (const auto& [point, gate] : gates_) {
      const auto [low, high] = std::minmax(profile_[point], profile_[point + 1]);
      if (gate.isPassed(low, high)) {
        continue;
      }
      if (gate.ceiling > settings_.ceiling) {
        return false;
      }
      floor_[point] = std::max(floor_[point], gate.ceiling);
      floor_[point + 1] = std::max(floor_[point + 1], gate.ceiling);
      isRaised = again = true;
    }
  }
  return true;
}

}  // namespace vp::tour
