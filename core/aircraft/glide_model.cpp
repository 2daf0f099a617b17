#include "core/aircraft/glide_model.h"

#include "core/base/expect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::aircraft {

GlideModel::GlideModel(const AircraftProfile& profile)
    : airspeed_(profile.bestGlideSpeed.si()),
      weight_(profile.mass_kg * kGravity.si()),
      dynamicPressureArea_(0.5 * profile.airDensity_kgm3 * airspeed_ * airspeed_ * profile.wingArea_m2),
      zeroLiftDrag_(profile.zeroLiftDrag),
      inducedDrag_(profile.inducedDrag) {
  VP_EXPECT(airspeed_ > 0.0 && weight_ > 0.0 && dynamicPressureArea_ > 0.0);
  straightLoss_ = lossAt(0.0);
  for (const Angle bank : profile.glideBanks) {
    VP_EXPECT(bank.degrees() > 0.0 && bank.degrees() < 90.0);
    glideRadii_.push_back(radiusOf(bank));
  }
  std::sort(glideRadii_.begin(), glideRadii_.end(), std::greater<>());
  tourRadius_ = radiusOf(profile.tourBank);
  minRadius_ = glideRadii_.empty() ? tourRadius_ : std::min(tourRadius_, glideRadii_.back());
}

double GlideModel::radiusOf(Angle bank) const {
  return airspeed_ * airspeed_ / (kGravity.si() * tan(bank));
}

Angle GlideModel::bankOf(double radius) const {
  return Angle::radians(std::atan(airspeed_ * airspeed_ / (kGravity.si() * radius)));
}

double GlideModel::lossAt(double radius) const {
  const double loadFactor = radius > 0.0 ? 1.0 / cos(bankOf(radius)) : 1.0;
  const double lift = loadFactor * weight_ / dynamicPressureArea_;  // C_L
  const double sinGamma = dynamicPressureArea_ * (zeroLiftDrag_ + inducedDrag_ * lift * lift) / weight_;
  if (sinGamma >= 1.0) {
    return std::numeric_limits<double>::infinity();
  }
  return sinGamma / std::sqrt(1.0 - sinGamma * sinGamma);
}

}  // namespace vp::aircraft
