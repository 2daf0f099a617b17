// Whether the aircraft and the settings of a mission are such that the safety of a plan can be measured against them.

#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"
#include "core/safety/standard_air.h"

#include <fmt/core.h>

#include <algorithm>

namespace vp::safety {
namespace {

// What the settings that come with a mission's air, approach and reaction may be (README.md, settings).
constexpr double kMostDragFactor = 3.0;
constexpr double kLongestReaction = 60.0;    // s
constexpr double kMostReactionLoss = 500.0;  // m
constexpr double kLowestQnh = 850.0;         // hPa
constexpr double kHighestQnh = 1090.0;       // hPa
constexpr double kColdest = -60.0;           // K off the standard atmosphere
constexpr double kWarmest = 50.0;            // K
constexpr double kLongestFinal = 20000.0;    // m
constexpr double kSteepestSlope = 20.0;      // degrees
constexpr double kFarthestSurface = 1000.0;  // m
constexpr double kHighestKey = 3000.0;       // m
constexpr double kLongestLanding = 20000.0;  // m
constexpr double kFastestAircraft = 1e3;     // m/s
constexpr double kSlowestRoll = 1.0;         // degrees per second; 45 degrees in less than a minute
constexpr double kFastestRoll = 720.0;       // degrees per second, above those of aerobatic aircraft

bool isBetween(double value, double low, double high) {
  return value > low && value < high;
}

bool isWithin(double value, double low, double high) {
  return value >= low && value <= high;
}

/// Collects what is wrong with the aircraft.
class ProfileCheck {
public:
  explicit ProfileCheck(CheckContext& context) : context_(context) {}

  void demand(bool holds, const std::string& text) {
    if (!holds) {
      sane_ = false;
      context_.findings.violated(rule::kAircraftProfile, fmt::format("aircraft {}: {}", context_.plan.mission.aircraft.name, text));
    }
  }
  [[nodiscard]] bool isSane() const { return sane_; }

private:
  CheckContext& context_;
  bool sane_ = true;
};

void checkModelNumbers(ProfileCheck& check, const aircraft::AircraftProfile& profile) {
  check.demand(isBetween(profile.mass_kg, 0.0, 1e6), fmt::format("mass is {} kg, must be positive", profile.mass_kg));
  check.demand(isBetween(profile.wingArea_m2, 0.0, 1e4), fmt::format("wing area is {} m2, must be positive", profile.wingArea_m2));
  check.demand(isBetween(profile.zeroLiftDrag, kLeastDrag, 1e2), fmt::format("zero-lift drag is {}, which no aircraft has", profile.zeroLiftDrag));
  check.demand(isBetween(profile.inducedDrag, kLeastDrag, 1e2), fmt::format("induced drag is {}, which no aircraft has", profile.inducedDrag));
  check.demand(isBetween(profile.airDensity_kgm3, 0.01, 2.0),
               fmt::format("air density is {} kg/m3, must be between 0.01 and 2", profile.airDensity_kgm3));
  check.demand(isBetween(profile.bestGlideSpeed.si(), 0.0, kFastestAircraft),
               fmt::format("glide speed is {} m/s, must be positive", profile.bestGlideSpeed.si()));
  check.demand(!profile.glideBanks.empty(), "no bank angle for glides is given");
  const auto demandAngle = [&](const char* name, Angle angle) {
    check.demand(isBetween(angle.degrees(), 0.0, 90.0), fmt::format("{} is {} degrees, must be between 0 and 90", name, angle.degrees()));
  };
  for (const Angle bank : profile.glideBanks) {
    demandAngle("a glide bank", bank);
  }
  demandAngle("tour bank", profile.tourBank);
  demandAngle("climb limit", profile.maxClimb);
  demandAngle("descent limit", profile.maxDescent);
  if (profile.steepestDescent) {
    demandAngle("the steepest descent", *profile.steepestDescent);
  }
  check.demand(!profile.ceiling || isBetween(profile.ceiling->metres(), kLowestAltitude, kHighestAltitude), "the ceiling is no altitude");
}

/// What a profile need not give.
void checkOtherNumbers(ProfileCheck& check, const aircraft::AircraftProfile& profile) {
  const double least = profile.leastMass_kg.value_or(profile.mass_kg);
  const double most = profile.mostMass_kg.value_or(profile.mass_kg);
  check.demand(isWithin(least, 1e-3 * profile.mass_kg, profile.mass_kg) && isWithin(most, profile.mass_kg, 1e3 * profile.mass_kg),
               fmt::format("its masses range from {} to {} kg, which does not hold its {} kg", least, most, profile.mass_kg));
  check.demand(!profile.maxSpeed || isBetween(profile.maxSpeed->si(), profile.bestGlideSpeed.si(), kFastestAircraft),
               fmt::format("its greatest speed of {} m/s is not above its glide speed of {} m/s", profile.maxSpeed ? profile.maxSpeed->si() : 0.0,
                           profile.bestGlideSpeed.si()));
  check.demand(!profile.stallSpeed || isBetween(profile.stallSpeed->si(), 0.0, kFastestAircraft), "its stall speed is no speed");
  for (const std::optional<double>& drag : {profile.windmillingDrag, profile.stoppedDrag}) {
    check.demand(!drag || isBetween(*drag, kLeastDrag, 1e2),
                 fmt::format("zero-lift drag with the propeller windmilling or stopped is {}, which no aircraft has", drag.value_or(0.0)));
  }
  check.demand(!profile.climbRate || !profile.serviceCeiling ||
                   (isBetween(profile.climbRate->si(), kClimbAtServiceCeiling, kFastestAircraft) &&
                    isBetween(profile.serviceCeiling->metres(), 0.0, kHighestAltitude)),
               "its rate of climb is not more at sea level than at its service ceiling");
  check.demand(!profile.rollRate_dps || isWithin(*profile.rollRate_dps, kSlowestRoll, kFastestRoll),
               fmt::format("its rate of roll is {} degrees per second, which no aircraft has", profile.rollRate_dps.value_or(0.0)));
  check.demand(!profile.landingDistance || isBetween(profile.landingDistance->si(), 0.0, kLongestLanding),
               fmt::format("its landing distance is {} m, must be positive", profile.landingDistance ? profile.landingDistance->si() : 0.0));
}

class SettingsCheck {
public:
  explicit SettingsCheck(CheckContext& context) : context_(context) {}

