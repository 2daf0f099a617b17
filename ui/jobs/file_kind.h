#pragma once

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
  std::vector<std::string> airspaces;  ///< OpenAir
};

/** Tells terrain from airfields by content (formats::airfieldFileOf); the airports and runways of one OurAirports download belong
 *  together, given at once or with the other lying beside; everything else has to be a raster. Files that the mission names already are skipped.
 *  @errors BadFile - fits nothing, an airports file without its runways, or all of it is there already */
Result<NewFiles> sortFiles(const QStringList& paths, const mission::Mission& mission);

}  // namespace vp::jobs
