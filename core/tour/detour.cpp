#include "core/tour/detour.h"

#include "core/base/quantity.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace vp::tour {
namespace {

/// Cells of the coarse grid; enough to follow an alpine valley over a degree, few enough for a search per target.
constexpr double kMostCells = 200'000.0;
/// How much longer a way may get to keep a turn's width from barred ground.
constexpr double kNearCost = 20.0;

/// The same to be inside forbidden airspace that cannot be passed below: out by the shortest way, and in only where a target is.
constexpr double kEnteredCost = 100.0;
/// Room [m] below an airspace that makes a way under it likely: legs are concave, so they are higher than the lowest safe altitude.
constexpr double kRoomBelow = 150.0;

enum class Ground : unsigned char { Free, Near, Entered, Barred };

double costOf(Ground ground) {
  return ground == Ground::Free ? 1.0 : ground == Ground::Near ? kNearCost : kEnteredCost;
}

/** The terrain as a coarse grid of what may be crossed. */
class CoarseGround {
public:
  CoarseGround(const landing::World& world, double ceiling) : extent_(world.terrain.grid().extent()) {
    const terrain::ElevationGrid& grid = world.terrain.grid();
    const double cells = static_cast<double>(grid.columns()) * grid.rows();
    factor_ = std::max(1, static_cast<int>(std::ceil(std::sqrt(cells / kMostCells))));
    cell_ = grid.cellSize() * factor_;
    columns_ = (grid.columns() + factor_ - 1) / factor_;
    rows_ = (grid.rows() + factor_ - 1) / factor_;
    ground_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), Ground::Free);
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        if (!(static_cast<double>(grid.upperInCell(column, row)) + world.clearance + world.reactionLoss <= ceiling)) {
          at(column / factor_, row / factor_) = Ground::Barred;
          barred_ = true;
        }
      }
    }
    if (barred_) {
      markNear(world);
    }
  }

  /// Bars the airspaces that can be passed neither way and marks those that the tour may be too high to pass below.
  /// @return false if stopped
  bool addAirspace(const landing::World& world, const ForbiddenAirspace& forbidden, const landing::AltitudeFloor& floor, double ceiling,
                   const Job& job) {
    hasAirspace_ = true;
    std::vector<HeightGate> gates;
    for (int index = 0; index < cells(); ++index) {
      if (index % columns_ == 0 && job.stopRequested()) {
        return false;
      }
      const geo::Point centre = centreOf(index);
      gates.clear();
      geo::Box cell;
      cell.add(centre);
      const double ground = world.terrain.upperIn(cell.grown(0.5 * cell_));
      forbidden.addGatesNear(world.terrain, centre, std::sqrt(0.5) * cell_, ground, gates);
      const double lowest = std::max(ground + world.clearance + world.reactionLoss, floor.at(centre));
      for (const HeightGate& gate : gates) {
        Ground& here = ground_[static_cast<std::size_t>(index)];
        if (!gate.isPassed(lowest, lowest + kRoomBelow)) {
          here = std::max(here, gate.isPassed(lowest, lowest) || gate.ceiling <= ceiling ? Ground::Entered : Ground::Barred);
          barred_ = true;
        }
      }
    }
    if (barred_) {
      markNear(world);
    }
    return true;
  }

  [[nodiscard]] bool hasBarred() const { return barred_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int cells() const { return columns_ * rows_; }
  [[nodiscard]] double cellSize() const { return cell_; }
  [[nodiscard]] Ground at(int index) const { return ground_[static_cast<std::size_t>(index)]; }

  [[nodiscard]] int indexOf(geo::Point p) const {
    const int column = std::clamp(static_cast<int>((p.x - extent_.minX) / cell_), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>((p.y - extent_.minY) / cell_), 0, rows_ - 1);
    return row * columns_ + column;
  }
  [[nodiscard]] geo::Point centreOf(int index) const {
    const int row = index / columns_;
    return {extent_.minX + (index - row * columns_ + 0.5) * cell_, extent_.minY + (row + 0.5) * cell_};
  }

  /// Whether a straight line touches no ground worse than `worst`, tested every half cell.
  [[nodiscard]] bool isClear(geo::Point a, geo::Point b, Ground worst) const {
    const int steps = 1 + static_cast<int>(geo::distance(a, b) / (0.5 * cell_));
    for (int i = 0; i <= steps; ++i) {
      const double f = static_cast<double>(i) / steps;
      if (at(indexOf({a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)})) > worst) {
        return false;
      }
    }
    return true;
  }

  /// What a straight part of a way may cross: beside airspace a target's own surroundings, which it has to leave somehow.
  [[nodiscard]] Ground worstBetween(geo::Point a, geo::Point b) const {
    return hasAirspace_ ? std::min(Ground::Entered, std::max(at(indexOf(a)), at(indexOf(b)))) : Ground::Free;
  }

  template <typename Visit>
  void forNeighbours(int index, Visit visit) const {
    const int row = index / columns_;
    const int column = index - row * columns_;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const int r = row + dr;
        const int c = column + dc;
        if ((dr != 0 || dc != 0) && r >= 0 && c >= 0 && r < rows_ && c < columns_) {
          visit(r * columns_ + c, dr != 0 && dc != 0 ? std::sqrt(2.0) : 1.0);
        }
      }
    }
  }

