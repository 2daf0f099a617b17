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

/// How wide the second sampling is, in radii of connection of the first: where the first tree could have had another sample.
constexpr double kTube = 0.5;

double apart(const Point3& a, const Point3& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double dz = b.z - a.z;
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

Point3 between(const Point3& a, const Point3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
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

/// Samples near a route, and the route's own points so close together that its legs may be found again.
std::vector<Point3> samplesNear(const BoxRoute& route, double tube, double spacing, std::size_t count, const Cuboid& box, Random& random) {
  std::vector<Point3> points{route.points.front(), route.points.back()};
  for (std::size_t leg = 1; leg < route.points.size(); ++leg) {
    const Point3& a = route.points[leg - 1];
    const Point3& b = route.points[leg];
    const auto parts = static_cast<int>(std::ceil(apart(a, b) / spacing));
    for (int i = leg == 1 ? 1 : 0; i < parts; ++i) {
      points.push_back(between(a, b, static_cast<double>(i) / parts));
    }
  }
  while (count > 0) {
    double along = random.unit() * route.length;
    std::size_t leg = 1;
    while (leg + 1 < route.points.size() && along > apart(route.points[leg - 1], route.points[leg])) {
      along -= apart(route.points[leg - 1], route.points[leg]);
      ++leg;
    }
    const double length = apart(route.points[leg - 1], route.points[leg]);
    const Point3 on = between(route.points[leg - 1], route.points[leg], length > 0.0 ? std::min(1.0, along / length) : 0.0);
    const Point3 sample = random.near(on, tube);
    if (contains(box, sample)) {
      points.push_back(sample);
      --count;
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
  std::vector<Point3> points{start, end};
  for (std::size_t i = 0; i < options.first; ++i) {
    points.push_back(random.in(box));
  }
  const double volume = (box.high.x - box.low.x) * (box.high.y - box.low.y) * (box.high.z - box.low.z);
  const double radius = fmtRadius(3, volume, options.first);
  std::optional<BoxRoute> best = search(std::move(points), radius, isFree);
  double tube = kTube * radius;
  for (int i = 0; best && i < options.further; ++i, tube *= 0.5) {
    // a tube with round ends
    const double measure = Angle::kPi * tube * tube * (best->length + 4.0 / 3.0 * tube);
    const double nearRadius = fmtRadius(3, measure, options.second);
    std::optional<BoxRoute> better = search(samplesNear(*best, tube, 0.5 * nearRadius, options.second, box, random), nearRadius, isFree);
    if (!better) {
      continue;  // the way through its own points is free, but FMT* tests one way to each node only
    }
    better->visited += best->visited;
    better->tested += best->tested;
    if (better->length < best->length) {
      best = std::move(better);
    } else {
      best->visited = better->visited;
      best->tested = better->tested;
    }
  }
  return best;
}

}  // namespace vp::emergency
