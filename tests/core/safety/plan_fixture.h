#pragma once

// A plan made for its mission's own conditions, for tests of the checker's rules: glides, safe altitudes and approaches fit the settings.

#include "core/geo/local_frame.h"
#include "core/safety/checker.h"
#include "core/safety/glide_rates.h"
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

inline QByteArray textsOfFindings(const safety::SafetyReport& report) {
  QByteArray texts;
  for (const safety::Finding& finding : report.findings) {
    texts += "\n" + QByteArray::fromStdString(finding.rule + ": " + finding.text);
  }
  return texts;
}

}  // namespace vp::test
