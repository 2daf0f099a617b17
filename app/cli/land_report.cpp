#include "app/cli/land_report.h"

#include "app/cli/json_text.h"
#include "core/emergency/landing_outcome.h"
#include "core/flight/curve_sampling.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vp::cli {
namespace {

/// Legs that are one turn or one straight for a pilot.
struct Part {
  flight::Piece piece;
  geo::Pose end;
  double endAltitude = 0.0;
};

std::vector<Part> partsOf(const mission::LandingPath& path) {
  std::vector<Part> all;
  geo::Pose pose = path.start;
  for (const mission::LandingLeg& leg : path.legs) {
    pose = flight::endOf(pose, leg.piece);
    if (!all.empty() && all.back().piece.turn == leg.piece.turn && all.back().piece.radius == leg.piece.radius) {
      all.back().piece.length += leg.piece.length;
    } else {
      all.push_back({leg.piece, {}, 0.0});
    }
    all.back().end = pose;
    all.back().endAltitude = leg.endAltitude;
  }
  return all;
}

int courseOf(const geo::LocalFrame& frame, const geo::Pose& pose) {
  const auto degrees = static_cast<int>(std::lround(frame.trueCourseOf(pose.heading, pose.point()).degrees()));
  return degrees % 360 == 0 ? 360 : degrees % 360;
}

std::string clockOf(double seconds) {
  const auto whole = std::lround(seconds);
  return fmt::format("{}:{:02d}", whole / 60, whole % 60);
}

double secondsIn(const emergency::LandingAnswer& answer) {
  for (const emergency::CostTerm& term : answer.terms) {
    if (term.name == "time") {
      return term.value;
    }
  }
  return 0.0;
}

void printWay(const emergency::LandingRequest& request, const mission::LandingPath& path) {
  const geo::LocalFrame frame(request.frameOrigin);
  for (const Part& part : partsOf(path)) {
    const int course = courseOf(frame, part.end);
    if (part.piece.turn == flight::Turn::Straight) {
      fmt::print("    straight on {:03d} for {}, down to {:.0f} m\n", course,
                 part.piece.length < 1000.0 ? fmt::format("{:.0f} m", part.piece.length) : fmt::format("{:.1f} km", 1e-3 * part.piece.length),
                 part.endAltitude);
    } else {
      fmt::print("    {} turn of {:.0f} degrees onto {:03d}, at most {:.0f} degrees of bank, down to {:.0f} m\n",
                 part.piece.turn == flight::Turn::Left ? "left" : "right", Angle::radians(part.piece.length / part.piece.radius).degrees(), course,
                 request.world->glide.bankOf(part.piece.radius).degrees(), part.endAltitude);
    }
  }
}

void printTerms(const emergency::LandingAnswer& answer) {
  for (const emergency::CostTerm& term : answer.terms) {
    if (term.name == emergency::kWeatherSuccess) {
      fmt::print("  comes through the weather with a probability of {:.1f} %\n", 100.0 * term.value);
    } else if (term.weight > 0.0) {
      fmt::print("  cost: {} {:.4g}{}{}{}\n", term.name, term.value, term.unit.empty() ? "" : " ", term.unit,
                 term.weight == 1.0 ? "" : fmt::format(" x {:g}", term.weight));
    }
  }
  if (answer.reachesRunway()) {
    fmt::print("  cost in all {:.4g}, {}\n", answer.cost(),
               answer.lowerBound ? fmt::format("no path costs less than {:.4g}", *answer.lowerBound) : "a heuristic: no bound is known");
  }
}

constexpr std::size_t kExplained = 3;  // runways of the ranked list with all their lines; --json has all of all

void printRanking(const LandQuestion& question) {
  const auto reached = static_cast<std::size_t>(
      std::count_if(question.ranking.begin(), question.ranking.end(), [](const emergency::RankedRunway& one) { return one.isReached; }));
  if (reached == 0) {
    return;
  }
  fmt::print("runways by total risk, {} of {} reached:\n", reached, question.ranking.size());
  for (std::size_t i = 0; i < reached; ++i) {
    const emergency::RankedRunway& runway = question.ranking[i];
    const mission::LandingSite& site = question.request.world->sites[static_cast<std::size_t>(runway.site)].site;
    fmt::print("  {}. {}{}: {:.1f} % expected to go well\n", i + 1, site.id, site.airportName.empty() ? "" : fmt::format(" ({})", site.airportName),
               100.0 * std::exp(-runway.logRisk));
    for (std::size_t line = 0; line < runway.lines.size() && i < kExplained; ++line) {
      const emergency::RankingLine& one = runway.lines[line];
      fmt::print("       -{:4.1f} %  {}: {}\n", 100.0 * (1.0 - std::exp(-one.logRisk)), one.name, one.sentence);
    }
  }
}

}  // namespace

