#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/world.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace vp::landing {

/** How finely an AltitudeFloor is worked out. */
struct AltitudeFloorOptions {
  std::size_t mostVertices = 300'000;  ///< of each of its two grids; about 0.8 us and 160 bytes each while it is built
  double finest = 0.0;                 ///< m, spacing that need not be undercut where the cells of the terrain are smaller
  std::optional<geo::Box> detail;      ///< where a second, finer grid is wanted
};

/** A lower bound W(x, y) of the safe altitude A(x, y, heading), World::reactionLoss included: for every heading and every glide, whatever
 *  roadmap found it, W <= A. So nothing that has to be safe at a place may be planned below W there, before any glide is looked for.
 *
 *  W is bilinear in the squares of a grid over the whole terrain and keeps three rules: W <= A(gate) where the approach to a site begins; and in
 *  each square either W <= the least ground in it + clearance (+ reactionLoss), or W is nowhere steeper than the straight glide. Squares of
 *  unknown ground keep no rule, as no glide enters them. Why that makes it a bound: WHY.md, "The altitude floor". It is not the
 *  greatest bound: it knows no headings, so it misses what turning costs.
 *  @threads const members are pure */
class AltitudeFloor {
public:
  /** A floor that claims nothing: minus infinity everywhere. */
  AltitudeFloor() = default;

  /** @errors Cancelled   @cost O(vertices log vertices), one thread */
  static Result<AltitudeFloor> build(const World& world, const AltitudeFloorOptions& options, const Job& job);

  /** The bound at a place [m MSL]; infinity where no glide to any site exists. Outside the terrain it claims nothing more than
   *  at the edge. @cost 4 loads, 8 in the detail */
  [[nodiscard]] double at(geo::Point p) const {
    const double whole = whole_.at(p.x, p.y);
    return detail_.value.empty() || !detail_.contains(p.x, p.y) ? whole : std::max(whole, detail_.at(p.x, p.y));
  }

  /** A grid of values: vertex (i, j) at (originX + i * spacing, originY + j * spacing). */
  struct Grid {
    double originX = 0.0;
    double originY = 0.0;
    double spacing = 1.0;
    double perSpacing = 1.0;
    int columns = 0;           ///< squares
    int rows = 0;              ///< squares
    std::vector<float> value;  ///< (columns + 1) * (rows + 1), m MSL

    [[nodiscard]] double at(double x, double y) const;
    [[nodiscard]] bool contains(double x, double y) const {
      return x >= originX && y >= originY && x <= originX + spacing * columns && y <= originY + spacing * rows;
    }
    [[nodiscard]] std::size_t vertex(int i, int j) const {
      return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns + 1) + static_cast<std::size_t>(i);
    }
  };
  [[nodiscard]] const Grid& whole() const { return whole_; }
  [[nodiscard]] const Grid& detail() const { return detail_; }  ///< empty if the whole is as fine

  /// Stands for infinity inside the grids, so that interpolation stays finite; above all ground and every ceiling [m].
  static constexpr float kNoGlide = 1e6F;
  /// Taken off every answer [m], for places that are known to a rounding error only.
  static constexpr double kSlack = 1e-3;

private:
  Grid whole_;
  Grid detail_;
};

inline double AltitudeFloor::Grid::at(double x, double y) const {
  if (value.empty()) {
    return -std::numeric_limits<double>::infinity();
  }
  const double u = std::clamp((x - originX) * perSpacing, 0.0, static_cast<double>(columns));
  const double v = std::clamp((y - originY) * perSpacing, 0.0, static_cast<double>(rows));
  const int i = std::min(static_cast<int>(u), columns - 1);
  const int j = std::min(static_cast<int>(v), rows - 1);
  const float* south = value.data() + vertex(i, j);
  const float* north = south + columns + 1;
  const double a = u - i;
  const double b = v - j;
  const double low = south[0] + a * (south[1] - south[0]);
  const double high = north[0] + a * (north[1] - north[0]);
  const double w = low + b * (high - low);
  return w < 0.5 * kNoGlide ? w - kSlack : std::numeric_limits<double>::infinity();
}

}  // namespace vp::landing
