#include "core/landing/lattice_ground.h"

#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::landing {
namespace {

/// A cell this close to the curve counts as touched [m]; as in required_height.cpp, plus a micrometre for the two roundings.
constexpr double kTouch = 1e-3 + 1e-6;
/// Parts of a curve that are looked at as boxes, per cell: short enough that few cells are counted that the curve misses.
constexpr double kPartsPerCell = 16.0;

/// Cells touched by a curve, as offsets from the cell whose centre is the origin, with the latest loss at which they are.
class TouchedCells {
public:
  /// @param reach  largest offset in cells
  TouchedCells(double cell, int reach) : perCell_(1.0 / cell), reach_(reach), side_(2 * reach + 1) {
    latest_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), -1.0);
  }

  void add(const geo::Box& box, double loss) {
    const int east = cellOf(box.maxX + kTouch);
    const int north = cellOf(box.maxY + kTouch);
    for (int row = cellOf(box.minY - kTouch); row <= north; ++row) {
      for (int column = cellOf(box.minX - kTouch); column <= east; ++column) {
        double& latest = latest_[placeOf(row, column)];
        if (latest < 0.0) {
          touched_.emplace_back(row, column);
        }
        latest = std::max(latest, loss);
      }
    }
  }

  /// Passes (row, column, loss) of each touched cell to `use`, and forgets them.
  template <typename Use>
  void drain(Use use) {
    for (const auto& [row, column] : touched_) {
      double& latest = latest_[placeOf(row, column)];
      use(row, column, latest);
      latest = -1.0;
    }
    touched_.clear();
  }

private:
  [[nodiscard]] std::size_t placeOf(int row, int column) const {
    return static_cast<std::size_t>(row + reach_) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column + reach_);
  }
  [[nodiscard]] int cellOf(double coordinate) const { return static_cast<int>(std::floor(coordinate * perCell_ + 0.5)); }

  double perCell_;
  int reach_;
  int side_;
  std::vector<double> latest_;  ///< below zero: not touched
  std::vector<std::pair<int, int>> touched_;
};

/// Adds the cells that a piece touches; places are kept by turning a vector, so that the parts need no trigonometry.
void touch(const geo::Pose& start, const flight::Piece& piece, double lost, const flight::PieceLoss& loss, double cell, TouchedCells& touched) {
  const int parts = std::max(1, static_cast<int>(std::ceil(piece.length / cell * kPartsPerCell)));
  const double length = piece.length / parts;
  const double side = static_cast<double>(static_cast<int>(piece.turn));
  const double angle = piece.turn == flight::Turn::Straight ? 0.0 : side * length / piece.radius;
  const double sagitta = piece.turn == flight::Turn::Straight ? 0.0 : length * length / (8.0 * piece.radius);
  const double chord = piece.turn == flight::Turn::Straight ? length : 2.0 * piece.radius * std::sin(0.5 * length / piece.radius);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  double east = chord * std::cos(start.heading + 0.5 * angle);
  double north = chord * std::sin(start.heading + 0.5 * angle);
  geo::Point at = start.point();
  for (int i = 0; i < parts; ++i) {
    geo::Box box;
    box.add(at);
    at = {at.x + east, at.y + north};
    box.add(at);
    touched.add(box.grown(sagitta), lost + loss.upTo(length * (i + 1)));
    const double turned = east * cosine - north * sine;
    north = east * sine + north * cosine;
    east = turned;
  }
}

}  // namespace

LatticeGround::LatticeGround(const World& world, const LatticeGlides& glides) {
  const double cell = world.terrain.grid().cellSize();
  cell_ = cell;
  perStep_ = static_cast<int>(std::lround(glides.primitives.step / cell));
  // a Dubins path strays from the box of its ends by at most two circles
  double largest = 0.0;
  for (const RadiusLoss& radius : glides.radii) {
    largest = std::max(largest, radius.radius);
  }
  margin_ = glides.primitives.reach * perStep_ + static_cast<int>(std::ceil(4.0 * largest / cell)) + 2;
  latticeColumns_ = glides.columns;
  copyGround(world, glides);
  addCover(glides, glides.glide);
  boundSurroundings(world, glides);
}

