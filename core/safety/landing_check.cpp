#include "core/safety/landing_check.h"

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/descent.h"
#include "core/safety/ground_path.h"
#include "core/safety/last_part.h"
#include "core/safety/limits.h"
#include "core/safety/number_check.h"
#include "core/safety/rules.h"
#include "core/safety/witness_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How much steeper than the glide in the worst wind a leg may be where no steeper descent is known: rounding of files and planners.
constexpr double kSteeperThanGlide = 1.001;

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

/// The path as a plan of one point, as far as the rules that it shares with plans look at one.
mission::Plan planOf(const LandingInput& input, const mission::LandingPath& path) {
  mission::Plan plan;
  plan.mission = input.mission;
  plan.frameOrigin = input.frameOrigin;
  plan.terrainCell = input.terrain.cellSize();
  plan.sites = input.sites;
  double lowest = path.altitude;
  mission::DecisionPoint& begin = plan.tour.emplace_back();
  begin.pose = path.start;
  begin.altitude = path.altitude;
  begin.witness.site = path.site;
  for (const mission::LandingLeg& leg : path.legs) {
    begin.witness.pieces.push_back(leg.piece);
    lowest = std::min(lowest, leg.endAltitude);
  }
  // The air is counted down to the lowest site; a path without one may end lower.
  plan.sites.emplace_back().site.elevation = geo::HeightMsl::fromMetres(lowest);
  return plan;
}

class LandingCheck {
public:
  LandingCheck(const LandingInput& input, const mission::LandingPath& path)
      : path_(path), plan_(planOf(input, path)), plain_{plan_, input.terrain, {}}, context_(plain_), walk_(input.terrain) {}

  LandingReport judge();

private:
  bool checkStructure();
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
  mission::Plan plan_;
  SafetyInput plain_;
  CheckContext context_;
  CellWalk walk_;
  std::vector<PlacedLeg> legs_;
  geo::Pose end_;
  double endAltitude_ = 0.0;
  LastPart part_;             // of the approach
  double lastLength_ = -1.0;  // m of path that it holds for; below zero: for none
  double missing_ = 0.0;      // m that flat parts of all legs so far promise and no glide has
};

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
    context_.findings.violated(
        rule::kPlanIndex, fmt::format("landing path: it leads to landing site no. {}, but {} are given", path_.site, static_cast<int>(last) + 1));
  }
  checkSiteNumbers(context_);
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
  const bool isSane = checkProfile(context_) && checkSettings(context_) && checkWind(context_);
  return checkGrid(context_) && isSane;
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

/// Part by part between the places at which the greatest loss changes: with the course, and where the leg passes an altitude.
void LandingCheck::checkSlope(const PlacedLeg& leg) {
  const double length = leg.piece.length;
  if (!(length > 0.0)) {
    missing_ += std::abs(leg.to - leg.from);
    if (missing_ > kAltitudeTolerance) {
      context_.findings.violated(
          rule::kLandingSlope, fmt::format("landing path: leg {} changes altitude by {:.1f} m on the spot", leg.number, std::abs(leg.to - leg.from)),
          {-1, leg.start.point()}, -std::abs(leg.to - leg.from));
    }
    return;
  }
  const double slope = (leg.from - leg.to) / length;
  std::vector<double> places{0.0, length};
  for (const double edge : context_.rates.edges()) {
    const double at = (leg.from - edge) / slope;
    if (at > 0.0 && at < length) {
      places.push_back(at);
    }
  }
  Descent breaks(context_.rates, leg.start.heading, leg.piece);
  for (double at = breaks.nextBreak(0.0); at < length; at = breaks.nextBreak(at)) {
    places.push_back(at);
  }
  std::sort(places.begin(), places.end());
  double greatest = 0.0;
  double missing = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double middle = 0.5 * (places[i - 1] + places[i]);
    const std::vector<double>& edges = context_.rates.edges();
    const auto band = static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), leg.altitudeAt(middle)) - edges.begin());
    const LossAlong loss = context_.rates.alongIn(band, leg.start.heading, leg.piece);
    const double rate = loss.isFinite() ? loss.rateAt(middle) : kInfinity;
    greatest = std::max(greatest, rate);
    missing += std::max(0.0, rate - slope) * (places[i] - places[i - 1]);
  }
  const auto degrees = [](double tangent) { return Angle::radians(std::atan(tangent)).degrees(); };
  if (missing > 0.0 && !(missing_ + missing <= kAltitudeTolerance)) {
    context_.findings.violated(
        rule::kLandingSlope,
        fmt::format(
            "landing path: leg {} goes down by {:.2f} degrees, flatter than the glide there, which needs up to {:.2f} degrees: plan it steeper",
            leg.number, degrees(slope), degrees(greatest)),
        {-1, leg.start.point()}, degrees(slope) - degrees(greatest));
  }
  missing_ += missing;
  const std::optional<Angle>& descent = plan_.mission.aircraft.steepestDescent;
  const double most =
      std::max(kSteeperThanGlide * greatest, descent ? tan(*descent) * context_.rates.descentShare(leg.start.heading, leg.piece) : 0.0);
  if (!((slope - most) * length <= kAltitudeTolerance)) {
    context_.findings.violated(
        rule::kLandingSlope,
        fmt::format(
            "landing path: leg {} goes down by {:.2f} degrees, steeper than the aircraft can descend there, {:.2f} degrees: lose the height in "
            "circles, or name a steeper descent in the profile",
            leg.number, degrees(slope), degrees(most)),
        {-1, leg.start.point()}, degrees(most) - degrees(slope));
  }
}

