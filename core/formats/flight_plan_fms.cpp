// X-Plane FMS 1100. Choices: DEP/DES (not ADEP/ADES), as a tour starts at a target and no airport is part of it; every
// row is type 28 (latitude/longitude), which needs no navigation data, so any four-digit CYCLE serves.
#include "core/formats/flight_plan_fms.h"

#include "core/formats/tour_path.h"
#include "core/geo/local_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::formats {
namespace {

constexpr double kOffTrack = 10.0;  // m, straight legs from the tour
constexpr double kArcError = 1.0;   // m of those, spent on the points that stand for an arc
constexpr double kBelow = 1.0;      // m that a leg may pass below the tour before the waypoints are raised by it
constexpr double kAbove = 15.0;     // m that a leg may pass above the tour
constexpr double kRounding = 0.1;   // m: 6 decimals are 0.1 m of track, and a tour is never as steep as 45 degrees
constexpr std::size_t kIdentLength = 10;
constexpr const char* kCycle = "1710";  // that of the format's own example

/// How a point of the path lies to a straight leg.
struct Offset {
  double side = 0.0;   ///< m from the leg
  double above = 0.0;  ///< m of the path above the leg
};

Offset offsetFrom(const PathPoint& a, const PathPoint& b, const PathPoint& p) {
  const double dx = b.point.x - a.point.x;
  const double dy = b.point.y - a.point.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.point.x - a.point.x) * dx + (p.point.y - a.point.y) * dy) / square, 0.0, 1.0) : 0.0;
  const double altitude = a.altitude + t * (b.altitude - a.altitude);
  return {std::hypot(a.point.x + t * dx - p.point.x, a.point.y + t * dy - p.point.y), p.altitude - altitude};
}

/// Keeps path points, worst first, until every leg between kept ones is near enough to the path (Douglas-Peucker with
/// separate limits to the side, below and above).
void keepBetween(const std::vector<PathPoint>& path, std::size_t first, std::size_t last, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double worst = 1.0;
    std::size_t split = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const Offset offset = offsetFrom(path[from], path[to], path[i]);
      const double excess = std::max({offset.side / (kOffTrack - kArcError), offset.above / kBelow, -offset.above / kAbove});
      if (excess > worst) {
        worst = excess;
        split = i;
      }
    }
    if (split != from) {
      kept[split] = true;
      open.emplace_back(from, split);
      open.emplace_back(split, to);
    }
  }
}

/// Waypoints of the tour as places in the path. Targets are always among them.
std::vector<std::size_t> chooseWaypoints(const std::vector<PathPoint>& path) {
  std::vector<bool> kept(path.size(), false);
  kept.front() = kept.back() = true;
  std::size_t previous = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].target >= 0 || i + 1 == path.size()) {
      kept[i] = true;
      keepBetween(path, previous, i, kept);
      previous = i;
    }
  }
  std::vector<std::size_t> waypoints;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (kept[i]) {
      waypoints.push_back(i);
    }
  }
  return waypoints;
}

/// Altitudes in whole feet: raised where a leg would pass below the path, then rounded up.
std::vector<double> waypointFeet(const std::vector<PathPoint>& path, const std::vector<std::size_t>& waypoints) {
  std::vector<double> raise(waypoints.size(), 0.0);
  for (std::size_t leg = 0; leg + 1 < waypoints.size(); ++leg) {
    double deficit = 0.0;
    for (std::size_t i = waypoints[leg] + 1; i < waypoints[leg + 1]; ++i) {
      deficit = std::max(deficit, offsetFrom(path[waypoints[leg]], path[waypoints[leg + 1]], path[i]).above);
    }
    raise[leg] = std::max(raise[leg], deficit);
    raise[leg + 1] = std::max(raise[leg + 1], deficit);
  }
  raise.front() = raise.back() = std::max(raise.front(), raise.back());  // one place, flown over twice
  std::vector<double> feet;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    feet.push_back(std::ceil((path[waypoints[i]].altitude + raise[i] + kRounding) / kMetresPerFoot));
  }
  return feet;
}

/// Up to ten characters A-Z, 0-9 and _ that no other waypoint has.
std::string uniqueIdent(const std::string& name, std::set<std::string>& used) {
  std::string ident;
  for (const char c : name) {
    const bool lower = c >= 'a' && c <= 'z';
    const bool plain = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    ident += lower ? static_cast<char>(c - 'a' + 'A') : plain ? c : '_';
  }
  ident.resize(std::min(ident.size(), kIdentLength));
  for (int number = 2; !used.insert(ident).second; ++number) {
    const std::string ending = std::to_string(number);
    ident.resize(std::min(ident.size(), kIdentLength - ending.size() - 1));
    ident.append("_").append(ending);
    if (used.count(ident) > 0) {
      ident.resize(ident.size() - ending.size() - 1);
    }
  }
  return ident;
}

/// Where the export begins: the first visit of a target.
std::size_t firstVisit(const mission::Plan& plan) {
  const auto visit = std::find_if(plan.tour.begin(), plan.tour.end(), [](const mission::DecisionPoint& point) { return point.target >= 0; });
  return visit == plan.tour.end() ? 0 : static_cast<std::size_t>(visit - plan.tour.begin());
}

std::vector<std::string> waypointIdents(const mission::Plan& plan, const std::vector<PathPoint>& path, const std::vector<std::size_t>& waypoints) {
  std::set<std::string> used;
  std::vector<std::string> idents(waypoints.size());
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const int target = path[waypoints[i]].target;
    if (target >= 0) {
      const std::string& name = plan.targets.at(static_cast<std::size_t>(target)).target.name;
      idents[i] = uniqueIdent(name.empty() ? fmt::format("T{}", target + 1) : name, used);
    }
  }
  int number = 0;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    if (idents[i].empty()) {
      idents[i] = uniqueIdent(fmt::format("V{:03}", ++number), used);
    }
  }
  idents.back() = idents.front();
  return idents;
}

}  // namespace

Result<std::string> toFms1100(const mission::Plan& plan) {
  if (plan.tour.empty()) {
    return fail(Errc::OutOfRange, "the plan has no tour to export; plan a mission with at least one target");
  }
  const std::vector<PathPoint> path = tourPath(plan, firstVisit(plan), kArcError);
  const std::vector<std::size_t> waypoints = chooseWaypoints(path);
  const std::vector<double> feet = waypointFeet(path, waypoints);
  const std::vector<std::string> idents = waypointIdents(plan, path, waypoints);
  const geo::LocalFrame frame(plan.frameOrigin);
  std::string text = fmt::format("I\n1100 Version\nCYCLE {}\nDEP {}\nDES {}\nNUMENR {}\n", kCycle, idents.front(), idents.back(), waypoints.size());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const geo::LatLon place = frame.toLatLon(path[waypoints[i]].point);
    const char* via = i == 0 ? "DEP" : i + 1 == waypoints.size() ? "DES" : "DRCT";
    text += fmt::format("28 {} {} {:.6f} {:.6f} {:.6f}\n", idents[i], via, feet[i], place.latitude_deg, place.longitude_deg);
  }
  return text;
}

}  // namespace vp::formats
