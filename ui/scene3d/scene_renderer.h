#pragma once

#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/scene_nodes.h"
#include "ui/scene3d/terrain_layer.h"
#include "ui/style/chart_colors.h"

#include <QRectF>
#include <QSize>

#include <memory>
#include <vector>

namespace vp::scene3d {

/** Owns the graph and draws it into whatever framebuffer is bound by its host; the same for all hosts.
 *  Needs OpenGL 2.1 with fixed functions (a compatibility profile), nothing above.
 *  @threads one thread, the one that its context is current on; constructing needs no context */
class SceneRenderer {
public:
  SceneRenderer();
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;
  SceneRenderer(SceneRenderer&&) = delete;
  SceneRenderer& operator=(SceneRenderer&&) = delete;

  /** Parts of the scene, each replaced on its own; null: none. */
  void setTerrain(std::shared_ptr<TerrainLayer> terrain);
  void setScene(std::shared_ptr<const SceneNodes> scene);
  void setCursor(std::shared_ptr<const SceneNodes> cursor);
  void setTheme(style::Theme theme);
  void setExaggeration(double factor);
  void setDetail(const TerrainDetail& detail);
  /** Parts of the picture that labels leave free, px at 96 dpi. */
  void setReserved(std::vector<QRectF> parts);

  /** Draws a frame. @pre a context is current
   *  @param camera  its width and height are those of the picture at 96 dpi
   *  @param pixels  of the framebuffer   @param framebuffer  OpenGL name, 0 for the window itself
   *  @param wait    builds missing terrain first, for pictures
   *  @return true if the terrain is as fine as it should be; else draw again when tiles are ready */
  bool render(const CameraState& camera, QSize pixels, unsigned int framebuffer, bool wait);

  /** Forgets what lies in the current context; the next frame starts in a new one. @pre that context is current */
  void releaseContext();

private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace vp::scene3d