private:
  Ground& at(int column, int row) {
    return ground_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }

  /// Free cells within `margin` cells of a barred one, or of the map's edge, become near ones.
  void markNear(const landing::World& world) {
    const int margin = static_cast<int>(std::ceil(2.0 * world.glide.tourRadius() / cell_));
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const bool edge = row < margin || column < margin || row >= rows_ - margin || column >= columns_ - margin;
        if (edge && at(column, row) == Ground::Free) {
          at(column, row) = Ground::Near;
        }
        if (at(column, row) < Ground::Entered) {
          continue;
        }
        for (int r = std::max(0, row - margin); r <= std::min(rows_ - 1, row + margin); ++r) {
          for (int c = std::max(0, column - margin); c <= std::min(columns_ - 1, column + margin); ++c) {
            if (at(c, r) == Ground::Free) {
              at(c, r) = Ground::Near;
            }
          }
        }
      }
    }
  }

  geo::Box extent_;
  int factor_ = 1;
  double cell_ = 1.0;
  int columns_ = 0;
  int rows_ = 0;
  bool barred_ = false;
  bool hasAirspace_ = false;
  std::vector<Ground> ground_;
};

/// Predecessors on the cheapest ways from one cell to all others; -1 where there is none.
std::vector<int> waysFrom(const CoarseGround& ground, int start) {
  std::vector<double> cost(static_cast<std::size_t>(ground.cells()), std::numeric_limits<double>::infinity());
  std::vector<int> before(static_cast<std::size_t>(ground.cells()), -1);
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
  cost[static_cast<std::size_t>(start)] = 0.0;
  open.emplace(0.0, start);
  while (!open.empty()) {
    const double soFar = open.top().first;
    const int index = open.top().second;  // no structured binding: clang 14 does not let lambdas take those
    open.pop();
    if (soFar > cost[static_cast<std::size_t>(index)]) {
      continue;
    }
    ground.forNeighbours(index, [&](int next, double distance) {
      if (ground.at(next) == Ground::Barred) {
        return;
      }
      const double total = soFar + distance * costOf(ground.at(next));
      if (total < cost[static_cast<std::size_t>(next)]) {
        cost[static_cast<std::size_t>(next)] = total;
        before[static_cast<std::size_t>(next)] = index;
        open.emplace(total, next);
      }
    });
  }
  return before;
}

