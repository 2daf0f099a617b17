#pragma once

// A situation made from formulas: hills with a mountain in the south-west, an unknown hole, unknown ground beyond a slanting
// edge in the east, a racetrack tour of 600 m in the north with two targets and one runway.

#include "tests/support/plan_builder.h"
#include "ui/document/situation.h"

#include <cmath>
#include <limits>
#include <memory>

namespace vp::test {

inline constexpr int kSceneCells = 240;
inline constexpr double kSceneCell = 50.0;
inline constexpr double kSceneHalf = 0.5 * kSceneCells * kSceneCell;

inline double sceneHeight(double x, double y) {
  const double hills = 120.0 + 80.0 * std::sin(x / 900.0) * std::cos(y / 700.0);
  const double r = std::hypot(x + 3500.0, y + 3200.0);
  return hills + 1300.0 * std::exp(-r * r / (2.0 * 1100.0 * 1100.0));
}

inline bool isSceneUnknown(double x, double y) {
  const bool isHole = x > 2000.0 && x < 3200.0 && y > -3600.0 && y < -2400.0;
  return isHole || x + 0.3 * y > 5200.0;
}

inline std::shared_ptr<const document::TerrainData> sceneTerrain(int cells = kSceneCells, double cell = kSceneCell) {
  std::vector<float> values;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const double x = (i + 0.5 - 0.5 * cells) * cell;
      const double y = (j + 0.5 - 0.5 * cells) * cell;
      values.push_back(isSceneUnknown(x, y) ? std::numeric_limits<float>::infinity() : static_cast<float>(sceneHeight(x, y)));
    }
  }
  auto grid = std::make_shared<const terrain::ElevationGrid>(-0.5 * cells * cell, -0.5 * cells * cell, cell, cells, cells, std::move(values));
  return document::makeTerrainData(geo::LocalFrame({46.5, 9.9}), std::move(grid), {});
}

inline document::Situation sceneSituation() {
  document::Situation situation;
  situation.terrain = sceneTerrain();
  PlanBuilder builder(900.0);
  auto sites = std::make_shared<std::vector<document::ShownSite>>();
  for (const mission::SiteInFrame& site : builder.plan().sites) {
    sites->push_back({site, true});
  }
  situation.sites = sites;
  auto targets = std::make_shared<std::vector<document::ShownTarget>>();
  for (const mission::TargetInFrame& target : builder.plan().targets) {
    targets->push_back({target.target, target.point, target.altitude, ""});
  }
  situation.targets = targets;
  situation.plan = std::make_shared<const document::PlanView>(std::make_shared<const mission::Plan>(builder.plan()), situation.terrain);
  return situation;
}

}  // namespace vp::test
