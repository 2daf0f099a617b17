#include "core/route/corners.h"

#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::route {
namespace {

constexpr double kLargestTurn = 2.0 * Angle::kPi / 3.0;  // rad; beyond it a fly-by corner lies far outside its turn
constexpr double kLargestShared = Angle::kPi / 2.0;      // rad, of two arcs that share the corner of a target
constexpr double kLeastTurn = 1e-7;                      // rad
constexpr double kLeastLeg = 60.0;                       // m, from an added corner to the next

/// A part of the tour that is one straight or one turn, ended by every visit.
struct Run {
  geo::Pose start;
  flight::Piece piece;
  double from = 0.0;  ///< m along the tour
  int target = -1;    ///< visited at the start
};

/// Decision points in flying order; of a closed path the first stands at the end once more.
using Points = std::vector<const mission::DecisionPoint*>;

std::vector<Run> runsOf(const Points& points) {
  std::vector<Run> runs;
  double distance = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const mission::DecisionPoint& point = *points[i];
    const bool goesOn =
        !runs.empty() && point.target < 0 && runs.back().piece.turn == point.onward.turn && runs.back().piece.radius == point.onward.radius;
    if (goesOn) {
      runs.back().piece.length += point.onward.length;
    } else {
      runs.push_back({point.pose, point.onward, distance, point.target});
    }
    distance += point.onward.length;
  }
  return runs;
}

geo::Point ahead(const geo::Pose& pose, double distance) {
  return {pose.x + distance * std::cos(pose.heading), pose.y + distance * std::sin(pose.heading)};
}

void addTurn(const Run& run, std::vector<Corner>& corners) {
  const double angle = run.piece.length / run.piece.radius;
  if (angle < kLeastTurn) {
    return;
  }
  const int parts = std::max(1, static_cast<int>(std::ceil(angle / kLargestTurn - kLeastTurn)));
  const double share = angle / parts;
  for (int i = 0; i < parts; ++i) {
    const double begin = run.piece.length * i / parts;
    const geo::Pose entry = flight::poseAfter(run.start, run.piece, begin);
    corners.push_back({ahead(entry, run.piece.radius * std::tan(share / 2.0)), run.piece.radius, share * static_cast<int>(run.piece.turn), -1,
                       run.from + begin + run.piece.length / parts / 2.0, entry});
  }
}

/// Whether two corners are parts of one arc that meet at the target between them.
bool areOneArc(const Corner& before, const Corner& target, const Corner& after) {
  constexpr double kTouch = 1e-3;  // m
  const double r = before.radius;
  return before.target < 0 && after.target < 0 && before.angle * after.angle > 0.0 && r == after.radius &&
         std::abs(geo::distance(before.point, target.point) - r * std::tan(std::abs(before.angle) / 2.0)) <= kTouch &&
         std::abs(geo::distance(after.point, target.point) - r * std::tan(std::abs(after.angle) / 2.0)) <= kTouch;
}

/// The corner of a part of an arc that begins at `start`, m along the tour.
Corner arcCorner(const Corner& whole, double start, double from, double angle) {
  const double r = whole.radius;
  const auto turn = whole.angle > 0.0 ? flight::Turn::Left : flight::Turn::Right;
  Corner corner = whole;
  corner.entry = flight::poseAfter(whole.entry, {turn, r, r * from}, r * from);
  corner.point = ahead(corner.entry, r * std::tan(angle / 2.0));
  corner.angle = std::copysign(angle, whole.angle);
  corner.tourDistance = start + r * (from + angle / 2.0);
  return corner;
}

