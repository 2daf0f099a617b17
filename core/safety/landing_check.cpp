#include "core/safety/landing_check.h"

#include "core/safety/ground_path.h"
#include "core/safety/landing_rules.h"
#include "core/safety/number_check.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

namespace vp::safety {
namespace {

/// What is kept for paths to come, each with its tables: as many as there are checks at once, and more where paths begin at several altitudes.
constexpr std::size_t kMostKept = 16;

/** A full circle that ends the path in several legs of one turn becomes one piece, as the circle of an approach overhead is asked for. What the same
 * turn does before it stays apart. */
void joinLastCircle(std::vector<flight::Piece>& pieces) {
  if (pieces.empty() || pieces.back().turn == flight::Turn::Straight) {
    return;
  }
  const flight::Piece end = pieces.back();
  const double circle = 2.0 * Angle::kPi * end.radius;
  double joined = 0.0;
  std::size_t first = pieces.size();
  while (first > 0 && joined < circle - kGapTolerance && pieces[first - 1].turn == end.turn && pieces[first - 1].radius == end.radius) {
    joined += pieces[--first].length;
  }
  if (std::abs(joined - circle) <= kGapTolerance) {
    pieces.resize(first);
    pieces.push_back({end.turn, end.radius, joined});
  }
}

}  // namespace

/// As conditionsOf has it for the plan of the path.
LandingAir airOf(const LandingInput& input, const mission::LandingPath& path) {
  if (!input.mission.atmosphere) {
    return {};
  }
  LandingAir air{path.altitude, path.altitude};
  for (const mission::SiteInFrame& site : input.sites) {
    air.lowest = std::min(air.lowest, site.site.elevation.metres());
  }
  for (const mission::LandingLeg& leg : path.legs) {
    air.lowest = std::min(air.lowest, leg.endAltitude);
  }
  return air;
}

LandingGround::LandingGround(const LandingInput& input) {
  plan.mission = input.mission;
  plan.frameOrigin = input.frameOrigin;
  plan.terrainCell = input.terrain.cellSize();
  plan.sites = input.sites;
  plan.sites.emplace_back();
  plan.tour.resize(1);
}

/// The path as a plan of one point, as far as the rules that it shares with plans look at one.
void LandingGround::take(const mission::LandingPath& path) {
  double lowest = path.altitude;
  mission::DecisionPoint begin;
  begin.pose = path.start;
  begin.altitude = path.altitude;
  begin.witness.site = path.site;
  for (const mission::LandingLeg& leg : path.legs) {
    begin.witness.pieces.push_back(leg.piece);
    lowest = std::min(lowest, leg.endAltitude);
  }
  if (plan.mission.approach.kind == mission::ApproachKind::Overhead) {
    joinLastCircle(begin.witness.pieces);
  }
  plan.tour[0] = std::move(begin);
  // The air is counted down to the lowest site; a path without one may end lower.
  plan.sites.back().site.elevation = geo::HeightMsl::fromMetres(lowest);
}

void LandingCheck::checkNumbers() {
  NumberCheck numbers(context_, "landing path");
  numbers.pose(path_.start);
  numbers.altitude("altitude", path_.altitude);
  numbers.within("number of legs", static_cast<double>(path_.legs.size()), 0.0, kMostPieces);
  double length = 0.0;
  for (const mission::LandingLeg& leg : path_.legs) {
    numbers.piece(leg.piece);
    numbers.altitude("altitude at the end of a leg", leg.endAltitude);
    length += leg.piece.length;
  }
  numbers.within("length", length, 0.0, kLongestPath);
  const double last = static_cast<double>(plan_.sites.size()) - 2.0;  // but for the one that planOf adds
  if (path_.site < -1 || static_cast<double>(path_.site) > last) {
    context_.findings.violated(rule::kPlanIndex, fmt::format("landing path: it leads to landing site no. {}, but {} are given",
                                                             std::int64_t{path_.site} + 1, static_cast<int>(last) + 1));
  }
  if (!ground_.known) {
    checkSiteNumbers(context_);
  }
}

bool LandingCheck::checkStructure() {
  checkNumbers();
  if (!context_.findings.isClean()) {
    return false;
  }
  for (const mission::LandingLeg& leg : path_.legs) {
    if (!isSelfConsistent(leg.piece)) {
      context_.findings.violated(rule::kPlanPiece,
                                 fmt::format("landing path: a leg is neither a straight of radius 0 nor a turn of at most {} full circles, so it "
                                             "cannot be flown",
                                             kMostCircles),
                                 {-1, path_.start.point()});
      return false;
    }
  }
  const bool isSane = checkProfile(context_) && checkSettings(context_) && checkAir();
  return checkGrid(context_) && isSane;
}

/// As checkWind, or what it said before in the same air.
bool LandingCheck::checkAir() {
  if (ground_.known == air_) {
    context_.rates = std::move(ground_.rates);
    hasRates_ = true;
  } else {
    ground_.known.reset();
    hasRates_ = checkWind(context_);
  }
  return hasRates_;
}

bool LandingCheck::checkRadii() {
  const double smallest = context_.rates.leastGlideRadius();
  for (std::size_t i = 0; i < path_.legs.size(); ++i) {
    const flight::Piece& piece = path_.legs[i].piece;
    if (piece.turn != flight::Turn::Straight && !(piece.radius >= smallest * (1.0 - kRadiusTolerance))) {
      context_.findings.violated(rule::kGlideRadius,
                                 fmt::format("landing path: leg {} turns with a radius of {:.2f} m, the aircraft needs {:.2f} m: widen the turn",
                                             i + 1, piece.radius, smallest),
                                 {-1, path_.start.point()}, piece.radius - smallest);
      return false;
    }
  }
  return true;
}

void LandingCheck::placeLegs() {
  end_ = path_.start;
  endAltitude_ = path_.altitude;
  double toGo = 0.0;
  for (const mission::LandingLeg& leg : path_.legs) {
    toGo += leg.piece.length;
  }
  legs_.push_back({0, end_, {}, endAltitude_, endAltitude_, toGo});  // the start itself
  for (std::size_t i = 0; i < path_.legs.size(); ++i) {
    const mission::LandingLeg& leg = path_.legs[i];
    toGo = std::max(0.0, toGo - leg.piece.length);
    legs_.push_back({i + 1, end_, leg.piece, endAltitude_, leg.endAltitude, i + 1 == path_.legs.size() ? 0.0 : toGo});
    end_ = endOfPiece(end_, leg.piece);
    endAltitude_ = leg.endAltitude;
  }
}

LandingReport LandingCheck::judge() {
  LandingReport report;
  report.reachesRunway = hasSite();
  if (checkStructure() && checkRadii()) {
    placeLegs();
    if (hasSite()) {
      checkEnd();
    }
    for (const PlacedLeg& leg : legs_) {
      if (leg.number > 0) {
        checkSlope(leg);
      }
      if (leg.number == 0 || leg.piece.length > 0.0) {
        checkClearance(leg);
      }
    }
  }
  if (hasRates_) {
    ground_.rates = std::move(context_.rates);
    ground_.known = air_;
  }
  report.findings = context_.findings.finish();
  report.margins = context_.margins.finish(context_.frame);
  return report;
}

bool LandingReport::isFlyable() const {
  return std::none_of(findings.begin(), findings.end(),
                      [](const Finding& finding) { return finding.severity == Severity::Violated || finding.severity == Severity::Unknown; });
}

LandingReport checkLanding(const LandingInput& input, const mission::LandingPath& path) {
  LandingGround ground(input);
  ground.take(path);
  return LandingCheck(input, path, ground).judge();
}

/** Grounds that no check is using, the one last used at the end. */
struct LandingChecker::Shelf {
  std::mutex mutex;
  std::vector<std::unique_ptr<LandingGround>> grounds;

