#include "app/cli/settings.h"

#include "core/aircraft/energy.h"
#include "core/mission/glide_conditions.h"
#include "core/mission/settings_check.h"
#include "core/route/flight_totals.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace vp::cli {
namespace {

using Value = mission::SettingFault::Value;

std::string withoutSpaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// The name of the power setting that is meant: "65%" is "65 %". What is none of them stays, to be refused by its name.
std::string namedPower(const aircraft::AircraftProfile& craft, const std::string& wanted) {
  for (const aircraft::PowerSetting& power : craft.powerSettings) {
    if (withoutSpaces(power.name) == withoutSpaces(wanted)) {
      return power.name;
    }
  }
  return wanted;
}

/// A number with one of the units after it; `units` lists them with what they are worth, "" for none.
std::optional<double> measured(const std::string& text, const std::vector<std::pair<std::string, double>>& units) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data() + (text.starts_with('+') ? 1 : 0), end, value);
  if (code != std::errc() || !std::isfinite(value)) {
    return std::nullopt;
  }
  std::string unit(stop, end);
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
  for (const auto& [name, worth] : units) {
    if (unit == name) {
      return value * worth;
    }
  }
  return std::nullopt;
}

std::optional<double> metres(const std::string& text) {
  return measured(text, {{"", 1.0}, {"m", 1.0}, {"km", 1000.0}, {"ft", kMetresPerFoot}, {"nm", 1852.0}, {"NM", 1852.0}});
}

