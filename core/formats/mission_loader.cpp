#include "core/formats/mission_loader.h"

#include "core/aircraft/runway_wind.h"
#include "core/formats/airfield_candidates.h"
#include "core/formats/airfields.h"
#include "core/formats/airspace/openair.h"
#include "core/formats/mission_file.h"
#include "core/mission/runway_need.h"
#include "core/terrain/terrain_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sys/stat.h>

namespace vp::formats {
namespace {

/// Targets closer than this are one place to an aircraft [m].
constexpr double kSamePlace = 1.0;
/// Ground this far above a site's elevation means that one of the two is wrong [m]; 25 real aerodromes agree within 15 m.
constexpr double kElevationDoubt = 50.0;

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

/// Files as they are now; afterwards it can tell whether others were put in their place, or they were written to, meanwhile:
/// heights of one file must not pass with the checksum of another.
class FilesBefore {
public:
  explicit FilesBefore(const std::vector<std::string>& files) : files_(files) {
    for (const std::string& file : files_) {
      before_.push_back(entryOf(file));
    }
  }

  [[nodiscard]] Result<void> areTheSame() const {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      const struct stat now = entryOf(files_[i]);
      const struct stat& before = before_[i];
      if (now.st_dev != before.st_dev || now.st_ino != before.st_ino || now.st_size != before.st_size ||
          now.st_mtim.tv_sec != before.st_mtim.tv_sec || now.st_mtim.tv_nsec != before.st_mtim.tv_nsec) {
        return fail(Errc::BadFile, "the file was changed while it was read; try again when nothing writes to it any more", files_[i]);
      }
    }
    return {};
  }

private:
  static struct stat entryOf(const std::string& file) {
    struct stat entry {};
    (void)::stat(file.c_str(), &entry);  // what is not there is told by whoever reads it
    return entry;
  }

  std::vector<std::string> files_;
  std::vector<struct stat> before_;
};

Result<std::vector<mission::TargetInFrame>> placeTargets(const mission::Mission& mission, const geo::LocalFrame& frame,
                                                         const terrain::ElevationGrid& terrain) {
  std::vector<mission::TargetInFrame> placed;
  for (const mission::Target& target : mission.targets) {
    Result<mission::TargetInFrame> inFrame = placeTarget(target, frame, terrain);
    if (!inFrame) {
      return forward(inFrame);
    }
    if (const Result<void> apart = checkApart(placed, *inFrame); !apart) {
      return forward(apart);
    }
    placed.push_back(std::move(*inFrame));
  }
  return placed;
}

/// Sites of all sources inside an area that pass a filter.
struct Collected {
  std::vector<mission::LandingSite> sites;
  std::vector<std::string> notes;
  std::vector<std::string> unmatched;  ///< entries of the filter that match nothing
};

/// Leaves out what lies farther away than the filter allows.
void leaveOutDistant(const mission::Mission& mission, const mission::SiteFilter& filter, Collected& collected) {
  std::vector<geo::LatLon> from;
  if (filter.distanceFrom) {
    from.push_back(*filter.distanceFrom);
  } else {
    std::transform(mission.targets.begin(), mission.targets.end(), std::back_inserter(from), [](const mission::Target& t) { return t.position; });
  }
  if (!filter.maxDistance || from.empty()) {
    return;
  }
  const auto isDistant = [&](const mission::LandingSite& site) {
    return std::none_of(from.begin(), from.end(),
                        [&](const geo::LatLon& place) { return geo::geodesicDistance(place, site.touchdown) <= *filter.maxDistance; });
  };
  const std::size_t erased = std::erase_if(collected.sites, isDistant);
  if (erased > 0) {
    collected.notes.push_back(fmt::format("{} left out: farther than {:.1f} km from {}", erased, filter.maxDistance->si() / 1000.0,
                                          filter.distanceFrom ? "the point that the mission gives" : "every target"));
  }
}

Result<Collected> collectSites(const mission::Mission& mission, const mission::SiteFilter& filter, const std::string& folder, const geo::GeoBox& area,
                               const Job& job) {
  std::vector<AirfieldReport> reports;
  reports.push_back(filterSites(mission.sites, filter, std::nullopt));
  for (const mission::AirfieldSource& source : mission.airfields) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the airfields was stopped");
    }
    Result<AirfieldReport> report = readAirfields(source, folder, filter, area);
    if (!report) {
      return forward(report);
    }
    reports.push_back(std::move(*report));
  }
  Collected collected;
  for (const AirfieldReport& report : reports) {
    collected.sites.insert(collected.sites.end(), report.sites.begin(), report.sites.end());
    collected.notes.insert(collected.notes.end(), report.notes.begin(), report.notes.end());
  }
  collected.unmatched = unmatchedNames(filter, reports);
  leaveOutDistant(mission, filter, collected);
  makeIdsUnique(collected.sites);
  return collected;
}

