#pragma once

#include "core/base/result.h"
#include "ui/scene3d/scene_renderer.h"

#include <QImage>

#include <memory>

namespace vp::scene3d {

/** A renderer with an OpenGL context of its own that needs no window and no display: EGL without a surface.
 *  @threads the thread that renders first, to the end */
class OffscreenScene {
public:
  /** @errors Unsupported - this machine has no EGL with OpenGL; what() says what was missing */
  static Result<std::unique_ptr<OffscreenScene>> create();
  ~OffscreenScene();
  OffscreenScene(const OffscreenScene&) = delete;
  OffscreenScene& operator=(const OffscreenScene&) = delete;
  OffscreenScene(OffscreenScene&&) = delete;
  OffscreenScene& operator=(OffscreenScene&&) = delete;

  [[nodiscard]] SceneRenderer& renderer();
  /** What draws, as OpenGL names it. */
  [[nodiscard]] QString rendererName() const;

  /** A frame as a picture of camera.width x camera.height times `pixelRatio` pixels.
   *  @param smooth   drawn twice as large and averaged: for pictures and for a camera that rests
   *  @param wait     see SceneRenderer::render   @param isComplete  receives its result; may be null */
  QImage render(const CameraState& camera, double pixelRatio, bool smooth, bool wait, bool* isComplete = nullptr);

private:
  class Private;
  explicit OffscreenScene(std::unique_ptr<Private> d);
  std::unique_ptr<Private> d_;
};

}  // namespace vp::scene3d
