// Landing glides over all usable sites, for the safe altitude under the pointer and its overlay.
#include "core/aircraft/wind_check.h"
#include "core/landing/build_roadmap.h"
#include "core/landing/safe_altitude_field.h"
#include "core/mission/glide_conditions.h"
#include "core/mission/settings_check.h"
#include "ui/jobs/workspace_private.h"

#include <algorithm>

namespace vp::jobs {
namespace {

constexpr int kCoarseCells = 40;  // of the safe-altitude overlay, along its longer side; doubled until it is fine
constexpr int kFineCells = 160;
constexpr int kFieldHeadings = 8;
constexpr double kRoom = 0.1;      // of the area's longer side: so far targets may move before the roadmap is grown anew
constexpr double kTooWide = 0.25;  // of its area: below this share a roadmap around the targets alone is much finer

double areaOf(const geo::Box& box) {
  return (box.maxX - box.minX) * (box.maxY - box.minY);
}

bool contains(const geo::Box& outer, const geo::Box& inner) {
  return outer.contains({inner.minX, inner.minY}) && outer.contains({inner.maxX, inner.maxY});
}

struct RoadmapResult {
  std::shared_ptr<const landing::World> world;
  std::shared_ptr<const landing::Roadmap> roadmap;
};

}  // namespace

/// Terrain, sites, the aircraft or the wind are others: what is known of glides holds no longer.
void Workspace::Private::dropGlides() {
  roadmapDelay.stop();
  roadmapJob.cancel();
  fieldJob.cancel();
  world.reset();
  roadmap.reset();
  roadmapArea = {};
  fieldCells = 0;
  situation.safeAltitudes.reset();
}

/// Gives the processor to something else; buildRoadmap() goes on.
void Workspace::Private::pauseGlides() {
  if (roadmapJob.isRunning()) {
    roadmapArea = {};
  }
  roadmapDelay.stop();
  roadmapJob.cancel();
  fieldJob.cancel();
}

/// Grows the roadmap when edits have come to rest.
void Workspace::Private::planRoadmap() {
  roadmapDelay.start();
}

void Workspace::Private::buildRoadmap() {
  if (usable.empty() || !situation.terrain || planJob.isRunning() || terrainJob.isRunning()) {
    return;
  }
  tour::PlanInput input = planInput();
  const geo::Box wanted = tour::roadmapArea(input);
  if (!roadmapArea.isEmpty() && contains(roadmapArea, wanted) && areaOf(wanted) >= kTooWide * areaOf(roadmapArea)) {
    if (roadmap && fieldWanted && fieldCells < kFineCells && !fieldJob.isRunning()) {
      buildField(fieldCells == 0 ? kCoarseCells : 2 * fieldCells);
    }
    return;  // it is there or being built
  }
  const geo::Box extent = terrain.grid->extent();
  geo::Box area = wanted.grown(kRoom * std::max(wanted.maxX - wanted.minX, wanted.maxY - wanted.minY));
  area = {std::max(area.minX, extent.minX), std::max(area.minY, extent.minY), std::min(area.maxX, extent.maxX), std::min(area.maxY, extent.maxY)};
  roadmapArea = area;
  fieldJob.cancel();
  roadmapJob.start<RoadmapResult>(
      [input = std::move(input), area, same = world](const Job& job) -> Result<RoadmapResult> {
        if (const auto fault = mission::settingFaultForAircraft(input.mission)) {
          return fail(Errc::OutOfRange, fault->sentence);
        }
        if (const auto fault = aircraft::windFault(input.mission.aircraft, mission::glideConditionsOf(input.mission, input.sites))) {
          return fail(Errc::OutOfRange, fault->sentence);
        }
        auto made = same ? same : std::make_shared<const landing::World>(tour::makeWorld(input));
        landing::RoadmapRequest request;
        request.area = area;
        mission::PlannerSettings settings = input.mission.planner;
        settings.roadmapTime.reset();  // what the window shows must not depend on the machine
        auto built = landing::buildRoadmap(*made, settings, request, job);
        if (!built) {
          return forward(built);
        }
        return RoadmapResult{std::move(made), std::move(*built)};
      },
      [this](Result<RoadmapResult> result) {
        if (!result) {
          roadmapArea = {};  // without one the window lacks an overlay, and planning will say why
          return;
        }
        world = std::move(result->world);
        roadmap = std::move(result->roadmap);
        fieldCells = 0;
        if (fieldWanted) {
          buildField(kCoarseCells);
        }
        publish();
      });
}

void Workspace::Private::buildField(int cells) {
  fieldJob.start<landing::SafeAltitudeField>(
      [ground = world, glides = roadmap, area = roadmapArea, cells](const Job& job) {
        return landing::safeAltitudeField(*ground, *glides, area, cells, kFieldHeadings, job);
      },
      [this, cells](Result<landing::SafeAltitudeField> result) {
        if (!result) {
          return;
        }
        situation.safeAltitudes = std::make_shared<const landing::SafeAltitudeField>(std::move(*result));
        fieldCells = cells;
        if (cells < kFineCells) {
          buildField(2 * cells);
        }
        publish();
      });
}

void Workspace::setSafeAltitudesWanted(bool wanted) {
  d_->fieldWanted = wanted;
  if (wanted) {
    d_->buildRoadmap();
  } else {
    d_->fieldJob.cancel();
    d_->fieldCells = 0;
    if (d_->situation.safeAltitudes) {
      d_->situation.safeAltitudes.reset();
      d_->publish();
    }
  }
}

std::optional<double> Workspace::safeAltitudeAt(geo::Point place) const {
  constexpr int kHeadings = 8;
  if (!d_->roadmap || !d_->world->terrain.grid().isKnownAt(place)) {
    return std::nullopt;
  }
  std::optional<double> worst;
  int hint = -1;
  for (int h = 0; h < kHeadings; ++h) {
    const auto answer = d_->roadmap->query(*d_->world, {place.x, place.y, 2.0 * Angle::kPi * h / kHeadings}, d_->scratch, hint);
    if (!answer) {
      return std::nullopt;
    }
    hint = answer->node;
    worst = std::max(worst.value_or(answer->altitude), answer->altitude);
  }
  return worst;
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

}  // namespace vp::jobs