std::vector<std::string> partsAtColons(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

tl::unexpected<Error> notUnderstood(const std::string& text, const char* what, const char* examples, const char* option) {
  return fail(Errc::OutOfRange, fmt::format("\"{}\" is no {}; give for example {}", text, what, examples), option);
}

Result<void> applyReaction(const SettingOptions& options, mission::SafetySettings& safety) {
  if (options.reaction) {
    const std::optional<double> time = measured(*options.reaction, {{"", 1.0}, {"s", 1.0}});
    if (!time) {
      return notUnderstood(*options.reaction, "time", "5s", "--reaction");
    }
    safety.reactionTime = Duration::fromSi(*time);
  }
  if (options.reactionLoss) {
    const std::optional<double> loss = metres(*options.reactionLoss);
    if (!loss) {
      return notUnderstood(*options.reactionLoss, "height", "30m or 100ft", "--reaction-loss");
    }
    safety.reactionLoss = Length::fromSi(*loss);
  }
  safety.dragFactor = options.dragFactor.value_or(safety.dragFactor);
  return {};
}

Result<void> applyAir(const SettingOptions& options, std::optional<air::Atmosphere>& atmosphere) {
  if (options.air && *options.air == "none") {
    if (options.qnh) {
      return fail(Errc::OutOfRange, "a QNH makes no sense with --air none, which takes the density of the aircraft's polar at every height", "--qnh");
    }
    atmosphere.reset();
    return {};
  }
  if (options.air) {
    const std::string& text = *options.air;
    const bool isStandard = text.starts_with("ISA") || text.starts_with("isa");
    const std::optional<double> offset =
        text.size() == 3 ? std::optional(0.0) : measured(text.substr(std::min<std::size_t>(3, text.size())), {{"", 1.0}});
    if (!isStandard || !offset) {
      return notUnderstood(text, "air", "ISA, ISA+10, ISA-15 or none", "--air");
    }
    atmosphere = air::Atmosphere{*offset, atmosphere.value_or(air::Atmosphere()).qnh_hPa};
  }
  if (options.qnh) {
    atmosphere = air::Atmosphere{atmosphere.value_or(air::Atmosphere()).temperatureOffset_K, *options.qnh};
  }
  return {};
}

Result<void> applyApproachKind(const std::string& text, mission::ApproachSettings& approach) {
  constexpr const char* kOption = "--approach";
  constexpr const char* kExamples = "threshold, straight:1500m, straight:1500m:4deg, overhead or overhead:300m";
  const std::vector<std::string> parts = partsAtColons(text);
  approach.slope.reset();
  approach.keyHeight.reset();
  if (parts[0] == "threshold" && parts.size() == 1) {
    approach.kind = mission::ApproachKind::Threshold;
    return {};
  }
  if (parts[0] == "straight" && parts.size() <= 3) {
    approach.kind = mission::ApproachKind::Straight;
    const std::optional<double> length = parts.size() > 1 ? metres(parts[1]) : approach.finalLength.si();
    const std::optional<double> slope = parts.size() > 2 ? measured(parts[2], {{"", 1.0}, {"deg", 1.0}, {"°", 1.0}}) : std::nullopt;
    if (!length || (parts.size() > 2 && !slope)) {
      return notUnderstood(text, "approach", kExamples, kOption);
    }
    approach.finalLength = Length::fromSi(*length);
    if (slope) {
      approach.slope = Angle::degrees(*slope);
    }
    return {};
  }
  if (parts[0] == "overhead" && parts.size() <= 2) {
    approach.kind = mission::ApproachKind::Overhead;
    if (parts.size() == 2) {
      const std::optional<double> height = metres(parts[1]);
      if (!height) {
        return notUnderstood(text, "approach", kExamples, kOption);
      }
      approach.keyHeight = Length::fromSi(*height);
    }
    return {};
  }
  return notUnderstood(text, "approach", kExamples, kOption);
}

Result<void> applySurface(const std::string& text, mission::ApproachSettings& approach) {
  if (text == "none") {
    approach.surfaceSlope.reset();
    return {};
  }
  const std::vector<std::string> parts = partsAtColons(text);
  const std::optional<double> slope = measured(parts[0], {{"", 1.0}, {"%", 0.01}});
  const std::optional<double> start = parts.size() > 1 ? metres(parts[1]) : approach.surfaceStart.si();
  if (!slope || !start || parts.size() > 2) {
    return notUnderstood(text, "obstacle surface", "0.05, 5%, 0.05:60m or none", "--obstacle-surface");
  }
  approach.surfaceSlope = *slope;
  approach.surfaceStart = Length::fromSi(*start);
  return {};
}

Result<void> applyPropeller(const std::string& text, aircraft::Propeller& propeller) {
  if (text == "as-in-polar") {
    propeller = aircraft::Propeller::AsInPolar;
  } else if (text == "windmilling") {
    propeller = aircraft::Propeller::Windmilling;
  } else if (text == "stopped") {
    propeller = aircraft::Propeller::Stopped;
  } else {
    return fail(Errc::OutOfRange, fmt::format("\"{}\" is nothing that a propeller does; give as-in-polar, windmilling or stopped", text),
                "--propeller");
  }
  return {};
}

/// The option that a fault came from; "" if it is the mission's own.
std::string optionOf(Value value, const SettingOptions& options) {
  switch (value) {
    case Value::ReactionTime:
      return options.reaction ? "--reaction" : "";
    case Value::ReactionLoss:
      return options.reactionLoss ? "--reaction-loss" : "";
    case Value::DragFactor:
      return options.dragFactor ? "--drag-factor" : "";
    case Value::TemperatureOffset:
      return options.air ? "--air" : "";
    case Value::Qnh:
      return options.qnh ? "--qnh" : "";
    case Value::FinalLength:
    case Value::ApproachSlope:
    case Value::KeyHeight:
      return options.approach ? "--approach" : "";
    case Value::SurfaceSlope:
    case Value::SurfaceStart:
      return options.surface ? "--obstacle-surface" : "";
    case Value::Propeller:
      return options.propeller ? "--propeller" : "";
    case Value::PowerSetting:
      break;
  }
  return options.power ? "--power" : "";
}

std::string approachWords(const mission::ApproachSettings& approach) {
  std::string words;
  switch (approach.kind) {
    case mission::ApproachKind::Threshold:
      words = "approach at the threshold, by whatever curve leads there";
      break;
    case mission::ApproachKind::Straight:
      words = fmt::format("approach straight for the last {:g} m, {}", approach.finalLength.si(),
                          approach.slope ? fmt::format("{:.4g} degrees down", approach.slope->degrees()) : "at best glide");
      break;
    case mission::ApproachKind::Overhead:
      words = "approach from overhead by a full circle";
      words += approach.keyHeight ? fmt::format(", high key at least {:g} m above the runway", approach.keyHeight->si()) : "";
      break;
  }
  if (approach.surfaceSlope && approach.kind != mission::ApproachKind::Threshold) {
    words += fmt::format("; above an obstacle surface of {:g} from {:g} m before touchdown", *approach.surfaceSlope, approach.surfaceStart.si());
  }
  return words + (approach.hold ? "; circles to lose height at each site" : "");
}

}  // namespace

