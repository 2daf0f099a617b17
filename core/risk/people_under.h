#pragma once

#include "core/risk/leg_risk.h"
#include "core/risk/population.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::risk {

/** A number that changes linearly or as a polynomial of up to third degree along part of a leg, weighted onto density: Gauss and Legendre with two
 *  points, exact for that degree. @param weight  (metres along the leg) -> weight */
template <typename Weight>
double weightedDensity(const Stretch& stretch, double from, double to, const Weight& weight) {
  const double a = stretch.from > from ? stretch.from : from;
  const double b = stretch.to < to ? stretch.to : to;
  if (!(b > a)) {
    return 0.0;
  }
  constexpr double kNode = 0.57735026918962576;  // 1 / sqrt(3)
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  return stretch.density * half * (weight(middle - kNode * half) + weight(middle + kNode * half));
}

/** People under a flight, in person seconds: density times the ground that a fall could hit, times how long, the less the higher.
 *
 *  The ground at risk is a circle of `kGroundAtRisk` around the place below: a constant, so that it changes no ordering. Weight: 1 at sea level,
 *  falling linearly to 0 at the crossover altitude and above, [3] (42) with h_c alone, so that legs add up whatever flight they belong to.
 *  Time is that in still air, as in [3] section 4.5.4.
 *  @threads const members are pure */
class PeopleUnder : public LegRisk {
public:
  static constexpr double kGroundAtRisk = 10000.0;  ///< m^2: a hectare, as census figures are thought of; only the unit

  /** @param population  not null   @param airspeed  [m/s], > 0   @param crossover  m MSL, > 0 */
  PeopleUnder(std::shared_ptr<const Population> population, double airspeed, double crossover);

  [[nodiscard]] double of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const override;
  [[nodiscard]] std::string name() const override { return "people under the path"; }
  [[nodiscard]] std::string unit() const override { return "person s/ha"; }

  [[nodiscard]] const std::shared_ptr<const Population>& population() const { return population_; }

private:
  std::shared_ptr<const Population> population_;
  double airspeed_;
  double crossover_;
};

}  // namespace vp::risk
