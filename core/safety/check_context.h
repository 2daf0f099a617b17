#pragma once

// Inside of core/safety: the rules, one function per group, and what they share. Order and meaning: checker.cpp.

#include "core/aircraft/glide_model.h"
#include "core/base/job.h"
#include "core/safety/checker.h"
#include "core/safety/findings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace vp::safety {

inline constexpr double kNoHeight = std::numeric_limits<double>::infinity();

/** One plan being checked. */
struct CheckContext {
  explicit CheckContext(const SafetyInput& in) : terrain(in.terrain), input(in), plan(in.plan), frame(in.plan.frameOrigin), findings(frame) {}

  const terrain::ElevationGrid& terrain;
  const SafetyInput& input;
  const mission::Plan& plan;
  geo::LocalFrame frame;
  Findings findings;
  Margins margins;
  aircraft::GlideModel model;    ///< set by checkProfile
  double clearance = 0.0;        ///< m, set by checkSettings
  double arrivalMargin = 0.0;    ///< m, set by checkSettings
  std::vector<double> required;  ///< A_w of every decision point's witness, m MSL; kNoHeight if it has none. Set by checkGlides
  std::vector<bool> tooLow;      ///< found to be too low for its own glide. Set by checkGlides
  std::vector<bool> siteUsed;    ///< by a witness. Set by checkGlides

  [[nodiscard]] std::size_t next(std::size_t point) const { return point + 1 == plan.tour.size() ? 0 : point + 1; }
  [[nodiscard]] FindingPlace at(std::size_t point) const { return {static_cast<int>(point), plan.tour[point].pose.point()}; }
};

/** Numbers, indices, pieces, aircraft, settings, terrain identity: false if the rest cannot be checked. */
bool checkStructure(CheckContext& context);

/** Sites and targets of the plan against the embedded mission, the frame and the terrain. */
void checkSites(CheckContext& context);
void checkTargets(CheckContext& context);

/** Witness of every decision point; fills context.required. Stops early when asked to. */
void checkGlides(CheckContext& context, const Job& job);

/** Every interval of the tour, and what happens between its decision points. Stops early when asked to. */
void checkTour(CheckContext& context, const Job& job);

/** Visits of targets and their spirals, then lengths and costs. */
void checkVisits(CheckContext& context);
void checkMetrics(CheckContext& context);

/** What to tell a pilot although nothing is violated. */
void addWarnings(CheckContext& context);
mission::Certificate issueCertificate(const CheckContext& context, const std::vector<Finding>& findings, const std::vector<mission::Margin>& margins);

}  // namespace vp::safety