  void within(const char* name, double value, double low, double high) { demand(name, fmt::format("{}", value), isWithin(value, low, high)); }
  void above(const char* name, double value, double low, double high) { demand(name, fmt::format("{}", value), value > low && value <= high); }
  void demand(const char* name, const std::string& value, bool holds) {
    if (!holds) {
      sane_ = false;
      context_.findings.violated(rule::kSettings,
                                 fmt::format("the setting {} is {}, which the safety of a plan cannot be measured against", name, value));
    }
  }
  [[nodiscard]] bool isSane() const { return sane_; }

private:
  CheckContext& context_;
  bool sane_ = true;
};

void checkAir(SettingsCheck& check, const mission::Plan& plan) {
  if (!plan.mission.atmosphere) {
    return;
  }
  check.within("QNH", plan.mission.atmosphere->qnh_hPa, kLowestQnh, kHighestQnh);
  check.within("temperature of the air", plan.mission.atmosphere->temperatureOffset_K, kColdest, kWarmest);
  double highest = kLowestAltitude;
  const auto add = [&](const std::vector<mission::DecisionPoint>& points) {
    for (const mission::DecisionPoint& point : points) {
      highest = std::max(highest, point.altitude);
    }
  };
  add(plan.tour);
  add(plan.departure ? plan.departure->points : std::vector<mission::DecisionPoint>());
  add(plan.arrival ? plan.arrival->points : std::vector<mission::DecisionPoint>());
  check.within("altitude in this air", highest, kLowestAltitude, kHighestAir);
}

void checkPower(SettingsCheck& check, const mission::Mission& mission) {
  if (mission.powerSetting.empty()) {
    return;
  }
  const auto& all = mission.aircraft.powerSettings;
  const auto chosen = std::find_if(all.begin(), all.end(), [&](const aircraft::PowerSetting& one) { return one.name == mission.powerSetting; });
  const double stall = mission.aircraft.stallSpeed ? mission.aircraft.stallSpeed->si() : 0.0;
  check.demand("power", "\"" + mission.powerSetting + "\"", chosen != all.end());
  if (chosen != all.end()) {
    check.demand("airspeed of the tour", fmt::format("{} m/s", chosen->trueAirspeed.si()),
                 isBetween(chosen->trueAirspeed.si(), stall, kFastestAircraft));
  }
}

void checkApproachSettings(SettingsCheck& check, const mission::Mission& mission) {
  const mission::ApproachSettings& approach = mission.approach;
  check.above("length of the final approach", approach.finalLength.si(), 0.0, kLongestFinal);
  check.within("start of the obstacle surface", approach.surfaceStart.si(), 0.0, kFarthestSurface);
  if (approach.slope) {
    check.above("slope of the final approach", approach.slope->degrees(), 0.0, kSteepestSlope);
    check.demand("slope of the final approach", fmt::format("{} degrees while the aircraft names no steepest descent", approach.slope->degrees()),
                 approach.kind != mission::ApproachKind::Straight || mission.aircraft.steepestDescent.has_value());
  }
  if (approach.surfaceSlope) {
    check.above("slope of the obstacle surface", *approach.surfaceSlope, 0.0, 1.0);
  }
  if (approach.keyHeight) {
    check.within("height of the high key", approach.keyHeight->si(), 0.0, kHighestKey);
  }
}

}  // namespace

bool checkProfile(CheckContext& context) {
  const aircraft::AircraftProfile& profile = context.plan.mission.aircraft;
  ProfileCheck check(context);
  checkModelNumbers(check, profile);
  checkOtherNumbers(check, profile);
  if (!check.isSane()) {
    return false;
  }
  aircraft::AircraftProfile ofOneMass = profile;
  ofOneMass.leastMass_kg.reset();
  ofOneMass.mostMass_kg.reset();
  context.model = aircraft::GlideModel(ofOneMass);
  const aircraft::GlideModel& model = context.model;
  const double radius = model.glideRadii().back();
  check.demand(radius >= kSmallestRadius && radius <= kLargestRadius && model.tourRadius() >= kSmallestRadius && model.tourRadius() <= kLargestRadius,
               fmt::format("turn radii of {} m and {} m are none of an aircraft", radius, model.tourRadius()));
  check.demand(isBetween(model.straightLoss(), kLeastLoss, 10.0) && isBetween(model.lossAt(radius), 0.0, 10.0) &&
                   isBetween(model.lossAt(model.tourRadius()), 0.0, 10.0),
               "the polar gives no glide at a bank angle that the profile allows");
  return check.isSane();
}

bool checkSettings(CheckContext& context) {
  const mission::Mission& mission = context.plan.mission;
  SettingsCheck check(context);
  context.clearance = mission.safety.clearance.si();
  context.arrivalMargin = mission.safety.arrivalMargin.si();
  context.reactionLoss = mission.safety.reactionLoss.si();
  check.within("clearance", context.clearance, 0.0, 1e4);
  check.within("arrival margin", context.arrivalMargin, 0.0, 1e4);
  check.within("reaction time", mission.safety.reactionTime.si(), 0.0, kLongestReaction);
  check.within("height lost on reaction", mission.safety.reactionLoss.si(), 0.0, kMostReactionLoss);
  check.within("drag factor", mission.safety.dragFactor, 1.0, kMostDragFactor);
  check.above("step", mission.planner.step.si(), 0.0, kLongestPath);
  check.within("beta", mission.planner.beta, 0.0, 1e6);
  if (mission.ceiling) {
    check.within("ceiling", mission.ceiling->metres(), kLowestAltitude, kHighestAltitude);
  }
  checkAir(check, context.plan);
  checkPower(check, mission);
  checkApproachSettings(check, mission);
  return check.isSane();
}

}  // namespace vp::safety