/// Two corners, or one, instead of three where a target lies within an arc: the target's as wide to both sides of it as the arc allows, the
/// other for the rest of the arc. @return false if the target's would lie too far beside it
bool shareArc(std::vector<Corner>& corners, std::size_t i, double beside) {
  const std::size_t count = corners.size();
  const std::size_t before = (i + count - 1) % count;
  const std::size_t after = (i + 1) % count;
  if (!areOneArc(corners[before], corners[i], corners[after])) {
    return false;
  }
  const Corner arc = corners[before];
  const double start = arc.tourDistance - arc.radius * std::abs(arc.angle) / 2.0;
  const double a = std::abs(corners[before].angle);
  const double b = std::abs(corners[after].angle);
  const geo::Point target = corners[i].point;
  const auto shared = [&](double from, double angle) {
    Corner corner = arcCorner(arc, start, from, angle);
    corner.target = corners[i].target;
    return angle <= kLargestShared && geo::distance(corner.point, target) <= beside ? std::optional(corner) : std::nullopt;
  };
  std::size_t gone = a < b ? before : after;
  if (const auto one = shared(0.0, a + b)) {
    corners[i] = *one;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(std::max(before, after)));
    gone = std::min(before, after);
  } else if (const auto two = shared(a < b ? 0.0 : a - b, 2.0 * std::min(a, b)); two && std::abs(a - b) <= kLargestTurn) {
    corners[i] = *two;
    corners[a < b ? after : before] = arcCorner(arc, start, a < b ? 2.0 * a : 0.0, std::abs(a - b));
  } else {
    return false;
  }
  corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(gone));
  return true;
}

void shareCorners(std::vector<Corner>& corners, double beside) {
  std::size_t i = 0;
  while (corners.size() > 5 && i < corners.size()) {
    const bool isShared = corners[i].target >= 0 && shareArc(corners, i, beside);
    i += isShared && i > 0 ? 0 : 1;  // what was left out before it has moved it back
  }
}

double distanceToLine(geo::Point p, geo::Point a, geo::Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

/// Leaves out corners without a target, nearest to the line between their neighbours first, as long as all that were left out
/// between two neighbours stay within `lateral` of that line.
void thinOut(std::vector<Corner>& corners, double lateral, bool isClosed) {
  std::vector<std::vector<geo::Point>> gone(corners.size());  // after each corner
  while (corners.size() > (isClosed ? 4U : 2U)) {
    double least = lateral;
    std::size_t choice = corners.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t before = (i + corners.size() - 1) % corners.size();
      const std::size_t after = (i + 1) % corners.size();
      if (corners[i].target >= 0 || (!isClosed && (i == 0 || after == 0))) {
        continue;
      }
      double worst = distanceToLine(corners[i].point, corners[before].point, corners[after].point);
      for (const std::vector<geo::Point>* list : {&gone[before], &gone[i]}) {
        for (const geo::Point p : *list) {
          worst = std::max(worst, distanceToLine(p, corners[before].point, corners[after].point));
        }
      }
      if (worst < least) {
        least = worst;
        choice = i;
      }
    }
    if (choice == corners.size()) {
      return;
    }
    const std::size_t before = (choice + corners.size() - 1) % corners.size();
    gone[before].push_back(corners[choice].point);
    gone[before].insert(gone[before].end(), gone[choice].begin(), gone[choice].end());
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(choice));
    gone.erase(gone.begin() + static_cast<std::ptrdiff_t>(choice));
  }
}

/// A decision point of the tour on a straight part: where an altitude can be given by one more corner.
struct Station {
  double distance = 0.0;
  double altitude = 0.0;
  geo::Pose pose;
  bool isStraight = false;
};

std::vector<Station> stationsOf(const Points& points) {
  std::vector<Station> stations;
  double distance = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const mission::DecisionPoint& point = *points[i];
    const bool isInside = i > 0 && i + 1 < points.size();
    stations.push_back({distance, point.altitude, point.pose,
                        isInside && point.onward.turn == flight::Turn::Straight && points[i - 1]->onward.turn == flight::Turn::Straight});
    distance += point.onward.length;
  }
  return stations;
}

double altitudeAt(const std::vector<Station>& stations, double distance) {
  const double length = stations.back().distance;
  const double s = distance < 0.0 ? distance + length : distance > length ? distance - length : distance;
  const auto next = std::upper_bound(stations.begin() + 1, stations.end() - 1, s, [](double d, const Station& at) { return d < at.distance; });
  const Station& a = *(next - 1);
  const Station& b = *next;
  return b.distance > a.distance ? a.altitude + (s - a.distance) / (b.distance - a.distance) * (b.altitude - a.altitude) : a.altitude;
}

