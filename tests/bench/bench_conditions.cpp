// What the conditions of a glide cost in planning: the same mission in still air, in winds, and with all that a pilot may ask for, each planned
// in one run with the same settings. The issue allows three times the calm time in wind.
//   bench_conditions MISSION...
#include "tests/bench/bench_support.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>

namespace {

using namespace vp;

constexpr int kRuns = 3;  // the quickest counts: the others had company

struct Condition {
  const char* name;
  std::function<void(mission::Mission&)> set;
};

air::WindLayer layer(double altitude, double from, double spread, double least, double most) {
  return {geo::HeightMsl::fromMetres(altitude), {from, spread, least * kMpsPerKnot, most * kMpsPerKnot}};
}

std::vector<Condition> conditions() {
  return {
      {"calm", [](mission::Mission&) {}},
      {"10 kt", [](mission::Mission& m) { m.wind = {layer(0.0, 270.0, 0.0, 10.0, 10.0)}; }},
      {"15 +- 5 kt, +- 20 degrees", [](mission::Mission& m) { m.wind = {layer(0.0, 270.0, 20.0, 10.0, 20.0)}; }},
      {"two layers",
       [](mission::Mission& m) {
         m.wind = {layer(300.0, 250.0, 0.0, 8.0, 8.0), layer(2500.0, 290.0, 0.0, 18.0, 18.0)};
       }},
      {"three layers",
       [](mission::Mission& m) {
         m.wind = {layer(0.0, 270.0, 0.0, 5.0, 5.0), layer(1000.0, 270.0, 0.0, 15.0, 15.0), layer(2000.0, 270.0, 0.0, 30.0, 30.0)};
       }},
      {"three layers where the glides are",
       [](mission::Mission& m) {
         m.wind = {layer(250.0, 240.0, 10.0, 5.0, 8.0), layer(500.0, 270.0, 10.0, 8.0, 12.0), layer(800.0, 300.0, 10.0, 12.0, 16.0)};
       }},
      {"standard atmosphere", [](mission::Mission& m) { m.atmosphere = air::Atmosphere(); }},
      {"reaction of 5 s", [](mission::Mission& m) { m.safety.reactionTime = Duration::fromSi(5.0); }},
      {"straight approach of 1 km", [](mission::Mission& m) { m.approach.kind = mission::ApproachKind::Straight; }},
      {"all of it",
       [](mission::Mission& m) {
         m.wind = {layer(0.0, 270.0, 20.0, 10.0, 20.0)};
         m.atmosphere = air::Atmosphere();
         m.safety.reactionTime = Duration::fromSi(5.0);
         m.safety.dragFactor = 1.1;
         m.approach.kind = mission::ApproachKind::Straight;
       }},
  };
}

void measure(const std::string& file) {
  const Result<tour::PlanInput> input = bench::load(file);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message());
    return;
  }
  const std::string name = "conditions " + std::filesystem::path(file).stem().string();
  double calm = 0.0;
  for (const Condition& condition : conditions()) {
    tour::PlanInput now = *input;
    condition.set(now.mission);
    double seconds = std::numeric_limits<double>::infinity();
    Result<mission::Plan> plan = fail(Errc::NoSolution, "not planned");
    for (int run = 0; run < kRuns; ++run) {
      const double start = bench::cpuSeconds();
      plan = tour::planTour(now, Job{});
      seconds = std::min(seconds, bench::cpuSeconds() - start);
      if (!plan) {
        break;
      }
    }
    const std::string bench = name + ", " + condition.name;
    if (!plan) {
      bench::countFailure(bench, plan.error());
      continue;
    }
    bench::verify(bench, now, *plan);
    calm = calm > 0.0 ? calm : seconds;
    bench::print(bench, "processor time", seconds, "s", "refinement included");
    bench::print(bench, "times calm", seconds / calm, "", "to reach in wind", 3.0);
    bench::print(bench, "cost", plan->metrics.cost, "m");
    bench::print(bench, "safe-altitude queries", static_cast<double>(plan->metrics.safeQueries));
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    measure(argv[i]);
  }
  return bench::verdict("bench_conditions");
}
