#include "ui/jobs/workspace.h"

#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/landing/rrt_star.h"
#include "core/landing/safe_altitude_field.h"
#include "core/tour/planner.h"
#include "ui/jobs/file_kind.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/planning_job.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <thread>

namespace vp::jobs {
namespace {

using document::Situation;
using document::TerrainData;

constexpr int kCoarseCells = 40;  // of the safe-altitude overlay, along its longer side
constexpr int kFineCells = 160;
constexpr int kFieldHeadings = 8;
constexpr int kProbeHeadings = 8;  // of the altitude under the pointer

struct TerrainResult {
  std::shared_ptr<const TerrainData> terrain;
  formats::LoadedTerrain loaded;
};

struct RoadmapResult {
  std::shared_ptr<const landing::World> world;
  std::shared_ptr<const landing::Roadmap> roadmap;
};

/// What the roadmap of landing glides depends on beside terrain and sites.
bool sameGlides(const mission::Mission& a, const mission::Mission& b) {
  mission::Mission x;
  mission::Mission y;
  x.aircraft = a.aircraft;
  y.aircraft = b.aircraft;
  x.safety = a.safety;
  y.safety = b.safety;
  return document::samePlanInputs(x, y);
}

bool sameSites(const mission::Mission& a, const mission::Mission& b) {
  return a.airfields == b.airfields && a.sites == b.sites && a.siteFilter == b.siteFilter;
}

}  // namespace

/// The desk's jobs and what they brought; one runner for each kind of work.
class Workspace::Private {
public:
  explicit Private(Workspace& workspace) : self(workspace) {}

  void missionChanged();
  void planChanged();
  void loadTerrain();
  void loadSites();
  void placeTargets();
  void viewPlan();
  void buildRoadmap();
  void buildField(int cells);
  void publish();
  void refreshActivity();
  [[nodiscard]] tour::PlanInput planInput() const;
  [[nodiscard]] Result<void> readyToPlan() const;

  Workspace& self;
  document::MissionDocument document;
  document::ViewState view;
  Situation situation;
  Activity activity = Activity::Idle;
  QStringList notes;

  mission::Mission shown;  ///< what the loaded parts belong to
  formats::LoadedTerrain terrain;
  std::vector<mission::SiteInFrame> usable;
  std::shared_ptr<const landing::World> world;
  std::shared_ptr<const landing::Roadmap> roadmap;
  mutable landing::Roadmap::QueryScratch scratch;
  bool fieldWanted = false;
  bool terrainFailed = false;

