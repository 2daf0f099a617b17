// volplane-cli plan MISSION -o PLAN: terrain in, verified tour out.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/settings.h"
#include "app/cli/values.h"
#include "app/cli/verification.h"
#include "core/aircraft/energy.h"
#include "core/formats/aircraft_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/formats/plan_file.h"
#include "core/formats/wind_text.h"
#include "core/mission/glide_conditions.h"
#include "core/route/flight_totals.h"
#include "core/tour/planner.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <memory>

namespace vp::cli {
namespace {

struct PlanArguments {
  std::string mission;
  std::string output;
  std::optional<std::string> method;
  std::optional<std::string> solver;
  std::optional<std::string> lowTargets;
  std::optional<std::string> roadmap;
  std::optional<std::string> refine;
  std::optional<std::string> aircraft;
  std::optional<std::string> home;
  std::optional<std::string> homeLanding;
  std::optional<std::uint64_t> seed;
  std::optional<int> headings;
  std::optional<double> step;
  std::optional<double> clearance;
  std::optional<double> ceiling;
  std::vector<std::string> wind;
  SettingOptions settings;
  std::optional<int> roadmapSamples;
  std::optional<double> roadmapTime;
  std::string lkh = "LKH";
  int threads = 1;
  bool keepUnverified = false;
};

const std::map<std::string, mission::Method> kMethods{{"lazy", mission::Method::Lazy}, {"base", mission::Method::Base}};
const std::map<std::string, mission::TourSolver> kSolvers{{"builtin", mission::TourSolver::Builtin}, {"lkh", mission::TourSolver::Lkh}};
const std::map<std::string, mission::LowTargets> kLowTargets{{"passAbove", mission::LowTargets::PassAbove},
                                                             {"descend", mission::LowTargets::Descend}};
const std::map<std::string, mission::RoadmapKind> kRoadmaps{{"lattice", mission::RoadmapKind::Lattice}, {"rrtstar", mission::RoadmapKind::RrtStar}};
const std::map<std::string, mission::Refine> kRefines{{"none", mission::Refine::None}, {"full", mission::Refine::Full}};

/// Command-line options count more than the mission file. @param notes  receives what was ignored of them
Result<void> applyOverrides(const PlanArguments& arguments, mission::Mission& mission, std::vector<std::string>& notes) {
  mission::PlannerSettings& planner = mission.planner;
  planner.method = arguments.method ? kMethods.at(*arguments.method) : planner.method;
  planner.tourSolver = arguments.solver ? kSolvers.at(*arguments.solver) : planner.tourSolver;
  planner.lowTargets = arguments.lowTargets ? kLowTargets.at(*arguments.lowTargets) : planner.lowTargets;
  planner.refine = arguments.refine ? kRefines.at(*arguments.refine) : planner.refine;
  planner.seed = arguments.seed.value_or(planner.seed);
  planner.headings = arguments.headings.value_or(planner.headings);
  planner.step = arguments.step ? Length::fromSi(*arguments.step) : planner.step;
  if (arguments.roadmap) {
    planner.roadmap = kRoadmaps.at(*arguments.roadmap);
  } else if (arguments.roadmapSamples || arguments.roadmapTime) {
    planner.roadmap = mission::RoadmapKind::RrtStar;  // the lattice has neither
  }
  if (arguments.roadmapSamples) {
    planner.roadmapSamples = arguments.roadmapSamples;
    planner.roadmapTime.reset();
  }
  if (arguments.roadmapTime) {
    planner.roadmapTime = Duration::fromSi(*arguments.roadmapTime);
    planner.roadmapSamples.reset();
  }
  if (arguments.clearance) {
    mission.safety.clearance = Length::fromSi(*arguments.clearance);
  }
  if (arguments.ceiling) {
    mission.ceiling = geo::HeightMsl::fromMetres(*arguments.ceiling);
  }
  if (arguments.home) {
    mission.home = mission::HomeBase{*arguments.home, arguments.homeLanding.value_or(*arguments.home)};
  }
  if (arguments.aircraft) {
    Result<aircraft::AircraftProfile> profile = formats::findAircraft(*arguments.aircraft, ".");
    if (!profile) {
      return forward(profile);
    }
    mission.aircraft = std::move(*profile);
    mission.aircraftReference = *arguments.aircraft;
  }
  if (Result<void> applied = applyWind(arguments.wind, mission, notes); !applied) {
    return applied;
  }
  return applySettings(arguments.settings, mission);
}

/// How good the tour over the sampled headings is, and what refinement made of it. The bound is one over those headings alone.
void printOrigin(const mission::Plan& plan) {
  const mission::PlanMetrics& m = plan.metrics;
  const bool refined = m.sampledCost > 0.0;
  const double sampled = refined ? m.sampledCost : m.cost;
  std::string text = fmt::format("tour over {} headings per target: cost {:.0f} m", plan.mission.planner.headings, sampled);
  if (m.lowerBound > 0.0) {
    text += fmt::format(", at most {:.1f} % above the best over these headings", 100.0 * (sampled / m.lowerBound - 1.0));
  }
  fmt::print("  {}\n", text);
  if (refined) {
    fmt::print("  refined: cost {:.1f} % less, by {} of {} changes that were tried\n", 100.0 * (1.0 - m.cost / m.sampledCost), m.movesAccepted,
               m.movesTried);
  }
}

double lengthOf(const std::vector<mission::DecisionPoint>& points, std::size_t first, std::size_t end) {
  double length = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    length += points[i].onward.length;
  }
  return length;
}

void printHome(const mission::Plan& plan) {
  if (!plan.departure || !plan.arrival) {
    return;
  }
  const mission::HomePath& out = *plan.departure;
  const mission::HomePath& in = *plan.arrival;
  const auto first = static_cast<std::size_t>(out.guaranteed);
  fmt::print("  departure from {}: {:.0f} m to the tour; glides are guaranteed {:.0f} m past the runway, from {:.0f} m MSL on\n",
             plan.sites[static_cast<std::size_t>(out.site)].site.id, lengthOf(out.points, 0, out.points.size()), lengthOf(out.points, 0, first),
             out.points[first].altitude);
  fmt::print("  arrival at {}: {:.0f} m from the tour; glides are guaranteed until above the threshold at {:.0f} m MSL\n",
             plan.sites[static_cast<std::size_t>(in.site)].site.id, lengthOf(in.points, 0, in.points.size()), in.points.back().altitude);
}

void printFreeBound(const mission::PlanMetrics& m) {
  if (m.freeLowerBound > 0.0) {
    fmt::print("  no safe tour over these targets, whatever its headings, costs less than {:.0f} m: this one is at most {:.1f} % above the best\n",
               m.freeLowerBound, 100.0 * (m.cost / m.freeLowerBound - 1.0));
  }
}

void printSummary(const mission::Plan& plan, const tour::PlanTimes& times, const std::string& output) {
  const mission::PlanMetrics& m = plan.metrics;
  fmt::print("{}: {} targets, {} decision points, {} landing sites\n", plan.mission.name.empty() ? "tour" : plan.mission.name, plan.targets.size(),
             plan.tour.size(), plan.sites.size());
  for (const std::string& wind : plan.mission.wind.empty() ? std::vector<std::string>{} : formats::windWords(plan.mission.wind)) {
    fmt::print("  wind {}\n", wind);
  }
  for (const std::string& setting : settingWords(plan.mission)) {
    fmt::print("  {}\n", setting);
  }
  fmt::print("  length {:.0f} m, penalty for passing above targets {:.0f} m, cost {:.0f} m\n", m.length, m.penalty, m.cost);
  fmt::print("  {}\n", flightWords(plan));
  printOrigin(plan);
  printFreeBound(m);
  fmt::print("  roadmap {} glides in {:.2f} s; {} tour solutions in {:.2f} s; {} safe segments with {} queries in {:.2f} s\n", m.roadmapExpansions,
             times.roadmap, m.tourSolutions, times.tourSolver, m.safeSegments, m.safeQueries, times.terrainSegments + times.safeSegments);
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    fmt::print("  spiral at target {}: from {:.0f} m down to {:.0f} m MSL without gliding guarantee\n",
               plan.targets[static_cast<std::size_t>(spiral.target)].target.name, spiral.top, spiral.bottom);
  }
  printHome(plan);
  fmt::print("  plan written to {}\n", output);
}

