#include "core/emergency/linear_octree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace vp::emergency {
namespace {

/// A cell this near counts as touched [cells]: far above rounding below kMostCells, far below a millimetre.
constexpr double kTouch = 1e-9;
constexpr int kLevelBits = 4;
/// The table of first leaves has at most 8^5 entries.
constexpr int kTableDepth = 5;

std::uint64_t spread(std::uint32_t value) {
  std::uint64_t bits = value & 0x1FFFFFU;
  bits = (bits | bits << 32U) & 0x1F00000000FFFFU;
  bits = (bits | bits << 16U) & 0x1F0000FF0000FFU;
  bits = (bits | bits << 8U) & 0x100F00F00F00F00FU;
  bits = (bits | bits << 4U) & 0x10C30C30C30C30C3U;
  return (bits | bits << 2U) & 0x1249249249249249U;
}

int levelsFor(const std::array<int, 3>& count) {
  return std::bit_width(static_cast<unsigned>(*std::max_element(count.begin(), count.end()) - 1));
}

/// Cells from the bottom of a column that ground up to `height` blocks.
std::uint16_t blockedUpTo(double height, const CellBox& box) {
  const double cells = (height - box.low.z) / box.cell.z + kTouch;
  if (!(cells < box.count[2])) {
    return static_cast<std::uint16_t>(box.count[2]);
  }
  return cells < 0.0 ? std::uint16_t{0} : static_cast<std::uint16_t>(std::floor(cells) + 1.0);
}

}  // namespace

std::uint64_t LinearOctree::mortonOf(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return spread(x) | spread(y) << 1U | spread(z) << 2U;
}

/** Halves cubes from the whole down until each is free or blocked; so leaves come by ascending code and are as large as can be. */
class OctreeBuilder {
public:
  OctreeBuilder(LinearOctree& tree, const std::vector<float>& ground, const std::vector<Cuboid>& obstacles, const Job& job) : tree_(tree), job_(job) {
    if (!ground.empty()) {
      setGround(ground);
    }
    for (const Cuboid& obstacle : obstacles) {
      addObstacle(obstacle);
    }
  }

  /// @return false: it was asked to stop
  bool run() {
    split(tree_.levels_, {0, 0, 0}, 0, 0, blocked_.size());
    return !isStopped_;
  }

private:
  using Cell = LinearOctree::Cell;
  /// Least and most of the cells that are blocked in the columns of 2^level x 2^level; columns outside the box are blocked.
  struct Level {
    int columns = 0;
    std::vector<std::uint16_t> least;
    std::vector<std::uint16_t> most;
  };

