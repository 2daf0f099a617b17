#include "core/landing/altitude_floor.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace vp::landing {
namespace {

using Grid = AltitudeFloor::Grid;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The slope is kept below the glide's by this part: far above rounding, a millimetre in a kilometre of height.
constexpr double kSlopeSlack = 1e-6;

/** Finds vertex values in ascending order, each as high as the rules of the squares around it allow (label setting).
 *
 *  The rules of a square: all four values <= its limit (the ground + clearance), or at each corner the differences to the
 *  two neighbouring corners, squared, add up to at most k^2, k = glide loss over the spacing: a bilinear function is
 *  steepest at corners. A rule between three corners is kept when the last of them is set. Where fewer are set, the others
 *  will be at least as high as the one at hand, which leaves k / sqrt(2) for each of two equal steps. So later values are
 *  never below earlier ones and every rule that was kept stays kept. */
class FloorSearch {
public:
  FloorSearch(Grid& grid, const World& world)
      : grid_(grid),
        step_(world.glide.straightLoss() * (1.0 - kSlopeSlack) * grid.spacing),
        square_(step_ * step_),
        halfStep_(step_ * std::sqrt(0.5)) {
    const std::size_t squares = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    limit_.resize(squares);
    isReleased_.assign(squares, 0);
    value_.assign(grid_.vertex(grid.columns, grid.rows) + 1, kInfinite);
    caps_.assign(value_.size(), {});
    // from the middle of the border cells, so that no neighbour counts as touched
    const double inset = 0.5 * world.terrain.grid().cellSize();
    for (int j = 0; j < grid.rows; ++j) {
      for (int i = 0; i < grid.columns; ++i) {
        const double west = grid.originX + i * grid.spacing;
        const double south = grid.originY + j * grid.spacing;
        const geo::Box box{west + inset, south + inset, west + grid.spacing - inset, south + grid.spacing - inset};
        limit_[square(i, j)] = world.terrain.lowerIn(box) + world.clearance;
      }
    }
  }

  /// No more than `value` at a vertex.
  void cap(int i, int j, double value) {
    Caps& caps = caps_[grid_.vertex(i, j)];
    caps.own = std::min(caps.own, value);
    offer(i, j);
  }

  /// @return false if stopped
  bool run(const Job& job) {
    constexpr int kBetweenPolls = 4096;
    for (int steps = 0; !open_.empty(); ++steps) {
      if (steps % kBetweenPolls == 0 && job.stopRequested()) {
        return false;
      }
      const Entry top = open_.front();
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      open_.pop_back();
      if (value_[top.vertex] == kInfinite && caps_[top.vertex].least() == top.value) {
        settle(top);
      }
    }
    grid_.value.reserve(value_.size());
    for (const double value : value_) {
      grid_.value.push_back(value < kInfinite ? static_cast<float>(value) : AltitudeFloor::kNoGlide);
    }
    return true;
  }

private:
  struct Caps {
    double own = kInfinite;
    std::array<double, 4> bySquare{kInfinite, kInfinite, kInfinite, kInfinite};  ///< square to the SW, SE, NW, NE
    [[nodiscard]] double least() const { return std::min({own, bySquare[0], bySquare[1], bySquare[2], bySquare[3]}); }
  };
  struct Entry {
    double value = 0.0;
    unsigned vertex = 0;
    bool operator>(const Entry& o) const { return value != o.value ? value > o.value : vertex > o.vertex; }
  };
  /// Values of a square as seen from one of its corners; infinity: not set yet.
  struct Corners {
    double beside = kInfinite;  ///< along x
    double above = kInfinite;   ///< along y
    double across = kInfinite;
  };

  [[nodiscard]] std::size_t square(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.columns) + static_cast<std::size_t>(i);
  }

  /// Corners of the square to the `side` (+-1, +-1) of vertex (i, j).
  [[nodiscard]] Corners seenFrom(int i, int j, int sideX, int sideY) const {
    return {value_[grid_.vertex(i + sideX, j)], value_[grid_.vertex(i, j + sideY)], value_[grid_.vertex(i + sideX, j + sideY)]};
  }

  /// Minus infinity where the corners differ by more than the slope allows, beyond rounding.
  [[nodiscard]] double rootOf(double square) const {
    return square > 0.0 ? std::sqrt(square) : square > -1e-9 * square_ ? 0.0 : -kInfinite;
  }