nlohmann::ordered_json summaryToJson(const mission::Plan& plan, const tour::PlanTimes& times, const std::string& output) {
  const mission::PlanMetrics& m = plan.metrics;
  nlohmann::ordered_json json{{"plan", output},
                              {"wind", formats::windText(plan.mission.wind)},
                              {"settings", settingWords(plan.mission)},
                              {"cost_m", m.cost},
                              {"length_m", m.length},
                              {"penalty_m", m.penalty},
                              {"lowerBound_m", m.lowerBound},
                              {"freeLowerBound_m", m.freeLowerBound},
                              {"optimal", m.optimal},
                              {"roadmapExpansions", m.roadmapExpansions},
                              {"safeQueries", m.safeQueries},
                              {"tourSolutions", m.tourSolutions},
                              {"safeSegments", m.safeSegments},
                              {"sampledCost_m", m.sampledCost},
                              {"movesTried", m.movesTried},
                              {"movesAccepted", m.movesAccepted}};
  const route::FlightTotals totals = route::flightTotals(plan);
  json["flight"] = {{"length_m", totals.length}, {"time_s", totals.seconds}, {"climbed_m", totals.climbed}};
  if (totals.energy) {
    json["flight"]["energy"] = *totals.energy;
    json["flight"]["energyUnit"] = aircraft::unitText(mission::powerSettingOf(plan.mission)->unit);
  }
  json["seconds"] = {{"roadmap", times.roadmap},
                     {"terrainSegments", times.terrainSegments},
                     {"safeSegments", times.safeSegments},
                     {"tourSolver", times.tourSolver},
                     {"assembly", times.assembly}};
  nlohmann::ordered_json order = nlohmann::ordered_json::array();
  for (const mission::DecisionPoint& point : plan.tour) {
    if (point.target >= 0) {
      order.push_back(plan.targets[static_cast<std::size_t>(point.target)].target.name);
    }
  }
  json["order"] = std::move(order);
  return json;
}

