#include "ui/scene3d/terrain_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::scene3d {
namespace {

constexpr int kQuads = TerrainModel::kTileQuads;
constexpr int kSide = TileMesh::kSide;
constexpr int kPatch = kSide + 2;  ///< the tile's posts and one around them

struct Post {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  bool isUsable = false;
};

/// The posts of a tile and those around it, moved where the known ground ends.
class Patch {
public:
  Patch(const TerrainModel& model, TileId tile) : model_(model), level_(tile.level), west_(tile.column * kQuads), south_(tile.row * kQuads) {
    for (int j = -1; j <= kSide; ++j) {
      for (int i = -1; i <= kSide; ++i) {
        Post& p = posts_[indexOf(i, j)];
        p = makePost(west_ + i, south_ + j);
        isWhole_ = isWhole_ && p.isUsable && std::isfinite(model.post(level_, west_ + i, south_ + j));
      }
    }
  }

  [[nodiscard]] const Post& at(int i, int j) const { return posts_[indexOf(i, j)]; }
  [[nodiscard]] bool isDrawn(int i, int j) const {
    return at(i, j).isUsable && at(i + 1, j).isUsable && at(i, j + 1).isUsable && at(i + 1, j + 1).isUsable;
  }
  [[nodiscard]] bool isUnknown(int i, int j) const { return !std::isfinite(model_.post(level_, west_ + i, south_ + j)); }
  /// Height of the flat ground in a quad that is not drawn or not all known.
  [[nodiscard]] double floorOf(int i, int j) const {
    for (const auto& [di, dj] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
      if (isUnknown(i + di, j + dj)) {
        return model_.floorAt(level_, west_ + i + di, south_ + j + dj);
      }
    }
    return model_.base();
  }
  [[nodiscard]] bool needsLid(int i, int j) const { return floorOf(i, j) > model_.base(); }
  [[nodiscard]] std::array<float, 3> place(int i, int j, double z) const {
    return {static_cast<float>(model_.xOf(level_, west_ + i)), static_cast<float>(model_.yOf(level_, south_ + j)), static_cast<float>(z)};
  }
  /// Everything known, the neighbours included.
  [[nodiscard]] bool isWhole() const { return isWhole_; }

private:
  static std::size_t indexOf(int i, int j) { return static_cast<std::size_t>(j + 1) * kPatch + static_cast<std::size_t>(i + 1); }

  [[nodiscard]] Post makePost(int column, int row) const {
    if (column < 0 || row < 0 || column >= model_.columns(level_) || row >= model_.rows(level_)) {
      return {};
    }
    const float height = model_.post(level_, column, row);
    if (std::isfinite(height)) {
      return {static_cast<float>(model_.xOf(level_, column)), static_cast<float>(model_.yOf(level_, row)), height, true};
    }
    return level_ > 0 ? movedPost(column, row) : Post{};
  }

  /// The place nearest to an unknown post that is still known on a line from a known neighbour.
  [[nodiscard]] Post movedPost(int column, int row) const {
    const int span = 1 << level_;
    const int lastColumn = model_.columns(0) - 1;
    const int lastRow = model_.rows(0) - 1;
    Post best;
    double bestMove = std::numeric_limits<double>::infinity();
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        if (!std::isfinite(model_.post(level_, column + di, row + dj))) {
          continue;
        }
        const int fromColumn = std::min((column + di) * span, lastColumn);
        const int fromRow = std::min((row + dj) * span, lastRow);
        int reached = 0;
        while (reached < span && std::isfinite(model_.post(0, fromColumn - di * (reached + 1), fromRow - dj * (reached + 1)))) {
          ++reached;
        }
        const double move = (span - reached) * std::hypot(di, dj);
        if (reached > 0 && move < bestMove) {
          bestMove = move;
          const int c = fromColumn - di * reached;
          const int r = fromRow - dj * reached;
          best = {static_cast<float>(model_.xOf(0, c)), static_cast<float>(model_.yOf(0, r)), model_.post(0, c, r), true};
        }
      }
    }
    return best;
  }

  const TerrainModel& model_;
  int level_;
  int west_;
  int south_;
  bool isWhole_ = true;
  std::array<Post, static_cast<std::size_t>(kPatch) * kPatch> posts_{};
};

std::uint16_t vertexOf(int i, int j) {
  return static_cast<std::uint16_t>(j * kSide + i);
}

/// Vertex of the skirt below post number `k` of a side: 0 south, 1 east, 2 north, 3 west; all from the side's left end seen from outside.
std::uint16_t skirtVertexOf(int side, int k) {
  return static_cast<std::uint16_t>(kSide * kSide + side * kSide + k);
}

std::pair<int, int> sidePost(int side, int k) {
  switch (side) {
    case 0:
      return {k, 0};
    case 1:
      return {kQuads, k};
    case 2:
      return {kQuads - k, kQuads};
    default:
      return {0, kQuads - k};
  }
}

/// The quad inside the tile that touches edge k of a side.
std::pair<int, int> sideQuad(int side, int k) {
  switch (side) {
    case 0:
      return {k, 0};
    case 1:
      return {kQuads - 1, k};
    case 2:
      return {kQuads - 1 - k, kQuads - 1};
    default:
      return {0, kQuads - 1 - k};
  }
}

