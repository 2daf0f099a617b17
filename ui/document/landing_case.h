#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/runway_ranking.h"
#include "core/landing/world.h"
#include "ui/document/plan_view.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::document {

/** An answer to "the engine has stopped here", made ready for drawing. */
struct ShownLanding {
  emergency::LandingAnswer answer;
  EngineOut glide;                           ///< its path sampled; empty where there is none. Its margin is the height in hand
  std::optional<mission::SiteInFrame> site;  ///< that it ends at; none: no runway
};

/** A runway of the ranked list, made ready for drawing. */
struct ShownRunway {
  mission::SiteInFrame site;
  bool isReached = false;
  double logRisk = 0.0;                       ///< -log of the probability that all goes well
  std::vector<emergency::RankingLine> lines;  ///< that it is made of
  ShownLanding landing;                       ///< the way there, or why there is none
};

/** One question of the operator, wherever on the map: where to, if the engine stopped here? And what the planners have said so far.
 *  Not part of the mission: nothing of it is saved. Frame of the terrain, m MSL. */
struct LandingCase {
  geo::Pose pose;
  double altitude = 0.0;
  double ground = 0.0;     ///< under it, upper bound; infinity where unknown
  double clearance = 0.0;  ///< of the mission, m
  std::vector<ShownLanding> landings;
  int selected = -1;                 ///< index into landings; -1: none
  bool isRunning = false;            ///< more answers come
  std::vector<ShownRunway> runways;  ///< ranked, the least risk first; empty: not asked yet, or stopped before
  int selectedRunway = -1;           ///< index into runways, looked at in place of the landing; -1: none
  bool hasWeather = false;           ///< the mission has weather, which the answers tell of
  bool hasPeople = false;            ///< the mission has population

  /** What is drawn: the runway looked at, else the landing. */
  [[nodiscard]] const ShownLanding* shown() const {
    if (selectedRunway >= 0 && selectedRunway < static_cast<int>(runways.size())) {
      return &runways[static_cast<std::size_t>(selectedRunway)].landing;
    }
    return selected >= 0 && selected < static_cast<int>(landings.size()) ? &landings[static_cast<std::size_t>(selected)] : nullptr;
  }
};

/** Samples the path of an answer, over the world that it was planned in, for drawing.   @threads pure */
ShownLanding shownLanding(emergency::LandingAnswer answer, const landing::World& world);

/** The same of a ranked runway.   @threads pure */
ShownRunway shownRunway(emergency::RankedRunway runway, const landing::World& world);

/** A term of an answer by its name; none: the answer does not tell it. */
std::optional<double> termOf(const emergency::LandingAnswer& answer, const std::string& name);

/** Index of the landing to look at first: of those verified down to a runway the one that most likely comes through the weather, of equal ones the
 * one with the most height in hand, else the one that comes farthest; -1 if no answer has a path.   @threads pure */
int bestLanding(const std::vector<ShownLanding>& landings);

}  // namespace vp::document
