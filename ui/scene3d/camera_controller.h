#pragma once

#include "ui/scene3d/camera_state.h"

#include <functional>
#include <optional>

namespace vp::scene3d {

/** What the camera moves over: the ground, and where it may go. Scene space. */
struct CameraGround {
  std::function<double(geo::Point)> heightAt;  ///< of the ground with exaggeration; the base where unknown
  std::function<std::optional<Vec3>(Vec3 eye, Vec3 direction)> hit;
  Bounds extent;  ///< of the terrain
};

/** A place along the tour for following it. Scene space; heading mathematical [rad]. */
struct FlightPoint {
  Vec3 position;
  double heading = 0.0;
};

/** The tour as the camera follows it. */
struct FlightPath {
  std::function<FlightPoint(double distance)> at;  ///< distance is wrapped around the tour
  double length = 0.0;                             ///< m
  double speed = 0.0;                              ///< m/s over ground at factor 1
};

/** Where the camera stands relative to what it looks at. */
struct CameraOrbit {
  Vec3 pivot;                ///< in the middle of the picture
  double distance = 1000.0;  ///< m from the pivot to the eye
  double azimuth = 1.57;     ///< rad, mathematical: direction of view over ground
  double pitch = 0.6;        ///< rad below the horizon, 0 level .. pi/2 straight down
};

/** Moves the camera: orbit, pan and zoom by hand, animated flights to places, following the tour. No graphics in it.
 *
 *  The camera always looks at a pivot. The eye stays kClearance above the ground, the distance within limits that follow
 *  from the terrain. Pixels are those of the picture size given to setPicture(), y downwards.
 *  advance() gives the same way for the same time in steps of any size: it works in steps of kStep. */
class CameraController {
public:
  static constexpr double kClearance = 40.0;     ///< m, least height of the eye above the ground
  static constexpr double kStep = 1.0 / 120.0;   ///< s
  static constexpr double kFlightSeconds = 0.7;  ///< of an animated change of place
  static constexpr double kFollowPitch = 0.34;   ///< rad, behind and above the aircraft
  static constexpr double kBesideTurn = 0.22;    ///< rad, and a little to its right, so that the curtain is seen from the side
  static constexpr double kLowestPitch = 0.02;   ///< rad
  static constexpr double kHighestPitch = 1.5607963267948966;

  CameraController();

  void setGround(CameraGround ground);
  void setPicture(double width, double height);

  [[nodiscard]] const CameraOrbit& orbit() const { return orbit_; }
  [[nodiscard]] CameraState camera() const;

  /** Turns about the pivot. @param azimuth, pitch  change [rad] */
  void orbitBy(double azimuth, double pitch);
  /** Takes hold of the ground under a pixel; dragTo() then moves it under another. */
  void beginPan(double x, double y);
  void panTo(double x, double y);
  void endPan();
  /** Moves over ground by a part of the picture. */
  void panBy(double right, double forward);
  /** Comes nearer (factor > 1) to what is under a pixel; it stays under that pixel. */
  void zoomAt(double factor, double x, double y);

  /** Stands at once, or flies there. The way flown keeps the eye above the ground. */
  void jumpTo(const CameraOrbit& orbit);
  void flyTo(const CameraOrbit& orbit);

  /** An orbit that shows all of a box, filling the picture. */
  [[nodiscard]] CameraOrbit fitted(const Bounds& box, double azimuth, double pitch) const;

  void setPath(FlightPath path);
  /** Follows the tour at a distance along it; moving by hand then turns about the aircraft and zooms to it. */
  void follow(double distance);
  void stopFollowing();
  [[nodiscard]] bool isFollowing() const { return followed_.has_value(); }
  [[nodiscard]] std::optional<double> followedDistance() const { return followed_; }
  /** Flies along the tour at `factor` times the aircraft's speed; 0 stops. Follows if it does not already. */
  void fly(double factor);
  [[nodiscard]] double flightFactor() const { return factor_; }

  /** True while time changes the picture. */
  [[nodiscard]] bool isMoving() const;
  void advance(double seconds);

private:
  struct Travel {
    CameraOrbit from;
    CameraOrbit to;
    double fraction = 0.0;
  };
  void step(double seconds);
  void keepWithinLimits();
  void anchorToGround();
  [[nodiscard]] double largestDistance() const;
  [[nodiscard]] double groundAt(Vec3 p) const { return ground_.heightAt ? ground_.heightAt(p.ground()) : 0.0; }

  CameraGround ground_;
  CameraOrbit orbit_;
  FlightPath path_;
  double width_ = 1280.0;
  double height_ = 720.0;
  std::optional<Vec3> held_;  ///< ground point under the pointer while panning
  std::optional<Travel> travel_;
  std::optional<double> followed_;
  double turn_ = 0.0;                  ///< rad, view direction relative to the aircraft's heading while following
  double followPitch_ = kFollowPitch;  ///< rad, asked for while following; the ground may force more
  double factor_ = 0.0;
  double pending_ = 0.0;  ///< s not yet stepped
};

/** Difference of two angles, -pi .. pi. */
double turnBetween(double from, double to);

}  // namespace vp::scene3d
