// Legs and end of a landing path: WHY.md section 15.

#include "core/safety/landing_rules.h"

#include "core/safety/descent.h"
#include "core/safety/ground_path.h"
#include "core/safety/rules.h"
#include "core/safety/witness_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How much steeper than the glide in the worst wind a leg may be where the profile names a steepest descent that is less: rounding of files and
/// planners.
constexpr double kRoundingOfSlope = 1.001;
/// The same where it names none. A planner counts the worst wind and air of whole
/// bands of altitude, up to 1.23 times what is found here (tst_landing_planners, three layers from 5 to 25 kt); WHY.md section 15.
constexpr double kSteeperThanGlide = 1.5;

}  // namespace

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
  Descent losses(context_.rates, leg.start.heading, leg.piece);
  for (double at = losses.nextBreak(0.0); at < length; at = losses.nextBreak(at)) {
    places.push_back(at);
  }
  std::sort(places.begin(), places.end());
  double greatest = 0.0;
  double missing = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double middle = 0.5 * (places[i - 1] + places[i]);
    const std::vector<double>& edges = context_.rates.edges();
    const auto band = static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), leg.altitudeAt(middle)) - edges.begin());
    const LossAlong& loss = losses.lossIn(band);
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
  const double most = descent ? std::max(kRoundingOfSlope * greatest, tan(*descent) * context_.rates.descentShare(leg.start.heading, leg.piece))
                              : kSteeperThanGlide * greatest;
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

}  // namespace vp::safety
