#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::safety {

enum class Severity { Note, Warning, Violated, Unknown };

/** One finding about a plan: data, not an error. */
struct Finding {
  Severity severity = Severity::Violated;
  std::string rule;    ///< id as listed in core/safety/README.md, for example "glide.clearance"
  std::string text;    ///< one sentence with the numbers, for a pilot
  int tourPoint = -1;  ///< index into Plan::tour, -1 if it concerns the whole plan
  std::optional<geo::LatLon> where;
  std::optional<double> margin;  ///< negative by how much, in the unit of the rule
};

/** Everything the checker found. The certificate exists only if no finding is Violated or Unknown. */
struct SafetyReport {
  std::vector<Finding> findings;
  std::vector<mission::Margin> margins;
  std::optional<mission::Certificate> certificate;
  [[nodiscard]] bool isSafe() const { return certificate.has_value(); }
};

/** A plan and the terrain read afresh for it. */
struct SafetyInput {
  const mission::Plan& plan;
  const terrain::ElevationGrid& terrain;   ///< in the frame of plan.frameOrigin, cells of plan.terrainCell
  std::vector<std::string> terrainSha256;  ///< of the files as they are now, in the order of plan.terrain
};

/** Re-derives the safety of a plan from the plan file and the terrain alone (DESIGN section 2, "Certificate").
 *  Shares no code with the planner: integrates curves itself, walks terrain cells itself. Every bound holds for the
 *  whole curve, not for samples of it. The certificate already in the plan is ignored.
 *  @errors Cancelled   @threads pure */
Result<SafetyReport> check(const SafetyInput& input, const Job& job);

}  // namespace vp::safety
