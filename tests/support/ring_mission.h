#pragma once
// A plan input over the small mountain, without any file.

#include "core/tour/planner.h"
#include "tests/support/mountain.h"

#include <cmath>
#include <string>

namespace vp::test {

inline void addTarget(tour::PlanInput& input, const std::string& name, geo::Point place) {
  mission::Target target;
  target.name = name;
  target.position = input.frame.toLatLon(place);
  const geo::Point placed = input.frame.toPoint(target.position);
  input.mission.targets.push_back(target);
  input.targets.push_back({target, placed, input.terrain->upperAt(placed) + 100.0});
}

/** The mountain around 47 N 11 E with its runways and no targets; few samples, four headings, 100 m steps. */
inline tour::PlanInput mountainInput() {
  tour::PlanInput input;
  const landing::World world = mountainWorld();
  input.frame = geo::LocalFrame({47.0, 11.0});
  input.terrain = std::make_shared<const terrain::ElevationGrid>(world.terrain.grid());
  input.terrainFiles = {{"mountain.tif", std::string(64, '0')}};
  input.mission.name = "test";
  input.mission.terrain = {"mountain.tif"};
  input.mission.aircraft = paperCessna();
  input.mission.planner.headings = 4;
  input.mission.planner.step = Length::fromSi(100.0);
  input.mission.planner.roadmapSamples = 800;
  input.createdBy = "test";
  for (mission::SiteInFrame site : world.sites) {
    site.site.airportIdent = site.site.id.substr(0, 1);
    site.site.touchdown = input.frame.toLatLon(site.pose.point());
    site.site.landingCourse = input.frame.trueCourseOf(site.pose.heading, site.pose.point());
    input.mission.sites.push_back(site.site);
    input.sites.push_back(site);
  }
  return input;
}

}  // namespace vp::test
