#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/geo_box.h"
#include "core/geo/local_frame.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::formats {

/** A mission with everything that its files name, placed in the local frame. */
struct LoadedMission {
  mission::Mission mission;
  geo::LocalFrame frame;  ///< centred on the terrain
  std::shared_ptr<const terrain::ElevationGrid> terrain;
  std::vector<mission::TerrainReference> terrainFiles;  ///< absolute paths
  std::vector<mission::SiteInFrame> sites;              ///< usable, on known terrain
  std::vector<mission::TargetInFrame> targets;
  std::vector<std::string> notes;                 ///< what was left out or derived, for the operator; one sentence each
  std::vector<mission::Airspace> airspaces = {};  ///< that the mission warns of or forbids, near the terrain
};

/** Terrain of a mission in the local frame that is centred on it. */
struct LoadedTerrain {
  geo::LocalFrame frame;
  std::shared_ptr<const terrain::ElevationGrid> grid;
  std::vector<mission::TerrainReference> files;  ///< absolute paths
  geo::GeoBox area;                              ///< covered by the files
};

/** Landing sites of a mission on its terrain. */
struct LoadedSites {
  std::vector<mission::SiteInFrame> usable;
  std::vector<mission::SiteInFrame> leftOut;  ///< on known terrain, but ruled out by the site filter, the wind or the length of the runway
  std::vector<std::string> notes;
  std::string tooWindy;                      ///< why the wind leaves out some that the filter lets count; "" if it leaves out none
  std::string tooShort;                      ///< the same of runways that are too short for the aircraft
  std::vector<std::string> unmatchedFilter;  ///< entries of the filter that name no site here: most likely misspelt, so not to be planned with
};

/** The first step of loadMission alone: a user interface shows terrain that still has no sites and no targets.
 *  @param files  as in Mission::terrain   @errors those of terrain::inspectTerrain and readTerrain, Cancelled   @threads pure */
Result<LoadedTerrain> loadTerrain(const std::vector<std::string>& files, const std::string& folder, const Job& job);

/** The second step alone; neither no usable site nor a name in the filter that nothing has is an error here.
 *  @param withLeftOut  reads the sources a second time, to know what the filter leaves out
 *  @errors those of the readers, Cancelled   @threads pure */
Result<LoadedSites> loadSites(const mission::Mission& mission, const std::string& folder, const LoadedTerrain& terrain, bool withLeftOut,
                              const Job& job);

/** Airspaces of a mission that reach into the area of its terrain, and what else its files hold. */
struct LoadedAirspaces {
  std::vector<mission::Airspace> airspaces;  ///< that are not hidden
  std::vector<mission::Airspace> hidden;     ///< those that the settings hide, without their outlines
  std::vector<std::string> kinds;            ///< classes of all airspaces of the files, in this area or not; sorted, each once
  std::vector<std::string> notes;
};

/** Reads Mission::airspace. @errors those of readOpenAir, Cancelled   @threads pure */
Result<LoadedAirspaces> loadAirspaces(const mission::Mission& mission, const std::string& folder, const geo::GeoBox& area, const Job& job);

/** Those of them that a plan has to be checked against: what the mission warns of or forbids. */
std::vector<mission::Airspace> airspacesToCheck(const std::vector<mission::Airspace>& airspaces, const mission::AirspaceSettings& settings);

/** What to tell about LoadedSites::unmatchedFilter. @pre it is not empty */
Error unmatchedFilterError(const std::vector<std::string>& unmatched);

/** The third step for one target. @errors MissingTerrain, OutOfRange (below the ground) */
Result<mission::TargetInFrame> placeTarget(const mission::Target& target, const geo::LocalFrame& frame, const terrain::ElevationGrid& terrain);

/** Refuses a target at the place of an earlier one. @errors OutOfRange naming both */
Result<void> checkApart(const std::vector<mission::TargetInFrame>& earlier, const mission::TargetInFrame& target);

/** Loads what a mission names: terrain, airfields, targets.
 *  @param folder  that the mission's relative paths start from
 *  @errors those of the readers; MissingTerrain (a target outside the terrain or where it has no data), NoLandingSite
 *  (none inside the terrain), OutOfRange (two targets at one place, a target below the ground, a name in the filter that nothing has), Cancelled
 * @threads pure */
Result<LoadedMission> loadMission(const mission::Mission& mission, const std::string& folder, const Job& job);

/** Terrain of a plan, read afresh for the checker: the files that the plan names, in the plan's frame and cell size.
 *  @param checksums  receives the SHA-256 of each file as it is now
 *  @errors those of terrain::readTerrain;  BadFile - a file was changed or replaced while it was read */
Result<terrain::ElevationGrid> readPlanTerrain(const mission::Plan& plan, const std::string& planFolder, std::vector<std::string>& checksums,
                                               const Job& job);

}  // namespace vp::formats
