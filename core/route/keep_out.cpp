#include "core/route/keep_out.h"

#include <algorithm>
#include <cmath>

namespace vp::route {
namespace {

constexpr double kNear = 2.0 * kTrackError;  // m: the chords of a track, and as much again

double distanceToSide(geo::Point p, geo::Point a, geo::Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

/// Twice the area of the triangle, positive if it runs counter-clockwise.
double turnOf(geo::Point a, geo::Point b, geo::Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isNear(geo::Point a, geo::Point b, geo::Point c, geo::Point d) {
  const bool crosses = (turnOf(a, b, c) > 0.0) != (turnOf(a, b, d) > 0.0) && (turnOf(c, d, a) > 0.0) != (turnOf(c, d, b) > 0.0);
  return crosses || std::min({distanceToSide(a, c, d), distanceToSide(b, c, d), distanceToSide(c, a, b), distanceToSide(d, a, b)}) <= kNear;
}

}  // namespace

KeepOut::KeepOut(const mission::Plan& plan, const Track& path) {
  const geo::LocalFrame frame(plan.frameOrigin);
  for (const mission::Airspace& airspace : plan.airspaces) {
    if (airspace.outline.size() < 3 || mission::useOf(airspace, plan.mission.airspace) != mission::AirspaceUse::Forbid) {
      continue;
    }
    Outline outline;
    for (const geo::LatLon& corner : airspace.outline) {
      outline.corners.push_back(frame.toPoint(corner));
      outline.box.add(outline.corners.back());
    }
    outline.box = outline.box.grown(kNear);
    if (!outline.isTouchedBy(path)) {
      outlines_.push_back(std::move(outline));
    }
  }
}

bool KeepOut::isEnteredBy(const Track& flown) const {
  return std::any_of(outlines_.begin(), outlines_.end(), [&](const Outline& outline) { return outline.isTouchedBy(flown); });
}

bool KeepOut::Outline::contains(geo::Point point) const {
  bool isInside = false;
  for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
    const geo::Point a = corners[before];
    const geo::Point b = corners[i];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      isInside = !isInside;
    }
  }
  return isInside;
}

bool KeepOut::Outline::isTouchedBy(geo::Point a, geo::Point b) const {
  if (std::max(a.x, b.x) < box.minX || std::min(a.x, b.x) > box.maxX || std::max(a.y, b.y) < box.minY || std::min(a.y, b.y) > box.maxY) {
    return false;
  }
  for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
    if (isNear(a, b, corners[before], corners[i])) {
      return true;
    }
  }
  return contains(a);
}

bool KeepOut::Outline::isTouchedBy(const Track& track) const {
  for (std::size_t i = 0; i + 1 < track.points.size(); ++i) {
    if (isTouchedBy(track.points[i], track.points[i + 1])) {
      return true;
    }
  }
  return false;
}

}  // namespace vp::route