void LandingCheck::checkClearanceAt(const PlacedLeg& leg, double at, double ground) {
  const double asked = clearanceAt(leg.toGo + leg.piece.length - at);
  const double altitude = leg.altitudeAt(at);
  const double left = altitude - ground - asked;
  const geo::Point place = poseOn(leg.start, leg.piece, at).point();
  context_.margins.note(MarginKind::GlideClearance, left, place);
  if (!(left >= -kAltitudeTolerance)) {
    context_.findings.violated(
        rule::kGlideClearance,
        fmt::format("landing path: leg {} is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m too low for the clearance of {:.0f} m", leg.number,
                    altitude, ground, -left, asked),
        {-1, place}, left);
  }
}

/// Altitude and clearance asked for are linear between the places looked at, the ground is one.
void LandingCheck::checkClearance(const PlacedLeg& leg) {
  std::vector<double> kinks;
  if (lastLength_ >= 0.0 && part_.surfaceSlope) {
    for (const double toGo : {part_.surfaceStart, part_.surfaceStart + context_.clearance / *part_.surfaceSlope, lastLength_}) {
      kinks.push_back(leg.toGo + leg.piece.length - toGo);
    }
  }
  walk_.start(leg.start, leg.piece);
  for (Span span; walk_.next(span);) {
    if (!span.isKnown()) {
      context_.findings.unknown(rule::kTerrainUnknown, fmt::format("landing path: leg {} crosses ground of unknown height", leg.number),
                                {-1, poseOn(leg.start, leg.piece, span.from).point()});
      return;
    }
    checkClearanceAt(leg, span.from, span.ground);
    for (const double at : kinks) {
      if (at > span.from && at < span.to) {
        checkClearanceAt(leg, at, span.ground);
      }
    }
    if (span.to > span.from) {
      checkClearanceAt(leg, span.to, span.ground);
    }
  }
}

/// The approach that the mission asks for; what it makes of the clearance holds for the legs that it covers.
void LandingCheck::checkApproach(const mission::SiteInFrame& site) {
  const mission::ApproachSettings& approach = plan_.mission.approach;
  const std::optional<SplitGlide> split = splitAtGate(plan_.tour[0].witness.pieces, approach);
  if (!split) {
    const bool isStraight = approach.kind == mission::ApproachKind::Straight;
    context_.findings.violated(
        isStraight ? rule::kApproachStraight : rule::kApproachCircle,
        isStraight ? fmt::format("landing path: its last {:.0f} m to {} are not straight", approach.finalLength.si(), site.site.id)
                   : fmt::format("landing path: it does not end in one full circle from above the touchdown point of {}", site.site.id),
        {-1, site.pose.point()});
    return;
  }
  if (approach.kind == mission::ApproachKind::Threshold) {
    return;
  }
  part_ = split->part;
  lastLength_ = split->last.length;
  if (!part_.keyHeight) {
    return;
  }
  const double key = site.site.elevation.metres() + *part_.keyHeight;
  double gate = kInfinity;  // m MSL, altitude there
  for (const PlacedLeg& leg : legs_) {
    const double at = leg.toGo + leg.piece.length - lastLength_;
    if (leg.number > 0 && at >= -kSpacingTolerance && at <= leg.piece.length + kSpacingTolerance) {
      gate = std::min(gate, leg.altitudeAt(std::clamp(at, 0.0, leg.piece.length)));
    }
  }
  if (!(gate >= key - kAltitudeTolerance)) {
    context_.findings.violated(rule::kApproachKey,
                               fmt::format("landing path: it is at {:.1f} m MSL at the high key of {}, {:.1f} m below the {:.1f} m required", gate,
                                           site.site.id, key - gate, key),
                               {-1, site.pose.point()}, gate - key);
  }
}

void LandingCheck::checkEnd() {
  const mission::SiteInFrame& end = site();
  const FindingPlace place{-1, end_.point()};
  const double offset = geo::distance(end_.point(), end.pose.point());
  if (!(offset <= kArrivalPlaceTolerance)) {
    context_.findings.violated(rule::kGlideSite, fmt::format("landing path: it ends {:.2f} m from the touchdown point of {}", offset, end.site.id),
                               place, -offset);
  }
  const double turned = Angle::radians(std::abs(wrapPi(end_.heading - end.pose.heading))).degrees();
  if (!(turned <= Angle::radians(kArrivalHeadingTolerance).degrees())) {
    context_.findings.violated(rule::kGlideHeading,
                               fmt::format("landing path: it arrives {:.2f} degrees off the landing course of {}", turned, end.site.id), place,
                               -turned);
  }
  const double asked = end.site.elevation.metres() + context_.arrivalMargin;
  const double left = endAltitude_ - asked;
  context_.margins.note(MarginKind::GlideArrival, left, end_.point());
  if (!(left >= -kAltitudeTolerance)) {
    context_.findings.violated(
        rule::kGlideArrival,
        fmt::format("landing path: it arrives at {} at {:.1f} m MSL, {:.1f} m below the {:.1f} m required (runway at {:.1f} m)", end.site.id,
                    endAltitude_, -left, asked, end.site.elevation.metres()),
        place, left);
  }
  checkSite(context_, end);
  checkLength(context_, end);
  checkApproach(end);
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
  report.findings = context_.findings.finish();
  report.margins = context_.margins.finish(context_.frame);
  return report;
}

}  // namespace

bool LandingReport::isFlyable() const {
  return std::none_of(findings.begin(), findings.end(),
                      [](const Finding& finding) { return finding.severity == Severity::Violated || finding.severity == Severity::Unknown; });
}

LandingReport checkLanding(const LandingInput& input, const mission::LandingPath& path) {
  return LandingCheck(input, path).judge();
}

}  // namespace vp::safety
