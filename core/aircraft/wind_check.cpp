#include "core/aircraft/wind_check.h"

#include "core/air/wind_shear.h"
#include "core/aircraft/glide_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vp::aircraft {
namespace {

using Value = WindFault::Value;

bool isWithin(double value, double low, double high) {
  return value >= low && value <= high;  // false for what is no number
}

/// At most one decimal, none where it is zero.
std::string rounded(double value) {
  const std::string text = fmt::format("{:.1f}", value);
  return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

std::string knots(double speed) {
  return rounded(speed / kMpsPerKnot) + " kt";
}

std::string feet(geo::HeightMsl altitude) {
  return fmt::format("{:.0f} ft", altitude.feet());
}

std::optional<WindFault> valueFault(const air::WindLayer& layer, std::size_t number) {
  const air::WindSector& wind = layer.wind;
  const auto fault = [number](Value value, std::string sentence) { return WindFault{number, value, std::move(sentence)}; };
  if (!isWithin(layer.altitude.metres(), kLowestWind, kHighestWind)) {
    return fault(Value::Altitude, fmt::format("the wind's altitude of {} is not between {:.0f} and {:.0f} ft", feet(layer.altitude),
                                              kLowestWind / kMetresPerFoot, kHighestWind / kMetresPerFoot));
  }
  const std::string place = " at " + feet(layer.altitude);
  if (!isWithin(wind.from_deg, 0.0, 360.0)) {
    return fault(Value::From, fmt::format("the wind{} blows from {} degrees, but a direction lies between 0 and 360", place, rounded(wind.from_deg)));
  }
  if (!isWithin(wind.spread_deg, 0.0, 180.0)) {
    return fault(Value::Spread,
                 fmt::format("the wind{} varies by {} degrees to each side, but a spread lies between 0 and 180", place, rounded(wind.spread_deg)));
  }
  if (!isWithin(wind.leastSpeed, 0.0, kMostWind)) {
    return fault(Value::LeastSpeed,
                 fmt::format("the wind{} has a speed of {}, but a speed lies between 0 and {}", place, knots(wind.leastSpeed), knots(kMostWind)));
  }
  if (!isWithin(wind.mostSpeed, 0.0, kMostWind)) {
    return fault(Value::MostSpeed,
                 fmt::format("the wind{} has a speed of {}, but a speed lies between 0 and {}", place, knots(wind.mostSpeed), knots(kMostWind)));
  }
  if (wind.leastSpeed > wind.mostSpeed) {
    return fault(Value::MostSpeed,
                 fmt::format("the greatest speed of the wind{}, {}, is below its least, {}", place, knots(wind.mostSpeed), knots(wind.leastSpeed)));
  }
  return std::nullopt;
}

std::optional<WindFault> orderFault(const std::vector<air::WindLayer>& winds) {
  for (std::size_t i = 1; i < winds.size(); ++i) {
    if (winds[i].altitude == winds[i - 1].altitude) {
      return WindFault{i, Value::Altitude, fmt::format("the wind at {} is given twice; give one for each altitude", feet(winds[i].altitude))};
    }
    if (winds[i].altitude < winds[i - 1].altitude) {
      return WindFault{
          i, Value::Altitude,
          fmt::format("the wind at {} comes after the one at {}; give the lowest layer first", feet(winds[i].altitude), feet(winds[i - 1].altitude))};
    }
  }
  return std::nullopt;
}

/// Winds that differ so much over so little height that a glide which sinks through them finds no way in some turn.
std::optional<WindFault> shearFault(const AircraftProfile& aircraft, const GlideConditions& conditions) {
  const std::vector<air::WindLayer>& winds = conditions.winds;
  if (winds.size() < 2) {
    return std::nullopt;
  }
  const GlideModel model = GlideModel(aircraft, conditions).everywhere();
  const auto isLost = [&](double radius) { return std::isfinite(model.lossAt(radius)) && !std::isfinite(model.mostTurnLoss(radius)); };
  const std::vector<double>& radii = model.glideRadii();
  if (!(model.shear() > 0.0) || (std::none_of(radii.begin(), radii.end(), isLost) && !isLost(model.tourRadius()))) {
    return std::nullopt;
  }
  std::size_t upper = 1;
  double most = 0.0;
  for (std::size_t i = 1; i < winds.size(); ++i) {
    const double shear = air::mostShear({winds[i - 1], winds[i]});
    if (shear > most) {
      most = shear;
      upper = i;
    }
  }
  const double height = winds[upper].altitude.metres() - winds[upper - 1].altitude.metres();
  return WindFault{upper, Value::MostSpeed,
                   fmt::format("the wind may change by {} between {} and {}; sinking through that the aircraft makes no way in a steep turn",
                               knots(most * height), feet(winds[upper - 1].altitude), feet(winds[upper].altitude))};
}

}  // namespace

std::optional<WindFault> windFault(const std::vector<air::WindLayer>& winds) {
  for (std::size_t i = 0; i < winds.size(); ++i) {
    if (std::optional<WindFault> fault = valueFault(winds[i], i)) {
      return fault;
    }
  }
  return orderFault(winds);
}

std::optional<WindFault> windFault(const std::vector<air::WindLayer>& winds, const AircraftProfile& aircraft, const std::optional<AirRange>& air) {
  if (std::optional<WindFault> fault = windFault(winds)) {
    return fault;
  }
  const bool isAnyWind = std::any_of(winds.begin(), winds.end(), [](const air::WindLayer& layer) { return !layer.wind.isCalm(); });
  if (!isAnyWind) {
    return std::nullopt;
  }
  // the slowest aircraft feels a wind most: it is what GlideModel scales the winds to
  const double slowest = glideSpeeds(aircraft, air).least;
  const char* const whose = slowest < aircraft.bestGlideSpeed.si() ? ", that of the lightest aircraft in the densest air" : "";
  for (std::size_t i = 0; i < winds.size(); ++i) {
    const double strongest = winds[i].wind.mostSpeed;
    if (strongest > 0.0 && !(strongest < slowest)) {
      return WindFault{i, Value::MostSpeed,
                       fmt::format("the wind of {} at {} is not below the gliding speed of {}{}; no glide makes way against it", knots(strongest),
                                   feet(winds[i].altitude), knots(slowest), whose)};
    }
  }
  return std::nullopt;
}

std::optional<WindFault> windFault(const AircraftProfile& aircraft, const GlideConditions& conditions) {
  if (std::optional<WindFault> fault = windFault(conditions.winds, aircraft, conditions.air)) {
    return fault;
  }
  GlideConditions still = conditions;
  still.winds.clear();
  const GlideModel model(aircraft, still);
  const SpeedRange speeds = glideSpeeds(aircraft, conditions.air);
  for (std::size_t i = 0; i < conditions.winds.size(); ++i) {
    const double strongest = conditions.winds[i].wind.mostSpeed;
    const double felt = strongest * speeds.most / speeds.least;
    const double relative = (speeds.most + felt) / (model.tourAirspeed() + felt);  // a tour flown slower than the glide turns tighter
    std::vector<double> tangents{tan(aircraft.tourBank) * relative * relative};
    std::transform(aircraft.glideBanks.begin(), aircraft.glideBanks.end(), std::back_inserter(tangents), [](Angle bank) { return tan(bank); });
    for (const double tangent : tangents) {
      const double loss = model.lossAt(speeds.most * speeds.most / (kGravity.si() * tangent));  // at that bank
      const double headway = speeds.least / std::sqrt(1.0 + loss * loss);
      if (strongest > 0.0 && std::isfinite(loss) && !(strongest < headway)) {
        return WindFault{
            i, Value::MostSpeed,
            fmt::format("the wind of {} at {} is not below the {} over ground that the aircraft glides at in a steep turn in still air; it "
                        "makes no way against it",
                        knots(strongest), feet(conditions.winds[i].altitude), knots(headway))};
      }
    }
  }
  return shearFault(aircraft, conditions);
}

}  // namespace vp::aircraft