template <typename IsDrawn>
std::vector<std::uint16_t> trianglesOf(IsDrawn isDrawn) {
  std::vector<std::uint16_t> triangles;
  triangles.reserve(static_cast<std::size_t>(kQuads * kQuads + 4 * kQuads) * 6);
  for (int j = 0; j < kQuads; ++j) {
    for (int i = 0; i < kQuads; ++i) {
      if (isDrawn(i, j)) {
        triangles.insert(triangles.end(), {vertexOf(i, j), vertexOf(i + 1, j), vertexOf(i + 1, j + 1)});
        triangles.insert(triangles.end(), {vertexOf(i, j), vertexOf(i + 1, j + 1), vertexOf(i, j + 1)});
      }
    }
  }
  for (int side = 0; side < 4; ++side) {
    for (int k = 0; k < kQuads; ++k) {
      const auto [qi, qj] = sideQuad(side, k);
      if (!isDrawn(qi, qj)) {
        continue;
      }
      const auto [ai, aj] = sidePost(side, k);
      const auto [bi, bj] = sidePost(side, k + 1);
      triangles.insert(triangles.end(), {vertexOf(ai, aj), skirtVertexOf(side, k), skirtVertexOf(side, k + 1)});
      triangles.insert(triangles.end(), {vertexOf(ai, aj), skirtVertexOf(side, k + 1), vertexOf(bi, bj)});
    }
  }
  return triangles;
}

/// Walls where a drawn quad has no drawn neighbour.
void addWalls(TileMesh& mesh, const Patch& patch) {
  const auto add = [&](const Post& a, const Post& b, double floor) {
    const auto bottom = static_cast<float>(floor);
    mesh.wallQuads.push_back({a.x, a.y, a.z});
    mesh.wallQuads.push_back({b.x, b.y, b.z});
    mesh.wallQuads.push_back({b.x, b.y, bottom});
    mesh.wallQuads.push_back({a.x, a.y, bottom});
  };
  for (int j = 0; j < kQuads; ++j) {
    for (int i = 0; i < kQuads; ++i) {
      if (!patch.isDrawn(i, j)) {
        continue;
      }
      if (!patch.isDrawn(i, j - 1)) {
        add(patch.at(i, j), patch.at(i + 1, j), patch.floorOf(i, j - 1));
      }
      if (!patch.isDrawn(i + 1, j)) {
        add(patch.at(i + 1, j), patch.at(i + 1, j + 1), patch.floorOf(i + 1, j));
      }
      if (!patch.isDrawn(i, j + 1)) {
        add(patch.at(i + 1, j + 1), patch.at(i, j + 1), patch.floorOf(i, j + 1));
      }
      if (!patch.isDrawn(i - 1, j)) {
        add(patch.at(i, j + 1), patch.at(i, j), patch.floorOf(i - 1, j));
      }
    }
  }
}

/// Flat ground in all quads that are not known to their corners; under the drawn part of such a quad it is hidden.
void addLids(TileMesh& mesh, const Patch& patch) {
  for (int j = 0; j < kQuads; ++j) {
    for (int i = 0; i < kQuads; ++i) {
      if (patch.needsLid(i, j)) {
        const double z = patch.floorOf(i, j);
        mesh.lidQuads.insert(mesh.lidQuads.end(),
                             {patch.place(i, j, z), patch.place(i + 1, j, z), patch.place(i + 1, j + 1, z), patch.place(i, j + 1, z)});
      }
    }
  }
}

}  // namespace

const std::vector<std::uint16_t>& wholeTileTriangles() {
  static const std::vector<std::uint16_t> triangles = trianglesOf([](int, int) { return true; });
  return triangles;
}

TileMesh buildTileMesh(const TerrainModel& model, TileId tile) {
  const Patch patch(model, tile);
  TileMesh mesh;
  mesh.isWhole = patch.isWhole();
  const double cell = model.terrain().grid->cellSize();
  const double west = model.xOf(0, 0) + static_cast<double>(tile.column) * kQuads * cell * std::exp2(tile.level);
  const double south = model.yOf(0, 0) + static_cast<double>(tile.row) * kQuads * cell * std::exp2(tile.level);
  const double side = kQuads * cell * std::exp2(tile.level);
  // texel centres lie on the tile's sides, so that neighbouring pictures agree there
  const auto textureAt = [&](const Post& p) -> std::array<float, 2> {
    const auto to = [&](double from, double value) {
      return static_cast<float>((0.5 + (value - from) / side * (TileTexture::kSide - 1)) / TileTexture::kSide);
    };
    return {to(west, static_cast<double>(p.x)), to(south, static_cast<double>(p.y))};
  };
  const Bounds bounds = model.boundsOf(tile);
  const double depth = bounds.isEmpty() ? 0.0 : std::min(bounds.high.z - bounds.low.z, side / kQuads) + 0.1 * cell;
  mesh.vertices.reserve(std::size_t{kSide} * (kSide + 4));
  mesh.textureAt.reserve(mesh.vertices.capacity());
  const auto add = [&](const Post& p, double lowered) {
    // a post that is not drawn stands anywhere harmless, so that the tile's bounds stay right
    const float z = p.isUsable ? p.z - static_cast<float>(lowered) : static_cast<float>(bounds.isEmpty() ? 0.0 : bounds.low.z);
    mesh.vertices.push_back({p.isUsable ? p.x : static_cast<float>(west), p.isUsable ? p.y : static_cast<float>(south), z});
    mesh.textureAt.push_back(textureAt(p));
  };
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      add(patch.at(i, j), 0.0);
    }
  }
  for (int s = 0; s < 4; ++s) {
    for (int k = 0; k < kSide; ++k) {
      const auto [i, j] = sidePost(s, k);
      add(patch.at(i, j), depth);
    }
  }
  if (mesh.isWhole) {
    return mesh;
  }
  mesh.triangles = trianglesOf([&](int i, int j) { return patch.isDrawn(i, j); });
  addWalls(mesh, patch);
  addLids(mesh, patch);
  return mesh;
}

}  // namespace vp::scene3d
