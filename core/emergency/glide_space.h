#pragma once

#include "core/emergency/fmt_star.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_request.h"
#include "core/emergency/linear_octree.h"
#include "core/emergency/sample_buckets.h"

#include <cstddef>
#include <vector>

namespace vp::emergency {

/** Points over the ground that an aircraft may glide over, for FMT*. What a node costs is height: what is lost up to it, and at a gate how much
 * higher its approach begins than the lowest in range; so altitude is no coordinate of its own, and whoever is cheaper is higher.
 *
 *  A leg is straight; it loses what the glide loses on its course at the altitude where it begins, and what the turn into it costs at
 *  least. It is possible only if what is left may still reach a gate.
 *  Node 0 is the aircraft, nodes 1 to G are the gates of goals.inRange(), the others samples. */
class GlideSpace final : public FmtSpace {
public:
  /** @param points  samples   @param octree   legs between samples are free if they lie in it; null: legs are tested by steps of half a cell of
   *  the terrain   @param wanted  m: only what may leave more height in hand counts. All outlive this */
  GlideSpace(const LandingRequest& request, const LandingGoals& goals, const std::vector<geo::Point>& points, double radius,
             const LinearOctree* octree, double wanted);

  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  void near(int node, std::vector<int>& found) const override { buckets_.near(node, found); }
  [[nodiscard]] double arrival(int parent, int from, double cost, int to) const override;
  [[nodiscard]] bool isFree(int from, double cost, int to, double arrival) const override;
  [[nodiscard]] bool isGoal(int node) const override { return node > 0 && node <= gates_; }

  /** Of a goal node: its number in goals.inRange(). */
  [[nodiscard]] static std::size_t goalOf(int node) { return static_cast<std::size_t>(node) - 1; }
  [[nodiscard]] geo::Point at(int node) const {
    const Point3& p = points_[static_cast<std::size_t>(node)];
    return {p.x, p.y};
  }

private:
  [[nodiscard]] double gateExtra(int node) const;
  [[nodiscard]] bool isFreeBySteps(geo::Point from, double altitude, geo::Point to, double end) const;

  const LandingRequest& request_;
  const landing::World& world_;
  const LandingGoals& goals_;
  std::vector<Point3> points_;
  SampleBuckets buckets_;
  const LinearOctree* octree_;
  int gates_;
  double turn_;                ///< m lost at least for a radian of turning
  std::vector<double> least_;  ///< m MSL by node: from lower no gate is reached with what is wanted
};

}  // namespace vp::emergency
