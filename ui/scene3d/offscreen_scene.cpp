#include "ui/scene3d/offscreen_scene.h"

#include <QCoreApplication>
#include <QString>

#include <cstdint>
#include <cstring>
#include <vector>

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

namespace vp::scene3d {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(SceneProblems)
};

/// The display without windows: Mesa's own kind, else the first graphics device.
EGLDisplay openDisplay() {
  const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (getDisplay == nullptr) {
    return EGL_NO_DISPLAY;
  }
  EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
    return display;
  }
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (queryDevices == nullptr || queryDevices(1, &device, &count) != EGL_TRUE || count < 1) {
    return EGL_NO_DISPLAY;
  }
  display = getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE ? display : EGL_NO_DISPLAY;
}

}  // namespace

class OffscreenScene::Private {
public:
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::unique_ptr<SceneRenderer> renderer = std::make_unique<SceneRenderer>();
  GLuint framebuffer = 0;
  GLuint color = 0;
  GLuint depth = 0;
  QSize size;

  Private() = default;
  Private(const Private&) = delete;
  Private& operator=(const Private&) = delete;
  Private(Private&&) = delete;
  Private& operator=(Private&&) = delete;
  ~Private() {
    if (context != EGL_NO_CONTEXT) {
      makeCurrent();
      renderer->releaseContext();
      renderer.reset();
      dropFramebuffer();
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglDestroyContext(display, context);
    }
    // The display is shared by all scenes of the process; ending it would end theirs.
  }

  bool makeCurrent() const {
    eglBindAPI(EGL_OPENGL_API);
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
  }

  void dropFramebuffer() {
    if (framebuffer != 0) {
      glDeleteFramebuffers(1, &framebuffer);
      glDeleteRenderbuffers(1, &color);
      glDeleteRenderbuffers(1, &depth);
      framebuffer = 0;
    }
  }

  bool makeFramebuffer(QSize wanted) {
    if (framebuffer != 0 && wanted == size) {
      return true;
    }
    dropFramebuffer();
    size = wanted;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &color);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, wanted.width(), wanted.height());
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, wanted.width(), wanted.height());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
};

OffscreenScene::OffscreenScene(std::unique_ptr<Private> d) : d_(std::move(d)) {}
OffscreenScene::~OffscreenScene() = default;

Result<std::unique_ptr<OffscreenScene>> OffscreenScene::create() {
  auto d = std::make_unique<Private>();
  d->display = openDisplay();
  if (d->display == EGL_NO_DISPLAY) {
    return fail(Errc::Unsupported,
                Words::tr("no EGL display without a window could be opened; install the OpenGL driver (Mesa) of this machine").toStdString());
  }
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    return fail(Errc::Unsupported, Words::tr("the EGL of this machine has no desktop OpenGL").toStdString());
  }
  constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(d->display, kConfig, &config, 1, &count) != EGL_TRUE || count < 1) {
    return fail(Errc::Unsupported, Words::tr("EGL has no configuration for OpenGL").toStdString());
  }
  d->context = eglCreateContext(d->display, config, EGL_NO_CONTEXT, nullptr);
  if (d->context == EGL_NO_CONTEXT || !d->makeCurrent()) {
    return fail(Errc::Unsupported, Words::tr("no OpenGL context without a window could be made").toStdString());
  }
  eglMakeCurrent(d->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  return std::unique_ptr<OffscreenScene>(new OffscreenScene(std::move(d)));
}

SceneRenderer& OffscreenScene::renderer() {
  return *d_->renderer;
}

QString OffscreenScene::rendererName() const {
  d_->makeCurrent();
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name != nullptr ? QString::fromLatin1(name) : QString();
}

QImage OffscreenScene::render(const CameraState& camera, double pixelRatio, bool smooth, bool wait, bool* isComplete) {
  const int factor = smooth ? 2 : 1;
  const QSize picture(qRound(camera.width * pixelRatio), qRound(camera.height * pixelRatio));
  const QSize pixels = picture * factor;
  if (picture.isEmpty() || !d_->makeCurrent() || !d_->makeFramebuffer(pixels)) {
    return {};
  }
  const bool complete = d_->renderer->render(camera, pixels, d_->framebuffer, wait);
  if (isComplete != nullptr) {
    *isComplete = complete;
  }
  QImage image(pixels, QImage::Format_RGBX8888);
  glBindFramebuffer(GL_FRAMEBUFFER, d_->framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, pixels.width(), pixels.height(), GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
  image = std::move(image).mirrored();
  if (smooth) {
    image = image.scaled(picture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGBX8888);
  }
  image.setDevicePixelRatio(pixelRatio);
  return image;
}

}  // namespace vp::scene3d
