#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"
#include "ui/map/overlay_painter.h"
#include "ui/map/relief_painter.h"
#include "ui/map/safe_altitude_layer.h"

#include <QPainter>

#include <memory>

namespace vp::map {

/** Draws the map on any paint device; no widget. Terrain and overlays are painted by TilePainters (tiles in a window, in one
 *  go for a picture); the rest is drawn here in two parts: what stays while the mouse moves, and what follows it.
 *  Cheap to make; holds what it derived from the scene so that a view can keep it while the scene stays.
 *  @threads one at a time */
class MapRenderer {
public:
  explicit MapRenderer(MapScene scene);

  [[nodiscard]] const MapScene& scene() const { return scene_; }
  /** Takes a new scene; keeps what is still right of the old one, so that pans and hovers cost nothing. */
  void setScene(MapScene scene);
  void setCursor(std::optional<double> distance);

  /** Painter of the ground; null without terrain. A new object only when terrain or style have changed. */
  [[nodiscard]] std::shared_ptr<const ReliefPainter> relief() const { return relief_; }
  /** Painter of the overlays; null if none is on. */
  [[nodiscard]] std::shared_ptr<const OverlayPainter> overlay() const { return overlay_; }
  [[nodiscard]] const SafeAltitudeLayer* safeAltitude() const { return safeAltitude_.get(); }

  /** Tour, runways, targets, sketch and all labels. @param reserved  places without labels */
  void drawObjects(QPainter& painter, const MapCamera& camera, const std::vector<QRectF>& reserved) const;
  /** Glide and aircraft at the cursor. */
  void drawCursor(QPainter& painter, const MapCamera& camera) const;  ///< also the ways down from an engine failure somewhere
  /** Scale bar, north arrow, legend, a message of what to do next unless it is empty, and the words about the glide on top of them. */
  void drawFrame(QPainter& painter, const MapCamera& camera, const QString& message = {}) const;
  [[nodiscard]] std::vector<QRectF> frameBoxes(const MapCamera& camera) const;
  /** Everything in place, terrain included. */
  void drawAll(QPainter& painter, const MapCamera& camera, double devicePixelRatio) const;

private:
  void drawLandings(QPainter& painter, const document::LandingCase& landing, const MapCamera& camera) const;
  void updateRelief(const MapScene& before);
  void updateOverlay(const MapScene& before);
  [[nodiscard]] bool updatePopulation(const MapScene& before);
  void drawContourLabels(QPainter& painter, const MapCamera& camera, LabelPlacer& labels) const;

  MapScene scene_;
  std::shared_ptr<const HeightLevels> heights_;
  std::shared_ptr<const ReliefPainter> relief_;
  std::shared_ptr<const SafeAltitudeLayer> safeAltitude_;
  std::shared_ptr<const GlideLines> glides_;
  std::shared_ptr<const PopulationLayer> population_;
  std::shared_ptr<const OverlayPainter> overlay_;
  std::optional<document::EngineOut> engineOut_;
};

/** Ground worth showing: tour, targets and runways in use, else the terrain. Empty if there is nothing. */
geo::Box contentBox(const document::Situation& situation);

}  // namespace vp::map
