// Plans in winds and air that depend on the altitude: those that keep every rule and would not with all winds at every height, and those that break
// one.

#include "core/safety/failures.h"
#include "core/safety/ground_path.h"
#include "tests/core/safety/layered_cases.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

using namespace vp;

namespace {

using Fixture = test::PlanFixture;
using Change = test::PlanChange;
using Layers = std::vector<air::WindLayer>;

/// Landing is to the east: against the wind below 300 m and with it above, or the other way round.
const Layers kEastBelow{test::layerOf(300.0, 90.0, 10.0, 4.0, 7.0), test::layerOf(400.0, 270.0, 10.0, 1.0, 3.0)};
const Layers kEastAbove{test::layerOf(300.0, 270.0, 10.0, 1.0, 3.0), test::layerOf(400.0, 90.0, 10.0, 4.0, 7.0)};
/// Calm where the tour is, and below it all that the aircraft may meet; or the other way round.
const Layers kCalmAbove{test::layerOf(300.0, 0.0, 180.0, 0.0, 8.0), test::layerOf(400.0, 0.0, 0.0, 0.0, 0.0)};
const Layers kCalmBelow{test::layerOf(300.0, 0.0, 0.0, 0.0, 0.0), test::layerOf(400.0, 0.0, 180.0, 0.0, 8.0)};

void blow(Fixture& f, const Layers& layers) {
  f.mission().wind = layers;
  f.refit();
}

safety::GlideRates ratesOf(Fixture& f) {
  return {safety::conditionsOf(f.plan()), f.mission().aircraft};
}

/// What all winds of both layers and their change from the one to the other cost, counted at every height.
double hullSafeAltitude(Fixture& f, std::size_t index) {
  safety::GlideRates rates = ratesOf(f);
  const double arrival = f.plan().sites[0].site.elevation.metres() + f.mission().safety.arrivalMargin.si();
  return test::addedUp(f.point(index).pose, f.point(index).witness.pieces, arrival, f.terrain.grid(), f.mission().safety.clearance.si(), rates);
}

/// Ground 100 to 150 m behind tour point 18, westbound, that a glide along the tour just clears, in layers.
float groundUnderGlide(Fixture& f) {
  safety::GlideRates rates = ratesOf(f);
  safety::Descent descent(rates, Angle::kPi, {flight::Turn::Straight, 0.0, 150.0});
  const double reaction = f.mission().safety.reactionLoss.si();
  return static_cast<float>(descent.down(0.0, 600.0 - reaction, 150.0) - 100.0);
}

/// A final of a kilometre at a slope.
void setSlope(Fixture& f, double degrees) {
  f.mission().approach.kind = mission::ApproachKind::Straight;
  f.mission().approach.finalLength = Length::fromSi(1000.0);
  f.mission().aircraft.steepestDescent = Angle::degrees(12.0);
  f.mission().approach.slope = Angle::degrees(degrees);
  f.refit();
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestLayerRules : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

private slots:
  void plan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    row("safe altitudes of the layer above", "glide.safeAltitude", [](Fixture& f) {
      blow(f, kCalmAbove);
      safety::GlideRates rates(f.mission().aircraft, {kCalmAbove[1]});
      for (std::size_t i = 0; i < f.plan().tour.size(); ++i) {
        f.setGlide(i, f.point(i).witness.pieces, rates);
      }
    });
    row("safe altitudes of the layer below", "glide.safeAltitude", [](Fixture& f) {
      blow(f, kCalmBelow);
      safety::GlideRates rates(f.mission().aircraft, {kCalmBelow[0]});
      for (std::size_t i = 0; i < f.plan().tour.size(); ++i) {
        f.setGlide(i, f.point(i).witness.pieces, rates);
      }
    });
    row("turns of the air below", "glide.radius", [](Fixture& f) {
      blow(f, kCalmAbove);
      f.builder.rebuildGlide(4, f.plan().sites[0].pose, 80.0);
    });
    row("too low between two points", "between.height", [](Fixture& f) {
      blow(f, kCalmAbove);
      f.flyLow(5.0);
    });
    row("too low between two points after the reaction", "between.height", [](Fixture& f) {
      f.mission().safety.reactionLoss = Length::fromSi(40.0);
      blow(f, kEastBelow);
      f.flyLow(5.0);
    });
    row("too low for a glide through both layers", "glide.clearance", [](Fixture& f) {
      blow(f, kEastBelow);
      f.flyLow(30.0);
      f.raise(f.highest(), -40.0);
    });
    row("arrival through both layers", "glide.arrival", [](Fixture& f) {
      f.mission().safety.arrivalMargin = Length::fromSi(150.0);
      blow(f, kEastBelow);
      f.flyLow(30.0);
      f.raise(f.highest(), -40.0);
    });
    row("ground that a glide along the tour meets in the layer of the tour", "between.clearance", [](Fixture& f) {
      blow(f, kCalmBelow);
      f.terrain.setCell(275.0, 1625.0, groundUnderGlide(f) + 0.01F);
    });
    row("ground that a glide along the tour meets after the reaction", "between.clearance", [](Fixture& f) {
      f.mission().safety.reactionLoss = Length::fromSi(30.0);
      blow(f, kCalmAbove);
      f.terrain.setCell(275.0, 1625.0, groundUnderGlide(f) + 0.01F);
    });
    row("safe altitudes of a wind that changes more slowly with height", "glide.safeAltitude", [](Fixture& f) {
      blow(f, {test::layerOf(200.0, 90.0, 0.0, 6.0, 6.0), test::layerOf(1800.0, 270.0, 0.0, 6.0, 6.0)});
      f.mission().wind[1].altitude = geo::HeightMsl::fromMetres(800.0);  // the same winds between, the tour too
    });
    row("a wind that changes too fast for any glide", "wind.data", [](Fixture& f) {
      f.mission().wind = {test::layerOf(300.0, 90.0, 0.0, 6.0, 6.0), test::layerOf(330.0, 270.0, 0.0, 6.0, 6.0)};
    });
    row("steepest descent that a helping change of the wind makes flatter", "approach.slope", [](Fixture& f) {
      f.mission().wind = kEastBelow;
      f.builder.flyAt(800.0);
      setSlope(f, 9.0);  // 12 degrees in the wind from behind are 10.2 over ground, less a third for the change
    });
    row("slope flatter than the glide in the layer of the final", "approach.slope", [](Fixture& f) {
      f.mission().wind = kEastBelow;
      setSlope(f, 5.5);
      f.builder.flyAt(800.0);
    });
    row("safe altitudes of one layer in thin air", "glide.safeAltitude", [](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{20.0, 1003.0};
      blow(f, kEastBelow);
      f.mission().wind[0].wind.mostSpeed = 6.0;
      f.mission().wind[0].wind.leastSpeed = 6.0;
      safety::GlideRates rates = ratesOf(f);
      for (std::size_t i = 0; i < f.plan().tour.size(); ++i) {
        f.setGlide(i, f.point(i).witness.pieces, rates);
      }
      f.mission().wind[0].wind = kEastBelow[0].wind;
    });
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
    QTest::newRow("wind below, calm above") << Change([](Fixture& f) { blow(f, kCalmAbove); });
    QTest::newRow("wind above, calm below") << Change([](Fixture& f) { blow(f, kCalmBelow); });
    QTest::newRow("in thin air, heavy, reacting") << Change([](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{20.0, 1003.0};
      f.mission().aircraft.leastMass_kg = 1000.0;
      f.mission().aircraft.mostMass_kg = 1157.0;
      f.mission().safety.reactionTime = Duration::fromSi(2.0);
      f.mission().safety.reactionLoss = Length::fromSi(20.0);
      f.builder.flyAt(800.0);
      blow(f, kEastBelow);
    });
    QTest::newRow("ground that a glide along the tour clears in the layer of the tour") << Change([](Fixture& f) {
      blow(f, kCalmBelow);
      f.terrain.setCell(275.0, 1625.0, groundUnderGlide(f) - 0.01F);
    });
    // In the wind below it would be metres too low there.
    QTest::newRow("ground that a glide along the tour clears above the wind") << Change([](Fixture& f) {
      blow(f, kCalmAbove);
      f.terrain.setCell(275.0, 1625.0, groundUnderGlide(f) - 0.01F);
    });
    QTest::newRow("slope that only the wind above would be too strong for") << Change([](Fixture& f) {
      f.mission().wind = kEastAbove;
      setSlope(f, 5.5);
      f.builder.flyAt(800.0);
    });
  }

