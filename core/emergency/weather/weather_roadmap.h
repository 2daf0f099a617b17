#pragma once

#include "core/emergency/landing_goals.h"
#include "core/emergency/weather/weather_flight.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::emergency {

/** What becomes of the altitude along an edge of a roadmap. */
enum class EdgeAltitude {
  Glide,      ///< that of the best glide; where slopes leave a choice also by the share of the vertex it leads to
  Layers,     ///< the same, and the floors and tops of weather that lie within what slopes leave: LVG
  Intervals,  ///< all that slopes leave, in intervals of one cost: HRM and HA*
};

/** A vertex of a roadmap: a place over ground, with dynamics a pose. */
struct RoadmapVertex {
  geo::Pose pose;
  double share = 0.0;  ///< of the range of slopes, for edges that lead to it
  int corner = -1;     ///< of the visibility graph; -1: none
};

/** One of the roadmaps of [4] section 2.1: the start is vertex 0, the gates of runways in range are vertices 1 to n, the others follow. Directed;
 *  edges that no altitude flies are found while it is searched. */
struct WeatherRoadmap {
  std::vector<RoadmapVertex> vertices;
  std::size_t goals = 0;                ///< number of gates
  std::vector<std::vector<int>> edges;  ///< by vertex; may be empty
  std::size_t nearest = 0;              ///< each vertex is joined to so many of its nearest too, and to the nearest gates
  bool hasDynamics = false;             ///< edges are Dubins glides between poses, not straight lines between places
  EdgeAltitude altitude = EdgeAltitude::Glide;

  [[nodiscard]] bool isGoal(std::size_t vertex) const { return vertex >= 1 && vertex <= goals; }
};

/** What a roadmap is made for. */
struct RoadmapTask {
  const LandingRequest& request;
  const LandingGoals& goals;
  WeatherFlight& flight;
  const Countdown& countdown;
  std::uint64_t seed = 1;
  std::size_t samples = 0;                      ///< of probabilistic roadmaps
  std::size_t nearest = 0;                      ///< that each is joined to
  const std::vector<geo::Pose>* way = nullptr;  ///< the best so far: half of the samples are drawn near it; null or empty: none
};

/** A roadmap with start and gates alone. */
WeatherRoadmap bareRoadmap(const RoadmapTask& task);

/** Visibility graph of the outlines of all weather, floors and tops aside, edges that are not locally tangent at both ends left out (tangent graph)
 *  or kept. @source [4] section 2.1 */
WeatherRoadmap visibilityRoadmap(const RoadmapTask& task, bool tangentOnly);

/** Layered visibility graph: the same places with the altitudes of floors and tops, start and gates joined to each other and to their 100 nearest.
 *  With dynamics two poses at each corner, tangent to it on either side. @source [4] section 2.1 */
WeatherRoadmap layeredRoadmap(const RoadmapTask& task, bool hasDynamics);

/** Hybrid roadmap: edges between corners of different cells that cross neither of the two, over, under or through all others; altitude intervals.
 *  @source [4] section 2.1 */
WeatherRoadmap hybridRoadmap(const RoadmapTask& task);

/** Probabilistic roadmap: samples where a landing may lead, each joined to its nearest. @source [4] section 2.1; Kavraki et al. 1996 */
WeatherRoadmap sampledRoadmap(const RoadmapTask& task, bool hasDynamics);

/** A probabilistic roadmap seeded with vertices and edges of the layered visibility graph: VPRM. @source [4] section 2.1 */
WeatherRoadmap seededRoadmap(const RoadmapTask& task, bool hasDynamics);

}  // namespace vp::emergency
