#pragma once
// A small bundled mission, planned quickly and checked: what views are tested with. Uses the planner as the program does.

#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/safety/checker.h"
#include "core/tour/planner.h"
#include "ui/document/situation.h"

#include <QDir>
#include <QImage>
#include <QString>

#include <stdexcept>

namespace vp::test {

/** Saves a picture to the folder that VOLPLANE_TEST_PICTURES names, for looking at; does nothing without it. */
inline void keepPicture(const QImage& image, const QString& name) {
  if (const QString folder = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !folder.isEmpty()) {
    QDir().mkpath(folder);
    image.save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
  }
}

/** A plan of maps/NAME.vpm with few headings and a small roadmap, certified, with its terrain, sites and targets. */
inline document::Situation plannedSituation(const char* name = "mountain-n5") {
  const std::string path = std::string(VOLPLANE_SOURCE_DIR "/maps/") + name + ".vpm";
  auto mission = formats::readMission(path);
  if (!mission) {
    throw std::runtime_error(mission.error().message());
  }
  mission->planner.headings = 2;
  mission->planner.roadmapSamples = 1500;
  const auto loaded = formats::loadMission(*mission, VOLPLANE_SOURCE_DIR "/maps", Job{});
  if (!loaded) {
    throw std::runtime_error(loaded.error().message());
  }
  tour::PlanInput input;
  input.mission = loaded->mission;
  input.frame = loaded->frame;
  input.terrain = loaded->terrain;
  input.terrainFiles = loaded->terrainFiles;
  input.sites = loaded->sites;
  input.targets = loaded->targets;
  input.createdBy = "test";
  auto plan = tour::planTour(input, Job{});
  if (!plan) {
    throw std::runtime_error(plan.error().message());
  }
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : loaded->terrainFiles) {
    checksums.push_back(file.sha256);
  }
  const auto report = safety::check({*plan, *loaded->terrain, checksums}, Job{});
  if (report) {
    plan->certificate = report->certificate;
  }

  document::Situation situation;
  situation.terrain = document::makeTerrainData(loaded->frame, loaded->terrain, loaded->terrainFiles);
  std::vector<document::ShownSite> sites;
  for (const mission::SiteInFrame& site : loaded->sites) {
    sites.push_back({site, true});
  }
  situation.sites = std::make_shared<const std::vector<document::ShownSite>>(std::move(sites));
  std::vector<document::ShownTarget> targets;
  for (const mission::TargetInFrame& target : loaded->targets) {
    targets.push_back({target.target, target.point, target.altitude, {}});
  }
  situation.targets = std::make_shared<const std::vector<document::ShownTarget>>(std::move(targets));
  situation.plan = std::make_shared<const document::PlanView>(std::make_shared<const mission::Plan>(std::move(*plan)), situation.terrain);
  return situation;
}

/** The same situation with its plan changed and derived anew. */
template <typename Change>
document::Situation withChangedPlan(const document::Situation& situation, Change change) {
  document::Situation changed = situation;
  mission::Plan plan = situation.plan->plan();
  change(plan);
  changed.plan = std::make_shared<const document::PlanView>(std::make_shared<const mission::Plan>(std::move(plan)), situation.terrain);
  return changed;
}

}  // namespace vp::test
