#include "core/formats/mission_loader.h"

#include "core/formats/airfields.h"
#include "core/formats/mission_file.h"
#include "core/terrain/terrain_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vp::formats {
namespace {

/// Targets closer than this are one place to an aircraft [m].
constexpr double kSamePlace = 1.0;
/// Ground this far above a site's elevation means that one of the two is wrong [m]; 25 real aerodromes agree within 15 m.
constexpr double kElevationDoubt = 50.0;

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

Result<std::vector<mission::TargetInFrame>> placeTargets(const mission::Mission& mission, const geo::LocalFrame& frame,
                                                         const terrain::ElevationGrid& terrain) {
  std::vector<mission::TargetInFrame> placed;
  for (const mission::Target& target : mission.targets) {
    Result<mission::TargetInFrame> inFrame = placeTarget(target, frame, terrain);
    if (!inFrame) {
      return forward(inFrame);
    }
    for (const mission::TargetInFrame& other : placed) {
      if (geo::distance(other.point, inFrame->point) < kSamePlace) {
        return fail(Errc::OutOfRange, fmt::format("targets {} and {} are at the same place; remove one of them", other.target.name, target.name));
      }
    }
    placed.push_back(std::move(*inFrame));
  }
  return placed;
}

/// Sites of all sources inside `area`, with notes; names of the filter that match nothing are refused.
Result<std::vector<mission::LandingSite>> collectSites(const mission::Mission& mission, const std::string& folder, const geo::GeoBox& area,
                                                       std::vector<std::string>& notes) {
  std::vector<mission::LandingSite> sites;
  std::vector<AirfieldReport> reports;
  reports.push_back(filterSites(mission.sites, mission.siteFilter, std::nullopt));
  for (const mission::AirfieldSource& source : mission.airfields) {
    Result<AirfieldReport> report = readAirfields(source, folder, mission.siteFilter, area);
    if (!report) {
      return forward(report);
    }
    reports.push_back(std::move(*report));
  }
  for (const AirfieldReport& report : reports) {
    sites.insert(sites.end(), report.sites.begin(), report.sites.end());
    notes.insert(notes.end(), report.notes.begin(), report.notes.end());
  }
  const std::vector<std::string> unmatched = unmatchedNames(mission.siteFilter, reports);
  if (!unmatched.empty()) {
    // a misspelt name would silently leave a runway in that somebody ruled out
    return fail(
        Errc::OutOfRange,
        fmt::format("siteFilter names {}, but no landing site inside the terrain is called that; correct the name or remove it", unmatched.front()));
  }
  makeIdsUnique(sites);
  return sites;
}

std::vector<mission::SiteInFrame> placeSites(const std::vector<mission::LandingSite>& sites, const geo::LocalFrame& frame,
                                             const terrain::ElevationGrid& terrain, std::vector<std::string>& notes) {
  std::vector<mission::SiteInFrame> placed;
  int outside = 0;
  for (const mission::LandingSite& site : sites) {
    const geo::Point p = frame.toPoint(site.touchdown);
    const double ground = terrain.upperAt(p);
    if (!std::isfinite(ground)) {
      ++outside;
      continue;
    }
    mission::LandingSite onGround = site;
    if (site.elevationFromTerrain) {
      onGround.elevation = geo::HeightMsl::fromMetres(std::ceil(ground));
      onGround.elevationFromTerrain = false;
    } else if (std::abs(ground - site.elevation.metres()) > kElevationDoubt) {
      notes.push_back(fmt::format("{}: elevation {:.0f} m, but the terrain there is {:.0f} m; check both before relying on this site", site.id,
                                  site.elevation.metres(), ground));
    }
    placed.push_back({std::move(onGround), {p.x, p.y, frame.headingOf(site.landingCourse, site.touchdown)}});
  }
  if (outside > 0) {
    notes.push_back(fmt::format("{} landing sites lie outside the terrain or where it has no data and are not used", outside));
  }
  return placed;
}

}  // namespace

Result<mission::TargetInFrame> placeTarget(const mission::Target& target, const geo::LocalFrame& frame, const terrain::ElevationGrid& terrain) {
  mission::TargetInFrame inFrame{target, frame.toPoint(target.position), 0.0};
  const double ground = terrain.upperAt(inFrame.point);
  if (!std::isfinite(ground)) {
    const bool outside = !terrain.extent().contains(inFrame.point);
    return fail(Errc::MissingTerrain,
                fmt::format("target {} at {:.5f}, {:.5f} lies {}; move it or load terrain that covers it", target.name, target.position.latitude_deg,
                            target.position.longitude_deg, outside ? "outside the terrain" : "where the terrain has no data"));
  }
  inFrame.altitude = target.reference == mission::HeightReference::AboveGround ? ground + target.height_m : target.height_m;
  if (inFrame.altitude < ground) {
    return fail(Errc::OutOfRange,
                fmt::format("target {} at {:.0f} m MSL lies below the ground there ({:.0f} m); give a greater height, or one above ground",
                            target.name, inFrame.altitude, ground));
  }
  return inFrame;
}

