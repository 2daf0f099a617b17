#pragma once
// Requests to the landing planners over worlds from formulas, with the mission that the checker needs beside the world.

#include "core/emergency/landing_request.h"
#include "tests/support/mountain.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vp::test {

inline constexpr geo::LatLon kLandingOrigin{46.5, 9.8};

/// A site of a mission: where it is on earth agrees with where it is in the frame.
inline mission::SiteInFrame placedSite(const char* id, const geo::Pose& pose, double elevation) {
  const geo::LocalFrame frame(kLandingOrigin);
  mission::SiteInFrame placed = site(id, pose.x, pose.y, pose.heading, elevation);
  placed.site.airportIdent = placed.site.id.substr(0, placed.site.id.find('/'));
  placed.site.runwayIdent = placed.site.id.substr(placed.site.id.find('/') + 1);
  placed.site.touchdown = frame.toLatLon(pose.point());
  placed.site.landingCourse = frame.trueCourseOf(pose.heading, pose.point());
  placed.site.length = Length::fromSi(1500.0);
  placed.site.surface = mission::Surface::Hard;
  return placed;
}

/// A mission without targets: all that glides depend on.
inline mission::Mission landingMission(const aircraft::AircraftProfile& profile = paperCessna()) {
  mission::Mission mission;
  mission.name = "landing";
  mission.aircraft = profile;
  return mission;
}

/// The request of an aircraft over a grid; ten seconds, so that counts decide and not the clock.
inline emergency::LandingRequest landingRequest(const mission::Mission& mission, std::vector<mission::SiteInFrame> sites,
                                                const std::shared_ptr<const terrain::ElevationGrid>& grid, const geo::Pose& pose, double altitude) {
  mission::Mission own = mission;
  own.sites.clear();  // the checker asks where a site comes from
  for (const mission::SiteInFrame& one : sites) {
    own.sites.push_back(one.site);
  }
  emergency::LandingRequest request;
  request.pose = pose;
  request.altitude = altitude;
  request.mission = std::make_shared<const mission::Mission>(own);
  request.world = std::make_shared<const landing::World>(landing::worldOf(own, std::move(sites), terrain::TerrainPyramid(grid)));
  request.frameOrigin = kLandingOrigin;
  request.deadline = 10.0;
  return request;
}

/// The paper's aircraft with one bank angle in glides.
inline aircraft::AircraftProfile oneBankCessna() {
  aircraft::AircraftProfile profile = paperCessna();
  profile.glideBanks = {Angle::degrees(45.0)};
  return profile;
}

/// The mountain of mountain.h with sites that are placed on earth.
inline emergency::LandingRequest mountainRequest(const mission::Mission& mission, const geo::Pose& pose, double altitude) {
  const auto grid = makeGrid(5000.0, 20.0, mountainHeight);
  std::vector<mission::SiteInFrame> sites;
  for (const mission::SiteInFrame& one : mountainWorld().sites) {
    sites.push_back(placedSite(one.site.id.c_str(), one.pose, one.site.elevation.metres()));
  }
  return landingRequest(mission, std::move(sites), grid, pose, altitude);
}

/// Flat ground at sea level, 12 x 12 km.
inline std::shared_ptr<const terrain::ElevationGrid> flatGrid() {
  return makeGrid(12000.0, 100.0, [](double, double) { return 0.0; });
}

/// Flat ground but for a wall from the south to the north edge, 40 m thick at x = 0, with a gap for y in (south, north).
inline std::shared_ptr<const terrain::ElevationGrid> wallGrid(double south, double north) {
  return makeGrid(8000.0, 20.0, [south, north](double x, double y) { return std::abs(x) <= 10.0 && (y <= south || y >= north) ? 5000.0 : 0.0; });
}

}  // namespace vp::test
