// A briefing from a plan file to a PDF in memory: bench_briefing PLAN|MISSION..., one JSON object per line. Missions are planned first, which is not
// counted.
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/formats/plan_file.h"
#include "core/tour/planner.h"
#include "ui/briefing/write_briefing.h"

#include <QGuiApplication>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::year_month_day kDay{std::chrono::year(2026), std::chrono::month(6), std::chrono::day(1)};

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

vp::Result<vp::mission::Plan> planOf(const std::string& path) {
  if (path.ends_with(".vpp")) {
    return vp::formats::readPlan(path);
  }
  vp::Result<vp::mission::Mission> mission = vp::formats::readMission(path);
  if (!mission) {
    return vp::forward(mission);
  }
  vp::formats::makePathsAbsolute(*mission, std::filesystem::absolute(path).parent_path().string());
  const vp::Result<vp::formats::LoadedMission> loaded = vp::formats::loadMission(*mission, "", vp::Job());
  if (!loaded) {
    return vp::forward(loaded);
  }
  return vp::tour::planTour(
      {loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "bench", "LKH", 1}, vp::Job());
}

int run(const std::string& path) {
  const vp::Result<vp::mission::Plan> plan = planOf(path);
  if (!plan) {
    fmt::print(stderr, "bench_briefing: {}\n", plan.error().message());
    return 1;
  }
  vp::briefing::BriefingOptions options;
  options.date = kDay;
  options.program = QStringLiteral("bench");
  const Clock::time_point start = Clock::now();
  const auto source = vp::briefing::briefingSource(*plan, std::filesystem::absolute(path).parent_path().string(), kDay, vp::Job());
  if (!source) {
    fmt::print(stderr, "bench_briefing: {}\n", source.error().message());
    return 1;
  }
  const double reading = secondsSince(start);
  const auto pdf = vp::briefing::writeBriefing(*source, options, vp::Job());
  const double whole = secondsSince(start);
  if (!pdf) {
    fmt::print(stderr, "bench_briefing: {}\n", pdf.error().message());
    return 1;
  }
  const std::string name = "briefing " + std::filesystem::path(path).stem().string();
  const auto line = [&name](const char* metric, double value, const char* unit, const char* more) {
    fmt::print("{{\"bench\": \"{}\", \"metric\": \"{}\", \"value\": {:.3f}, \"unit\": \"{}\"{}}}\n", name, metric, value, unit, more);
  };
  line("terrain, check and figures", reading, "s", "");
  line("whole", whole, "s", ", \"reference\": 3, \"note\": \"asked, for 10 pages\"");
  line("pages", vp::briefing::pageCount(*pdf), "", "");
  line("size", static_cast<double>(pdf->size()) / 1e6, "MB", "");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication application(argc, argv);
  for (int i = 1; i < argc; ++i) {
    if (const int status = run(argv[i]); status != 0) {
      return status;
    }
  }
  return 0;
}
