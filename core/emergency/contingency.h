#pragma once

#include "core/emergency/best_descent.h"
#include "core/emergency/gradient_options.h"
#include "core/emergency/gradient_search.h"
#include "core/emergency/holding_areas.h"
#include "core/risk/descent_risk.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::emergency {

/** What [3] section 5.2 plans for one runway: Algorithm 1 and the Dubins ways beside it.
 *  @threads one thread at a time; several objects may share request and options. All outlive it */
class Contingency {
public:
  Contingency(const LandingRequest& request, const landing::Approach& approach, const GradientOptions& options, const HoldingAreas* areas);

  /** Four Dubins types and S-turns, of least risk ([3] sections 5.2 and 6.3), with radii from the search's down to the tightest of the glide: wide
   *  turns first, tighter ones only where none fits. Found once. @return the best, if any */
  const BestDescent& dubins();

  /** Algorithm 1: at or below the crossover altitude the search from where the aircraft is; above it the shortest way to the best holding areas,
   * circles there down to the outbound altitude, and the search from there; where the way to the hold comes below the crossover altitude, the search
   * from where it does. @param limits  of each search */
  const BestDescent& search(const GradientLimits& limits, const Countdown& countdown);

  [[nodiscard]] const GradientCount& count() const { return count_; }
  /** Whether the search's best way holds. */
  [[nodiscard]] bool isHolding() const { return isHolding_; }
  /** What the guide takes the population risk from; null if the request's risk is no population. */
  [[nodiscard]] const std::shared_ptr<const risk::DescentRisk>& people() const { return people_; }

private:
  void searchFrom(const Pieces& before, const GradientLimits& limits, const Countdown& countdown, bool isHold);
  void searchByHold(const HoldingArea& area, const GradientLimits& limits, const Countdown& countdown);
  /// The part of pieces flown from the start that ends where an altitude is reached at the optimal slope.
  Pieces downTo(const Pieces& pieces, double altitude);
  [[nodiscard]] double shareFrom(const geo::Pose& pose, double altitude);
  [[nodiscard]] double crossover() const;

  const LandingRequest* request_;
  const landing::Approach* approach_;
  const GradientOptions* options_;
  const HoldingAreas* areas_;
  DescentFlight flight_;
  double radius_;
  std::shared_ptr<const risk::DescentRisk> people_;
  BestDescent direct_;
  BestDescent found_;
  GradientCount count_;
  bool isHolding_ = false;
};

/** Radius of the search's turns in a world: GradientOptions::turnBank in the strongest wind from behind, not below the widest of the glide. */
double searchRadius(const landing::World& world, const GradientOptions& options);

/** The population risk of [3] (44) for a descent from an altitude to a gate; null if the risk is no population (PeopleUnder, DescentRisk), or the
 *  aircraft is at the gate's altitude already. */
std::shared_ptr<const risk::DescentRisk> descentRiskOf(const LandingRequest& request, const landing::Approach& approach,
                                                       const GradientOptions& options);

}  // namespace vp::emergency
