#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"
#include "ui/map/safe_altitude_layer.h"

#include <QPainter>

namespace vp::map {

/** A round length for a scale bar: 1, 2 or 5 times a power of ten of the shown unit, at most `pixels` long. [m] */
double scaleBarLength(double metresPerPixel, double pixels, const style::Units& units);

/** What stands still on the glass while the ground moves under it: scale bar lower left, north arrow upper right, legend lower right. */
class ChartFrame {
public:
  /** @param safeAltitude  the field that is shown; null: none */
  ChartFrame(const MapScene& scene, const MapCamera& camera, const SafeAltitudeLayer* safeAltitude)
      : scene_(scene), camera_(camera), safeAltitude_(safeAltitude) {}

  void draw(QPainter& painter) const;
  /** Places that draw() covers, for labels to keep off. */
  [[nodiscard]] std::vector<QRectF> covered() const;

private:
  struct Entry {
    enum class Sign { AltitudeScale, NoGlide, Reachable, Margin, DecisionPoint, SafeLeg, BoundLeg, Roadmap };
    Sign sign;
    QString text;
    double margin = 0.0;
  };
  [[nodiscard]] std::vector<Entry> entries() const;
  [[nodiscard]] QRectF legendBox(const std::vector<Entry>& entries) const;
  [[nodiscard]] QRectF scaleBox() const;
  [[nodiscard]] QRectF northBox() const;
  void drawScale(QPainter& painter) const;
  void drawNorth(QPainter& painter) const;
  void drawLegend(QPainter& painter) const;
  void drawSign(QPainter& painter, const Entry& entry, const QRectF& box) const;
  void drawAltitudeScale(QPainter& painter, const QRectF& box) const;
  [[nodiscard]] QString courseText() const;

  const MapScene& scene_;
  const MapCamera& camera_;
  const SafeAltitudeLayer* safeAltitude_;
};

}  // namespace vp::map
