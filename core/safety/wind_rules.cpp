// The winds that a mission wants its glides to hold for, and how a pilot reads them.

#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

bool isWithin(double value, double low, double high) {
  return value >= low && value <= high;  // false for NaN
}

/// What is wrong with a layer in itself; empty if nothing is.
std::string faultOf(const air::WindLayer& layer) {
  const air::WindSector& wind = layer.wind;
  if (!isWithin(layer.altitude.metres(), kLowestAltitude, kHighestAltitude)) {
    return fmt::format("its altitude is {} m MSL, must be between {} and {}", layer.altitude.metres(), kLowestAltitude, kHighestAltitude);
  }
  if (!isWithin(wind.from_deg, 0.0, 360.0)) {
    return fmt::format("it blows from {} degrees, must be between 0 and 360", wind.from_deg);
  }
  if (!isWithin(wind.spread_deg, 0.0, 180.0)) {
    return fmt::format("its direction is uncertain by {} degrees, must be between 0 and 180", wind.spread_deg);
  }
  if (!isWithin(wind.leastSpeed, 0.0, kHighestAltitude) || !isWithin(wind.mostSpeed, 0.0, kHighestAltitude)) {
    return fmt::format("its speeds are {} and {} m/s, which no wind has", wind.leastSpeed, wind.mostSpeed);
  }
  if (!(wind.leastSpeed <= wind.mostSpeed)) {
    return fmt::format("its least speed of {} m/s is above its greatest of {} m/s", wind.leastSpeed, wind.mostSpeed);
  }
  return {};
}

/// Rounded towards the inside, so that no wind is named that was not checked; what is round in another unit stays so.
double roundedUp(double value) {
  return std::max(0.0, std::ceil(value * 1e3 - 1e-6) / 1e3);
}

double roundedDown(double value) {
  return std::floor(value * 1e3 + 1e-6) / 1e3;
}

std::string sectorText(const air::WindSector& wind) {
  const double least = roundedUp(wind.leastSpeed / kMpsPerKnot);
  const double most = roundedDown(wind.mostSpeed / kMpsPerKnot);
  if (most == 0.0) {
    return "calm air";
  }
  std::string directions = "any direction";
  if (wind.spread_deg == 0.0) {
    directions = fmt::format("{:.10g} degrees true", wind.from_deg);
  } else if (wind.spread_deg < 180.0) {
    const auto direction = [](double degrees) { return degrees < 0.0 ? degrees + 360.0 : degrees > 360.0 ? degrees - 360.0 : degrees; };
    directions = fmt::format("{:.10g} to {:.10g} degrees true", direction(-roundedDown(wind.spread_deg - wind.from_deg)),
                             direction(roundedDown(wind.from_deg + wind.spread_deg)));
  }
  const std::string speeds = least < most ? fmt::format("{:.10g} to {:.10g}", least, most) : fmt::format("{:.10g}", most);
  return fmt::format("from {} at {} kt", directions, speeds);
}

/// What the changes of the wind with height cost at most; where they leave no glide: a sentence for each pair of layers.
ShearCost worstShear(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, std::vector<std::string>& faults) {
  ShearCost worst;
  double named = -kNoHeight;  // m MSL, lower layer of the last sentence
  for (const HeightBand& band : heightBands(conditions, profile).bands) {
    if (band.shear == 0.0) {
      continue;
    }
    const ShearCost cost = shearCost(profile, conditions, band.glide, WindSet(band.winds).strongest(), band.shear);
    worst = worst.with(cost);
    const double bottom = band.winds[0].altitude.metres();
    const double top = band.winds[1].altitude.metres();
    if (!cost.isGlide() && bottom > named) {
      named = bottom;
      faults.push_back(
          fmt::format("between the wind layers at {:.0f} and {:.0f} m MSL the wind may change by {:.1f} m/s, too fast for a glide at {:.1f} m/s that "
                      "sinks through it: give winds that differ less, or layers further apart",
                      bottom, top, band.shear * (top - bottom), band.glide.most));
    }
  }
  return worst;
}

