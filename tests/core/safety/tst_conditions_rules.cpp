// Plans that keep every rule in still air of one density at one mass, and break one where the mission's conditions differ.

#include "tests/core/safety/plan_fixture.h"

#include <QTest>

#include <limits>

using namespace vp;

namespace {

using Fixture = test::PlanFixture;
using Change = test::PlanChange;

void setMasses(Fixture& f, double least, double most) {
  f.mission().aircraft.leastMass_kg = least;
  f.mission().aircraft.mostMass_kg = most;
}

void setPower(Fixture& f, double speed) {
  f.mission().aircraft.powerSettings = {{"65 %", Speed::fromSi(speed), 30.0, aircraft::PowerSetting::Unit::Litres}};
  f.mission().powerSetting = "65 %";
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestConditionsRules : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

  static void addProfileRows() {
    row("mass above the greatest", "aircraft.profile", [](Fixture& f) { setMasses(f, 900.0, 1100.0); });
    row("mass below the least", "aircraft.profile", [](Fixture& f) { setMasses(f, 1120.0, 1157.0); });
    row("mass that is no number", "aircraft.profile", [](Fixture& f) { setMasses(f, std::nan(""), 1157.0); });
    row("glide faster than allowed", "aircraft.profile", [](Fixture& f) { f.mission().aircraft.maxSpeed = Speed::fromSi(33.0); });
    row("windmill that pulls", "aircraft.profile", [](Fixture& f) { f.mission().aircraft.windmillingDrag = -0.01; });
    row("stopped propeller without drag", "aircraft.profile", [](Fixture& f) { f.mission().aircraft.stoppedDrag = 0.0; });
    row("windmill like a barn door", "aircraft.profile", [](Fixture& f) {
      f.mission().aircraft.windmillingDrag = 0.9;
      f.mission().propeller = aircraft::Propeller::Windmilling;
    });
    row("steepest descent straight down", "aircraft.profile", [](Fixture& f) { f.mission().aircraft.steepestDescent = Angle::degrees(90.0); });
    row("stalls at no speed", "aircraft.profile", [](Fixture& f) { f.mission().aircraft.stallSpeed = Speed(); });
    row("lands on the spot", "aircraft.profile", [](Fixture& f) { f.mission().aircraft.landingDistance = Length(); });
  }

  static void addSettingsRows() {
    const auto rowOf = [](const char* name, auto change) { row(name, "settings", [change](Fixture& f) { change(f.mission()); }); };
    using mission::Mission;
    rowOf("drag less than the profile's", [](Mission& m) { m.safety.dragFactor = 0.99; });
    rowOf("drag that is no number", [](Mission& m) { m.safety.dragFactor = std::nan(""); });
    rowOf("drag of three aircraft", [](Mission& m) { m.safety.dragFactor = 3.1; });
    rowOf("pressure of no weather", [](Mission& m) { m.atmosphere = air::Atmosphere{0.0, 800.0}; });
    rowOf("heat of no weather", [](Mission& m) { m.atmosphere = air::Atmosphere{51.0, 1013.25}; });
    rowOf("reacts before the failure", [](Mission& m) { m.safety.reactionTime = Duration::fromSi(-1.0); });
    rowOf("sleeps", [](Mission& m) { m.safety.reactionTime = Duration::fromSi(61.0); });
    rowOf("climbs on a failure", [](Mission& m) { m.safety.reactionLoss = Length::fromSi(-1.0); });
    rowOf("falls on a failure", [](Mission& m) { m.safety.reactionLoss = Length::fromSi(501.0); });
    rowOf("final of no length", [](Mission& m) { m.approach.finalLength = Length(); });
    rowOf("final over the horizon", [](Mission& m) { m.approach.finalLength = Length::fromSi(20001.0); });
    rowOf("slope of a lift", [](Mission& m) { m.approach.slope = Angle::degrees(21.0); });
    rowOf("level slope", [](Mission& m) { m.approach.slope = Angle(); });
    rowOf("slope without a steepest descent", [](Mission& m) {
      m.approach.kind = mission::ApproachKind::Straight;
      m.approach.slope = Angle::degrees(8.0);
    });
    rowOf("obstacle surface that falls", [](Mission& m) { m.approach.surfaceSlope = -0.05; });
    rowOf("obstacle surface that begins far off", [](Mission& m) { m.approach.surfaceStart = Length::fromSi(1001.0); });
    rowOf("key in the ground", [](Mission& m) { m.approach.keyHeight = Length::fromSi(-1.0); });
    rowOf("power that the aircraft lacks", [](Mission& m) { m.powerSetting = "65 %"; });
    row("power that stalls", "settings", [](Fixture& f) {
      f.mission().aircraft.stallSpeed = Speed::fromSi(24.0);
      setPower(f, 24.0);
    });
  }

  static void addFlightRows() {
    row("wind that only the heaviest gets on against", "wind.data", [](Fixture& f) {
      setMasses(f, 400.0, 1111.0);
      f.mission().wind = {test::layerOf(0.0, 250.0, 20.0, 4.0, 21.0)};
    });
    row("wind that the tour does not get on against", "wind.data", [](Fixture& f) {
      setPower(f, 20.0);
      f.mission().wind = {test::layerOf(0.0, 250.0, 20.0, 4.0, 21.0)};
    });
    row("glide with turns of dense air", "glide.radius", [](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{20.0, 1013.25};
      f.refit();
      f.builder.rebuildGlide(4, f.plan().sites[0].pose, 65.8);
    });
    row("glide with turns of the light aircraft", "glide.radius", [](Fixture& f) {
      setMasses(f, 900.0, 1157.0);
      f.refit();
      f.builder.rebuildGlide(4, f.plan().sites[0].pose, 65.8);
    });
    row("tour too fast for its turns", "tour.radius", [](Fixture& f) { setPower(f, 72.0); });
    row("safe altitudes of the profile's polar", "glide.safeAltitude", [](Fixture& f) { f.mission().safety.dragFactor = 1.02; });
    row("safe altitudes without the propeller", "glide.safeAltitude", [](Fixture& f) {
      f.mission().aircraft.windmillingDrag = 0.035;
      f.mission().propeller = aircraft::Propeller::Windmilling;
    });
    row("safe altitudes of the heavy aircraft in wind", "glide.safeAltitude", [](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 250.0, 20.0, 4.0, 6.0)};
      f.refit();
      f.mission().aircraft.leastMass_kg = 1000.0;
    });
    row("climb of the fast aircraft in wind", "tour.climb", [](Fixture& f) {
      f.mission().aircraft.maxClimb = Angle::degrees(10.5);
      f.mission().wind = {test::layerOf(0.0, 270.0, 0.0, 6.0, 6.0)};
      setPower(f, 30.0);
      f.refit();
      f.raise(5, 31.0);
    });
  }