/// Two readings of one runway end; ids are numbered after the filter and may differ between the two.
bool isSameEnd(const mission::SiteInFrame& a, const mission::SiteInFrame& b) {
  return a.pose == b.pose && a.site.airportIdent == b.site.airportIdent && a.site.runwayIdent == b.site.runwayIdent && a.site.source == b.site.source;
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

/// By boxes of latitude and longitude, with a tenth of a degree to spare; across the 180th meridian: always.
bool reachesInto(const mission::Airspace& airspace, const geo::GeoBox& area) {
  constexpr double kSpare = 0.1;
  double south = 90.0;
  double north = -90.0;
  double west = 180.0;
  double east = -180.0;
  for (const geo::LatLon& corner : airspace.outline) {
    south = std::min(south, corner.latitude_deg);
    north = std::max(north, corner.latitude_deg);
    west = std::min(west, corner.longitude_deg);
    east = std::max(east, corner.longitude_deg);
  }
  const bool isNear = south <= area.northEast.latitude_deg + kSpare && north >= area.southWest.latitude_deg - kSpare;
  const bool wraps = east - west > 180.0 || area.southWest.longitude_deg > area.northEast.longitude_deg;
  return isNear && (wraps || (west <= area.northEast.longitude_deg + kSpare && east >= area.southWest.longitude_deg - kSpare));
}

/// Moves sites that are unfit from the usable ones to those that are left out.
/// @param reasonOf  why a site is unfit, part of a sentence; empty if it is not   @param what  as of LeftOut::sentences
/// @return the first reason with its sites; "" if none is unfit
template <typename ReasonOf>
std::string leaveOutUnfit(const ReasonOf& reasonOf, const std::string& what, LoadedSites& sites) {
  LeftOut unfit;
  std::vector<mission::SiteInFrame> fit;
  for (mission::SiteInFrame& site : sites.usable) {
    const std::string reason = reasonOf(site.site);
    if (reason.empty()) {
      fit.push_back(std::move(site));
    } else {
      unfit.add(reason, site.site.id);
      sites.leftOut.push_back(std::move(site));
    }
  }
  sites.usable = std::move(fit);
  const std::vector<std::string> sentences = unfit.sentences(what);
  sites.notes.insert(sites.notes.end(), sentences.begin(), sentences.end());
  return sentences.empty() ? "" : sentences.front();
}

/// Leaves out what the wind or the length of a runway makes unfit for the aircraft.
void leaveOutUnfit(const mission::Mission& mission, LoadedSites& sites) {
  const std::vector<mission::SiteInFrame> all = sites.usable;  // the other ends of runways are looked for among them
  sites.tooWindy = leaveOutUnfit(
      [&mission](const mission::LandingSite& site) {
        return aircraft::againstLanding(mission.aircraft, aircraft::runwayWind(mission.wind, site.elevation, site.landingCourse));
      },
      "not landed on in this wind", sites);
  sites.tooShort = leaveOutUnfit([&](const mission::LandingSite& site) { return mission::tooShort(mission, site, all); },
                                 "too short to be landed on that day", sites);
}

}  // namespace

