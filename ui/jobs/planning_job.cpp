#include "ui/jobs/planning_job.h"

#include "core/aircraft/glide_model.h"
#include "core/formats/mission_loader.h"
#include "core/mission/glide_conditions.h"

#include <QCoreApplication>
#include <QString>

namespace vp::jobs {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(PlanningSketch)
};

}  // namespace

Result<safety::SafetyReport> checkPlan(const mission::Plan& plan, const Job& job) {
  std::vector<std::string> checksums;
  const Result<terrain::ElevationGrid> terrain = formats::readPlanTerrain(plan, "", checksums, job.part(0.0, 0.4));
  if (!terrain) {
    return forward(terrain);
  }
  return safety::check({plan, *terrain, checksums}, job.part(0.4, 1.0));
}

Result<PlannedTour> planAndVerify(tour::Planner& planner, const tour::PlanInput& input, const SketchBuilder::Publish& publish, const Job& job) {
  PlannedTour planned;
  SketchBuilder sketches(aircraft::GlideModel(input.mission.aircraft, mission::glideConditionsOf(input.mission, input.sites)).tourRadius(), publish);
  Result<mission::Plan> plan = planner.plan(input, job.part(0.0, 0.85), nullptr, sketches.observer(), &planned.why);
  if (!plan) {
    if (plan.error().code == Errc::Cancelled) {
      return forward(plan);
    }
    planned.failure = plan.error();
    return planned;
  }
  planned.reused = planner.reused();
  job.progress(0.85, Words::tr("checking the plan").toStdString());
  Result<safety::SafetyReport> report = checkPlan(*plan, job.part(0.85, 1.0));
  if (!report) {
    return forward(report);
  }
  plan->certificate = report->certificate;
  planned.report = std::move(*report);
  planned.plan = std::make_shared<const mission::Plan>(std::move(*plan));
  return planned;
}

PlanningOutcome outcomeOf(const Result<PlannedTour>& result) {
  using Kind = PlanningOutcome::Kind;
  PlanningOutcome outcome;
  if (!result) {
    outcome.kind = result.error().code == Errc::Cancelled ? Kind::Cancelled : Kind::Failed;
    outcome.error = result.error();
    return outcome;
  }
  outcome.report = result->report;
  outcome.isTourReused = result->reused.tour;
  if (result->failure) {
    outcome.kind = Kind::Failed;
    outcome.error = result->failure;
    outcome.missingHeight = result->why.missingHeight;
    outcome.target = result->why.target;
  } else {
    outcome.kind = result->report.isSafe() ? Kind::Verified : Kind::Refused;
  }
  return outcome;
}

}  // namespace vp::jobs
