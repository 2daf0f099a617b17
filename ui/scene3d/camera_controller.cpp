#include "ui/scene3d/camera_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vp::scene3d {
namespace {

constexpr double kFieldOfView = 0.70;    // rad: 40 degrees, calm perspective
constexpr double kNearest = 60.0;        // m between eye and pivot
constexpr double kFollowSeconds = 0.35;  // time constant in which the view turns after the aircraft

Vec3 directionOf(double azimuth, double pitch) {
  return {std::cos(azimuth) * std::cos(pitch), std::sin(azimuth) * std::cos(pitch), -std::sin(pitch)};
}

Vec3 eyeOf(const CameraOrbit& orbit) {
  return orbit.pivot - orbit.distance * directionOf(orbit.azimuth, orbit.pitch);
}

double eased(double t) {
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

double turnBetween(double from, double to) {
  return std::remainder(to - from, 2.0 * std::numbers::pi);
}

CameraController::CameraController() = default;

void CameraController::setGround(CameraGround ground) {
  ground_ = std::move(ground);
  keepWithinLimits();
}

void CameraController::setPicture(double width, double height) {
  width_ = std::max(1.0, width);
  height_ = std::max(1.0, height);
}

CameraState CameraController::camera() const {
  CameraState camera;
  camera.eye = eyeOf(orbit_);
  camera.forward = directionOf(orbit_.azimuth, orbit_.pitch);
  const Vec3 right{std::sin(orbit_.azimuth), -std::cos(orbit_.azimuth), 0.0};
  camera.up = cross(right, camera.forward);
  camera.fieldOfView = kFieldOfView;
  camera.width = width_;
  camera.height = height_;
  const double above = std::max(kClearance, camera.eye.z - groundAt(camera.eye));
  camera.nearPlane = std::clamp(0.2 * std::min(above, orbit_.distance), 4.0, 2000.0);
  const double reach = ground_.extent.isEmpty() ? 1e5 : length(ground_.extent.centre() - camera.eye) + 2.0 * ground_.extent.diagonal();
  camera.farPlane = std::max(reach, 100.0 * camera.nearPlane);
  return camera;
}

double CameraController::largestDistance() const {
  return ground_.extent.isEmpty() ? 1e6 : std::max(2000.0, 3.0 * ground_.extent.diagonal());
}

void CameraController::keepWithinLimits() {
  orbit_.distance = std::clamp(orbit_.distance, kNearest, largestDistance());
  orbit_.pitch = std::clamp(orbit_.pitch, kLowestPitch, kHighestPitch);
  if (!ground_.extent.isEmpty() && !followed_) {
    const Vec3 low = ground_.extent.low;
    const Vec3 high = ground_.extent.high;
    const double margin = 0.25 * std::max(high.x - low.x, high.y - low.y);
    orbit_.pivot.x = std::clamp(orbit_.pivot.x, low.x - margin, high.x + margin);
    orbit_.pivot.y = std::clamp(orbit_.pivot.y, low.y - margin, high.y + margin);
  }
  // The eye is lifted about the pivot, so that what is looked at stays; where that does not do, straight up.
  constexpr int kLifts = 60;
  for (int i = 0; i < kLifts && orbit_.pitch < kHighestPitch; ++i) {
    const Vec3 eye = eyeOf(orbit_);
    const double missing = groundAt(eye) + kClearance - eye.z;
    if (missing <= 0.0) {
      return;
    }
    const double lift = std::max(missing / (orbit_.distance * std::max(0.2, std::cos(orbit_.pitch))), 0.002);
    orbit_.pitch = std::min(kHighestPitch, orbit_.pitch + std::min(lift, 0.05));
  }
  const Vec3 eye = eyeOf(orbit_);
  orbit_.pivot.z += std::max(0.0, groundAt(eye) + kClearance - eye.z);
}

void CameraController::orbitBy(double azimuth, double pitch) {
  travel_.reset();
  orbit_.azimuth = std::remainder(orbit_.azimuth + azimuth, 2.0 * std::numbers::pi);
  orbit_.pitch += pitch;
  if (followed_) {
    turn_ = std::remainder(turn_ + azimuth, 2.0 * std::numbers::pi);
    followPitch_ = std::clamp(orbit_.pitch, kLowestPitch, kHighestPitch);
  }
  keepWithinLimits();
}

void CameraController::beginPan(double x, double y) {
  travel_.reset();
  const CameraState view = camera();
  held_ = ground_.hit ? ground_.hit(view.eye, view.rayThrough(x, y)) : std::nullopt;
  if (!held_) {  // sky: hold on to something as far away as the pivot
    const Vec3 ray = view.rayThrough(x, y);
    held_ = view.eye + (orbit_.distance / std::max(0.1, dot(ray, view.forward))) * ray;
  }
}

void CameraController::panTo(double x, double y) {
  if (!held_ || followed_) {
    return;
  }
  const CameraState view = camera();
  const Vec3 ray = view.rayThrough(x, y);
  const double fall = held_->z - view.eye.z;
  const double away = length(*held_ - view.eye);
  Vec3 move;
  if (ray.z * fall > 0.0 && fall / ray.z < 4.0 * away) {
    move = *held_ - (view.eye + (fall / ray.z) * ray);
  } else {  // near the horizon the level plane runs away: keep the distance instead
    move = *held_ - (view.eye + away * ray);
  }
  orbit_.pivot = orbit_.pivot + Vec3{move.x, move.y, 0.0};
  keepWithinLimits();
}

void CameraController::endPan() {
  held_.reset();
  anchorToGround();
}

void CameraController::panBy(double right, double forward) {
  travel_.reset();
  if (followed_) {
    return;
  }
  const double wide = orbit_.distance * 2.0 * std::tan(0.5 * kFieldOfView);
  const Vec3 ahead{std::cos(orbit_.azimuth), std::sin(orbit_.azimuth), 0.0};
  const Vec3 side{ahead.y, -ahead.x, 0.0};
  orbit_.pivot = orbit_.pivot + (wide * right) * side + (wide * forward) * ahead;
  anchorToGround();
  keepWithinLimits();
}

void CameraController::anchorToGround() {
  if (followed_ || !ground_.hit) {
    return;
  }
  // Without moving the eye the pivot goes to the ground in the middle of the picture, so that orbits turn about what is seen.
  const Vec3 eye = eyeOf(orbit_);
  const Vec3 forward = directionOf(orbit_.azimuth, orbit_.pitch);
  if (const auto ground = ground_.hit(eye, forward)) {
    const double distance = length(*ground - eye);
    if (distance >= kNearest && distance <= largestDistance()) {
      orbit_.pivot = *ground;
      orbit_.distance = distance;
    }
  }
}

void CameraController::zoomAt(double factor, double x, double y) {
  travel_.reset();
  const double limited = std::clamp(orbit_.distance / factor, kNearest, largestDistance());
  if (followed_) {
    orbit_.distance = limited;
    keepWithinLimits();
    return;
  }
  const CameraState view = camera();
  const Vec3 ray = view.rayThrough(x, y);
  const std::optional<Vec3> ground = ground_.hit ? ground_.hit(view.eye, ray) : std::nullopt;
  const Vec3 fixed = ground.value_or(orbit_.pivot);
  double scale = limited / orbit_.distance;
  if (scale < 1.0) {  // never through the ground: stay kClearance and kNearest away from it
    const double away = length(fixed - view.eye);
    scale = std::max(scale, std::min(1.0, 1.5 * kNearest / std::max(away, 1.0)));
  }
  orbit_.pivot = fixed + scale * (orbit_.pivot - fixed);
  orbit_.distance = std::max(kNearest, orbit_.distance * scale);
  anchorToGround();
  keepWithinLimits();
}

void CameraController::jumpTo(const CameraOrbit& orbit) {
  travel_.reset();
  orbit_ = orbit;
  keepWithinLimits();
}

void CameraController::flyTo(const CameraOrbit& orbit) {
  travel_ = Travel{orbit_, orbit, 0.0};
}

CameraOrbit CameraController::fitted(const Bounds& box, double azimuth, double pitch) const {
  constexpr double kInset = 0.06;  // of the picture, left free on each side
  CameraController trial;
  trial.width_ = width_;
  trial.height_ = height_;
  trial.orbit_ = {box.centre(), 0.0, azimuth, pitch};
  const Vec3 ahead{std::cos(azimuth), std::sin(azimuth), 0.0};
  /// The part of the picture that the box takes, 1: all but the inset; infinite if some of it is behind the eye.
  const auto filled = [&](double distance) {
    trial.orbit_.distance = distance;
    double part = 0.0;
    constexpr int kRounds = 4;  // perspective puts the middle of a box below that of the picture: move it there
    for (int round = 0; round < kRounds; ++round) {
      const CameraState view = trial.camera();
      Bounds shown;
      for (int k = 0; k < 8; ++k) {
        const Vec3 corner{(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y, (k & 4) != 0 ? box.high.z : box.low.z};
        const auto at = view.project(corner);
        if (!at) {
          return std::numeric_limits<double>::infinity();
        }
        shown.add({at->x, at->y, 0.0});
      }
      const Vec3 span = shown.high - shown.low;
      part = std::max(span.x / width_, span.y / height_) / (1.0 - 2.0 * kInset);
      const double metres = (0.5 * height_ - shown.centre().y) / view.pixelsPerMetre(distance) / std::max(0.2, std::sin(pitch));
      trial.orbit_.pivot = trial.orbit_.pivot + metres * ahead;
    }
    return part;
  };
  const double size = std::max(500.0, box.diagonal());
  double near = 0.2 * size;
  double far = 8.0 * size;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (near + far);
    trial.orbit_.pivot = box.centre();
    (filled(middle) <= 1.0 ? far : near) = middle;
  }
  trial.orbit_.pivot = box.centre();
  filled(far);
  return trial.orbit_;
}

void CameraController::setPath(FlightPath path) {
  path_ = std::move(path);
  if (path_.length <= 0.0) {
    stopFollowing();
  }
}

void CameraController::follow(double distance) {
  if (path_.length <= 0.0) {
    return;
  }
  const bool isNew = !followed_;
  followed_ = distance;
  if (isNew) {
    const FlightPoint point = path_.at(distance);
    turn_ = kBesideTurn;
    followPitch_ = kFollowPitch;
    flyTo({point.position, std::clamp(orbit_.distance, 600.0, 2500.0), point.heading + turn_, followPitch_});
  }
}

void CameraController::stopFollowing() {
  followed_.reset();
  factor_ = 0.0;
  anchorToGround();
}

void CameraController::fly(double factor) {
  factor_ = std::max(0.0, factor);
  if (factor_ > 0.0 && !followed_) {
    follow(0.0);
  }
}

bool CameraController::isMoving() const {
  if (travel_ || (followed_ && factor_ > 0.0)) {
    return true;
  }
  if (!followed_) {
    return false;
  }
  const FlightPoint point = path_.at(*followed_);
  return length(point.position - orbit_.pivot) > 0.01 || std::abs(turnBetween(orbit_.azimuth, point.heading + turn_)) > 1e-4;
}

void CameraController::advance(double seconds) {
  pending_ = std::min(pending_ + seconds, 1.0);  // after a pause nothing races
  while (pending_ >= kStep - 1e-9) {
    step(kStep);
    pending_ -= kStep;
  }
}

void CameraController::step(double seconds) {
  if (followed_ && factor_ > 0.0) {
    const double wrapped = std::fmod(*followed_ + seconds * factor_ * path_.speed, path_.length);
    followed_ = wrapped < 0.0 ? wrapped + path_.length : wrapped;
  }
  if (followed_) {
    const FlightPoint point = path_.at(*followed_);
    if (travel_) {
      travel_->to.pivot = point.position;
    } else {
      // with time the view turns after the aircraft; the place itself is exact
      const double part = 1.0 - std::exp(-seconds / kFollowSeconds);
      orbit_.pivot = point.position;
      orbit_.azimuth += part * turnBetween(orbit_.azimuth, point.heading + turn_);
      orbit_.pitch += part * (followPitch_ - orbit_.pitch);
    }
  }
  if (travel_) {
    travel_->fraction = std::min(1.0, travel_->fraction + seconds / kFlightSeconds);
    const double t = eased(travel_->fraction);
    const CameraOrbit& from = travel_->from;
    const CameraOrbit& to = travel_->to;
    orbit_.pivot = (1.0 - t) * from.pivot + t * to.pivot;
    orbit_.distance = std::exp((1.0 - t) * std::log(from.distance) + t * std::log(to.distance));
    orbit_.azimuth = from.azimuth + t * turnBetween(from.azimuth, to.azimuth);
    orbit_.pitch = (1.0 - t) * from.pitch + t * to.pitch;
    if (travel_->fraction >= 1.0) {
      travel_.reset();
    }
  }
  keepWithinLimits();
}

}  // namespace vp::scene3d
