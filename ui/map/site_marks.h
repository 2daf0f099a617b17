#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>

#include <string>
#include <vector>

namespace vp::map {

/** Where a runway is drawn as a strip rather than as a symbol [px of length]. */
inline constexpr double kStripPixels = 16.0;
inline constexpr double kSiteRadius = 7.0;  ///< px, of the symbol of a runway too small to see

inline constexpr double kRingRadius = 9.0;  ///< px, around the runway that a glide ends at

/** "LSZS 21": airport and runway end as written on the map. */
QString siteTitle(const mission::LandingSite& site);

/** What a runway covers on the map: boxes along its strip or around its symbol, and first the one around the ring at the end where a
 *  glide arrives [px]. */
std::vector<QRectF> runwayBoxes(const mission::SiteInFrame& site, const MapCamera& camera);

/** The words beside the runways of an airport. */
struct SiteLabel {
  bool usable = false;
  QStringList lines;
  QFont font;
  QPointF anchor;       ///< px
  double radius = 0.0;  ///< px, of what the words stand beside

  /// Where the words stand if nothing else does.
  [[nodiscard]] QRectF firstBox() const;
};

/** Runways: strips to scale and direction where they are large enough, else a circle with a bar in their direction. Usable
 *  ones dark; those that the filter leaves out weaker and dashed; the geometry derived: with the sign of approximation. */
class SiteMarks {
public:
  SiteMarks(const MapScene& scene, const MapCamera& camera) : scene_(scene), camera_(camera) {}

  void drawSymbols(QPainter& painter, LabelPlacer& labels) const;
  void drawLabels(QPainter& painter, LabelPlacer& labels) const;
  /// Of the airports on the map, used ones first. @param only  airport; empty: all
  [[nodiscard]] std::vector<SiteLabel> labelsOf(const std::string& only = {}) const;

private:
  [[nodiscard]] bool isShown(const document::ShownSite& site) const;
  [[nodiscard]] bool isOtherEndDrawn(std::size_t index) const;
  void drawStrip(QPainter& painter, const document::ShownSite& site) const;
  void drawSymbol(QPainter& painter, const document::ShownSite& site) const;
  void drawThreshold(QPainter& painter, const document::ShownSite& site, LabelPlacer& labels) const;
  [[nodiscard]] SiteLabel labelOf(const std::string& ident, const document::ShownSite& site, bool isApproximate) const;
  void drawIdents(QPainter& painter, LabelPlacer& labels) const;
  [[nodiscard]] double stripPixels(const document::ShownSite& site) const;

  const MapScene& scene_;
  const MapCamera& camera_;
};

}  // namespace vp::map