void LatticeGround::copyGround(const World& world, const LatticeGlides& glides) {
  const terrain::ElevationGrid& grid = world.terrain.grid();
  columns_ = (glides.columns - 1) * perStep_ + 1 + 2 * margin_;
  const int rows = (glides.rows - 1) * perStep_ + 1 + 2 * margin_;
  const int firstColumn = static_cast<int>(std::floor((glides.originX - grid.originX()) / grid.cellSize())) - margin_;
  const int firstRow = static_cast<int>(std::floor((glides.originY - grid.originY()) / grid.cellSize())) - margin_;
  ground_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), terrain::kUnknownUpper);
  for (int row = std::max(0, -firstRow); row < std::min(rows, grid.rows() - firstRow); ++row) {
    float* out = &ground_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
    for (int column = std::max(0, -firstColumn); column < std::min(columns_, grid.columns() - firstColumn); ++column) {
      const float upper = grid.upperInCell(firstColumn + column, firstRow + row);
      out[column] = upper < terrain::kUnknownUpper ? roundedUp(static_cast<double>(upper) + world.clearance) : terrain::kUnknownUpper;
    }
  }
}

void LatticeGround::boundSurroundings(const World& world, const LatticeGlides& glides) {
  const double reach = reach_ * world.terrain.grid().cellSize();
  around_.reserve(static_cast<std::size_t>(glides.columns) * static_cast<std::size_t>(glides.rows));
  for (int row = 0; row < glides.rows; ++row) {
    for (int column = 0; column < glides.columns; ++column) {
      const double x = glides.originX + column * glides.primitives.step;
      const double y = glides.originY + row * glides.primitives.step;
      around_.push_back(roundedUp(world.terrain.upperIn({x - reach, y - reach, x + reach, y + reach}) + world.clearance));
    }
  }
}

std::size_t LatticeGround::addCover(const LatticeGlides& glides, const aircraft::GlideModel& glide) {
  TouchedCells touched(cell_, margin_);
  const GlidePrimitives& set = glides.primitives;
  Cover& cover = covers_.emplace_back();
  cover.stencils.resize(set.arrivals.size());
  cover.losses.resize(set.arrivals.size());
  for (std::size_t heading = 0; heading < set.arrivals.size(); ++heading) {
    for (const GlidePrimitive& primitive : set.arrivals[heading]) {
      const RadiusLoss& radius = glides.radii[primitive.radius];
      const flight::TurnLoss losses = radius.lossBy(glide);
      const geo::Pose start{-primitive.columns * set.step, -primitive.rows * set.step, set.headings[static_cast<std::size_t>(primitive.from)]};
      const geo::Pose end{0.0, 0.0, set.headings[heading]};
      const auto path = flight::dubinsWord(start, end, radius.radius, primitive.word);
      VP_EXPECT(path.has_value());
      geo::Pose pose = start;
      double lost = 0.0;
      for (std::size_t part = 0; part < 3; ++part) {
        const flight::Piece piece = path->piece(part);
        const flight::PieceLoss loss(piece, pose.heading, losses);
        touch(pose, piece, lost, loss, cell_, touched);
        lost += loss.upTo(piece.length);
        pose = flight::endOf(pose, piece);
      }
      Stencil stencil;
      stencil.first = static_cast<std::uint32_t>(cover.cells.size());
      touched.drain([&](int row, int column, double loss) {
        reach_ = std::max({reach_, std::abs(row), std::abs(column)});
        cover.cells.push_back({row * columns_ + column, roundedUp(loss + kRoundingOfSum)});
      });
      while ((cover.cells.size() - stencil.first) % kTogether != 0) {
        cover.cells.push_back(cover.cells.back());
      }
      stencil.end = static_cast<std::uint32_t>(cover.cells.size());
      cover.stencils[heading].push_back(stencil);
      cover.losses[heading].push_back(lost);
    }
  }
  return covers_.size() - 1;
}

}  // namespace vp::landing
