#pragma once
// The 108 cases of [3] section 6.3 rebuilt: 9 places x 3 altitudes x 4 headings around runway 15R of Long Island MacArthur Airport (KISP), with the
// Census 2000 tracts of Suffolk County. What differs from the paper stands in tests/bench/README.md.
#include "core/emergency/gradient_options.h"
#include "core/emergency/landing_request.h"
#include "core/formats/aircraft_file.h"
#include "core/formats/population_file.h"
#include "core/landing/approach.h"
#include "core/risk/population.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::test {

/// What all cases share.
struct ContingencySetting {
  geo::LocalFrame frame;
  std::shared_ptr<const mission::Mission> mission;
  std::shared_ptr<const landing::World> world;
  std::shared_ptr<const risk::Population> population;  ///< with the paper's rule for outliers
  landing::Approach approach;                          ///< 1 NM straight to runway 15R
};

struct ContingencyCase {
  double altitude_ft = 0.0;  ///< MSL
  geo::Pose pose;
};

/// Long Island MacArthur Airport's runway 15R, as OurAirports has it (May 2026): threshold, elevation 99 ft, 135 degrees true.
inline mission::LandingSite runway15R() {
  mission::LandingSite site;
  site.id = "KISP/15R";
  site.airportIdent = "KISP";
  site.airportName = "Long Island MacArthur Airport";
  site.runwayIdent = "15R";
  site.touchdown = {40.80220031738281, -73.1072998046875};
  site.landingCourse = Angle::degrees(135.0);
  site.elevation = geo::HeightMsl::fromMetres(99.0 * kMetresPerFoot);
  site.length = Length::fromSi(5186.0 * kMetresPerFoot);
  site.width = Length::fromSi(150.0 * kMetresPerFoot);
  site.surface = mission::Surface::Hard;
  return site;
}

/** @param census  file of the tracts   @param wind  layers; none: calm as in section 6.3 */
inline Result<ContingencySetting> contingencySetting(const std::string& census, const std::vector<air::WindLayer>& wind = {}) {
  ContingencySetting setting;
  const mission::LandingSite site = runway15R();
  setting.frame = geo::LocalFrame(site.touchdown);
  auto mission = std::make_shared<mission::Mission>();
  const Result<aircraft::AircraftProfile> profile = formats::findAircraft("cessna182-gradient", "");
  if (!profile) {
    return forward(profile);
  }
  mission->aircraft = *profile;
  mission->sites = {site};
  mission->wind = wind;
  mission->approach.kind = mission::ApproachKind::Straight;
  mission->approach.finalLength = Length::fromSi(kMetresPerNauticalMile);
  mission->approach.surfaceSlope = 0.05;  // ICAO Annex 14, code number 1
  // flat ground at the runway's elevation: the terrain of this part of Long Island lies between 0 and 80 m, and there is no model of it here
  constexpr double kHalf = 40000.0;
  constexpr double kCell = 250.0;
  constexpr int kCells = static_cast<int>(2.0 * kHalf / kCell);
  auto grid = std::make_shared<const terrain::ElevationGrid>(
      -kHalf, -kHalf, kCell, kCells, kCells,
      std::vector<float>(static_cast<std::size_t>(kCells) * kCells, static_cast<float>(site.elevation.metres())));
  const mission::SiteInFrame placed{site, {0.0, 0.0, setting.frame.headingOf(site.landingCourse, site.touchdown)}};
  auto world = std::make_shared<landing::World>(landing::worldOf(*mission, {placed}, terrain::TerrainPyramid(grid)));
  const Result<landing::Approach> approach = landing::approachTo(*world, 0);
  if (!approach) {
    return forward(approach);
  }
  const Result<formats::PopulationReport> report = formats::readPopulation(census);
  if (!report) {
    return forward(report);
  }
  Result<risk::Population> population = risk::Population::from(report->areas, setting.frame, risk::Outliers::ThirdQuartile);
  if (!population) {
    return forward(population);
  }
  setting.approach = *approach;
  setting.mission = mission;
  setting.world = world;
  setting.population = std::make_shared<const risk::Population>(std::move(*population));
  return setting;
}

/// Around the fix where the final approach begins, so near that the paper's turns reach it from 4000 ft on every heading.
inline std::vector<ContingencyCase> contingencyCases(const ContingencySetting& setting, double spacing = 3500.0) {
  std::vector<ContingencyCase> cases;
  const geo::Point gate = setting.approach.gate.point();
  for (const double altitude : {4000.0, 6000.0, 10000.0}) {
    for (const int column : {-1, 0, 1}) {
      for (const int row : {-1, 0, 1}) {
        for (const double course : {0.0, 90.0, 180.0, 270.0}) {
          cases.push_back({altitude, {gate.x + spacing * column, gate.y + spacing * row, wrapTwoPi(Angle::degrees(90.0 - course).radians())}});
        }
      }
    }
  }
  return cases;
}

inline emergency::LandingRequest requestOf(const ContingencySetting& setting, const ContingencyCase& one) {
  emergency::LandingRequest request;
  request.pose = one.pose;
  request.altitude = one.altitude_ft * kMetresPerFoot;
  request.world = setting.world;
  request.mission = setting.mission;
  request.frameOrigin = setting.frame.origin();
  return request;
}

}  // namespace vp::test
