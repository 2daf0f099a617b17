#include "core/landing/line_height.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vp::landing {
namespace {

/// Cells of the first level along the line at most; fewer look too far beside the line, more are looked at in vain.
constexpr int kMostCells = 16;
constexpr std::size_t kMostParts = std::size_t{3} * (kMostCells + 2);
/// Cells per metre across a line along the cells' side: so small that it leaves no row, so large that it can be divided by.
constexpr double kLeastSlope = 1e-12;

/** A walk along a line over the cells of a pyramid. In cells of the grid; "along" is the axis that the line covers more of. */
class LineWalk {
public:
  LineWalk(const terrain::TerrainPyramid& terrain, geo::Point from, geo::Point to, double loss, double above, double required, double giveUpAbove)
      : terrain_(terrain), loss_(loss), above_(above), required_(required), giveUpAbove_(giveUpAbove) {
    const terrain::ElevationGrid& grid = terrain.grid();
    const double perCell = 1.0 / grid.cellSize();
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    length_ = std::sqrt(dx * dx + dy * dy);
    touch_ = kTouch * perCell;
    const double perMetre = length_ > 0.0 ? perCell / length_ : 0.0;
    isEastward_ = std::abs(dx) >= std::abs(dy);
    const double x = (from.x - grid.originX()) * perCell;
    const double y = (from.y - grid.originY()) * perCell;
    along_ = axis(isEastward_ ? x : y, (isEastward_ ? dx : dy) * perMetre);
    across_ = axis(isEastward_ ? y : x, (isEastward_ ? dy : dx) * perMetre);
    const geo::Box extent = grid.extent();
    isInside_ = std::min(from.x, to.x) - kTouch > extent.minX && std::min(from.y, to.y) - kTouch > extent.minY &&
                std::max(from.x, to.x) + kTouch < extent.maxX && std::max(from.y, to.y) + kTouch < extent.maxY;
  }

  double walk() {
    if (!isInside_) {
      return std::numeric_limits<double>::infinity();
    }
    const auto cells = static_cast<unsigned>(std::abs(along_.slope) * length_);
    const int level = std::min(static_cast<int>(std::bit_width(cells / kMostCells)), terrain_.levels() - 1);
    part(level, 0.0, length_);
    return required_;
  }

private:
  struct Axis {
    double start = 0.0;
    double slope = 0.0;    ///< cells per metre
    double inverse = 0.0;  ///< metres per cell
    [[nodiscard]] double at(double s) const { return start + slope * s; }
    [[nodiscard]] double reaches(double edge) const { return (edge - start) * inverse; }
  };
  struct Part {
    double bound = 0.0;
    double from = 0.0;
    double to = 0.0;
  };
  static Axis axis(double start, double slope) {
    const double divisor = slope < 0.0 ? std::min(slope, -kLeastSlope) : std::max(slope, kLeastSlope);
    return {start, slope, 1.0 / divisor};
  }

  /// The part of the line between two lengths, over the cells of a level.
  void part(int level, double from, double to) {
    if (level == 0) {
      cells(0, from, to, [this](double bound, double, double) { required_ = bound; });
      return;
    }
    std::array<Part, kMostParts> parts;
    std::size_t count = 0;
    std::size_t worst = 0;
    cells(level, from, to, [&](double bound, double in, double out) {
      worst = count > 0 && bound <= parts[worst].bound ? worst : count;
      parts[count++] = {bound, in, out};
    });
    if (count == 0) {
      return;
    }
    // The most demanding first: it settles the others sooner, or shows that the glide is hopeless.
    part(level - 1, parts[worst].from, parts[worst].to);
    for (std::size_t i = count; i-- > 0 && required_ <= giveUpAbove_;) {
      if (i != worst && parts[i].bound > required_) {
        part(level - 1, parts[i].from, parts[i].to);
      }
    }
  }

  /// Passes each cell of a level that asks for more than is required to `use`: (what it asks for, where the line comes and leaves).
  template <typename Use>
  void cells(int level, double from, double to, Use use) {
    const double side = static_cast<double>(1 << level);
    const double scale = 1.0 / side;
    const terrain::TerrainPyramid::Upper upper = terrain_.upperLevel(level);
    const std::size_t alongStride = isEastward_ ? 1 : upper.columns;
    const std::size_t acrossStride = isEastward_ ? upper.columns : 1;
    const double a = along_.at(from);
    const double b = along_.at(to);
    const int first = static_cast<int>((std::min(a, b) - touch_) * scale);
    const int last = static_cast<int>((std::max(a, b) + touch_) * scale);
    const bool isRising = along_.slope >= 0.0;
    for (int k = first; k <= last; ++k) {
      const double near = (isRising ? k * side - touch_ : (k + 1) * side + touch_);
      const double far = (isRising ? (k + 1) * side + touch_ : k * side - touch_);
      const double in = std::clamp(along_.reaches(near), from, to);
      const double out = std::clamp(along_.reaches(far), in, to);
      const double c = across_.at(in);
      const double d = across_.at(out);
      const int lowest = static_cast<int>((std::min(c, d) - touch_) * scale);
      const int highest = static_cast<int>((std::max(c, d) + touch_) * scale);
      const float* ground = upper.values + static_cast<std::size_t>(k) * alongStride;
      for (int r = lowest; r <= highest; ++r) {
        const double most = static_cast<double>(ground[static_cast<std::size_t>(r) * acrossStride]) + above_;
        if (most + loss_ * out > required_) {
          const bool isUp = across_.slope >= 0.0;
          const double comes = std::clamp(across_.reaches(isUp ? r * side - touch_ : (r + 1) * side + touch_), in, out);
          const double leaves = std::clamp(across_.reaches(isUp ? (r + 1) * side + touch_ : r * side - touch_), comes, out);
          if (const double bound = most + loss_ * leaves; bound > required_) {
            use(bound, comes, leaves);
            if (required_ > giveUpAbove_) {
              return;
            }
          }
        }
      }
    }
  }

  const terrain::TerrainPyramid& terrain_;
  double loss_;
  double above_;
  double required_;
  double giveUpAbove_;
  double length_ = 0.0;
  double touch_ = 0.0;
  bool isEastward_ = true;
  bool isInside_ = false;
  Axis along_;
  Axis across_;
};

}  // namespace

double requiredAlongLine(const terrain::TerrainPyramid& terrain, geo::Point from, geo::Point to, double lossPerMetre, double above, double required,
                         double giveUpAbove) {
  const geo::Box box{std::min(from.x, to.x) - kTouch, std::min(from.y, to.y) - kTouch, std::max(from.x, to.x) + kTouch,
                     std::max(from.y, to.y) + kTouch};
  if (required > giveUpAbove || terrain.upperIn(box) + above + lossPerMetre * geo::distance(from, to) <= required) {
    return required;
  }
  return LineWalk(terrain, from, to, lossPerMetre, above, required, giveUpAbove).walk();
}

}  // namespace vp::landing
