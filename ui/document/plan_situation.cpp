#include "ui/document/plan_situation.h"

#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"

#include <QCoreApplication>
#include <QString>

#include <filesystem>
#include <vector>

namespace vp::document {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(DocumentFiles)
};

}  // namespace

Situation situationOf(std::shared_ptr<const mission::Plan> plan, std::shared_ptr<const TerrainData> terrain) {
  Situation situation;
  auto sites = std::make_shared<std::vector<ShownSite>>();
  for (const mission::SiteInFrame& site : plan->sites) {
    sites->push_back({site, true});
  }
  auto targets = std::make_shared<std::vector<ShownTarget>>();
  for (const mission::TargetInFrame& target : plan->targets) {
    targets->push_back({target.target, target.point, target.altitude, {}});
  }
  auto airspaces = std::make_shared<std::vector<ShownAirspace>>();
  for (const mission::Airspace& airspace : plan->airspaces) {
    airspaces->push_back(shownAirspace(airspace, plan->mission.airspace, geo::LocalFrame(plan->frameOrigin)));
  }
  situation.wind = plan->mission.wind;
  situation.airspaces = airspaces->empty() ? nullptr : std::move(airspaces);
  situation.terrain = terrain;
  situation.sites = std::move(sites);
  situation.targets = std::move(targets);
  if (!plan->tour.empty()) {
    situation.plan = std::make_shared<const PlanView>(std::move(plan), std::move(terrain));
  }
  return situation;
}

Result<Situation> loadPlanSituation(const std::string& path, const Job& job) {
  Result<mission::Plan> plan = formats::readPlan(path);
  if (!plan) {
    return forward(plan);
  }
  std::vector<std::string> checksums;
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  Result<terrain::ElevationGrid> grid = formats::readPlanTerrain(*plan, folder, checksums, job);
  if (!grid) {
    return forward(grid);
  }
  for (std::size_t i = 0; i < checksums.size(); ++i) {
    if (checksums[i] != plan->terrain[i].sha256) {
      return fail(Errc::BadFile, Words::tr("the terrain has changed since the plan was made; plan again before looking at it").toStdString(),
                  plan->terrain[i].path);
    }
  }
  const geo::LocalFrame frame(plan->frameOrigin);
  auto terrain = makeTerrainData(frame, std::make_shared<const terrain::ElevationGrid>(std::move(*grid)), plan->terrain);
  return situationOf(std::make_shared<const mission::Plan>(std::move(*plan)), std::move(terrain));
}

}  // namespace vp::document
