#pragma once

#include "ui/scene3d/scene_view.h"

#include <memory>

namespace vp::scene3d {

/** The 3D view on a desktop: draws with the graphics card in an OpenGL widget of its own, under the overlay.
 *  Never make one where createSceneView() would not: under a platform without OpenGL Qt ends the process. */
class GlSceneWidget : public SceneView {
  Q_OBJECT

public:
  GlSceneWidget(document::ViewState& state, bool isSoftware, QWidget* parent);
  ~GlSceneWidget() override;

  [[nodiscard]] QString rendererName() const override;
  [[nodiscard]] bool isSettled() const override;
  /** The picture as drawn, without the overlay. */
  [[nodiscard]] QImage grabPicture();

protected:
  void takeTerrain(std::shared_ptr<TerrainLayer> terrain) override;
  void takeScene(std::shared_ptr<const SceneNodes> scene) override;
  void takeCursor(std::shared_ptr<const SceneNodes> cursor) override;
  void takeLook(style::Theme theme, double exaggeration) override;
  void takeReserved(std::vector<QRectF> parts) override;
  void requestFrame() override;
  void resizeEvent(QResizeEvent* event) override;

private:
  class Canvas;
  Canvas* canvas_ = nullptr;
};

}  // namespace vp::scene3d
