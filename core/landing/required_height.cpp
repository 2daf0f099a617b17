#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>

#include "core/flight/curve_sampling.h"

namespace vp::landing {
namespace {

/// A cell this close to the curve counts as touched [m]; far above rounding, far below anything flown.
constexpr double kTouch = 1e-3;

/** Where a straight piece is: no trigonometry per part. */
class StraightBox {
public:
  StraightBox(const geo::Pose& start, const flight::Piece& /*piece*/) : start_(start), c_(std::cos(start.heading)), s_(std::sin(start.heading)) {}
  [[nodiscard]] geo::Box operator()(double from, double to) const {
    const double x0 = start_.x + from * c_;
    const double x1 = start_.x + to * c_;
    const double y0 = start_.y + from * s_;
    const double y1 = start_.y + to * s_;
    return {std::min(x0, x1) - kTouch, std::min(y0, y1) - kTouch, std::max(x0, x1) + kTouch, std::max(y0, y1) + kTouch};
  }

private:
  const geo::Pose& start_;
  double c_;
  double s_;
};

class ArcBox {
public:
  ArcBox(const geo::Pose& start, const flight::Piece& piece) : start_(start), piece_(piece) {}
  [[nodiscard]] geo::Box operator()(double from, double to) const { return flight::boxOf(start_, piece_, from, to).grown(kTouch); }

private:
  const geo::Pose& start_;
  const flight::Piece& piece_;
};

/** Branch and bound over one piece: raises `required` until it bounds terrain + clearance + loss on all of it. */
template <typename BoxOf>
class PieceBound {
public:
  PieceBound(const terrain::TerrainPyramid& terrain, BoxOf box, double lossPerMetre, double clearance, double required, double giveUpAbove)
      : terrain_(terrain), box_(box), loss_(lossPerMetre), clearance_(clearance), required_(required), giveUpAbove_(giveUpAbove),
        leaf_(0.5 * terrain.grid().cellSize()) {}

  double raise(double length) {
    visit(0.0, length);
    return required_ > giveUpAbove_ ? std::numeric_limits<double>::infinity() : required_;
  }

private:
  void visit(double from, double to) {
    const double bound = terrain_.upperIn(box_(from, to)) + clearance_ + loss_ * to;
    if (bound <= required_) {
      return;
    }
    if (to - from <= leaf_) {
      required_ = bound;
      return;
    }
    // The far half first: more height is lost up to there, so it often bounds the near half too.
    const double middle = 0.5 * (from + to);
    visit(middle, to);
    if (required_ <= giveUpAbove_) {
      visit(from, middle);
    }
  }

  const terrain::TerrainPyramid& terrain_;
  BoxOf box_;
  double loss_;
  double clearance_;
  double required_;
  double giveUpAbove_;
  double leaf_;
};

}  // namespace

double requiredStartHeight(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, double lossPerMetre,
                           double clearance, double endHeight, double giveUpAbove) {
  const double required = endHeight + lossPerMetre * piece.length;
  if (piece.turn == flight::Turn::Straight) {
    return PieceBound(terrain, StraightBox(start, piece), lossPerMetre, clearance, required, giveUpAbove).raise(piece.length);
  }
  return PieceBound(terrain, ArcBox(start, piece), lossPerMetre, clearance, required, giveUpAbove).raise(piece.length);
}

double requiredStartHeight(const World& world, const flight::DubinsPath& path, double endHeight, double giveUpAbove) {
  const double turnLoss = world.glide.lossAt(path.radius);
  const double straightLoss = world.glide.straightLoss();
  std::array<geo::Pose, 3> starts;
  std::array<flight::Piece, 3> pieces;
  geo::Pose pose = path.start;
  for (std::size_t part = 0; part < 3; ++part) {
    starts[part] = pose;
    pieces[part] = path.piece(part);
    pose = flight::endOf(pose, pieces[part]);
  }
  double height = endHeight;
  double lossBefore = turnLoss * path.turned() + straightLoss * path.straight();
  for (std::size_t part = 3; part-- > 0;) {
    const double loss = pieces[part].turn == flight::Turn::Straight ? straightLoss : turnLoss;
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
