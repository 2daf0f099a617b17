// Mission files of the generated maps.
#pragma once

#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "maps/airstrip.h"

#include <string>
#include <vector>

namespace vp::maps {

/** A landing site as a mission lists it. */
struct SiteText {
  std::string airport;
  std::string airportName;
  std::string runway;
  geo::LatLon touchdown;
  double elevation = 0.0;  ///< m
  double course_deg = 0.0;
  double length = 0.0;  ///< m
  double width = 0.0;   ///< m
  std::string surface;  ///< one of the words of mission files: "hard", "grass", ...
};

/** The site of a landing at `from` towards `to` on a strip. */
SiteText siteOf(const geo::LocalFrame& frame, const Airstrip& strip, geo::Point from, geo::Point to);

struct TargetText {
  std::string name;
  geo::LatLon position;
  double height = 100.0;  ///< m above ground
};

/** What differs between the generated missions. */
struct MissionText {
  std::string name;
  std::string terrain;
  std::string airports;  ///< OurAirports files; empty for none
  std::string runways;
  std::vector<SiteText> sites;
  std::string aircraft;
  std::vector<TargetText> targets;
  double clearance = 100.0;   ///< m
  double step = 50.0;         ///< m
  std::string roadmap;        ///< kind of roadmap as in mission files; empty leaves it out
  int roadmapSamples = 7500;  ///< 0 leaves the choice to the planner
};

/** Writes a mission file (JSON, format "volplane-mission"). @errors OutputFailed */
Result<void> writeMission(const MissionText& mission, const std::string& path);

/** Writes a text file as it is. @errors OutputFailed */
Result<void> writeText(const std::string& text, const std::string& path);

}  // namespace vp::maps
