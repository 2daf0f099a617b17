#pragma once

#include "core/landing/roadmap.h"
#include "core/landing/spatial_index.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vp::landing {

/** A pose from which a safe glide to a site is known. */
struct RoadmapNode {
  geo::Pose pose;
  double altitude = 0.0;  ///< A(node), m MSL: lowest height from which the known glide arrives
  int parent = -1;        ///< next node of the glide; -1 for a landing site
  int site = -1;          ///< index into World::sites that the glide ends at
  flight::DubinsPath toParent;
};

/** A glide from one pose to another: the curve and the height needed at its start. */
struct GlideLeg {
  flight::DubinsPath path;
  double altitude = 0.0;  ///< needed at the start, m MSL
};

/** A roadmap grown pose by pose: a forest rooted at the landing sites, edges are Dubins glides towards the root.
 *  Built by buildRrtStarRoadmap (rrt_star.h); answers safe-altitude queries ([1] Algorithm 2).
 *  @threads const members are pure; each thread brings its own QueryScratch */
class TreeRoadmap final : public Roadmap {
public:
  TreeRoadmap() = default;
  /** Starts where the approaches to the landing sites begin. @param cell  bucket size of the index [m] */
  TreeRoadmap(const World& world, double bucket) : TreeRoadmap(world, approachesOf(world), bucket) {}
  TreeRoadmap(const World& world, const std::vector<Approach>& approaches, double bucket);

  [[nodiscard]] const std::vector<RoadmapNode>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<int>& roots() const { return roots_; }

  /** Candidates are the sites and all nodes within reach(). Best first by ever sharper lower bounds: by distance and
   *  heading change, then by the Dubins glides without ground, last the ground; so few glides meet the terrain.
   *  Then the ancestors of the best are tried.
   *  @source [1] Algorithm 2; ancestors as in Jeong, Lee, Kim 2019, Expert Systems with Applications 123, Quick-RRT* */
  [[nodiscard]] std::optional<SafeAltitude> queryTurning(const World& world, const geo::Pose& from, QueryScratch& scratch,
                                                         int hint = -1) const override;

  [[nodiscard]] std::size_t size() const override { return nodes_.size(); }
  void draw(std::size_t most, const DrawGlide& draw) const override;

  /** Distance within which nodes are candidates [m]. */
  [[nodiscard]] double reach() const { return reach_; }
  void setReach(double metres) { reach_ = metres; }

  /** Adds a node whose glide starts with `leg` to `parent`. */
  int add(const geo::Pose& pose, int parent, const GlideLeg& leg);

  /** Gives a node a new parent and passes the lower altitude on to all nodes that glide through it. */
  void reconnect(const World& world, int node, int parent, const GlideLeg& leg);

  /** Best glide from a pose to a node, over all radii of the profile, if it needs less than `below`. `options` is working memory. */
  [[nodiscard]] std::optional<GlideLeg> legTo(const World& world, const geo::Pose& from, int node, double below,
                                              std::vector<GlideOption>& options) const;

  /** Admissible lower bound of the altitude of any leg from a pose to a node [m MSL]. */
  [[nodiscard]] double boundTo(const geo::Pose& from, int node) const;

  /** Nodes within `radius` of a point, appended to `found`. */
  void nodesNear(geo::Point p, double radius, std::vector<int>& found) const { index_.within(p, radius, found); }
  /** Node nearest to a point by plain distance. */
  [[nodiscard]] int nearest(geo::Point p) const { return index_.nearest(p); }

protected:
  void appendGlide(const SafeAltitude& answer, std::vector<flight::Piece>& pieces) const override;

private:
  void optionsTo(const geo::Pose& from, int node, double below, std::vector<GlideOption>& options) const;
  struct RadiusLoss {
    double radius = 0.0;
    flight::TurnLoss loss;
  };
  [[nodiscard]] std::size_t indexOf(double radius) const;
  void improveByAncestors(const World& world, const geo::Pose& from, SafeAltitude& best, std::vector<GlideOption>& options) const;

  std::vector<RoadmapNode> nodes_;
  std::vector<std::vector<int>> children_;
  std::vector<int> roots_;
  SpatialIndex index_;
  double reach_ = 0.0;
  aircraft::GlideModel glide_;
  double leastLossPerRadian_ = 0.0;
  std::vector<RadiusLoss> losses_;
};

}  // namespace vp::landing
