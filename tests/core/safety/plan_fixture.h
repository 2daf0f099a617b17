#pragma once

// A plan made for its mission's own conditions, for tests of the checker's rules: glides, safe altitudes and approaches fit the settings.

#include "core/geo/local_frame.h"
#include "core/safety/checker.h"
#include "core/safety/glide_rates.h"
#include "core/safety/plan_conditions.h"
#include "core/safety/witness_check.h"
#include "tests/core/safety/wind_cases.h"
#include "tests/support/plan_builder.h"

#include <QByteArray>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace vp::test {

struct PlanFixture {
  PlanBuilder builder;
  TestTerrain terrain;

  mission::Plan& plan() { return builder.plan(); }
  mission::Mission& mission() { return builder.plan().mission; }
  mission::DecisionPoint& point(std::size_t index) { return builder.plan().tour[index]; }

  /// The last part of every glide, as the approach asks for it, where that is one.
  [[nodiscard]] std::vector<flight::Piece> lastPart(safety::GlideRates& rates) const {
    const mission::ApproachSettings& approach = builder.plan().mission.approach;
    switch (approach.kind) {
      case mission::ApproachKind::Straight:
        return {{flight::Turn::Straight, 0.0, approach.finalLength.si()}};
      case mission::ApproachKind::Overhead:
        return {{flight::Turn::Left, rates.leastGlideRadius(), 2.0 * Angle::kPi * rates.leastGlideRadius()}};
      case mission::ApproachKind::Threshold:
        break;
    }
    return {};
  }
  /// Pieces of a glide from a point: straight for the reaction, then to the gate, then the approach.
  [[nodiscard]] std::vector<flight::Piece> glideFrom(const geo::Pose& pose, safety::GlideRates& rates) const {
    const double ahead = builder.plan().mission.safety.reactionTime.si() * rates.fastestOverGround();
    const geo::Pose turns{pose.x + ahead * std::cos(pose.heading), pose.y + ahead * std::sin(pose.heading), pose.heading};
    const geo::Pose gate = safety::gateOf(builder.plan().sites[0].pose, builder.plan().mission.approach);
    std::vector<flight::Piece> pieces = glideTo(turns, gate, rates.leastGlideRadius());
    pieces.insert(pieces.begin(), {flight::Turn::Straight, 0.0, ahead});
    const std::vector<flight::Piece> last = lastPart(rates);
    pieces.insert(pieces.end(), last.begin(), last.end());
    return pieces;
  }
  /// The glide of one point and its safe altitude, as the mission is now.
  void setGlide(std::size_t index, const std::vector<flight::Piece>& pieces, safety::GlideRates& rates) {
    point(index).witness.pieces = pieces;
    point(index).safeAltitude = safety::requiredStartHeight(point(index).pose, pieces, plan().sites[0].site, mission(), terrain.grid(), rates);
  }
  /// All of them.
  void refit() {
    safety::GlideRates rates(safety::conditionsOf(plan()), mission().aircraft);
    for (std::size_t i = 0; i < plan().tour.size(); ++i) {
      setGlide(i, glideFrom(point(i).pose, rates), rates);
    }
  }
  /// Lowest flat tour altitude at which no glide is too low, plus `extra`.
  void flyLow(double extra) { builder.flyAt(builder.highestSafeAltitude() + extra); }
  /// The point with the highest safe altitude.
  std::size_t highest() {
    std::size_t best = 0;
    for (std::size_t i = 0; i < plan().tour.size(); ++i) {
      best = point(i).safeAltitude > point(best).safeAltitude ? i : best;
    }
    return best;
  }
  void raise(std::size_t index, double metres) {
    point(index).altitude += metres;
    builder.updateMetrics();
  }
};

inline safety::SafetyReport checkedPlan(const mission::Plan& plan, const terrain::ElevationGrid& grid) {
  return safety::check({plan, grid, {std::string(64, 'a')}}, Job()).value();
}

inline safety::SafetyReport checkedPlan(PlanFixture& fixture) {
  return checkedPlan(fixture.plan(), fixture.terrain.grid());
}

/// Rules that are violated or unknown, in alphabetical order.
inline std::string rulesBroken(const safety::SafetyReport& report) {
  std::set<std::string> rules;
  for (const safety::Finding& finding : report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      rules.insert(finding.rule);
    }
  }
  std::string text;
  for (const std::string& rule : rules) {
    text += (text.empty() ? "" : " ") + rule;
  }
  return text;
}

/// A margin of a report; NaN if there is none of this kind.
inline double marginOf(const safety::SafetyReport& report, const std::string& kind) {
  for (const mission::Margin& margin : report.margins) {
    if (margin.kind == kind) {
      return margin.value;
    }
  }
  return std::nan("");
}

inline QByteArray textsOfFindings(const safety::SafetyReport& report) {
  QByteArray texts;
  for (const safety::Finding& finding : report.findings) {
    texts += "\n" + QByteArray::fromStdString(finding.rule + ": " + finding.text);
  }
  return texts;
}

}  // namespace vp::test
