#include "core/landing/rrt_star.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace vp::landing {
namespace {

/// Mean number of neighbours looked at. On the mountain of tests/support 40 lower the mean safe altitude by 1 m of 525 m
/// against 20 and take three times as long; 10 raise it by 1 m (measured over 5,000 queries).
constexpr double kNeighbours = 20.0;
constexpr double kPaperArea = 25e6;       // m^2, [1] section 8
constexpr double kPaperSamples = 7500.0;  // [1] Table 3
/// On the alpine map (60 x 60 km, ten targets) 5,000, 20,000 and 90,000 samples give costs within 0.02 % of each other,
/// because sites and ancestors are tried directly; 20,000 leave room for country with more walls.
constexpr double kMostSamples = 20000.0;

double areaOf(const geo::Box& box) {
  return (box.maxX - box.minX) * (box.maxY - box.minY);
}

/// Radius that holds kNeighbours of n nodes spread evenly over the area, not less than two turn radii.
double neighbourRadius(double area, std::size_t nodes, double turnRadius) {
  const double n = static_cast<double>(std::max<std::size_t>(nodes, 1));
  return std::max(2.0 * turnRadius, std::sqrt(kNeighbours * area / (Angle::kPi * n)));
}

/// Uniform in [0, 1) with the same bits on every platform, which std::uniform_real_distribution does not promise.
double unit(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1.0p-53;
}

/** Growth of one roadmap; a class to keep the loop readable. */
class Growth {
public:
  Growth(const World& world, const RrtStarOptions& options)
      : world_(world),
        options_(options),
        area_(areaOf(options.area)),
        engine_(options.seed),
        finalRadius_(neighbourRadius(area_, static_cast<std::size_t>(options.samples), world.glide.minRadius())),
        roadmap_(world, finalRadius_),
        steer_(8.0 * finalRadius_ + 4.0 * world.glide.minRadius()) {}

  [[nodiscard]] bool hasRoots() const { return !roadmap_.roots().empty(); }

  /// One expansion; false if the sample has no safe glide.
  bool expand() {
    const geo::Pose random{options_.area.minX + unit(engine_) * (options_.area.maxX - options_.area.minX),
                           options_.area.minY + unit(engine_) * (options_.area.maxY - options_.area.minY), 2.0 * Angle::kPi * unit(engine_)};
    const geo::Pose pose = steer(random);
    if (!world_.terrain.grid().isKnownAt(pose.point())) {
      return false;
    }
    const double radius = neighbourRadius(area_, roadmap_.nodes().size(), world_.glide.minRadius());
    roadmap_.setReach(radius);
    const std::optional<SafeAltitude> parent = roadmap_.queryTurning(world_, pose, scratch_);
    if (!parent) {
      return false;
    }
    near_.clear();
    roadmap_.nodesNear(pose.point(), radius, near_);
    const int added = roadmap_.add(pose, parent->node, {parent->first, parent->altitude});
    rewire(added);
    return true;
  }

  [[nodiscard]] const TreeRoadmap& roadmap() const { return roadmap_; }

  TreeRoadmap finish() {
    roadmap_.setReach(finalRadius_);
    return std::move(roadmap_);
  }

private:
  /// The part of the glide from the sample to the nearest node that is no longer than the steer constant.
  geo::Pose steer(const geo::Pose& random) const {
    const int nearest = roadmap_.nearest(random.point());
    const geo::Pose& goal = roadmap_.nodes()[static_cast<std::size_t>(nearest)].pose;
    if (geo::distance(random.point(), goal.point()) <= 0.5 * steer_) {
      return random;
    }
    const flight::DubinsPath path = flight::shortestDubins(random, goal, world_.glide.minRadius());
    const double length = path.length();
    return length <= steer_ ? random : flight::poseAlong(flight::toCurve(path), length - steer_, world_.glide.airspeed());
  }

  void rewire(int added) {
    const RoadmapNode from = roadmap_.nodes()[static_cast<std::size_t>(added)];
    for (const int node : near_) {
      const RoadmapNode& neighbour = roadmap_.nodes()[static_cast<std::size_t>(node)];
      if (neighbour.parent < 0 || node == from.parent || roadmap_.boundTo(neighbour.pose, added) >= neighbour.altitude) {
        continue;
      }
      if (const std::optional<GlideLeg> leg = roadmap_.legTo(world_, neighbour.pose, added, neighbour.altitude, scratch_.options)) {
        roadmap_.reconnect(world_, node, added, *leg);
      }
    }
  }

  const World& world_;
  const RrtStarOptions& options_;
  double area_;
  std::mt19937_64 engine_;
  double finalRadius_;
  TreeRoadmap roadmap_;
  double steer_;
  QueryScratch scratch_;
  std::vector<int> near_;
};

}  // namespace

Result<TreeRoadmap> buildRrtStarRoadmap(const World& world, const RrtStarOptions& options, const Job& job, RrtStarStatistics* statistics) {
  if (options.area.isEmpty() || options.samples < 0) {
    return fail(Errc::OutOfRange, "the area for the roadmap of landing glides is empty");
  }
  Growth growth(world, options);
  if (!growth.hasRoots()) {
    return tl::unexpected(noApproach(world));
  }
  const auto start = std::chrono::steady_clock::now();
  RrtStarStatistics counts;
  const std::int64_t mostRejected = 20LL * options.samples + 1000;
  while (counts.expansions < options.samples && counts.rejected < mostRejected) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while building the roadmap of landing glides");
    }
    if (growth.expand()) {
      ++counts.expansions;
      if (counts.expansions % 500 == 0) {
        job.progress(static_cast<double>(counts.expansions) / options.samples,
                     fmt::format("roadmap: {} of {} glides", counts.expansions, options.samples));
        if (options.grew) {
          options.grew(growth.roadmap());
        }
      }
    } else {
      ++counts.rejected;
    }
    if (options.seconds && std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > *options.seconds) {
      break;
    }
  }
  if (statistics != nullptr) {
    *statistics = counts;
  }
  return growth.finish();
}

int defaultSamples(const geo::Box& area) {
  return static_cast<int>(std::clamp(kPaperSamples * std::sqrt(areaOf(area) / kPaperArea), kPaperSamples, kMostSamples));
}

}  // namespace vp::landing
