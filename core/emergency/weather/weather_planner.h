#pragma once

#include "core/emergency/landing_planner.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace vp::emergency {

/** Which roadmap of [4] section 2.1 a planner searches. */
enum class RoadmapOf {
  Nothing,          ///< single curves alone: "Straight"
  VisibilityGraph,  ///< VG, flat
  TangentGraph,     ///< VG without edges that are not locally tangent
  Layers,           ///< LVG, DLVG
  Hybrid,           ///< HRM
  Samples,          ///< PRM, DPRM
  SeededSamples,    ///< VPRM, DVPRM
};

/** One planner of [4]. */
struct WeatherPlannerOptions {
  RoadmapOf roadmap = RoadmapOf::SeededSamples;
  bool hasDynamics = false;    ///< vertices are poses, edges Dubins glides: the planners with a D
  bool searchesLines = true;   ///< ELS on what a roadmap without dynamics gives; with them it "makes no improvement", [4] section 3.2
  bool searchesCurves = true;  ///< DLS on what any roadmap gives; without, points are flown through as the Trajectory Planner does
  std::size_t samples = 100;   ///< of the first roadmap with samples; twice as many in each that follows. [4] has 2000 in one
  std::size_t nearest = 20;    ///< that each is joined to; [4] has 200
  int rounds = 5;              ///< roadmaps with samples at most
  int ways = 4;                ///< taken from each roadmap, as not each can be flown
  int polish = 1000;           ///< moves of the best way's poses after each roadmap
};

/** The planners of [4] for a glide: a roadmap, A* over it, local search, then the altitudes of least weather along what was found.
 *
 *  Single curves to all runways in range come first, so none is worse than "straight". What comes through the weather surely ends the search.
 * Roadmaps with samples grow from round to round, with half the samples near the best way so far. What differs from the paper: WHY-weather.md.
 *  @source [4] Meuleau, Neukom, Plaunt, Smith, Smith 2011, A comparison of risk sensitive path planning methods for aircraft emergency landing
 *  @threads one thread, whatever the request allows */
class WeatherPlanner final : public LandingPlanner {
public:
  /** @param name  outlives the planner */
  WeatherPlanner(std::string_view name, const WeatherPlannerOptions& options) : name_(name), options_(options) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;

private:
  std::string_view name_;
  WeatherPlannerOptions options_;
};

/** Names of the planners of [4], in the order of its text. */
std::vector<std::string_view> weatherPlannerNames();

/** Options by such a name; none if it is none. */
std::optional<WeatherPlannerOptions> weatherPlannerOptions(std::string_view name);

}  // namespace vp::emergency
