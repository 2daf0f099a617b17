// Airspaces that the mission warns of or forbids, against the tour and the glides.

#include "core/safety/airspace_crossing.h"
#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/failures.h"
#include "core/safety/ground_path.h"
#include "core/safety/last_part.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>
#include <span>

namespace vp::safety {
namespace {

using mission::Airspace;
using mission::AirspaceLimit;

/// Heights of a path over a stretch; linear in distance, so the ends bound it.
struct Band {
  double low = 0.0;
  double high = 0.0;
};

/// The tour, or a way from or to home.
struct Path {
  std::span<const mission::DecisionPoint> points;
  const char* name = "tour";
  bool isClosed = true;

  [[nodiscard]] std::size_t intervals() const { return isClosed ? points.size() : points.size() - 1; }
  [[nodiscard]] const mission::DecisionPoint& after(std::size_t i) const { return points[i + 1 == points.size() ? 0 : i + 1]; }
  [[nodiscard]] FindingPlace at(std::size_t i, std::optional<geo::Point> where) const { return {isClosed ? static_cast<int>(i) : -1, where}; }
  [[nodiscard]] std::string nameOf(std::size_t i) const { return fmt::format("{} point {}", name, i); }
};

std::vector<Path> pathsOf(const mission::Plan& plan) {
  std::vector<Path> paths{{plan.tour, "tour", true}};
  if (plan.departure && !plan.departure->points.empty()) {
    paths.push_back({plan.departure->points, "departure", false});
  }
  if (plan.arrival && !plan.arrival->points.empty()) {
    paths.push_back({plan.arrival->points, "arrival", false});
  }
  return paths;
}

/// An airspace in the frame, and where the tour and the glides enter it.
struct Volume {
  const Airspace* airspace = nullptr;
  mission::AirspaceUse use = mission::AirspaceUse::Warn;
  Outline outline;
  double tourLength = 0.0;
  std::optional<FindingPlace> tourAt;
  std::string tourPlace;  ///< what tourAt is: "behind tour point 3"
  std::size_t glides = 0;
  std::optional<FindingPlace> glideAt;
  std::string glidePoint;
};

/// Lowest and highest ground under a stretch by its cells; infinite where unknown, so that it counts as entered.
Band groundUnder(const geo::Pose& start, const flight::Piece& piece, const InsideStretch& stretch, CellWalk& walk) {
  flight::Piece part = piece;
  part.length = stretch.to - stretch.from;
  walk.start(poseOn(start, piece, stretch.from), part);
  Band ground{kNoHeight, -kNoHeight};
  for (Span span; walk.next(span);) {
    if (!span.isKnown()) {
      return {-kNoHeight, kNoHeight};
    }
    ground.low = std::min(ground.low, span.ground);
    ground.high = std::max(ground.high, span.ground);
  }
  return ground;
}

bool isAboveFloor(const AirspaceLimit& floor, double height, double lowestGround) {
  switch (floor.kind) {
    case AirspaceLimit::Kind::Msl:
    case AirspaceLimit::Kind::FlightLevel:
      return height > floor.metres + kAltitudeTolerance;
    case AirspaceLimit::Kind::AboveGround:
      return height > lowestGround + floor.metres + kAltitudeTolerance;
    case AirspaceLimit::Kind::Unlimited:
      return false;
    default:
      return true;
  }
}

bool isBelowCeiling(const AirspaceLimit& ceiling, double height, double highestGround) {
  switch (ceiling.kind) {
    case AirspaceLimit::Kind::Msl:
    case AirspaceLimit::Kind::FlightLevel:
      return height < ceiling.metres - kAltitudeTolerance;
    case AirspaceLimit::Kind::AboveGround:
      return height < highestGround + ceiling.metres - kAltitudeTolerance;
    case AirspaceLimit::Kind::Surface:
      return false;
    default:
      return true;
  }
}

bool needsGround(const Airspace& airspace) {
  return airspace.floor.kind == AirspaceLimit::Kind::AboveGround || airspace.ceiling.kind == AirspaceLimit::Kind::AboveGround;
}

/// "FL 65", "1500 m MSL", as a finding says it.
std::string limitText(const AirspaceLimit& limit) {
  switch (limit.kind) {
    case AirspaceLimit::Kind::Surface:
      return "the surface";
    case AirspaceLimit::Kind::Msl:
      return fmt::format("{:.0f} m MSL", limit.metres);
    case AirspaceLimit::Kind::AboveGround:
      return fmt::format("{:.0f} m above ground", limit.metres);
    case AirspaceLimit::Kind::FlightLevel:
      return fmt::format("FL {:.0f} (taken as {:.0f} m MSL: standard atmosphere, QNH 1013.25 hPa)", limit.metres / kMetresPerFoot / 100.0,
                         limit.metres);
    case AirspaceLimit::Kind::Unlimited:
      return "unlimited";
    case AirspaceLimit::Kind::Unknown:
      break;
  }
  return "a limit in words (NOTAM)";
}

std::string nameOf(const Airspace& airspace) {
  return fmt::format("{} (class {}, {} to {})", airspace.name.empty() ? "an airspace without a name" : airspace.name, airspace.kind,
                     limitText(airspace.floor), limitText(airspace.ceiling));
}

/// Heights along a piece: those at its start, the low one losing the most and the high one the least.
struct Heights {
  Band atStart;
  Descent most;
  double least = 0.0;  // m per m

