#include "maps/worlds.h"

#include "maps/airstrip.h"
#include "maps/height_field.h"
#include "maps/mission_text.h"

#include <cmath>
#include <vector>

namespace vp::maps {
namespace {

constexpr int kSize = 501;         // posts: 10 km at 20 m; the figures' axes are not given in the paper's text
constexpr double kSpacing = 20.0;  // m
constexpr double kRunway = 600.0;  // m, length of every runway
constexpr double kBlock = 450.0;   // m, height of the obstacles, caption of Fig. 4

const geo::LocalFrame kFrame(geo::LatLon{47.0, -26.0});

/// An upright block: posts within the rectangle have its height.
void raise(HeightField& field, const geo::Box& box, double height) {
  for (int j = 0; j < field.size(); ++j) {
    for (int i = 0; i < field.size(); ++i) {
      if (box.contains({field.coordinate(i), field.coordinate(j)})) {
        field.at(i, j) = height;
      }
    }
  }
}

/// A runway that is landed on from `touchdown` towards a direction (dx, dy) of the frame only.
SiteText oneWaySite(const std::string& ident, const std::string& name, geo::Point touchdown, double dx, double dy, double elevation) {
  const double norm = std::sqrt(dx * dx + dy * dy);
  const geo::Point end{touchdown.x + kRunway * dx / norm, touchdown.y + kRunway * dy / norm};
  const Airstrip strip{ident, name, touchdown, end, 30.0, "hard", elevation};
  return siteOf(kFrame, strip, touchdown, end);
}

Result<void> writeWorld(const HeightField& field, const std::string& name, const std::string& title, const std::vector<SiteText>& sites,
                        const std::string& folder) {
  if (const auto written = writeGeoTiff(field, kFrame, SampleType::Int16, folder + "/" + name + ".tif"); !written) {
    return written;
  }
  MissionText mission;
  mission.name = title;
  mission.terrain = name + ".tif";
  mission.sites = sites;
  mission.aircraft = "cessna172-elasp";
  mission.clearance = 0.0;
  return writeMission(mission, folder + "/" + name + ".vpm");
}

}  // namespace

Result<void> writeWorlds(const std::string& folder) {
  const SiteText first = oneWaySite("SITE1", "First site", {0.0, 0.0}, 1.0, 0.0, 0.0);

  // Fig. 3, caption: (0, 0, 0) km heading 90 degrees and (-2.5, 1.5, 0.1) km heading 315 degrees.
  const geo::Point second{-2500.0, 1500.0};
  const SiteText secondSite = oneWaySite("SITE2", "Second site", second, -1.0, 1.0, 100.0);
  HeightField twoRunways(kSize, kSpacing);
  raise(twoRunways, {second.x - 480.0, second.y - 60.0, second.x + 60.0, second.y + 480.0}, 100.0);
  if (const auto written = writeWorld(twoRunways, "two-runways", "Two one-way runways at different heights", {first, secondSite}, folder); !written) {
    return written;
  }

  // Fig. 4: above without, below with obstacles.
  HeightField blocks(kSize, kSpacing);
  if (const auto written = writeWorld(blocks, "flat", "One one-way runway on flat ground", {first}, folder); !written) {
    return written;
  }
  raise(blocks, {-3000.0, -1400.0, -2200.0, 1000.0}, kBlock);  // across the approach
  raise(blocks, {-1200.0, 1600.0, 1600.0, 2200.0}, kBlock);    // north of the runway
  raise(blocks, {1400.0, -3200.0, 2000.0, -1000.0}, kBlock);   // south-east of it
  return writeWorld(blocks, "three-blocks", "One one-way runway among three blocks", {first}, folder);
}

}  // namespace vp::maps
