#include "core/landing/altitude_floor.h"

#include "core/landing/approach.h"

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

constexpr int kBetweenPolls = 4096;

/// A vertex in the order of values.
struct Entry {
  double value = 0.0;
  unsigned vertex = 0;
  bool operator>(const Entry& o) const { return value != o.value ? value > o.value : vertex > o.vertex; }
};

/** A first guess at the floor, no bound: least altitudes along straight glides from anchors, which are sites and vertices that
 *  the ground raised (Dijkstra; each vertex remembers its anchor, as in vector distance transforms, Danielsson 1980). */
class FloorGuess {
public:
  FloorGuess(const Grid& grid, const std::vector<double>& limit, double lossPerMetre)
      : grid_(grid), limit_(limit), loss_(lossPerMetre), value_(grid.vertex(grid.columns, grid.rows) + 1, kInfinite), anchor_(value_.size()) {}

  void start(int i, int j, geo::Point at, double altitude) { offer(grid_.vertex(i, j), {at, altitude}, -kInfinite); }

  [[nodiscard]] bool run(const Job& job) {
    for (int steps = 0; !open_.empty(); ++steps) {
      if (steps % kBetweenPolls == 0 && job.stopRequested()) {
        return false;
      }
      const Entry top = open_.front();
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      open_.pop_back();
      if (top.value == value_[top.vertex]) {
        spread(top.vertex);
      }
    }
    return true;
  }
  [[nodiscard]] std::vector<double> takeValues() { return std::move(value_); }

private:
  struct Anchor {
    geo::Point at;
    double altitude = 0.0;
  };

  void spread(std::size_t vertex) {
    const int j = static_cast<int>(vertex / static_cast<std::size_t>(grid_.columns + 1));
    const int i = static_cast<int>(vertex) - j * (grid_.columns + 1);
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        if ((di != 0 || dj != 0) && i + di >= 0 && j + dj >= 0 && i + di <= grid_.columns && j + dj <= grid_.rows) {
          offer(grid_.vertex(i + di, j + dj), anchor_[vertex], limitBetween(i, j, di, dj));
        }
      }
    }
  }

  /// Least limit of the squares that both ends of an edge belong to; infinity if all are unknown.
  [[nodiscard]] double limitBetween(int i, int j, int di, int dj) const {
    double least = kInfinite;
    for (int q = 0; q < 4; ++q) {
      const int sideX = q % 2 == 0 ? -1 : 1;
      const int sideY = q < 2 ? -1 : 1;
      const int column = i + std::min(sideX, 0);
      const int row = j + std::min(sideY, 0);
      const bool isShared = di * sideX >= 0 && dj * sideY >= 0 && column >= 0 && row >= 0 && column < grid_.columns && row < grid_.rows;
      if (isShared) {
        const double limit = limit_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) + static_cast<std::size_t>(column)];
        least = limit > -kInfinite ? std::min(least, limit) : least;
      }
    }
    return least;
  }

  void offer(std::size_t vertex, Anchor anchor, double limit) {
    if (limit == kInfinite || value_[vertex] <= limit) {
      return;
    }
    const int j = static_cast<int>(vertex / static_cast<std::size_t>(grid_.columns + 1));
    const int i = static_cast<int>(vertex) - j * (grid_.columns + 1);
    const geo::Point here{grid_.originX + i * grid_.spacing, grid_.originY + j * grid_.spacing};
    const double dx = here.x - anchor.at.x;
    const double dy = here.y - anchor.at.y;
    double value = anchor.altitude + loss_ * std::sqrt(dx * dx + dy * dy);
    if (value < limit) {
      value = limit;
      anchor = {here, limit};
    }
    if (value < value_[vertex]) {
      value_[vertex] = value;
      anchor_[vertex] = anchor;
      open_.push_back({value, static_cast<unsigned>(vertex)});
      std::push_heap(open_.begin(), open_.end(), std::greater<>());
    }
  }

  const Grid& grid_;
  const std::vector<double>& limit_;
  double loss_;
  std::vector<double> value_;
  std::vector<Anchor> anchor_;
  std::vector<Entry> open_;
};

