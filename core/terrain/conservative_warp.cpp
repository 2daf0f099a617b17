#include "core/terrain/conservative_warp.h"

#include "core/base/expect.h"
#include "core/terrain/elevation_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::terrain::detail {
namespace {

constexpr int kPatch = 16;            ///< cells along the side of a patch
constexpr double kFloatNoise = 1e-6;  ///< posts; a source aligned with the grid must not touch its neighbours by rounding
constexpr double kErrorSafety = 2.0;  ///< over the deviation seen at the middles; covers a jump between two operations of PROJ too

/// Post coordinates at the nodes of one line of the lattice, two nodes to a patch and one at the end.
struct NodeLine {
  std::vector<double> u;
  std::vector<double> v;
};

/// Half-open range of cells.
struct CellRange {
  int column0 = 0;
  int row0 = 0;
  int column1 = 0;
  int row1 = 0;
};

/// Cells of the layout that the mosaic can reach: its outline in the frame and some cells more.
CellRange reachOf(const Mosaic& mosaic, CrsTransform& toFrame, const GridLayout& layout) {
  std::vector<double> x;
  std::vector<double> y;
  for (const geo::Point& post : outline(mosaic.columns, mosaic.rows)) {
    const geo::Point at = mosaic.posts.apply(post);
    x.push_back(at.x);
    y.push_back(at.y);
  }
  toFrame.apply(x, y);
  geo::Box box;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i])) {
      return {0, 0, layout.columns, layout.rows};
    }
    box.add({x[i], y[i]});
  }
  const auto index = [&layout](double at, double origin, int count) {
    return static_cast<int>(std::clamp(std::floor((at - origin) / layout.cell), -4.0, count + 4.0));
  };
  constexpr int kSpare = 3;
  return {std::max(0, index(box.minX, layout.originX, layout.columns) - kSpare), std::max(0, index(box.minY, layout.originY, layout.rows) - kSpare),
          std::min(layout.columns, index(box.maxX, layout.originX, layout.columns) + 1 + kSpare),
          std::min(layout.rows, index(box.maxY, layout.originY, layout.rows) + 1 + kSpare)};
}

/// Replaces each post by the highest of the 2 x 2 posts east and below: the upper bound between the posts of a mesh.
void toMeshMaxima(const Mosaic& mosaic, std::vector<float>& posts, const Job& job) {
  const auto columns = static_cast<std::size_t>(mosaic.columns);
  for (std::size_t row = 0; row + 1 < static_cast<std::size_t>(mosaic.rows); ++row) {
    if (row % 64 == 0 && job.stopRequested()) {
      return;  // the warp that follows reports it
    }
    float* here = posts.data() + row * columns;
    const float* below = here + columns;
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      here[column] = std::max(std::max(here[column], here[column + 1]), std::max(below[column], below[column + 1]));
    }
  }
}

class Warp {
public:
  Warp(const Mosaic& mosaic, const std::vector<float>& meshes, CrsTransform toSource, const GridLayout& layout, CellRange range,
       std::vector<float>& grid)
      : mosaic_(mosaic), meshes_(meshes), toSource_(std::move(toSource)), layout_(layout), range_(range), grid_(grid) {
    const auto inverse = mosaic.posts.inverse();
    VP_EXPECT(inverse.has_value());
    toPosts_ = *inverse;
    centreX_ = mosaic.posts.apply({0.5 * (mosaic.columns - 1), 0.5 * (mosaic.rows - 1)}).x;
    patches_ = (range.column1 - range.column0 + kPatch - 1) / kPatch;
  }