  void setGround(const std::vector<float>& ground) {
    const CellBox& box = tree_.box_;
    Level finest;
    finest.columns = box.count[0];
    finest.most.resize(ground.size());
    std::transform(ground.begin(), ground.end(), finest.most.begin(), [&box](float height) { return blockedUpTo(static_cast<double>(height), box); });
    finest.least = finest.most;
    levels_.push_back(std::move(finest));
    int rows = box.count[1];
    for (int level = 1; level <= tree_.levels_; ++level) {
      const Level& below = levels_.back();
      const int rowsBelow = rows;
      rows = (rows + 1) / 2;
      Level next;
      next.columns = (below.columns + 1) / 2;
      const std::size_t size = static_cast<std::size_t>(next.columns) * static_cast<std::size_t>(rows);
      next.least.resize(size);
      next.most.resize(size);
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < next.columns; ++i) {
          // what a border column lacks is outside: split() never takes such a cube for free
          const auto at = [&](int di, int dj) {
            const int column = std::min(2 * i + di, below.columns - 1);
            const int row = std::min(2 * j + dj, rowsBelow - 1);
            return static_cast<std::size_t>(row) * static_cast<std::size_t>(below.columns) + static_cast<std::size_t>(column);
          };
          const std::size_t to = static_cast<std::size_t>(j) * static_cast<std::size_t>(next.columns) + static_cast<std::size_t>(i);
          next.least[to] = std::min({below.least[at(0, 0)], below.least[at(1, 0)], below.least[at(0, 1)], below.least[at(1, 1)]});
          next.most[to] = std::max({below.most[at(0, 0)], below.most[at(1, 0)], below.most[at(0, 1)], below.most[at(1, 1)]});
        }
      }
      levels_.push_back(std::move(next));
    }
  }

  void addObstacle(const Cuboid& obstacle) {
    const std::array<double, 3> low = tree_.inCells(obstacle.low);
    const std::array<double, 3> high = tree_.inCells(obstacle.high);
    LinearOctree::CellRange range;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int last = tree_.box_.count[axis] - 1;
      if (high[axis] + kTouch < 0.0 || low[axis] - kTouch > last + 1.0 || low[axis] > high[axis]) {
        return;
      }
      range.low[axis] = static_cast<int>(std::max(0.0, std::floor(low[axis] - kTouch)));
      range.high[axis] = static_cast<int>(std::min(static_cast<double>(last), std::floor(high[axis] + kTouch)));
    }
    blocked_.push_back(range);
  }

  /** @param first, last  of blocked_: what may meet this cube */
  void split(int level, const Cell& at, std::uint64_t code, std::size_t first, std::size_t last) {
    const int side = 1 << level;
    const std::array<int, 3>& count = tree_.box_.count;
    if (at[0] >= count[0] || at[1] >= count[1] || at[2] >= count[2] || isStopped_) {
      return;
    }
    bool isWhole = at[0] + side <= count[0] && at[1] + side <= count[1] && at[2] + side <= count[2];
    if (!levels_.empty()) {
      const Level& columns = levels_[static_cast<std::size_t>(level)];
      const std::size_t column =
          static_cast<std::size_t>(at[1] >> level) * static_cast<std::size_t>(columns.columns) + static_cast<std::size_t>(at[0] >> level);
      if (std::min(at[2] + side, count[2]) <= columns.least[column]) {
        return;
      }
      isWhole = isWhole && at[2] >= columns.most[column];
    }
    const std::size_t kept = blocked_.size();
    for (std::size_t i = first; i < last; ++i) {
      const LinearOctree::CellRange range = blocked_[i];
      bool meets = true;
      bool covers = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        meets = meets && range.low[axis] < at[axis] + side && range.high[axis] >= at[axis];
        covers = covers && range.low[axis] <= at[axis] && range.high[axis] >= at[axis] + side - 1;
      }
      if (covers) {
        blocked_.resize(kept);
        return;
      }
      if (meets) {
        blocked_.push_back(range);
      }
    }
    const std::size_t end = blocked_.size();
    if (isWhole && end == kept) {
      tree_.leaves_.push_back(code << static_cast<unsigned>(kLevelBits) | static_cast<unsigned>(level));
      return;
    }
    if (level == kPolled) {
      isStopped_ = job_.stopRequested();
    }
    const int half = side / 2;
    const std::uint64_t step = std::uint64_t{1} << (3U * static_cast<unsigned>(level - 1));
    for (unsigned child = 0; child < 8; ++child) {
      const Cell corner{at[0] + static_cast<int>(child & 1U) * half, at[1] + static_cast<int>(child >> 1U & 1U) * half,
                        at[2] + static_cast<int>(child >> 2U) * half};
      split(level - 1, corner, code + child * step, kept, end);
    }
    blocked_.resize(kept);
  }

  /// Cubes of so many levels are worked out in well under a millisecond.
  static constexpr int kPolled = 6;

  LinearOctree& tree_;
  const Job& job_;
  std::vector<Level> levels_;
  std::vector<LinearOctree::CellRange> blocked_;  ///< obstacles, and behind them those that meet the cubes being split
  bool isStopped_ = false;
};

Result<LinearOctree> LinearOctree::build(const CellBox& box, const std::vector<float>& ground, const std::vector<Cuboid>& obstacles, const Job& job) {
  LinearOctree tree;
  tree.box_ = box;
  tree.levels_ = levelsFor(box.count);
  tree.tableLevel_ = std::max(0, tree.levels_ - kTableDepth);
  if (job.stopRequested() || !OctreeBuilder(tree, ground, obstacles, job).run()) {
    return fail(Errc::Cancelled, "The octree of free space was stopped.");
  }
  const unsigned shift = 3U * static_cast<unsigned>(tree.tableLevel_) + kLevelBits;
  const std::size_t cubes = std::size_t{1} << (3U * static_cast<unsigned>(tree.levels_ - tree.tableLevel_));
  tree.first_.reserve(cubes + 1);
  std::size_t leaf = 0;
  for (std::size_t cube = 0; cube <= cubes; ++cube) {
    while (leaf < tree.leaves_.size() && tree.leaves_[leaf] >> shift < cube) {
      ++leaf;
    }
    tree.first_.push_back(static_cast<std::uint32_t>(leaf));
  }
  return tree;
}

std::array<double, 3> LinearOctree::inCells(const Point3& p) const {
  return {(p.x - box_.low.x) / box_.cell.x, (p.y - box_.low.y) / box_.cell.y, (p.z - box_.low.z) / box_.cell.z};
}

