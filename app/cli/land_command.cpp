// volplane-cli land MISSION --at LON,LAT,ALT,COURSE: the engine has stopped here; where to, and how?
#include "app/cli/commands.h"
#include "app/cli/land_report.h"
#include "app/cli/settings.h"
#include "app/cli/values.h"
#include "core/emergency/landing_judge.h"
#include "core/emergency/planners.h"
#include "core/emergency/runway_ranking.h"
#include "core/emergency/verified_answer.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/formats/population_file.h"
#include "core/formats/weather_file.h"
#include "core/landing/build_roadmap.h"
#include "core/risk/people_under.h"
#include "core/risk/population.h"
#include "core/risk/weather.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <thread>

namespace vp::cli {
namespace {

struct LandArguments {
  std::string mission;
  std::string at;
  std::string planner = "combined";
  std::string deadline = "1s";
  std::uint64_t seed = 1;
  int threads = 1;
  std::string population;
  std::string weather;
  std::vector<std::string> wind;
  SettingOptions settings;
};

/// Where the aircraft is, as --at says.
struct Place {
  geo::LatLon position;
  double altitude = 0.0;  ///< m MSL
  Angle course;           ///< true
};

Result<Place> placeAt(const std::string& text) {
  constexpr const char* kOption = "--at";
  const std::vector<std::string> parts = partsOf(text);
  if (parts.size() != 4) {
    return fail(Errc::OutOfRange,
                fmt::format("\"{}\" is no place and course; give longitude,latitude,altitude,true course, for example 9.81,46.62,2400m,210", text),
                kOption);
  }
  const Result<std::vector<double>> numbers = numbersIn(fmt::format("{},{},{}", parts[0], parts[1], parts[3]), 3);
  if (!numbers) {
    return fail(Errc::OutOfRange, numbers.error().what, kOption);
  }
  const Result<geo::LatLon> position = placeFrom((*numbers)[1], (*numbers)[0], kOption);
  if (!position) {
    return forward(position);
  }
  const Result<double> altitude = altitudeIn(parts[2], kOption);
  if (!altitude) {
    return forward(altitude);
  }
  if ((*numbers)[2] < 0.0 || (*numbers)[2] > 360.0) {
    return fail(Errc::OutOfRange, fmt::format("{} is no course; give degrees from 0 to 360, true", (*numbers)[2]), kOption);
  }
  return Place{*position, *altitude, Angle::degrees((*numbers)[2])};
}

/// People on the ground as the risk that planners keep low: nobody is at risk from higher than the aircraft is, [3] (42).
Result<void> addPopulation(const std::vector<std::string>& files, const geo::LocalFrame& frame, emergency::LandingRequest& request,
                           std::vector<std::string>& notes) {
  std::vector<mission::PopulationArea> areas;
  for (const std::string& file : files) {
    Result<formats::PopulationReport> read = formats::readPopulation(file);
    if (!read) {
      return forward(read);
    }
    notes.insert(notes.end(), read->notes.begin(), read->notes.end());
    std::move(read->areas.begin(), read->areas.end(), std::back_inserter(areas));
  }
  Result<risk::Population> people = risk::Population::from(areas, frame);
  if (!people) {
    return forward(people);
  }
  if (request.altitude > 0.0) {
    request.risk = std::make_shared<const risk::PeopleUnder>(std::make_shared<const risk::Population>(std::move(*people)),
                                                             request.world->glide.airspeed(), request.altitude);
  }
  return {};
}

/// Bad weather: told of every path, and the planners of [4] keep out of it. @param source  that it is from, for errors
Result<void> addWeather(const std::vector<mission::WeatherCell>& cells, const std::string& source, const geo::LocalFrame& frame,
                        emergency::LandingRequest& request) {
  Result<std::shared_ptr<const risk::Weather>> weather = risk::Weather::from(cells, frame);
  if (!weather) {
    return fail(weather.error().code, weather.error().what, source);
  }
  request.weather = std::move(*weather);
  return {};
}

/// People and weather of the options, else the mission's own.
Result<void> addRisks(const LandArguments& arguments, const geo::LocalFrame& frame, emergency::LandingRequest& request,
                      std::vector<std::string>& notes) {
  std::vector<std::string> people{arguments.population};
  if (arguments.population.empty()) {
    mission::Mission placed = *request.mission;
    formats::makePathsAbsolute(placed, folderOf(arguments.mission));
    people = placed.populationFiles;
  }
  if (!people.empty()) {
    if (const Result<void> added = addPopulation(people, frame, request, notes); !added) {
      return forward(added);
    }
  }
  if (arguments.weather.empty()) {
    const std::vector<mission::WeatherCell>& own = request.mission->weather;
    return own.empty() ? Result<void>() : addWeather(own, arguments.mission, frame, request);
  }
  const Result<formats::WeatherReport> read = formats::readWeather(arguments.weather);
  if (!read) {
    return forward(read);
  }
  notes.insert(notes.end(), read->notes.begin(), read->notes.end());
  return addWeather(read->cells, arguments.weather, frame, request);
}

/// The mission's world and where the aircraft is in it.
Result<emergency::LandingRequest> requestFor(const LandArguments& arguments, std::vector<std::string>& notes, const Job& job) {
  const Result<Place> place = placeAt(arguments.at);
  if (!place) {
    return forward(place);
  }
  const Result<double> deadline = secondsIn(arguments.deadline, "--deadline");
  if (!deadline) {
    return forward(deadline);
  }
  Result<mission::Mission> mission = formats::readMission(arguments.mission);
  if (!mission) {
    return forward(mission);
  }
  if (const Result<void> applied = applySettings(arguments.settings, *mission); !applied) {
    return forward(applied);
  }
  if (const Result<void> applied = applyWind(arguments.wind, *mission, notes); !applied) {
    return forward(applied);
  }
  Result<formats::LoadedMission> loaded = formats::loadMission(*mission, folderOf(arguments.mission), job);
  if (!loaded) {
    return forward(loaded);
  }
  notes.insert(notes.end(), loaded->notes.begin(), loaded->notes.end());
  emergency::LandingRequest request;
  const geo::Point point = loaded->frame.toPoint(place->position);
  request.pose = {point.x, point.y, loaded->frame.headingOf(place->course, place->position)};
  request.altitude = place->altitude;
  request.frameOrigin = loaded->frame.origin();
  request.mission = std::make_shared<const mission::Mission>(loaded->mission);
  request.world =
      std::make_shared<const landing::World>(landing::worldOf(loaded->mission, std::move(loaded->sites), terrain::TerrainPyramid(loaded->terrain)));
  request.deadline = *deadline;
  request.seed = arguments.seed;
  request.threads = arguments.threads;
  request.job = job;
  if (const Result<void> added = addRisks(arguments, loaded->frame, request, notes); !added) {
    return forward(added);
  }
  return request;
}

/// A roadmap as the tour has it, before the clock begins: in flight there is one already. @return the seconds it took
double provideRoadmap(emergency::LandingRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  landing::RoadmapRequest wanted;
  wanted.area = request.world->terrain.grid().extent();
  wanted.threads = request.threads;
  if (auto roadmap = landing::buildRoadmap(*request.world, request.mission->planner, wanted, request.job)) {
    request.roadmap = std::move(*roadmap);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int statusOf(const emergency::LandingAnswer& answer, bool refused, const Job& job) {
  if (answer.reachesRunway()) {
    return kDone;
  }
  return job.stopRequested() ? kStopped : refused ? kVerificationFailed : kNoSolution;
}

int runLand(const LandArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  std::vector<std::string> notes;
  Result<emergency::LandingRequest> request = requestFor(arguments, notes, console.job());
  console.finishProgress();
  if (!request) {
    return report(request.error(), common.json);
  }
  if (const std::optional<std::string> fault = emergency::requestFault(*request)) {
    return report({Errc::OutOfRange, fault->substr(0, fault->size() - 1), request->deadline > 0.0 ? "--at" : "--deadline"}, common.json);
  }
  LandQuestion question{*request, arguments.planner, 0.0, std::move(notes)};
  if (arguments.planner == "roadmap" || arguments.planner == "combined") {
    question.roadmapSeconds = provideRoadmap(*request);
    console.finishProgress();
  }
  *request = emergency::withJudge(std::move(*request));
  emergency::LandingAnswer answer = emergency::makePlanner(arguments.planner)->plan(*request);
  bool refused = false;
  if (answer.path && !answer.verified) {
    answer = emergency::verifiedAnswer(*request, std::move(answer));
    refused = !answer.verified;
  }
  if (!request->job.stopRequested()) {
    emergency::RankingOptions ranking;
    ranking.known = &answer;
    question.ranking = emergency::rankRunways(*request, ranking);
  }
  if (common.json) {
    fmt::print("{}", answerToJson(question, answer));
  } else if (!common.quiet) {
    printAnswer(question, answer);
  }
  return statusOf(answer, refused, request->job);
}

}  // namespace

void addLandCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<LandArguments>();
  arguments->threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("land", "The engine stops here: which runway, and which way");
  command->add_option("mission", arguments->mission, "Mission file (*.vpm)")->required();
  command
      ->add_option("--at", arguments->at,
                   "Where the aircraft is: longitude,latitude,altitude above mean sea level,true course, for example 9.81,46.62,2400m,210")
      ->required();
  const std::vector<std::string> names = emergency::plannerNames();
  command->add_option("--planner", arguments->planner, fmt::format("{}; combined (default) runs the best of the others", fmt::join(names, ", ")))
      ->check(CLI::IsMember(names));
  command->add_option("--deadline", arguments->deadline, "Time for the answer: 1s (default), 200ms");
  command->add_option("--seed", arguments->seed, "Seed of all random choices");
  command->add_option("--threads", arguments->threads, "Threads to plan with")->check(CLI::Range(1, 256));
  command->add_option("--population", arguments->population,
                      "Polygons with how many people live in them (GeoJSON, shapefile, GeoPackage, KML): planners keep away from people; "
                      "else those of the mission");
  command->add_option(
      "--weather", arguments->weather,
      "Polygons of bad weather with floor, top and probability of coming through (GeoJSON, shapefile, GeoPackage, KML): planners keep "
      "out of it; else that of the mission");
  command->add_option("--wind", arguments->wind, kWindHelp)->allow_extra_args(false);
  addSettingOptions(*command, arguments->settings);
  command->callback([arguments, &common, &status] { status = runLand(*arguments, common); });
}

}  // namespace vp::cli