  void plan_isCertified() {
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyIsCertified(fixture);
  }

  /// At altitudes that all winds everywhere would refuse, and no lower than what both layers together ask for.
  void plan_isCertified_belowTheAltitudesOfAllWindsEverywhere() {
    for (const Layers& layers : {kCalmAbove, kCalmBelow}) {
      Fixture fixture;
      blow(fixture, layers);
      double extra = 10.0;  // to reach every point's glide from just before it
      for (fixture.flyLow(extra); extra < 30.0 && !test::checkedPlan(fixture).isSafe(); fixture.flyLow(extra)) {
        extra += 1.0;
      }
      const safety::SafetyReport report = test::checkedPlan(fixture);
      QVERIFY2(report.isSafe(), test::textsOfFindings(report));
      const std::size_t worst = fixture.highest();
      const double hull = hullSafeAltitude(fixture, worst);
      qInfo("safe from %.1f m on instead of %.1f m, flown at %.1f m", fixture.point(worst).safeAltitude, hull, fixture.point(worst).altitude);
      QVERIFY(fixture.point(worst).altitude < hull);
    }
  }

  /// What is said about arrival and clearance is what the glide from the tour's altitude comes to, not what the lowest start would.
  void margins_areThoseOfTheGlideFromTheTour() {
    Fixture fixture;
    blow(fixture, kEastBelow);
    const safety::SafetyReport report = test::checkedPlan(fixture);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    safety::GlideRates rates = ratesOf(fixture);
    double arrival = 1e9;
    double fromStart = 1e9;
    for (std::size_t i = 0; i < fixture.plan().tour.size(); ++i) {
      const mission::DecisionPoint& point = fixture.point(i);
      geo::Pose pose = point.pose;
      double height = point.altitude;
      for (const flight::Piece& piece : point.witness.pieces) {
        height = safety::Descent(rates, pose.heading, piece).down(0.0, height, piece.length);
        pose = safety::endOfPiece(pose, piece);
      }
      arrival = std::min(arrival, height - fixture.mission().safety.arrivalMargin.si());
      fromStart = std::min(fromStart, point.altitude - point.safeAltitude);
    }
    QVERIFY(std::abs(test::marginOf(report, "glide.arrival") - arrival) < 1e-9);
    QVERIFY(std::abs(test::marginOf(report, "glide.clearance") - (arrival + fixture.mission().safety.arrivalMargin.si() - 100.0)) < 1e-9);
    QVERIFY(std::abs(test::marginOf(report, "glide.clearance") - fromStart) > 1.0);
  }

