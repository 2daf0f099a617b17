#pragma once

#include "ui/document/situation.h"
#include "ui/scene3d/scene_data.h"
#include "ui/scene3d/scene_nodes.h"
#include "ui/scene3d/terrain_layer.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace vp::scene3d {

/** Builds terrain and scenes on a thread of its own. Of each kind only the latest request counts: a newer one stops what
 *  runs and replaces what waits. Terrain goes first, since scenes stand on it.
 *  @threads GUI thread; signals arrive there, queued */
class SceneWorker : public QObject {
  Q_OBJECT

public:
  struct Terrain {
    std::shared_ptr<const TerrainModel> model;  ///< null: none
    std::shared_ptr<TerrainLayer> layer;
  };
  struct Scene {
    std::shared_ptr<const SceneNodes> nodes;
    AltitudeRange altitudes;
  };

  /** @param tileReady  see TerrainLayer; called from any thread, never after the destructor has returned */
  explicit SceneWorker(std::function<void()> tileReady, QObject* parent = nullptr);
  ~SceneWorker() override;

  void buildTerrain(std::shared_ptr<const document::TerrainData> terrain, const SceneStyle& style);
  void buildScene(const document::Situation& situation, const SceneOptions& options, const SceneStyle& style, double labelRatio);
  void buildCursor(const document::Situation& situation, std::optional<double> distance, int selectedTarget, const SceneStyle& style,
                   double labelRatio);
  /** True while something is asked for that has not been delivered. */
  [[nodiscard]] bool isBusy() const;

signals:
  void terrainReady(const vp::scene3d::SceneWorker::Terrain& terrain);
  void sceneReady(const vp::scene3d::SceneWorker::Scene& scene);
  void cursorReady(const std::shared_ptr<const vp::scene3d::SceneNodes>& nodes);

private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace vp::scene3d
