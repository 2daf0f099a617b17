#pragma once

#include "core/emergency/weather/weather_roadmap.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace vp::emergency {

/** A way through a roadmap to a gate: its vertices without start and gate. */
struct RoadmapWay {
  std::vector<int> vertices;
  std::size_t goal = 0;  ///< index in LandingGoals::inRange
  double cost = 0.0;     ///< weather and clear air
};

/** Effort of searches. */
struct RoadmapCount {
  std::int64_t vertices = 0;
  std::int64_t expanded = 0;  ///< states taken from the queue
  std::int64_t edges = 0;     ///< evaluated against weather and ground
};

/** A* over a roadmap whose edges are evaluated only when a state that they start at is taken ([4] section 2.1, "lazy approach").
 *
 *  A state is a vertex, the altitude there or an interval of altitudes, and what has been met so far: height is the resource that range limits ask
 * for. Heuristic: the rest of the way straight in clear weather; states from which no gate can be reached any more by the least loss are dropped. Of
 * two states at a vertex the one that costs no more and is no lower is kept, as long as no floor or top lies between their altitudes; of intervals
 * the one that covers the other.
 *  @threads one thread; all that it is made of outlives it */
class RoadmapSearch {
public:
  RoadmapSearch(const RoadmapTask& task, const WeatherRoadmap& roadmap, RoadmapCount& count);

  /** The next best way: the best first, another at each call. @return none: there is no other, or time is over */
  std::optional<RoadmapWay> next();

private:
  struct State {
    int vertex = 0;
    double low = 0.0;  ///< altitudes, m MSL; low == high but for intervals
    double high = 0.0;
    double cost = 0.0;
    int parent = -1;
    bool isDominated = false;
  };
  struct Open {
    double estimate = 0.0;
    double altitude = 0.0;
    int state = -1;
  };
  struct Reached {
    double low = 0.0;
    double high = 0.0;
    double cost = 0.0;
  };

  void expand(int id);
  void neighboursOf(int vertex, std::vector<int>& out) const;
  void alongCurve(const State& from, int to);
  void alongLine(const State& from, int to);
  void lineEnd(const State& from, const geo::Pose& pose, const flight::Piece& piece, double end);
  [[nodiscard]] bool dominates(const State& one, const State& other) const;
  [[nodiscard]] bool isDominated(const State& state) const;
  [[nodiscard]] std::size_t layerOf(double altitude) const;
  void push(State state);
  static bool isLater(const Open& a, const Open& b);

  const RoadmapTask& task_;
  const WeatherRoadmap& roadmap_;
  RoadmapCount& count_;
  std::vector<double> toGo_;    ///< by vertex: m straight to the nearest gate
  std::vector<double> needed_;  ///< by vertex: m MSL, from lower no gate is reached
  std::vector<State> states_;
  std::vector<std::vector<int>> atVertex_;
  std::vector<Open> open_;
  std::vector<Reached> reached_;
  std::vector<int> near_;
};

}  // namespace vp::emergency
