#pragma once

#include "ui/scene3d/terrain_model.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vp::scene3d {

/** Geometry of a tile: quads between known posts, a skirt along its sides that hides the cracks to coarser neighbours, and
 *  walls down to the base or to a flat lid where the known ground ends. East, north, metres MSL; no exaggeration.
 *
 *  On coarse levels a post that is unknown but has a known neighbour is moved towards it, onto the last known post of level
 *  0 between them: so the edge of the known ground keeps its shape, and no quad reaches into the unknown. */
struct TileMesh {
  static constexpr int kSide = TerrainModel::kTileQuads + 1;

  std::vector<std::array<float, 3>> vertices;  ///< kSide * kSide posts from the south-west, then those of the skirt
  std::vector<std::array<float, 2>> textureAt;
  std::vector<std::uint16_t> triangles;
  bool isWhole = false;  ///< all posts known: triangles are those of wholeTileTriangles()

  std::vector<std::array<float, 3>> wallQuads;  ///< four corners each, the upper two first
  std::vector<std::array<float, 3>> lidQuads;   ///< flat hatched ground over unknown regions inside the terrain, four corners each
};

/** Picture of a tile: tint by height, shaded as if lit from the north-west, unknown ground hatched. */
struct TileTexture {
  static constexpr int kSide = 128;
  std::vector<std::uint8_t> rgb;  ///< all mipmap levels, largest first; rows from the south, no padding
};

/** Colours of the terrain, as a table over the shown heights. */
class TerrainPalette {
public:
  /** @param contourInterval  m between contour lines, 0: none */
  TerrainPalette(style::Theme theme, double lowest, double highest, double contourInterval);

  using Rgb = std::array<std::uint8_t, 3>;
  /** Tint by height, light by slope, and a contour line where the height is near a multiple of the interval; lines fade out
   *  where they would lie closer than some texels. @param east, north  slope of the ground [-]  @param texel  its side [m] */
  [[nodiscard]] Rgb colorOf(double height, double east, double north, double texel) const;
  [[nodiscard]] Rgb hatch() const { return hatch_; }
  [[nodiscard]] Rgb hatchBase() const { return hatchBase_; }
  /** True where a hatch line runs. Period 16. */
  static bool isHatchLine(int x, int y) { return ((x + y) & 15) < 4; }

private:
  [[nodiscard]] double contourAt(double height, double slope, double texel) const;

  static constexpr std::size_t kSteps = 1024;
  std::array<std::array<float, 3>, kSteps> tint_{};
  double lowest_ = 0.0;
  double perMetre_ = 0.0;
  double interval_ = 0.0;
  bool isDark_ = false;
  Rgb hatch_{};
  Rgb hatchBase_{};
};

/** Height between contour lines [m]: a round number of the operator's unit that suits a range of heights. */
double contourInterval(double lowest, double highest, const style::Units& units);

TileMesh buildTileMesh(const TerrainModel& model, TileId tile);
TileTexture buildTileTexture(const TerrainModel& model, const TerrainPalette& palette, TileId tile);

/** Triangles of a tile without unknown posts, shared by all of them. */
const std::vector<std::uint16_t>& wholeTileTriangles();

}  // namespace vp::scene3d
