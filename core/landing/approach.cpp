#include "core/landing/approach.h"

#include "core/aircraft/glide_bands.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace vp::landing {
namespace {

using mission::ApproachKind;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kPart = 2.0;  // m of the approach that are bounded together
constexpr double kMostParts = 2000.0;
constexpr std::array kSides{flight::Turn::Left, flight::Turn::Right};

tl::unexpected<Error> unusable(const mission::SiteInFrame& site, const std::string& why) {
  return fail(Errc::NoLandingSite, site.site.id + ": " + why);
}

flight::Piece circleOf(flight::Turn turn, double radius) {
  return {turn, radius, 2.0 * Angle::kPi * radius};
}

/// Clearance with so many metres to go.
double clearanceAt(const World& world, double toGo) {
  const mission::ApproachSettings& asked = world.approach;
  return asked.surfaceSlope ? std::min(world.clearance, *asked.surfaceSlope * std::max(0.0, toGo - asked.surfaceStart.si())) : world.clearance;
}

/// Lowest height at the gate from which the approach by one piece clears the ground and arrives; infinite over unknown ground.
double requiredOn(const World& world, const geo::Pose& gate, const flight::Piece& piece, const flight::PieceLoss& loss, double arrival) {
  double required = arrival + loss.upTo(piece.length);
  const int parts = std::max(1, static_cast<int>(std::min(kMostParts, std::ceil(piece.length / kPart))));
  const flight::Piece part{piece.turn, piece.radius, piece.length / parts};
  for (int i = 0; i < parts; ++i) {
    const double flown = part.length * i;
    const double ground = maxTerrainAlong(world.terrain, flight::poseAfter(gate, piece, flown), part);
    required = std::max(required, ground + clearanceAt(world, piece.length - flown) + loss.upTo(part.length * (i + 1)));
  }
  return required;
}

/// Height lost per metre of a straight approach, if the aircraft can hold that.
Result<double> slopeOf(const World& world, const mission::SiteInFrame& site) {
  const double course = site.pose.heading;
  const double glide = world.glide.lossOver(std::cos(course), std::sin(course));
  if (!world.approach.slope) {  // what it is at the altitudes of the approach is found there
    return std::isfinite(glide) ? Result<double>(glide) : unusable(site, "the glide makes no way against the wind on its approach");
  }
  const Angle chosen = *world.approach.slope;
  if (!world.steepestDescent) {
    return unusable(site, "the aircraft's profile has no steepest descent, which an approach of a chosen slope needs");
  }
  if (!(tan(chosen) >= glide)) {
    return unusable(site, fmt::format("its approach of {:.1f} degrees cannot be held, as the glide descends at {:.1f} degrees there",
                                      chosen.degrees(), Angle::radians(std::atan(glide)).degrees()));
  }
  const double airspeed = world.glide.airspeed();
  const double shear = 1.0 + airspeed * world.glide.shear() / kGravity.si();  // sinking into a headwind holds the aircraft up
  const double steepest = tan(*world.steepestDescent) * airspeed / (airspeed + world.glide.mostTailwind(course)) / shear;
  if (!(tan(chosen) <= steepest)) {
    return unusable(site, fmt::format("its approach of {:.1f} degrees cannot be held, as the aircraft descends at no more than {:.1f} degrees there",
                                      chosen.degrees(), Angle::radians(std::atan(steepest)).degrees()));
  }
  return tan(chosen);
}

double arrivalAt(const World& world, const mission::SiteInFrame& site) {
  return site.site.elevation.metres() + world.arrivalMargin;
}

Result<Approach> straightTo(const World& world, const mission::SiteInFrame& site) {
  const Result<double> slope = slopeOf(world, site);
  if (!slope) {
    return forward(slope);
  }
  Approach approach;
  approach.gate = gateOf(world.approach, site);
  approach.pieces = {{flight::Turn::Straight, 0.0, world.approach.finalLength.si()}};
  if (world.approach.slope) {
    approach.altitude = requiredOn(world, approach.gate, approach.pieces[0], flight::PieceLoss(*slope), arrivalAt(world, site));
    return approach;
  }
  const auto needed = [&](const aircraft::GlideModel& cover, double end, double /*giveUpAbove*/) {
    const double perMetre = cover.lossOver(std::cos(site.pose.heading), std::sin(site.pose.heading));
    return requiredOn(world, approach.gate, approach.pieces[0], flight::PieceLoss(perMetre), end);
  };
  approach.altitude = aircraft::leastStart(world.glide, arrivalAt(world, site), needed);
  return approach;
}

Result<Approach> overheadTo(const World& world, const mission::SiteInFrame& site) {
  Approach approach;
  approach.gate = site.pose;
  approach.altitude = kInfinite;
  for (const double radius : world.glide.glideRadii()) {
    for (const flight::Turn turn : kSides) {
      const flight::Piece circle = circleOf(turn, radius);
      const auto needed = [&](const aircraft::GlideModel& cover, double end, double /*giveUpAbove*/) {
        const flight::PieceLoss loss(circle, site.pose.heading, flight::turnLossOf(cover, radius));
        return requiredOn(world, approach.gate, circle, loss, end);
      };
      const double altitude = aircraft::leastStart(world.glide, arrivalAt(world, site), needed);
      if (altitude < approach.altitude) {
        approach.altitude = altitude;
        approach.pieces = {circle};
      }
    }
  }
  if (world.approach.keyHeight) {
    approach.altitude = std::max(approach.altitude, site.site.elevation.metres() + world.approach.keyHeight->si());
  }
  return approach;
}

Result<Approach> thresholdOf(const World& world, const mission::SiteInFrame& site) {
  Approach approach;
  approach.gate = site.pose;
  // DESIGN section 2: A(site) is elevation + margin, and the site itself is a point of the glide that needs clearance
  approach.altitude = std::max(arrivalAt(world, site), world.terrain.grid().upperAt(site.pose.point()) + world.clearance);
  return approach;
}

/// The hold with the lowest circles; of equal ones the widest.
std::optional<mission::Hold> holdOver(const World& world, const Approach& approach) {
  std::optional<mission::Hold> best;
  for (const double radius : world.glide.glideRadii()) {
    for (const flight::Turn turn : kSides) {
      const double ground = maxTerrainAlong(world.terrain, approach.gate, circleOf(turn, radius));
      const double lowest = std::max(approach.altitude, ground + world.clearance);
      if (std::isfinite(lowest) && (!best || lowest < best->lowest)) {
        best = mission::Hold{approach.site, turn, radius, lowest};
      }
    }
  }
  return best;
}

}  // namespace

