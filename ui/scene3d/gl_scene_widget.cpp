#include "ui/scene3d/gl_scene_widget.h"

#include "ui/scene3d/scene_renderer.h"
#include "ui/scene3d/scene_view_factory.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>

namespace vp::scene3d {
namespace {

// On the processor the frame must be ready in 33 ms; a graphics card draws ten times as much.
constexpr TerrainDetail kSoftware{};
constexpr TerrainDetail kSoftwareResting{220, 6.0};
constexpr TerrainDetail kHardware{800, 4.0};

}  // namespace

class GlSceneWidget::Canvas : public QOpenGLWidget {
public:
  Canvas(GlSceneWidget& view, bool isSoftware) : QOpenGLWidget(&view), view_(view), isSoftware_(isSoftware) {
    setFormat(sceneFormat(isSoftware));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
  }
  ~Canvas() override {
    if (isValid()) {
      disconnect(context(), nullptr, this, nullptr);  // it ends after the renderer
      makeCurrent();
      renderer.releaseContext();
      doneCurrent();
    }
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  Canvas(Canvas&&) = delete;
  Canvas& operator=(Canvas&&) = delete;

  SceneRenderer renderer;
  QString name;
  bool isComplete = false;
  bool isFailed = false;

protected:
  void initializeGL() override {
    const auto* text = reinterpret_cast<const char*>(context()->functions()->glGetString(GL_RENDERER));
    name = text != nullptr ? QString::fromLatin1(text) : QString();
    // a new window means a new context: what lay in the old one is gone with it
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
      makeCurrent();
      renderer.releaseContext();
      doneCurrent();
    });
  }

  void paintGL() override {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (pixels.isEmpty() || isFailed) {
      return;
    }
    try {
      renderer.setDetail(!isSoftware_ ? kHardware : view_.isInMotion() ? kSoftware : kSoftwareResting);
      isComplete = renderer.render(view_.camera(), pixels, defaultFramebufferObject(), false);
    } catch (const std::exception& e) {
      isFailed = true;
      view_.showProblem(GlSceneWidget::tr("The 3D view failed: %1").arg(QString::fromUtf8(e.what())));
    }
  }

private:
  GlSceneWidget& view_;
  bool isSoftware_;
};

GlSceneWidget::GlSceneWidget(document::ViewState& state, bool isSoftware, QWidget* parent) : SceneView(state, parent) {
  canvas_ = new Canvas(*this, isSoftware);
  canvas_->lower();
}

GlSceneWidget::~GlSceneWidget() {
  delete canvas_;  // while its view is still a GlSceneWidget
}

QString GlSceneWidget::rendererName() const {
  return canvas_->name;
}

bool GlSceneWidget::isSettled() const {
  return SceneView::isSettled() && canvas_->isComplete && !isInMotion();
}

QImage GlSceneWidget::grabPicture() {
  return canvas_->grabFramebuffer();
}

void GlSceneWidget::takeTerrain(std::shared_ptr<TerrainLayer> terrain) {
  canvas_->renderer.setTerrain(std::move(terrain));
}

void GlSceneWidget::takeScene(std::shared_ptr<const SceneNodes> scene) {
  canvas_->renderer.setScene(std::move(scene));
}

void GlSceneWidget::takeCursor(std::shared_ptr<const SceneNodes> cursor) {
  canvas_->renderer.setCursor(std::move(cursor));
}

void GlSceneWidget::takeLook(style::Theme theme, double exaggeration) {
  canvas_->renderer.setTheme(theme);
  canvas_->renderer.setExaggeration(exaggeration);
}

void GlSceneWidget::takeReserved(std::vector<QRectF> parts) {
  canvas_->renderer.setReserved(std::move(parts));
}

void GlSceneWidget::requestFrame() {
  canvas_->isComplete = false;
  canvas_->update();
}

void GlSceneWidget::resizeEvent(QResizeEvent* event) {
  canvas_->setGeometry(rect());
  SceneView::resizeEvent(event);
}

}  // namespace vp::scene3d
