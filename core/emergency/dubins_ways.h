#pragma once

#include "core/emergency/descent_flight.h"
#include "core/emergency/gradient_cost.h"
#include "core/flight/curve.h"

#include <array>
#include <optional>
#include <vector>

namespace vp::emergency {

using Pieces = std::vector<flight::Piece>;

/** One Dubins way of a turn, a straight and a turn, if that type connects the poses. @param type  0..3: LSL, RSR, LSR, RSL, [3] (8) */
std::optional<Pieces> dubinsWay(const geo::Pose& from, const geo::Pose& to, double radius, std::size_t type);

inline constexpr std::size_t kDubinsTypes = 4;

/** Ways to one goal that lose as much height as there is. The four Dubins types have the lengths that they have; where height is left over, two
 *  families of longer ones are searched for the one that loses it at the optimal slope, half-way between best glide and steepest descent:
 *  - extended: the type to a place further out on the final course, then straight to the goal;
 *  - S-turns: by a place abeam of the middle between start and goal, to the left or to the right, passed on the course between the two
 *    ([3] section 6.3, after Atkins, Portillo, Strube 2006).
 *  @threads as DescentFlight */
class DubinsWays {
public:
  /** @param radius  of all turns [m]   @param goal, goalAltitude  where the way ends; it must not end lower */
  DubinsWays(DescentFlight& flight, const geo::Pose& goal, double goalAltitude, double radius)
      : flight_(&flight), goal_(goal), goalAltitude_(goalAltitude), radius_(radius) {}

  /** The four types as they are; only those whose best glide arrives. */
  void direct(const geo::Pose& from, double altitude, std::vector<Pieces>& out);
  /** One type: as it is where its range of slopes fits, extended where there is height left over; none if it arrives too low or cannot lose enough.
   */
  std::optional<Pieces> fitted(const geo::Pose& from, double altitude, std::size_t type);
  /** S-turns to both sides; none where the direct way needs no lengthening. */
  void sTurns(const geo::Pose& from, double altitude, std::vector<Pieces>& out);

  [[nodiscard]] double radius() const { return radius_; }

private:
  /// Height above the goal at the end of pieces with a share of the range of slopes; negative infinity without a glide.
  double left(const geo::Pose& from, double altitude, const Pieces& pieces, double share);
  /// The member of a family that ends at the goal's altitude at the optimal slope; its members get longer with the parameter, but for jumps.
  template <typename Family>
  std::optional<Pieces> fit(const geo::Pose& from, double altitude, double first, double most, const Family& family);

  DescentFlight* flight_;
  geo::Pose goal_;
  double goalAltitude_;
  double radius_;
};

}  // namespace vp::emergency
