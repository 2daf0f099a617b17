#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"
#include "ui/map/safe_altitude_layer.h"

#include <QPainter>

#include <vector>

namespace vp::map {

/** What the colours and dashes on the map mean. Rows that belong together are a group, shown or left out as one; long rows are
 *  broken into lines. */
class ChartLegend {
public:
  /** @param safeAltitude  the field that is shown; null: none   @param maxWidth  px, of the whole legend */
  ChartLegend(const MapScene& scene, const MapCamera& camera, const SafeAltitudeLayer* safeAltitude, double maxWidth);

  [[nodiscard]] double width() const { return width_; }
  /** Heights of the groups, the most important first. [px] */
  [[nodiscard]] std::vector<double> groupHeights() const;
  /** Above and below the groups together. [px] */
  [[nodiscard]] static double padding();
  /** Draws the first `groups` groups into a box of their heights, padding and width(). */
  void draw(QPainter& painter, const QRectF& box, std::size_t groups) const;

private:
  struct Row {
    enum class Sign { AltitudeScale, NoGlide, Reachable, Margin, DecisionPoint, SafeLeg, BoundLeg, Roadmap, Weather, PopulationScale };
    Sign sign;
    QString text;
    double margin = 0.0;      ///< m, of Sign::Margin; probability per nautical mile, of Sign::Weather
    double textHeight = 0.0;  ///< px
  };
  using Group = std::vector<Row>;
  void add(Group group);
  void addSafeAltitude();
  void addMargins();
  void addTour(const MapCamera& camera);
  void addAreas();
  void measure(double maxWidth);
  [[nodiscard]] static double heightOf(const Row& row);
  void drawRow(QPainter& painter, const Row& row, const QRectF& box) const;
  void drawSign(QPainter& painter, const Row& row, const QRectF& box) const;
  void drawAltitudeScale(QPainter& painter, const QRectF& box) const;
  void drawPopulationScale(QPainter& painter, const QRectF& box) const;
  [[nodiscard]] QString courseText() const;

  const MapScene& scene_;
  const SafeAltitudeLayer* safeAltitude_;
  std::vector<Group> groups_;
  double width_ = 0.0;
};

}  // namespace vp::map