/** Finds vertex values in ascending order, each as high as the rules of the squares around it allow (label setting).
 *
 *  The rules of a square: all four values <= its limit (the ground + clearance), or at each corner the differences to the
 *  two neighbouring corners, squared, add up to at most k^2, k = glide loss over the spacing: a bilinear function is
 *  steepest at corners. A rule between three corners is kept when the last of them is set. Where fewer are set, the others
 *  will be at least as high as the one at hand, which leaves k / sqrt(2) for each of two equal steps. So later values are
 *  never below earlier ones and every rule that was kept stays kept. How high a value is within the rules is a matter of
 *  quality alone; the guess decides it. */
class FloorSearch {
public:
  FloorSearch(Grid& grid, const World& world)
      : grid_(grid), step_(world.glide.leastLoss() * (1.0 - kSlopeSlack) * grid.spacing), square_(step_ * step_), halfStep_(step_ * std::sqrt(0.5)) {
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
        limit_[square(i, j)] = world.terrain.lowerIn(box) + world.clearance + world.reactionLoss;
      }
    }
  }

  /// No more than `value` at a vertex.
  void cap(int i, int j, double value) {
    Caps& caps = caps_[grid_.vertex(i, j)];
    caps.own = std::min(caps.own, value);
  }

  [[nodiscard]] const std::vector<double>& limits() const { return limit_; }

  /// Follows a guess from below.
  void follow(std::vector<double> guess) {
    for (std::size_t vertex = 0; vertex < guess.size(); ++vertex) {
      if (guess[vertex] < kInfinite) {
        caps_[vertex].own = std::min(caps_[vertex].own, guess[vertex]);
        open_.push_back({caps_[vertex].own, static_cast<unsigned>(vertex)});
      }
    }
    std::make_heap(open_.begin(), open_.end(), std::greater<>());
    guess_ = std::move(guess);
  }

  /// @return false if stopped
  bool run(const Job& job) {
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
    double deficits = 0.0;  ///< below the guess, summed over the vertices around that are set
    double neighbours = 0.0;
    std::array<double, 4> bySquare{kInfinite, kInfinite, kInfinite, kInfinite};  ///< square to the SW, SE, NW, NE
    [[nodiscard]] double least() const { return std::min({own, bySquare[0], bySquare[1], bySquare[2], bySquare[3]}); }
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
  [[nodiscard]] double rootOf(double square) const { return square > 0.0 ? std::sqrt(square) : square > -1e-9 * square_ ? 0.0 : -kInfinite; }

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
    followGuess(caps, grid_.vertex(i, j), grid_.vertex(setI, setJ));
    if (caps.least() != before) {
      offer(i, j);
    }
  }

  /** Keeps a vertex as far below the guess as the vertices set around it are on average. Without this the rules are kept as
   *  well, but a vertex set as high as it may be leaves less to those beside it, which lie further below then, and so on: over
   *  flat ground the result would be a pyramid, up to 30 % below the cone. */
  void followGuess(Caps& caps, std::size_t vertex, std::size_t set) const {
    const double level = value_[set];
    caps.deficits += guess_[set] - level;
    caps.neighbours += 1.0;
    caps.own = std::min(caps.own, std::max(level, guess_[vertex] - caps.deficits / caps.neighbours));
  }

  Grid& grid_;
  double step_;                ///< k, m
  double square_;              ///< k^2
  double halfStep_;            ///< k / sqrt(2)
  std::vector<double> value_;  ///< per vertex; infinity: not set
  std::vector<double> guess_;
  std::vector<double> limit_;     ///< per square; minus infinity: unknown ground
  std::vector<char> isReleased_;  ///< per square: holds by its limit
  std::vector<Caps> caps_;
  std::vector<Entry> open_;
};

/// The squares of a grid over a box: `factor` cells wide, from the box's south-west cell.
Grid gridOver(const terrain::ElevationGrid& terrain, int column0, int row0, int columns, int rows, int factor) {
  Grid grid;
  grid.spacing = terrain.cellSize() * factor;
  grid.perSpacing = 1.0 / grid.spacing;
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
    const auto across = static_cast<std::size_t>(columns / factor) + 2;
    const auto along = static_cast<std::size_t>(rows / factor) + 2;
    return across * along > options.mostVertices || terrain.cellSize() * factor < options.finest;
  };
  while (isTooFine() && factor < std::max(columns, rows)) {
    factor *= 2;
  }
  return factor;
}

