#include "ui/scene3d/scene_renderer.h"

#include "ui/scene3d/overlay_nodes.h"

#include <osg/Group>
#include <osg/Hint>
#include <osg/MatrixTransform>
#include <osg/Notify>
#include <osg/ref_ptr>
#include <osgViewer/Viewer>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace vp::scene3d {
namespace {

void quieten() {
  static std::once_flag once;
  std::call_once(once, [] { osg::setNotifyLevel(osg::WARN); });
}

osg::Matrixd matrixOf(const std::array<double, 16>& m) {
  return osg::Matrixd(m.data());
}

}  // namespace

class SceneRenderer::Private {
public:
  Private() {
    quieten();
    root = new osg::Group;
    scaled = new osg::MatrixTransform;
    ground = new osg::Group;
    scene = new osg::Group;
    cursor = new osg::Group;
    scaled->addChild(ground);
    scaled->addChild(scene);
    scaled->addChild(cursor);
    root->addChild(&sky.node());
    root->addChild(scaled);
    root->addChild(&labels.node());
    osg::StateSet* state = root->getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setAttribute(new osg::Hint(GL_LINE_SMOOTH_HINT, GL_NICEST));
  }

  void makeViewer(QSize pixels) {
    viewer = std::make_unique<osgViewer::Viewer>();
    viewer->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer->setReleaseContextAtEndOfFrameHint(false);
    viewer->setKeyEventSetsDone(0);
    viewer->setLightingMode(osg::View::NO_LIGHT);
    window = viewer->setUpViewerAsEmbeddedInWindow(0, 0, pixels.width(), pixels.height());
    osg::Camera* camera = viewer->getCamera();
    camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setCullingMode(osg::CullSettings::VIEW_FRUSTUM_CULLING);  // nothing is too small
    camera->setAllowEventFocus(false);
    viewer->setSceneData(root);
    viewer->realize();
  }

  void fitScenes(const CameraState& camera, double pixelRatio) {
    std::vector<const LabelAtlas*> atlases;
    for (const auto& nodes : {sceneNodes, cursorNodes}) {
      if (nodes != nullptr) {
        fitToPicture(*nodes, camera, exaggeration, pixelRatio);
        atlases.push_back(&nodes->labels);
      }
    }
    const auto isClear = [&](Vec3 place) { return terrain == nullptr || terrain->model().isClear(camera.eye, place, exaggeration); };
    labels.update(camera, atlases, placeLabels(atlases, camera, exaggeration, reserved, isClear));
  }

  osg::ref_ptr<osg::Group> root;
  osg::ref_ptr<osg::MatrixTransform> scaled;
  osg::ref_ptr<osg::Group> ground;
  osg::ref_ptr<osg::Group> scene;
  osg::ref_ptr<osg::Group> cursor;
  SkyNode sky;
  LabelNode labels;
  std::shared_ptr<TerrainLayer> terrain;
  std::shared_ptr<const SceneNodes> sceneNodes;
  std::shared_ptr<const SceneNodes> cursorNodes;
  style::Theme theme = style::Theme::Light;
  double exaggeration = 1.0;
  TerrainDetail detail;
  std::vector<QRectF> reserved;
  std::unique_ptr<osgViewer::Viewer> viewer;
  osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window;
  QSize size;
};

SceneRenderer::SceneRenderer() : d_(std::make_unique<Private>()) {}

SceneRenderer::~SceneRenderer() = default;

namespace {

void replace(osg::Group& group, osg::Node* node) {
  group.removeChildren(0, group.getNumChildren());
  if (node != nullptr) {
    group.addChild(node);
  }
}

}  // namespace

void SceneRenderer::setTerrain(std::shared_ptr<TerrainLayer> terrain) {
  replace(*d_->ground, terrain != nullptr ? &terrain->root() : nullptr);
  d_->terrain = std::move(terrain);
}

void SceneRenderer::setScene(std::shared_ptr<const SceneNodes> scene) {
  replace(*d_->scene, scene != nullptr ? scene->root.get() : nullptr);
  d_->sceneNodes = std::move(scene);
}

void SceneRenderer::setCursor(std::shared_ptr<const SceneNodes> cursor) {
  replace(*d_->cursor, cursor != nullptr ? cursor->root.get() : nullptr);
  d_->cursorNodes = std::move(cursor);
}

void SceneRenderer::setTheme(style::Theme theme) {
  d_->theme = theme;
}

void SceneRenderer::setExaggeration(double factor) {
  d_->exaggeration = factor;
  d_->scaled->setMatrix(osg::Matrix::scale(1.0, 1.0, factor));
}

void SceneRenderer::setDetail(const TerrainDetail& detail) {
  d_->detail = detail;
}

void SceneRenderer::setReserved(std::vector<QRectF> parts) {
  d_->reserved = std::move(parts);
}

bool SceneRenderer::render(const CameraState& camera, QSize pixels, unsigned int framebuffer, bool wait) {
  const bool isComplete = d_->terrain == nullptr || d_->terrain->update(camera, d_->exaggeration, d_->detail, wait);
  d_->sky.update(camera, d_->theme);
  d_->fitScenes(camera, pixels.height() / camera.height);
  if (d_->viewer == nullptr) {
    d_->makeViewer(pixels);
    d_->size = pixels;
  }
  if (d_->size != pixels) {
    d_->window->resized(0, 0, pixels.width(), pixels.height());
    d_->size = pixels;
  }
  osg::Camera* view = d_->viewer->getCamera();
  view->setViewport(0, 0, pixels.width(), pixels.height());
  const QColor haze = hazeColor(d_->theme);
  view->setClearColor(osg::Vec4(haze.redF(), haze.greenF(), haze.blueF(), 1.0F));
  view->setViewMatrix(matrixOf(camera.viewMatrix()));
  view->setProjectionMatrix(matrixOf(camera.projectionMatrix()));
  d_->window->setDefaultFboId(framebuffer);
  d_->viewer->frame(0.0);
  return isComplete;
}

void SceneRenderer::releaseContext() {
  if (d_->viewer == nullptr) {
    return;
  }
  d_->root->releaseGLObjects();
  if (d_->terrain != nullptr) {
    d_->terrain->releaseContext();
  }
  d_->window->getState()->reset();
  osg::flushAllDeletedGLObjects(d_->window->getState()->getContextID());
  d_->viewer.reset();
  d_->window = nullptr;
}

}  // namespace vp::scene3d
