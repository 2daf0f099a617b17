#include "core/landing/required_height.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/quantity.h"
#include "core/landing/line_height.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::landing {
namespace {

/// Quarter circles of a full one, and one for rounding.
constexpr int kMostParts = 5;

/** Branch and bound over one piece: raises `required` until it bounds terrain + clearance + loss on all of it.
 *  Parts are kept by their end points, so halving needs no trigonometry. */
class PieceBound {
public:
  /// @param before  metres of the piece that are flown before what this looks at
  PieceBound(const terrain::TerrainPyramid& terrain, const flight::PieceLoss& loss, double before, double above, double required, double giveUpAbove)
      : terrain_(terrain),
        loss_(loss),
        before_(before),
        above_(above),
        required_(required),
        giveUpAbove_(giveUpAbove),
        leaf_(0.5 * terrain.grid().cellSize()) {}

  /// a and b as seen from the centre of the turn; at most a quarter circle apart.
  void arc(geo::Point centre, double radius, geo::Point a, geo::Point b, double from, double to) {
    arc(centre, radius, a, b, from, to, arcBound(centre, radius, a, b, from, to));
  }

  [[nodiscard]] double required() const { return required_; }

private:
  /// True if the bound of a part settles it: it asks for nothing, or the glide is hopeless.
  [[nodiscard]] bool isSettled(double bound) const { return bound <= required_ || required_ > giveUpAbove_; }

  /** A part of at most half a cell: the cells that it really touches, not all that its box does. So what is found hardly depends on where
   *  a curve was cut. A cell counts if its square, grown by `grow`, meets the chord: their boxes do, and so do their shadows
   *  across the chord. */
  void leaf(geo::Point a, geo::Point b, double grow, double to) {
    const terrain::ElevationGrid& grid = terrain_.grid();
    const double cell = grid.cellSize();
    const double reach = 0.5 * cell + grow;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    const double shadow = reach * (std::abs(dx) + std::abs(dy)) + kTouch * length;
    const int east = grid.columnOf(std::max(a.x, b.x) + grow);
    const int north = grid.rowOf(std::max(a.y, b.y) + grow);
    for (int row = grid.rowOf(std::min(a.y, b.y) - grow); row <= north; ++row) {
      for (int column = grid.columnOf(std::min(a.x, b.x) - grow); column <= east; ++column) {
        const double needed = static_cast<double>(grid.upperInCell(column, row)) + above_ + loss_.upTo(before_ + to);
        if (needed <= required_) {
          continue;
        }
        const double x = grid.originX() + (column + 0.5) * cell - a.x;
        const double y = grid.originY() + (row + 0.5) * cell - a.y;
        if (std::abs(dx * y - dy * x) <= shadow) {
          required_ = needed;
        }
      }
    }
  }

  void arc(geo::Point centre, double radius, geo::Point a, geo::Point b, double from, double to, double bound) {
    if (isSettled(bound)) {
      return;
    }
    if (to - from <= leaf_) {
      leaf({centre.x + a.x, centre.y + a.y}, {centre.x + b.x, centre.y + b.y}, kTouch + sagittaOf(to - from, radius), to);
      return;
    }
    const double half = 0.5 * (from + to);
    const double scale = radius / std::sqrt((a.x + b.x) * (a.x + b.x) + (a.y + b.y) * (a.y + b.y));
    const geo::Point middle{(a.x + b.x) * scale, (a.y + b.y) * scale};
    const double near = arcBound(centre, radius, a, middle, from, half);
    const double far = arcBound(centre, radius, middle, b, half, to);
    if (far >= near) {
      arc(centre, radius, middle, b, half, to, far);
      arc(centre, radius, a, middle, from, half, near);
    } else {
      arc(centre, radius, a, middle, from, half, near);
      arc(centre, radius, middle, b, half, to, far);
    }
  }

  /// An arc of length l stays within its sagitta r (1 - cos(l / 2r)) <= l^2 / 8r of its chord.
  static double sagittaOf(double length, double radius) { return length * length / (8.0 * radius); }

