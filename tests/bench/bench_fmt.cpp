// FMT* and the linear octree against the figures of [5]: routes through a cube of 1000 x 1000 x 1000, and gliding down among mountains.
//   bench_fmt [--cube-only | --terrain-only]
#include "core/emergency/box_route.h"
#include "core/emergency/fmt_planner.h"
#include "core/emergency/octree_ground.h"
#include "core/emergency/verified_answer.h"
#include "tests/bench/bench_support.h"
#include "tests/support/landing_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace vp;
using namespace vp::emergency;
using bench::Clock;
using bench::print;
using bench::secondsSince;

constexpr int kSeeds = 5;

/// One box between two points that are 500 cells apart, and how short the way around it is.
struct CubeCase {
  Cuboid obstacle;
  Point3 start;
  Point3 end;
  double optimum = 0.0;
};

/// Boxes of twelve sizes. The way around a box that lies in the middle is that over the nearest of its edges, in the plane of its faces.
std::vector<CubeCase> cubeCases() {
  std::vector<CubeCase> cases;
  for (const double half : {60.0, 100.0, 150.0, 200.0}) {
    for (const double thick : {50.0, 150.0, 300.0}) {
      CubeCase one;
      one.start = {250.0, 500.0, 500.0};
      one.end = {750.0, 500.0, 500.0};
      one.obstacle = {{500.0 - 0.5 * thick, 500.0 - half, 500.0 - 1.3 * half}, {500.0 + 0.5 * thick, 500.0 + 1.4 * half, 500.0 + 1.2 * half}};
      one.optimum = 2.0 * std::hypot(250.0 - 0.5 * thick, half) + thick;
      cases.push_back(one);
    }
  }
  return cases;
}

LinearOctree octreeOf(const CubeCase& one) {
  // a cell is blocked by what touches it: what ends on its face would block the next one too
  constexpr double kInside = 0.25;
  Cuboid inside = one.obstacle;
  inside.low = {inside.low.x + kInside, inside.low.y + kInside, inside.low.z + kInside};
  inside.high = {inside.high.x - kInside, inside.high.y - kInside, inside.high.z - kInside};
  return *LinearOctree::build({{}, {1.0, 1.0, 1.0}, {1000, 1000, 1000}}, {}, {inside}, Job());
}

/// The usual test: cell by cell along the leg, each against the list of obstacles.
bool isFreeBySteps(const CubeCase& one, const Point3& a, const Point3& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
  const int steps = std::max(1, static_cast<int>(std::ceil(length)));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Point3 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    if (p.x > one.obstacle.low.x && p.x < one.obstacle.high.x && p.y > one.obstacle.low.y && p.y < one.obstacle.high.y && p.z > one.obstacle.low.z &&
        p.z < one.obstacle.high.z) {
      return false;
    }
  }
  return true;
}

struct CubeResult {
  double error = 0.0;    ///< mean
  double seconds = 0.0;  ///< mean
  int missed = 0;        ///< no way found
};

CubeResult runCube(const BoxRouteOptions& options, bool withOctree) {
  const Cuboid box{{0.0, 0.0, 0.0}, {1000.0, 1000.0, 1000.0}};
  CubeResult result;
  int found = 0;
  for (const CubeCase& one : cubeCases()) {
    const LinearOctree octree = octreeOf(one);
    for (int seed = 1; seed <= kSeeds; ++seed) {
      BoxRouteOptions own = options;
      own.seed = static_cast<std::uint64_t>(seed);
      const auto begin = Clock::now();
      const std::optional<BoxRoute> route =
          withOctree ? boxRoute(
                           box, one.start, one.end, [&](const Point3& a, const Point3& b) { return octree.isFree(a, b); }, own)
                     : boxRoute(
                           box, one.start, one.end, [&](const Point3& a, const Point3& b) { return isFreeBySteps(one, a, b); }, own);
      result.seconds += secondsSince(begin);
      if (!route) {
        ++result.missed;
        continue;
      }
      result.error += route->length / one.optimum - 1.0;
      ++found;
    }
  }
  result.seconds /= found + result.missed;
  result.error /= std::max(1, found);
  return result;
}

