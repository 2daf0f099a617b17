#pragma once

#include "ui/document/terrain_data.h"
#include "ui/scene3d/scene_math.h"
#include "ui/scene3d/unknown_regions.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace vp::scene3d {

/** A tile of the terrain: kTileQuads x kTileQuads quads between the posts of one level of detail. */
struct TileId {
  int level = 0;
  int column = 0;
  int row = 0;
  auto operator<=>(const TileId&) const = default;
};

/** Terrain made ready for drawing: posts at the centres of the grid's cells, and ever coarser levels of them.
 *
 *  Post i of level l stands on post min(i * 2^l, last) of level 0, so tiles of different levels meet on common posts. Its
 *  height is a binomial mean of the grid's upper bounds around it (5 x 5 on level 0, 3 x 3 posts on the others): a picture, and
 *  no bound. A post is known exactly where the grid's cell is: nothing is filled in. Heights m MSL, without exaggeration.
 *  @threads const members are pure   @cost about 40 ns per cell to build, 5.7 bytes per cell in memory */
class TerrainModel {
public:
  static constexpr int kTileQuads = 16;

  /** @return nothing if asked to stop. @pre terrain is not null, its grid has at least 2 x 2 cells */
  static std::shared_ptr<const TerrainModel> build(std::shared_ptr<const document::TerrainData> terrain, const std::stop_token& stop = {});

  [[nodiscard]] const document::TerrainData& terrain() const { return *terrain_; }
  [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }  ///< the last has one tile
  [[nodiscard]] int columns(int level) const { return levels_[static_cast<std::size_t>(level)].columns; }
  [[nodiscard]] int rows(int level) const { return levels_[static_cast<std::size_t>(level)].rows; }

  /** Height of a post [m MSL]; infinity if unknown or outside. */
  [[nodiscard]] float post(int level, int column, int row) const;
  /** True if some cell that a post of a level stands for is unknown. Outside is unknown. */
  [[nodiscard]] bool touchesUnknown(int level, int column, int row) const;
  [[nodiscard]] double xOf(int level, int column) const;
  [[nodiscard]] double yOf(int level, int row) const;

  [[nodiscard]] double lowest() const { return terrain_->lowest; }
  [[nodiscard]] double highest() const { return terrain_->highest; }
  [[nodiscard]] double base() const { return base_; }                 ///< of the relief model: unknown ground is drawn flat here
  [[nodiscard]] const geo::Box& extent() const { return extent_; }    ///< of the outermost posts
  [[nodiscard]] const geo::Box& known() const { return knownArea_; }  ///< smallest box around all known posts; empty if there is none

  /** Ground as drawn in full detail: between known posts; nothing elsewhere. */
  [[nodiscard]] std::optional<double> heightAt(geo::Point p) const;
  /** The same; where it is unknown the lid over it or the base. */
  [[nodiscard]] double surfaceAt(geo::Point p) const;
  /** Flat height at which an unknown post is drawn: the lid of the region it lies in, else the base. Outside: the base. */
  [[nodiscard]] double floorAt(int level, int column, int row) const;
  /** True if an unknown post lies in a region with a lid. */
  [[nodiscard]] bool hasLid(int level, int column, int row) const;

  /** Where a ray from `eye` meets the ground or the base; scene space. @return nothing within `reach` metres */
  [[nodiscard]] std::optional<Vec3> hit(Vec3 eye, Vec3 direction, double exaggeration, double reach) const;
  /** True if no ground stands between two points; scene space. */
  [[nodiscard]] bool isClear(Vec3 from, Vec3 to, double exaggeration) const;

  /// Number of tiles of a level to the east and to the north.
  [[nodiscard]] int tileColumns(int level) const;
  [[nodiscard]] int tileRows(int level) const;
  /** Extent of a tile with all that is below it; lids included; heights of level 0, no exaggeration. Empty if nothing in it is drawn. */
  [[nodiscard]] Bounds boundsOf(TileId tile) const;

private:
  struct Level {
    int columns = 0;
    int rows = 0;
    const float* heights = nullptr;
    std::vector<float> storage;
    std::vector<std::uint8_t> unknown;       ///< levels above 0
    std::vector<std::pair<float, float>> z;  ///< lowest and highest of each tile; lowest > highest: nothing drawn
  };
  TerrainModel() = default;
  [[nodiscard]] std::optional<double> meets(Vec3 eye, Vec3 direction, double exaggeration, double reach, double leastStep) const;
  static Level coarser(const Level& fine, const std::stop_token& stop);
  void addTileRanges(const std::stop_token& stop);

  std::shared_ptr<const document::TerrainData> terrain_;
  std::vector<Level> levels_;
  geo::Box extent_;
  geo::Box knownArea_;
  UnknownRegions unknown_;
  double base_ = 0.0;
};

}  // namespace vp::scene3d