Result<void> checkApart(const std::vector<mission::TargetInFrame>& earlier, const mission::TargetInFrame& target) {
  for (const mission::TargetInFrame& other : earlier) {
    if (geo::distance(other.point, target.point) < kSamePlace) {
      return fail(Errc::OutOfRange,
                  fmt::format("targets {} and {} are at the same place; remove one of them", other.target.name, target.target.name));
    }
  }
  return {};
}

Error unmatchedFilterError(const std::vector<std::string>& unmatched) {
  // a misspelt name would silently leave a runway in that somebody ruled out
  return {Errc::OutOfRange,
          fmt::format("siteFilter names {}, but no landing site inside the terrain is called that; correct the name or remove it", unmatched.front()),
          {}};
}

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
  paths.reserve(files.size());
  for (const std::string& file : files) {
    paths.push_back(absolute(resolvePath(folder, file)));
  }
  const FilesBefore before(paths);
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
    const Result<std::string> sha = terrain::sha256OfFile(path, job);
    if (!sha) {
      return forward(sha);
    }
    loaded.files.push_back({path, *sha});
  }
  if (const Result<void> same = before.areTheSame(); !same) {
    return forward(same);
  }
  return loaded;
}

Result<LoadedSites> loadSites(const mission::Mission& mission, const std::string& folder, const LoadedTerrain& terrain, bool withLeftOut,
                              const Job& job) {
  Result<Collected> collected = collectSites(mission, mission.siteFilter, folder, terrain.area, job);
  if (!collected) {
    return forward(collected);
  }
  LoadedSites loaded;
  loaded.notes = std::move(collected->notes);
  loaded.unmatchedFilter = std::move(collected->unmatched);
  loaded.usable = placeSites(collected->sites, terrain.frame, *terrain.grid, loaded.notes);
  leaveOutUnfit(mission, loaded);
  mission::SiteFilter open = mission.siteFilter;  // the same without what an operator rules out by hand
  open.exclude.clear();
  open.oneWay.clear();
  open.approximate = true;
  open.minLength.reset();
  open.minWidth.reset();
  open.surfaces.clear();
  open.lighted = false;
  open.maxDistance.reset();
  open.notes.clear();
  if (!withLeftOut || open == mission.siteFilter) {
    return loaded;
  }
  std::vector<std::string> ignored;
  const Result<Collected> all = collectSites(mission, open, folder, terrain.area, job);
  if (!all) {
    return forward(all);
  }
  for (mission::SiteInFrame& site : placeSites(all->sites, terrain.frame, *terrain.grid, ignored)) {
    const auto isKnown = [&site](const auto& other) { return isSameEnd(site, other); };
    if (std::none_of(loaded.usable.begin(), loaded.usable.end(), isKnown) && std::none_of(loaded.leftOut.begin(), loaded.leftOut.end(), isKnown)) {
      loaded.leftOut.push_back(std::move(site));
    }
  }
  return loaded;
}

Result<LoadedAirspaces> loadAirspaces(const mission::Mission& mission, const std::string& folder, const geo::GeoBox& area, const Job& job) {
  LoadedAirspaces loaded;
  std::set<std::string> kinds;
  for (const std::string& file : mission.airspace.files) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the airspaces was stopped");
    }
    Result<AirspaceReport> report = readOpenAir(absolute(resolvePath(folder, file)));
    if (!report) {
      return forward(report);
    }
    for (mission::Airspace& airspace : report->airspaces) {
      kinds.insert(airspace.kind);
      if (!reachesInto(airspace, area)) {
        continue;
      }
      if (useOf(airspace, mission.airspace) == mission::AirspaceUse::Hide) {
        airspace.outline.clear();
        loaded.hidden.push_back(std::move(airspace));
      } else {
        loaded.airspaces.push_back(std::move(airspace));
      }
    }
    loaded.notes.insert(loaded.notes.end(), report->notes.begin(), report->notes.end());
  }
  loaded.kinds.assign(kinds.begin(), kinds.end());
  return loaded;
}

