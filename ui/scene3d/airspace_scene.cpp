#include "ui/scene3d/airspace_scene.h"

#include "ui/document/airspace_words.h"
#include "ui/style/short_name.h"

#include <QPolygonF>
#include <QRectF>

#include <algorithm>
#include <cmath>

namespace vp::scene3d {
namespace {

constexpr double kAbove = 500.0;   // m above the tour and the terrain, where an airspace has no ceiling
constexpr double kBuried = 100.0;  // m that one from the surface goes below the lowest ground: the terrain hides it there
constexpr double kForbidden = 0.24;
constexpr double kWarned = 0.13;
constexpr double kMostSides = 300.0;
constexpr std::size_t kMostPosts = 12;  // a circle needs no more to be seen as one

bool followsGround(const mission::AirspaceLimit& limit) {
  return limit.kind == mission::AirspaceLimit::Kind::AboveGround;
}

/// The part of an outline over the terrain, not closed; with many corners where its height follows the ground.
std::vector<geo::Point> outlineOver(const document::ShownAirspace& shown, const geo::Box& terrain) {
  QPolygonF polygon;
  for (const geo::Point& corner : shown.outline) {
    polygon << QPointF(corner.x, corner.y);
  }
  polygon = polygon.intersected(QPolygonF(QRectF(QPointF(terrain.minX, terrain.minY), QPointF(terrain.maxX, terrain.maxY))));
  if (polygon.size() > 1 && polygon.front() == polygon.back()) {
    polygon.pop_back();
  }
  const bool isUneven = followsGround(shown.airspace.floor) || followsGround(shown.airspace.ceiling);
  const double longest = isUneven ? std::max(100.0, std::max(terrain.maxX - terrain.minX, terrain.maxY - terrain.minY) / kMostSides) : 1e12;
  std::vector<geo::Point> outline;
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    const QPointF a = polygon[i];
    const QPointF step = polygon[(i + 1) % polygon.size()] - a;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::hypot(step.x(), step.y()) / longest)));
    for (int k = 0; k < parts; ++k) {
      outline.push_back({a.x() + step.x() * k / parts, a.y() + step.y() * k / parts});
    }
  }
  return outline;
}

void addEdges(SceneData& scene, const SceneVolume& volume) {
  SceneLine top;
  SceneLine bottom;
  const std::size_t count = volume.top.size();
  const std::size_t postEvery = (count + kMostPosts - 1) / kMostPosts;
  for (std::size_t i = 0; i <= count; ++i) {
    const ScenePoint& high = volume.top[i % count];
    const ScenePoint low{high.x, high.y, volume.bottom[i % count]};
    top.points.push_back(high);
    bottom.points.push_back(low);
    if (i < count && i % postEvery == 0) {
      SceneLine post;
      post.points = {low, high};
      post.color = volume.color;
      post.width = 1.0;
      scene.lines.push_back(std::move(post));
    }
  }
  top.color = bottom.color = volume.color;
  top.width = bottom.width = 2.0;
  scene.lines.push_back(std::move(top));
  scene.lines.push_back(std::move(bottom));
}

/// In the middle of the ceiling.
void addLabel(SceneData& scene, const document::ShownAirspace& shown, const SceneVolume& volume) {
  SceneLabel label;
  label.kind = SceneLabel::Kind::Airspace;
  for (const ScenePoint& p : volume.top) {
    const double share = 1.0 / static_cast<double>(volume.top.size());
    label.anchor = {label.anchor.x + share * p.x, label.anchor.y + share * p.y, std::max(label.anchor.z, p.z)};
  }
  const QStringList text = document::airspaceText(shown.airspace, scene.style.units);
  label.text = style::shortName(text.front());
  label.detail = text.back();
  label.color = volume.color;
  label.priority = 30.0;
  scene.labels.push_back(std::move(label));
}

}  // namespace

void addAirspaces(SceneData& scene, const document::Situation& situation) {
  if (situation.airspaces == nullptr || situation.terrain == nullptr) {
    return;
  }
  const geo::Box terrain = situation.terrain->grid->extent();
  const double highest = std::max(scene.altitudes.high, situation.terrain->highest) + kAbove;
  const double lowest = std::min(scene.altitudes.low, situation.terrain->lowest) - kBuried;
  for (const document::ShownAirspace& shown : *situation.airspaces) {
    const bool isForbidden = shown.use == mission::AirspaceUse::Forbid;
    if (!isForbidden && shown.use != mission::AirspaceUse::Warn) {
      continue;
    }
    const std::vector<geo::Point> outline = outlineOver(shown, terrain);
    if (outline.size() < 3) {
      continue;
    }
    SceneVolume volume;
    volume.color = style::ChartColors::airspace(scene.style.theme, shown.airspace.kind);
    volume.opacity = isForbidden ? kForbidden : kWarned;
    for (const geo::Point& corner : outline) {
      const double surface = scene.terrain != nullptr ? scene.terrain->surfaceAt(corner) : scene.altitudes.low;
      const double ground = std::isfinite(surface) ? surface : scene.altitudes.low;
      const double high = document::airspaceTop(shown.airspace, ground, highest);
      volume.top.push_back({corner.x, corner.y, high});
      volume.bottom.push_back(std::min(high, document::airspaceBottom(shown.airspace, ground, lowest)));
    }
    addEdges(scene, volume);
    addLabel(scene, shown, volume);
    scene.volumes.push_back(std::move(volume));
  }
}

}  // namespace vp::scene3d
