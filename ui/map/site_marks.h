#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>

namespace vp::map {

/** Where a runway is drawn as a strip rather than as a symbol [px of length]. */
inline constexpr double kStripPixels = 16.0;
inline constexpr double kSiteRadius = 7.0;  ///< px, of the symbol of a runway too small to see

/** "LSZS 21": airport and runway end as written on the map. */
QString siteTitle(const mission::LandingSite& site);

/** Runways: strips to scale and direction where they are large enough, else a circle with a bar in their direction. Usable
 *  ones dark; those that the filter leaves out weaker and dashed; the geometry derived: with the sign of approximation. */
class SiteMarks {
public:
  SiteMarks(const MapScene& scene, const MapCamera& camera) : scene_(scene), camera_(camera) {}

  void drawSymbols(QPainter& painter, LabelPlacer& labels) const;
  void drawLabels(QPainter& painter, LabelPlacer& labels) const;

private:
  [[nodiscard]] bool isShown(const document::ShownSite& site) const;
  [[nodiscard]] bool isOtherEndDrawn(std::size_t index) const;
  void drawStrip(QPainter& painter, const document::ShownSite& site) const;
  void drawSymbol(QPainter& painter, const document::ShownSite& site) const;
  void drawThreshold(QPainter& painter, const document::ShownSite& site, LabelPlacer& labels) const;
  void drawIdents(QPainter& painter, LabelPlacer& labels) const;
  [[nodiscard]] double stripPixels(const document::ShownSite& site) const;

  const MapScene& scene_;
  const MapCamera& camera_;
};

}  // namespace vp::map
