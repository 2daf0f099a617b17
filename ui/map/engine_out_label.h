#pragma once

#include "ui/document/plan_view.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>

#include <optional>
#include <vector>

namespace vp::map {

/** Runway and margin of the glide at the cursor, in words. */
struct EngineOutLabel {
  QString text;
  QRectF box;  ///< px, inside the map
};

/** Where the words on a glide stand: beside the runway on the side that the glide does not come from, else elsewhere at the runway, else
 *  at the aircraft or next to the frame. They never cover the frame where there is room beside it, then not the runway and the ring
 *  around it, then neither the end of the glide, nor the runway's own words where these usually stand, nor other runways.
 *  Nothing if no glide arrives.
 *  @param furniture  boxes of the frame [px] */
std::optional<EngineOutLabel> engineOutLabel(const MapScene& scene, const MapCamera& camera, const document::EngineOut& glide,
                                             const std::vector<QRectF>& furniture);

void drawEngineOutLabel(QPainter& painter, const EngineOutLabel& label, const style::ChartColors& colors, const QRectF& within);

}  // namespace vp::map
