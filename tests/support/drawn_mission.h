#pragma once
// Missions over the small mountain under random combinations of what a mission may ask for: reaction, approach, hold, air, masses, drag,
// propeller, power setting, wind.

#include "tests/support/band_flight.h"
#include "tests/support/ring_mission.h"

#include <QString>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace vp::test {

/// The checker of this tree takes the whole clearance on every approach and best glide speed on every tour. Set when it knows better.
inline constexpr bool kCheckerKnowsConditions = true;

/** Whether the checker understands all that a mission asks for. */
inline bool isKnownToTheChecker(const mission::Mission& mission) {
  const bool isTapered = mission.approach.surfaceSlope && mission.approach.kind != mission::ApproachKind::Threshold;
  return (kCheckerKnowsConditions || (!isTapered && mission.powerSetting.empty())) && (kCheckerKnowsBands || !hasBands(mission));
}

class Draw {
public:
  explicit Draw(int seed) : engine_(static_cast<std::uint64_t>(seed) * 7919 + 5) {}
  double between(double least, double most) { return least + (most - least) * unit_(engine_); }
  bool oneIn(int n) { return between(0.0, n) < 1.0; }

private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

inline void drawAircraft(Draw& draw, mission::Mission& mission) {
  aircraft::AircraftProfile& profile = mission.aircraft;
  profile.steepestDescent = Angle::degrees(15.0);
  profile.windmillingDrag = 0.040;
  profile.stoppedDrag = 0.037;
  profile.powerSettings = {{"65 %", Speed::fromSi(42.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
  if (draw.oneIn(2)) {
    profile.leastMass_kg = 850.0;
    profile.mostMass_kg = 1111.0;
  }
  mission.powerSetting = draw.oneIn(2) ? "65 %" : "";
  mission.propeller = static_cast<aircraft::Propeller>(static_cast<int>(draw.between(0.0, 2.999)));
  if (draw.oneIn(2)) {
    mission.atmosphere = air::Atmosphere{draw.between(-15.0, 20.0), draw.between(990.0, 1030.0)};
    mission.ceiling = geo::HeightMsl::fromMetres(3000.0);
  }
  if (draw.oneIn(2)) {
    const double speed = draw.between(0.0, 4.0);
    mission.wind = {{geo::HeightMsl(), {draw.between(0.0, 360.0), draw.between(0.0, 25.0), speed, speed + 2.0}}};
  }
}

inline void drawSafety(Draw& draw, int number, mission::Mission& mission) {
  mission.safety.arrivalMargin = Length::fromSi(draw.between(0.0, 40.0));
  mission.safety.dragFactor = draw.oneIn(2) ? 1.0 : draw.between(1.0, 1.2);
  mission.safety.reactionTime = Duration::fromSi(draw.oneIn(3) ? 0.0 : draw.between(1.0, 8.0));
  mission.safety.reactionLoss = Length::fromSi(draw.oneIn(3) ? 0.0 : draw.between(0.0, 40.0));
  mission::ApproachSettings& approach = mission.approach;
  approach.kind = static_cast<mission::ApproachKind>(number % 3);
  approach.finalLength = Length::fromSi(draw.between(300.0, 1200.0));
  if (approach.kind == mission::ApproachKind::Straight && draw.oneIn(2)) {
    approach.slope = Angle::degrees(10.5);
  }
  if (draw.oneIn(2)) {
    approach.surfaceSlope = draw.between(0.02, 0.06);
  }
  if (approach.kind == mission::ApproachKind::Overhead && draw.oneIn(2)) {
    approach.keyHeight = Length::fromSi(draw.between(100.0, 350.0));
  }
  approach.hold = draw.oneIn(2);
  mission.planner.roadmap = draw.oneIn(4) ? mission::RoadmapKind::RrtStar : mission::RoadmapKind::Lattice;
}

/// The mountain with room for approaches around it, five targets, and the settings of a number.
inline tour::PlanInput drawnInput(int number) {
  Draw draw(number);
  tour::PlanInput input = mountainInput();
  input.terrain = makeGrid(8000.0, 20.0, mountainHeight);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * Angle::kPi * i / 5;
    addTarget(input, "T" + std::to_string(i + 1), {1500.0 * std::cos(angle), 1500.0 * std::sin(angle)});
  }
  input.mission.planner.step = Length::fromSi(60.0);
  drawAircraft(draw, input.mission);
  drawSafety(draw, number, input.mission);
  if (number % 4 == 1) {
    input.mission.home = mission::HomeBase{"A/09", "B/18"};
  }
  return input;
}

/// Layers of wind where the glides of drawn missions are.
inline void drawLayers(int number, mission::Mission& mission) {
  Draw draw(1000 + number);
  const int layers = 2 + number % 3;
  double altitude = draw.between(-50.0, 300.0);
  mission.wind.clear();
  for (int i = 0; i < layers; ++i) {
    const double speed = draw.between(0.0, 8.0);
    mission.wind.push_back(
        {geo::HeightMsl::fromMetres(altitude), {draw.between(0.0, 360.0), draw.between(0.0, 25.0), speed, speed + draw.between(0.0, 2.0)}});
    altitude += draw.between(100.0, 500.0);
  }
  if (mission.approach.slope) {
    mission.approach.slope = Angle::degrees(12.0);  // as steep as the glide is in that wind, at least
  }
}

inline QString describe(const mission::Mission& m) {
  return QString("approach %1, surface %2, hold %3, reaction %4 s and %5 m, drag %6, air %7, wind %8, power '%9'")
      .arg(static_cast<int>(m.approach.kind))
      .arg(m.approach.surfaceSlope.value_or(0.0))
      .arg(m.approach.hold)
      .arg(m.safety.reactionTime.si())
      .arg(m.safety.reactionLoss.si())
      .arg(m.safety.dragFactor)
      .arg(m.atmosphere.has_value())
      .arg(m.wind.size())
      .arg(QString::fromStdString(m.powerSetting));
}

}  // namespace vp::test
