#pragma once

// Random intervals between two decision points, judged by the checker and by brute force.

#include "core/aircraft/glide_model.h"
#include "core/safety/witness_check.h"
#include "tests/core/safety/plan_fixture.h"
#include "tests/support/path_check.h"

#include <limits>
#include <random>

namespace vp::test {

/// Margin of the worst engine failure anywhere on an interval, by brute force: fail at each of `count` places, where what a
/// reaction loses is lost at once, glide along the tour to the next point watching the ground `near` metres around, and be there not below what its
/// glide needs.
inline double worstFailure(const mission::Plan& plan, std::size_t index, const terrain::ElevationGrid& grid, double required, int count,
                           double near) {
  const aircraft::GlideModel model(plan.mission.aircraft);
  const mission::DecisionPoint& from = plan.tour[index];
  const mission::DecisionPoint& to = plan.tour[(index + 1) % plan.tour.size()];
  const double length = from.onward.length;
  const double rate = model.lossAt(from.onward.radius);
  const auto points = test::fly(from.pose, {from.onward}, length / count);
  std::vector<double> ground;
  for (const test::FlownPoint& point : points) {
    ground.push_back(test::groundNear(grid, point.x, point.y, near) + plan.mission.safety.clearance.si());
  }
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double altitude = from.altitude + (to.altitude - from.altitude) * points[i].distance / length - plan.mission.safety.reactionLoss.si();
    for (std::size_t k = i; k < points.size(); ++k) {
      const double height = altitude - rate * (points[k].distance - points[i].distance);
      worst = std::min(worst, height - ground[k]);
    }
    worst = std::min(worst, altitude - rate * (length - points[i].distance) - required);
  }
  return worst;
}

struct IntervalCases {
  std::uint64_t seed = 0;
  int count = 0;
  double altitudes = 0.0;                  ///< m, that the first point is higher than 120 m MSL at most
  std::optional<double> mostReactionLoss;  ///< m; none: a failure loses nothing at once
};

/// One interval of a two-point tour over random ground; everything else about it is wrong, and only its own findings are read. Fails the test where
/// checker and brute force differ.
inline void judgeRandomIntervals(const IntervalCases& cases) {
  qInfo("seed %llu, %d cases", static_cast<unsigned long long>(cases.seed), cases.count);
  std::mt19937_64 random(cases.seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlanBuilder builder;
  mission::Plan plan = builder.plan();
  const aircraft::GlideModel model(plan.mission.aircraft);
  const mission::DecisionPoint sample = plan.tour[0];
  plan.sites[0].site.elevation = geo::HeightMsl::fromMetres(-1000.0);
  int broken = 0;
  int kept = 0;
  for (int number = 0; number < cases.count; ++number) {
    std::vector<float> values(24 * 24);
    for (float& value : values) {
      value = static_cast<float>(20.0 * unit(random));
    }
    const terrain::ElevationGrid grid(-600.0, -600.0, 50.0, 24, 24, values);
    if (cases.mostReactionLoss) {
      plan.mission.safety.reactionLoss = Length::fromSi(*cases.mostReactionLoss * unit(random));
    }
    const auto turn = static_cast<flight::Turn>(static_cast<int>(unit(random) * 3.0) - 1);
    mission::DecisionPoint from = sample;
    from.pose = {200.0 * unit(random) - 100.0, 200.0 * unit(random) - 100.0, 6.0 * unit(random)};
    from.onward = {turn, turn == flight::Turn::Straight ? 0.0 : 70.0 + 300.0 * unit(random), 20.0 + 150.0 * unit(random)};
    from.altitude = 120.0 + cases.altitudes * unit(random);
    mission::DecisionPoint to = sample;
    const FlownPoint end = test::fly(from.pose, {from.onward}, 5.0).back();
    to.pose = {end.x, end.y, wrapTwoPi(end.heading)};
    to.altitude = from.altitude + 30.0 * (unit(random) - 0.5);
    to.witness.pieces = {{flight::Turn::Straight, 0.0, 150.0 * unit(random)}};
    plan.tour = {from, to};
    const double required = safety::requiredStartHeight(to.pose, to.witness.pieces, -950.0, grid, 100.0, model);
    if (!(to.altitude >= required + plan.mission.safety.reactionLoss.si() + 0.01)) {
      continue;  // the glide of the next point has rules of its own, which stand in for the interval's
    }
    bool found = false;
    for (const safety::Finding& finding : checkedPlan(plan, grid).findings) {
      found = found || (finding.tourPoint == 0 && (finding.rule.starts_with("between.") || finding.rule == "tour.clearance"));
    }
    const double worst = worstFailure(plan, 0, grid, required, 60, 0.0);  // samples are less than 3 m apart, so the truth lies between
    const double bound = worstFailure(plan, 0, grid, required, 60, 3.0) - 1.0;
    const QByteArray label = QString("case %1: worst margin between %2 and %3, %4").arg(number).arg(bound).arg(worst).arg(found).toUtf8();
    if (worst < -0.0011) {
      ++broken;
      QVERIFY2(found, label);
    } else if (bound > 0.0) {
      ++kept;
      QVERIFY2(!found, label);
    }
  }
  qInfo("%d broken, %d kept", broken, kept);
  QVERIFY(broken > 1000);
  QVERIFY(kept > 500);
}

}  // namespace vp::test
