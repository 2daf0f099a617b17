#include "ui/map/hit_test.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vp::map {
namespace {

constexpr double kTourReach = 8.0;  // px

double pixelsBetween(QPointF a, QPointF b) {
  return QLineF(a, b).length();
}

double pixelsToSegment(QPointF p, QPointF a, QPointF b) {
  const QPointF step = b - a;
  const double square = QPointF::dotProduct(step, step);
  const double t = square > 0.0 ? std::clamp(QPointF::dotProduct(p - a, step) / square, 0.0, 1.0) : 0.0;
  return pixelsBetween(p, a + step * t);
}

int nearestTarget(const MapScene& scene, const MapCamera& camera, QPointF at) {
  int nearest = -1;
  double least = kReach;
  if (scene.situation.targets != nullptr) {
    for (std::size_t i = 0; i < scene.situation.targets->size(); ++i) {
      const double away = pixelsBetween(at, camera.toScreen((*scene.situation.targets)[i].point));
      if (away <= least) {
        least = away;
        nearest = static_cast<int>(i);
      }
    }
  }
  return nearest;
}

/// The runway end whose half of the strip is nearest.
int nearestSite(const MapScene& scene, const MapCamera& camera, QPointF at) {
  int nearest = -1;
  double least = kReach;
  if (scene.situation.sites == nullptr) {
    return nearest;
  }
  for (std::size_t i = 0; i < scene.situation.sites->size(); ++i) {
    const document::ShownSite& site = (*scene.situation.sites)[i];
    if (!site.usable && !scene.options.excludedSites) {
      continue;
    }
    const geo::Pose& pose = site.site.pose;
    const double half = site.site.site.length ? 0.5 * site.site.site.length->si() : 0.0;
    const QPointF middle = camera.toScreen({pose.x + half * std::cos(pose.heading), pose.y + half * std::sin(pose.heading)});
    const double away = pixelsToSegment(at, camera.toScreen(pose.point()), middle);
    if (away < least) {
      least = away;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

}  // namespace

MapObject objectAt(const MapScene& scene, const MapCamera& camera, QPointF at) {
  if (const int target = nearestTarget(scene, camera, at); target >= 0) {
    return {MapObject::Kind::Target, target, 0.0};
  }
  if (const int site = nearestSite(scene, camera, at); site >= 0) {
    return {MapObject::Kind::Site, site, 0.0};
  }
  if (scene.situation.plan != nullptr) {
    if (const auto distance = scene.situation.plan->nearest(camera.toGround(at), kTourReach * camera.metresPerPixel())) {
      return {MapObject::Kind::Tour, -1, *distance};
    }
  }
  return {};
}

int insertionIndex(const MapScene& scene, double distance) {
  if (scene.situation.plan == nullptr || scene.situation.targets == nullptr) {
    return -1;
  }
  const document::PlanView& plan = *scene.situation.plan;
  std::optional<std::string> next;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < plan.plan().targets.size(); ++i) {
    if (const auto at = plan.distanceOfTarget(static_cast<int>(i))) {
      const double ahead = *at >= distance ? *at - distance : *at - distance + plan.length();
      if (ahead < least) {
        least = ahead;
        next = plan.plan().targets[i].target.name;
      }
    }
  }
  // the mission may have changed since the plan was made: its names count
  for (std::size_t i = 0; next && i < scene.situation.targets->size(); ++i) {
    if ((*scene.situation.targets)[i].target.name == *next) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace vp::map