  JobRunner terrainJob;
  JobRunner sitesJob;
  JobRunner viewJob;
  JobRunner roadmapJob;
  JobRunner fieldJob;
  JobRunner planJob;
};

void Workspace::Private::missionChanged() {
  const mission::Mission before = shown;
  shown = document.mission();
  if (shown.terrain != before.terrain) {
    loadTerrain();
  } else if (situation.terrain && !sameSites(shown, before)) {
    loadSites();
  } else if (situation.terrain && !sameGlides(shown, before)) {
    buildRoadmap();
  }
  if (shown.targets != before.targets || situation.targets == nullptr) {
    placeTargets();
  }
  publish();
}

void Workspace::Private::planChanged() {
  situation.planIsCurrent = document.planIsCurrent();
  if (!document.plan()) {
    viewJob.cancel();
    situation.plan.reset();
  } else if (!situation.plan || &situation.plan->plan() != document.plan().get()) {
    viewPlan();
  }
  publish();
}

void Workspace::Private::loadTerrain() {
  sitesJob.cancel();
  roadmapJob.cancel();
  fieldJob.cancel();
  terrainFailed = false;
  if (shown.terrain.empty()) {
    terrainJob.cancel();
    terrain = {};
    usable.clear();
    world.reset();
    roadmap.reset();
    situation = {};
    placeTargets();
    refreshActivity();
    return;
  }
  terrainJob.start<TerrainResult>(
      [files = shown.terrain](const Job& job) -> Result<TerrainResult> {
        Result<formats::LoadedTerrain> loaded = formats::loadTerrain(files, "", job);
        if (!loaded) {
          return forward(loaded);
        }
        auto data = document::makeTerrainData(loaded->frame, loaded->grid, loaded->files);
        return TerrainResult{std::move(data), std::move(*loaded)};
      },
      [this](Result<TerrainResult> result) {
        if (!result) {
          terrainFailed = true;
          refreshActivity();
          emit self.loadingFailed(result.error());
          return;
        }
        terrain = std::move(result->loaded);
        situation.terrain = std::move(result->terrain);
        situation.sites.reset();
        situation.safeAltitudes.reset();
        world.reset();
        roadmap.reset();
        usable.clear();
        placeTargets();
        loadSites();
        if (document.plan()) {
          viewPlan();
        }
        publish();
      });
  refreshActivity();
}

void Workspace::Private::loadSites() {
  roadmapJob.cancel();
  fieldJob.cancel();
  sitesJob.start<formats::LoadedSites>([mission = shown, ground = terrain](const Job&) { return formats::loadSites(mission, "", ground); },
                                       [this](Result<formats::LoadedSites> result) {
                                         if (!result) {
                                           refreshActivity();
                                           emit self.loadingFailed(result.error());
                                           return;
                                         }
                                         auto sites = std::make_shared<std::vector<document::ShownSite>>();
                                         for (const mission::SiteInFrame& site : result->usable) {
                                           sites->push_back({site, true});
                                         }
                                         for (const mission::SiteInFrame& site : result->leftOut) {
                                           sites->push_back({site, false});
                                         }
                                         usable = std::move(result->usable);
                                         situation.sites = std::move(sites);
                                         notes.clear();
                                         for (const std::string& note : result->notes) {
                                           notes << QString::fromStdString(note);
                                         }
                                         emit self.notesChanged();
                                         buildRoadmap();
                                         publish();
                                         refreshActivity();
                                       });
  refreshActivity();
}

void Workspace::Private::placeTargets() {
  auto targets = std::make_shared<std::vector<document::ShownTarget>>();
  for (const mission::Target& target : document.mission().targets) {
    document::ShownTarget shownTarget{target, {}, std::nullopt, {}};
    if (situation.terrain) {
      shownTarget.point = situation.terrain->frame.toPoint(target.position);
      const Result<mission::TargetInFrame> placed = formats::placeTarget(target, situation.terrain->frame, *situation.terrain->grid);
      if (placed) {
        shownTarget.altitude = placed->altitude;
      } else {
        shownTarget.problem = placed.error().what;
      }
    }
    targets->push_back(std::move(shownTarget));
  }
  situation.targets = std::move(targets);
}

void Workspace::Private::viewPlan() {
  if (!situation.terrain || !document.plan() || document.plan()->tour.empty()) {
    situation.plan.reset();
    return;
  }
  // a plan lies in the frame that it was made in; over other terrain it cannot be drawn
  if (!(document.plan()->frameOrigin == situation.terrain->frame.origin())) {
    situation.plan.reset();
    return;
  }
  viewJob.start<std::shared_ptr<const document::PlanView>>(
      [plan = document.plan(), ground = situation.terrain](const Job&) -> Result<std::shared_ptr<const document::PlanView>> {
        return std::make_shared<const document::PlanView>(plan, ground);
      },
      [this](Result<std::shared_ptr<const document::PlanView>> result) {
        if (!result) {
          emit self.loadingFailed(result.error());
          return;
        }
        situation.plan = *result;
        situation.planIsCurrent = document.planIsCurrent();
        publish();
      });
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
  input.createdBy = "volplane " VOLPLANE_VERSION;
  input.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  return input;
}

void Workspace::Private::buildRoadmap() {
  fieldJob.cancel();
  roadmap.reset();
  world.reset();
  situation.safeAltitudes.reset();
  if (usable.empty() || !terrain.grid) {
    roadmapJob.cancel();
    return;
  }
  roadmapJob.start<RoadmapResult>(
      [input = planInput()](const Job& job) -> Result<RoadmapResult> {
        auto made = std::make_shared<const landing::World>(tour::makeWorld(input));
        landing::RrtStarOptions options;
        options.area = tour::roadmapArea(input);
        options.samples = landing::defaultSamples(options.area);
        options.seed = input.mission.planner.seed;
        Result<landing::Roadmap> built = landing::buildRrtStarRoadmap(*made, options, job);
        if (!built) {
          return forward(built);
        }
        return RoadmapResult{std::move(made), std::make_shared<const landing::Roadmap>(std::move(*built))};
      },
      [this](Result<RoadmapResult> result) {
        if (result) {  // without one the window lacks an overlay, and planning will say why
          world = std::move(result->world);
          roadmap = std::move(result->roadmap);
          if (fieldWanted) {
            buildField(kCoarseCells);
          }
          publish();
        }
      });
}

void Workspace::Private::buildField(int cells) {
  if (!roadmap) {
    return;
  }
  const geo::Box area = tour::roadmapArea(planInput());
  fieldJob.start<landing::SafeAltitudeField>(
      [ground = world, glides = roadmap, area, cells](const Job& job) {
        return landing::safeAltitudeField(*ground, *glides, area, cells, kFieldHeadings, job);
      },
      [this, cells](Result<landing::SafeAltitudeField> result) {
        if (result) {
          situation.safeAltitudes = std::make_shared<const landing::SafeAltitudeField>(std::move(*result));
          publish();
          if (cells < kFineCells) {
            buildField(kFineCells);
          }
        }
      });
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

Result<void> Workspace::Private::readyToPlan() const {
  const mission::Mission& mission = document.mission();
  if (planJob.isRunning()) {
    return fail(Errc::OutOfRange, "a plan is being made already; stop it first");
  }
  if (mission.terrain.empty()) {
    return fail(Errc::MissingTerrain, "no terrain is loaded; add a terrain file first");
  }
  if (terrainJob.isRunning() || sitesJob.isRunning()) {
    return fail(Errc::OutOfRange, "terrain and airfields are still being read; plan again in a moment");
  }
  if (terrainFailed || !situation.terrain) {
    return fail(Errc::MissingTerrain, "the terrain could not be read; replace it by a file that exists", mission.terrain.front());
  }
  if (usable.empty()) {
    return fail(Errc::NoLandingSite, "no usable runway lies inside the terrain; add airfields, or include runways that the filter leaves out");
  }
  if (mission.targets.empty()) {
    return fail(Errc::OutOfRange, "the mission has no targets; press A and click at least one on the map");
  }
  for (const document::ShownTarget& target : *situation.targets) {
    if (!target.problem.empty()) {
      return fail(Errc::MissingTerrain, target.problem);
    }
  }
  return {};
}

Workspace::Workspace(QObject* parent) : QObject(parent), d_(std::make_unique<Private>(*this)) {
  connect(&d_->document, &document::MissionDocument::missionChanged, this, [this] { d_->missionChanged(); });
  connect(&d_->document, &document::MissionDocument::planChanged, this, [this] { d_->planChanged(); });
  for (JobRunner* job : {&d_->terrainJob, &d_->planJob}) {
    connect(job, &JobRunner::progressed, this, &Workspace::progressed);
  }
  d_->shown = d_->document.mission();
  d_->placeTargets();
}

Workspace::~Workspace() = default;

document::MissionDocument& Workspace::document() {
  return d_->document;
}
document::ViewState& Workspace::view() {
  return d_->view;
}
const Situation& Workspace::situation() const {
  return d_->situation;
}
Workspace::Activity Workspace::activity() const {
  return d_->activity;
}
QStringList Workspace::notes() const {
  return d_->notes;
}
geo::Box Workspace::glideArea() const {
  return d_->terrain.grid ? tour::roadmapArea(d_->planInput()) : geo::Box{};
}
std::shared_ptr<const landing::World> Workspace::world() const {
  return d_->world;
}
std::shared_ptr<const landing::Roadmap> Workspace::roadmap() const {
  return d_->roadmap;
}

Result<void> Workspace::startPlanning() {
  if (Result<void> ready = d_->readyToPlan(); !ready) {
    return ready;
  }
  auto clock = std::make_shared<QElapsedTimer>();
  clock->start();
  const auto publish = [this](std::shared_ptr<const document::PlanningSketch> sketch) {
    QMetaObject::invokeMethod(
        this,
        [this, sketch = std::move(sketch)] {
          if (d_->planJob.isRunning()) {
            d_->situation.sketch = sketch;
            d_->publish();
          }
        },
        Qt::QueuedConnection);
  };
  d_->planJob.start<PlannedTour>([input = d_->planInput(), publish](const Job& job) { return planAndVerify(input, publish, job); },
                                 [this, clock](Result<PlannedTour> result) {
                                   d_->situation.sketch.reset();
                                   PlanningOutcome outcome = outcomeOf(result);
                                   outcome.seconds = static_cast<double>(clock->nsecsElapsed()) * 1e-9;
                                   if (result && result->plan) {
                                     d_->document.setPlan(result->plan);
                                   }
                                   d_->publish();
                                   d_->refreshActivity();
                                   emit planningEnded(outcome);
                                 });
  d_->refreshActivity();
  return {};
}

void Workspace::cancelPlanning() {
  d_->planJob.requestStop();
}

Result<void> Workspace::addFiles(const QStringList& paths) {
  Result<NewFiles> files = sortFiles(paths, d_->document.mission());
  if (!files) {
    return forward(files);
  }
  const auto count = files->terrain.size() + files->airfields.size();
  const QString name = files->airfields.empty() ? tr("Add terrain")
                       : files->terrain.empty() ? tr("Add airfields")
                                                : tr("Add %n file(s)", nullptr, static_cast<int>(count));
  d_->document.edit(name, [&](mission::Mission& m) {
    m.terrain.insert(m.terrain.end(), files->terrain.begin(), files->terrain.end());
    m.airfields.insert(m.airfields.end(), files->airfields.begin(), files->airfields.end());
  });
  return {};
}

void Workspace::setSafeAltitudesWanted(bool wanted) {
  d_->fieldWanted = wanted;
  if (!wanted) {
    d_->fieldJob.cancel();
  } else if (!d_->situation.safeAltitudes && !d_->fieldJob.isRunning()) {
    d_->buildField(kCoarseCells);
  }
}

std::optional<double> Workspace::safeAltitudeAt(geo::Point place) const {
  if (!d_->roadmap || !d_->world->terrain.grid().isKnownAt(place)) {
    return std::nullopt;
  }
  std::optional<double> worst;
  int hint = -1;
  for (int h = 0; h < kProbeHeadings; ++h) {
    const auto answer = d_->roadmap->query(*d_->world, {place.x, place.y, 2.0 * Angle::kPi * h / kProbeHeadings}, d_->scratch, hint);
    if (!answer) {
      return std::nullopt;
    }
    hint = answer->node;
    worst = std::max(worst.value_or(answer->altitude), answer->altitude);
  }
  return worst;
}

void Workspace::stopAll() {
  for (JobRunner* job : {&d_->terrainJob, &d_->sitesJob, &d_->viewJob, &d_->roadmapJob, &d_->fieldJob, &d_->planJob}) {
    job->cancel();
  }
}

}  // namespace vp::jobs
