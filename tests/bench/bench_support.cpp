#include "tests/bench/bench_support.h"

#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/safety/checker.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <sys/resource.h>

namespace vp::bench {
namespace {

int plansMade = 0;
int plansVerified = 0;

struct Place {
  double latitude;
  double longitude;
};

mission::Mission realMission(const std::string& name, std::vector<std::string> terrain, mission::AirfieldSource airfields,
                             const std::vector<Place>& places, double height) {
  const std::string text =
      R"({"format": "volplane-mission", "version": 1, "terrain": [], "aircraft": "cessna172-elasp", "targets": [], "planner": {"step_m": 100, "headings": 8}})";
  mission::Mission mission = formats::parseDraft(text, name).value();
  mission.name = name;
  for (const std::string& file : terrain) {
    mission.terrain.push_back(dataFolder() + "/dem/" + file);
  }
  airfields.airports = dataFolder() + "/airports/" + airfields.airports;
  airfields.runways = airfields.runways.empty() ? "" : dataFolder() + "/airports/" + airfields.runways;
  mission.airfields = {std::move(airfields)};
  for (const Place& place : places) {
    mission::Target target;
    target.name = fmt::format("T{}", mission.targets.size() + 1);
    target.position = {place.latitude, place.longitude};
    target.height_m = height;
    mission.targets.push_back(target);
  }
  return mission;
}

}  // namespace

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void print(const std::string& bench, std::string_view metric, double value, std::string_view unit, std::string_view note, double reference) {
  const std::string compared = std::isfinite(reference) ? fmt::format(R"(, "reference": {:.8g})", reference) : "";
  fmt::print("{{\"bench\": \"{}\", \"metric\": \"{}\", \"value\": {:.8g}, \"unit\": \"{}\"{}, \"note\": \"{}\"}}\n", bench, metric, value, unit,
             compared, note);
  std::fflush(stdout);
}

Result<tour::PlanInput> load(const mission::Mission& mission, const std::string& folder) {
  const Result<formats::LoadedMission> loaded = formats::loadMission(mission, folder, Job{});
  if (!loaded) {
    return forward(loaded);
  }
  return tour::PlanInput{loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "bench", "LKH", 1};
}

Result<tour::PlanInput> load(const std::string& missionFile) {
  const Result<mission::Mission> mission = formats::readMission(missionFile);
  if (!mission) {
    return forward(mission);
  }
  return load(*mission, std::filesystem::path(missionFile).parent_path().string());
}

std::string dataFolder() {
  const char* given = std::getenv("VOLPLANE_DATA");
  for (const std::string& folder : {std::string(given != nullptr ? given : ""), std::string(VOLPLANE_SOURCE_DIR "/../shared/data"),
                                    std::string(VOLPLANE_SOURCE_DIR "/../../shared/data")}) {
    if (!folder.empty() && std::filesystem::is_directory(folder + "/dem")) {
      return std::filesystem::weakly_canonical(folder).string();
    }
  }
  return {};
}

std::vector<std::pair<std::string, mission::Mission>> realMissions() {
  if (dataFolder().empty()) {
    fmt::print(stderr, "the folder with real terrain is not here; set VOLPLANE_DATA to it\n");
    return {};
  }
  const mission::AirfieldSource world{"ourairports_airports.csv.gz", "ourairports_runways.csv.gz"};
  const std::vector<Place> alps{{46.80, 8.20}, {46.75, 8.75}, {46.60, 8.50}, {46.50, 8.15}, {46.45, 8.60},
                                {46.30, 8.30}, {46.25, 8.80}, {46.15, 8.55}, {46.35, 8.05}, {46.85, 8.40}};
  return {
      {"alps", realMission("Swiss Alps", {"swiss_alps_N46E008_srtm3_voids.tif"},
                           {"ourairports_alps_43-48N_4.5-13.5E_airports.csv", "ourairports_alps_43-48N_4.5-13.5E_runways.csv"}, alps, 200.0)},
      {"davos", davos()},
      {"canberra", realMission("Canberra", {"canberra_S36E149_srtm3.tif"}, world,
                               {{-35.35, 149.10}, {-35.55, 149.15}, {-35.45, 149.05}, {-35.25, 149.35}, {-35.60, 149.45}}, 200.0)},
      {"bc-coast", realMission("British Columbia", {"bc_coast_N49W123_srtm3_voids.tif", "bc_coast_N49W124_srtm3_voids.tif"}, world,
                               {{49.15, -122.70}, {49.25, -122.95}, {49.20, -123.05}, {49.30, -122.60}, {49.10, -122.40}}, 250.0)},
  };
}

mission::Mission davos() {
  return realMission("Davos", {"davos_srtm1_wgs84.tif"}, {"CH-WPT-National-XCSoar.cup", ""},
                     {{46.80, 9.83}, {46.70, 9.75}, {46.62, 9.95}, {46.95, 9.70}, {46.85, 10.05}}, 200.0);
}

mission::Mission victorianAlps() {
  return realMission("Victorian Alps", {"victorian_alps_benalla_srtm90_xcsoar.tif"}, {"ourairports_airports.csv.gz", "ourairports_runways.csv.gz"},
                     {{-36.55, 146.00}, {-36.75, 146.95}}, 300.0);
}

bool verify(const std::string& name, const tour::PlanInput& input, const mission::Plan& plan) {
  ++plansMade;
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : plan.terrain) {
    checksums.push_back(file.sha256);
  }
  const Result<safety::SafetyReport> report = safety::check({plan, *input.terrain, checksums}, Job{});
  if (report && report->isSafe()) {
    ++plansVerified;
    return true;
  }
  fmt::print(stderr, "{}: the checker does not certify this plan{}\n", name, report ? "" : ": " + report.error().message());
  return false;
}

void countFailure(const std::string& name, const Error& error) {
  ++plansMade;
  fmt::print(stderr, "{}: {}\n", name, error.message());
}

int verdict(const std::string& program) {
  print(program, "plans verified", plansVerified, "", "by core/safety", plansMade);
  return plansVerified == plansMade ? 0 : 1;
}

}  // namespace vp::bench
