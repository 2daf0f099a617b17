#pragma once

#include "ui/scene3d/scene_data.h"
#include "ui/scene3d/scene_options.h"
#include "ui/scene3d/scene_overlay.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace vp::scene3d {

/** Compass, wind, legend and notes over the 3D view, as widgets of their own so that they never meet its graphics state. Lets the
 *  mouse through everywhere but on the compass, which turns the view north. */
class SceneOverlay : public QObject {
  Q_OBJECT

public:
  explicit SceneOverlay(QWidget* view);

  void setGeometry(const QRect& rect);
  void setVisible(bool visible);
  void setStyle(const SceneStyle& style);
  void setAzimuth(double azimuth);
  void setExaggeration(double factor);
  void setAltitudes(std::optional<AltitudeRange> range);
  /** @param metres  between contour lines, 0: none */
  void setContourInterval(double metres);
  /** @param winds  none: still air */
  void setWinds(std::vector<air::WindLayer> winds);

  /** Parts of the view that are covered, for labels to leave free. */
  [[nodiscard]] std::vector<QRectF> covered() const { return layout_.shown(); }

signals:
  void northRequested();
  void arranged();

private:
  class Part;
  void arrange();

  SceneStyle style_;
  OverlayContent content_;
  double azimuth_ = 1.5707963267948966;
  bool isVisible_ = true;
  OverlayLayout layout_;
  QRect rect_;
  Part* compass_ = nullptr;
  Part* wind_ = nullptr;
  Part* legend_ = nullptr;
  Part* note_ = nullptr;
};

}  // namespace vp::scene3d