/// Where a floor starts from: no more than `altitude` at the vertex, reached from a place.
struct FloorStart {
  int i = 0;
  int j = 0;
  geo::Point from;
  double altitude = 0.0;
};

void addSites(const Grid& grid, const std::vector<Approach>& approaches, double reactionLoss, std::vector<FloorStart>& starts) {
  for (const Approach& approach : approaches) {
    const geo::Point place = approach.gate.point();
    if (!grid.contains(place.x, place.y)) {
      continue;
    }
    const int i = std::min(static_cast<int>((place.x - grid.originX) / grid.spacing), grid.columns - 1);
    const int j = std::min(static_cast<int>((place.y - grid.originY) / grid.spacing), grid.rows - 1);
    for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      starts.push_back({i + di, j + dj, place, approach.altitude + reactionLoss});
    }
  }
}

/// On its border a detail may be no higher than the whole, which a glide meets when it leaves.
void addBorder(const Grid& detail, const Grid& whole, std::vector<FloorStart>& starts) {
  const auto add = [&](int i, int j) {
    const geo::Point place{detail.originX + i * detail.spacing, detail.originY + j * detail.spacing};
    const double value = whole.at(place.x, place.y);
    if (std::isfinite(value)) {
      starts.push_back({i, j, place, value});
    }
  };
  for (int i = 0; i <= detail.columns; ++i) {
    add(i, 0);
    add(i, detail.rows);
  }
  for (int j = 0; j <= detail.rows; ++j) {
    add(0, j);
    add(detail.columns, j);
  }
}

/// @return false if stopped
bool fill(Grid& grid, const World& world, const std::vector<FloorStart>& starts, const Job& job) {
  FloorSearch search(grid, world);
  FloorGuess guess(grid, search.limits(), world.glide.leastLoss());
  for (const FloorStart& start : starts) {
    search.cap(start.i, start.j, start.altitude);
    guess.start(start.i, start.j, start.from, start.altitude);
  }
  if (!guess.run(job)) {
    return false;
  }
  search.follow(guess.takeValues());
  return search.run(job);
}

}  // namespace

Result<AltitudeFloor> AltitudeFloor::build(const World& world, const AltitudeFloorOptions& options, const Job& job) {
  AltitudeFloor floor;
  const terrain::ElevationGrid& terrain = world.terrain.grid();
  const int factor = factorFor(terrain, terrain.columns(), terrain.rows(), options);
  floor.whole_ = gridOver(terrain, 0, 0, terrain.columns(), terrain.rows(), factor);
  const std::vector<Approach> approaches = approachesOf(world);
  std::vector<FloorStart> starts;
  addSites(floor.whole_, approaches, world.reactionLoss, starts);
  if (!fill(floor.whole_, world, starts, job)) {
    return fail(Errc::Cancelled, "stopped while bounding the safe altitudes");
  }
  if (!options.detail || factor == 1) {
    return floor;
  }
  // The detail begins and ends at vertices of the whole, so that on its border the whole is linear between them.
  const Grid& whole = floor.whole_;
  const auto index = [&](double x, double origin, int most) {
    return std::clamp(static_cast<int>(std::floor((x - origin) / whole.spacing)), 0, most);
  };
  const int west = index(options.detail->minX, whole.originX, whole.columns - 1);
  const int south = index(options.detail->minY, whole.originY, whole.rows - 1);
  const int columns = index(options.detail->maxX, whole.originX, whole.columns - 1) + 1 - west;
  const int rows = index(options.detail->maxY, whole.originY, whole.rows - 1) + 1 - south;
  const int detailFactor = std::min(factor, factorFor(terrain, columns * factor, rows * factor, options));
  if (detailFactor == factor) {
    return floor;
  }
  floor.detail_ = gridOver(terrain, west * factor, south * factor, columns * factor, rows * factor, detailFactor);
  starts.clear();
  addSites(floor.detail_, approaches, world.reactionLoss, starts);
  addBorder(floor.detail_, whole, starts);
  if (!fill(floor.detail_, world, starts, job)) {
    return fail(Errc::Cancelled, "stopped while bounding the safe altitudes");
  }
  return floor;
}

}  // namespace vp::landing
