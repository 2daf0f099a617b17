#include "core/aircraft/wind_check.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace vp;
using aircraft::WindFault;
using aircraft::windFault;
using Value = aircraft::WindFault::Value;

namespace {

air::WindLayer layer(double feet, air::WindSector wind) {
  return {geo::HeightMsl::fromMetres(feet * kMetresPerFoot), wind};
}

air::WindLayer knots(double feet, double least, double most) {
  return layer(feet, {270.0, 0.0, least * kMpsPerKnot, most * kMpsPerKnot});
}

/// "" if there is no fault, or if it is the expected one.
std::string unlike(const std::optional<WindFault>& fault, std::size_t number, Value value, const std::string& part) {
  if (!fault) {
    return "no fault";
  }
  const bool fits = fault->layer == number && fault->value == value && fault->sentence.find(part) != std::string::npos;
  return fits ? "" : std::to_string(fault->layer) + ": " + fault->sentence;
}

}  // namespace

class TestWindCheck : public QObject {
  Q_OBJECT

private slots:
  void limits_areAccepted() {
    QVERIFY(!windFault({}));
    QVERIFY(!windFault({layer(-1640.0, {0.0, 180.0, 0.0, 0.0}), layer(65616.0, {360.0, 0.0, aircraft::kMostWind, aircraft::kMostWind})}));
  }

  void eachValue_outOfItsLimits_isNamed() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<air::WindLayer> good{knots(0.0, 10.0, 10.0)};
    const auto fault = [&](const air::WindLayer& second) { return windFault({good[0], second}); };
    QCOMPARE(unlike(fault(layer(70000.0, {})), 1, Value::Altitude, "altitude of 70000 ft is not between -1640 and 65617 ft"), std::string());
    QCOMPARE(unlike(fault(layer(5000.0, {360.5, 0.0, 1.0, 1.0})), 1, Value::From, "at 5000 ft blows from 360.5 degrees"), std::string());
    QCOMPARE(unlike(fault(layer(5000.0, {-1.0, 0.0, 1.0, 1.0})), 1, Value::From, "from -1 degrees"), std::string());
    QCOMPARE(unlike(fault(layer(5000.0, {0.0, 181.0, 1.0, 1.0})), 1, Value::Spread, "181 degrees to each side"), std::string());
    QCOMPARE(unlike(fault(knots(5000.0, -1.0, 1.0)), 1, Value::LeastSpeed, "a speed of -1 kt"), std::string());
    QCOMPARE(unlike(fault(knots(5000.0, 0.0, 201.0)), 1, Value::MostSpeed, "201 kt, but a speed lies between 0 and 200 kt"), std::string());
    QCOMPARE(unlike(fault(knots(5000.0, 20.0, 15.0)), 1, Value::MostSpeed, "15 kt, is below its least, 20 kt"), std::string());
    QVERIFY(fault(layer(nan, {})) && fault(layer(5000.0, {nan, 0.0, 1.0, 1.0})) && fault(layer(5000.0, {0.0, nan, 1.0, 1.0})));
    QVERIFY(fault(layer(5000.0, {0.0, 0.0, nan, 1.0})) && fault(layer(5000.0, {0.0, 0.0, 1.0, nan})));
  }

  void layers_outOfOrderOrTwice_areNamed() {
    QCOMPARE(unlike(windFault({knots(0.0, 1.0, 1.0), knots(0.0, 2.0, 2.0)}), 1, Value::Altitude, "the wind at 0 ft is given twice"), std::string());
    QCOMPARE(unlike(windFault({knots(5000.0, 1.0, 1.0), knots(3000.0, 2.0, 2.0)}), 1, Value::Altitude, "at 3000 ft comes after the one at 5000 ft"),
             std::string());
  }

  void wind_asStrongAsTheGlide_isRefused() {
    aircraft::AircraftProfile profile;
    profile.bestGlideSpeed = Speed::fromSi(65.0 * kMpsPerKnot);
    QVERIFY(!windFault({knots(0.0, 0.0, 64.9)}, profile));
    QCOMPARE(unlike(windFault({knots(0.0, 0.0, 65.0)}, profile), 0, Value::MostSpeed, "the wind of 65 kt at 0 ft is not below"), std::string());
    QCOMPARE(unlike(windFault({knots(0.0, 10.0, 10.0), knots(5000.0, 0.0, 70.0)}, profile), 1, Value::MostSpeed,
                    "the wind of 70 kt at 5000 ft is not below the gliding speed of 65 kt"),
             std::string());
    QVERIFY(!windFault({}, aircraft::AircraftProfile{}) && !windFault({knots(0.0, 0.0, 0.0)}, aircraft::AircraftProfile{}));
    QVERIFY(windFault({knots(0.0, 5.0, 1.0)}, profile));  // what is no wind at all is refused here too
  }

  /// Light aircraft glide slower, and dense air slows all of them: the slowest must still make way.
  void wind_asStrongAsTheSlowestGlide_isRefused() {
    aircraft::AircraftProfile profile;
    profile.bestGlideSpeed = Speed::fromSi(65.0 * kMpsPerKnot);
    profile.mass_kg = 1000.0;
    profile.airDensity_kgm3 = 1.0;
    profile.leastMass_kg = 640.0;  // 52 kt
    profile.mostMass_kg = 1200.0;
    QVERIFY(!windFault({knots(0.0, 0.0, 51.9)}, profile));
    QCOMPARE(unlike(windFault({knots(0.0, 0.0, 52.1)}, profile), 0, Value::MostSpeed,
                    "the wind of 52.1 kt at 0 ft is not below the gliding speed of 52 kt, that of the lightest aircraft in the densest air"),
             std::string());
    const aircraft::AirRange range{{}, geo::HeightMsl(), geo::HeightMsl::fromMetres(3000.0)};
    const double slowest = 52.0 / std::sqrt(air::kSeaLevelDensity);
    QVERIFY(!windFault({knots(0.0, 0.0, slowest - 0.1)}, profile, range));
    QVERIFY(windFault({knots(0.0, 0.0, slowest + 0.1)}, profile, range).has_value());
    profile.leastMass_kg.reset();
    QVERIFY(windFault({knots(0.0, 0.0, 60.0)}, profile, range).has_value());
    QVERIFY(!windFault({knots(0.0, 0.0, 60.0)}, profile));
  }
};

QTEST_APPLESS_MAIN(TestWindCheck)
#include "tst_wind_check.moc"
