// What the mission's files hold: terrain, landing sites, population, placed targets and weather, and the plan over them.
#include "core/formats/population_file.h"
#include "core/risk/population.h"
#include "core/risk/weather.h"
#include "ui/jobs/plan_placement.h"
#include "ui/jobs/workspace_private.h"
#include "ui/style/core_text.h"

#include <iterator>

namespace vp::jobs {

using document::PlanView;
using document::TerrainData;

struct TerrainResult {
  std::shared_ptr<const TerrainData> data;
  formats::LoadedTerrain loaded;
  std::vector<FileStamp> stamps;
};

struct GroundResult {
  formats::LoadedSites sites;
  formats::LoadedAirspaces airspaces;
};

/// No terrain: nothing can be shown in its frame.
void Workspace::Private::clearGround() {
  sitesJob.cancel();
  viewJob.cancel();
  dropGlides();
  terrain = {};
  terrainStamps.clear();
  usable.clear();
  siteNotes.clear();
  sitesError.reset();
  viewedPlan.reset();
  viewedTerrain.reset();
  situation.terrain.reset();
  situation.sites.reset();
  situation.airspaces.reset();
  situation.foundAirspaces.reset();
  situation.plan.reset();
  populationJob.cancel();
  populationNotes.clear();
  situation.population.reset();
  placeTargets();
  placeWeather();
  refreshPlanState();
  tellNotes();
}

void Workspace::Private::loadTerrain() {
  terrainError.reset();
  if (shown.terrain.empty()) {
    terrainJob.cancel();
    clearGround();
    refreshActivity();
    return;
  }
  // what is shown stays until the new terrain is there, but nothing is worked out over it any more
  sitesJob.cancel();
  pauseGlides();
  terrainJob.start<TerrainResult>(
      [files = shown.terrain](const Job& job) -> Result<TerrainResult> {
        std::vector<FileStamp> stamps = stampsOf(files);
        Result<formats::LoadedTerrain> loaded = formats::loadTerrain(files, "", job);
        if (!loaded) {
          return forward(loaded);
        }
        job.progress(1.0, Workspace::tr("terrain: shading").toStdString());
        auto data = document::makeTerrainData(loaded->frame, loaded->grid, loaded->files);
        return TerrainResult{std::move(data), std::move(*loaded), std::move(stamps)};
      },
      [this](Result<TerrainResult> result) {
        if (result) {
          terrainLoaded(std::move(*result));
        } else {
          terrainError = result.error();
          clearGround();  // terrain of another list of files must not pass for this one
        }
        publish();
        refreshActivity();
        if (terrainError) {
          emit self.loadingFailed(*terrainError);
        }
      });
  refreshActivity();
}

void Workspace::Private::terrainLoaded(TerrainResult result) {
  const bool sameFrame = situation.terrain && situation.terrain->frame == result.data->frame;
  terrain = std::move(result.loaded);
  terrainStamps = std::move(result.stamps);
  situation.terrain = std::move(result.data);
  situation.sites.reset();
  usable.clear();
  dropGlides();
  if (!sameFrame) {
    viewJob.cancel();
    situation.plan.reset();
    viewedPlan.reset();
  }
  placeTargets();
  placeWeather();
  loadSites();
  loadPopulation();
  viewPlan();
}

void Workspace::Private::loadSites() {
  dropGlides();
  usable.clear();  // nothing is planned with runways of another filter
  sitesError.reset();
  sitesJob.start<GroundResult>(
      [mission = shown, ground = terrain](const Job& job) -> Result<GroundResult> {
        Result<formats::LoadedSites> sites = formats::loadSites(mission, "", ground, true, job);
        if (!sites) {
          return forward(sites);
        }
        Result<formats::LoadedAirspaces> airspaces = formats::loadAirspaces(mission, "", ground.area, job);
        if (!airspaces) {
          return forward(airspaces);
        }
        return GroundResult{std::move(*sites), std::move(*airspaces)};
      },
      [this](Result<GroundResult> result) {
        sitesLoaded(std::move(result));
        publish();
        refreshActivity();
        if (sitesError) {
          emit self.loadingFailed(*sitesError);
        }
      });
  refreshActivity();
}

void Workspace::Private::airspacesLoaded(formats::LoadedAirspaces loaded) {
  auto airspaces = std::make_shared<std::vector<document::ShownAirspace>>();
  for (mission::Airspace& airspace : loaded.airspaces) {
    airspaces->push_back(document::shownAirspace(std::move(airspace), shown.airspace, terrain.frame));
  }
  situation.airspaces = airspaces->empty() ? nullptr : std::move(airspaces);
  situation.foundAirspaces = loaded.kinds.empty()
                                 ? nullptr
                                 : std::make_shared<const document::FoundAirspaces>(document::FoundAirspaces{std::move(loaded.hidden), loaded.kinds});
  for (const std::string& note : loaded.notes) {
    siteNotes << style::coreText(note);
  }
}

void Workspace::Private::sitesLoaded(Result<GroundResult> ground) {
  siteNotes.clear();
  if (ground) {
    airspacesLoaded(std::move(ground->airspaces));
  }
  const Result<formats::LoadedSites> result = ground ? Result<formats::LoadedSites>(std::move(ground->sites)) : forward(ground);
  if (!result) {
    sitesError = result.error();
    situation.sites.reset();
    situation.airspaces.reset();
    situation.foundAirspaces.reset();
    tellNotes();
    return;
  }
  auto sites = std::make_shared<std::vector<document::ShownSite>>();
  for (const mission::SiteInFrame& site : result->usable) {
    sites->push_back({site, true});
  }
  for (const mission::SiteInFrame& site : result->leftOut) {
    sites->push_back({site, false});
  }
  situation.sites = std::move(sites);
  usable = result->usable;
  for (const std::string& note : result->notes) {
    siteNotes << style::coreText(note);
  }
  if (!result->unmatchedFilter.empty()) {
    sitesError = formats::unmatchedFilterError(result->unmatchedFilter);
  }
  tellNotes();
  buildRoadmap();
}

void Workspace::Private::tellNotes() {
  QStringList now = siteNotes + populationNotes;
  if (!document.planProblem().isEmpty()) {
    now.prepend(document.planProblem());
  }
  if (now != notes) {
    notes = now;
    emit self.notesChanged();
  }
}

void Workspace::Private::placeTargets() {
  auto targets = std::make_shared<std::vector<document::ShownTarget>>();
  std::vector<mission::TargetInFrame> placedBefore;
  for (const mission::Target& target : document.mission().targets) {
    document::ShownTarget shownTarget{target, {}, std::nullopt, {}};
    if (situation.terrain) {
      shownTarget.point = situation.terrain->frame.toPoint(target.position);
      const Result<mission::TargetInFrame> placed = formats::placeTarget(target, situation.terrain->frame, *situation.terrain->grid);
      if (!placed) {
        shownTarget.problem = placed.error().what;
      } else {
        shownTarget.altitude = placed->altitude;
        if (const Result<void> apart = formats::checkApart(placedBefore, *placed); !apart) {
          shownTarget.problem = apart.error().what;
        }
        placedBefore.push_back(*placed);
      }
    }
    targets->push_back(std::move(shownTarget));
  }
  situation.targets = std::move(targets);
  situation.home = document.mission().home;
  situation.wind = document.mission().wind;
}

/// The mission's weather in the frame, and for planners.
void Workspace::Private::placeWeather() {
  situation.weather.reset();
  situation.weatherRisk.reset();
  situation.weatherProblem.clear();
  if (!situation.terrain || shown.weather.empty()) {
    return;
  }
  auto cells = std::make_shared<std::vector<document::ShownWeather>>();
  for (const mission::WeatherCell& cell : shown.weather) {
    cells->push_back(document::shownWeather(cell, situation.terrain->frame));
  }
  situation.weather = std::move(cells);
  if (auto weather = risk::Weather::from(shown.weather, situation.terrain->frame)) {
    situation.weatherRisk = std::move(*weather);
  } else {
    situation.weatherProblem = weather.error().what + '.';
  }
}

struct PopulationResult {
  std::shared_ptr<const risk::Population> people;
  std::vector<std::string> notes;
};

/// Files that cannot be read are told of and left out whole: half of the people must not pass for all of them.
void Workspace::Private::loadPopulation() {
  situation.population.reset();
  populationNotes.clear();
  if (shown.populationFiles.empty()) {
    populationJob.cancel();
    tellNotes();
    return;
  }
  populationJob.start<PopulationResult>(
      [files = shown.populationFiles, frame = situation.terrain->frame](const Job& job) -> Result<PopulationResult> {
        std::vector<mission::PopulationArea> areas;
        PopulationResult result;
        for (const std::string& file : files) {
          if (job.stopRequested()) {
            return fail(Errc::Cancelled, Workspace::tr("reading the population was stopped").toStdString());
          }
          Result<formats::PopulationReport> read = formats::readPopulation(file);
          if (!read) {
            return forward(read);
          }
          std::move(read->areas.begin(), read->areas.end(), std::back_inserter(areas));
          result.notes.insert(result.notes.end(), read->notes.begin(), read->notes.end());
        }
        Result<risk::Population> people = risk::Population::from(areas, frame);
        if (!people) {
          return forward(people);
        }
        result.people = std::make_shared<const risk::Population>(std::move(*people));
        return result;
      },
      [this](Result<PopulationResult> result) {
        if (result) {
          situation.population = std::move(result->people);
          for (const std::string& note : result->notes) {
            populationNotes << style::coreText(note);
          }
        }
        tellNotes();
        publish();
        if (!result) {
          emit self.loadingFailed(result.error());
        }
      });
}

/// A plan that is not the one shown is never current, whatever the document says of it.
void Workspace::Private::refreshPlanState() {
  situation.planIsCurrent = !situation.plan || (document.planIsCurrent() && viewedPlan == document.plan());
}

void Workspace::Private::viewPlan() {
  const std::shared_ptr<const mission::Plan> plan = document.plan();
  if (!plan || plan->tour.empty() || !situation.terrain) {
    viewJob.cancel();
    situation.plan.reset();
    viewedPlan.reset();
    refreshPlanState();
    return;
  }
  refreshPlanState();
  if (situation.plan && viewedPlan == plan && viewedTerrain == situation.terrain) {
    viewJob.cancel();
    return;
  }
  using View = std::shared_ptr<const PlanView>;
  viewJob.start<View>(
      [plan, ground = situation.terrain](const Job&) -> Result<View> {
        auto placed = placedIn(plan, ground->frame, *ground->grid);
        return placed ? std::make_shared<const PlanView>(std::move(placed), ground) : View();
      },
      [this, plan, ground = situation.terrain](const Result<View>& result) {
        situation.plan = result ? *result : View();
        viewedPlan = plan;
        viewedTerrain = ground;
        refreshPlanState();
        publish();
        if (!result) {
          emit self.loadingFailed(result.error());
        }
      });
}

}  // namespace vp::jobs
