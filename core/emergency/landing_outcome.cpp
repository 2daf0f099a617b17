#include "core/emergency/landing_outcome.h"

#include "core/emergency/glide_flight.h"
#include "core/emergency/longest_glide.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/risk/leg_risk.h"
#include "core/risk/weather.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

/// A touchdown that is lower than it may be only by so much is not: rounding, as landing::kMarginTolerance [m].
constexpr double kArrivalTolerance = 1e-3;

double endAltitude(const mission::LandingPath& path) {
  return path.legs.empty() ? path.altitude : path.legs.back().endAltitude;
}

/// Passes each leg with the pose and the altitude at its beginning to `use`.
template <typename Use>
void forEachLeg(const mission::LandingPath& path, Use use) {
  geo::Pose pose = path.start;
  double altitude = path.altitude;
  for (const mission::LandingLeg& leg : path.legs) {
    use(pose, altitude, leg);
    pose = flight::endOf(pose, leg.piece);
    altitude = leg.endAltitude;
  }
}

double secondsOf(const landing::World& world, const mission::LandingPath& path) {
  double seconds = 0.0;
  forEachLeg(path, [&](const geo::Pose& pose, double /*altitude*/, const mission::LandingLeg& leg) {
    seconds += flight::glideSeconds(world.glide, pose, leg.piece);
  });
  return seconds;
}

LandingAnswer emptyAnswer(const LandingRequest& request, std::string_view planner) {
  LandingAnswer answer;
  answer.planner = planner;
  answer.seed = request.seed;
  return answer;
}

}  // namespace

double lengthOf(const mission::LandingPath& path) {
  double length = 0.0;
  for (const mission::LandingLeg& leg : path.legs) {
    length += leg.piece.length;
  }
  return length;
}

int manoeuvresOf(const mission::LandingPath& path) {
  int count = 0;
  const flight::Piece* last = nullptr;
  for (const mission::LandingLeg& leg : path.legs) {
    count += last != nullptr && last->turn == leg.piece.turn && last->radius == leg.piece.radius ? 0 : 1;
    last = &leg.piece;
  }
  return count;
}

double reachOf(const mission::LandingPath& path) {
  geo::Pose end = path.start;
  for (const mission::LandingLeg& leg : path.legs) {
    end = flight::endOf(end, leg.piece);
  }
  return geo::distance(path.start.point(), end.point());
}

double riskOf(const LandingRequest& request, const mission::LandingPath& path) {
  double risk = 0.0;
  if (request.risk != nullptr) {
    forEachLeg(path, [&](const geo::Pose& pose, double altitude, const mission::LandingLeg& leg) {
      risk += request.risk->of(pose, leg.piece, altitude, leg.endAltitude);
    });
  }
  return risk;
}

double weatherOf(const LandingRequest& request, const mission::LandingPath& path) {
  double sum = 0.0;
  if (request.weather != nullptr) {
    const risk::WeatherRisk weather(request.weather);
    forEachLeg(path, [&](const geo::Pose& pose, double altitude, const mission::LandingLeg& leg) {
      sum += weather.of(pose, leg.piece, altitude, leg.endAltitude);
    });
  }
  return sum;
}

double heightInHand(const landing::World& world, const mission::LandingPath& path) {
  const Result<landing::Approach> approach = approachInLegs(world, static_cast<std::size_t>(path.site));
  if (!approach) {
    return 0.0;
  }
  std::vector<mission::LandingLeg> legs;
  return endAltitude(path) - GlideFlight(world).flyApproach(*approach, approach->altitude, legs);
}

LandingAnswer answerWith(const LandingRequest& request, const LandingGoals& goals, std::string_view planner, mission::LandingPath path) {
  const landing::World& world = *request.world;
  LandingAnswer answer = emptyAnswer(request, planner);
  answer.heightInHand = heightInHand(world, path);
  const bool byWeather = request.weather != nullptr;
  const bool byRisk = byWeather || request.risk != nullptr;
  if (byWeather) {
    const double weather = weatherOf(request, path);
    answer.terms.push_back({"weather", weather, "", 1.0});
    answer.terms.push_back({kWeatherSuccess, std::exp(-weather), "", 0.0});
  }
  if (request.risk != nullptr) {
    answer.terms.push_back({request.risk->name(), riskOf(request, path), request.risk->unit(), byWeather ? 0.0 : 1.0});
  }
  // start = lost to the gate + in hand + lowest height at the gate
  const Result<landing::Approach> approach = approachInLegs(world, static_cast<std::size_t>(path.site));
  const double gate = approach ? approach->altitude : goals.lowestGate();
  const double weight = byRisk ? 0.0 : 1.0;
  answer.terms.push_back({"height lost to the approach", path.altitude - answer.heightInHand - gate, "m", weight});
  answer.terms.push_back({"approach higher than the lowest in range", gate - goals.lowestGate(), "m", weight});
  answer.terms.push_back({"manoeuvres", static_cast<double>(manoeuvresOf(path)), "", byRisk ? 0.0 : kPerManoeuvre});
  answer.terms.push_back({kDistance, lengthOf(path), "m", 0.0});
  answer.terms.push_back({"time", secondsOf(world, path), "s", 0.0});
  if (!byRisk && !goals.inRange().empty()) {
    answer.lowerBound = std::max(0.0, goals.inRange().front().least - goals.lowestGate());
  }
  answer.path = std::move(path);
  return answer;
}

LandingAnswer answerWithout(const LandingRequest& request, std::string_view planner, std::string why, double missing, const Countdown& countdown) {
  LandingAnswer answer = emptyAnswer(request, planner);
  answer.whyNot = std::move(why);
  answer.missing = missing;
  answer.path = longestGlide(request, countdown);
  if (answer.path) {
    answer.terms = {{kHowFar, reachOf(*answer.path), "m", -1.0},
                    {kDistance, lengthOf(*answer.path), "m", 0.0},
                    {"time", secondsOf(*request.world, *answer.path), "s", 0.0}};
    if (request.risk != nullptr) {
      answer.terms.push_back({request.risk->name(), riskOf(request, *answer.path), request.risk->unit(), 0.0});
    }
    answer.notes.emplace_back(
        request.risk == nullptr
            ? "The path is NOT to a runway: of the glides that keep the clearance it gets farthest."
            : "The path is NOT to a runway: of the glides that keep the clearance and get far it is the one of least risk to people.");
  }
  answer.seconds = countdown.elapsed();
  return answer;
}

LandingAnswer answerToFault(const LandingRequest& request, std::string_view planner, std::string fault) {
  LandingAnswer answer = emptyAnswer(request, planner);
  answer.whyNot = std::move(fault);
  return answer;
}

std::optional<mission::LandingPath> withApproach(const LandingRequest& request, const landing::Approach& approach,
                                                 std::vector<mission::LandingLeg> way, double altitude) {
  const landing::World& world = *request.world;
  if (altitude < approach.altitude - kArrivalTolerance) {
    return std::nullopt;
  }
  const double end = GlideFlight(world).flyApproach(approach, altitude, way);
  const mission::SiteInFrame& site = world.sites[static_cast<std::size_t>(approach.site)];
  if (end < site.site.elevation.metres() + world.arrivalMargin - kArrivalTolerance) {
    return std::nullopt;
  }
  return mission::LandingPath{request.pose, request.altitude, std::move(way), approach.site};
}

}  // namespace vp::emergency
