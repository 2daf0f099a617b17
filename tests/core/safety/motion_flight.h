#pragma once

// An aircraft that flies by its equations of motion, for tests of the checker's bounds.

#include "core/air/wind.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/geo/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace vp::test {

/** The air at a height, and the true airspeed held in it [m/s]. */
struct AirThere {
  air::Wind wind;
  double airspeed = 0.0;
  air::Wind change;  ///< of the wind per metre of height [1/s]
};

/** An aircraft that flies one piece by its equations of motion: heading, bank, crab and path angle, in a steady wind or in one that depends on its
 *  height, as its true airspeed may. Keeps its track by the bank that the track asks for, and a little more where it has left it. Forces act in a
 *  frame that does not move with the air: sinking out of a wind into another takes what it takes to be carried along by that. */
class MotionFlight {
public:
  MotionFlight(const aircraft::AircraftProfile& profile, air::Wind wind, double course, double side, double radius)
      : MotionFlight(
            profile, [air = AirThere{wind, profile.bestGlideSpeed.si(), {}}](double) { return air; }, 0.0, course, side, radius) {}

  /** @param height  m MSL where it begins; the profile's own speed gives the drag, which does not change with the air */
  MotionFlight(const aircraft::AircraftProfile& profile, std::function<AirThere(double)> air, double height, double course, double side,
               double radius)
      : air_(std::move(air)), height_(height), side_(side), radius_(radius), course_(course) {
    const double v = profile.bestGlideSpeed.si();
    const double pressureArea = 0.5 * profile.airDensity_kgm3 * v * v * profile.wingArea_m2;
    const double weight = profile.mass_kg * kGravityThere;
    parasite_ = pressureArea * profile.zeroLiftDrag / weight;
    induced_ = profile.inducedDrag * weight / pressureArea;
    const AirThere first = air_(height);
    const double across = first.wind.north * std::cos(course) - first.wind.east * std::sin(course);
    state_ = {0.0, 0.0, course - std::asin(across / (first.airspeed * 0.99)), 0.0};
  }

  /** Height lost when `length` metres of the piece are flown. */
  double fly(double length) {
    return fly(length, [](double, double) {});
  }

  /** The same. @param visit  called with distance flown and height lost after each step */
  template <typename Visit>
  double fly(double length, const Visit& visit) {
    constexpr double kStep = 0.1;  // s
    double flown = 0.0;
    while (true) {
      const State before = state_;
      const double was = flown;
      stepWithin(kStep);
      flown = distance(flown);
      furthestOff_ = std::max(furthestOff_, std::abs(offTrack(state_)));
      if (flown < length) {
        visit(flown, -state_[3]);
      }
      if (flown >= length) {
        const double share = (length - was) / (flown - was);
        return -(before[3] + share * (state_[3] - before[3]));
      }
    }
  }
  [[nodiscard]] double furthestOff() const { return furthestOff_; }

private:
  static constexpr double kGravityThere = 9.80665;
  using State = std::array<double, 4>;  // x, y, heading, z

  /// Metres to the left of the track.
  [[nodiscard]] double offTrack(const State& s) const {
    if (side_ == 0.0) {
      return s[1] * std::cos(course_) - s[0] * std::sin(course_);
    }
    return side_ * (radius_ - std::hypot(s[0] - centre().x, s[1] - centre().y));
  }
  [[nodiscard]] geo::Point centre() const { return {-side_ * radius_ * std::sin(course_), side_ * radius_ * std::cos(course_)}; }
  [[nodiscard]] double trackCourse(const State& s) const {
    return side_ == 0.0 ? course_ : std::atan2(s[1] - centre().y, s[0] - centre().x) + side_ * Angle::kPi / 2.0;
  }
  [[nodiscard]] double distance(double before) const {
    if (side_ == 0.0) {
      return state_[0] * std::cos(course_) + state_[1] * std::sin(course_);
    }
    const double turned = side_ * (trackCourse(state_) - course_);
    return before + radius_ * wrapPi(turned - before / radius_);
  }

  [[nodiscard]] State rates(const State& s) const {
    const auto [wind, v, change] = air_(height_ + s[3]);
    double sine = parasite_ + induced_;
    double turning = 0.0;
    double horizontal = v;
    for (int i = 0; i < 12; ++i) {  // path angle, bank and turn rate belong together
      horizontal = v * std::sqrt(1.0 - sine * sine);
      const double gx = horizontal * std::cos(s[2]) + wind.east;
      const double gy = horizontal * std::sin(s[2]) + wind.north;
      const double ground = std::hypot(gx, gy);
      const double course = std::atan2(gy, gx);
      const double wanted = (side_ == 0.0 ? 0.0 : side_ * ground / radius_) - 0.02 * offTrack(s) - 0.8 * wrapPi(course - trackCourse(s));
      // The wind around the aircraft gains so much along its nose and to the left of it, and to the left of its track [m/s^2].
      const double gain = -v * sine;
      const double ahead = gain * (change.east * std::cos(s[2]) + change.north * std::sin(s[2]));
      const double left = gain * (change.north * std::cos(s[2]) - change.east * std::sin(s[2]));
      const double leftOfTrack = gain * (change.north * std::cos(course) - change.east * std::sin(course));
      turning = (wanted * ground - leftOfTrack) / (horizontal * std::cos(s[2] - course));
      // Lift: sideways what turns the airspeed and what the wind gains, and at a right angle to the path upwards the weight's part and the wind's.
      const double cosine = std::sqrt(1.0 - sine * sine);
      const double sideways = (horizontal * turning + left) / kGravityThere;
      const double upwards = cosine + sine * ahead / kGravityThere;
      const double drag = parasite_ + induced_ * (upwards * upwards + sideways * sideways);  // per weight
      sine = drag + cosine * ahead / kGravityThere;                                          // along the path: weight, drag and what the wind gains
    }
    return {horizontal * std::cos(s[2]) + wind.east, horizontal * std::sin(s[2]) + wind.north, turning, -v * sine};
  }

  /// A step, in short ones where the wind begins to change otherwise on the way.
  void stepWithin(double h) {
    constexpr double kShortest = 1e-4;  // s
    constexpr double kSmooth = 5e-4;    // 1/s, less than a layer makes
    const State before = state_;
    step(h);
    const air::Wind first = air_(height_ + before[3]).change;
    const air::Wind last = air_(height_ + state_[3]).change;
    if (h > kShortest && std::hypot(last.east - first.east, last.north - first.north) > kSmooth) {
      state_ = before;
      stepWithin(h / 2.0);
      stepWithin(h / 2.0);
    }
  }

  void step(double h) {
    const auto moved = [](const State& s, const State& d, double by) {
      return State{s[0] + by * d[0], s[1] + by * d[1], s[2] + by * d[2], s[3] + by * d[3]};
    };
    const State a = rates(state_);
    const State b = rates(moved(state_, a, h / 2.0));
    const State c = rates(moved(state_, b, h / 2.0));
    const State d = rates(moved(state_, c, h));
    for (std::size_t i = 0; i < state_.size(); ++i) {
      state_[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    }
  }

  std::function<AirThere(double)> air_;
  double height_;
  double side_;
  double radius_;
  double course_;
  double parasite_ = 0.0;
  double induced_ = 0.0;
  double furthestOff_ = 0.0;
  State state_{};
};

}  // namespace vp::test