  /// The highest value that keeps the slope of a square, as far as its other corners are set.
  [[nodiscard]] double slopeCap(const Corners& c) const {
    double cap = kInfinite;
    const auto along = [&](double neighbour) {
      if (c.across == kInfinite) {
        return neighbour + halfStep_;
      }
      return neighbour + rootOf(square_ - (neighbour - c.across) * (neighbour - c.across));
    };
    if (c.beside < kInfinite) {
      cap = along(c.beside);
    }
    if (c.above < kInfinite) {
      cap = std::min(cap, along(c.above));
      if (c.beside < kInfinite) {
        cap = std::min(cap, 0.5 * (c.beside + c.above + rootOf(2.0 * square_ - (c.beside - c.above) * (c.beside - c.above))));
      }
    }
    return cap;
  }

  /// The highest value that keeps either rule of a square.
  [[nodiscard]] double capBy(std::size_t square, const Corners& c) const {
    const double limit = limit_[square];
    if (isReleased_[square] != 0) {
      return limit;
    }
    const double slope = slopeCap(c);
    const auto isBelow = [limit](double value) { return value <= limit || value == kInfinite; };
    return isBelow(c.beside) && isBelow(c.above) && isBelow(c.across) ? std::max(slope, limit) : slope;
  }

  void offer(int i, int j) {
    const std::size_t vertex = grid_.vertex(i, j);
    open_.push_back({caps_[vertex].least(), static_cast<unsigned>(vertex)});
    std::push_heap(open_.begin(), open_.end(), std::greater<>());
  }

  void settle(const Entry& entry) {
    const int j = static_cast<int>(entry.vertex / static_cast<unsigned>(grid_.columns + 1));
    const int i = static_cast<int>(entry.vertex) - j * (grid_.columns + 1);
    for (int q = 0; q < 4; ++q) {
      const int sideX = q % 2 == 0 ? -1 : 1;
      const int sideY = q < 2 ? -1 : 1;
      if (hasSquare(i, j, sideX, sideY) && entry.value > slopeCap(seenFrom(i, j, sideX, sideY))) {
        isReleased_[square(i + std::min(sideX, 0), j + std::min(sideY, 0))] = 1;  // its limit allowed this value
      }
    }
    value_[entry.vertex] = entry.value;
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        refresh(i + di, j + dj, i, j);
      }
    }
  }

  [[nodiscard]] bool hasSquare(int i, int j, int sideX, int sideY) const {
    return i + sideX >= 0 && i + sideX <= grid_.columns && j + sideY >= 0 && j + sideY <= grid_.rows &&
           limit_[square(i + std::min(sideX, 0), j + std::min(sideY, 0))] > -kInfinite;
  }

  /// Works out anew what the squares that (i, j) shares with a vertex just set allow.
  void refresh(int i, int j, int setI, int setJ) {
    if (i < 0 || j < 0 || i > grid_.columns || j > grid_.rows || value_[grid_.vertex(i, j)] < kInfinite) {
      return;
    }
    Caps& caps = caps_[grid_.vertex(i, j)];
    const double before = caps.least();
    for (int q = 0; q < 4; ++q) {
      const int sideX = q % 2 == 0 ? -1 : 1;
      const int sideY = q < 2 ? -1 : 1;
      const bool isShared = (setI - i) * sideX >= 0 && (setJ - j) * sideY >= 0;
      if (isShared && hasSquare(i, j, sideX, sideY)) {
        const std::size_t at = square(i + std::min(sideX, 0), j + std::min(sideY, 0));
        caps.bySquare[static_cast<std::size_t>(q)] = capBy(at, seenFrom(i, j, sideX, sideY));
      }
    }
    if (caps.least() != before) {
      offer(i, j);
    }
  }

  Grid& grid_;
  double step_;      ///< k, m
  double square_;    ///< k^2
  double halfStep_;  ///< k / sqrt(2)
  std::vector<double> value_;  ///< per vertex; infinity: not set
  std::vector<double> limit_;  ///< per square; minus infinity: unknown ground
  std::vector<char> isReleased_;  ///< per square: holds by its limit
  std::vector<Caps> caps_;
  std::vector<Entry> open_;
};

