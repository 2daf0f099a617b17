#include "ui/scene3d/camera_presets.h"

#include "ui/scene3d/scene_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::scene3d {
namespace {

constexpr double kNorth = 0.5 * std::numbers::pi;
constexpr double kOverviewPitch = 0.62;  // rad: relief and plan both readable

Bounds scaled(Bounds box, double exaggeration) {
  box.low.z *= exaggeration;
  box.high.z *= exaggeration;
  return box;
}

const mission::SiteInFrame* runwayFor(const document::Situation& situation, std::optional<double> cursor) {
  if (situation.plan != nullptr) {
    const document::EngineOut glide = situation.plan->engineOutAt(cursor.value_or(0.0));
    if (glide.site >= 0) {
      return &situation.plan->plan().sites[static_cast<std::size_t>(glide.site)];
    }
  }
  if (situation.sites != nullptr) {
    const auto first = std::find_if(situation.sites->begin(), situation.sites->end(), [](const document::ShownSite& s) { return s.usable; });
    if (first != situation.sites->end()) {
      return &first->site;
    }
  }
  return nullptr;
}

CameraOrbit fromRunway(const mission::SiteInFrame& site, const TerrainModel* terrain, double exaggeration) {
  constexpr double kBehind = 900.0;  // m past the threshold, in landing direction
  constexpr double kAbove = 260.0;   // m over the ground, so that the runway lies below in the picture
  constexpr double kPitch = 0.16;
  const double c = std::cos(site.pose.heading);
  const double s = std::sin(site.pose.heading);
  const geo::Point stand{site.pose.x + kBehind * c, site.pose.y + kBehind * s};
  const double elevation = site.site.elevation.metres();
  const double ground = terrain != nullptr ? terrain->heightAt(stand).value_or(elevation) : elevation;
  const Vec3 eye{stand.x, stand.y, std::max(ground, elevation) * exaggeration + kAbove};
  CameraOrbit orbit;
  orbit.azimuth = std::remainder(site.pose.heading + std::numbers::pi, 2.0 * std::numbers::pi);
  orbit.pitch = kPitch;
  orbit.distance = kAbove / std::sin(kPitch);
  orbit.pivot = eye + orbit.distance * Vec3{-c * std::cos(kPitch), -s * std::cos(kPitch), -std::sin(kPitch)};
  return orbit;
}

}  // namespace

CameraGround cameraGround(const std::shared_ptr<const TerrainModel>& terrain, double exaggeration) {
  CameraGround ground;
  if (terrain == nullptr) {
    ground.heightAt = [](geo::Point) { return 0.0; };
    return ground;
  }
  const geo::Box box = terrain->known().isEmpty() ? terrain->extent() : terrain->known();
  ground.extent.add(Vec3{box.minX, box.minY, terrain->lowest() * exaggeration});
  ground.extent.add(Vec3{box.maxX, box.maxY, terrain->highest() * exaggeration});
  const double reach = 10.0 * ground.extent.diagonal();
  ground.heightAt = [terrain, exaggeration](geo::Point p) { return terrain->surfaceAt(p) * exaggeration; };
  ground.hit = [terrain, exaggeration, reach](Vec3 eye, Vec3 direction) { return terrain->hit(eye, direction, exaggeration, reach); };
  return ground;
}

FlightPath flightPath(std::shared_ptr<const document::PlanView> plan, double exaggeration) {
  FlightPath path;
  if (plan == nullptr) {
    return path;
  }
  path.length = plan->length();
  path.speed = plan->plan().mission.aircraft.bestGlideSpeed.si();
  path.at = [plan = std::move(plan), exaggeration](double distance) {
    const document::TourState state = plan->at(distance);
    return FlightPoint{{state.pose.x, state.pose.y, state.altitude * exaggeration}, state.pose.heading};
  };
  return path;
}

CameraOrbit presetOrbit(Preset preset, const document::Situation& situation, const TerrainModel* terrain, double exaggeration,
                        std::optional<double> cursor, const CameraController& controller) {
  if (preset == Preset::AlongTour && situation.plan != nullptr) {
    const document::TourState state = situation.plan->at(cursor.value_or(0.0));
    return {{state.pose.x, state.pose.y, state.altitude * exaggeration},
            1400.0,
            state.pose.heading + CameraController::kBesideTurn,
            CameraController::kFollowPitch};
  }
  if (preset == Preset::FromRunway) {
    if (const mission::SiteInFrame* site = runwayFor(situation, cursor)) {
      return fromRunway(*site, terrain, exaggeration);
    }
  }
  const Bounds box = scaled(interestOf(situation), exaggeration);
  if (box.isEmpty()) {
    return controller.orbit();
  }
  return controller.fitted(box, kNorth, preset == Preset::Top ? CameraController::kHighestPitch : kOverviewPitch);
}

}  // namespace vp::scene3d
