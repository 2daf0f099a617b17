#include "core/aircraft/aircraft_profile.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vp::aircraft {

Angle AircraftProfile::maxBank() const {
  Angle steepest = tourBank;
  for (const Angle bank : glideBanks) {
    steepest = std::max(steepest, bank);
  }
  return steepest;
}

std::vector<std::string> profileWarnings(const AircraftProfile& profile) {
  std::vector<std::string> warnings;
  const Angle bank = profile.maxBank();
  const double loadFactor = 1.0 / cos(bank);
  if (profile.stallSpeed) {
    const double ratio = profile.bestGlideSpeed / *profile.stallSpeed;
    const double available = ratio * ratio;
    if (loadFactor > available) {
      warnings.push_back(fmt::format(
          "{}: a turn at {:.0f} degrees of bank needs load factor {:.2f}, but at the glide speed of {:.1f} m/s the aircraft stalls above {:.2f} "
          "({:.0f} degrees of bank); plan with a profile of less bank before flying this",
          profile.name, bank.degrees(), loadFactor, profile.bestGlideSpeed.si(), available,
          Angle::radians(std::acos(std::min(1.0, 1.0 / available))).degrees()));
    }
  }
  if (profile.maxLoadFactor && loadFactor > *profile.maxLoadFactor) {
    warnings.push_back(fmt::format("{}: a turn at {:.0f} degrees of bank needs load factor {:.2f}, above the structural limit of {:.2f}",
                                   profile.name, bank.degrees(), loadFactor, *profile.maxLoadFactor));
  }
  return warnings;
}

}  // namespace vp::aircraft
