#include "maps/erosion.h"

#include "core/base/expect.h"
#include "maps/deterministic.h"

#include <queue>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace vp::maps {
namespace {

constexpr double kDiagonal = 1.4142135623730951;  // square root of 2
constexpr double kErodibility = 0.08;             // of rock of hardness 1, per step and metre of sqrt(area): settles in some tens of steps
constexpr double kTimeStep = 1.0;                 // unit of time; speeds below are per step

struct Neighbour {
  int di;
  int dj;
  double distance;  // in spacings
};
constexpr std::array<Neighbour, 8> kNeighbours{
    {{1, 0, 1.0}, {0, 1, 1.0}, {-1, 0, 1.0}, {0, -1, 1.0}, {1, 1, kDiagonal}, {-1, 1, kDiagonal}, {-1, -1, kDiagonal}, {1, -1, kDiagonal}}};

bool isBorder(int i, int j, int size) {
  return i == 0 || j == 0 || i == size - 1 || j == size - 1;
}

/// Places of posts seen from their index.
struct Grid {
  int size;
  [[nodiscard]] int column(std::size_t index) const { return static_cast<int>(index % static_cast<std::size_t>(size)); }
  [[nodiscard]] int row(std::size_t index) const { return static_cast<int>(index / static_cast<std::size_t>(size)); }
  [[nodiscard]] bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < size && j < size; }
};

double stepLength(const Grid& grid, std::size_t a, std::size_t b, double spacing) {
  const bool straight = grid.column(a) == grid.column(b) || grid.row(a) == grid.row(b);
  return straight ? spacing : spacing * kDiagonal;
}

/// Posts in the order in which rising water reaches them from the border; fills pits on the way.
std::vector<std::size_t> floodOrder(HeightField& field) {
  using Entry = std::pair<double, std::size_t>;
  const Grid grid{field.size()};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<char> seen(field.heights().size(), 0);
  for (int j = 0; j < field.size(); ++j) {
    for (int i = 0; i < field.size(); ++i) {
      if (isBorder(i, j, field.size())) {
        queue.emplace(field.at(i, j), field.index(i, j));
        seen[field.index(i, j)] = 1;
      }
    }
  }
  std::vector<std::size_t> order;
  order.reserve(seen.size());
  while (!queue.empty()) {
    const std::size_t post = queue.top().second;
    queue.pop();
    order.push_back(post);
    for (const Neighbour& step : kNeighbours) {
      const int i = grid.column(post) + step.di;
      const int j = grid.row(post) + step.dj;
      if (grid.contains(i, j) && seen[field.index(i, j)] == 0) {
        seen[field.index(i, j)] = 1;
        field.at(i, j) = std::max(field.at(i, j), field.heights()[post]);
        queue.emplace(field.at(i, j), field.index(i, j));
      }
    }
  }
  return order;
}

/// One step of time: uplift and incision from the border upwards, slopes cut to the talus, summits rounded.
void advance(HeightField& field, const Tectonics& tectonics, const std::vector<double>& uplift, const std::vector<double>& erodibility) {
  const Grid grid{field.size()};
  const Drainage drainage = drain(field);
  std::vector<double>& z = field.heights();
  for (const std::size_t post : drainage.order) {
    const std::size_t below = drainage.receiver[post];
    if (below == post) {
      continue;
    }
    const double length = stepLength(grid, post, below, field.spacing());
    const double incision = erodibility[post] * std::sqrt(drainage.area[post]) * kTimeStep / length;
    const double eroded = (z[post] + uplift[post] * kTimeStep + incision * z[below]) / (1.0 + incision);
    z[post] = std::min(std::max(eroded, z[below]), z[below] + tectonics.talus * (0.5 + 0.5 * kErodibility / erodibility[post]) * length);
  }
  if (tectonics.diffusion <= 0.0) {
    return;
  }
  const std::vector<double> before = z;
  for (int j = 1; j + 1 < field.size(); ++j) {
    for (int i = 1; i + 1 < field.size(); ++i) {
      const double mean =
          (before[field.index(i + 1, j)] + before[field.index(i - 1, j)] + before[field.index(i, j + 1)] + before[field.index(i, j - 1)]) / 4.0;
      field.at(i, j) += tectonics.diffusion * (mean - before[field.index(i, j)]);
    }
  }
}

