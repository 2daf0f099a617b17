#include "core/audit/glide_motion.h"

#include <algorithm>
#include <cmath>

namespace vp::audit {
namespace {

constexpr double kGravity = 9.80665;      // m/s^2, standard gravity
constexpr double kShearBase = 1.0;        // m of height that a change of the wind is taken over
constexpr double kStillAir = 1e-9;        // m/s: winds and their changes below it are none
constexpr double kStraightAhead = 1e-12;  // of a unit vector: a track that turns less goes straight on

/// Speed over ground along a track at this airspeed [m/s]; not a number where the wind is stronger than that across it.
double alongTrack(double airspeed, const LevelWind& wind, const Along& track) {
  const double with = wind.east * track.east + wind.north * track.north;
  const double across = wind.north * track.east - wind.east * track.north;
  return std::sqrt(airspeed * airspeed - across * across) + with;
}

double dragOf(const mission::Mission& mission) {
  const aircraft::AircraftProfile& profile = mission.aircraft;
  switch (mission.propeller) {
    case aircraft::Propeller::Windmilling:
      return profile.windmillingDrag ? *profile.windmillingDrag : profile.zeroLiftDrag;
    case aircraft::Propeller::Stopped:
      return profile.stoppedDrag ? *profile.stoppedDrag : profile.zeroLiftDrag;
    case aircraft::Propeller::AsInPolar:
      break;
  }
  return profile.zeroLiftDrag;
}

}  // namespace

GlideMotion::GlideMotion(const mission::Mission& mission, const SampleAir& air, const AirTable& table) : air_(air), table_(table) {
  const aircraft::AircraftProfile& profile = mission.aircraft;
  const double speed = profile.bestGlideSpeed.si();
  airspeed_ = speed * std::sqrt(air.mass_kg / profile.mass_kg);  // the same angle of attack at the day's mass
  for (const aircraft::PowerSetting& power : profile.powerSettings) {
    if (!mission.powerSetting.empty() && power.name == mission.powerSetting) {
      powerSpeed_ = power.trueAirspeed.si();
    }
  }
  const double pressureForce = 0.5 * profile.airDensity_kgm3 * speed * speed * profile.wingArea_m2;  // N, at the mass of the polar
  const double weight = profile.mass_kg * kGravity;
  parasitic_ = mission.safety.dragFactor * dragOf(mission) * pressureForce / weight;
  induced_ = mission.safety.dragFactor * profile.inducedDrag * weight / pressureForce;
}

MetreFlown GlideMotion::fly(const Along& before, const Along& middle, const Along& after, double length, double height) const {
  MetreFlown metre;
  const double v = airspeed(height);
  const LevelWind wind = air_.at(height);
  const LevelWind below = air_.levels.size() > 1 ? air_.at(height - kShearBase) : wind;
  const double shearEast = (wind.east - below.east) / kShearBase;
  const double shearNorth = (wind.north - below.north) / kShearBase;
  const bool isSheared = std::abs(shearEast) + std::abs(shearNorth) > kStillAir;
  const bool turns = std::abs(before.east - after.east) + std::abs(before.north - after.north) > kStraightAhead;
  double sine = parasitic_ + induced_;
  if (turns || isSheared) {
    const double sinks = sine * length;  // about: what it changes is the wind by its shear over centimetres
    const LevelWind lower{height - sinks, wind.east - shearEast * sinks, wind.north - shearNorth * sinks};
    const double speedBefore = alongTrack(v, wind, before);
    const double speedAfter = alongTrack(v, lower, after);
    const double mean = 0.5 * (speedBefore + speedAfter);
    if (!(mean > 0.0)) {
      return metre;
    }
    const double fromEast = speedBefore * before.east;
    const double fromNorth = speedBefore * before.north;
    const double toEast = speedAfter * after.east;
    const double toNorth = speedAfter * after.north;
    const double rate = mean / length;  // 1/s
    const double airEast = 0.5 * (fromEast + toEast) - 0.5 * (wind.east + lower.east);
    const double airNorth = 0.5 * (fromNorth + toNorth) - 0.5 * (wind.north + lower.north);
    const double speed = std::hypot(airEast, airNorth);
    const double across = (airEast * (toNorth - fromNorth) - airNorth * (toEast - fromEast)) / speed;
    const double turned = across / speed;                                   // rad, about
    const double lateral = rate * across * (1.0 + turned * turned / 24.0);  // the difference is a chord of what the velocity turned by
    metre.bankTangent = lateral / kGravity;
    sine += induced_ * metre.bankTangent * metre.bankTangent;
    sine /= 1.0 + (airEast * shearEast + airNorth * shearNorth) / kGravity;
  }
  if (!(sine > 0.0 && sine < 1.0)) {
    return metre;
  }
  const double overGround = alongTrack(v * std::sqrt(1.0 - sine * sine), wind, middle);
  if (!(overGround > 0.0)) {
    return metre;
  }
  metre.isPossible = true;
  metre.took = length / overGround;
  metre.lost = v * sine * metre.took;
  return metre;
}

double GlideMotion::mostGroundSpeed(double height) const {
  const LevelWind wind = air_.at(height);
  return std::max(airspeed(height), tourAirspeed(height)) + std::hypot(wind.east, wind.north);
}

double GlideMotion::bankOf(const Along& track, double curvature, double airspeed, double height) const {
  constexpr double kHalf = 0.5;  // m to each side
  const Along before{track.east + kHalf * curvature * track.north, track.north - kHalf * curvature * track.east};
  const Along after{track.east - kHalf * curvature * track.north, track.north + kHalf * curvature * track.east};
  const LevelWind wind = air_.at(height);
  const double speedBefore = alongTrack(airspeed, wind, before);
  const double speedAfter = alongTrack(airspeed, wind, after);
  const double mean = 0.5 * (speedBefore + speedAfter);
  const double airEast = mean * track.east - wind.east;
  const double airNorth = mean * track.north - wind.north;
  const double east = speedAfter * after.east - speedBefore * before.east;
  const double north = speedAfter * after.north - speedBefore * before.north;
  return std::atan(mean / (2.0 * kHalf) * (airEast * north - airNorth * east) / (std::hypot(airEast, airNorth) * kGravity));
}

double GlideMotion::sinkRate(double tangent, double height) const {
  return airspeed(height) * std::min(1.0, parasitic_ + induced_ * (1.0 + tangent * tangent));
}

}  // namespace vp::audit
