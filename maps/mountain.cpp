#include "maps/mountain.h"

#include "maps/airstrip.h"
#include "maps/deterministic.h"
#include "maps/erosion.h"
#include "maps/height_field.h"
#include "maps/mission_text.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <vector>

namespace vp::maps {
namespace {

constexpr int kSize = 251;           // posts: 5 km at 20 m
constexpr double kSpacing = 20.0;    // m
constexpr double kHighest = 1500.0;  // m, Vana, Faigl, Slama 2020, section 8
constexpr double kUnit = 0.25;       // m: exact in 32-bit floats and in decimals
constexpr std::uint64_t kSeed = 8;

const geo::LocalFrame kFrame(geo::LatLon{47.0, -25.0});

/// Where the massif rises: a crooked, elongated body with spurs, low ground around it.
double uplift(double x, double y) {
  const double warpX = x + 450.0 * fractalNoise(x / 1500.0, y / 1500.0, kSeed + 100, 3);
  const double warpY = y + 450.0 * fractalNoise(x / 1500.0, y / 1500.0, kSeed + 200, 3);
  const double along = (warpX - 60.0) * 0.8 - (warpY - 60.0) * 0.6;  // axis towards ESE
  const double across = (warpX - 60.0) * 0.6 + (warpY - 60.0) * 0.8;
  const double distance = std::sqrt(along * along / (2500.0 * 2500.0) + across * across / (1900.0 * 1900.0));
  return 0.018 + 0.982 * (1.0 - smoothStep(0.12, 1.08, distance));
}

HeightField mountain(std::vector<Airstrip>& strips) {
  Tectonics tectonics;
  tectonics.uplift = uplift;
  tectonics.hardness = [](double x, double y) {
    return 1.0 + 0.4 * fractalNoise(x / 600.0, y / 600.0, kSeed + 300, 3) + 0.45 * valueNoise(x / 45.0, y / 45.0, kSeed + 400);
  };
  tectonics.steepness = 230.0;
  tectonics.talus = 1.15;
  tectonics.diffusion = 0.07;
  HeightField field = erode(kSize, kSpacing, tectonics, {220, 60}, kSeed);
  bend(field, 90.0, 350.0, kSeed + 500);
  field.stretchTo(0.0, kHighest);
  for (Airstrip& strip : strips) {
    levelGround(field, strip, 70.0, 220.0, kUnit);
  }
  field.roundHeights(kUnit);
  return field;
}

std::vector<TargetText> targets(int count) {
  constexpr double kBorder = 300.0;  // m: room for a turning circle of the paper's Cessna
  constexpr double kApart = 100.0;   // m
  Random random(kSeed * 1000 + static_cast<std::uint64_t>(count));
  const double reach = (kSize - 1) / 2.0 * kSpacing - kBorder;
  std::vector<geo::Point> points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const double x = roundTo(random.uniform(-reach, reach), 1.0);
    const double y = roundTo(random.uniform(-reach, reach), 1.0);
    bool free = true;
    for (const geo::Point& other : points) {
      free = free && (other.x - x) * (other.x - x) + (other.y - y) * (other.y - y) >= kApart * kApart;
    }
    if (free) {
      points.push_back({x, y});
    }
  }
  std::vector<TargetText> result;
  result.reserve(points.size());
  for (const geo::Point& point : points) {
    result.push_back({fmt::format("T{:02}", result.size() + 1), kFrame.toLatLon(point), 100.0});
  }
  return result;
}

}  // namespace

Result<void> writeMountain(const std::string& folder) {
  std::vector<Airstrip> strips{
      {"MTSW", "Southwell", {-1900.0, -1300.0}, {-1350.0, -1850.0}, 20.0, "grass"},
      {"MTNE", "Northmead", {1250.0, 1900.0}, {1850.0, 1500.0}, 20.0, "grass"},
      {"MTNW", "Westgrange", {-2100.0, 1500.0}, {-1650.0, 1950.0}, 18.0, "gravel"},
  };
  const HeightField field = mountain(strips);
  if (const auto written = writeGeoTiff(field, kFrame, SampleType::Float32, folder + "/mountain.tif"); !written) {
    return written;
  }
  MissionText mission;
  mission.terrain = "mountain.tif";
  mission.aircraft = "cessna172-elasp";
  mission.roadmap = "lattice";  // and the samples of [1] for those who ask for its roadmap
  for (const Airstrip& strip : strips) {
    mission.sites.push_back(siteOf(kFrame, strip, strip.first, strip.second));
    if (strip.ident != "MTNW") {  // the third runway is one-way
      mission.sites.push_back(siteOf(kFrame, strip, strip.second, strip.first));
    }
  }
  for (const int count : {5, 10, 20, 50, 100}) {
    mission.name = fmt::format("Mountain, {} targets", count);
    mission.targets = targets(count);
    if (const auto written = writeMission(mission, fmt::format("{}/mountain-n{}.vpm", folder, count)); !written) {
      return written;
    }
  }
  return {};
}

}  // namespace vp::maps
