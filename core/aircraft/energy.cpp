#include "core/aircraft/energy.h"

#include "core/base/quantity.h"

namespace vp::aircraft {
namespace {

constexpr double kSecondsPerHour = 3600.0;
constexpr double kFuelEnergy = 43.5e6;  // J/kg
constexpr double kFuelDensity = 0.72;   // kg/l
constexpr double kFuelShare = 0.25;     // of its energy that lifts the aircraft
constexpr double kBatteryShare = 0.6;   // the same
constexpr double kJoulePerWattHour = 3600.0;

/// Height energy that one unit gives, J.
double liftOf(PowerSetting::Unit unit) {
  switch (unit) {
    case PowerSetting::Unit::Litres:
      return kFuelShare * kFuelEnergy * kFuelDensity;
    case PowerSetting::Unit::Kilograms:
      return kFuelShare * kFuelEnergy;
    case PowerSetting::Unit::WattHours:
      return kBatteryShare * kJoulePerWattHour;
  }
  return kFuelShare * kFuelEnergy;
}

}  // namespace

double energyUsed(const PowerSetting& setting, double mass_kg, double seconds, double climbed) {
  return setting.perHour * seconds / kSecondsPerHour + mass_kg * kGravity.si() * climbed / liftOf(setting.unit);
}

const char* unitText(PowerSetting::Unit unit) {
  switch (unit) {
    case PowerSetting::Unit::Litres:
      return "l";
    case PowerSetting::Unit::Kilograms:
      return "kg";
    case PowerSetting::Unit::WattHours:
      return "Wh";
  }
  return "";
}

}  // namespace vp::aircraft