  [[nodiscard]] double arcBound(geo::Point centre, double radius, geo::Point a, geo::Point b, double from, double to) const {
    return boundOver({centre.x + a.x, centre.y + a.y}, {centre.x + b.x, centre.y + b.y}, kTouch + sagittaOf(to - from, radius), to);
  }

  [[nodiscard]] double boundOver(geo::Point a, geo::Point b, double grow, double to) const {
    const geo::Box box{std::min(a.x, b.x) - grow, std::min(a.y, b.y) - grow, std::max(a.x, b.x) + grow, std::max(a.y, b.y) + grow};
    return terrain_.upperIn(box) + above_ + loss_.upTo(before_ + to);
  }

  const terrain::TerrainPyramid& terrain_;
  const flight::PieceLoss& loss_;
  double before_;
  double above_;
  double required_;
  double giveUpAbove_;
  double leaf_;
};

/// Cosine and sine of a turn's angle.
struct Turned {
  double cosine = 1.0;
  double sine = 0.0;

  Turned() = default;
  explicit Turned(double angle) : cosine(std::cos(angle)), sine(std::sin(angle)) {}
};

/// A place and a direction of flight, moved on without asking for the heading's sine and cosine again.
struct Flown {
  geo::Point at;
  flight::Direction direction;

  void straight(double length) { at = {at.x + length * direction.east, at.y + length * direction.north}; }
  /// @param side  +1 left, -1 right
  void turn(double side, double radius, Turned turned) {
    const auto [cosine, sine] = turned;
    const geo::Point centre = centreOf(side, radius);
    const flight::Direction after(direction.east * cosine - side * direction.north * sine, side * direction.east * sine + direction.north * cosine);
    at = {centre.x + side * radius * after.north, centre.y - side * radius * after.east};
    direction = after;
  }
  [[nodiscard]] geo::Point centreOf(double side, double radius) const {
    return {at.x - side * radius * direction.north, at.y + side * radius * direction.east};
  }
};

/// The turn in parts of at most a quarter circle, the last first.
/// @param whole  of the whole turn, if that is known
void boundTurn(PieceBound& bound, const Flown& start, double side, double radius, double length, const Turned* whole) {
  const geo::Point centre = start.centreOf(side, radius);
  const int parts = std::max(1, static_cast<int>(std::ceil(length / (0.5 * Angle::kPi * radius))));
  // what the start looks like from the centre, turned back and forth by whole parts
  const auto [cosine, sine] = parts == 1 && whole != nullptr ? *whole : Turned(length / radius / parts);
  std::array<geo::Point, kMostParts + 1> seen;
  seen[0] = {start.at.x - centre.x, start.at.y - centre.y};
  for (int i = 0; i < parts; ++i) {
    const geo::Point& p = seen[static_cast<std::size_t>(i)];
    seen[static_cast<std::size_t>(i) + 1] = {p.x * cosine - side * p.y * sine, side * p.x * sine + p.y * cosine};
  }
  for (int i = parts; i-- > 0;) {
    bound.arc(centre, radius, seen[static_cast<std::size_t>(i)], seen[static_cast<std::size_t>(i) + 1], length * i / parts, length * (i + 1) / parts);
  }
}

/** The highest of `required` and what a piece asks for, both as heights at the start of the whole glide.
 *  @param above   clearance and what the glide has lost when the piece begins [m]
 *  @param turned  of a turn's whole angle, if that is known */
double requiredAlong(const terrain::TerrainPyramid& terrain, const Flown& start, const flight::Piece& piece, const flight::PieceLoss& loss,
                     double above, double required, double giveUpAbove, const Turned* turned = nullptr) {
  if (piece.turn == flight::Turn::Straight) {
    Flown end = start;
    end.straight(piece.length);
    return requiredAlongLine(terrain, start.at, end.at, loss.upTo(1.0), above, required, giveUpAbove);
  }
  const double side = static_cast<double>(static_cast<int>(piece.turn));
  // more than a full circle is flown over the same ground again, which the last round asks most of
  const double circle = 2.0 * Angle::kPi * piece.radius;
  const double before = std::max(0.0, piece.length - circle);
  Flown last = start;
  if (before > 0.0) {
    last.turn(side, piece.radius, Turned(before / piece.radius));
  }
  PieceBound bound(terrain, loss, before, above, required, giveUpAbove);
  boundTurn(bound, last, side, piece.radius, piece.length - before, before > 0.0 ? nullptr : turned);
  return bound.required();
}

double orNone(double required, double giveUpAbove) {
  return required > giveUpAbove ? std::numeric_limits<double>::infinity() : required;
}

}  // namespace