/// The squares of a grid over a box: `factor` cells wide, from the box's south-west cell.
Grid gridOver(const terrain::ElevationGrid& terrain, int column0, int row0, int columns, int rows, int factor) {
  Grid grid;
  grid.spacing = terrain.cellSize() * factor;
  grid.originX = terrain.originX() + column0 * terrain.cellSize();
  grid.originY = terrain.originY() + row0 * terrain.cellSize();
  grid.columns = (columns + factor - 1) / factor;
  grid.rows = (rows + factor - 1) / factor;
  return grid;
}

/// The least power of two of cells per square that keeps the number of vertices and the finest spacing.
int factorFor(const terrain::ElevationGrid& terrain, int columns, int rows, const AltitudeFloorOptions& options) {
  int factor = 1;
  const auto isTooFine = [&] {
    return static_cast<double>(columns / factor + 2) * (rows / factor + 2) > static_cast<double>(options.mostVertices) ||
           terrain.cellSize() * factor < options.finest;
  };
  while (isTooFine() && factor < std::max(columns, rows)) {
    factor *= 2;
  }
  return factor;
}

void capAtSites(FloorSearch& search, const Grid& grid, const World& world) {
  for (const mission::SiteInFrame& site : world.sites) {
    const double ground = world.terrain.grid().upperAt(site.pose.point());
    if (!std::isfinite(ground) || !grid.contains(site.pose.x, site.pose.y)) {
      continue;  // no glide arrives over unknown ground
    }
    const double altitude = std::max(site.site.elevation.metres() + world.arrivalMargin, ground + world.clearance);
    const int i = std::min(static_cast<int>((site.pose.x - grid.originX) / grid.spacing), grid.columns - 1);
    const int j = std::min(static_cast<int>((site.pose.y - grid.originY) / grid.spacing), grid.rows - 1);
    for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      search.cap(i + di, j + dj, altitude);
    }
  }
}

}  // namespace

Result<AltitudeFloor> AltitudeFloor::build(const World& world, const AltitudeFloorOptions& options, const Job& job) {
  AltitudeFloor floor;
  const terrain::ElevationGrid& terrain = world.terrain.grid();
  const int factor = factorFor(terrain, terrain.columns(), terrain.rows(), options);
  floor.whole_ = gridOver(terrain, 0, 0, terrain.columns(), terrain.rows(), factor);
  FloorSearch search(floor.whole_, world);
  capAtSites(search, floor.whole_, world);
  if (!search.run(job)) {
    return fail(Errc::Cancelled, "stopped while bounding the safe altitudes");
  }
  if (!options.detail || factor == 1) {
    return floor;
  }
  // The detail begins and ends at vertices of the whole, so that on its border the whole is linear between them.
  const Grid& whole = floor.whole_;
  const auto index = [&](double x, double origin, int most) { return std::clamp(static_cast<int>(std::floor((x - origin) / whole.spacing)), 0, most); };
  const int west = index(options.detail->minX, whole.originX, whole.columns - 1);
  const int south = index(options.detail->minY, whole.originY, whole.rows - 1);
  const int columns = index(options.detail->maxX, whole.originX, whole.columns - 1) + 1 - west;
  const int rows = index(options.detail->maxY, whole.originY, whole.rows - 1) + 1 - south;
  const int detailFactor = std::min(factor, factorFor(terrain, columns * factor, rows * factor, options));
  if (detailFactor == factor) {
    return floor;
  }
  floor.detail_ = gridOver(terrain, west * factor, south * factor, columns * factor, rows * factor, detailFactor);
  Grid& detail = floor.detail_;
  FloorSearch fine(detail, world);
  capAtSites(fine, detail, world);
  const auto capAtBorder = [&](int i, int j) {
    const double value = whole.at(detail.originX + i * detail.spacing, detail.originY + j * detail.spacing);
    if (std::isfinite(value)) {
      fine.cap(i, j, value);
    }
  };
  for (int i = 0; i <= detail.columns; ++i) {
    capAtBorder(i, 0);
    capAtBorder(i, detail.rows);
  }
  for (int j = 0; j <= detail.rows; ++j) {
    capAtBorder(0, j);
    capAtBorder(detail.columns, j);
  }
  if (!fine.run(job)) {
    return fail(Errc::Cancelled, "stopped while bounding the safe altitudes");
  }
  return floor;
}

}  // namespace vp::landing
