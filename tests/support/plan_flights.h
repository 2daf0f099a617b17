#pragma once
// Engine failures on a plan at random places and on random days of its mission, flown to the end (condition_flight.h).

#include "core/aircraft/glide_model.h"
#include "tests/support/condition_flight.h"

#include <QString>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace vp::test {

/// The path of decision points from one of them on, a few kilometres at most.
inline std::vector<flight::Piece> pathFrom(const std::vector<mission::DecisionPoint>& points, std::size_t from, bool isClosed) {
  std::vector<flight::Piece> path;
  for (std::size_t i = 0; i < 40 && (isClosed || from + i < points.size()); ++i) {
    path.push_back(points[(from + i) % points.size()].onward);
  }
  return path;
}

class Flights {
public:
  Flights(const mission::Plan& plan, const terrain::ElevationGrid& terrain)
      : plan_(plan),
        terrain_(terrain),
        conditions_(mission::glideConditionsOf(plan.mission, plan.sites)),
        model_(plan.mission.aircraft, conditions_) {}

  /// The engine stops at random places of a path on random days. @return what went wrong
  QString fly(const std::vector<mission::DecisionPoint>& points, std::size_t first, bool isClosed, int times) {
    const std::size_t last = isClosed ? points.size() - 1 : points.size() - 2;
    for (int i = 0; i < times; ++i) {
      const std::size_t at = first + std::uniform_int_distribution<std::size_t>(0, last - first)(random_);
      const double part = i % 2 == 0 ? 0.0 : std::uniform_real_distribution<double>(0.0, 1.0)(random_);
      const QString wrong = failAt(points, at, part, isClosed);
      if (!wrong.isEmpty()) {
        return QString("point %1 + %2: %3").arg(at).arg(part).arg(wrong);
      }
    }
    return {};
  }

private:
  QString failAt(const std::vector<mission::DecisionPoint>& points, std::size_t at, double part, bool isClosed) {
    const mission::DecisionPoint& from = points[at];
    const std::size_t nextAt = (at + 1) % points.size();
    const mission::DecisionPoint& next = points[nextAt];
    geo::Pose pose = from.pose;
    std::vector<flight::Piece> pieces = from.witness.pieces;
    if (part > 0.0) {
      const Outcome there = test::fly(polarOf(plan_.mission.aircraft), {}, from.pose, 0.0,
                                      {{from.onward.turn, from.onward.radius, part * from.onward.length}}, terrain_, 0.0, 0.01);
      pose = there.end;
      pieces = {{from.onward.turn, from.onward.radius, (1.0 - part) * from.onward.length}};
      pieces.insert(pieces.end(), next.witness.pieces.begin(), next.witness.pieces.end());
    }
    const mission::Witness& proof = part > 0.0 ? next.witness : from.witness;
    const std::size_t proofAt = part > 0.0 ? nextAt : at;
    if (turnsTooEarly(pathFrom(points, proofAt, isClosed), proof.pieces, plan_.mission.safety.reactionTime.si() * model_.mostGroundSpeed())) {
      return "turns too early";
    }
    const double altitude = from.altitude + part * (next.altitude - from.altitude) - plan_.mission.safety.reactionLoss.si();
    const Day day = dayOf(plan_.mission, random_);
    return judge(flyGlide(plan_, conditions_, day, terrain_, pose, altitude, pieces), plan_.sites.at(static_cast<std::size_t>(proof.site)));
  }

  [[nodiscard]] QString judge(const ConditionOutcome& outcome, const mission::SiteInFrame& site) const {
    const mission::ApproachSettings& asked = plan_.mission.approach;
    const double elevation = site.site.elevation.metres();
    const double arrival = outcome.endAltitude - elevation - plan_.mission.safety.arrivalMargin.si();
    if (outcome.leastSpare < -1e-3 || arrival < -1e-3) {
      return QString("spare %1, arrival %2").arg(outcome.leastSpare).arg(arrival);
    }
    if (geo::distance(outcome.end.point(), site.pose.point()) > 0.05 || std::abs(wrapPi(outcome.end.heading - site.pose.heading)) > 1e-3) {
      return "ends beside the runway";
    }
    if (asked.kind == mission::ApproachKind::Straight && !outcome.isGateStraight) {
      return "turns on its final";
    }
    if (asked.kind == mission::ApproachKind::Overhead && (geo::distance(outcome.gate.point(), site.pose.point()) > 0.05 ||
                                                          outcome.gateAltitude - elevation < asked.keyHeight.value_or(Length()).si() - 1e-3)) {
      return QString("at high key only %1 m above the runway").arg(outcome.gateAltitude - elevation);
    }
    return {};
  }

  const mission::Plan& plan_;
  const terrain::ElevationGrid& terrain_;
  aircraft::GlideConditions conditions_;
  aircraft::GlideModel model_;
  std::mt19937_64 random_{99};
};

}  // namespace vp::test
