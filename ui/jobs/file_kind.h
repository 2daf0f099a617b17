#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/mission.h"

#include <QStringList>

#include <string>
#include <vector>

namespace vp::jobs {

/** Files that an operator gave, sorted by what they are; absolute paths. */
struct NewFiles {
  std::vector<std::string> terrain;
  std::vector<mission::AirfieldSource> airfields;
  std::vector<std::string> airspaces;   ///< OpenAir
  std::vector<std::string> population;  ///< polygons with people
  [[nodiscard]] std::size_t count() const { return terrain.size() + airfields.size() + airspaces.size() + population.size(); }
};

/** The same with files of targets and weather, which are read and not named by a mission. */
struct SortedFiles {
  NewFiles map;
  QStringList weather;
  QStringList targets;
  QStringList either;  ///< airfields or targets: the columns fit both
};

/** Tells terrain from airfields by content (formats::airfieldFileOf); the airports and runways of one OurAirports download belong
 *  together, given at once or with the other lying beside; polygons are told by their fields (formats::isPopulationFile, isWeatherFile); everything
 *  else has to be a raster.
 *  @errors BadFile - fits nothing, or an airports file without its runways; those of terrain::inspectTerrain; Cancelled
 *  @threads pure; opens the files, so call it on a worker */
Result<NewFiles> sortFiles(const QStringList& paths, const Job& job = {});

/** The same where files of targets and weather are welcome too. */
Result<SortedFiles> sortAllFiles(const QStringList& paths, const Job& job = {});

/** Those that the mission does not name yet. @errors BadFile - none of them */
Result<NewFiles> newTo(const mission::Mission& mission, NewFiles files);

}  // namespace vp::jobs