  /// The last whole circle of the hold is flown in the wind at the altitude of the hold.
  void holdSurplus_isOfTheWindAtTheHold() {
    const auto warns = [](const Layers& layers, double steepest) {
      Fixture fixture;
      fixture.mission().approach.kind = mission::ApproachKind::Straight;
      fixture.mission().approach.finalLength = Length::fromSi(1000.0);
      fixture.mission().approach.hold = true;
      fixture.mission().aircraft.steepestDescent = Angle::degrees(steepest);
      blow(fixture, layers);
      fixture.plan().holds = {{0, flight::Turn::Left, 250.0, 460.0}};
      fixture.builder.flyAt(900.0);
      return test::isNamed(test::checkedPlan(fixture), "hold.surplus");
    };
    // The circle above 460 m is flown in the one layer or the other; all else is the same, the wind on the final being that of any height.
    const auto leastSteep = [&](const Layers& layers) {
      double low = 20.0;
      double high = 60.0;
      while (high - low > 0.01) {
        const double middle = 0.5 * (low + high);
        (warns(layers, middle) ? low : high) = middle;
      }
      return high;
    };
    const double calm = leastSteep(kCalmAbove);
    const double windy = leastSteep(kCalmBelow);
    QVERIFY2(calm > 20.1 && windy < 59.9 && windy > calm + 0.1, QString("%1 and %2 degrees").arg(calm).arg(windy).toUtf8());
  }
};

QTEST_APPLESS_MAIN(TestLayerRules)
#include "tst_layer_rules.moc"