private slots:
  void plan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    addProfileRows();
    addSettingsRows();
    addFlightRows();
  }

  void plan_breaksExactlyItsRule() {
    QFETCH(QString, rule);
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyBreaksExactly(fixture, rule);
  }

  void plan_isCertified_data() {
    QTest::addColumn<Change>("change");
    QTest::newRow("in thin air, heavy, with a poor pilot and a windmill") << Change([](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{20.0, 1003.0};
      setMasses(f, 900.0, 1157.0);
      f.mission().safety.dragFactor = 1.02;
      f.mission().aircraft.windmillingDrag = 0.035;
      f.mission().propeller = aircraft::Propeller::Windmilling;
      f.refit();
    });
    QTest::newRow("in wind and thin air") << Change([](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{20.0, 1003.0};
      setMasses(f, 1000.0, 1157.0);
      f.mission().wind = {test::layerOf(0.0, 250.0, 20.0, 2.0, 4.0)};
      f.refit();
    });
    QTest::newRow("at another power") << Change([](Fixture& f) { setPower(f, 55.0); });
    QTest::newRow("climbing at the speed of the power setting") << Change([](Fixture& f) {
      f.mission().aircraft.maxClimb = Angle::degrees(10.5);
      f.mission().wind = {test::layerOf(0.0, 270.0, 0.0, 6.0, 6.0)};
      setPower(f, 50.0);
      f.refit();
      f.raise(5, 31.0);
    });
    QTest::newRow("settings at their ends") << Change([](Fixture& f) {
      f.mission().approach.slope = Angle::degrees(20.0);
      f.mission().approach.surfaceSlope = 1.0;
      f.mission().approach.keyHeight = Length();
      f.mission().aircraft.maxSpeed = Speed::fromSi(80.0);
    });
  }

  void plan_isCertified() {
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyIsCertified(fixture);
  }
};

QTEST_APPLESS_MAIN(TestConditionsRules)
#include "tst_conditions_rules.moc"
