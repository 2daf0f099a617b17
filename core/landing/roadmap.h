#pragma once

#include "core/flight/dubins.h"
#include "core/landing/spatial_index.h"
#include "core/landing/world.h"

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

/** The answer to a safe-altitude query: how low, and the glide that proves it. */
struct SafeAltitude {
  double altitude = 0.0;  ///< A(q), m MSL
  int node = -1;          ///< roadmap node that the first leg leads to
  flight::DubinsPath first;
};

/** Roadmap of landing glides: a forest rooted at the landing sites, edges are Dubins glides towards the root.
 *  Built by buildRrtStarRoadmap (rrt_star.h); answers safe-altitude queries ([1] Algorithm 2).
 *  @threads const members are pure; each thread brings its own QueryScratch */
class Roadmap {
public:
  /// A glide over one radius, and the altitude it would need if there were no ground: a lower bound.
  struct Option {
    flight::DubinsPath path;
    double altitude = 0.0;
    std::size_t radius = 0;  ///< index into the profile's radii
    int node = -1;
  };

  /// Working memory of a query, kept by the caller so that queries allocate nothing.
  struct QueryScratch {
    struct Candidate {
      double bound = 0.0;
      int node = -1;
      int option = -1;  ///< index into options; -1 while only the distance is known
      bool operator>(const Candidate& o) const { return bound != o.bound ? bound > o.bound : node != o.node ? node > o.node : option > o.option; }
    };
    std::vector<Candidate> candidates;
    std::vector<Option> options;
    std::vector<int> near;
    std::int64_t queries = 0;
  };

  Roadmap() = default;
  /** Starts with the landing sites; sites over unknown ground get no node. @param cell  bucket size of the index [m] */
  Roadmap(const World& world, double bucket);

  [[nodiscard]] const std::vector<RoadmapNode>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<int>& roots() const { return roots_; }

  /** Lowest height from which some glide over the roadmap arrives, and that glide.
   *  Candidates are the sites and all nodes within reach(). Best first by ever sharper lower bounds: by distance and
   *  heading change, then by the Dubins glides without ground, last the ground; so few glides meet the terrain.
   *  Then the ancestors of the best are tried.
   *  @param hint  a node to try first (the answer of a neighbouring query), or -1
   *  @return nothing if no glide exists
   *  @source [1] Algorithm 2, with the corrected height condition of DESIGN section 2; ancestors as in Jeong, Lee,
   *  Kim 2019, Expert Systems with Applications 123, Quick-RRT* */
  [[nodiscard]] std::optional<SafeAltitude> query(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint = -1) const;

  /** The glide of an answer as pieces from the queried pose to the site. */
  [[nodiscard]] std::vector<flight::Piece> witnessPieces(const SafeAltitude& answer) const;

  /** Distance within which nodes are candidates [m]. */
  [[nodiscard]] double reach() const { return reach_; }
  void setReach(double metres) { reach_ = metres; }

  /** Adds a node whose glide starts with `leg` to `parent`. */
  int add(const geo::Pose& pose, int parent, const GlideLeg& leg);

  /** Gives a node a new parent and passes the lower altitude on to all nodes that glide through it. */
  void reconnect(const World& world, int node, int parent, const GlideLeg& leg);

  /** Best glide from a pose to a node, over all radii of the profile, if it needs less than `below`. `options` is working memory. */
  [[nodiscard]] std::optional<GlideLeg> legTo(const World& world, const geo::Pose& from, int node, double below, std::vector<Option>& options) const;

  /** Admissible lower bound of the altitude of any leg from a pose to a node [m MSL]. */
  [[nodiscard]] double boundTo(const geo::Pose& from, int node) const;

  /** Nodes within `radius` of a point, appended to `found`. */
  void nodesNear(geo::Point p, double radius, std::vector<int>& found) const { index_.within(p, radius, found); }
  /** Node nearest to a point by plain distance. */
  [[nodiscard]] int nearest(geo::Point p) const { return index_.nearest(p); }

private:
  void optionsTo(const geo::Pose& from, int node, double below, std::vector<Option>& options) const;
  struct RadiusLoss {
    double radius = 0.0;
    flight::TurnLoss loss;
  };
  [[nodiscard]] flight::TurnLoss lossesAt(double radius) const;
  void improveByAncestors(const World& world, const geo::Pose& from, SafeAltitude& best, std::vector<Option>& options) const;

  std::vector<RoadmapNode> nodes_;
  std::vector<std::vector<int>> children_;
  std::vector<int> roots_;
  SpatialIndex index_;
  double reach_ = 0.0;
  double straightLoss_ = 0.0;
  double leastLossPerRadian_ = 0.0;
  std::vector<RadiusLoss> losses_;
};

}  // namespace vp::landing
