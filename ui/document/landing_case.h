#pragma once

#include "core/emergency/landing_answer.h"
#include "core/landing/world.h"
#include "ui/document/plan_view.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::document {

/** An answer to "the engine has stopped here", made ready for drawing. */
struct ShownLanding {
  emergency::LandingAnswer answer;
  EngineOut glide;                           ///< its path sampled; empty where there is none. Its margin is the height in hand
  std::optional<mission::SiteInFrame> site;  ///< that it ends at; none: no runway
};

/** One question of the operator, wherever on the map: where to, if the engine stopped here? And what the planners have said so far.
 *  Not part of the mission: nothing of it is saved. Frame of the terrain, m MSL. */
struct LandingCase {
  geo::Pose pose;
  double altitude = 0.0;
  double ground = 0.0;     ///< under it, upper bound; infinity where unknown
  double clearance = 0.0;  ///< of the mission, m
  std::vector<ShownLanding> landings;
  int selected = -1;       ///< index into landings; -1: none
  bool isRunning = false;  ///< more answers come

  [[nodiscard]] const ShownLanding* shown() const {
    return selected >= 0 && selected < static_cast<int>(landings.size()) ? &landings[static_cast<std::size_t>(selected)] : nullptr;
  }
};

/** Samples the path of an answer, over the world that it was planned in, for drawing.   @threads pure */
ShownLanding shownLanding(emergency::LandingAnswer answer, const landing::World& world);

/** Index of the landing to look at first: of those verified down to a runway the one with the most height in hand, else the one that comes
 *  farthest; -1 if no answer has a path.   @threads pure */
int bestLanding(const std::vector<ShownLanding>& landings);

}  // namespace vp::document