  /// One that knows the air; none if there is no such.
  std::unique_ptr<LandingGround> take(const LandingAir& air) {
    const std::scoped_lock lock(mutex);
    const auto found = std::find_if(grounds.begin(), grounds.end(), [&](const auto& ground) { return ground->known == air; });
    if (found == grounds.end()) {
      return nullptr;
    }
    std::unique_ptr<LandingGround> ground = std::move(*found);
    grounds.erase(found);
    return ground;
  }
  void put(std::unique_ptr<LandingGround> ground) {
    const std::scoped_lock lock(mutex);
    if (grounds.size() == kMostKept) {
      grounds.erase(grounds.begin());
    }
    grounds.push_back(std::move(ground));
  }
};

LandingChecker::LandingChecker(const LandingInput& input) : input_(input), shelf_(std::make_unique<Shelf>()) {}
LandingChecker::~LandingChecker() = default;

LandingReport LandingChecker::check(const mission::LandingPath& path) const {
  std::unique_ptr<LandingGround> ground = shelf_->take(airOf(input_, path));
  if (!ground) {
    ground = std::make_unique<LandingGround>(input_);
  }
  ground->take(path);
  LandingReport report = LandingCheck(input_, path, *ground).judge();
  if (ground->known) {
    shelf_->put(std::move(ground));
  }
  return report;
}

}  // namespace vp::safety
