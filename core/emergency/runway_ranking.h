#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/landing_request.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::emergency {

/** One reason why a runway stands where it does. */
struct RankingLine {
  std::string name;      ///< "runway length"
  double value = 0.0;    ///< in `unit`; 0 where it is not known
  std::string unit;      ///< "m", "kt", "people", "" for a share
  bool isKnown = true;   ///< false: counted with a stated value
  double logRisk = 0.0;  ///< what it adds to the total: -log of the probability that it goes well, >= 0
  std::string sentence;  ///< for a pilot, with its stop
};

/** A runway end among all of the mission, with what landing there risks. */
struct RankedRunway {
  int site = -1;           ///< index into World::sites
  bool isReached = false;  ///< a way there was found that the checker accepts
  double logRisk = 0.0;    ///< sum over the lines
  std::vector<RankingLine> lines;
  LandingAnswer answer;  ///< the way there, verified; or why there is none
};

/** What is counted, and how. All values are choices but for those with a source: WHY-weather.md, "The ranked list". */
struct RankingOptions {
  const LandingAnswer* known =
      nullptr;                ///< an answer with a verified path, which counts for its runway if it meets no more weather than the one found here
  double lowestHand = 150.0;  ///< m of height in hand (500 ft): less counts, up to `noHand` with none
  double noHand = 0.1;
  double outOfRange = 10.0;      ///< a runway that cannot be reached
  double unknownWeather = 0.02;  ///< on the way
  double ceilingNotKnown = 0.02;
  double servicesNotKnown = 0.02;
  double factoredLength = 1.67;  ///< of the landing distance: 14 CFR 121.195 (b) asks of transport aircraft to stop within 60 % of the runway
  double shortRunway = 0.1;      ///< where the runway is just as long as the landing distance; twenty times as much for all of it missing
  double lengthNotKnown = 0.1;
  double needNotKnown = 0.02;
  double fullWidth = 18.0;  ///< m: runways of code number 1, ICAO Annex 14 volume I, 3.1.10
  double noWidth = 0.05;
  double widthNotKnown = 0.01;
  double windAtLimit = 0.02;     ///< crosswind at the aircraft's limit, tailwind likewise; with the square of the wind
  double crosswindLimit = 15.0;  ///< kt, where the profile names none: usual among light aircraft's demonstrated values
  double tailwindLimit = 10.0;   ///< kt, where the profile names none: 14 CFR 25.105 (d)'s usual limit, and where handbooks' tables end
  double windNotKnown = 0.01;
  double approachLength = 3.0;       ///< nautical miles of the final course that people under it are counted for
  double approachHalfWidth = 100.0;  ///< m to either side
  double perPerson = 1e-4;
  double mostPeople = 0.2;
  double peopleNotKnown = 0.01;
  double noLights = 0.005;
};

/** Every runway of the request's world by total risk, the best first; those that cannot be reached come last. [4] section 1: weather on the way,
 * ceiling and visibility, length, width and surface, wind, people under the final approach, emergency services.
 *
 *  The way to each is planned by a planner of [4] within an equal share of the deadline that is left, and judged by the checker; in the order of
 *  the height that they need at least, until time is over or the request is stopped: runways not come to until then count as not reached and say so.
 *  @pre request.world and request.mission are not null; nothing is asked of requestFault
 *  @threads as many as the request allows   @cost up to the deadline, and the checker's for each path */
std::vector<RankedRunway> rankRunways(const LandingRequest& request, const RankingOptions& options = {});

}  // namespace vp::emergency
