#pragma once

#include "ui/document/plan_view.h"
#include "ui/document/planning_sketch.h"
#include "ui/map/area_layer.h"
#include "ui/map/safe_altitude_layer.h"
#include "ui/map/tile_painter.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace vp::map {

/** Glides of all decision points as lines on the ground. Made on first use, which is on a worker.
 *  @threads safe */
class GlideLines {
public:
  struct Line {
    std::vector<geo::Point> points;
    geo::Box box;
    double margin = 0.0;  ///< m
  };
  explicit GlideLines(std::shared_ptr<const document::PlanView> plan) : plan_(std::move(plan)) {}
  [[nodiscard]] const std::vector<Line>& lines() const;
  void abandon() const { abandoned_ = true; }

private:
  std::shared_ptr<const document::PlanView> plan_;
  mutable std::once_flag made_;
  mutable std::vector<Line> lines_;
  mutable std::atomic<bool> abandoned_ = false;
};

/** What an overlay shows; what is null or off is left out. */
struct OverlayContent {
  style::Theme theme = style::Theme::Light;
  style::UnitSystem units = style::UnitSystem::Aviation;
  std::shared_ptr<const SafeAltitudeLayer> safeAltitude;
  bool tint = false;                    ///< of the lowest safe altitude, with contours
  std::optional<double> reachableFrom;  ///< m MSL
  std::shared_ptr<const GlideLines> glides;
  std::shared_ptr<const std::vector<document::PlanningSketch::Edge>> roadmap;
  std::shared_ptr<const PopulationLayer> population;
  std::shared_ptr<const std::vector<document::ShownWeather>> weather;

  [[nodiscard]] bool isEmpty() const;
};

/** Overlays that lie on the terrain under tour and runways: population, lowest safe altitude, reachable area, weather, all glides, the roadmap
 *  while it grows. Transparent elsewhere. */
class OverlayPainter : public TilePainter {
public:
  explicit OverlayPainter(OverlayContent content);

  [[nodiscard]] QImage paint(const PixelWindow& window, double devicePixelRatio) const override;
  [[nodiscard]] geo::Box extent() const override { return extent_; }
  void abandon() const override;

private:
  void paintField(QImage& image, const PixelWindow& window, double devicePixelRatio) const;
  void paintRoadmap(QPainter& painter, const PixelWindow& window, double devicePixelRatio) const;
  void paintGlides(QPainter& painter, const PixelWindow& window, double devicePixelRatio) const;

  OverlayContent content_;
  geo::Box extent_;
  std::vector<QRgb> scale_;  ///< of altitudes, lowest first
};

}  // namespace vp::map
