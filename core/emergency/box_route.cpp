#include "core/emergency/box_route.h"

#include "core/base/quantity.h"
#include "core/emergency/fmt_star.h"
#include "core/emergency/sample_buckets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace vp::emergency {
namespace {

/// How far from a turning point the second sampling reaches, in fmtRadius() of the first: where that one could have had another sample.
constexpr double kReach = 0.5;
/// And each further one, of the one before.
constexpr double kNarrower = 0.5;

double apart(const Point3& a, const Point3& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double dz = b.z - a.z;
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

class BoxSpace final : public FmtSpace {
public:
  /** @param points  the start first, the end second */
  BoxSpace(std::vector<Point3> points, double radius, const FreeLeg& isFree)
      : points_(std::move(points)), buckets_(points_, radius), isFree_(isFree) {}

  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  void near(int node, std::vector<int>& found) const override { buckets_.near(node, found); }
  [[nodiscard]] double arrival(int /*parent*/, int from, double cost, int to) const override { return cost + apart(at(from), at(to)); }
  [[nodiscard]] bool isFree(int from, double /*cost*/, int to, double /*arrival*/) const override { return isFree_(at(from), at(to)); }
  [[nodiscard]] bool isGoal(int node) const override { return node == 1; }
  [[nodiscard]] const Point3& at(int node) const { return points_[static_cast<std::size_t>(node)]; }

private:
  std::vector<Point3> points_;
  SampleBuckets buckets_;
  const FreeLeg& isFree_;
};

class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  Point3 in(const Cuboid& box) {
    const double x = unit();
    const double y = unit();
    return {box.low.x + x * (box.high.x - box.low.x), box.low.y + y * (box.high.y - box.low.y), box.low.z + unit() * (box.high.z - box.low.z)};
  }
  /// Within a ball.
  Point3 near(const Point3& centre, double reach) {
    while (true) {
      const Point3 off{2.0 * unit() - 1.0, 2.0 * unit() - 1.0, 2.0 * unit() - 1.0};
      if (off.x * off.x + off.y * off.y + off.z * off.z <= 1.0) {
        return {centre.x + reach * off.x, centre.y + reach * off.y, centre.z + reach * off.z};
      }
    }
  }

private:
  std::mt19937_64 engine_;
};

bool contains(const Cuboid& box, const Point3& p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z && p.z <= box.high.z;
}

/// The same way without the points that it can do without: from each the farthest that a free leg leads to.
void shorten(BoxRoute& route, const FreeLeg& isFree) {
  std::vector<Point3> kept{route.points.front()};
  for (std::size_t at = 0; at + 1 < route.points.size();) {
    std::size_t next = route.points.size() - 1;
    while (next > at + 1) {
      ++route.tested;
      if (isFree(route.points[at], route.points[next])) {
        break;
      }
      --next;
    }
    kept.push_back(route.points[next]);
    at = next;
  }
  route.points = std::move(kept);
  route.length = 0.0;
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    route.length += apart(route.points[i - 1], route.points[i]);
  }
}

/// Samples near the turning points of a route, and these.
std::vector<Point3> samplesNear(const BoxRoute& route, double reach, std::size_t count, const Cuboid& box, Random& random) {
  std::vector<Point3> points{route.points.front(), route.points.back()};
  points.insert(points.end(), route.points.begin() + 1, route.points.end() - 1);
  const std::size_t corners = route.points.size() - 2;
  for (std::size_t i = 0; corners > 0 && i < count; ++i) {
    const Point3 sample = random.near(route.points[1 + i % corners], reach);
    if (contains(box, sample)) {
      points.push_back(sample);
    }
  }
  return points;
}

std::optional<BoxRoute> search(std::vector<Point3> points, double radius, const FreeLeg& isFree) {
  const BoxSpace space(std::move(points), radius, isFree);
  FmtStar tree(space);
  const int end = tree.next(std::numeric_limits<double>::infinity());
  if (end < 0) {
    return std::nullopt;
  }
  BoxRoute route;
  for (const int node : tree.wayTo(end)) {
    route.points.push_back(space.at(node));
  }
  route.length = tree.costOf(end);
  route.visited = tree.counts().visited;
  route.tested = tree.counts().tested;
  return route;
}

}  // namespace

std::optional<BoxRoute> boxRoute(const Cuboid& box, const Point3& start, const Point3& end, const FreeLeg& isFree, const BoxRouteOptions& options) {
  Random random(options.seed);
  const double volume = (box.high.x - box.low.x) * (box.high.y - box.low.y) * (box.high.z - box.low.z);
  const double radius = fmtRadius(3, volume, options.first);
  std::optional<BoxRoute> best;
  std::int64_t visited = 0;
  std::int64_t tested = 0;
  for (int tree = 0; tree < options.trees; ++tree) {
    std::optional<BoxRoute> route;
    double reach = kReach * radius;
    for (int sampling = 0; sampling <= options.further; ++sampling) {
      std::vector<Point3> points{start, end};
      if (sampling == 0) {
        for (std::size_t i = 0; i < options.first; ++i) {
          points.push_back(random.in(box));
        }
      } else {
        points = samplesNear(*route, reach, options.second, box, random);
        reach *= kNarrower;
      }
      // near turning points alone, every sample is near every other
      const double near = sampling == 0 ? options.connect * radius : apart(box.low, box.high);
      std::optional<BoxRoute> found = search(std::move(points), near, isFree);
      if (found && options.shortens) {
        shorten(*found, isFree);
      }
      visited += found ? found->visited : 0;
      tested += found ? found->tested : 0;
      if (found && (!route || found->length < route->length)) {
        route = std::move(found);
      }
      // none, or straight on: nothing to be refined
      if (!route || route->points.size() <= 2) {
        break;
      }
    }
    if (route && (!best || route->length < best->length)) {
      best = std::move(route);
    }
  }
  if (best) {
    best->visited = visited;
    best->tested = tested;
  }
  return best;
}

}  // namespace vp::emergency