/// What [5] Table 2 gives: milliseconds for an error.
struct CubeRow {
  int percent = 0;
  double plain = 0.0;
  double proposed = 0.0;
  BoxRouteOptions options;  ///< enough for that error
};

void benchCube() {
  const std::array<CubeRow, 3> rows{CubeRow{5, 98.7, 51.3, {300, 50, 3, 2, 1.5, true, 1}}, CubeRow{2, 493.8, 203.4, {600, 50, 5, 2, 1.5, true, 1}},
                                    CubeRow{1, 6896.5, 2057.3, {600, 100, 5, 2, 1.5, true, 1}}};
  for (const CubeRow& row : rows) {
    const CubeResult result = runCube(row.options, true);
    const std::string name = fmt::format("cube 1000^3, error {} %", row.percent);
    print(name, "time", 1e3 * result.seconds, "ms", fmt::format("[5] Table 2, proposed; FMT {:g} ms", row.plain), row.proposed);
    print(name, "error", 100.0 * result.error, "%", fmt::format("mean of {} cases x {} seeds, {} missed", cubeCases().size(), kSeeds, result.missed),
          row.percent);
  }
  constexpr std::size_t kPlain = 30'000;
  const CubeResult plain = runCube(BoxRouteOptions::plain(kPlain), false);
  print("cube 1000^3, plain FMT*", "time", 1e3 * plain.seconds, "ms", fmt::format("{} samples, legs tested cell by cell", kPlain));
  print("cube 1000^3, plain FMT*", "error", 100.0 * plain.error, "%");
}

constexpr double kNauticalMile = 1852.0;
constexpr double kFoot = 0.3048;
constexpr double kHalfSide = 50.0 * kNauticalMile;
constexpr int kColumns = 1200;
constexpr int kLayers = 500;
/// [5]: 30 ft is the precision of its altitudes.
constexpr double kLayer = 30.0 * kFoot;
constexpr double kStartAltitude = 10'000.0 * kFoot;

/// Ridges of up to 3,600 m and valleys in between, from formulas: [5] has the surroundings of Grenoble, which are not public with it.
double alpineHeight(double x, double y) {
  const double ranges = std::sin(x / 5200.0 + 1.5 * std::sin(y / 9000.0)) * std::cos(y / 6700.0 + std::sin(x / 8000.0));
  const double ridges = std::sin(x / 900.0) * std::sin(y / 1100.0) + 0.5 * std::sin((x + y) / 410.0);
  return std::max(150.0, 1600.0 + 1600.0 * ranges + 250.0 * ridges * (1.0 + ranges));
}

struct Terrain {
  std::shared_ptr<const terrain::ElevationGrid> grid;
  geo::Point runway;  ///< lowest ground near the middle
};

Terrain alpineTerrain() {
  Terrain terrain;
  terrain.grid = test::makeGrid(2.0 * kHalfSide, 2.0 * kHalfSide / kColumns, alpineHeight);
  double lowest = INFINITY;
  for (double x = -6000.0; x <= 6000.0; x += 500.0) {
    for (double y = -6000.0; y <= 6000.0; y += 500.0) {
      if (const double height = terrain.grid->upperAt({x, y}); height < lowest) {
        lowest = height;
        terrain.runway = {x, y};
      }
    }
  }
  return terrain;
}