std::vector<mission::Airspace> airspacesToCheck(const std::vector<mission::Airspace>& airspaces, const mission::AirspaceSettings& settings) {
  std::vector<mission::Airspace> chosen;
  std::copy_if(airspaces.begin(), airspaces.end(), std::back_inserter(chosen), [&](const mission::Airspace& airspace) {
    const mission::AirspaceUse use = useOf(airspace, settings);
    return use == mission::AirspaceUse::Warn || use == mission::AirspaceUse::Forbid;
  });
  return chosen;
}

Result<LoadedMission> loadMission(const mission::Mission& mission, const std::string& folder, const Job& job) {
  Result<LoadedTerrain> terrain = loadTerrain(mission.terrain, folder, job.part(0.0, 0.8));
  if (!terrain) {
    return forward(terrain);
  }
  job.progress(0.9, "airfields");
  Result<LoadedSites> sites = loadSites(mission, folder, *terrain, false, job);
  if (!sites) {
    return forward(sites);
  }
  if (!sites->unmatchedFilter.empty()) {
    return tl::unexpected<Error>(unmatchedFilterError(sites->unmatchedFilter));
  }
  if (sites->usable.empty() && !sites->tooWindy.empty()) {
    return fail(Errc::NoLandingSite,
                fmt::format("in this wind the aircraft may land on no runway inside the terrain: {}; wait for less wind, load terrain with other "
                            "runways, or correct the limits of the aircraft",
                            sites->tooWindy),
                terrain->files.empty() ? "" : terrain->files.front().path);
  }
  if (sites->usable.empty() && !sites->tooShort.empty()) {
    return fail(Errc::NoLandingSite,
                fmt::format("every runway inside the terrain is too short for the aircraft on that day: {}; load terrain with other runways, or "
                            "correct the landing distance of the aircraft",
                            sites->tooShort),
                terrain->files.empty() ? "" : terrain->files.front().path);
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
  Result<LoadedAirspaces> airspaces = loadAirspaces(mission, folder, terrain->area, job);
  if (!airspaces) {
    return forward(airspaces);
  }
  LoadedMission loaded;
  loaded.airspaces = airspacesToCheck(airspaces->airspaces, mission.airspace);
  loaded.mission = mission;
  loaded.frame = terrain->frame;
  loaded.terrain = std::move(terrain->grid);
  loaded.terrainFiles = std::move(terrain->files);
  loaded.sites = std::move(sites->usable);
  loaded.targets = std::move(*targets);
  loaded.notes = std::move(sites->notes);
  loaded.notes.insert(loaded.notes.end(), airspaces->notes.begin(), airspaces->notes.end());
  return loaded;
}

Result<terrain::ElevationGrid> readPlanTerrain(const mission::Plan& plan, const std::string& planFolder, std::vector<std::string>& checksums,
                                               const Job& job) {
  std::vector<std::string> files;
  checksums.clear();
  for (const mission::TerrainReference& reference : plan.terrain) {
    files.push_back(resolvePath(planFolder, reference.path));
  }
  const FilesBefore before(files);
  for (const std::string& file : files) {
    Result<std::string> sha = terrain::sha256OfFile(file, job);
    if (!sha && sha.error().code == Errc::Cancelled) {
      return forward(sha);
    }
    if (!sha) {
      return fail(sha.error().code, sha.error().what + "; the plan needs the terrain it was made with to be verified", sha.error().where);
    }
    checksums.push_back(std::move(*sha));
  }
  terrain::ReadOptions options;
  options.cell = plan.terrainCell;
  Result<terrain::ElevationGrid> grid = terrain::readTerrain(files, geo::LocalFrame(plan.frameOrigin), options, job);
  const Result<void> same = grid ? before.areTheSame() : Result<void>();
  return same ? std::move(grid) : Result<terrain::ElevationGrid>(forward(same));
}

}  // namespace vp::formats
