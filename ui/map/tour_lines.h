#pragma once

#include "ui/document/plan_view.h"
#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>

#include <optional>

namespace vp::map {

/** Decision points nearer together than this [px] are not all drawn. */
inline constexpr double kDotSpacing = 10.0;
inline constexpr double kTourWidth = 4.0;  ///< px

/** The tour: magenta with casing and direction arrows; grey, dashed and marked while out of date; by its glide margin where
 *  that is asked for. Decision points, and what the planner works on. */
class TourLines {
public:
  TourLines(const MapScene& scene, const MapCamera& camera) : scene_(scene), camera_(camera) {}

  void draw(QPainter& painter) const;
  void avoidLabels(LabelPlacer& labels) const;  ///< keeps labels off the line where that can be done
  void drawMarks(QPainter& painter,
                 LabelPlacer& labels) const;  ///< "OUT OF DATE", "NOT VERIFIED"; where the ways from and to home begin to be guaranteed
  void drawSketch(QPainter& painter) const;

private:
  void drawPlain(QPainter& painter) const;
  void drawByMargin(QPainter& painter) const;
  void drawHomePaths(QPainter& painter) const;
  void drawArrows(QPainter& painter) const;
  void drawDecisionPoints(QPainter& painter) const;
  void drawSpirals(QPainter& painter) const;
  [[nodiscard]] std::vector<geo::Point> line() const;

  const MapScene& scene_;
  const MapCamera& camera_;
};

/** A glide flown after an engine failure, the aircraft where it begins, and a ring around the runway that it ends at.
 *  @param end  touchdown point; none: it reaches no runway */
void drawEngineOut(QPainter& painter, const style::ChartColors& colors, const MapCamera& camera, const document::EngineOut& glide,
                   std::optional<geo::Point> end);
/** A glide that is another choice: thin. */
void drawOtherGlide(QPainter& painter, const style::ChartColors& colors, const MapCamera& camera, const document::EngineOut& glide);

}  // namespace vp::map
