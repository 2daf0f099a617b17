#pragma once

#include "ui/scene3d/offscreen_scene.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>

namespace vp::scene3d {

/** A thread with an off-screen renderer. Tasks run there in order; the renderer is made before the first.
 *  @threads GUI thread; signals arrive there, queued */
class RenderThread : public QObject {
  Q_OBJECT

public:
  explicit RenderThread(QObject* parent = nullptr);
  ~RenderThread() override;

  /** Changes what is drawn. */
  void post(std::function<void(SceneRenderer&)> task);
  /** Draws; answered by pictureReady, or never if there is no OpenGL. */
  void draw(const CameraState& camera, double pixelRatio, bool isSmooth);

signals:
  void started(const QString& rendererName);
  void failed(const QString& reason);
  void pictureReady(const QImage& picture, bool isComplete, bool isSmooth, double milliseconds);

private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace vp::scene3d
