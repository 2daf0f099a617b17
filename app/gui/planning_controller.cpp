#include "app/gui/planning_controller.h"

#include "app/gui/edit_controller.h"
#include "core/mission/glide_conditions.h"
#include "ui/jobs/planning_job.h"
#include "ui/style/core_text.h"

#include <cmath>

namespace vp::gui {
namespace {

constexpr double kRaiseBlindly = 100.0;  // m, a step to try where the planner cannot say how much is missing

}  // namespace

using dialogs::MessageBanner;

PlanningController::PlanningController(jobs::Workspace& workspace, EditController& edits, MessageBanner& banner, QObject* parent)
    : QObject(parent), workspace_(workspace), edits_(edits), banner_(banner) {
  connect(&workspace_, &jobs::Workspace::planningEnded, this, &PlanningController::ended);
  connect(&workspace_, &jobs::Workspace::loadingFailed, this, [this](const Error& error) {
    Actions remedies;
    if (error.code == Errc::OutOfRange && isFilterStrict()) {  // the filter names a runway that is gone with its file
      remedies.push_back({tr("Include excluded runways"), [this] { edits_.includeAllSites(); }});
    }
    banner_.show(MessageBanner::Kind::Failure, style::coreText(error), remedies);
  });
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
                 tr("The plan in this file could not be checked and counts as unverified: %1").arg(style::coreText(result.error())));
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
    Actions remedies;
    if (started.error().code != Errc::MissingTerrain && isFilterStrict()) {
      remedies.push_back(includeRunways());
    }
    banner_.show(MessageBanner::Kind::Warning, style::coreText(started.error()), remedies);
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
  QString text;
  Actions actions;
  if (plan->spirals.empty()) {
    text = tr("Verified: from every point of this %1 tour the aircraft can glide to a runway.").arg(units.distance(plan->metrics.length));
  } else {
    text = tr("Verified, but for the spirals down to %n target(s), in which the gliding guarantee is suspended; this tour is %1 long.", nullptr,
              static_cast<int>(plan->spirals.size()))
               .arg(units.distance(plan->metrics.length));
    actions.push_back(passAbove());
  }
  text += QLatin1Char(' ') + tr("Planned in %1 s.").arg(QString::number(outcome.seconds, 'f', 1));
  if (outcome.isTourReused) {
    text += QLatin1Char(' ') + tr("Your edit was placed into the tour before; planning once more searches the whole anew.");
  }
  const auto warnings = plan->certificate ? plan->certificate->warnings.size() : 0;
  if (warnings > 0) {
    text += QLatin1Char(' ') + tr("%n warning(s) to read in the plan panel.", nullptr, static_cast<int>(warnings));
  }
  banner_.show(warnings > 0 ? MessageBanner::Kind::Warning : MessageBanner::Kind::Success, text, actions);
  emit reportReady(outcome.report);
}

void PlanningController::showRefusal(const jobs::PlanningOutcome& outcome) {
  QString first;
  for (const safety::Finding& finding : outcome.report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      first = workspace_.view().units().inSentence(finding.text);
      break;
    }
  }
  Actions actions;
  if (const auto plan = workspace_.document().plan(); plan && !plan->spirals.empty()) {
    actions.push_back(passAbove());
  }
  banner_.show(MessageBanner::Kind::Failure, tr("The independent checker refuses this plan; do not fly it. %1").arg(first), actions);
  emit reportReady(outcome.report);
}

MessageBanner::Action PlanningController::passAbove() {
  return {tr("Allow passing above"), [this] { editAndPlan([this] { edits_.allowPassingAbove(); }); }};
}

MessageBanner::Action PlanningController::includeRunways() {
  return {tr("Include excluded runways"), [this] { editAndPlan([this] { edits_.includeAllSites(); }); }};
}

bool PlanningController::isFilterStrict() const {
  const mission::SiteFilter& filter = workspace_.document().mission().siteFilter;
  return !filter.exclude.empty() || !filter.oneWay.empty() || filter.minLength || filter.minWidth || !filter.surfaces.empty() || filter.lighted ||
         filter.maxDistance || !filter.approximate;
}

