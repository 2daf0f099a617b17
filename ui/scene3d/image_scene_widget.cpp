#include "ui/scene3d/image_scene_widget.h"

#include "ui/scene3d/render_thread.h"

#include <QPainter>

#include <algorithm>

namespace vp::scene3d {
namespace {

constexpr double kSlowMs = 40.0;  // a picture in motion that takes longer is drawn smaller next time
constexpr double kFastMs = 18.0;
constexpr double kSmallest = 0.4;
constexpr TerrainDetail kMoving{};
constexpr TerrainDetail kResting{360, 5.0};

}  // namespace

ImageSceneWidget::ImageSceneWidget(document::ViewState& state, QWidget* parent)
    : SceneView(state, parent), thread_(std::make_unique<RenderThread>()) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(thread_.get(), &RenderThread::started, this, [this](const QString& name) { rendererName_ = name; });
  connect(
      thread_.get(), &RenderThread::failed, this,
      [this](const QString& reason) {
        showProblem(tr("There is no 3D view on this machine:\n%1.\nMap and profile show the same flight.").arg(reason));
      },
      Qt::QueuedConnection);
  connect(thread_.get(), &RenderThread::pictureReady, this, &ImageSceneWidget::receive);
}

ImageSceneWidget::~ImageSceneWidget() = default;

bool ImageSceneWidget::isSettled() const {
  return SceneView::isSettled() && !isDrawing_ && !isWanted_ && isComplete_ && isSmooth_;
}

void ImageSceneWidget::takeTerrain(std::shared_ptr<TerrainLayer> terrain) {
  thread_->post([terrain = std::move(terrain)](SceneRenderer& renderer) { renderer.setTerrain(terrain); });
}

void ImageSceneWidget::takeScene(std::shared_ptr<const SceneNodes> scene) {
  thread_->post([scene = std::move(scene)](SceneRenderer& renderer) { renderer.setScene(scene); });
}

void ImageSceneWidget::takeCursor(std::shared_ptr<const SceneNodes> cursor) {
  thread_->post([cursor = std::move(cursor)](SceneRenderer& renderer) { renderer.setCursor(cursor); });
}

void ImageSceneWidget::takeLook(style::Theme theme, double exaggeration) {
  thread_->post([theme, exaggeration](SceneRenderer& renderer) {
    renderer.setTheme(theme);
    renderer.setExaggeration(exaggeration);
  });
}

void ImageSceneWidget::takeReserved(std::vector<QRectF> parts) {
  thread_->post([parts = std::move(parts)](SceneRenderer& renderer) { renderer.setReserved(parts); });
}

void ImageSceneWidget::requestFrame() {
  isComplete_ = false;
  if (isDrawing_) {
    isWanted_ = true;
    return;
  }
  if (!isVisible() || !problem().isEmpty() || situation().terrain == nullptr) {
    return;
  }
  isDrawing_ = true;
  isWanted_ = false;
  const bool isSmooth = !isInMotion();
  const TerrainDetail detail = isSmooth ? kResting : kMoving;
  thread_->post([detail](SceneRenderer& renderer) { renderer.setDetail(detail); });
  thread_->draw(camera(), devicePixelRatioF() * (isSmooth ? 1.0 : scale_), isSmooth);
}

void ImageSceneWidget::receive(const QImage& picture, bool isComplete, bool isSmooth, double milliseconds) {
  isDrawing_ = false;
  if (picture.isNull()) {
    showProblem(tr("There is no 3D view: OpenGL could not draw a picture of this size."));
    return;
  }
  picture_ = picture;
  isComplete_ = isComplete && !isWanted_;
  isSmooth_ = isSmooth;
  if (!isSmooth) {
    if (milliseconds > kSlowMs) {
      scale_ = std::max(kSmallest, 0.85 * scale_);
    } else if (milliseconds < kFastMs) {
      scale_ = std::min(1.0, scale_ / 0.92);
    }
  }
  update();
  if (isWanted_ || (isSmooth && isInMotion())) {
    requestFrame();
  }
  emit pictureShown();
}

void ImageSceneWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), palette().window());
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(rect()), picture_);
}

}  // namespace vp::scene3d
