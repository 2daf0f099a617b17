#include "ui/map/engine_out_label.h"

#include "ui/map/chart_text.h"
#include "ui/map/site_marks.h"
#include "ui/map/words.h"

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr std::size_t kFinal = 40;              // points of a glide that tell where it comes from
constexpr QPointF kBesideAircraft(20.0, 16.0);  // px
constexpr double kBesideRunway = 24.0;          // px
constexpr double kAboveRunway = 34.0;           // px
constexpr double kBesideFurniture = 4.0;        // px

/// Upper left corners of the places, the best first.
std::vector<QPointF> placesFor(const MapCamera& camera, const document::EngineOut& glide, const geo::Pose& runway, QSizeF size) {
  std::vector<QPointF> places;
  const QPointF end = camera.toScreen(runway.point());
  const QPointF aircraft = camera.toScreen(glide.from.pose.point());
  if (camera.screen().contains(end)) {
    const QPointF across(std::sin(runway.heading), std::cos(runway.heading));
    const QPointF from = camera.toScreen(glide.path[glide.path.size() - 1 - std::min<std::size_t>(kFinal, glide.path.size() - 1)].pose.point()) - end;
    const double side = QPointF::dotProduct(across, from) > 0.0 ? -1.0 : 1.0;
    for (const double way : {side, -side}) {
      const QPointF centre = end + QPointF(across.x() * (0.5 * size.width() + kBesideRunway), across.y() * kAboveRunway) * way;
      places.push_back(centre - QPointF(0.5 * size.width(), 0.5 * size.height()));
    }
  }
  for (const QPointF& at : {aircraft, end}) {
    places.push_back(at + kBesideAircraft);
    places.push_back(at + QPointF(kBesideAircraft.x(), -kBesideAircraft.y() - size.height()));
    places.push_back(at + QPointF(-kBesideAircraft.x() - size.width(), kBesideAircraft.y()));
    places.push_back(at - kBesideAircraft - QPointF(size.width(), size.height()));
  }
  return places;
}

}  // namespace

std::optional<EngineOutLabel> engineOutLabel(const MapScene& scene, const MapCamera& camera, const document::EngineOut& glide,
                                             const std::vector<QRectF>& furniture) {
  if (glide.site < 0 || glide.path.empty()) {
    return std::nullopt;
  }
  const mission::SiteInFrame& site = scene.situation.plan->plan().sites[static_cast<std::size_t>(glide.site)];
  QString text = QStringLiteral("%1   %2").arg(siteTitle(site.site), Words::tr("margin %1").arg(scene.units.margin(glide.margin)));
  if (!camera.screen().contains(camera.toScreen(site.pose.point()))) {
    text.prepend(QStringLiteral("→ "));  // the runway is out of view
  }
  const QSizeF size = readoutBox({}, {text}, camera.screen()).size();
  std::vector<QPointF> places = placesFor(camera, glide, site.pose, size);
  for (const QRectF& other : furniture) {  // if all of these are taken, next to what takes them
    places.push_back(other.topLeft() - QPointF(0.0, size.height() + kBesideFurniture));
    places.push_back(other.bottomLeft() + QPointF(0.0, kBesideFurniture));
  }
  std::vector<QRectF> boxes;
  boxes.reserve(places.size());
  for (const QPointF& place : places) {
    boxes.push_back(readoutBox(place, {text}, camera.screen()));
  }
  const auto isFree = [&](const QRectF& box) {
    return std::none_of(furniture.begin(), furniture.end(), [&](const QRectF& other) { return other.intersects(box); });
  };
  const auto free = std::find_if(boxes.begin(), boxes.end(), isFree);
  return EngineOutLabel{text, free == boxes.end() ? boxes.front() : *free};
}

void drawEngineOutLabel(QPainter& painter, const EngineOutLabel& label, const style::ChartColors& colors, const QRectF& within) {
  drawReadout(painter, label.box.topLeft(), {label.text}, colors, within);
}

}  // namespace vp::map