bool isCalm(const std::vector<air::WindLayer>& layers) {
  return std::all_of(layers.begin(), layers.end(), [](const air::WindLayer& layer) { return layer.wind.isCalm(); });
}

}  // namespace

bool checkWind(CheckContext& context) {
  const mission::Mission& mission = context.plan.mission;
  bool sane = true;
  const auto demand = [&](bool holds, const std::string& text) {
    if (!holds) {
      sane = false;
      context.findings.violated(rule::kWindData, text);
    }
  };
  double strongest = 0.0;
  for (std::size_t i = 0; i < mission.wind.size(); ++i) {
    const std::string fault = faultOf(mission.wind[i]);
    demand(fault.empty(), fmt::format("wind layer {}: {}", i + 1, fault));
    demand(i == 0 || mission.wind[i].altitude.metres() > mission.wind[i - 1].altitude.metres(),
           fmt::format("wind layer {}: it is not above the layer before it", i + 1));
    strongest = std::max(strongest, mission.wind[i].wind.mostSpeed);
  }
  if (!sane) {
    return false;
  }
  const PlanConditions conditions = conditionsOf(context.plan);
  const WindGlide slowest(mission.aircraft, conditions, conditions.glide.least);
  double steepest = tan(mission.aircraft.tourBank);  // an engine failure in a turn of the tour is followed by a glide along it
  for (const Angle bank : mission.aircraft.glideBanks) {
    steepest = std::max(steepest, tan(bank));
  }
  const double headway = slowest.horizontalSpeed(steepest);
  if (!(headway > 0.0)) {
    context.findings.violated(
        rule::kAircraftProfile,
        fmt::format("aircraft {}: with this drag there is no glide at a bank angle that the profile allows", mission.aircraft.name));
    return false;
  }
  if (isCalm(mission.wind)) {
    const bool isPlain = conditions.isAsInProfile(mission.aircraft) && conditions.tour.most == conditions.glide.most;
    context.rates = isPlain ? GlideRates(context.model) : GlideRates(conditions, mission.aircraft);
    return true;
  }
  std::vector<std::string> faults;
  const ShearCost shear = worstShear(conditions, mission.aircraft, faults);
  for (const std::string& fault : faults) {
    demand(false, fault);
  }
  if (!sane) {
    return false;
  }
  const double sheared = WindGlide(mission.aircraft, conditions, conditions.glide.least, shear).horizontalSpeed(steepest);
  const double usable = conditions.glide.most > conditions.glide.least ? std::min(sheared, kMostCrab * conditions.glide.least) : sheared;
  demand(strongest < usable, fmt::format("the wind may blow at {:.1f} m/s, but the aircraft glides at {:.1f} m/s in its steepest turns, so it could "
                                         "be blown backwards",
                                         strongest, usable));
  demand(strongest < conditions.tour.least, fmt::format("the wind may blow at {:.1f} m/s, but the tour is flown at {:.1f} m/s, so it could be blown "
                                                        "backwards",
                                                        strongest, conditions.tour.least));
  if (sane) {
    context.rates = GlideRates(conditions, mission.aircraft);
    const double radius = std::max(context.rates.leastGlideRadius(), context.rates.leastTourRadius());
    demand(radius <= kLargestRadius, fmt::format("in this wind the aircraft turns with a radius of {:.0f} m, which is none of an aircraft", radius));
  }
  return sane;
}

std::string windText(const std::vector<air::WindLayer>& layers) {
  if (isCalm(layers)) {
    return "calm air";
  }
  if (layers.size() == 1) {
    return "every wind " + sectorText(layers.front().wind);
  }
  std::string text =
      "every wind that at its height lies between those of the layers next to it, and changes from the one to the other nowhere faster than evenly "
      "between those that differ most:";
  for (std::size_t i = 0; i < layers.size(); ++i) {
    text += fmt::format("{} {} ({:.0f} m MSL)", i == 0 ? "" : ",", sectorText(layers[i].wind), layers[i].altitude.metres());
  }
  return text;
}

}  // namespace vp::safety
