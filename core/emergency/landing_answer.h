#pragma once

#include "core/mission/landing_path.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::emergency {

/** One part of what an answer costs. The cost of an answer is the sum of weight * value; a weight of 0 tells, but does not count. */
struct CostTerm {
  std::string name;     ///< for a pilot: "height lost"
  double value = 0.0;   ///< in `unit`
  std::string unit;     ///< "m", "s", "" for a share
  double weight = 0.0;  ///< [1 / unit]
};

/** How often something was tried: "glides tried against the ground", 4211. */
struct Tried {
  std::string what;
  std::int64_t count = 0;
};

/** What one planner has to say to one request. Its path proves nothing until safety::checkLanding has judged it. */
struct LandingAnswer {
  std::string planner;                       ///< that made it, by its name in planners.h; of a combined answer the one whose path was taken
  std::optional<mission::LandingPath> path;  ///< with site -1: reaches no runway, the best that can be had
  std::vector<CostTerm> terms;
  /** No path of this request costs less than this; none: a heuristic, which says nothing about what it did not find. */
  std::optional<double> lowerBound;
  double heightInHand = 0.0;  ///< m, of a path to a site: left when it begins its approach, beyond the lowest from which the approach arrives
  std::vector<Tried> tried;
  std::string whyNot;              ///< a sentence with its stop where there is no path to a runway, else empty
  std::vector<std::string> notes;  ///< what else a pilot should know, sentences with their stop
  double missing = 0.0;            ///< m of height that a glide to a runway lacks, where that is known; else 0
  double seconds = 0.0;            ///< from the request to this answer
  std::uint64_t seed = 0;          ///< of the request
  bool verified = false;  ///< safety::checkLanding found it flyable, and safe if it has a site. Only `combined` and verifiedAnswer() set this

  [[nodiscard]] bool reachesRunway() const { return path && path->site >= 0; }
  /** Sum of weight * value. */
  [[nodiscard]] double cost() const {
    double sum = 0.0;
    for (const CostTerm& term : terms) {
      sum += term.weight * term.value;
    }
    return sum;
  }
};

}  // namespace vp::emergency