void printAnswer(const LandQuestion& question, const emergency::LandingAnswer& answer) {
  const emergency::LandingRequest& request = question.request;
  for (const std::string& note : question.notes) {
    fmt::print("note: {}\n", note);
  }
  if (answer.reachesRunway()) {
    const mission::LandingSite& site = request.world->sites[static_cast<std::size_t>(answer.path->site)].site;
    const geo::Pose& touchdown = request.world->sites[static_cast<std::size_t>(answer.path->site)].pose;
    fmt::print("land at {}{}, {:.1f} km away on {:03d}: {:.1f} km to fly, {} min\n", site.id,
               site.airportName.empty() ? "" : fmt::format(" ({})", site.airportName), 1e-3 * geo::distance(request.pose.point(), touchdown.point()),
               courseOf(geo::LocalFrame(request.frameOrigin),
                        {request.pose.x, request.pose.y, std::atan2(touchdown.y - request.pose.y, touchdown.x - request.pose.x)}),
               1e-3 * emergency::lengthOf(*answer.path), clockOf(secondsIn(answer)));
    fmt::print("  {:.0f} m of height in hand: over the threshold at {:.0f} m MSL, {:.0f} m above the runway\n", answer.heightInHand,
               answer.path->legs.empty() ? answer.path->altitude : answer.path->legs.back().endAltitude,
               (answer.path->legs.empty() ? answer.path->altitude : answer.path->legs.back().endAltitude) - site.elevation.metres());
  } else {
    fmt::print("NO RUNWAY: {}\n", answer.whyNot);
    if (answer.path) {
      fmt::print("  not a runway: this glide {}, {:.1f} km away, and keeps the clearance until then\n",
                 request.risk == nullptr ? "gets farthest" : "gets far at the least risk to people", 1e-3 * emergency::reachOf(*answer.path));
    }
  }
  if (answer.path) {
    printWay(request, *answer.path);
    printTerms(answer);
    fmt::print("  verified by the checker; found by {} in {:.3g} s{}\n", answer.planner, answer.seconds,
               question.roadmapSeconds > 0.0 ? fmt::format(", after {:.2g} s for the roadmap", question.roadmapSeconds) : "");
  }
  for (const std::string& note : answer.notes) {
    fmt::print("  {}\n", note);
  }
  printRanking(question);
}

std::string answerToJson(const LandQuestion& question, const emergency::LandingAnswer& answer) {
  const emergency::LandingRequest& request = question.request;
  const geo::LocalFrame frame(request.frameOrigin);
  nlohmann::ordered_json json{{"asked", question.planner}, {"planner", answer.planner}, {"reachesRunway", answer.reachesRunway()}};
  json["whyNot"] = answer.whyNot;
  json["missing_m"] = answer.missing;
  if (answer.reachesRunway()) {
    const mission::LandingSite& site = request.world->sites[static_cast<std::size_t>(answer.path->site)].site;
    json["site"] = site.id;
    json["elevation_m"] = site.elevation.metres();
    json["heightInHand_m"] = answer.heightInHand;
  }
  json["terms"] = nlohmann::ordered_json::array();
  for (const emergency::CostTerm& term : answer.terms) {
    json["terms"].push_back({{"name", term.name}, {"value", term.value}, {"unit", term.unit}, {"weight", term.weight}});
  }
  json["cost"] = answer.path ? nlohmann::ordered_json(answer.cost()) : nlohmann::ordered_json();
  json["lowerBound"] = answer.lowerBound ? nlohmann::ordered_json(*answer.lowerBound) : nlohmann::ordered_json("heuristic");
  if (answer.path) {
    json["verified"] = answer.verified;
    json["isRunway"] = answer.path->site >= 0;
    json["path"] = nlohmann::ordered_json::array();
    geo::Pose pose = answer.path->start;
    for (const mission::LandingLeg& leg : answer.path->legs) {
      pose = flight::endOf(pose, leg.piece);
      const geo::LatLon end = frame.toLatLon(pose.point());
      const char* turn = leg.piece.turn == flight::Turn::Left ? "left" : leg.piece.turn == flight::Turn::Right ? "right" : "straight";
      json["path"].push_back({{"turn", turn},
                              {"radius_m", leg.piece.radius},
                              {"length_m", leg.piece.length},
                              {"longitude", end.longitude_deg},
                              {"latitude", end.latitude_deg},
                              {"course_deg", frame.trueCourseOf(pose.heading, pose.point()).degrees()},
                              {"altitude_m", leg.endAltitude}});
    }
  }
  json["tried"] = nlohmann::ordered_json::object();
  for (const emergency::Tried& tried : answer.tried) {
    json["tried"][tried.what] = tried.count;
  }
  json["ranking"] = nlohmann::ordered_json::array();
  for (const emergency::RankedRunway& runway : question.ranking) {
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const emergency::RankingLine& line : runway.lines) {
      lines.push_back({{"name", line.name},
                       {"value", line.isKnown ? nlohmann::ordered_json(line.value) : nlohmann::ordered_json()},
                       {"unit", line.unit},
                       {"logRisk", line.logRisk},
                       {"sentence", line.sentence}});
    }
    json["ranking"].push_back({{"site", request.world->sites[static_cast<std::size_t>(runway.site)].site.id},
                               {"reached", runway.isReached},
                               {"logRisk", runway.logRisk},
                               {"probability", std::exp(-runway.logRisk)},
                               {"lines", lines}});
  }
  json["seconds"] = answer.seconds;
  json["roadmapSeconds"] = question.roadmapSeconds;
  json["deadline_s"] = request.deadline;
  json["seed"] = answer.seed;
  std::vector<std::string> notes = question.notes;
  notes.insert(notes.end(), answer.notes.begin(), answer.notes.end());
  json["notes"] = notes;
  return jsonText(json);
}

}  // namespace vp::cli