/// The corners of the way from `from` to `to`, ends left out; nothing if there is no way.
std::vector<geo::Point> pullStraight(const CoarseGround& ground, const std::vector<int>& before, geo::Point from, geo::Point to) {
  const int start = ground.indexOf(from);
  std::vector<geo::Point> way{to};
  for (int cell = before[static_cast<std::size_t>(ground.indexOf(to))]; cell >= 0 && cell != start; cell = before[static_cast<std::size_t>(cell)]) {
    way.push_back(ground.centreOf(cell));
  }
  way.push_back(from);
  std::reverse(way.begin(), way.end());
  std::vector<geo::Point> corners;
  std::size_t at = 0;
  while (at + 1 < way.size()) {
    std::size_t next = at + 1;
    for (std::size_t far = at + 2; far < way.size(); ++far) {
      if (ground.isClear(way[at], way[far], ground.worstBetween(way[at], way[far]))) {
        next = far;
      }
    }
    at = next;
    if (at + 1 < way.size()) {
      corners.push_back(way[at]);
    }
  }
  return corners;
}

/// Headings along the way: at each corner the direction from the one before to the one after.
std::vector<geo::Pose> withHeadings(const std::vector<geo::Point>& corners, geo::Point from, geo::Point to) {
  std::vector<geo::Pose> poses;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const geo::Point a = i == 0 ? from : corners[i - 1];
    const geo::Point b = i + 1 == corners.size() ? to : corners[i + 1];
    poses.push_back({corners[i].x, corners[i].y, wrapTwoPi(std::atan2(b.y - a.y, b.x - a.x))});
  }
  return poses;
}

/// Ways between all pairs of targets whose straight line is not free.
Result<std::vector<std::vector<geo::Pose>>> waysBetween(const CoarseGround& ground, const std::vector<geo::Point>& targets, const Job& job) {
  std::vector<std::vector<geo::Pose>> ways(targets.size() * targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while looking for ways around unknown terrain");
    }
    std::vector<int> before;
    for (std::size_t j = i + 1; j < targets.size(); ++j) {
      if (ground.isClear(targets[i], targets[j], Ground::Free)) {
        continue;
      }
      if (before.empty()) {
        before = waysFrom(ground, ground.indexOf(targets[i]));
      }
      std::vector<geo::Pose> poses = withHeadings(pullStraight(ground, before, targets[i], targets[j]), targets[i], targets[j]);
      ways[i * targets.size() + j] = poses;
      std::reverse(poses.begin(), poses.end());
      for (geo::Pose& pose : poses) {
        pose.heading = wrapTwoPi(pose.heading + Angle::kPi);
      }
      ways[j * targets.size() + i] = std::move(poses);
    }
  }
  return ways;
}

}  // namespace

Result<Detours> Detours::find(const landing::World& world, const std::vector<geo::Point>& targets, double ceiling, const Job& job) {
  Detours detours;
  detours.count_ = targets.size();
  const CoarseGround ground(world, ceiling);
  if (!ground.hasBarred()) {
    return detours;
  }
  Result<Ways> ways = waysBetween(ground, targets, job);
  if (!ways) {
    return forward(ways);
  }
  detours.poses_ = std::move(*ways);
  return detours;
}

Result<void> Detours::findAround(const ForbiddenAirspace& forbidden, const landing::AltitudeFloor& floor, const landing::World& world,
                                 const std::vector<geo::Point>& targets, double ceiling, const Job& job) {
  CoarseGround ground(world, ceiling);
  if (!ground.addAirspace(world, forbidden, floor, ceiling, job)) {
    return fail(Errc::Cancelled, "stopped while looking for ways around airspace");
  }
  if (!ground.hasBarred()) {
    return {};
  }
  Result<Ways> ways = waysBetween(ground, targets, job);
  if (!ways) {
    return forward(ways);
  }
  around_ = std::move(*ways);
  return {};
}

const std::vector<geo::Pose>& Detours::wayOf(const Ways& ways, int from, int to) const {
  static const std::vector<geo::Pose> none;
  return ways.empty() ? none : ways[static_cast<std::size_t>(from) * count_ + static_cast<std::size_t>(to)];
}

const std::vector<geo::Pose>& Detours::between(int from, int to) const {
  return wayOf(poses_, from, to);
}

const std::vector<geo::Pose>& Detours::aroundAirspace(int from, int to) const {
  return wayOf(around_, from, to);
}

}  // namespace vp::tour