double requiredStartHeight(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, const flight::PieceLoss& loss,
                           double clearance, double endHeight, double giveUpAbove) {
  const Flown flown{start.point(), flight::Direction(start.heading)};
  return orNone(requiredAlong(terrain, flown, piece, loss, clearance, endHeight + loss.upTo(piece.length), giveUpAbove), giveUpAbove);
}

double requiredStartHeight(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, double lossPerMetre,
                           double clearance, double endHeight, double giveUpAbove) {
  return requiredStartHeight(terrain, start, piece, flight::PieceLoss(lossPerMetre), clearance, endHeight, giveUpAbove);
}

double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::TurnLoss losses, double endHeight, double giveUpAbove) {
  return requiredStartHeight(world, path, flight::Direction(path.start.heading), losses, endHeight, giveUpAbove);
}

double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::Direction direction, flight::TurnLoss losses, double endHeight,
                           double giveUpAbove) {
  Flown flown{path.start.point(), direction};
  double course = path.start.heading;
  double required = endHeight + flight::lossOf(path, losses);
  double above = world.clearance;
  // From the start on: the ground there has the least of the glide's loss above it, and is most often what is hopeless.
  for (std::size_t part = 0; part < 3 && required <= giveUpAbove; ++part) {
    const flight::Piece piece = path.piece(part);
    if (piece.length <= 0.0 && part > 0) {
      continue;
    }
    const bool isStraight = piece.turn == flight::Turn::Straight;
    const flight::PieceLoss loss(piece, course, losses);
    const Turned turned = isStraight || part == 2 ? Turned() : Turned(piece.length / path.radius);
    required = requiredAlong(world.terrain, flown, piece, loss, above, required, giveUpAbove, part == 2 ? nullptr : &turned);
    above += loss.upTo(piece.length);
    if (isStraight) {
      flown.straight(piece.length);
    } else if (part < 2) {  // where the last part ends is known
      const double side = static_cast<double>(static_cast<int>(piece.turn));
      flown.turn(side, path.radius, turned);
      course += side * piece.length / path.radius;
    }
  }
  return orNone(required, giveUpAbove);
}

double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::Direction direction, std::size_t radius, double endHeight,
                           double giveUpAbove) {
  const auto needed = [&](const aircraft::GlideModel& cover, double end, double limit) {
    return requiredStartHeight(world, path, direction, flight::turnLossAt(cover, radius), end, limit);
  };
  return aircraft::leastStart(world.glide, endHeight, needed, giveUpAbove);
}

double requiredOverStraight(const World& world, const geo::Pose& start, double length, double endHeight) {
  const flight::Piece straight{flight::Turn::Straight, 0.0, length};
  const auto needed = [&](const aircraft::GlideModel& cover, double end, double /*giveUpAbove*/) {
    const double perMetre = cover.lossOver(std::cos(start.heading), std::sin(start.heading));
    // not finite: the wind holds the aircraft up
    return std::isfinite(perMetre) ? requiredStartHeight(world.terrain, start, straight, perMetre, world.clearance, end) : perMetre;
  };
  return aircraft::leastStart(world.glide, endHeight, needed);
}

double maxTerrainAlong(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece) {
  const double lowest = -1e9;  // below any ground: the search raises it to the bound
  return requiredStartHeight(terrain, start, piece, 0.0, 0.0, lowest);
}

}  // namespace vp::landing
