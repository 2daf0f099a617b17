#include "ui/scene3d/scene_view_factory.h"

#include "ui/scene3d/gl_scene_widget.h"
#include "ui/scene3d/image_scene_widget.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace vp::scene3d {
namespace {

/// Platforms on which Qt composes OpenGL widgets; on others even a working context ends in a crash when one is shown.
bool composesOpenGl(const QString& platform) {
  return platform == QLatin1String("xcb") || platform.startsWith(QLatin1String("wayland")) || platform == QLatin1String("windows") ||
         platform == QLatin1String("cocoa");
}

/// Makes a context and asks it what it is. @return false if it cannot draw the scene
bool hasFixedFunctions(bool& isSoftware) {
  QOpenGLContext context;
  context.setFormat(sceneFormat(false));
  if (!context.create() || context.isOpenGLES()) {
    return false;
  }
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) {
    return false;
  }
  const auto* text = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const QString name = text != nullptr ? QString::fromLatin1(text) : QString();
  isSoftware = name.contains(QLatin1String("llvmpipe")) || name.contains(QLatin1String("softpipe")) || name.contains(QLatin1String("SWR"));
  const bool isEnough = context.format().version() >= qMakePair(2, 1) && context.format().profile() != QSurfaceFormat::CoreProfile;
  context.doneCurrent();
  return isEnough;
}

}  // namespace

QSurfaceFormat sceneFormat(bool isSoftware) {
  QSurfaceFormat format;
  format.setVersion(2, 1);
  format.setProfile(QSurfaceFormat::NoProfile);
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setDepthBufferSize(24);
  format.setSamples(isSoftware ? 0 : 4);  // on the processor smooth edges cost half the frames
  return format;
}

SceneHost sceneHost(bool* isSoftware) {
  bool software = true;
  SceneHost host = SceneHost::Images;
  const QByteArray wish = qgetenv("VOLPLANE_3D");
  if (wish != "images" && composesOpenGl(QGuiApplication::platformName()) && (hasFixedFunctions(software) || wish == "widget")) {
    host = SceneHost::OpenGlWidget;
  }
  if (isSoftware != nullptr) {
    *isSoftware = software;
  }
  return host;
}

SceneView* createSceneView(document::ViewState& state, QWidget* parent) {
  bool isSoftware = true;
  if (sceneHost(&isSoftware) == SceneHost::OpenGlWidget) {
    return new GlSceneWidget(state, isSoftware, parent);
  }
  return new ImageSceneWidget(state, parent);
}

}  // namespace vp::scene3d