std::optional<PlanningController::Limit> PlanningController::limit() const {
  const mission::Mission& mission = workspace_.document().mission();
  const std::optional<geo::HeightMsl> ceiling = mission::ceilingOf(mission);
  if (!ceiling) {
    return std::nullopt;
  }
  const bool isOwn = mission.ceiling == ceiling;
  return Limit{isOwn ? Whose::Mission : mission.aircraft.ceiling == ceiling ? Whose::Aircraft : Whose::Nobody, ceiling->metres()};
}

QString PlanningController::failureText(const jobs::PlanningOutcome& outcome) const {
  const mission::Mission& mission = workspace_.document().mission();
  const style::Units units = workspace_.view().units();
  const std::optional<Limit> ceiling = limit();
  const bool isForHeight = outcome.missingHeight || outcome.target < 0;
  if (!outcome.error || outcome.error->code != Errc::NoSolution || !ceiling || !isForHeight) {
    return outcome.error ? units.inSentence(outcome.error->message()) : tr("Planning failed.");
  }
  const QString whose = ceiling->whose == Whose::Mission    ? tr("the mission's ceiling of %1")
                        : ceiling->whose == Whose::Aircraft ? tr("the aircraft's ceiling of %1")
                                                            : tr("%1, to which the air is reckoned as neither mission nor aircraft has a ceiling");
  const QString of = whose.arg(units.altitudeMsl(ceiling->metres));
  if (!outcome.missingHeight) {
    return tr("No safe tour joins all targets below %1; how much is missing is not known.").arg(of);
  }
  const QString needed = units.requiredMsl(ceiling->metres + *outcome.missingHeight);
  const QString missing = units.required(*outcome.missingHeight);
  const auto target = static_cast<std::size_t>(outcome.target);
  if (outcome.target < 0 || target >= mission.targets.size()) {
    return tr("No safe tour: to stay within glide of a runway it must climb to %1, which is %2 above %3.").arg(needed, missing, of);
  }
  return tr("No safe tour over target %1: to stay within glide of a runway it must climb to at least %2 there, which is %3 above %4.")
      .arg(QString::fromStdString(mission.targets[target].name), needed, missing, of);
}

void PlanningController::addCeilingRemedies(const jobs::PlanningOutcome& outcome, Actions& remedies) {
  const mission::Mission& mission = workspace_.document().mission();
  const std::optional<Limit> ceiling = limit();
  const bool isForHeight = outcome.missingHeight || (outcome.target < 0 && outcome.error && outcome.error->code == Errc::NoSolution);
  if (!ceiling || !isForHeight) {
    return;
  }
  const style::Units units = workspace_.view().units();
  const double least = outcome.missingHeight.value_or(kRaiseBlindly);
  const double by = units.heightToSi(std::ceil(units.heightFromSi(least) / 10.0 + 1.0) * 10.0);  // a round figure above it
  if (ceiling->whose != Whose::Mission || (mission.aircraft.ceiling && ceiling->metres + by > mission.aircraft.ceiling->metres())) {
    remedies.push_back({tr("Aircraft…"), [this] { edits_.editAircraft(); }});
  } else {
    remedies.push_back({tr("Raise ceiling by %1").arg(units.height(by)), [this, by] { editAndPlan([this, by] { edits_.raiseCeiling(by); }); }});
  }
  if (ceiling->whose == Whose::Mission) {
    remedies.push_back({tr("No ceiling"), [this] { editAndPlan([this] { edits_.removeCeiling(); }); }});
  }
}

void PlanningController::showFailure(const jobs::PlanningOutcome& outcome) {
  const mission::Mission& mission = workspace_.document().mission();
  Actions remedies;
  addCeilingRemedies(outcome, remedies);
  if (isFilterStrict()) {
    remedies.push_back(includeRunways());
  }
  if (outcome.target >= 0 && static_cast<std::size_t>(outcome.target) < mission.targets.size()) {
    const int target = outcome.target;
    workspace_.view().selectTarget(target);
    const QString name = QString::fromStdString(mission.targets[static_cast<std::size_t>(target)].name);
    remedies.push_back({tr("Delete target %1").arg(name), [this, target] { editAndPlan([this, target] { edits_.removeTarget(target); }); }});
  }
  banner_.show(MessageBanner::Kind::Failure, failureText(outcome), remedies);
}

}  // namespace vp::gui
