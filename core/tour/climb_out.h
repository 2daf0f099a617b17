// Climbing circles over the end of a runway, and where the gliding guarantee begins on them. Of home_path.cpp only.
#pragma once

#include "core/landing/roadmap.h"
#include "core/landing/world.h"
#include "core/mission/plan.h"
#include "core/tour/segment.h"

#include <array>

namespace vp::tour {

/** A circle at the end of a runway, without heights. */
struct Circle {
  flight::Turn turn = flight::Turn::Left;
  double radius = 0.0;
  double length = 0.0;
  double ground = 0.0;  ///< m MSL, highest under it
};

/** Circles of the tour's radius to both sides of a pose, the one over lower ground first. */
std::array<Circle, 2> circlesAt(const landing::World& world, const geo::Pose& pose);

/** A climb over one circle from the end of a runway, as steep as the aircraft climbs. */
class ClimbOut {
public:
  /** @param end  of the runway, on the takeoff course   @param elevation  of the runway, m MSL   All outlive this. */
  ClimbOut(const landing::World& world, const SegmentSettings& settings, const geo::Pose& end, double elevation, const Circle& circle)
      : world_(world), settings_(settings), end_(end), elevation_(elevation), circle_(circle) {}

  /** Lowest altitude at which the circles may be left: the runway's, and the clearance above what is under them. */
  [[nodiscard]] double leastAltitude() const;
  /** Whole circles from the runway up to an altitude. */
  [[nodiscard]] double circlesUpTo(double altitude) const;
  [[nodiscard]] double metresUpTo(double altitude) const { return circlesUpTo(altitude) * circle_.length; }
  /** One circle. */
  [[nodiscard]] flight::Piece circlePiece() const { return {circle_.turn, circle_.radius, circle_.length}; }
  /** Adds the circles from the runway up to `top`. */
  void append(double top, mission::HomePath& path) const;
  /** Asks for the glides of the circles, from the last one back, until one is higher than the aircraft.
   *  @param path  circles and the safe points behind them; path.guaranteed is the first of these and becomes the first with a glide */
  void findGuarantee(const landing::Roadmap& roadmap, mission::HomePath& path) const;
  /** The rule of kDepartureClearancePerMetre for the points before the guarantee. */
  [[nodiscard]] bool isClear(const mission::HomePath& path) const;

private:
  const landing::World& world_;
  const SegmentSettings& settings_;
  geo::Pose end_;
  double elevation_;
  Circle circle_;
};

}  // namespace vp::tour
