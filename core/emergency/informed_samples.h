#pragma once

#include "core/emergency/landing_goals.h"

#include <cstdint>
#include <random>
#include <vector>

namespace vp::emergency {

/** Draws poses that may lie on a better landing: within ellipses around the aircraft and one of the runways each, as long as the height at hand
 *  lasts straight flight, with headings half the time along the way there. The same poses on every platform for the same seed. */
class InformedSamples {
public:
  /** @param altitude  of the aircraft, m MSL   @pre goals has one in range; world and goals outlive this */
  InformedSamples(const landing::World& world, const LandingGoals& goals, const geo::Pose& start, double altitude, std::uint64_t seed);

  /** Only what can leave more height in hand than this counts from now on [m]. */
  void narrow(double heightInHand);

  /** The next pose. Not surely one that counts: an ellipse knows no courses, headings or ground. Outside the terrain at times. */
  geo::Pose next();
  /** A pose near another: anywhere within `reach` metres, its heading the more turned the farther that may be. */
  geo::Pose near(const geo::Pose& pose, double reach);

  /** Uniform in [0, 1). */
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  /** Area in which samples count, ellipses that overlap counted twice, at most that of the terrain [m^2]. */
  [[nodiscard]] double area() const { return area_; }
  /** True if nothing can be better any more. */
  [[nodiscard]] bool isEmpty() const { return ellipses_.empty(); }

private:
  struct Ellipse {
    std::size_t goal = 0;
    geo::Point centre;
    double longAxis = 0.0;   ///< half of it, m
    double shortAxis = 0.0;  ///< half of it, m
    double east = 1.0;       ///< direction of the long axis
    double north = 0.0;
    double sum = 0.0;  ///< of the areas up to this one, m^2
  };

  const LandingGoals& goals_;
  geo::Pose start_;
  double altitude_;
  double leastLoss_;  ///< per metre of ground, whatever the course
  geo::Box extent_;
  std::mt19937_64 engine_;
  std::vector<Ellipse> ellipses_;
  double area_ = 0.0;
};

}  // namespace vp::emergency
