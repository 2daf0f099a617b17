#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>

namespace vp::map {

inline constexpr double kTargetRadius = 7.0;  ///< px

/** "target 3" for a target named "3", "Target 3" or "T3"'s own name in quotes else: how menus and messages name it. */
QString targetTitle(const document::ShownTarget& target);
/** "500 ft AGL" or "6 480 ft MSL": the height as the mission gives it. */
QString targetHeight(const document::ShownTarget& target, const style::Units& units);

/** The symbol of a target alone, for the map, drags and legends. */
void drawTargetSymbol(QPainter& painter, QPointF at, const style::ChartColors& colors, bool selected, bool hasProblem);

/** Targets: symbol, name, height with datum; a sign where a target cannot be planned. */
class TargetMarks {
public:
  TargetMarks(const MapScene& scene, const MapCamera& camera) : scene_(scene), camera_(camera) {}

  void drawSymbols(QPainter& painter, LabelPlacer& labels) const;
  void drawLabels(QPainter& painter, LabelPlacer& labels) const;

private:
  const MapScene& scene_;
  const MapCamera& camera_;
};

}  // namespace vp::map
