#include "core/mission/settings_check.h"

#include "core/aircraft/glide_model.h"
#include "core/mission/glide_conditions.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

namespace vp::mission {
namespace {

using Value = SettingFault::Value;

/// Up to six digits that matter.
std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

/// @param isAbove  the least itself is excluded
std::optional<SettingFault> outside(Value which, const char* what, double value, const Limits& limits, const char* unit, bool isAbove = false) {
  const bool isFine = (isAbove ? value > limits.least : value >= limits.least) && value <= limits.most;  // false for what is no number
  if (isFine) {
    return std::nullopt;
  }
  const std::string range = isAbove ? fmt::format("more than {} and at most {}", number(limits.least), number(limits.most))
                                    : fmt::format("between {} and {}", number(limits.least), number(limits.most));
  return SettingFault{which, fmt::format("the {} of {}{} is not {}{}", what, number(value), unit, range, unit)};
}

std::optional<SettingFault> firstOf(std::initializer_list<std::optional<SettingFault>> faults) {
  for (const std::optional<SettingFault>& fault : faults) {
    if (fault) {
      return fault;
    }
  }
  return std::nullopt;
}

std::optional<SettingFault> airFault(const std::optional<air::Atmosphere>& atmosphere) {
  if (!atmosphere) {
    return std::nullopt;
  }
  return firstOf({outside(Value::TemperatureOffset, "temperature offset", atmosphere->temperatureOffset_K, kTemperatureOffset, " K"),
                  outside(Value::Qnh, "QNH", atmosphere->qnh_hPa, kQnh, " hPa")});
}

std::optional<SettingFault> approachFault(const ApproachSettings& approach) {
  std::optional<SettingFault> fault =
      firstOf({outside(Value::FinalLength, "final approach", approach.finalLength.si(), kFinalLength, " m", true),
               outside(Value::SurfaceStart, "start of the obstacle surface", approach.surfaceStart.si(), kSurfaceStart, " m")});
  if (!fault && approach.slope) {
    fault = outside(Value::ApproachSlope, "approach slope", approach.slope->degrees(), kApproachSlope, " degrees", true);
  }
  if (!fault && approach.surfaceSlope) {
    fault = outside(Value::SurfaceSlope, "slope of the obstacle surface", *approach.surfaceSlope, kSurfaceSlope, "", true);
  }
  if (!fault && approach.keyHeight) {
    fault = outside(Value::KeyHeight, "height at high key", approach.keyHeight->si(), kKeyHeight, " m");
  }
  return fault;
}

std::optional<SettingFault> propellerFault(const Mission& mission) {
  const aircraft::AircraftProfile& craft = mission.aircraft;
  const bool isUnknown = (mission.propeller == aircraft::Propeller::Windmilling && !craft.windmillingDrag) ||
                         (mission.propeller == aircraft::Propeller::Stopped && !craft.stoppedDrag);
  if (!isUnknown) {
    return std::nullopt;
  }
  return SettingFault{Value::Propeller,
                      fmt::format("the profile of {} does not say what the drag is with the propeller {}; take the propeller as in its polar, or "
                                  "another profile",
                                  craft.name, mission.propeller == aircraft::Propeller::Stopped ? "stopped" : "windmilling")};
}

std::optional<SettingFault> powerFault(const Mission& mission) {
  if (mission.powerSetting.empty() || powerSettingOf(mission) != nullptr) {
    return std::nullopt;
  }
  std::string known;
  for (const aircraft::PowerSetting& one : mission.aircraft.powerSettings) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", one.name);
  }
  return SettingFault{Value::PowerSetting, fmt::format("{} has no power setting \"{}\"; {}", mission.aircraft.name, mission.powerSetting,
                                                       known.empty() ? "its profile has none" : "it has " + known)};
}

std::optional<SettingFault> slopeFault(const Mission& mission) {
  const ApproachSettings& approach = mission.approach;
  if (approach.kind != ApproachKind::Straight || !approach.slope) {
    return std::nullopt;
  }
  const std::optional<Angle>& steepest = mission.aircraft.steepestDescent;
  if (!steepest) {
    return SettingFault{Value::ApproachSlope, fmt::format("an approach slope of {} degrees needs a profile that says how steeply the aircraft can "
                                                          "descend, and that of {} does not; leave the slope to the best glide",
                                                          number(approach.slope->degrees()), mission.aircraft.name)};
  }
  if (*approach.slope > *steepest) {
    return SettingFault{Value::ApproachSlope, fmt::format("the approach slope of {} degrees is steeper than {} can descend, {} degrees",
                                                          number(approach.slope->degrees()), mission.aircraft.name, number(steepest->degrees()))};
  }
  return std::nullopt;
}

/// Drag above weight: straight or in a turn.
std::optional<SettingFault> glideFault(const Mission& mission) {
  const aircraft::AircraftProfile& craft = mission.aircraft;
  if (craft.mass_kg <= 0.0 || craft.bestGlideSpeed.si() <= 0.0 || craft.wingArea_m2 <= 0.0 || craft.airDensity_kgm3 <= 0.0) {
    return std::nullopt;  // no aircraft yet
  }
  aircraft::GlideConditions conditions;
  conditions.dragFactor = mission.safety.dragFactor;
  conditions.propeller = mission.propeller;
  const aircraft::GlideModel model(craft, conditions);
  const auto fault = [&](const std::string& where) {
    return SettingFault{Value::DragFactor, fmt::format("with a drag factor of {} drag exceeds the weight of {}{}, and no glide exists",
                                                       number(mission.safety.dragFactor), craft.name, where)};
  };
  if (!std::isfinite(model.straightLoss())) {
    return fault("");
  }
  for (const Angle bank : craft.glideBanks) {
    if (!std::isfinite(model.lossAt(model.radiusOf(bank)))) {
      return fault(fmt::format(" in turns of {} degrees of bank", number(bank.degrees())));
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<SettingFault> settingFault(const Mission& mission) {
  const SafetySettings& safety = mission.safety;
  return firstOf({outside(Value::ReactionTime, "reaction time", safety.reactionTime.si(), kReactionTime, " s"),
                  outside(Value::ReactionLoss, "height lost in the reaction", safety.reactionLoss.si(), kReactionLoss, " m"),
                  outside(Value::DragFactor, "drag factor", safety.dragFactor, kDragFactor, ""), airFault(mission.atmosphere),
                  approachFault(mission.approach)});
}

std::optional<SettingFault> settingFaultForAircraft(const Mission& mission) {
  if (std::optional<SettingFault> fault = settingFault(mission)) {
    return fault;
  }
  return firstOf({propellerFault(mission), powerFault(mission), slopeFault(mission), glideFault(mission)});
}

}  // namespace vp::mission
