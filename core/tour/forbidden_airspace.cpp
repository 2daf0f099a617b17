#include "core/tour/forbidden_airspace.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::tour {
namespace {

using mission::Airspace;
using mission::AirspaceLimit;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMostSagitta = 0.5;   // m, of a chord that stands for a turn
constexpr double kGroundMargin = 1.0;  // m around a stretch, within which ground counts
constexpr std::size_t kMostSlabs = 256;

bool isHeight(const AirspaceLimit& limit) {
  return limit.kind == AirspaceLimit::Kind::Msl || limit.kind == AirspaceLimit::Kind::FlightLevel;
}

/// Whether anything can be inside at all.
bool hasInside(const Airspace& airspace) {
  const bool isHollow = airspace.floor.kind == AirspaceLimit::Kind::Unlimited || airspace.ceiling.kind == AirspaceLimit::Kind::Surface ||
                        (isHeight(airspace.floor) && isHeight(airspace.ceiling) && airspace.ceiling.metres <= airspace.floor.metres);
  return airspace.outline.size() >= 3 && !isHollow;
}

double distanceToSide(geo::Point p, geo::Point a, geo::Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

/// Twice the signed area of a triangle.
double turnOf(geo::Point a, geo::Point b, geo::Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool areNear(geo::Point a, geo::Point b, geo::Point c, geo::Point d, double margin) {
  const bool isCrossed = (turnOf(a, b, c) > 0.0) != (turnOf(a, b, d) > 0.0) && (turnOf(c, d, a) > 0.0) != (turnOf(c, d, b) > 0.0);
  return isCrossed || distanceToSide(a, c, d) <= margin || distanceToSide(b, c, d) <= margin || distanceToSide(c, a, b) <= margin ||
         distanceToSide(d, a, b) <= margin;
}

std::string limitText(const AirspaceLimit& limit) {
  switch (limit.kind) {
    case AirspaceLimit::Kind::Surface:
      return "the surface";
    case AirspaceLimit::Kind::Msl:
      return fmt::format("{:.0f} m MSL", limit.metres);
    case AirspaceLimit::Kind::AboveGround:
      return fmt::format("{:.0f} m above ground", limit.metres);
    case AirspaceLimit::Kind::FlightLevel:
      return fmt::format("FL {:.0f}", limit.metres / kMetresPerFoot / 100.0);
    case AirspaceLimit::Kind::Unlimited:
      return "unlimited";
    case AirspaceLimit::Kind::Unknown:
      break;
  }
  return "a limit in words";
}

}  // namespace

ForbiddenAirspace::ForbiddenAirspace(const std::vector<Airspace>& airspaces, const mission::AirspaceSettings& settings,
                                     const geo::LocalFrame& frame) {
  for (const Airspace& airspace : airspaces) {
    if (mission::useOf(airspace, settings) != mission::AirspaceUse::Forbid || !hasInside(airspace)) {
      continue;
    }
    Volume volume;
    volume.airspace = airspace;
    for (const geo::LatLon& corner : airspace.outline) {
      volume.corners.push_back(frame.toPoint(corner));
      volume.box.add(volume.corners.back());
    }
    volume.box = volume.box.grown(kMargin);
    const std::size_t count = volume.corners.size();
    volume.slabs.resize(std::clamp<std::size_t>(count / 4, 1, kMostSlabs));
    for (std::size_t i = 0; i < count; ++i) {
      const auto [low, high] = std::minmax(volume.corners[i].y, volume.corners[(i + 1) % count].y);
      for (std::size_t s = volume.slabOf(low - kMargin); s <= volume.slabOf(high + kMargin); ++s) {
        volume.slabs[s].push_back(i);
      }
    }
    volumes_.push_back(std::move(volume));
  }
}

std::size_t ForbiddenAirspace::Volume::slabOf(double y) const {
  const double part = (y - box.minY) / (box.maxY - box.minY) * static_cast<double>(slabs.size());
  return part > 0.0 ? static_cast<std::size_t>(std::min(part, static_cast<double>(slabs.size() - 1))) : 0;
}

bool ForbiddenAirspace::Volume::contains(geo::Point point) const {
  if (!box.contains(point)) {
    return false;
  }
  bool isInside = false;
  for (const std::size_t i : slabs[slabOf(point.y)]) {
    const geo::Point a = corners[i];
    const geo::Point b = corners[(i + 1) % corners.size()];
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) {
      isInside = !isInside;
    }
  }
  return isInside;
}

/// Whether the line from a to b is inside or comes within `margin` of the outline.
bool ForbiddenAirspace::Volume::isNear(geo::Point a, geo::Point b, double margin) const {
  geo::Box around;
  around.add(a);
  around.add(b);
  around = around.grown(margin);
  if (around.minX > box.maxX || around.maxX < box.minX || around.minY > box.maxY || around.maxY < box.minY) {
    return false;
  }
  for (std::size_t s = slabOf(around.minY); s <= slabOf(around.maxY); ++s) {
    for (const std::size_t i : slabs[s]) {
      if (areNear(a, b, corners[i], corners[(i + 1) % corners.size()], margin)) {
        return true;
      }
    }
  }
  return contains(a);
}

bool ForbiddenAirspace::Volume::isTouchedBy(const geo::Pose& start, const flight::Piece& piece) const {
  if (piece.turn == flight::Turn::Straight) {
    return isNear(start.point(), flight::endOf(start, piece).point(), kMargin);
  }
  const double longest = std::sqrt(8.0 * piece.radius * kMostSagitta);
  const int chords = std::max(1, static_cast<int>(std::ceil(piece.length / longest)));
  geo::Point last = start.point();
  for (int i = 1; i <= chords; ++i) {
    const geo::Point next = flight::poseAfter(start, piece, piece.length * i / chords).point();
    if (isNear(last, next, kMargin)) {
      return true;
    }
    last = next;
  }
  return false;
}

HeightGate ForbiddenAirspace::Volume::gate(int number, double lowestGround, double highestGround) const {
  HeightGate gate{-kInfinite, kInfinite, number};
  if (isWall) {
    return gate;
  }
  if (isHeight(airspace.floor)) {
    gate.floor = airspace.floor.metres;
  } else if (airspace.floor.kind == AirspaceLimit::Kind::AboveGround) {
    gate.floor = lowestGround + airspace.floor.metres;
  }
  if (isHeight(airspace.ceiling)) {
    gate.ceiling = airspace.ceiling.metres;
  } else if (airspace.ceiling.kind == AirspaceLimit::Kind::AboveGround) {
    gate.ceiling = highestGround + airspace.ceiling.metres;
  }
  return gate;
}

void ForbiddenAirspace::addGates(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, double ground,
                                 std::vector<HeightGate>& gates) const {
  const geo::Box around = flight::boxOf(start, piece, 0.0, piece.length).grown(kGroundMargin);
  for (std::size_t v = 0; v < volumes_.size(); ++v) {
    const geo::Box& box = volumes_[v].box;
    const bool isApart = around.minX > box.maxX || around.maxX < box.minX || around.minY > box.maxY || around.maxY < box.minY;
    if (!isApart && volumes_[v].isTouchedBy(start, piece)) {
      gates.push_back(volumes_[v].gate(static_cast<int>(v), terrain.lowerIn(around), ground));
    }
  }
}

void ForbiddenAirspace::addGatesNear(const terrain::TerrainPyramid& terrain, geo::Point point, double radius, double ground,
                                     std::vector<HeightGate>& gates) const {
  for (std::size_t v = 0; v < volumes_.size(); ++v) {
    if (volumes_[v].isNear(point, point, radius + kMargin)) {
      geo::Box around;
      around.add(point);
      gates.push_back(volumes_[v].gate(static_cast<int>(v), terrain.lowerIn(around.grown(radius + kGroundMargin)), ground));
    }
  }
}

ForbiddenAirspace ForbiddenAirspace::walledBut(const std::vector<geo::Point>& points) const {
  ForbiddenAirspace walled = *this;
  for (Volume& volume : walled.volumes_) {
    volume.isWall = std::none_of(points.begin(), points.end(), [&](geo::Point p) { return volume.isNear(p, p, kMargin); });
  }
  return walled;
}

std::string ForbiddenAirspace::nameOf(int volume) const {
  const Airspace& airspace = volumes_[static_cast<std::size_t>(volume)].airspace;
  return fmt::format("{} (class {}, {} to {})", airspace.name.empty() ? "an airspace without a name" : airspace.name, airspace.kind,
                     limitText(airspace.floor), limitText(airspace.ceiling));
}

}  // namespace vp::tour