  Result<void> run(const Job& job) {
    readLine(range_.row0, lines_[2]);
    for (int row = range_.row0; row < range_.row1; row += kPatch) {
      if (job.stopRequested()) {
        return fail(Errc::Cancelled, "reading the terrain was stopped");
      }
      std::swap(lines_[0], lines_[2]);
      readLine(row + 0.5 * kPatch, lines_[1]);
      readLine(row + kPatch, lines_[2]);
      for (int patch = 0; patch < patches_; ++patch) {
        warpPatch(row, patch);
      }
      job.progress(static_cast<double>(row - range_.row0) / (range_.row1 - range_.row0), "terrain: warping to the local frame");
    }
    return {};
  }

private:
  void readLine(double row, NodeLine& line) {
    const std::size_t nodes = 2 * static_cast<std::size_t>(patches_) + 1;
    line.u.resize(nodes);
    line.v.assign(nodes, layout_.originY + row * layout_.cell);
    for (std::size_t i = 0; i < nodes; ++i) {
      line.u[i] = layout_.originX + (range_.column0 + 0.5 * kPatch * static_cast<double>(i)) * layout_.cell;
    }
    toSource_.apply(line.u, line.v);
    for (std::size_t i = 0; i < nodes; ++i) {
      double x = line.u[i];
      if (mosaic_.turn > 0.0) {
        x = centreX_ + std::remainder(x - centreX_, mosaic_.turn);
      }
      const geo::Point post = toPosts_.apply({x, line.v[i]});
      line.u[i] = post.x;
      line.v[i] = post.y;
    }
  }

  /// Bound of |true - bilinear| over a patch from its 3 x 3 nodes: the bilinear map lacks the second derivatives along
  /// the two axes, and each shows in the deviation of a middle node from the mean of its neighbours.
  [[nodiscard]] double deviation(std::vector<double> NodeLine::*axis, std::size_t node) const {
    double alongRow = 0.0;
    double alongColumn = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& line = lines_[k].*axis;
      alongRow = std::max(alongRow, std::abs(line[node + 1] - 0.5 * (line[node] + line[node + 2])));
      const double middle = 0.5 * ((lines_[0].*axis)[node + k] + (lines_[2].*axis)[node + k]);
      alongColumn = std::max(alongColumn, std::abs((lines_[1].*axis)[node + k] - middle));
    }
    return kErrorSafety * (alongRow + alongColumn) + mosaic_.misfit - kFloatNoise;
  }

  [[nodiscard]] bool isComplete(std::size_t node) const {
    for (const NodeLine& line : lines_) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!std::isfinite(line.u[node + k]) || !std::isfinite(line.v[node + k])) {
          return false;
        }
      }
    }
    return true;
  }

  void warpPatch(int row0, int patch) {
    const std::size_t node = 2 * static_cast<std::size_t>(patch);
    if (!isComplete(node)) {
      return;
    }
    const double marginU = deviation(&NodeLine::u, node);
    const double marginV = deviation(&NodeLine::v, node);
    const int column0 = range_.column0 + patch * kPatch;
    const int columns = std::min(kPatch, range_.column1 - column0);
    const int rows = std::min(kPatch, range_.row1 - row0);
    std::array<double, kPatch + 1> southU{};
    std::array<double, kPatch + 1> southV{};
    std::array<double, kPatch + 1> northU{};
    std::array<double, kPatch + 1> northV{};
    cornersAt(0, node, northU, northV);
    for (int row = 0; row < rows; ++row) {
      std::swap(southU, northU);
      std::swap(southV, northV);
      cornersAt(row + 1, node, northU, northV);
      float* out = grid_.data() + static_cast<std::size_t>(row0 + row) * static_cast<std::size_t>(layout_.columns) + column0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i) {
        const double minU = std::min(std::min(southU[i], southU[i + 1]), std::min(northU[i], northU[i + 1])) - marginU;
        const double maxU = std::max(std::max(southU[i], southU[i + 1]), std::max(northU[i], northU[i + 1])) + marginU;
        const double minV = std::min(std::min(southV[i], southV[i + 1]), std::min(northV[i], northV[i + 1])) - marginV;
        const double maxV = std::max(std::max(southV[i], southV[i + 1]), std::max(northV[i], northV[i + 1])) + marginV;
        const float value = highest(minU, maxU, minV, maxV);
        out[i] = value == kUnknownUpper ? out[i] : (out[i] == kUnknownUpper ? value : std::max(out[i], value));
      }
    }
  }

  void cornersAt(int row, std::size_t node, std::array<double, kPatch + 1>& u, std::array<double, kPatch + 1>& v) const {
    const double t = static_cast<double>(row) / kPatch;
    const double westU = std::lerp(lines_[0].u[node], lines_[2].u[node], t);
    const double eastU = std::lerp(lines_[0].u[node + 2], lines_[2].u[node + 2], t);
    const double westV = std::lerp(lines_[0].v[node], lines_[2].v[node], t);
    const double eastV = std::lerp(lines_[0].v[node + 2], lines_[2].v[node + 2], t);
    for (std::size_t i = 0; i <= kPatch; ++i) {
      const double s = static_cast<double>(i) / kPatch;
      u[i] = westU + (eastU - westU) * s;
      v[i] = westV + (eastV - westV) * s;
    }
  }

  /// Highest post around any point of a box of post coordinates; unknown if it reaches out of the mosaic.
  [[nodiscard]] float highest(double minU, double maxU, double minV, double maxV) const {
    const bool isInside = minU >= 0.0 && minV >= 0.0 && maxU <= mosaic_.columns - 1.0 && maxV <= mosaic_.rows - 1.0;
    if (!isInside) {
      return kUnknownUpper;
    }
    // meshes from floor(min) to ceil(max) - 1, at least one; all values are positive, so truncation is floor
    const int column0 = std::min(static_cast<int>(minU), mosaic_.columns - 2);
    const int row0 = std::min(static_cast<int>(minV), mosaic_.rows - 2);
    const int column1 = std::max(column0, lastBelow(maxU));
    const int row1 = std::max(row0, lastBelow(maxV));
    float value = -kUnknownUpper;
    for (int row = row0; row <= row1; ++row) {
      const float* line = meshes_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(mosaic_.columns);
      for (int column = column0; column <= column1; ++column) {
        value = std::max(value, line[column]);
      }
    }
    return value;
  }

  /// ceil(at) - 1 for at >= 0.
  static int lastBelow(double at) {
    const int whole = static_cast<int>(at);
    return at > static_cast<double>(whole) ? whole : whole - 1;
  }

  const Mosaic& mosaic_;
  const std::vector<float>& meshes_;
  CrsTransform toSource_;
  const GridLayout& layout_;
  CellRange range_;
  std::vector<float>& grid_;
  PostTransform toPosts_;
  double centreX_ = 0.0;
  int patches_ = 0;
  std::array<NodeLine, 3> lines_;  ///< south, middle and north of the row of patches at work
};

}  // namespace

