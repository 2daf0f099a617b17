// Roadmaps over real terrain, large ones too: 46 x 67 km around Davos, and 20 M cells of the Victorian Alps with all airfields inside.
#include "core/landing/build_roadmap.h"
#include "core/landing/lattice_roadmap.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace {

using namespace vp;
using bench::print;

constexpr int kPoses = 5000;
constexpr double kReferenceStep = 200.0;  // m, the lattice that Davos is to be as good as

/// Mean safe altitude over fixed poses from which both roadmaps know a glide, in this order.
std::pair<double, double> meanSafeAltitudes(const landing::World& world, const geo::Box& area, const landing::Roadmap& a, const landing::Roadmap& b) {
  std::mt19937_64 engine(kPoses);
  const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  landing::QueryScratch scratch;
  double sumA = 0.0;
  double sumB = 0.0;
  int both = 0;
  for (int i = 0; i < kPoses; ++i) {
    const geo::Pose pose{area.minX + (area.maxX - area.minX) * unit(), area.minY + (area.maxY - area.minY) * unit(), 2.0 * Angle::kPi * unit()};
    const auto inA = a.query(world, pose, scratch);
    const auto inB = b.query(world, pose, scratch);
    if (inA && inB) {
      sumA += inA->altitude;
      sumB += inB->altitude;
      ++both;
    }
  }
  return {sumA / both, sumB / both};
}

void benchRoadmap(const std::string& name, const mission::Mission& mission, int threads, bool compares) {
  const auto begin = bench::Clock::now();
  const Result<tour::PlanInput> input = bench::load(mission);
  if (!input) {
    fmt::print(stderr, "{}: {}\n", name, input.error().message());
    return;
  }
  const landing::World world = tour::makeWorld(*input);
  print(name, "reading, with the pyramid", bench::secondsSince(begin), "s");
  print(name, "cells", static_cast<double>(input->terrain->columns()) * input->terrain->rows());
  print(name, "landing directions", static_cast<double>(input->sites.size()));
  const geo::Box area = input->terrain->extent();
  landing::RoadmapRequest request;
  request.area = area;
  request.threads = threads;
  const auto start = bench::Clock::now();
  const double cpuStart = bench::cpuSeconds();
  const auto roadmap = landing::buildRoadmap(world, input->mission.planner, request, Job{});
  if (!roadmap) {
    fmt::print(stderr, "{}: {}\n", name, roadmap.error().message());
    return;
  }
  print(name, "roadmap", bench::secondsSince(start), "s", fmt::format("{} thread(s)", threads));
  print(name, "roadmap, processor time of the first thread", bench::cpuSeconds() - cpuStart, "s");
  print(name, "poses", static_cast<double>((*roadmap)->size()));
  print(name, "peak memory", bench::peakMemory(), "MiB", "of the whole program until here");
  if (compares) {
    for (const bool isPlain : {true, false}) {
      const auto begun = bench::Clock::now();
      const auto reference = landing::buildLatticeRoadmap(world, {area, kReferenceStep, isPlain}, Job{});
      if (reference) {
        const std::string note = isPlain ? "reference: plain lattice of 200 m x 16 headings" : "reference: this builder with 200 m";
        print(name, isPlain ? "roadmap of the plain lattice" : "roadmap with 200 m", bench::secondsSince(begun), "s");
        const auto [mine, other] = meanSafeAltitudes(world, area, **roadmap, *reference);
        print(name, isPlain ? "mean safe altitude" : "mean safe altitude, both finer", mine, "m", note, other);
      }
    }
  }
}

}  // namespace

int main() {
  if (bench::dataFolder().empty()) {
    fmt::print(stderr, "bench_scale: the folder with real terrain is not here; set VOLPLANE_DATA to it\n");
    return 0;
  }
  benchRoadmap("roadmap Davos", bench::davos(), 1, true);
  benchRoadmap("roadmap 20 M cells", bench::victorianAlps(), 2, false);
}