geo::Pose gateOf(const mission::ApproachSettings& settings, const mission::SiteInFrame& site) {
  if (settings.kind != ApproachKind::Straight) {
    return site.pose;
  }
  const double length = settings.finalLength.si();
  return {site.pose.x - length * std::cos(site.pose.heading), site.pose.y - length * std::sin(site.pose.heading), site.pose.heading};
}

Result<Approach> approachTo(const World& world, std::size_t number) {
  const mission::SiteInFrame& site = world.sites[number];
  const ApproachKind kind = world.approach.kind;
  Result<Approach> approach = kind == ApproachKind::Straight   ? straightTo(world, site)
                              : kind == ApproachKind::Overhead ? overheadTo(world, site)
                                                               : thresholdOf(world, site);
  if (!approach) {
    return approach;
  }
  if (!std::isfinite(approach->altitude)) {
    return unusable(site, "the ground under its approach is of unknown height");
  }
  approach->site = static_cast<int>(number);
  if (world.approach.hold) {
    approach->hold = holdOver(world, *approach);
    if (!approach->hold) {
      return unusable(site, "there is no room for a holding circle over known ground at the beginning of its approach");
    }
  }
  return approach;
}

std::vector<Approach> approachesOf(const World& world) {
  std::vector<Approach> approaches;
  for (std::size_t site = 0; site < world.sites.size(); ++site) {
    if (Result<Approach> approach = approachTo(world, site)) {
      approaches.push_back(std::move(*approach));
    }
  }
  return approaches;
}

std::vector<std::string> approachFaults(const World& world) {
  std::vector<std::string> faults;
  for (std::size_t site = 0; site < world.sites.size(); ++site) {
    if (const Result<Approach> approach = approachTo(world, site); !approach) {
      faults.push_back(approach.error().what);
    }
  }
  return faults;
}

Error noApproach(const World& world) {
  const std::vector<std::string> faults = approachFaults(world);
  if (faults.empty() || (world.approach.kind == ApproachKind::Threshold && !world.approach.hold)) {
    return {Errc::NoLandingSite,
            "no landing site lies on terrain with known height; load terrain that covers at least one runway of the airfield list",
            {}};
  }
  const std::string others = faults.size() > 1 ? fmt::format(", and neither do the {} others have theirs", faults.size() - 1) : "";
  return {Errc::NoLandingSite, fmt::format("no landing site can have the approach that the mission asks for: {}{}", faults.front(), others), {}};
}

std::vector<flight::Piece> joinedGlide(const World& world, std::vector<flight::Piece> way, const std::vector<flight::Piece>& glide) {
  for (const flight::Piece& piece : glide) {
    const bool isCircle = world.approach.kind == ApproachKind::Overhead && &piece == &glide.back();
    if (!isCircle && !way.empty() && way.back().turn == piece.turn && way.back().radius == piece.radius) {
      way.back().length += piece.length;
    } else {
      way.push_back(piece);
    }
  }
  return way;
}

void setHolds(const World& world, mission::Plan& plan) {
  plan.holds.clear();
  if (!world.approach.hold) {
    return;
  }
  std::set<int> used;
  const auto add = [&](const std::vector<mission::DecisionPoint>& points) {
    for (const mission::DecisionPoint& point : points) {
      if (point.witness.site >= 0) {
        used.insert(point.witness.site);
      }
    }
  };
  add(plan.tour);
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    if (*path) {
      add((*path)->points);
    }
  }
  for (const int site : used) {
    if (const Result<Approach> approach = approachTo(world, static_cast<std::size_t>(site)); approach && approach->hold) {
      plan.holds.push_back(*approach->hold);
    }
  }
}

}  // namespace vp::landing
