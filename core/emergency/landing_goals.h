#pragma once

#include "core/landing/approach.h"
#include "core/landing/world.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::emergency {

/** A runway that a glide may end at: where its approach begins and the lowest height there. */
struct LandingGoal {
  landing::Approach approach;  ///< its altitude raised by what its curve loses more when flown in legs (GlideFlight)
  double least = 0.0;          ///< m MSL: from the aircraft's pose no glide reaches it from lower
};

/** The runways that an aircraft may reach from a pose and height, the most promising first, and bounds on what it takes.
 *  @threads const members are pure; the world outlives it */
class LandingGoals {
public:
  /** @param altitude  m MSL: only sites whose bound is at or below it are in range
   *  @param onlySite  the only one that counts, by its index; none: all */
  LandingGoals(const landing::World& world, const geo::Pose& from, double altitude, std::optional<int> onlySite = std::nullopt);

  /** In range, by ascending `least`. */
  [[nodiscard]] const std::vector<LandingGoal>& inRange() const { return goals_; }

  /** Height that any glide between two poses loses at least [m]: straight in the wind and at the altitude that favour it most, and what the change
   *  of heading costs at least. */
  [[nodiscard]] double leastLoss(const geo::Pose& from, const geo::Pose& to) const;

  /** Lowest altitude from which a glide from this pose might reach any of those in range [m MSL]; infinity if none is in range. */
  [[nodiscard]] double leastFrom(const geo::Pose& from) const;

  /** Least of the heights at which approaches of those in range begin [m MSL]; 0 if none is in range. */
  [[nodiscard]] double lowestGate() const { return lowestGate_; }

  /** Why none is in range: which site comes closest and how much height it takes at least. Empty if one is. */
  [[nodiscard]] std::string whyNone() const { return whyNone_; }
  /** Height that is missing at least for the closest [m]; 0 if one is in range or none can be reached from any height. */
  [[nodiscard]] double missing() const { return missing_; }

private:
  const landing::World* world_;
  double turnPerRadian_ = 0.0;  ///< m lost at least beyond straight flight for each radian of heading
  std::vector<LandingGoal> goals_;
  double lowestGate_ = 0.0;
  double missing_ = 0.0;
  std::string whyNone_;
};

}  // namespace vp::emergency
