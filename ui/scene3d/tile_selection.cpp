#include "ui/scene3d/tile_selection.h"

#include <queue>

#include <algorithm>
#include <cmath>

namespace vp::scene3d {
namespace {

Bounds sceneBounds(const TerrainModel& model, TileId tile, double exaggeration) {
  Bounds bounds = model.boundsOf(tile);
  bounds.low.z *= exaggeration;
  bounds.high.z *= exaggeration;
  return bounds;
}

/// Pixels that a quad of a tile takes where the tile is nearest.
double quadPixels(const TerrainModel& model, TileId tile, const Bounds& bounds, const CameraState& camera) {
  const auto beyond = [](double low, double high, double v) { return std::max({low - v, v - high, 0.0}); };
  const Vec3 gap{beyond(bounds.low.x, bounds.high.x, camera.eye.x), beyond(bounds.low.y, bounds.high.y, camera.eye.y),
                 beyond(bounds.low.z, bounds.high.z, camera.eye.z)};
  const double quad = model.terrain().grid->cellSize() * std::exp2(tile.level);
  return quad * camera.pixelsPerMetre(std::max(length(gap), quad));
}

struct Candidate {
  double pixels = 0.0;
  TileId tile;
  bool operator<(const Candidate& o) const { return pixels != o.pixels ? pixels < o.pixels : o.tile < tile; }
};

}  // namespace

TileChoice chooseTiles(const TerrainModel& model, const CameraState& camera, double exaggeration, const TerrainDetail& detail,
                       const std::function<bool(TileId)>& isThere) {
  TileChoice choice;
  std::priority_queue<Candidate> open;
  const auto candidate = [&](TileId tile) -> std::optional<Candidate> {
    const Bounds bounds = sceneBounds(model, tile, exaggeration);
    if (bounds.isEmpty() || !camera.maySee(bounds)) {
      return std::nullopt;
    }
    return Candidate{quadPixels(model, tile, bounds, camera), tile};
  };
  if (const auto root = candidate({model.levels() - 1, 0, 0})) {
    open.push(*root);
  }
  std::vector<Candidate> parts;
  while (!open.empty()) {
    const Candidate next = open.top();
    open.pop();
    const auto count = static_cast<int>(open.size() + choice.shown.size());
    bool isSplit = next.tile.level > 0 && next.pixels > detail.quadSize && count + 4 <= detail.tiles;
    if (isSplit) {
      parts.clear();
      bool allThere = true;
      const int level = next.tile.level - 1;
      for (int k = 0; k < 4; ++k) {
        const TileId part{level, 2 * next.tile.column + k % 2, 2 * next.tile.row + k / 2};
        if (part.column >= model.tileColumns(level) || part.row >= model.tileRows(level)) {
          continue;
        }
        if (const auto c = candidate(part)) {
          parts.push_back(*c);
          if (!isThere(part)) {
            allThere = false;
            choice.wanted.push_back(part);
          }
        }
      }
      isSplit = allThere;
    }
    if (isSplit) {
      for (const Candidate& part : parts) {
        open.push(part);
      }
    } else {
      choice.shown.push_back(next.tile);
    }
  }
  return choice;
}

}  // namespace vp::scene3d