int LinearOctree::leafSide(const Cell& cell) const {
  const std::uint64_t code = mortonOf(static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]), static_cast<std::uint32_t>(cell[2]));
  const std::size_t cube = code >> (3U * static_cast<unsigned>(tableLevel_));
  const auto begin = leaves_.begin() + first_[cube];
  const auto end = leaves_.begin() + first_[cube + 1];
  // the last leaf that begins at the cell or before it; one that is larger than the table's cubes may begin in an earlier cube
  const std::uint64_t key = code << static_cast<unsigned>(kLevelBits) | ((1U << static_cast<unsigned>(kLevelBits)) - 1U);
  const auto behind = std::upper_bound(begin, end, key);
  if (behind == leaves_.begin()) {
    return 0;
  }
  const std::uint64_t leaf = *(behind - 1);
  const unsigned level = leaf & ((1U << static_cast<unsigned>(kLevelBits)) - 1U);
  return (leaf >> static_cast<unsigned>(kLevelBits)) >> (3U * level) == code >> (3U * level) ? 1 << level : 0;
}

bool LinearOctree::isFree(const Point3& p) const {
  return isFree(p, p);
}

bool LinearOctree::isFree(const Point3& from, const Point3& to) const {
  const std::array<double, 3> a = inCells(from);
  const std::array<double, 3> b = inCells(to);
  Cell cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double most = box_.count[axis];
    if (!(a[axis] >= 0.0 && a[axis] <= most && b[axis] >= 0.0 && b[axis] <= most) || leaves_.empty()) {
      return false;
    }
    cell[axis] = std::min(static_cast<int>(a[axis]), box_.count[axis] - 1);
  }
  double along = 0.0;  // share of the segment up to the current leaf's far side
  while (true) {
    const int side = leafSide(cell);
    if (side == 0) {
      return false;
    }
    double exit = 1.0;
    std::size_t face = 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = b[axis] - a[axis];
      const int low = cell[axis] & ~(side - 1);
      const int plane = step > 0.0 ? low + side : low;
      // not at all: a segment that ends on the far side stays in this leaf
      if (step > 0.0 ? b[axis] > plane : b[axis] < plane) {
        const double at = (plane - a[axis]) / step;
        if (face == 3 || at < exit) {
          exit = at;
          face = axis;
        }
      }
    }
    if (face == 3) {
      return true;
    }
    along = std::max(along, exit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = b[axis] - a[axis];
      const int low = cell[axis] & ~(side - 1);
      if (axis == face) {
        cell[axis] = step > 0.0 ? low + side : low - 1;
        continue;
      }
      // within this leaf, and never back: so rounding cannot lead in circles
      const int at = std::clamp(static_cast<int>(std::floor(a[axis] + along * step)), low, low + side - 1);
      cell[axis] = step > 0.0 ? std::max(cell[axis], at) : std::min(cell[axis], at);
    }
  }
}

bool LinearOctree::isBoxFree(const Cuboid& part) const {
  const std::array<double, 3> low = inCells(part.low);
  const std::array<double, 3> high = inCells(part.high);
  CellRange range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(low[axis] >= 0.0 && low[axis] <= high[axis] && high[axis] <= box_.count[axis]) || leaves_.empty()) {
      return false;
    }
    range.low[axis] = std::min(static_cast<int>(low[axis]), box_.count[axis] - 1);
    range.high[axis] = std::min(static_cast<int>(high[axis]), box_.count[axis] - 1);
  }
  return areFree(range);
}

bool LinearOctree::areFree(CellRange range) const {
  while (true) {
    const int side = leafSide(range.low);
    if (side == 0) {
      return false;
    }
    Cell last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      last[axis] = std::min(range.high[axis], range.low[axis] | (side - 1));
    }
    // what is left beyond the leaf: above it, then north of it, then east
    for (const std::size_t axis : {std::size_t{2}, std::size_t{1}}) {
      if (last[axis] < range.high[axis]) {
        CellRange beyond = range;
        beyond.low[axis] = last[axis] + 1;
        if (!areFree(beyond)) {
          return false;
        }
        range.high[axis] = last[axis];
      }
    }
    if (last[0] == range.high[0]) {
      return true;
    }
    range.low[0] = last[0] + 1;
  }
}

std::int64_t LinearOctree::freeCells() const {
  std::int64_t cells = 0;
  for (const std::uint64_t leaf : leaves_) {
    cells += std::int64_t{1} << (3U * (leaf & ((1U << static_cast<unsigned>(kLevelBits)) - 1U)));
  }
  return cells;
}

}  // namespace vp::emergency
