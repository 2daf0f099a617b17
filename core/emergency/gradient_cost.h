#pragma once

#include "core/emergency/gradient_options.h"
#include "core/geo/pose.h"

namespace vp::emergency {

/** Weights of the four terms, [3] Table 2. */
struct GradientWeights {
  double descent = 0.0;   ///< w_1
  double distance = 0.0;  ///< w_2
  double course = 0.0;    ///< w_3
  double people = 0.0;    ///< w_4
};

/** Where a search begins and what it looks for. */
struct GradientTask {
  geo::Pose start;
  double altitude = 0.0;      ///< h_0, m MSL
  geo::Pose goal;             ///< s_N: where the final approach begins
  double goalAltitude = 0.0;  ///< h_N
  double radius = 0.0;        ///< R [m]
  double optimal = 0.0;       ///< tan(gamma_opt) between start and goal
};

/** The guiding terms of [3] section 4.5 for one task. All lie in [0, 1].  @threads const members are pure */
class GradientCost {
public:
  GradientCost(const GradientTask& task, const GradientOptions& options);

  /** (24): great-circle distance and the turn towards the goal. A guide, not a bound: see leastLength. */
  [[nodiscard]] double guidingLength(const geo::Pose& pose) const;
  /** The shortest way with turns of radius R to the place of the goal, any course there: what (25) prunes by. (24) is longer than this by up to
   *  R where the goal lies abeam, and would prune states from which the goal is reached. */
  [[nodiscard]] double leastLength(const geo::Pose& pose) const;

  [[nodiscard]] double optimalLength() const { return optimalLength_; }  ///< d_opt, (26)
  [[nodiscard]] double outerRadius() const { return outer_; }            ///< (35)

  /** g_d,1 of (27), limited to 1: with steepest descents of more than twice the best glide Lemma 1 does not hold. @param flown  metres from the start
   */
  [[nodiscard]] double descent(double flown, double guiding) const;
  /** g_d,2 of (34), limited to 1. */
  [[nodiscard]] double distance(double guiding) const;
  /** rho of (36). */
  [[nodiscard]] double share(double guiding) const;
  /** The product n . (c(s) - c(s_N)) of (38) [m]: below zero behind the goal, where less than 90 degrees are left to turn. */
  [[nodiscard]] double beyond(geo::Point place) const;
  /** g_chi of (39), (40), each factor limited to zero: as printed, behind the goal and beyond d_opt two negative ones would make a cost. */
  [[nodiscard]] double course(geo::Point place) const;
  /** Table 2. */
  [[nodiscard]] static GradientWeights weights(double course);

  /** (23) without the people. @param course  gets g_chi */
  [[nodiscard]] double guide(const geo::Pose& pose, double flown, double& course) const;

private:
  GradientTask task_;
  double optimalLength_ = 0.0;
  double outer_ = 0.0;
  double inner_ = 0.0;
};

}  // namespace vp::emergency
