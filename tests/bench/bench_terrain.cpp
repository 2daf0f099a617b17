// Loading, pyramid and queries of terrain files: bench_terrain FILE...
#include "core/geo/local_frame.h"
#include "core/terrain/terrain_pyramid.h"
#include "core/terrain/terrain_reader.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using vp::bench::Clock;
using vp::bench::print;
using vp::bench::secondsSince;

/// Mean time of upperIn over boxes like those of a glide: a place that moves on by some cells, sides up to `side` cells.
double queryNanoseconds(const vp::terrain::TerrainPyramid& pyramid, double side, bool isScattered) {
  const vp::terrain::ElevationGrid& grid = pyramid.grid();
  constexpr std::size_t kBoxes = 1 << 16;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const vp::geo::Box all = grid.extent();
  const double cell = grid.cellSize();
  std::vector<vp::geo::Box> boxes(kBoxes);
  vp::geo::Point at{0.5 * (all.minX + all.maxX), 0.5 * (all.minY + all.maxY)};
  for (vp::geo::Box& box : boxes) {
    if (isScattered) {
      at = {all.minX + unit(random) * (all.maxX - all.minX), all.minY + unit(random) * (all.maxY - all.minY)};
    } else {
      at = {at.x + (unit(random) - 0.5) * 4.0 * cell, at.y + (unit(random) - 0.5) * 4.0 * cell};
    }
    box = {at.x, at.y, at.x + unit(random) * side * cell, at.y + unit(random) * side * cell};
  }
  constexpr int kRounds = 200;
  double sum = 0.0;
  const auto start = Clock::now();
  for (int round = 0; round < kRounds; ++round) {
    for (const vp::geo::Box& box : boxes) {
      const double upper = pyramid.upperIn(box);
      sum += upper < 1e9 ? upper : 0.0;
    }
  }
  const double seconds = secondsSince(start);
  if (sum == 0.12345) {
    fmt::print(stderr, "never\n");
  }
  return seconds * 1e9 / (static_cast<double>(kRounds) * static_cast<double>(kBoxes));
}

bool measure(const std::string& path) {
  const auto start = Clock::now();
  const auto info = vp::terrain::inspectTerrain({path});
  if (!info) {
    fmt::print(stderr, "bench_terrain: {}\n", info.error().message());
    return false;
  }
  auto grid = vp::terrain::readTerrain({path}, vp::geo::LocalFrame(info->centre()), {}, vp::Job());
  if (!grid) {
    fmt::print(stderr, "bench_terrain: {}\n", grid.error().message());
    return false;
  }
  const double loading = secondsSince(start);
  const auto shared = std::make_shared<const vp::terrain::ElevationGrid>(std::move(*grid));
  const auto startPyramid = Clock::now();
  const vp::terrain::TerrainPyramid pyramid(shared);
  const double building = secondsSince(startPyramid);
  const std::string name = "terrain " + std::filesystem::path(path).filename().string();
  print(name, "cells", static_cast<double>(shared->values().size()));
  print(name, "cell", shared->cellSize(), "m");
  print(name, "load", loading, "s");
  print(name, "pyramid", building, "s");
  print(name, "upper bound in a small box near the last", queryNanoseconds(pyramid, 2.0, false), "ns");
  print(name, "upper bound in a small box anywhere", queryNanoseconds(pyramid, 2.0, true), "ns");
  print(name, "upper bound in a wide box anywhere", queryNanoseconds(pyramid, 60.0, true), "ns");
  print(name, "peak memory", vp::bench::peakMemory(), "MiB");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_terrain FILE...\n");
    return 2;
  }
  bool isGood = true;
  for (int i = 1; i < argc; ++i) {
    isGood = measure(argv[i]) && isGood;
  }
  return isGood ? 0 : 1;
}
