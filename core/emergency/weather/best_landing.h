#pragma once

#include "core/emergency/landing_goals.h"
#include "core/emergency/weather/weather_flight.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace vp::emergency {

/** Of the ways to runways that a search offers the one that comes through the weather most likely, of those that are as likely the one with the most
 *  height in hand. Each is flown at the best glide, and where slopes leave a choice at the altitudes of least weather; nothing that touches
 *  the ground is kept.
 *  @threads as DescentFlight; all that it is made of outlives it */
class BestLanding {
public:
  BestLanding(const LandingRequest& request, const LandingGoals& goals, WeatherFlight& flight) : request_(request), goals_(goals), flight_(flight) {}

  /** A way by poses, Dubins curves between them, to the gate of a runway in range. @return whether it is the best so far */
  bool offer(const std::vector<geo::Pose>& poses, std::size_t goal);

  /** Single curves to all runways in range: the least loss of each radius, and the four types of a turn, a straight and a turn. */
  void offerDirect(const Countdown& countdown);

  /** Moves the poses of the best way about, far at first, then less, and keeps what is better.
   *  @param tries  at most   @param isOver  stops earlier */
  void polish(int tries, std::uint64_t seed, const Countdown& countdown);

  [[nodiscard]] const std::optional<mission::LandingPath>& path() const { return path_; }
  /** -log of the probability of coming through the weather on the best path; infinity without one. */
  [[nodiscard]] double weather() const { return weather_; }
  /** Between start and gate of the best path; empty if it is a single curve. */
  [[nodiscard]] const std::vector<geo::Pose>& poses() const { return poses_; }
  [[nodiscard]] std::size_t goal() const { return goal_; }
  /** Nothing is left to gain but height. */
  [[nodiscard]] bool isClear() const { return path_ && weather_ <= kSame; }
  [[nodiscard]] std::int64_t offered() const { return offered_; }
  [[nodiscard]] std::int64_t improved() const { return improved_; }

  /// -log of probabilities nearer than this are the same: one flight in a million.
  static constexpr double kSame = 1e-6;

private:
  bool offerPieces(const std::vector<flight::Piece>& pieces, std::size_t goal, const std::vector<geo::Pose>& poses);
  bool take(std::vector<mission::LandingLeg> legs, double weather, std::size_t goal, const std::vector<geo::Pose>& poses);
  [[nodiscard]] double weatherOnApproach(const landing::Approach& approach, double altitude) const;

  const LandingRequest& request_;
  const LandingGoals& goals_;
  WeatherFlight& flight_;
  std::optional<mission::LandingPath> path_;
  std::vector<geo::Pose> poses_;
  std::size_t goal_ = 0;
  double weather_ = std::numeric_limits<double>::infinity();
  double inHand_ = -std::numeric_limits<double>::infinity();
  std::int64_t offered_ = 0;
  std::int64_t improved_ = 0;
};

}  // namespace vp::emergency
