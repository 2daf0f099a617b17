#pragma once

#include "ui/scene3d/osg_pointer.h"
#include "ui/scene3d/scene_options.h"
#include "ui/scene3d/terrain_model.h"
#include "ui/scene3d/tile_selection.h"

#include <functional>
#include <memory>

namespace vp::scene3d {

/** The terrain in the graph: shows the tiles that a camera needs, builds missing ones on threads of its own and forgets
 *  those not seen for long. The coarsest tiles are built with it and stay, so there is always something to show.
 *  @threads construct anywhere (some ms); then only on the thread that renders   @cost memory below 250 MB */
class TerrainLayer {
public:
  static constexpr std::size_t kMostTiles = 1100;  ///< kept, about 200 kB each with their pictures

  /** @param tileReady  called from a worker when a tile can be shown that was not there; may be empty */
  TerrainLayer(std::shared_ptr<const TerrainModel> model, const SceneStyle& style, std::function<void()> tileReady);
  ~TerrainLayer();
  TerrainLayer(const TerrainLayer&) = delete;
  TerrainLayer& operator=(const TerrainLayer&) = delete;
  TerrainLayer(TerrainLayer&&) = delete;
  TerrainLayer& operator=(TerrainLayer&&) = delete;

  [[nodiscard]] const TerrainModel& model() const;
  /** Tiles, walls and the hatched base; heights without exaggeration. */
  [[nodiscard]] osg::Group& root();

  /** Puts the tiles for a camera into the graph. @param wait  builds what is missing here and now
   *  @return true if nothing better is on its way */
  bool update(const CameraState& camera, double exaggeration, const TerrainDetail& detail, bool wait);

  /** Forgets what tiles have in graphics contexts, those not shown now included. */
  void releaseContext();

  [[nodiscard]] std::size_t tilesKept() const;
  [[nodiscard]] std::size_t tilesShown() const;

private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace vp::scene3d
