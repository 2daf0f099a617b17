#include "ui/map/engine_out_label.h"

#include "ui/map/chart_text.h"
#include "ui/map/site_marks.h"
#include "ui/map/words.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace vp::map {
namespace {

constexpr std::size_t kFinal = 40;              // points of a glide that tell where it comes from
constexpr QPointF kBesideAircraft(20.0, 16.0);  // px
constexpr double kBesideRunway = 24.0;          // px
constexpr double kAboveRunway = 34.0;           // px
constexpr double kBesideFurniture = 4.0;        // px
constexpr double kNearEnd = 70.0;               // px from the runway within which the glide should stay visible
constexpr double kGlideRoom = 4.0;              // px on either side of the glide's middle

/// What the words on a glide should leave visible, the most important first.
struct Obstacles {
  std::vector<QRectF> furniture;
  std::vector<QRectF> runway;
  std::vector<QRectF> rather;  ///< the end of the glide, the runway's own words, other runways

  /// 0: clear of everything; 1: covers what it rather should not; 2: the runway; 3: furniture.
  [[nodiscard]] int worst(const QRectF& box) const {
    const auto hits = [&](const std::vector<QRectF>& boxes) {
      return std::any_of(boxes.begin(), boxes.end(), [&](const QRectF& other) { return other.intersects(box); });
    };
    return hits(furniture) ? 3 : hits(runway) ? 2 : hits(rather) ? 1 : 0;
  }
};

Obstacles obstaclesFor(const MapScene& scene, const MapCamera& camera, const document::EngineOut& glide, const mission::SiteInFrame& site,
                       const std::vector<QRectF>& furniture) {
  Obstacles obstacles{furniture, runwayBoxes(site, camera), {}};
  const QPointF end = camera.toScreen(site.pose.point());
  for (const document::GlidePoint& point : glide.path) {
    const QPointF at = camera.toScreen(point.pose.point());
    if ((at - end).manhattanLength() < kNearEnd) {
      obstacles.rather.emplace_back(at.x() - kGlideRoom, at.y() - kGlideRoom, 2.0 * kGlideRoom, 2.0 * kGlideRoom);
    }
  }
  if (scene.situation.sites != nullptr) {
    const std::string& airport = site.site.airportIdent.empty() ? site.site.id : site.site.airportIdent;
    for (const SiteLabel& label : SiteMarks(scene, camera).labelsOf(airport)) {
      obstacles.rather.push_back(label.firstBox());
    }
    const double radius = kSiteRadius + kBesideFurniture;
    for (const document::ShownSite& other : *scene.situation.sites) {
      const QPointF at = camera.toScreen(other.site.pose.point());
      if ((other.usable || scene.options.excludedSites) && camera.screen().contains(at)) {
        obstacles.rather.emplace_back(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius);
      }
    }
  }
  return obstacles;
}

/// Upper left corners of the places, the best first. @param room  px from the middle of the runway that keep clear of it
std::vector<QPointF> placesFor(const MapCamera& camera, const document::EngineOut& glide, const geo::Pose& runway, QSizeF size, double room) {
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
  if (camera.screen().contains(end)) {  // straight below and above it, to either side
    places.push_back(end + QPointF(-0.5 * size.width(), room));
    places.push_back(end - QPointF(0.5 * size.width(), room + size.height()));
    places.push_back(end + QPointF(room, -0.5 * size.height()));
    places.push_back(end - QPointF(room + size.width(), 0.5 * size.height()));
  }
  for (const QPointF& at : {end, aircraft}) {
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
  const Obstacles obstacles = obstaclesFor(scene, camera, glide, site, furniture);
  double room = 0.0;
  for (const QRectF& box : obstacles.runway) {
    room = std::max(room, 0.5 * box.height() + kBesideFurniture);
  }
  std::vector<QPointF> places = placesFor(camera, glide, site.pose, size, room);
  for (const QRectF& other : furniture) {  // if all of these are taken, next to what takes them
    places.push_back(other.topLeft() - QPointF(0.0, size.height() + kBesideFurniture));
    places.push_back(other.bottomLeft() + QPointF(0.0, kBesideFurniture));
  }
  std::vector<QRectF> boxes;
  boxes.reserve(places.size());
  for (const QPointF& place : places) {
    boxes.push_back(readoutBox(place, {text}, camera.screen()));
  }
  std::vector<int> worst;
  worst.reserve(boxes.size());
  std::transform(boxes.begin(), boxes.end(), std::back_inserter(worst), [&](const QRectF& box) { return obstacles.worst(box); });
  const auto best = std::min_element(worst.begin(), worst.end()) - worst.begin();  // the first of equals
  return EngineOutLabel{text, boxes[static_cast<std::size_t>(best)]};
}

void drawEngineOutLabel(QPainter& painter, const EngineOutLabel& label, const style::ChartColors& colors, const QRectF& within) {
  drawReadout(painter, label.box.topLeft(), {label.text}, colors, within);
}

}  // namespace vp::map