Result<Crs> crsOf(const geo::LocalFrame& frame) {
  return crsFrom(frame.projString());
}

std::vector<geo::Point> outline(int columns, int rows) {
  constexpr int kSteps = 128;
  const double east = columns - 1.0;
  const double bottom = rows - 1.0;
  std::vector<geo::Point> points;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    points.push_back({t * east, 0.0});
    points.push_back({t * east, bottom});
    points.push_back({0.0, t * bottom});
    points.push_back({east, t * bottom});
  }
  return points;
}

Result<void> warpInto(const Mosaic& mosaic, std::vector<float>& posts, const Crs& frame, const GridLayout& layout, std::vector<float>& grid,
                      const Job& job) {
  VP_EXPECT(posts.size() == mosaic.size() && grid.size() == layout.size());
  auto toFrame = CrsTransform::between(mosaic.crs, frame);
  if (!toFrame) {
    return forward(toFrame);
  }
  auto toSource = CrsTransform::between(frame, mosaic.crs);
  if (!toSource) {
    return forward(toSource);
  }
  toMeshMaxima(mosaic, posts, job);
  const CellRange range = reachOf(mosaic, *toFrame, layout);
  return Warp(mosaic, posts, std::move(*toSource), layout, range, grid).run(job);
}

}  // namespace vp::terrain::detail
