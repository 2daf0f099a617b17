// FMT* and the linear octree against the figures of [5]: routes through a cube of 1000 x 1000 x 1000, and gliding down among mountains.
//   bench_fmt [--cube-only | --terrain-only]
#include "core/emergency/box_route.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
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

}  // namespace

int main(int argc, char** argv) {
  const std::string only = argc > 1 ? argv[1] : "";
  if (only != "--terrain-only") {
    benchCube();
  }
  return 0;
}