/// A folder that cannot be written to is found out before minutes of planning.
Result<void> checkOutput(const std::string& output) {
  std::error_code error;
  const std::string folder = folderOf(output);
  if (!std::filesystem::is_directory(folder, error)) {
    return fail(Errc::OutputFailed, "there is no folder of this name to write the plan to; create it or choose another with -o", folder);
  }
  if (std::filesystem::is_directory(output, error)) {
    return fail(Errc::OutputFailed, "is a folder; name a file for the plan with -o", output);
  }
  return {};
}

int runPlan(const PlanArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  const Job job = console.job();
  const auto failed = [&](const Error& error) {
    console.finishProgress();
    return report(error, common.json);
  };
  if (const Result<void> writable = checkOutput(arguments.output); !writable) {
    return failed(writable.error());
  }
  Result<mission::Mission> mission = formats::readMission(arguments.mission);
  if (!mission) {
    return failed(mission.error());
  }
  std::vector<std::string> notes;
  if (const Result<void> applied = applyOverrides(arguments, *mission, notes); !applied) {
    return failed(applied.error());
  }
  Result<formats::LoadedMission> loaded = formats::loadMission(*mission, folderOf(arguments.mission), job.part(0.0, 0.1));
  if (!loaded) {
    Error error = loaded.error();
    error.where = error.where.empty() ? arguments.mission : error.where;
    return failed(error);
  }
  notes.insert(notes.end(), loaded->notes.begin(), loaded->notes.end());
  tour::PlanInput input{loaded->mission, loaded->frame,    loaded->terrain, loaded->terrainFiles, loaded->sites,
                        loaded->targets, programVersion(), arguments.lkh,   arguments.threads};
  input.airspaces = loaded->airspaces;
  tour::PlanTimes times;
  Result<mission::Plan> plan = tour::planTour(input, job.part(0.1, 0.9), &times);
  if (!plan) {
    Error error = plan.error();
    error.where = arguments.mission;
    return failed(error);
  }
  const std::string folder = folderOf(arguments.output);
  formats::makePathsAbsolute(plan->mission, folderOf(arguments.mission));
  formats::makePathsRelative(*plan, folder);  // so that plan and files can move together
  const Result<safety::SafetyReport> verdict = verify(*plan, folder, job.part(0.9, 1.0));
  if (!verdict) {
    return failed(verdict.error());
  }
  console.finishProgress();
  plan->certificate = verdict->certificate;
  const bool write = verdict->isSafe() || arguments.keepUnverified;
  if (write) {
    if (const Result<void> written = formats::writePlan(*plan, arguments.output); !written) {
      return failed(written.error());
    }
  }
  if (common.json) {
    nlohmann::ordered_json json = summaryToJson(*plan, times, write ? arguments.output : "");
    json["notes"] = notes;
    json["verification"] = nlohmann::ordered_json::parse(reportToJson(*plan, *verdict));
    fmt::print("{}", jsonText(json));
  } else if (!common.quiet || !verdict->isSafe()) {
    for (const std::string& note : notes) {
      fmt::print("note: {}\n", note);
    }
    if (write) {
      printSummary(*plan, times, arguments.output);
    }
    printReport(*plan, *verdict);
  }
  return verdict->isSafe() ? kDone : kVerificationFailed;
}

