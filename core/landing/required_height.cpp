#include "core/landing/required_height.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>

namespace vp::landing {
namespace {

/// A cell this close to the curve counts as touched [m]; far above rounding, far below anything flown.
constexpr double kTouch = 1e-3;

/** Branch and bound over one piece: raises `required` until it bounds terrain + clearance + loss on all of it.
 *  Parts are kept by their end points, so halving needs no trigonometry. */
class PieceBound {
public:
  PieceBound(const terrain::TerrainPyramid& terrain, double lossPerMetre, double clearance, double required, double giveUpAbove)
      : terrain_(terrain),
        loss_(lossPerMetre),
        clearance_(clearance),
        required_(required),
        giveUpAbove_(giveUpAbove),
        leaf_(0.5 * terrain.grid().cellSize()) {}

  void straight(geo::Point a, geo::Point b, double from, double to) { straight(a, b, from, to, boundOver(a, b, kTouch, to)); }

  /// a and b as seen from the centre of the turn; at most a quarter circle apart.
  void arc(geo::Point centre, double radius, geo::Point a, geo::Point b, double from, double to) {
    arc(centre, radius, a, b, from, to, arcBound(centre, radius, a, b, from, to));
  }

  [[nodiscard]] double required() const { return required_ > giveUpAbove_ ? std::numeric_limits<double>::infinity() : required_; }

private:
  /// True if the bound of a part settles it: it asks for nothing, or the part is small enough to take it as it is.
  bool settled(double bound, double length) {
    if (bound <= required_ || required_ > giveUpAbove_) {
      return true;
    }
    if (length <= leaf_) {
      required_ = bound;
      return true;
    }
    return false;
  }

  void straight(geo::Point a, geo::Point b, double from, double to, double bound) {
    if (settled(bound, to - from)) {
      return;
    }
    const double half = 0.5 * (from + to);
    const geo::Point middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
    const double near = boundOver(a, middle, kTouch, half);
    const double far = boundOver(middle, b, kTouch, to);
    // The more demanding half first: it settles the other sooner, or shows that the glide is hopeless.
    if (far >= near) {
      straight(middle, b, half, to, far);
      straight(a, middle, from, half, near);
    } else {
      straight(a, middle, from, half, near);
      straight(middle, b, half, to, far);
    }
  }

  void arc(geo::Point centre, double radius, geo::Point a, geo::Point b, double from, double to, double bound) {
    if (settled(bound, to - from)) {
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
  [[nodiscard]] double arcBound(geo::Point centre, double radius, geo::Point a, geo::Point b, double from, double to) const {
    const double sagitta = (to - from) * (to - from) / (8.0 * radius);
    return boundOver({centre.x + a.x, centre.y + a.y}, {centre.x + b.x, centre.y + b.y}, kTouch + sagitta, to);
  }

  [[nodiscard]] double boundOver(geo::Point a, geo::Point b, double grow, double to) const {
    const geo::Box box{std::min(a.x, b.x) - grow, std::min(a.y, b.y) - grow, std::max(a.x, b.x) + grow, std::max(a.y, b.y) + grow};
    return terrain_.upperIn(box) + clearance_ + loss_ * to;
  }

  const terrain::TerrainPyramid& terrain_;
  double loss_;
  double clearance_;
  double required_;
  double giveUpAbove_;
  double leaf_;
};

/// The turn in parts of at most a quarter circle, the last first.
void boundTurn(PieceBound& bound, const geo::Pose& start, const flight::Piece& piece) {
  const double side = static_cast<double>(static_cast<int>(piece.turn));
  const geo::Point centre{start.x - side * piece.radius * std::sin(start.heading), start.y + side * piece.radius * std::cos(start.heading)};
  const double first = start.heading - side * 0.5 * Angle::kPi;
  const auto seenFromCentre = [&](double along) {
    const double angle = first + side * along / piece.radius;
    return geo::Point{piece.radius * std::cos(angle), piece.radius * std::sin(angle)};
  };
  const int parts = std::max(1, static_cast<int>(std::ceil(piece.length / (0.5 * Angle::kPi * piece.radius))));
  geo::Point b = seenFromCentre(piece.length);
  for (int i = parts; i-- > 0;) {
    const geo::Point a = seenFromCentre(piece.length * i / parts);
    bound.arc(centre, piece.radius, a, b, piece.length * i / parts, piece.length * (i + 1) / parts);
    b = a;
  }
}

}  // namespace

double requiredStartHeight(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, double lossPerMetre,
                           double clearance, double endHeight, double giveUpAbove) {
  PieceBound bound(terrain, lossPerMetre, clearance, endHeight + lossPerMetre * piece.length, giveUpAbove);
  if (piece.turn == flight::Turn::Straight) {
    const geo::Pose end = flight::endOf(start, piece);
    bound.straight(start.point(), end.point(), 0.0, piece.length);
  } else {
    boundTurn(bound, start, piece);
  }
  return bound.required();
}

double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::TurnLoss losses, double endHeight, double giveUpAbove) {
  std::array<geo::Pose, 3> starts;
  std::array<flight::Piece, 3> pieces;
  geo::Pose pose = path.start;
  for (std::size_t part = 0; part < 3; ++part) {
    starts[part] = pose;
    pieces[part] = path.piece(part);
    pose = flight::endOf(pose, pieces[part]);
  }
  double height = endHeight;
  double lossBefore = flight::lossOf(path, losses);
  for (std::size_t part = 3; part-- > 0;) {
    const double loss = pieces[part].turn == flight::Turn::Straight ? losses.straight : losses.turn;
    lossBefore -= loss * pieces[part].length;
    if (pieces[part].length <= 0.0 && part > 0) {
      continue;
    }
    height = requiredStartHeight(world.terrain, starts[part], pieces[part], loss, world.clearance, height, giveUpAbove - lossBefore);
    if (height == std::numeric_limits<double>::infinity()) {
      return height;
    }
  }
  return height;
}

double maxTerrainAlong(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece) {
  const double lowest = -1e9;  // below any ground: the search raises it to the bound
  return requiredStartHeight(terrain, start, piece, 0.0, 0.0, lowest);
}

}  // namespace vp::landing
