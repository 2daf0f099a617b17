#pragma once

#include "core/emergency/glide_flight.h"
#include "core/emergency/landing_goals.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vp::emergency {

/** A glide of Dubins curves from the aircraft to a gate, clear of the ground. */
struct SmoothGlide {
  std::vector<geo::Pose> poses;       ///< between the curves, start and gate not included
  std::vector<flight::Piece> pieces;  ///< of all curves
  double altitude = 0.0;              ///< m MSL, at the gate
};

/** Makes ways of straight legs flyable: a Dubins curve between each two of some of their points, with the glide's radii and the ground looked at.
 *
 *  At each point several courses are tried, and points may be left out; of all these ways the one that arrives highest is found exactly (a step by
 *  step maximum: who is higher at a pose can be higher everywhere after it). The points may then be moved about a little, as long as that helps.
 *  @threads const members are pure; what it is made of outlives it
 *  @source [5] section 4.1, where each point is flown over on the course to the next; what differs: README.md */
class GlideSmoothing {
public:
  GlideSmoothing(const landing::World& world, const LandingGoals& goals, const GlideFlight& flight) : world_(world), goals_(goals), flight_(flight) {}

  /** @param points   between start and gate   @param atLeast  m MSL at the gate: only what arrives higher counts
   *  @return none: no such way is clear */
  [[nodiscard]] std::optional<SmoothGlide> smooth(const geo::Pose& start, double altitude, const std::vector<geo::Point>& points,
                                                  const geo::Pose& gate, double atLeast) const;

  /** Moves the poses of a glide at random, first far and then less, and keeps what arrives higher.
   *  @param reach  m, how far at first   @param isOver  true: as good as it is now */
  void polish(const geo::Pose& start, double altitude, const geo::Pose& gate, SmoothGlide& glide, double reach, int tries, std::uint64_t seed,
              const std::function<bool()>& isOver) const;

private:
  struct Curve {
    flight::DubinsPath path;
    double altitude = GlideFlight::kTouches;  ///< at its end
  };
  [[nodiscard]] Curve curve(const geo::Pose& from, double altitude, const geo::Pose& to, double atLeast) const;

  const landing::World& world_;
  const LandingGoals& goals_;
  const GlideFlight& flight_;
};

}  // namespace vp::emergency
