#include "ui/scene3d/scene_picking.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace vp::scene3d {
namespace {

Vec3 placeOf(const document::TourState& state, double exaggeration) {
  return {state.pose.x, state.pose.y, state.altitude * exaggeration};
}

struct Hit {
  double pixels = 0.0;
  double distance = 0.0;
  Vec3 place;
};

}  // namespace

std::optional<double> pickTour(const document::PlanView& plan, const TerrainModel* terrain, const CameraState& camera, double exaggeration, double x,
                               double y, double radius) {
  std::vector<Hit> hits;
  const std::vector<document::TourSample>& samples = plan.samples();
  std::optional<ScreenPoint> before;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 place = placeOf(samples[i].state, exaggeration);
    const auto at = camera.project(place);
    if (at && before) {
      const double dx = at->x - before->x;
      const double dy = at->y - before->y;
      const double square = dx * dx + dy * dy;
      const double t = square > 0.0 ? std::clamp(((x - before->x) * dx + (y - before->y) * dy) / square, 0.0, 1.0) : 0.0;
      const double pixels = std::hypot(before->x + t * dx - x, before->y + t * dy - y);
      if (pixels <= radius) {
        // a part of the picture is another part of the way: nearer things are drawn larger
        const double along = t * before->depth / (t * before->depth + (1.0 - t) * at->depth);
        const Vec3 from = placeOf(samples[i - 1].state, exaggeration);
        const double start = samples[i - 1].state.distance;
        hits.push_back({pixels, start + along * (samples[i].state.distance - start), from + along * (place - from)});
      }
    }
    before = at;
  }
  // where the tour crosses itself on the picture the nearer part counts among those about equally near to the pixel
  std::sort(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    return std::pair(std::floor(a.pixels / 2.0), length(a.place - camera.eye)) < std::pair(std::floor(b.pixels / 2.0), length(b.place - camera.eye));
  });
  for (const Hit& hit : hits) {
    if (terrain == nullptr || terrain->isClear(camera.eye, hit.place, exaggeration)) {
      return hit.distance;
    }
  }
  return std::nullopt;
}

std::optional<int> pickTarget(const std::vector<document::ShownTarget>& targets, const TerrainModel* terrain, const CameraState& camera,
                              double exaggeration, double x, double y, double radius) {
  std::optional<int> best;
  double bestPixels = radius;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double foot = terrain != nullptr ? terrain->surfaceAt(targets[i].point) : 0.0;
    for (const double height : {targets[i].altitude.value_or(foot), foot}) {
      const auto at = camera.project({targets[i].point.x, targets[i].point.y, height * exaggeration});
      const double pixels = at ? std::hypot(at->x - x, at->y - y) : bestPixels + 1.0;
      if (pixels < bestPixels) {
        bestPixels = pixels;
        best = static_cast<int>(i);
      }
    }
  }
  return best;
}

std::optional<Vec3> pickGround(const TerrainModel& terrain, const CameraState& camera, double exaggeration, double x, double y) {
  return terrain.hit(camera.eye, camera.rayThrough(x, y), exaggeration, camera.farPlane);
}

}  // namespace vp::scene3d
