#pragma once

#include "ui/scene3d/scene_view.h"

#include <QImage>

#include <memory>

namespace vp::scene3d {

class RenderThread;

/** The 3D view where no OpenGL widget can live: a thread draws off screen, and this widget shows its pictures. While the
 *  camera moves pictures are coarser where the machine is slow; at rest they are drawn with smooth edges. */
class ImageSceneWidget : public SceneView {
  Q_OBJECT

public:
  ImageSceneWidget(document::ViewState& state, QWidget* parent);
  ~ImageSceneWidget() override;

  [[nodiscard]] QString rendererName() const override { return rendererName_; }
  [[nodiscard]] bool isSettled() const override;
  /** What is shown now; null before the first picture. */
  [[nodiscard]] const QImage& picture() const { return picture_; }

signals:
  void pictureShown();

protected:
  void takeTerrain(std::shared_ptr<TerrainLayer> terrain) override;
  void takeScene(std::shared_ptr<const SceneNodes> scene) override;
  void takeCursor(std::shared_ptr<const SceneNodes> cursor) override;
  void takeLook(style::Theme theme, double exaggeration) override;
  void takeReserved(std::vector<QRectF> parts) override;
  void requestFrame() override;
  /// Texts are made for the smooth pictures, which are drawn twice as large.
  [[nodiscard]] double labelRatio() const override { return 2.0 * devicePixelRatioF(); }
  void paintEvent(QPaintEvent* event) override;

private:
  void receive(const QImage& picture, bool isComplete, bool isSmooth, double milliseconds);

  std::unique_ptr<RenderThread> thread_;
  QImage picture_;
  QString rendererName_;
  double scale_ = 1.0;  ///< of pictures in motion, smaller where the machine is slow
  bool isDrawing_ = false;
  bool isWanted_ = false;
  bool isComplete_ = false;
  bool isSmooth_ = false;
};

}  // namespace vp::scene3d
