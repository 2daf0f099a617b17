#pragma once

// Inside of core/safety: how one landing path is judged. What it means: landing_check.h.

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/landing_check.h"
#include "core/safety/last_part.h"
#include "core/safety/limits.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace vp::safety {

/** A leg where it lies: start pose, altitudes at both ends, and metres of path to go from its end. */
struct PlacedLeg {
  std::size_t number = 0;
  geo::Pose start;
  flight::Piece piece;
  double from = 0.0;  // m MSL
  double to = 0.0;
  double toGo = 0.0;

  [[nodiscard]] double altitudeAt(double distance) const {
    return piece.length > 0.0 ? from + (to - from) * (distance / piece.length) : std::min(from, to);
  }
};

/** What the losses of a path depend on beside the mission: where there is an atmosphere, the altitudes of its air [m MSL]. */
struct LandingAir {
  double lowest = 0.0;
  double highest = 0.0;

  bool operator==(const LandingAir&) const = default;
};

LandingAir airOf(const LandingInput& input, const mission::LandingPath& path);

/** A mission as the rules that landing paths share with plans look at one, and what was worked out for the paths before. */
struct LandingGround {
  explicit LandingGround(const LandingInput& input);

  /** Makes the plan that of a path, of one point. */
  void take(const mission::LandingPath& path);

  mission::Plan plan;               ///< with one site more than there are: the lowest place of the path
  std::optional<LandingAir> known;  ///< that the rates are of; none: nothing is known, or the mission is not sound
  GlideRates rates;
};

/** One path judged. */
class LandingCheck {
public:
  /** @param ground  of the same input, that has taken the path; one check at a time */
  LandingCheck(const LandingInput& input, const mission::LandingPath& path, LandingGround& ground)
      : path_(path),
        ground_(ground),
        plan_(ground.plan),
        plain_{plan_, input.terrain, {}},
        air_(airOf(input, path)),
        context_(plain_),
        walk_(input.terrain) {}

  LandingReport judge();

private:
  bool checkStructure();
  bool checkAir();
  void checkNumbers();
  bool checkRadii();
  void placeLegs();
  void checkSlope(const PlacedLeg& leg);
  void checkClearance(const PlacedLeg& leg);
  void checkClearanceAt(const PlacedLeg& leg, double at, double ground);
  void checkEnd();
  void checkApproach(const mission::SiteInFrame& site);

  [[nodiscard]] const mission::SiteInFrame& site() const { return plan_.sites[static_cast<std::size_t>(path_.site)]; }
  [[nodiscard]] bool hasSite() const { return path_.site >= 0; }
  /// Clearance asked for with so many metres of path to go [m]; at the gate the whole, as for who comes from before it.
  [[nodiscard]] double clearanceAt(double toGo) const {
    return toGo < lastLength_ - kSpacingTolerance ? part_.clearanceAt(toGo, context_.clearance) : context_.clearance;
  }

  const mission::LandingPath& path_;
  LandingGround& ground_;
  const mission::Plan& plan_;
  SafetyInput plain_;
  LandingAir air_;
  CheckContext context_;
  CellWalk walk_;
  bool hasRates_ = false;  // in the context, for the ground
  std::vector<PlacedLeg> legs_;
  geo::Pose end_;
  double endAltitude_ = 0.0;
  LastPart part_;             // of the approach
  double lastLength_ = -1.0;  // m of path that it holds for; below zero: for none
  double missing_ = 0.0;      // m that flat parts of all legs so far promise and no glide has
};

}  // namespace vp::safety
