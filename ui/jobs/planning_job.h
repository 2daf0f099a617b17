#pragma once

#include "core/tour/replan.h"
#include "ui/jobs/planning_outcome.h"
#include "ui/jobs/sketch_builder.h"

#include <memory>

namespace vp::jobs {

/** What planning on a worker brought: a plan with the checker's report, or why there is none. */
struct PlannedTour {
  std::shared_ptr<const mission::Plan> plan;  ///< with the certificate if the checker gave one; null if none was found
  safety::SafetyReport report;
  std::optional<Error> failure;
  tour::PlanFailure why;
  tour::PlanReuse reused;  ///< what the plan took over from the one before
};

/** Plans, then has the checker judge the plan over the terrain read afresh from its files, as `volplane-cli plan` does.
 *  @param planner  keeps between calls what an edit leaves valid; of one job at a time
 *  A mission without a safe tour is no error of this function but a PlannedTour with `failure`. @errors Cancelled, Internal */
Result<PlannedTour> planAndVerify(tour::Planner& planner, const tour::PlanInput& input, const SketchBuilder::Publish& publish, const Job& job);

/** Has the checker judge a plan over the terrain read afresh from the files that it names. @errors of the readers, Cancelled */
Result<safety::SafetyReport> checkPlan(const mission::Plan& plan, const Job& job);

/** The outcome for the operator, its time left open. */
PlanningOutcome outcomeOf(const Result<PlannedTour>& result);

}  // namespace vp::jobs
