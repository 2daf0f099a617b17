#pragma once

#include "core/landing/world.h"
#include "core/mission/landing_path.h"
#include "core/mission/mission.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace vp::emergency {

/** Slopes over ground [-] that may be planned along a part of a descent: [3] (1) to (4) in the wind. */
struct DescentRange {
  double least = 0.0;  ///< tan of the best glide: what the part loses at most if the pilot glides as well as he can
  double most = 0.0;   ///< tan of the steepest descent, at least `least`

  /** [3] (5): a share of 0.5 lies half-way, the optimal descent; 0 is the best glide, 1 the steepest descent. */
  [[nodiscard]] double at(double share) const { return least + share * (most - least); }
};

/** A descent with one share of the range on all of its length. */
struct Descent {
  std::vector<mission::LandingLeg> legs;
  double share = 0.5;
  double surplus = 0.0;  ///< m: how much higher it ends than asked, where even the steepest descent is not steep enough
};

/** Flies descents forwards with a choice of how steep they are: never flatter than the best glide on any course in the winds that cost it most,
 *  never steeper than the profile's steepest descent with the wind as strong from behind as it may be. Without a steepest descent in the profile, and
 *  where the wind leaves no room between the two, there is no choice. Turns in wind are cut at every five degrees of course, legs end at the edges
 *  of bands of altitude. Turns are as steep as straights may be at most: what a turn at the steepest configuration costs beyond that is not relied
 * on.
 *  @threads one thread at a time: it keeps tables of radii it has met. World and mission outlive it */
class DescentFlight {
public:
  static constexpr double kNoGlide = -std::numeric_limits<double>::infinity();

  DescentFlight(const landing::World& world, const mission::Mission& mission);

  /** Slopes of a part that begins on a course [rad], just below an altitude. */
  [[nodiscard]] DescentRange rangeOf(double course, const flight::Piece& part, double altitude);

  /** Altitude at the end of pieces flown from a pose [m MSL], kNoGlide if the wind lets no glide pass; nothing is asked of the ground.
   *  @param pose  becomes the end   @param legs  gets the legs appended; null: not wanted */
  double fly(geo::Pose& pose, double altitude, const std::vector<flight::Piece>& pieces, double share, std::vector<mission::LandingLeg>* legs);
  double fly(geo::Pose& pose, double altitude, const flight::Piece& piece, double share, std::vector<mission::LandingLeg>* legs);

  /** The descent along pieces that ends at `end`: one share for all of it, nearest to what is needed.
   *  @return none if even the best glide ends below `end` */
  std::optional<Descent> descendTo(const geo::Pose& pose, double altitude, const std::vector<flight::Piece>& pieces, double end);

  /** Whether legs keep the world's clearance over known ground. */
  [[nodiscard]] bool isClear(const geo::Pose& pose, double altitude, const std::vector<mission::LandingLeg>& legs) const;
  [[nodiscard]] bool isClear(const geo::Pose& pose, const flight::Piece& piece, double altitude, double end) const;

  [[nodiscard]] const landing::World& world() const { return *world_; }

private:
  /// What turns of a radius lose in a band.
  struct Known {
    double radius = 0.0;
    std::size_t band = 0;
    std::shared_ptr<const aircraft::CourseLoss> byCourse;
    double still = 0.0;
  };

  [[nodiscard]] const aircraft::GlideModel& lossesOf(std::size_t band) const;
  const Known& known(double radius, std::size_t band);
  [[nodiscard]] double steepest(double course, const flight::Piece& part) const;
  [[nodiscard]] DescentRange inBand(double course, const flight::Piece& part, std::size_t band);

  const landing::World* world_;
  const mission::Mission* mission_;
  bool isCalm_;
  double steepestInAir_ = 0.0;  ///< tan; 0 without
  double slowest_ = 0.0;        ///< true airspeeds of the glide [m/s]
  double fastest_ = 0.0;
  double shear_ = 1.0;  ///< what of the rate of descent is left in the change of the wind with height
  std::vector<Known> known_;
};

}  // namespace vp::emergency
