#pragma once

#include "core/base/quantity.h"
#include "core/geo/height.h"
#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

enum class Surface { Unknown, Hard, Gravel, Grass, Dirt, Water, Snow };

/** One runway end that a glide may land on: touchdown point, elevation and landing course. A usable runway gives two
 *  sites, a one-way runway one. Values as read from files; ENU comes with SiteInFrame (plan.h). */
struct LandingSite {
  std::string id;            ///< unique in a mission: airport ident and runway end, for example "LSZS/21"
  std::string airportIdent;  ///< "LSZS"
  std::string airportName;   ///< "Samedan"
  std::string runwayIdent;   ///< "21"; "" where the file has none
  geo::LatLon touchdown;     ///< threshold, moved by the displaced threshold
  geo::HeightMsl elevation;
  Angle landingCourse;           ///< true course flown when landing
  std::optional<Length> length;  ///< landing distance from the touchdown point to the other end
  std::optional<Length> width;
  Surface surface = Surface::Unknown;
  bool lighted = false;
  std::vector<std::string> approximations;  ///< what the file lacked and how it was derived; empty = all read
  std::string source;                       ///< file name it came from
  bool elevationFromTerrain = false;        ///< the file has no elevation; whoever places the site on terrain sets it and clears this

  [[nodiscard]] bool isApproximate() const { return !approximations.empty(); }
  bool operator==(const LandingSite&) const = default;
};

}  // namespace vp::mission
