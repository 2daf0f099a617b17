#pragma once

#include "core/flight/curve.h"
#include "core/mission/plan.h"

#include <span>
#include <vector>

namespace vp::route {

/** A path as a chain of points close enough together to measure on; of a closed one the last point repeats the first. */
struct Track {
  bool isClosed = true;
  std::vector<geo::Point> points;
  std::vector<double> distance;  ///< m from the start
  std::vector<double> altitude;  ///< m MSL; empty where there is none
  [[nodiscard]] double length() const { return distance.back(); }
};

/// Most that the chords of a track lie beside its arcs [m].
inline constexpr double kTrackError = 0.05;

Track trackOf(const geo::Pose& start, std::span<const flight::Piece> pieces);
/** The tour from decision point `first`, with its altitude. */
Track trackOfTour(const mission::Plan& plan, std::size_t first);

/** An open way, with its altitude. */
Track trackOfWay(const std::vector<mission::DecisionPoint>& way);

/** Where a point lies beside a track. */
struct Beside {
  double distance = 0.0;  ///< m along the track
  double aside = 0.0;     ///< m from it
};

/** Finds, one after the other, the places on a track beside points that follow it: each within some hundred metres of the one
 *  before, so that a track that crosses itself is followed rightly. */
class Follower {
public:
  /** @param start  m along the track near which the first point lies */
  Follower(const Track& track, double start);
  Beside next(geo::Point point);
  /** Goes on from another place of the track. */
  void moveTo(double distance);

private:
  const Track& track_;
  std::size_t at_ = 0;
};

double altitudeOn(const Track& track, double distance);

}  // namespace vp::route
