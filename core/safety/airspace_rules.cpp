// Airspaces that the mission warns of or forbids, against the tour and the glides.

#include "core/safety/airspace_crossing.h"
#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/ground_path.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

using mission::Airspace;
using mission::AirspaceLimit;

/// Heights of a path over a stretch; linear in distance, so the ends bound it.
struct Band {
  double low = 0.0;
  double high = 0.0;
};

/// An airspace in the frame, and where the tour and the glides enter it.
struct Volume {
  const Airspace* airspace = nullptr;
  mission::AirspaceUse use = mission::AirspaceUse::Warn;
  Outline outline;
  double tourLength = 0.0;
  std::optional<FindingPlace> tourAt;
  std::size_t glides = 0;
  std::optional<FindingPlace> glideAt;
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

/** Length of a piece inside a volume. `low` and `high` are the heights at its start, both losing `slope` per metre. */
double lengthInside(const Volume& volume, const geo::Pose& start, const flight::Piece& piece, Band atStart, double slope, CellWalk& walk,
                    std::optional<geo::Point>& first) {
  double length = 0.0;
  for (const InsideStretch& stretch : volume.outline.stretchesInside(start, piece)) {
    const Band height{atStart.low - std::max(slope * stretch.from, slope * stretch.to),
                      atStart.high - std::min(slope * stretch.from, slope * stretch.to)};
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

void checkTourIn(CheckContext& context, Volume& volume, CellWalk& walk) {
  const std::vector<mission::DecisionPoint>& tour = context.plan.tour;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const double length = tour[i].onward.length;
    if (!isIntegrable(tour[i].onward) || !(length > 0.0)) {
      continue;
    }
    std::optional<geo::Point> first;
    const double slope = (tour[i].altitude - tour[context.next(i)].altitude) / length;
    volume.tourLength += lengthInside(volume, tour[i].pose, tour[i].onward, {tour[i].altitude, tour[i].altitude}, slope, walk, first);
    if (first && !volume.tourAt) {
      volume.tourAt = FindingPlace{static_cast<int>(i), first};
    }
  }
}

/// How much lower than the tour the glide of a point may begin: after a failure anywhere on the way to that point.
double dropBefore(const CheckContext& context, std::size_t index) {
  const std::vector<mission::DecisionPoint>& tour = context.plan.tour;
  const mission::DecisionPoint& before = tour[index == 0 ? tour.size() - 1 : index - 1];
  const double rate = before.onward.turn == flight::Turn::Straight ? context.model.straightLoss() : context.model.lossAt(before.onward.radius);
  return std::max(0.0, tour[index].altitude - (before.altitude - rate * before.onward.length));
}

void checkGlidesIn(CheckContext& context, Volume& volume, CellWalk& walk, const Job& job) {
  const std::vector<mission::DecisionPoint>& tour = context.plan.tour;
  for (std::size_t i = 0; i < tour.size() && !job.stopRequested(); ++i) {
    geo::Pose pose = tour[i].pose;
    Band height{tour[i].altitude - dropBefore(context, i), tour[i].altitude};
    std::optional<geo::Point> first;
    for (const flight::Piece& piece : tour[i].witness.pieces) {
      if (!isIntegrable(piece)) {
        break;
      }
      const double rate = piece.turn == flight::Turn::Straight ? context.model.straightLoss() : context.model.lossAt(piece.radius);
      lengthInside(volume, pose, piece, height, rate, walk, first);
      height = {height.low - rate * piece.length, height.high - rate * piece.length};
      pose = endOfPiece(pose, piece);
    }
    if (first) {
      ++volume.glides;
      volume.glideAt = volume.glideAt ? volume.glideAt : FindingPlace{static_cast<int>(i), first};
    }
  }
}

void report(CheckContext& context, const Volume& volume) {
  if (volume.tourAt) {
    const std::string text = fmt::format("the tour flies {:.0f} m inside {}, first behind tour point {}", volume.tourLength, nameOf(*volume.airspace),
                                         volume.tourAt->tourPoint);
    if (volume.use == mission::AirspaceUse::Forbid) {
      context.findings.violated(rule::kAirspaceTour, text + "; the mission forbids it", *volume.tourAt, -volume.tourLength);
    } else {
      context.findings.warning(rule::kAirspaceTour, text, *volume.tourAt);
    }
  }
  if (volume.glideAt) {
    context.findings.warning(rule::kAirspaceGlide,
                             fmt::format("glides from {} tour points, the first from point {}, enter {}", volume.glides, volume.glideAt->tourPoint,
                                         nameOf(*volume.airspace)),
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
    Volume volume{&airspace, use, Outline(std::move(corners)), 0.0, {}, 0, {}};
    checkTourIn(context, volume, walk);
    checkGlidesIn(context, volume, walk, job);
    report(context, volume);
  }
}

}  // namespace vp::safety