template <typename Value>
std::vector<std::string> keysOf(const std::map<std::string, Value>& map) {
  std::vector<std::string> keys;
  keys.reserve(map.size());
  for (const auto& [key, value] : map) {
    keys.push_back(key);
  }
  return keys;
}

}  // namespace

void addPlanCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Plan the shortest safe tour of a mission, verify it and write it");
  command->add_option("mission", arguments->mission, "Mission file (*.vpm)")->required();
  command->add_option("-o,--output", arguments->output, "Plan file to write (*.vpp)")->required();
  command->add_option("--method", arguments->method, "lazy (default) or base")->check(CLI::IsMember(keysOf(kMethods)));
  command->add_option("--seed", arguments->seed, "Seed of all random choices; the same seed gives the same plan");
  command->add_option("--headings", arguments->headings, "Heading samples per target (k)")->check(CLI::Range(1, 64));
  command->add_option("--step", arguments->step, "Longest distance between decision points, m (d_step)")->check(CLI::Range(1.0, 1000.0));
  command->add_option("--roadmap", arguments->roadmap, "lattice (default) or rrtstar, random samples as in the source paper")
      ->check(CLI::IsMember(keysOf(kRoadmaps)));
  command->add_option("--roadmap-samples", arguments->roadmapSamples, "Glides in the roadmap; implies --roadmap rrtstar")
      ->check(CLI::Range(0, 10'000'000));
  command
      ->add_option("--roadmap-time", arguments->roadmapTime,
                   "Build the roadmap for so many seconds instead (not reproducible); implies --roadmap rrtstar")
      ->check(CLI::Range(0.01, 86400.0));
  command->add_option("--refine", arguments->refine, "full (default): any heading, and other orders; none: the tour over the heading samples")
      ->check(CLI::IsMember(keysOf(kRefines)));
  command->add_option("--tour-solver", arguments->solver, "builtin (default) or lkh, an external program")->check(CLI::IsMember(keysOf(kSolvers)));
  command->add_option("--lkh", arguments->lkh, "The LKH program, for --tour-solver lkh");
  command->add_option("--low-targets", arguments->lowTargets, "Targets below the safe altitude: passAbove (default) or descend by a spiral")
      ->check(CLI::IsMember(keysOf(kLowTargets)));
  command->add_option("--aircraft", arguments->aircraft, "Aircraft profile instead of the mission's: a bundled name or a file");
  auto* home = command->add_option("--home", arguments->home, "Start and end at this runway end, for example LSZS/21");
  command->add_option("--home-landing", arguments->homeLanding, "End at this runway end instead")->needs(home);
  command->add_option("--clearance", arguments->clearance, "Height above terrain to keep everywhere, m")->check(CLI::Range(0.0, 5000.0));
  command->add_option("--ceiling", arguments->ceiling, "Highest altitude of the tour, m MSL")->check(CLI::Range(-500.0, 20000.0));
  command->add_option("--wind", arguments->wind, kWindHelp)->allow_extra_args(false);
  addSettingOptions(*command, arguments->settings);
  command->add_option("--threads", arguments->threads, "Threads to plan with; the plan does not depend on it")->check(CLI::Range(1, 256));
  command->add_flag("--keep-unverified", arguments->keepUnverified, "Write the plan even if the checker refuses it");
  command->callback([arguments, &common, &status] { status = runPlan(*arguments, common); });
}

}  // namespace vp::cli
