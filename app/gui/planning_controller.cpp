#include "app/gui/planning_controller.h"

#include "app/gui/edit_controller.h"
#include "ui/jobs/planning_job.h"

#include <cmath>

namespace vp::gui {

using dialogs::MessageBanner;

PlanningController::PlanningController(jobs::Workspace& workspace, EditController& edits, MessageBanner& banner, QObject* parent)
    : QObject(parent), workspace_(workspace), edits_(edits), banner_(banner) {
  connect(&workspace_, &jobs::Workspace::planningEnded, this, &PlanningController::ended);
  connect(&workspace_.document(), &document::MissionDocument::replaced, this, [this] { recheckWanted_ = true; });
  connect(&workspace_, &jobs::Workspace::situationChanged, this, &PlanningController::recheck);
  connect(&workspace_, &jobs::Workspace::activityChanged, this, [this] {
    if (planAfterLoading_ && workspace_.activity() == jobs::Workspace::Activity::Idle) {
      planAfterLoading_ = false;
      plan();
    }
  });
}

void PlanningController::recheck() {
  const auto plan = workspace_.document().plan();
  if (!recheckWanted_ || !workspace_.situation().plan || !plan) {
    return;
  }
  recheckWanted_ = false;
  if (plan->certificate) {
    checker_.start<safety::SafetyReport>([plan](const Job& job) { return jobs::checkPlan(*plan, job); },
                                         [this, plan](const Result<safety::SafetyReport>& result) { rechecked(result, plan); });
  }
}

void PlanningController::rechecked(const Result<safety::SafetyReport>& result, const std::shared_ptr<const mission::Plan>& plan) {
  if (workspace_.document().plan() != plan) {
    return;  // another one by now
  }
  if (result && result->isSafe()) {
    emit reportReady(*result);
    return;
  }
  auto claimed = std::make_shared<mission::Plan>(*plan);
  claimed->certificate.reset();
  workspace_.document().setPlan(std::move(claimed));
  if (!result) {
    banner_.show(MessageBanner::Kind::Failure,
                 tr("The plan in this file could not be checked and counts as unverified: %1").arg(QString::fromStdString(result.error().message())));
    return;
  }
  jobs::PlanningOutcome outcome;
  outcome.report = *result;
  showRefusal(outcome);
}

void PlanningController::plan() {
  banner_.hide();
  const Result<void> started = workspace_.startPlanning();
  if (!started) {
    banner_.show(MessageBanner::Kind::Warning, QString::fromStdString(started.error().message()));
  }
}

void PlanningController::cancel() {
  planAfterLoading_ = false;
  workspace_.cancelPlanning();
}

void PlanningController::editAndPlan(const std::function<void()>& edit) {
  edit();
  if (workspace_.activity() == jobs::Workspace::Activity::Loading) {
    planAfterLoading_ = true;  // the runways are being read again
  } else {
    plan();
  }
}

void PlanningController::ended(const jobs::PlanningOutcome& outcome) {
  using Kind = jobs::PlanningOutcome::Kind;
  switch (outcome.kind) {
    case Kind::Verified:
      showSuccess(outcome);
      break;
    case Kind::Refused:
      showRefusal(outcome);
      break;
    case Kind::Failed:
      showFailure(outcome);
      break;
    case Kind::Cancelled:
      banner_.show(MessageBanner::Kind::Hint, tr("Planning was stopped; the mission is as it was."), {{tr("Plan again"), [this] { plan(); }}});
      break;
  }
}

void PlanningController::showSuccess(const jobs::PlanningOutcome& outcome) {
  const auto plan = workspace_.document().plan();
  if (!plan) {
    return;
  }
  const style::Units units = workspace_.view().units();
  QString text = tr("Verified: from every point of this %1 tour the aircraft can glide to a runway. Planned in %2 s.")
                     .arg(units.distance(plan->metrics.length), QString::number(outcome.seconds, 'f', 1));
  const auto warnings = plan->certificate ? plan->certificate->warnings.size() : 0;
  if (warnings > 0) {
    text += QLatin1Char(' ') + tr("%n warning(s) to read in the plan panel.", nullptr, static_cast<int>(warnings));
  }
  banner_.show(warnings > 0 ? MessageBanner::Kind::Warning : MessageBanner::Kind::Success, text);
  emit reportReady(outcome.report);
}

void PlanningController::showRefusal(const jobs::PlanningOutcome& outcome) {
  QString first;
  for (const safety::Finding& finding : outcome.report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      first = QString::fromStdString(finding.text);
      break;
    }
  }
  banner_.show(MessageBanner::Kind::Failure, tr("The independent checker refuses this plan; do not fly it. %1").arg(first));
  emit reportReady(outcome.report);
}

void PlanningController::showFailure(const jobs::PlanningOutcome& outcome) {
  const mission::Mission& mission = workspace_.document().mission();
  const style::Units units = workspace_.view().units();
  std::vector<MessageBanner::Action> remedies;
  if (outcome.missingHeight && std::isfinite(*outcome.missingHeight)) {
    const bool missionLimits =
        mission.ceiling && (!mission.aircraft.ceiling || mission.ceiling->metres() + *outcome.missingHeight <= mission.aircraft.ceiling->metres());
    if (missionLimits) {
      const double by = std::ceil(units.heightFromSi(*outcome.missingHeight) / 10.0 + 1.0) * 10.0;  // a round figure above it
      const double metres = units.heightToSi(by);
      remedies.push_back(
          {tr("Raise ceiling by %1").arg(units.height(metres)), [this, metres] { editAndPlan([this, metres] { edits_.raiseCeiling(metres); }); }});
    } else {
      remedies.push_back({tr("Aircraft…"), [this] { edits_.editAircraft(); }});
    }
  }
  if (mission.planner.lowTargets == mission::LowTargets::Descend) {
    remedies.push_back({tr("Allow passing above"), [this] { editAndPlan([this] { edits_.allowPassingAbove(); }); }});
  }
  const mission::SiteFilter& filter = mission.siteFilter;
  if (!filter.exclude.empty() || !filter.oneWay.empty() || filter.minLength || !filter.approximate) {
    remedies.push_back({tr("Include excluded runways"), [this] { editAndPlan([this] { edits_.includeAllSites(); }); }});
  }
  if (outcome.target >= 0 && static_cast<std::size_t>(outcome.target) < mission.targets.size()) {
    const int target = outcome.target;
    workspace_.view().selectTarget(target);
    const QString name = QString::fromStdString(mission.targets[static_cast<std::size_t>(target)].name);
    remedies.push_back({tr("Delete target %1").arg(name), [this, target] { edits_.removeTarget(target); }});
  }
  const QString text = outcome.error ? QString::fromStdString(outcome.error->message()) : tr("Planning failed.");
  banner_.show(MessageBanner::Kind::Failure, text, remedies);
}

}  // namespace vp::gui