Result<LoadedTerrain> loadTerrain(const std::vector<std::string>& files, const std::string& folder, const Job& job) {
  LoadedTerrain loaded;
  std::vector<std::string> paths;
  for (const std::string& file : files) {
    paths.push_back(absolute(resolvePath(folder, file)));
  }
  const Result<terrain::TerrainInfo> info = terrain::inspectTerrain(paths);
  if (!info) {
    return forward(info);
  }
  loaded.area = {info->southWest, info->northEast};
  loaded.frame = geo::LocalFrame(info->centre());
  Result<terrain::ElevationGrid> grid = terrain::readTerrain(paths, loaded.frame, {}, job);
  if (!grid) {
    return forward(grid);
  }
  loaded.grid = std::make_shared<const terrain::ElevationGrid>(std::move(*grid));
  for (const std::string& path : paths) {
    const Result<std::string> sha = terrain::sha256OfFile(path);
    if (!sha) {
      return forward(sha);
    }
    loaded.files.push_back({path, *sha});
  }
  return loaded;
}

Result<LoadedSites> loadSites(const mission::Mission& mission, const std::string& folder, const LoadedTerrain& terrain) {
  LoadedSites loaded;
  const Result<std::vector<mission::LandingSite>> sites = collectSites(mission, folder, terrain.area, loaded.notes);
  if (!sites) {
    return forward(sites);
  }
  loaded.usable = placeSites(*sites, terrain.frame, *terrain.grid, loaded.notes);
  mission::Mission open = mission;  // the same without what an operator rules out by hand
  open.siteFilter.exclude.clear();
  open.siteFilter.oneWay.clear();
  open.siteFilter.approximate = true;
  open.siteFilter.minLength.reset();
  if (open.siteFilter == mission.siteFilter) {
    return loaded;
  }
  std::vector<std::string> ignored;
  const Result<std::vector<mission::LandingSite>> all = collectSites(open, folder, terrain.area, ignored);
  if (!all) {
    return forward(all);
  }
  for (mission::SiteInFrame& site : placeSites(*all, terrain.frame, *terrain.grid, ignored)) {
    const auto sameId = [&site](const mission::SiteInFrame& used) { return used.site.id == site.site.id; };
    if (std::none_of(loaded.usable.begin(), loaded.usable.end(), sameId)) {
      loaded.leftOut.push_back(std::move(site));
    }
  }
  return loaded;
}

Result<LoadedMission> loadMission(const mission::Mission& mission, const std::string& folder, const Job& job) {
  Result<LoadedTerrain> terrain = loadTerrain(mission.terrain, folder, job.part(0.0, 0.8));
  if (!terrain) {
    return forward(terrain);
  }
  job.progress(0.9, "airfields");
  Result<LoadedSites> sites = loadSites(mission, folder, *terrain);
  if (!sites) {
    return forward(sites);
  }
  if (sites->usable.empty()) {
    return fail(Errc::NoLandingSite,
                "no usable landing site lies inside the terrain; load terrain that covers a runway, add airfields, or relax the site filter",
                terrain->files.empty() ? "" : terrain->files.front().path);
  }
  Result<std::vector<mission::TargetInFrame>> targets = placeTargets(mission, terrain->frame, *terrain->grid);
  if (!targets) {
    return forward(targets);
  }
  LoadedMission loaded;
  loaded.mission = mission;
  loaded.frame = terrain->frame;
  loaded.terrain = std::move(terrain->grid);
  loaded.terrainFiles = std::move(terrain->files);
  loaded.sites = std::move(sites->usable);
  loaded.targets = std::move(*targets);
  loaded.notes = std::move(sites->notes);
  return loaded;
}

Result<terrain::ElevationGrid> readPlanTerrain(const mission::Plan& plan, const std::string& planFolder, std::vector<std::string>& checksums,
                                               const Job& job) {
  std::vector<std::string> files;
  checksums.clear();
  for (const mission::TerrainReference& reference : plan.terrain) {
    files.push_back(resolvePath(planFolder, reference.path));
    Result<std::string> sha = terrain::sha256OfFile(files.back());
    if (!sha) {
      return fail(sha.error().code, sha.error().what + "; the plan needs the terrain it was made with to be verified", sha.error().where);
    }
    checksums.push_back(std::move(*sha));
  }
  terrain::ReadOptions options;
  options.cell = plan.terrainCell;
  return terrain::readTerrain(files, geo::LocalFrame(plan.frameOrigin), options, job);
}

}  // namespace vp::formats