/// Start course 180 degrees, landing course 315 degrees, as in [5] section 5.5; the start in many places around the runway.
std::vector<LandingRequest> terrainRequests(const Terrain& terrain) {
  const geo::Pose runway{terrain.runway.x, terrain.runway.y, Angle::degrees(135.0).radians()};
  const mission::SiteInFrame site = test::placedSite("G/31", runway, terrain.grid->upperAt(terrain.runway));
  const LandingRequest whole =
      test::landingRequest(test::landingMission(), {site}, terrain.grid, {runway.x, runway.y, Angle::degrees(-90.0).radians()}, kStartAltitude);
  std::vector<LandingRequest> requests;
  for (int i = 0; i < 40; ++i) {
    LandingRequest request = whole;
    const double far = 10'000.0 + 250.0 * i;
    const double around = 2.4 * i;  // rad: all around
    request.pose.x += far * std::cos(around);
    request.pose.y += far * std::sin(around);
    request.seed = static_cast<std::uint64_t>(i + 1);
    if (terrain.grid->upperAt(request.pose.point()) + whole.world->clearance < kStartAltitude) {
      requests.push_back(std::move(request));
    }
  }
  return requests;
}

struct TerrainResult {
  std::vector<double> milliseconds;
  int landed = 0;
  int verified = 0;
  double inHand = 0.0;  ///< mean of those landed, m
};

TerrainResult runTerrain(const LandingPlanner& planner, const std::vector<LandingRequest>& requests) {
  TerrainResult result;
  for (const LandingRequest& request : requests) {
    const auto begin = Clock::now();
    const LandingAnswer answer = planner.plan(request);
    result.milliseconds.push_back(1e3 * secondsSince(begin));
    result.landed += answer.reachesRunway() ? 1 : 0;
    result.inHand += answer.reachesRunway() ? answer.heightInHand : 0.0;
    const LandingAnswer judged = verifiedAnswer(request, answer);
    result.verified += judged.verified && judged.reachesRunway() ? 1 : 0;
    if (answer.reachesRunway() && !judged.verified) {
      fmt::print(stderr, "{}: {}\n", planner.name(), judged.whyNot);
    }
  }
  std::sort(result.milliseconds.begin(), result.milliseconds.end());
  result.inHand /= std::max(1, result.landed);
  return result;
}

void printTerrain(const std::string& name, const TerrainResult& result, double reference) {
  const std::size_t count = result.milliseconds.size();
  print(name, "path, median", result.milliseconds[count / 2], "ms", "[5] section 5.5: below 10 s with the smoothing", reference);
  print(name, "path, longest", result.milliseconds.back(), "ms", fmt::format("of {} starts; those that reach no runway included", count));
  print(name, "landings", result.landed, "", fmt::format("{} of them accepted by the checker", result.verified), result.verified);
  print(name, "height in hand", result.inHand, "m", "mean of the landings");
}

void benchTerrain() {
  const Terrain terrain = alpineTerrain();
  const std::vector<LandingRequest> requests = terrainRequests(terrain);
  const landing::World& world = *requests.front().world;
  OctreeGround ground;
  ground.area = terrain.grid->extent();
  ground.highest = kLayers * kLayer;
  ground.mostCells = {kColumns, kColumns, kLayers};
  ground.clearance = world.clearance;
  ground.enlarge = world.glide.glideRadii().back();
  const auto begin = Clock::now();
  const auto octree = std::make_shared<const LinearOctree>(*octreeOver(*terrain.grid, ground, Job()));
  const double seconds = secondsSince(begin);
  const std::string name = "terrain of 50 NM, 1200 x 1200 x 500";
  print(name, "octree", seconds, "s", "[5] section 5.5: below 10 s for all");
  print(name, "leaves", static_cast<double>(octree->leaves()), "", "[5] section 5.5", 6e6);
  print(name, "memory", 1e-6 * static_cast<double>(octree->bytes()), "MB", "[5] section 5.5", 80.0);
  FmtOptions options;
  options.octree = octree;
  printTerrain("50 NM, fmt-octree", runTerrain(FmtPlanner(options), requests), 10'000.0);
  printTerrain("50 NM, fmt-octree with an octree of its own", runTerrain(FmtPlanner(FmtOptions{}), requests), 10'000.0);
  printTerrain("50 NM, fmt", runTerrain(FmtPlanner(FmtPlanner::plain()), requests), 10'000.0);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string only = argc > 1 ? argv[1] : "";
  if (only != "--terrain-only") {
    benchCube();
  }
  if (only != "--cube-only") {
    benchTerrain();
  }
  return 0;
}
