// volplane-cli safe-altitude MISSION|PLAN -o FILE: the lowest safe altitude as a map for other programs.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/settings.h"
#include "app/cli/values.h"
#include "core/charts/safe_altitude_chart.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"
#include "core/landing/build_roadmap.h"
#include "core/tour/planner.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <thread>

namespace vp::cli {
namespace {

struct ChartArguments {
  std::string input;
  std::string output;
  std::optional<double> heading;
  std::string contours = "100m";
  bool worst = false;
  bool best = false;
  bool whole = false;
  SettingOptions settings;
  charts::ChartRequest request;
};

Result<mission::Mission> missionOf(const std::string& path) {
  if (std::filesystem::path(path).extension() != ".vpp") {
    return formats::readMission(path);
  }
  const Result<mission::Plan> plan = formats::readPlan(path);
  return plan ? Result<mission::Mission>(plan->mission) : forward(plan);
}

Result<charts::ChartSummary> writeChart(const ChartArguments& arguments, charts::ChartRequest request, std::vector<std::string>& notes,
                                        const Job& job) {
  const Result<double> interval = distanceIn(arguments.contours, "--contours");
  if (!interval) {
    return forward(interval);
  }
  request.interval = *interval;
  if (const Result<void> named = charts::checkChartName(arguments.output); !named) {
    return forward(named);
  }
  Result<mission::Mission> mission = missionOf(arguments.input);
  if (!mission) {
    return forward(mission);
  }
  if (const Result<void> applied = applySettings(arguments.settings, *mission); !applied) {
    return forward(applied);
  }
  Result<formats::LoadedMission> loaded = formats::loadMission(*mission, folderOf(arguments.input), job.part(0.0, 0.05));
  if (!loaded) {
    return forward(loaded);
  }
  notes = loaded->notes;
  const tour::PlanInput input{loaded->mission, loaded->frame,    loaded->terrain, loaded->terrainFiles, loaded->sites,
                              loaded->targets, programVersion(), "LKH",           request.threads};
  const landing::World world = tour::makeWorld(input);
  request.area = arguments.whole ? loaded->terrain->extent() : tour::roadmapArea(input);
  landing::RoadmapRequest wanted;
  wanted.area = request.area;
  wanted.threads = request.threads;
  const Result<std::shared_ptr<const landing::Roadmap>> roadmap = landing::buildRoadmap(world, loaded->mission.planner, wanted, job.part(0.05, 0.2));
  if (!roadmap) {
    return forward(roadmap);
  }
  return charts::writeSafeAltitudeChart(world, **roadmap, loaded->frame, loaded->mission, request, arguments.output, job.part(0.2, 1.0));
}

int runSafeAltitude(const ChartArguments& arguments, const Common& common) {
  charts::ChartRequest request = arguments.request;
  request.courses = arguments.heading ? charts::Courses::One
                    : arguments.worst ? charts::Courses::Worst
                    : arguments.best  ? charts::Courses::Best
                                      : charts::Courses::All;
  request.course_deg = arguments.heading.value_or(0.0);
  Console console(!common.quiet && !common.json);
  std::vector<std::string> notes;
  const Result<charts::ChartSummary> summary = writeChart(arguments, request, notes, console.job());
  console.finishProgress();
  if (!summary) {
    return report(summary.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", jsonText(nlohmann::ordered_json{{"file", arguments.output},
                                                     {"columns", summary->columns},
                                                     {"rows", summary->rows},
                                                     {"cell_m", summary->cell},
                                                     {"bands", summary->bands},
                                                     {"contours", summary->contours},
                                                     {"lowest_m", summary->lowest},
                                                     {"highest_m", summary->highest},
                                                     {"knownShare", summary->knownShare},
                                                     {"notes", notes}}));
  } else if (!common.quiet) {
    for (const std::string& note : notes) {
      fmt::print("note: {}\n", note);
    }
    fmt::print("wrote {}: {} x {} cells of {:.0f} m, lowest safe altitude {:.0f} to {:.0f} m MSL; {:.0f} % of the area has one\n", arguments.output,
               summary->columns, summary->rows, summary->cell, summary->lowest, summary->highest, 100.0 * summary->knownShare);
    fmt::print("  values hold for whole cells, engine off and in {}; {}\n", summary->air,
               summary->contours > 0
                   ? fmt::format("{} contours, between two lines the higher one counts", summary->contours)
                   : fmt::format("{} band{}", summary->bands, summary->bands == 1 ? "" : "s: any course, then one for each course"));
  }
  return kDone;
}

}  // namespace

void addSafeAltitudeCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<ChartArguments>();
  arguments->request.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("safe-altitude", "Write the lowest safe altitude as a map: .tif (values), .kml or .gpkg (contours)");
  command->add_option("input", arguments->input, "Mission (*.vpm) or plan (*.vpp)")->required();
  command->add_option("-o,--output", arguments->output, "File to write; its ending says what: .tif, .kml, .gpkg")->required();
  CLI::Option* heading = command->add_option("--heading", arguments->heading, "Only for this true course, degrees")->check(CLI::Range(0.0, 360.0));
  CLI::Option* worst =
      command->add_flag("--worst", arguments->worst, "Only for the worst course, so for any; without these options: worst and each course");
  CLI::Option* best = command->add_flag("--best", arguments->best, "Only for the best course at each place");
  heading->excludes(worst)->excludes(best);
  worst->excludes(best);
  command->add_option("--courses", arguments->request.count, "Courses that the circle is cut into (16); more give lower values, and take longer")
      ->check(CLI::Range(4, 72));
  command
      ->add_option("--cell", arguments->request.cell, "Size of cells, m (50, or 1/250 of the area); smaller ones give lower values, and take longer")
      ->check(CLI::Range(10.0, 5000.0));
  command->add_option("--contours", arguments->contours, "Interval of contours: 100m (default)");
  command->add_flag("--whole-terrain", arguments->whole, "Map all of the terrain, not only where targets and runways are");
  addSettingOptions(*command, arguments->settings);
  command->add_option("--threads", arguments->request.threads, "Threads to compute with; the map does not depend on it")->check(CLI::Range(1, 256));
  command->callback([arguments, &common, &status] { status = runSafeAltitude(*arguments, common); });
}

}  // namespace vp::cli
