// How long long work takes to notice that it is to stop: each stage is stopped at many moments of its run.
//   bench_cancel [--runs N] MISSION...     one JSON line per mission and stage (tests/bench/README.md)
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/landing/rrt_star.h"
#include "core/landing/safe_altitude_field.h"
#include "core/safety/checker.h"
#include "core/tour/planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <pthread.h>
#include <string>
#include <thread>
#include <vector>

using namespace vp;

namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<bool(const Job&)>;  ///< true: it came to its end

double seconds(Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

double cpuSeconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/** One run of some work that is stopped after a time. */
struct Stopped {
  bool ended = false;  ///< before it was stopped
  double wall = 0.0;   ///< s from the request to the end
  double cpu = 0.0;    ///< s of processor time in between: what it takes on a machine with nothing else to do
  std::string stage;   ///< last progress before the request
};

Stopped stopAfter(const Work& work, double after) {
  std::stop_source stop;
  std::mutex mutex;
  std::string stage = "start";
  std::atomic<double> cpuAtEnd = 0.0;
  std::atomic<bool> ended = false;
  std::condition_variable done;
  bool isDone = false;
  const Job job(stop.get_token(), [&](double, std::string_view text) {
    const std::lock_guard lock(mutex);
    stage = text;
  });
  std::thread thread([&] {
    ended = work(job);
    cpuAtEnd = cpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    const std::lock_guard lock(mutex);
    isDone = true;
    done.notify_all();
  });
  Stopped result;
  clockid_t clock{};
  const bool hasClock = pthread_getcpuclockid(thread.native_handle(), &clock) == 0;
  {
    std::unique_lock lock(mutex);
    done.wait_for(lock, std::chrono::duration<double>(after), [&] { return isDone; });
    result.stage = stage;
    result.ended = isDone;
  }
  const double cpuBefore = hasClock && !result.ended ? cpuSeconds(clock) : 0.0;
  const auto start = Clock::now();
  stop.request_stop();
  thread.join();
  result.wall = seconds(Clock::now() - start);
  result.cpu = cpuAtEnd - cpuBefore;
  result.ended = result.ended || ended;
  return result;
}

std::string withoutNumbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == ','; });
  return text.substr(0, text.find(':'));
}

void measure(const std::string& mission, const char* what, int runs, const Work& work) {
  const auto start = Clock::now();
  work(Job{});
  const double whole = seconds(Clock::now() - start);
  std::map<std::string, Stopped> worst;
  double total = 0.0;
  int count = 0;
  for (int i = 0; i < runs; ++i) {
    const Stopped stopped = stopAfter(work, whole * (i + 0.5) / runs);
    if (stopped.ended) {
      continue;
    }
    Stopped& most = worst[withoutNumbers(stopped.stage)];
    most.cpu = std::max(most.cpu, stopped.cpu);
    most.wall = std::max(most.wall, stopped.wall);
    total += stopped.cpu;
    ++count;
  }
  for (const auto& [stage, most] : worst) {
    fmt::print(R"~({{"bench": "cancel {} {} ({})", "metric": "longest time to stop", "value": {:.1f}, "unit": "ms", "reference": 100, )~"
               R"~("note": "processor time; wall {:.1f} ms"}})~"
               "\n",
               what, mission, stage, 1e3 * most.cpu, 1e3 * most.wall);
  }
  fmt::print(R"~({{"bench": "cancel {} {}", "metric": "mean time to stop", "value": {:.1f}, "unit": "ms", )~"
             R"~("note": "processor time; {} stops in {:.1f} s"}})~"
             "\n",
             what, mission, count > 0 ? 1e3 * total / count : 0.0, count, whole);
  std::fflush(stdout);
}

int run(const std::string& path, int runs) {
  Result<mission::Mission> mission = formats::readMission(path);
  if (!mission) {
    fmt::print(stderr, "{}\n", mission.error().message());
    return 1;
  }
  const std::string name = std::filesystem::path(path).stem().string();
  formats::makePathsAbsolute(*mission, std::filesystem::absolute(path).parent_path().string());
  measure(name, "terrain", runs, [&](const Job& job) { return formats::loadTerrain(mission->terrain, "", job).has_value(); });
  const Result<formats::LoadedTerrain> terrain = formats::loadTerrain(mission->terrain, "", Job{});
  measure(name, "sites", runs, [&](const Job& job) { return formats::loadSites(*mission, "", *terrain, true, job).has_value(); });
  const Result<formats::LoadedMission> loaded = formats::loadMission(*mission, "", Job{});
  if (!loaded) {
    fmt::print(stderr, "{}\n", loaded.error().message());
    return 1;
  }
  const tour::PlanInput input{
      loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "bench_cancel", "LKH", 1};
  measure(name, "plan", runs, [&](const Job& job) { return tour::planTour(input, job).has_value(); });
  tour::PlanInput low = input;
  double lowest = 1e9;
  for (const mission::TargetInFrame& target : input.targets) {
    lowest = std::min(lowest, target.altitude);
  }
  low.mission.ceiling = geo::HeightMsl::fromMetres(lowest + 300.0);
  measure(name, "hopeless plan", runs, [&](const Job& job) {
    const auto plan = tour::planTour(low, job);
    return plan || plan.error().code != Errc::Cancelled;
  });
  const Result<mission::Plan> plan = tour::planTour(input, Job{});
  if (plan) {
    measure(name, "terrain again", runs, [&](const Job& job) {
      std::vector<std::string> checksums;
      return formats::readPlanTerrain(*plan, "", checksums, job).has_value();
    });
    std::vector<std::string> checksums;
    const Result<terrain::ElevationGrid> grid = formats::readPlanTerrain(*plan, "", checksums, Job{});
    measure(name, "check", runs, [&](const Job& job) { return safety::check({*plan, *grid, checksums}, job).has_value(); });
  }
  const landing::World world = tour::makeWorld(input);
  landing::RrtStarOptions options;
  options.area = tour::roadmapArea(input);
  options.samples = 3000;
  const Result<landing::TreeRoadmap> roadmap = landing::buildRrtStarRoadmap(world, options, Job{});
  measure(name, "safe altitudes", runs,
          [&](const Job& job) { return landing::safeAltitudeField(world, *roadmap, options.area, 40, 8, job).has_value(); });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int runs = 20;
  int status = 0;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--runs" && i + 1 < argc) {
      runs = std::atoi(argv[++i]);
    } else {
      status |= run(argv[i], runs);
    }
  }
  return status;
}
