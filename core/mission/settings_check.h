#pragma once

#include "core/mission/mission.h"

#include <optional>
#include <string>

namespace vp::mission {

/** What one setting may be, in SI units or as its name says. */
struct Limits {
  double least = 0.0;
  double most = 0.0;
};

// What air, flying and approaches are like that anybody means, so that a slip of the pen is found out.
inline constexpr Limits kReactionTime{0.0, 60.0};         ///< s
inline constexpr Limits kReactionLoss{0.0, 500.0};        ///< m
inline constexpr Limits kDragFactor{1.0, 3.0};            ///< [-]
inline constexpr Limits kTemperatureOffset{-60.0, 50.0};  ///< K; -60: an arctic winter's day at sea level
inline constexpr Limits kQnh{850.0, 1090.0};              ///< hPa; measured so far: 870 to 1084 (WMO archive of extremes)
inline constexpr Limits kFinalLength{0.0, 20000.0};       ///< m, above the least
inline constexpr Limits kApproachSlope{0.0, 20.0};        ///< degrees, above the least
inline constexpr Limits kSurfaceSlope{0.0, 1.0};          ///< [-], above the least
inline constexpr Limits kSurfaceStart{0.0, 1000.0};       ///< m
inline constexpr Limits kKeyHeight{0.0, 3000.0};          ///< m

/// Reaction that new missions begin with [s]. @source FAA-H-8083-3C, Airplane Flying Handbook: about 4 seconds until a pilot acts on a failed engine
inline constexpr double kUsualReaction = 4.0;

/** What is wrong with a setting. */
struct SettingFault {
  enum class Value {
    ReactionTime,
    ReactionLoss,
    DragFactor,
    TemperatureOffset,
    Qnh,
    FinalLength,
    ApproachSlope,
    SurfaceSlope,
    SurfaceStart,
    KeyHeight,
    Propeller,
    PowerSetting
  };
  Value value = Value::ReactionTime;
  std::string sentence;  ///< names the value and the limit; without a final stop
};

/** The first of reaction, drag factor, air and approach that is out of its limits. Values that are no numbers are out of all limits.
 *  @threads pure */
std::optional<SettingFault> settingFault(const Mission& mission);

/** The same, and what the mission's aircraft cannot do: a power setting or a propeller that its profile says nothing of, an approach
 *  steeper than its steepest descent, a drag factor that leaves no glide. Who plans or reads a mission to be planned asks this one.
 *  @threads pure */
std::optional<SettingFault> settingFaultForAircraft(const Mission& mission);

}  // namespace vp::mission
