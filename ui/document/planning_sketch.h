#pragma once

#include "core/geo/pose.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::document {

/** What the planner is doing right now, for drawing: the roadmap as it grows ([1] Fig. 4), the tour of the last lazy round.
 *  Lower bounds are drawn dashed, safe segments solid. A snapshot: immutable once published. */
struct PlanningSketch {
  struct Edge {
    geo::Point from;
    geo::Point to;
    float altitude = 0.0F;  ///< m MSL needed at `from`
  };
  struct Leg {
    std::vector<geo::Point> path;
    bool safe = false;  ///< false: a terrain segment, still only a lower bound
  };
  std::shared_ptr<const std::vector<Edge>> roadmap;  ///< glides towards the runways; may be null
  std::shared_ptr<const std::vector<Leg>> tour;      ///< may be null
  std::string stage;                                 ///< "Roadmap: 2,500 of 7,500 samples"
  int round = 0;                                     ///< lazy round, 0 before the first
  std::optional<double> bestCost;                    ///< m
  std::optional<double> lowerBound;                  ///< m
};

}  // namespace vp::document
