#include "ui/jobs/workspace.h"

#include "core/aircraft/wind_check.h"
#include "core/mission/glide_conditions.h"
#include "core/mission/settings_check.h"
#include "ui/jobs/file_kind.h"
#include "ui/jobs/planning_job.h"
#include "ui/jobs/workspace_private.h"

#include <QElapsedTimer>

#include <algorithm>
#include <thread>
#include <utility>

namespace vp::jobs {
namespace {

constexpr int kEditsRest = 300;  // ms without an edit before landing glides are grown anew

bool sameGlides(const mission::Mission& a, const mission::Mission& b) {
  return a.aircraft == b.aircraft && a.safety == b.safety && mission::sameConditions(a, b);
}

/// Whether what lies on the terrain is the same. Distances may be counted from the targets, so moving one can change which runways are used; so
/// can the wind and the air of the day, and what the aircraft may land in.
bool sameSites(const mission::Mission& a, const mission::Mission& b) {
  const bool countsFromTargets = a.siteFilter.maxDistance && !a.siteFilter.distanceFrom;
  return a.airfields == b.airfields && a.sites == b.sites && a.siteFilter == b.siteFilter && a.airspace == b.airspace && a.wind == b.wind &&
         a.atmosphere == b.atmosphere && a.aircraft == b.aircraft && (!countsFromTargets || a.targets == b.targets);
}

}  // namespace

Workspace::Private::Private(Workspace& workspace) : self(workspace) {
  roadmapDelay.setSingleShot(true);
  roadmapDelay.setInterval(kEditsRest);
  QObject::connect(&roadmapDelay, &QTimer::timeout, &self, [this] { buildRoadmap(); });
}

std::array<JobRunner*, 7> Workspace::Private::jobs() {
  return {&terrainJob, &sitesJob, &populationJob, &viewJob, &roadmapJob, &fieldJob, &planJob};
}

/// Nothing that was started for the document before may reach this one.
void Workspace::Private::documentReplaced() {
  isReplaced = true;
  planner = std::make_shared<tour::Planner>();
  tellNotes();
  if (planJob.isRunning()) {
    planJob.cancel();
    situation.sketch.reset();
    refreshActivity();
    emit self.planningEnded(PlanningOutcome{});
  }
}

void Workspace::Private::missionChanged() {
  const mission::Mission before = std::exchange(shown, document.mission());
  const bool rewritten = std::exchange(isReplaced, false) && situation.terrain && stampsOf(shown.terrain) != terrainStamps;
  if (shown.terrain != before.terrain || rewritten) {
    loadTerrain();
  } else if (situation.terrain && !terrainJob.isRunning()) {
    if (!sameSites(shown, before)) {
      loadSites();
    } else if (!sameGlides(shown, before)) {
      dropGlides();
      planRoadmap();
    }
  }
  if (shown.targets != before.targets) {
    placeTargets();
    planRoadmap();  // where the area of the targets has grown out of it
  }
  if (shown.weather != before.weather) {
    placeWeather();
  }
  if (shown.populationFiles != before.populationFiles && situation.terrain && !terrainJob.isRunning()) {
    loadPopulation();
  }
  publish();
}

tour::PlanInput Workspace::Private::planInput() const {
  tour::PlanInput input;
  input.mission = document.mission();
  input.frame = terrain.frame;
  input.terrain = terrain.grid;
  input.terrainFiles = terrain.files;
  input.sites = usable;
  if (situation.targets) {
    for (const document::ShownTarget& target : *situation.targets) {
      if (target.altitude) {
        input.targets.push_back({target.target, target.point, *target.altitude});
      }
    }
  }
  if (situation.terrain) {
    input.pyramid = situation.terrain->pyramid;
  }
  for (std::size_t i = 0; situation.airspaces && i < situation.airspaces->size(); ++i) {
    const document::ShownAirspace& shownOne = (*situation.airspaces)[i];
    if (shownOne.use == mission::AirspaceUse::Warn || shownOne.use == mission::AirspaceUse::Forbid) {
      input.airspaces.push_back(shownOne.airspace);
    }
  }
  input.createdBy = "volplane " VOLPLANE_VERSION;
  input.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  return input;
}

void Workspace::Private::publish() {
  emit self.situationChanged();
}

void Workspace::Private::refreshActivity() {
  const bool loading = terrainJob.isRunning() || sitesJob.isRunning();
  const Activity now = planJob.isRunning() ? Activity::Planning : loading ? Activity::Loading : Activity::Idle;
  if (now != activity) {
    activity = now;
    emit self.activityChanged();
  }
}

Result<void> Workspace::Private::readyToPlan() {
  const mission::Mission& mission = document.mission();
  if (planJob.isRunning()) {
    return fail(Errc::OutOfRange, Workspace::tr("a plan is being made already; stop it first").toStdString());
  }
  if (mission.terrain.empty()) {
    return fail(Errc::MissingTerrain, Workspace::tr("no terrain is loaded; add a terrain file first").toStdString());
  }
  if (terrainError) {
    return tl::unexpected(*terrainError);
  }
  if (!terrainJob.isRunning() && situation.terrain && stampsOf(mission.terrain) != terrainStamps) {
    loadTerrain();
    return fail(Errc::OutOfRange, Workspace::tr("the terrain files have changed and are read again; plan again in a moment").toStdString());
  }
  if (const auto fault = vp::mission::settingFaultForAircraft(mission)) {
    return fail(Errc::OutOfRange, fault->sentence);
  }
  if (const auto fault = aircraft::windFault(mission.aircraft, vp::mission::glideConditionsOf(mission, {}))) {
    return fail(Errc::OutOfRange, fault->sentence);
  }
  if (terrainJob.isRunning() || sitesJob.isRunning() || !situation.terrain) {
    return fail(Errc::OutOfRange, Workspace::tr("terrain and airfields are still being read; plan again in a moment").toStdString());
  }
  if (sitesError) {
    return tl::unexpected(*sitesError);
  }
  if (usable.empty()) {
    return fail(
        Errc::NoLandingSite,
        Workspace::tr("no usable runway lies inside the terrain; add airfields, or include runways that the filter leaves out").toStdString());
  }
  if (mission.targets.empty()) {
    return fail(Errc::OutOfRange, Workspace::tr("the mission has no targets; press A and click at least one on the map").toStdString());
  }
  for (const document::ShownTarget& target : *situation.targets) {
    if (!target.problem.empty()) {
      return fail(Errc::MissingTerrain, target.problem);
    }
  }
  return {};
}

void Workspace::Private::planned(const Result<PlannedTour>& result, double seconds) {
  situation.sketch.reset();
  PlanningOutcome outcome = outcomeOf(result);
  if (planStopped) {  // even if the plan was finished in the same moment: the operator has been told that nothing changes
    outcome = {};
  } else if (result && result->plan) {
    document.setPlan(result->plan);
  }
  outcome.seconds = seconds;
  buildRoadmap();
  publish();
  refreshActivity();
  emit self.planningEnded(outcome);
}

Workspace::Workspace(QObject* parent) : QObject(parent), d_(std::make_unique<Private>(*this)) {
  connect(&d_->document, &document::MissionDocument::replaced, this, [this] { d_->documentReplaced(); });
  connect(&d_->document, &document::MissionDocument::missionChanged, this, [this] { d_->missionChanged(); });
  connect(&d_->document, &document::MissionDocument::planChanged, this, [this] {
    d_->viewPlan();
    d_->publish();
  });
  for (JobRunner* job : {&d_->terrainJob, &d_->planJob}) {
    connect(job, &JobRunner::progressed, this, &Workspace::progressed);
  }
  d_->shown = d_->document.mission();
  d_->placeTargets();
}

Workspace::~Workspace() {
  stopAll();
}

document::MissionDocument& Workspace::document() {
  return d_->document;
}
document::ViewState& Workspace::view() {
  return d_->view;
}
const document::Situation& Workspace::situation() const {
  return d_->situation;
}
Workspace::Activity Workspace::activity() const {
  return d_->activity;
}
QStringList Workspace::notes() const {
  return d_->notes;
}

Result<void> Workspace::startPlanning() {
  if (Result<void> ready = d_->readyToPlan(); !ready) {
    return ready;
  }
  d_->pauseGlides();
  d_->planStopped = false;
  QElapsedTimer clock;
  clock.start();
  const auto publish = [this](std::shared_ptr<const document::PlanningSketch> sketch) {
    d_->mailbox.post([this, sketch = std::move(sketch)] {
      if (d_->planJob.isRunning()) {
        d_->situation.sketch = sketch;
        d_->publish();
      }
    });
  };
  d_->planJob.start<PlannedTour>(
      [planner = d_->planner, input = d_->planInput(), publish](const Job& job) { return planAndVerify(*planner, input, publish, job); },
      [this, clock](const Result<PlannedTour>& result) { d_->planned(result, static_cast<double>(clock.nsecsElapsed()) * 1e-9); });
  d_->refreshActivity();
  return {};
}

void Workspace::cancelPlanning() {
  if (d_->planJob.isRunning()) {
    d_->planStopped = true;
    d_->planJob.requestStop();
  }
}

Result<void> Workspace::add(const NewFiles& given) {
  const Result<NewFiles> files = newTo(d_->document.mission(), given);
  if (!files) {
    return forward(files);
  }
  const std::size_t count = files->count();
  const QString name = files->terrain.size() == count      ? tr("Add terrain")
                       : files->airfields.size() == count  ? tr("Add airfields")
                       : files->airspaces.size() == count  ? tr("Add airspaces")
                       : files->population.size() == count ? tr("Add population")
                                                           : tr("Add %n file(s)", nullptr, static_cast<int>(count));
  d_->document.edit(name, [&](mission::Mission& m) {
    m.terrain.insert(m.terrain.end(), files->terrain.begin(), files->terrain.end());
    m.airfields.insert(m.airfields.end(), files->airfields.begin(), files->airfields.end());
    if (!files->airspaces.empty() && m.airspace == mission::AirspaceSettings()) {
      for (const char* kind : {"A", "B", "C", "D", "CTR", "P", "R", "Q", "TMZ"}) {  // what takes a clearance or endangers
        m.airspace.rules.push_back({kind, "", mission::AirspaceUse::Warn});
      }
    }
    m.airspace.files.insert(m.airspace.files.end(), files->airspaces.begin(), files->airspaces.end());
    m.populationFiles.insert(m.populationFiles.end(), files->population.begin(), files->population.end());
  });
  return {};
}

void Workspace::stopAll() {
  d_->roadmapDelay.stop();
  for (JobRunner* job : d_->jobs()) {
    job->cancel();  // all are asked before any is waited for
  }
  for (JobRunner* job : d_->jobs()) {
    job->stopAndWait();
  }
  d_->situation.sketch.reset();
  d_->refreshActivity();
}

}  // namespace vp::jobs