  [[nodiscard]] Band over(const InsideStretch& stretch) {
    return {std::min(most.down(0.0, atStart.low, stretch.from), most.down(0.0, atStart.low, stretch.to)),
            atStart.high - std::min(least * stretch.from, least * stretch.to)};
  }
};

/// Both alike, `slope` per metre.
Heights alongSlope(double altitude, double slope) {
  return {{altitude, altitude}, Descent(slope), slope};
}

/// Length of a piece inside a volume.
double lengthInside(const Volume& volume, const geo::Pose& start, const flight::Piece& piece, Heights heights, CellWalk& walk,
                    std::optional<geo::Point>& first) {
  double length = 0.0;
  for (const InsideStretch& stretch : volume.outline.stretchesInside(start, piece)) {
    const Band height = heights.over(stretch);
    const Band ground = needsGround(*volume.airspace) ? groundUnder(start, piece, stretch, walk) : Band{};
    if (isAboveFloor(volume.airspace->floor, height.high, ground.low) && isBelowCeiling(volume.airspace->ceiling, height.low, ground.high)) {
      first = first ? first : std::optional(poseOn(start, piece, stretch.from).point());
      length += stretch.to - stretch.from;
    }
  }
  return length;
}

bool isOnEarth(const Airspace& airspace) {
  const auto isPlace = [](const geo::LatLon& p) { return std::abs(p.latitude_deg) <= 90.0 && std::abs(p.longitude_deg) <= 180.0; };
  return airspace.outline.size() >= 3 && std::all_of(airspace.outline.begin(), airspace.outline.end(), isPlace) &&
         std::abs(airspace.floor.metres) <= kHighestAltitude && std::abs(airspace.ceiling.metres) <= kHighestAltitude;
}

void checkPathIn(const Path& path, Volume& volume, CellWalk& walk) {
  for (std::size_t i = 0; i < path.intervals(); ++i) {
    const mission::DecisionPoint& from = path.points[i];
    const double length = from.onward.length;
    if (!isIntegrable(from.onward) || !(length > 0.0)) {
      continue;
    }
    std::optional<geo::Point> first;
    const double slope = (from.altitude - path.after(i).altitude) / length;
    volume.tourLength += lengthInside(volume, from.pose, from.onward, alongSlope(from.altitude, slope), walk, first);
    if (first && !volume.tourAt) {
      volume.tourAt = path.at(i, first);
      volume.tourPlace = "behind " + path.nameOf(i);
    }
  }
}

/// A spiral lap by lap: each is one circle with a constant slope.
void checkSpiralIn(const CheckContext& context, const mission::SpiralVisit& spiral, Volume& volume, CellWalk& walk) {
  const mission::Plan& plan = context.plan;
  const auto isVisit = [&](const mission::DecisionPoint& point) { return point.target == spiral.target; };
  const auto visit = std::find_if(plan.tour.begin(), plan.tour.end(), isVisit);
  const flight::Piece circle{spiral.turn, spiral.radius, 2.0 * Angle::kPi * spiral.radius};
  const bool isFlown = spiral.turn != flight::Turn::Straight && isIntegrable(circle) && spiral.turnsDown >= 1 && spiral.turnsUp >= 1 &&
                       spiral.turnsDown <= kMostTurns && spiral.turnsUp <= kMostTurns;
  if (visit == plan.tour.end() || !isFlown) {
    return;  // other rules find it
  }
  std::optional<geo::Point> first;
  const double depth = spiral.top - spiral.bottom;
  const auto addLap = [&](double start, double loss) {
    volume.tourLength += lengthInside(volume, visit->pose, circle, alongSlope(start, loss / circle.length), walk, first);
  };
  for (int lap = 0; lap < spiral.turnsDown; ++lap) {
    addLap(spiral.top - depth * lap / spiral.turnsDown, depth / spiral.turnsDown);
  }
  for (int lap = 0; lap < spiral.turnsUp; ++lap) {
    addLap(spiral.bottom + depth * lap / spiral.turnsUp, -depth / spiral.turnsUp);
  }
  if (first && !volume.tourAt) {
    volume.tourAt = FindingPlace{static_cast<int>(visit - plan.tour.begin()), first};
    volume.tourPlace = fmt::format("in the spiral at target {}", plan.targets[static_cast<std::size_t>(spiral.target)].target.name);
  }
}

/// How much lower than the path the glide of a point may begin: after a failure anywhere on the way to that point.
double dropBefore(CheckContext& context, const Path& path, std::size_t index) {
  if (index == 0 && !path.isClosed) {
    return 0.0;
  }
  const mission::DecisionPoint& before = path.points[index == 0 ? path.points.size() - 1 : index - 1];
  const double length = before.onward.length;
  const double altitude = path.points[index].altitude;
  Descent descent(context.rates, before.pose.heading, before.onward);
  return std::max(0.0, altitude - Failures(before.altitude, altitude, length, descent, context.reactionLoss).lowestAt(length));
}

/// A glide with the last part that the approach asks for; what does not end so is found elsewhere.
SplitGlide splitOrWhole(const CheckContext& context, const std::vector<flight::Piece>& pieces) {
  const bool isSound = std::all_of(pieces.begin(), pieces.end(), isIntegrable);
  return (isSound ? splitAtGate(pieces, context.plan.mission.approach) : std::nullopt).value_or(SplitGlide{pieces, {}, {}});
}

void checkGlidesIn(CheckContext& context, const Path& path, Volume& volume, CellWalk& walk, const Job& job) {
  for (std::size_t i = 0; i < path.points.size() && !job.stopRequested(); ++i) {
    const mission::DecisionPoint& point = path.points[i];
    geo::Pose pose = point.pose;
    Band height{point.altitude - dropBefore(context, path, i) - context.reactionLoss, point.altitude};
    std::optional<geo::Point> first;
    const SplitGlide glide = splitOrWhole(context, point.witness.pieces);
    for (std::size_t k = 0; k <= glide.before.size(); ++k) {
      const bool isLast = k == glide.before.size();
      const flight::Piece& piece = isLast ? glide.last : glide.before[k];
      if (!isIntegrable(piece) || (isLast && piece.length == 0.0)) {
        break;
      }
      Descent most = isLast && glide.part.slope ? Descent(*glide.part.slope) : Descent(context.rates, pose.heading, piece);
      const double least = context.rates.leastAlong(pose.heading, piece);
      lengthInside(volume, pose, piece, {height, most, least}, walk, first);
      height = {most.down(0.0, height.low, piece.length), height.high - least * piece.length};
      pose = endOfPiece(pose, piece);
    }
    if (first) {
      ++volume.glides;
      if (!volume.glideAt) {
        volume.glideAt = path.at(i, first);
        volume.glidePoint = path.nameOf(i);
      }
    }
  }
}

void report(CheckContext& context, const Volume& volume) {
  if (volume.tourAt) {
    const std::string text =
        fmt::format("the tour flies {:.0f} m inside {}, first {}", volume.tourLength, nameOf(*volume.airspace), volume.tourPlace);
    if (volume.use == mission::AirspaceUse::Forbid) {
      context.findings.violated(rule::kAirspaceTour, text + "; the mission keeps the tour out of it: plan again, or allow it (Mission > Airspace)",
                                *volume.tourAt, -volume.tourLength);
    } else {
      context.findings.warning(rule::kAirspaceTour, text, *volume.tourAt);
    }
  }
  if (volume.glideAt) {
    context.findings.warning(rule::kAirspaceGlide,
                             fmt::format("after an engine failure the glides from {} points, the first from {}, enter {}, which an emergency may",
                                         volume.glides, volume.glidePoint, nameOf(*volume.airspace)),
                             *volume.glideAt);
  }
}

}  // namespace

void checkAirspaces(CheckContext& context, const Job& job) {
  CellWalk walk(context.terrain);
  for (const Airspace& airspace : context.plan.airspaces) {
    const mission::AirspaceUse use = mission::useOf(airspace, context.plan.mission.airspace);
    if (job.stopRequested() || (use != mission::AirspaceUse::Warn && use != mission::AirspaceUse::Forbid)) {
      continue;
    }
    if (!isOnEarth(airspace)) {
      context.findings.violated(rule::kPlanNumber,
                                fmt::format("airspace {}: its outline or limits are no places and heights on Earth", airspace.name));
      continue;
    }
    std::vector<geo::Point> corners;
    for (const geo::LatLon& corner : airspace.outline) {
      corners.push_back(context.frame.toPoint(corner));
    }
    Volume volume{&airspace, use, Outline(std::move(corners)), 0.0, {}, {}, 0, {}, {}};
    for (const Path& path : pathsOf(context.plan)) {
      checkPathIn(path, volume, walk);
      checkGlidesIn(context, path, volume, walk, job);
    }
    for (const mission::SpiralVisit& spiral : context.plan.spirals) {
      checkSpiralIn(context, spiral, volume, walk);
    }
    report(context, volume);
  }
}

}  // namespace vp::safety