void addSettingOptions(CLI::App& command, SettingOptions& options) {
  const char* group = "Pilot, air and approach";
  command.add_option("--reaction", options.reaction, "Time after the engine stops in which nothing is done, 0s to 60s, for example 5s")->group(group);
  command.add_option("--reaction-loss", options.reactionLoss, "Height lost until the glide is established: 30m, 100ft")->group(group);
  command.add_option("--drag-factor", options.dragFactor, "What this pilot's glide costs more than the profile says, 1 to 3, for example 1.1")
      ->group(group);
  command.add_option("--air", options.air, "Temperature of the day: ISA, ISA+10, ISA-15; none: the density of the aircraft's polar at every height")
      ->group(group);
  command.add_option("--qnh", options.qnh, "Pressure of the day, hPa, for example 1005")->group(group);
  command
      .add_option("--approach", options.approach,
                  "How glides end: threshold; straight:1500m, a last straight, with straight:1500m:4deg at a slope of choice; overhead, a circle "
                  "from above the "
                  "runway, with overhead:300m no lower than that")
      ->group(group);
  command
      .add_option(
          "--obstacle-surface", options.surface,
          "On that last part keep only above a surface of this slope that begins so far before touchdown: 0.05, 0.05:60m; none: the whole clearance")
      ->group(group);
  CLI::Option* hold =
      command.add_flag("--hold", options.hold, "Only sites where circles before the approach can lose what height is left over")->group(group);
  command.add_flag("--no-hold", options.noHold, "Sites without room for such circles too")->group(group)->excludes(hold);
  command.add_option("--propeller", options.propeller, "After the engine stops: windmilling, stopped, or as-in-polar")->group(group);
  command
      .add_option("--power", options.power,
                  "Power setting of the aircraft that the tour is flown with, for example \"65 %\"; none: at best glide speed")
      ->group(group);
}

Result<void> applySettings(const SettingOptions& options, mission::Mission& mission) {
  if (Result<void> applied = applyReaction(options, mission.safety); !applied) {
    return applied;
  }
  if (Result<void> applied = applyAir(options, mission.atmosphere); !applied) {
    return applied;
  }
  if (options.approach) {
    if (Result<void> applied = applyApproachKind(*options.approach, mission.approach); !applied) {
      return applied;
    }
  }
  if (options.surface) {
    if (Result<void> applied = applySurface(*options.surface, mission.approach); !applied) {
      return applied;
    }
  }
  mission.approach.hold = (mission.approach.hold || options.hold) && !options.noHold;
  if (options.propeller) {
    if (Result<void> applied = applyPropeller(*options.propeller, mission.propeller); !applied) {
      return applied;
    }
  }
  if (options.power) {
    mission.powerSetting = *options.power == "none" ? "" : namedPower(mission.aircraft, *options.power);
  }
  if (const auto fault = mission::settingFaultForAircraft(mission)) {
    return fail(Errc::OutOfRange, fault->sentence, optionOf(fault->value, options));
  }
  return {};
}

std::vector<std::string> settingWords(const mission::Mission& mission) {
  std::vector<std::string> lines;
  const mission::SafetySettings& safety = mission.safety;
  if (safety.reactionTime.si() > 0.0 || safety.reactionLoss.si() > 0.0) {
    lines.push_back(fmt::format("reaction {:g} s, {:g} m of height lost in it", safety.reactionTime.si(), safety.reactionLoss.si()));
  }
  if (safety.dragFactor > 1.0) {
    lines.push_back(fmt::format("drag {:g} times that of the profile", safety.dragFactor));
  }
  if (mission.atmosphere) {
    lines.push_back(fmt::format("air ISA{}, QNH {:g} hPa",
                                mission.atmosphere->temperatureOffset_K == 0.0 ? "" : fmt::format("{:+g}", mission.atmosphere->temperatureOffset_K),
                                mission.atmosphere->qnh_hPa));
  }
  if (!(mission.approach == mission::ApproachSettings())) {
    lines.push_back(approachWords(mission.approach));
  }
  if (mission.propeller != aircraft::Propeller::AsInPolar) {
    lines.push_back(
        fmt::format("propeller {} after the engine has stopped", mission.propeller == aircraft::Propeller::Stopped ? "stopped" : "windmilling"));
  }
  if (const aircraft::PowerSetting* power = mission::powerSettingOf(mission)) {
    lines.push_back(fmt::format("power {}: {:.0f} kt true airspeed, {:g} {} per hour", power->name, power->trueAirspeed.si() / kMpsPerKnot,
                                power->perHour, aircraft::unitText(power->unit)));
  }
  return lines;
}

std::string flightWords(const mission::Plan& plan) {
  const route::FlightTotals totals = route::flightTotals(plan);
  constexpr int kMinutesPerHour = 60;
  const int minutes = static_cast<int>(std::ceil(totals.seconds / kMinutesPerHour));
  std::string said = fmt::format("{} {}:{:02} h, {:.0f} m of climb", plan.departure ? "flight" : "tour", minutes / kMinutesPerHour,
                                 minutes % kMinutesPerHour, std::ceil(totals.climbed));
  if (const aircraft::PowerSetting* power = mission::powerSettingOf(plan.mission); power != nullptr && totals.energy) {
    const char* unit = aircraft::unitText(power->unit);
    said += fmt::format(", {:.1f} {}", *totals.energy, unit);
    if (const std::optional<double>& usable = plan.mission.aircraft.usableEnergy) {
      said += fmt::format(" of {:.0f} {} usable{}", *usable, unit, *totals.energy > *usable ? ": NOT ENOUGH" : "");
    }
  }
  return said;
}

}  // namespace vp::cli