/// The station between two corners at which a straight line of altitude is worst, if it is worse than `vertical`.
const Station* worstStation(const std::vector<Station>& stations, const Corner& from, const Corner& to, double vertical) {
  const double end = to.tourDistance <= from.tourDistance ? to.tourDistance + stations.back().distance : to.tourDistance;
  const double a = altitudeAt(stations, from.tourDistance);
  const double b = altitudeAt(stations, to.tourDistance);
  const Station* worst = nullptr;
  for (const Station& at : stations) {
    if (!at.isStraight || at.distance <= from.tourDistance || at.distance >= end || geo::distance(at.pose.point(), from.point) < kLeastLeg ||
        geo::distance(at.pose.point(), to.point) < kLeastLeg) {
      continue;
    }
    const double t = (at.distance - from.tourDistance) / (end - from.tourDistance);
    const double off = std::abs(at.altitude - (a + t * (b - a)));
    if (off > vertical) {
      vertical = off;
      worst = &at;
    }
  }
  return worst;
}

void addForAltitude(const Points& points, std::vector<Corner>& corners, double vertical, bool isClosed) {
  const std::vector<Station> stations = stationsOf(points);
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < corners.size(); ++i) {
    while (const Station* at = worstStation(stations, corners[i], corners[(i + 1) % corners.size()], vertical)) {
      corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     Corner{at->pose.point(), corners[i].radius, 0.0, -1, at->distance, at->pose});
    }
  }
}

std::vector<Corner> cornersOf(const std::vector<Run>& runs) {
  std::vector<Corner> corners;
  double radius = 0.0;
  for (const Run& run : runs) {
    if (run.target >= 0 || corners.empty()) {
      corners.push_back({run.start.point(), 0.0, 0.0, run.target, run.from, run.start});
    }
    if (run.piece.turn != flight::Turn::Straight) {
      radius = std::max(radius, run.piece.radius);
      addTurn(run, corners);
    }
  }
  for (Corner& corner : corners) {
    corner.radius = corner.radius > 0.0 ? corner.radius : radius;
  }
  return corners;
}

}  // namespace

std::size_t firstVisit(const mission::Plan& plan) {
  const auto visit = std::find_if(plan.tour.begin(), plan.tour.end(), [](const mission::DecisionPoint& point) { return point.target >= 0; });
  return visit == plan.tour.end() ? 0 : static_cast<std::size_t>(visit - plan.tour.begin());
}

std::vector<Corner> tangentCorners(const mission::Plan& plan, const CornerLimits& limits) {
  VP_EXPECT(!plan.tour.empty());
  const std::size_t first = firstVisit(plan);
  Points points;
  for (std::size_t i = 0; i <= plan.tour.size(); ++i) {
    points.push_back(&plan.tour[(first + i) % plan.tour.size()]);
  }
  std::vector<Corner> corners = cornersOf(runsOf(points));
  shareCorners(corners, limits.beside);
  thinOut(corners, limits.lateral, true);
  addForAltitude(points, corners, limits.vertical, true);
  return corners;
}

std::vector<Corner> openCorners(const std::vector<mission::DecisionPoint>& way, const CornerLimits& limits) {
  VP_EXPECT(way.size() >= 2);
  Points points;
  for (const mission::DecisionPoint& point : way) {
    points.push_back(&point);
  }
  const std::vector<Run> runs = runsOf(points);
  std::vector<Corner> corners = cornersOf(runs);
  const Run& last = runs.back();
  const geo::Pose end = flight::endOf(last.start, last.piece);
  corners.push_back({end.point(), corners.back().radius, 0.0, way.back().target, last.from + last.piece.length, end});
  thinOut(corners, limits.lateral, false);
  addForAltitude(points, corners, limits.vertical, false);
  return corners;
}

}  // namespace vp::route
