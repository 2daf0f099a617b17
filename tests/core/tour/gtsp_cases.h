#pragma once

// Random problems and a brute-force oracle for the tour tests. Shares no code with the solver.

#include "core/tour/gtsp.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <random>
#include <vector>

namespace gtsp_cases {

using vp::tour::GtspProblem;
using vp::tour::kForbidden;

enum class Kind { Whole, Real, Metric, Forbidden, Zeros, Symmetric };
inline constexpr int kKinds = 6;

inline GtspProblem randomProblem(std::mt19937_64& random, int sets, int mostNodes, Kind kind) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  GtspProblem problem;
  for (int set = 0; set < sets; ++set) {
    std::vector<int> members(static_cast<std::size_t>(1 + below(mostNodes)));
    std::iota(members.begin(), members.end(), problem.nodes);
    problem.nodes += static_cast<int>(members.size());
    problem.sets.push_back(members);
  }
  // Node numbers are shuffled, so that sets are no ranges.
  std::vector<int> names(static_cast<std::size_t>(problem.nodes));
  std::iota(names.begin(), names.end(), 0);
  std::shuffle(names.begin(), names.end(), random);
  for (std::vector<int>& members : problem.sets) {
    for (int& node : members) {
      node = names[static_cast<std::size_t>(node)];
    }
  }
  std::vector<double> x(names.size());
  std::vector<double> y(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    x[i] = unit();
    y[i] = unit();
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      double cost = kind == Kind::Whole ? below(1000) : unit() * 37.5;
      if (kind == Kind::Metric) {
        cost = 1e5 * std::hypot(x[i] - x[j], y[i] - y[j]) * (x[i] < x[j] ? 1.2 : 1.0);
      } else if (kind == Kind::Symmetric) {
        cost = std::floor(1e4 * std::hypot(x[i] - x[j], y[i] - y[j]));
      } else if (kind == Kind::Zeros) {
        cost = below(3) == 0 ? 1.0 + below(5) : 0.0;
      } else if (kind == Kind::Forbidden && below(100) < 45) {
        cost = kForbidden;
      }
      problem.cost.push_back(cost);
    }
  }
  return problem;
}

inline double costOf(const GtspProblem& problem, const std::vector<int>& tour) {
  double sum = 0.0;
  for (std::size_t i = 0; tour.size() > 1 && i < tour.size(); ++i) {
    sum += problem.at(tour[i], tour[(i + 1) % tour.size()]);
  }
  return sum;
}

/** Tries every order of sets and every choice of nodes. */
inline void extend(const GtspProblem& problem, std::vector<int>& tour, std::vector<bool>& done, double cost, double& best) {
  if (tour.size() == problem.sets.size()) {
    best = std::min(best, cost + (tour.size() > 1 ? problem.at(tour.back(), tour.front()) : 0.0));
    return;
  }
  for (std::size_t set = 1; set < problem.sets.size(); ++set) {
    if (done[set]) {
      continue;
    }
    done[set] = true;
    for (const int node : problem.sets[set]) {
      const double next = cost + problem.at(tour.back(), node);
      if (next < best) {
        tour.push_back(node);
        extend(problem, tour, done, next, best);
        tour.pop_back();
      }
    }
    done[set] = false;
  }
}

inline double bruteForce(const GtspProblem& problem) {
  double best = kForbidden;
  for (const int node : problem.sets[0]) {
    std::vector<int> tour{node};
    std::vector<bool> done(problem.sets.size(), false);
    extend(problem, tour, done, 0.0, best);
  }
  return best;
}

/** Whether a tour visits every set once, beginning with set 0. */
inline bool isTour(const GtspProblem& problem, const std::vector<int>& tour) {
  std::vector<int> visits(problem.sets.size(), 0);
  for (const int node : tour) {
    for (std::size_t set = 0; set < problem.sets.size(); ++set) {
      visits[set] += static_cast<int>(std::count(problem.sets[set].begin(), problem.sets[set].end(), node));
    }
  }
  const std::vector<int>& zero = problem.sets[0];
  return tour.size() == problem.sets.size() && std::count(visits.begin(), visits.end(), 1) == std::ssize(visits) &&
         std::find(zero.begin(), zero.end(), tour[0]) != zero.end();
}

/** Folder of the shared test data, empty if there is none. */
inline std::filesystem::path dataFolder() {
  if (const char* named = std::getenv("VOLPLANE_DATA")) {
    return named;
  }
  for (const char* relative : {"/../../shared/data", "/../shared/data"}) {
    const std::filesystem::path folder = std::filesystem::path(VOLPLANE_SOURCE_DIR).string() + relative;
    if (std::filesystem::exists(folder)) {
      return folder;
    }
  }
  return {};
}

}  // namespace gtsp_cases
