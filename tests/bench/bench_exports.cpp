// Seconds to prepare all exports of a mission's plan: roadmap and routes, and the files alone. Arguments: missions.
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/tour/planner.h"
#include "ui/exports/prepare_export.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

using namespace vp;

namespace {

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print(const std::string& mission, const std::string& metric, double seconds, const std::string& reference) {
  fmt::print("{{\"bench\": \"exports {}\", \"metric\": \"{}\", \"value\": {:.4f}, \"unit\": \"s\"{}}}\n",
             std::filesystem::path(mission).stem().string(), metric, seconds, reference.empty() ? "" : ", \"reference\": " + reference);
}

int measure(const std::string& path) {
  const auto mission = formats::readMission(path);
  const auto loaded = mission ? formats::loadMission(*mission, std::filesystem::path(path).parent_path().string(), Job{}) : forward(mission);
  if (!loaded) {
    fmt::print(stderr, "{}\n", loaded.error().message());
    return 1;
  }
  const tour::PlanInput input{
      loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "bench", "LKH", 1};
  const auto plan = tour::planTour(input, Job{});
  if (!plan) {
    fmt::print(stderr, "{}\n", plan.error().message());
    return 1;
  }
  exports::ExportRequest request{*plan, loaded->terrain, {}, {}};
  for (const mission::TerrainReference& file : plan->terrain) {
    request.terrainSha256.push_back(file.sha256);
  }
  for (const formats::ExportFormat& format : formats::exportFormats()) {
    request.formats.push_back(format.name);
  }
  auto start = std::chrono::steady_clock::now();
  const auto prepared = exports::prepareExport(request, Job{});
  const double all = since(start);
  if (!prepared) {
    fmt::print(stderr, "{}\n", prepared.error().message());
    return 1;
  }
  double files = 0.0;
  for (const formats::ExportFormat& format : formats::exportFormats()) {
    start = std::chrono::steady_clock::now();
    const auto bytes = format.write({*plan, &prepared->routes.front().route});
    const double seconds = since(start);
    files += seconds;
    print(path, (bytes ? "writing " : "failed ") + format.name, seconds, "");
  }
  print(path, "writing all", files, "1");
  print(path, "all, with roadmap, routes and their checks", all, "");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int status = 0;
  for (int i = 1; i < argc; ++i) {
    status |= measure(argv[i]);
  }
  return status;
}