HeightField refined(const HeightField& coarse, std::uint64_t seed) {
  HeightField fine(2 * coarse.size() - 1, coarse.spacing() / 2.0);
  Random random(seed);
  for (int j = 0; j < fine.size(); ++j) {
    for (int i = 0; i < fine.size(); ++i) {
      const int i1 = (i + 1) / 2;
      const int j1 = (j + 1) / 2;
      fine.at(i, j) = (coarse.at(i / 2, j / 2) + coarse.at(i1, j / 2) + coarse.at(i / 2, j1) + coarse.at(i1, j1)) / 4.0;
      const double jitter = random.uniform(0.0, 0.2 * fine.spacing());
      if (!isBorder(i, j, fine.size())) {
        fine.at(i, j) += jitter;
      }
    }
  }
  return fine;
}

void run(HeightField& field, const Tectonics& tectonics, int steps) {
  std::vector<double> uplift(field.heights().size());
  std::vector<double> erodibility(field.heights().size());
  for (int j = 0; j < field.size(); ++j) {
    for (int i = 0; i < field.size(); ++i) {
      const double x = field.coordinate(i);
      const double y = field.coordinate(j);
      uplift[field.index(i, j)] = kErodibility * tectonics.steepness * tectonics.uplift(x, y);
      erodibility[field.index(i, j)] = kErodibility / tectonics.hardness(x, y);
    }
  }
  for (int step = 0; step < steps; ++step) {
    advance(field, tectonics, uplift, erodibility);
  }
}

}  // namespace

Drainage drain(HeightField& field) {
  const Grid grid{field.size()};
  const std::vector<double>& z = field.heights();
  Drainage result;
  result.order = floodOrder(field);
  result.receiver.resize(z.size());
  result.area.assign(z.size(), field.spacing() * field.spacing());
  std::vector<std::size_t> rank(z.size());
  for (std::size_t k = 0; k < result.order.size(); ++k) {
    rank[result.order[k]] = k;
  }
  for (const std::size_t post : result.order) {
    const int column = grid.column(post);
    const int row = grid.row(post);
    result.receiver[post] = post;
    if (isBorder(column, row, field.size())) {
      continue;
    }
    double steepest = -1.0;
    for (const Neighbour& step : kNeighbours) {
      const std::size_t other = field.index(column + step.di, row + step.dj);
      const double slope = (z[post] - z[other]) / step.distance;
      const bool flatButEarlier = slope == steepest && rank[other] < rank[result.receiver[post]];
      if (rank[other] < rank[post] && (slope > steepest || flatButEarlier)) {
        steepest = slope;
        result.receiver[post] = other;
      }
    }
  }
  for (auto post = result.order.rbegin(); post != result.order.rend(); ++post) {
    if (result.receiver[*post] != *post) {
      result.area[result.receiver[*post]] += result.area[*post];
    }
  }
  return result;
}

HeightField erode(int size, double spacing, const Tectonics& tectonics, const std::vector<int>& steps, std::uint64_t seed) {
  const int halvings = static_cast<int>(steps.size()) - 1;
  VP_EXPECT(halvings >= 0 && (size - 1) % (1 << halvings) == 0);
  HeightField field((size - 1) / (1 << halvings) + 1, spacing * (1 << halvings));
  for (int j = 1; j + 1 < field.size(); ++j) {
    for (int i = 1; i + 1 < field.size(); ++i) {
      const double x = field.coordinate(i) / (20.0 * spacing);
      const double y = field.coordinate(j) / (20.0 * spacing);
      field.at(i, j) = 2.0 * spacing * (1.0 + fractalNoise(x, y, seed, 6));
    }
  }
  run(field, tectonics, steps.front());
  for (std::size_t level = 1; level < steps.size(); ++level) {
    field = refined(field, seed + level);
    run(field, tectonics, steps[level]);
  }
  return field;
}

void bend(HeightField& field, double amplitude, double wavelength, std::uint64_t seed) {
  const HeightField source = field;
  const int last = field.size() - 1;
  for (int j = 0; j < field.size(); ++j) {
    for (int i = 0; i < field.size(); ++i) {
      const double x = field.coordinate(i) / wavelength;
      const double y = field.coordinate(j) / wavelength;
      const double fromEdge = std::min(std::min(i, last - i), std::min(j, last - j)) * field.spacing();
      const double shift = std::min(amplitude, fromEdge / 2.0) / field.spacing();
      const double u = std::clamp(i + shift * fractalNoise(x, y, seed, 3), 0.0, last - 1e-9);
      const double v = std::clamp(j + shift * fractalNoise(x, y, seed + 50, 3), 0.0, last - 1e-9);
      const int left = static_cast<int>(u);
      const int below = static_cast<int>(v);
      const double south = source.at(left, below) * (1.0 - (u - left)) + source.at(left + 1, below) * (u - left);
      const double north = source.at(left, below + 1) * (1.0 - (u - left)) + source.at(left + 1, below + 1) * (u - left);
      field.at(i, j) = south * (1.0 - (v - below)) + north * (v - below);
    }
  }
}

}  // namespace vp::maps
