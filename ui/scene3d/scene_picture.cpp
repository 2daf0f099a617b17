#include "ui/scene3d/scene_picture.h"

#include "ui/scene3d/camera_presets.h"
#include "ui/scene3d/offscreen_scene.h"
#include "ui/scene3d/scene_overlay.h"
#include "ui/scene3d/terrain_tile.h"

#include <QCoreApplication>
#include <QPainter>

namespace vp::scene3d {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(SceneProblems)
};

}  // namespace

Result<QImage> renderScene(const document::Situation& situation, const SceneOptions& options, const CameraSpec& spec, QSize size, style::Theme theme,
                           const style::Units& units, double pixelRatio) {
  if (situation.terrain == nullptr) {
    return fail(Errc::MissingTerrain, Words::tr("there is no terrain to draw; add a terrain file to the mission").toStdString());
  }
  auto offscreen = OffscreenScene::create();
  if (!offscreen) {
    return forward(offscreen);
  }
  constexpr double kSmoothFactor = 2.0;  // what OffscreenScene draws smooth pictures with
  const SceneStyle style{theme, units};
  const auto terrain = TerrainModel::build(situation.terrain);
  const auto scene = buildScene(situation, terrain, options, style);
  CameraController controller;
  controller.setPicture(size.width(), size.height());
  controller.setGround(cameraGround(terrain, options.verticalExaggeration));
  CameraOrbit orbit = spec.orbit.value_or(presetOrbit(spec.preset, situation, terrain.get(), options.verticalExaggeration, spec.cursor, controller));
  orbit.azimuth += spec.turn;
  orbit.distance /= spec.nearer;
  controller.jumpTo(orbit);
  const OverlayContent beside{
      {situation.plan != nullptr ? std::optional(scene->altitudes) : std::nullopt, contourInterval(terrain->lowest(), terrain->highest(), units)},
      situation.wind,
      options.verticalExaggeration};
  SceneRenderer& renderer = (*offscreen)->renderer();
  renderer.setTheme(theme);
  renderer.setExaggeration(options.verticalExaggeration);
  renderer.setDetail({900, 4.5 / pixelRatio});
  renderer.setReserved(layOutOverlay(QSizeF(size), beside, style).shown());
  renderer.setTerrain(std::make_shared<TerrainLayer>(terrain, style, nullptr));
  renderer.setScene(buildSceneNodes(*scene, pixelRatio * kSmoothFactor));
  if (spec.cursor) {
    renderer.setCursor(buildSceneNodes(buildCursorScene(situation, terrain, spec.cursor, -1, style), pixelRatio * kSmoothFactor));
  }
  QImage image = (*offscreen)->render(controller.camera(), pixelRatio, true, true);
  if (image.isNull()) {
    return fail(Errc::Unsupported, Words::tr("OpenGL could not draw a picture of this size").toStdString());
  }
  QPainter painter(&image);
  paintOverlay(painter, QSizeF(size), controller.orbit().azimuth, beside, style);
  return image;
}

}  // namespace vp::scene3d
