// How glides end: last parts, slopes, keys, holds and runway lengths, each broken alone.

#include "core/safety/landing_length.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

using namespace vp;

namespace {

using Fixture = test::PlanFixture;
using Change = test::PlanChange;
using mission::ApproachKind;

void approachStraight(Fixture& f) {
  f.mission().approach.kind = ApproachKind::Straight;
  f.mission().aircraft.steepestDescent = Angle::degrees(12.0);
  f.refit();
}

void approachOverhead(Fixture& f) {
  f.mission().approach.kind = ApproachKind::Overhead;
  f.refit();
}

void setSlope(Fixture& f, double degrees) {
  f.mission().approach.slope = Angle::degrees(degrees);
  approachStraight(f);
}

/// Obstacle surface of 1 : 20 from 60 m before the touchdown point.
void setSurface(Fixture& f) {
  f.mission().approach.surfaceSlope = 0.05;
  approachStraight(f);
}

/// Asks for holds and flies one over the gate.
void holdAt(Fixture& f, double lowest, double radius = 200.0) {
  f.mission().approach.hold = true;
  f.plan().holds = {{0, flight::Turn::Left, radius, lowest}};
}

/// Makes one glide end in other pieces than its safe altitude is for.
std::vector<flight::Piece>& piecesOf(Fixture& f, std::size_t index) {
  return f.point(index).witness.pieces;
}

mission::LandingSite& site(Fixture& f) {
  return f.plan().sites[0].site;
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestApproachRules : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

  static void addLastPartRows() {
    row("final a metre too short", "approach.straight", [](Fixture& f) {
      approachStraight(f);
      f.mission().approach.finalLength = Length::fromSi(1001.0);
    });
    row("turn in the final", "approach.straight", [](Fixture& f) {
      approachStraight(f);
      piecesOf(f, 4).back().length = 500.0;
      piecesOf(f, 4).push_back({flight::Turn::Right, 2000.0, 1.0});
      piecesOf(f, 4).push_back({flight::Turn::Straight, 0.0, 499.0});
    });
    row("glide that is over before it could be straight", "approach.straight", [](Fixture& f) {
      approachStraight(f);
      piecesOf(f, 4).clear();
    });
    row("nearly a circle", "approach.circle", [](Fixture& f) {
      approachOverhead(f);
      piecesOf(f, 4).back().length -= 0.01;
    });
    row("two circles in one", "approach.circle", [](Fixture& f) {
      approachOverhead(f);
      piecesOf(f, 4).back().length *= 2.0;
    });
    row("straight in instead of a circle", "approach.circle", [](Fixture& f) {
      approachOverhead(f);
      piecesOf(f, 4).push_back({flight::Turn::Straight, 0.0, 1.0});
    });
    row("circle too tight", "glide.radius", [](Fixture& f) {
      approachOverhead(f);
      piecesOf(f, 4).back() = {flight::Turn::Left, 60.0, 120.0 * Angle::kPi};
    });
    row("slope flatter than the glide", "approach.slope", [](Fixture& f) { setSlope(f, 4.5); });
    row("slope steeper than the descent", "approach.slope", [](Fixture& f) {
      setSlope(f, 12.1);
      f.builder.flyAt(800.0);
    });
    row("slope steeper than the descent with the wind behind", "approach.slope", [](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 270.0, 0.0, 0.0, 6.0)};
      setSlope(f, 11.0);
      f.builder.flyAt(800.0);
    });
    row("slope flatter than the glide against the wind", "approach.slope", [](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 90.0, 0.0, 0.0, 6.0)};
      setSlope(f, 5.5);
    });
    row("safe altitudes without the slope", "glide.safeAltitude", [](Fixture& f) {
      approachStraight(f);
      f.builder.flyAt(800.0);
      f.mission().approach.slope = Angle::degrees(8.0);
    });
    row("too low for the slope", "glide.arrival", [](Fixture& f) {
      f.mission().safety.arrivalMargin = Length::fromSi(120.0);
      setSlope(f, 8.0);
      f.flyLow(20.0);
      f.raise(f.highest(), -30.0);
    });
    row("too low at the high key", "approach.key", [](Fixture& f) {
      f.mission().approach.keyHeight = Length::fromSi(260.0);
      approachOverhead(f);
      f.flyLow(20.0);
      f.raise(f.highest(), -30.0);
    });
    row("safe altitudes without the key", "glide.safeAltitude", [](Fixture& f) {
      approachOverhead(f);
      f.mission().approach.keyHeight = Length::fromSi(260.0);
    });
    row("obstacle through the surface", "glide.safeAltitude", [](Fixture& f) {
      setSurface(f);
      f.terrain.setCell(-475.0, -1025.0, 72.0F);
    });
    row("obstacle outside the surface", "glide.safeAltitude", [](Fixture& f) {
      f.mission().approach.surfaceStart = Length::fromSi(160.0);
      setSurface(f);
      f.mission().approach.surfaceStart = Length::fromSi(60.0);
      f.terrain.setCell(-475.0, -1025.0, 72.0F);
    });
    row("surface dropped", "glide.safeAltitude", [](Fixture& f) {
      setSurface(f);
      f.mission().approach.surfaceSlope.reset();
    });
  }

  static void addHoldRows() {
    row("hold of no site", "plan.index", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0);
      f.plan().holds.push_back({1, flight::Turn::Left, 200.0, 200.0});
    });
    row("hold that is no number", "plan.number", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, std::nan(""));
    });
    row("no hold", "hold.missing", [](Fixture& f) {
      approachStraight(f);
      f.mission().approach.hold = true;
    });
    row("two holds", "hold.missing", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0);
      f.plan().holds.push_back(f.plan().holds[0]);
    });
    row("two holds where none is asked for", "hold.missing", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0);
      f.mission().approach.hold = false;
      f.plan().holds.push_back(f.plan().holds[0]);
    });
    row("hold too tight", "hold.radius", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0, 65.0);
    });
    row("hold straight on", "hold.radius", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0);
      f.plan().holds[0].turn = flight::Turn::Straight;
    });
    row("hold into the ground", "hold.clearance", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0, 700.0);
      f.terrain.setCell(-1690.0, -325.0, 120.0F);
    });
    row("hold below its gate", "hold.clearance", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 180.0);  // the final loses 88 m and ends 100 m above its ground
    });
    row("hold below the high key", "hold.clearance", [](Fixture& f) {
      f.mission().approach.keyHeight = Length::fromSi(260.0);
      approachOverhead(f);
      holdAt(f, 250.0);
    });
    row("hold over the unknown", "terrain.unknown", [](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0, 700.0);
      f.terrain.setCell(-1690.0, -325.0, terrain::kUnknownUpper);
    });
  }

  static void addLengthRows() {
    row("runway too short", "site.length", [](Fixture& f) {
      f.mission().aircraft.landingDistance = Length::fromSi(400.0);
      site(f).length = Length::fromSi(539.0);  // of unknown surface
    });
    row("runway too short in the wind from behind", "site.length", [](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 270.0, 0.0, 0.0, 5.0)};
      f.refit();
      f.mission().aircraft.landingDistance = Length::fromSi(400.0);
      site(f).length = Length::fromSi(599.0);
      site(f).surface = mission::Surface::Hard;
    });
  }

private slots:
  void plan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    addLastPartRows();
    addHoldRows();
    addLengthRows();
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
    QTest::newRow("final") << Change(approachStraight);
    QTest::newRow("final of two straights and a piece of no length") << Change([](Fixture& f) {
      approachStraight(f);
      for (std::size_t i = 0; i < f.plan().tour.size(); ++i) {
        piecesOf(f, i).back().length = 400.0;
        piecesOf(f, i).push_back({flight::Turn::Left, 100.0, 0.0});
        piecesOf(f, i).push_back({flight::Turn::Straight, 0.0, 600.0});
        piecesOf(f, i).push_back({flight::Turn::Left, 100.0, 0.0});
      }
    });
    QTest::newRow("longer final than asked for") << Change([](Fixture& f) {
      approachStraight(f);
      f.mission().approach.finalLength = Length::fromSi(500.0);
    });
    QTest::newRow("circle overhead") << Change(approachOverhead);
    QTest::newRow("circle overhead from a high key in wind") << Change([](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 200.0, 30.0, 1.0, 3.0)};
      f.mission().approach.keyHeight = Length::fromSi(200.0);
      f.mission().approach.surfaceSlope = 0.05;
      approachOverhead(f);
    });
    QTest::newRow("slope") << Change([](Fixture& f) { setSlope(f, 6.0); });
    QTest::newRow("obstacle below the surface") << Change([](Fixture& f) {
      setSurface(f);
      f.terrain.setCell(-475.0, -1025.0, 66.0F);
    });
    QTest::newRow("hold") << Change([](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0);
    });
    QTest::newRow("hold that nobody asked for") << Change([](Fixture& f) {
      approachStraight(f);
      holdAt(f, 200.0);
      f.mission().approach.hold = false;
    });
    QTest::newRow("runway just long enough") << Change([](Fixture& f) {
      f.mission().aircraft.landingDistance = Length::fromSi(400.0);
      site(f).length = Length::fromSi(541.0);
    });
    QTest::newRow("runway of unknown length") << Change([](Fixture& f) { f.mission().aircraft.landingDistance = Length::fromSi(4000.0); });
  }

  void plan_isCertified() {
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyIsCertified(fixture);
  }

  void surplusHeight_thatTheFinalCannotLose_isAWarning() {
    Fixture fixture;
    approachStraight(fixture);
    holdAt(fixture, 200.0);
    fixture.mission().aircraft.steepestDescent = Angle::degrees(17.0);
    QVERIFY(!test::isNamed(test::checkedPlan(fixture), "hold.surplus"));  // 150 m and a circle of 133 m against 305 m
    fixture.mission().aircraft.steepestDescent = Angle::degrees(15.0);
    QVERIFY(test::isNamed(test::checkedPlan(fixture), "hold.surplus"));  // 267 m
  }

  void landingLength_byHand_data() {
    QTest::addColumn<Change>("change");
    QTest::addColumn<double>("factor");
    const auto rowOf = [](const char* name, double factor, Change change) { QTest::newRow(name) << change << factor; };
    using mission::Surface;
    for (const auto& [surface, factor] : {std::pair{Surface::Hard, 1.0},
                                          {Surface::Gravel, 1.15},
                                          {Surface::Grass, 1.35},
                                          {Surface::Dirt, 1.25},
                                          {Surface::Snow, 1.25},
                                          {Surface::Unknown, 1.35}}) {
      rowOf(qPrintable(QString("surface %1").arg(static_cast<int>(surface))), factor, [surface = surface](Fixture& f) { site(f).surface = surface; });
    }
    rowOf("1000 m up", 1.225 / 1.11164, [](Fixture& f) { site(f).elevation = geo::HeightMsl::fromMetres(1000.0); });
    rowOf("hot day", 308.15 / 288.15, [](Fixture& f) { f.mission().atmosphere = air::Atmosphere{20.0, 1013.25}; });
    rowOf("wind from behind", 40.0 * 40.0 / (32.5 * 32.5), [](Fixture& f) {
      f.mission().aircraft.stallSpeed = Speed::fromSi(25.0);
      f.mission().wind = {test::layerOf(0.0, 270.0, 10.0, 2.0, 5.0)};
    });
    rowOf("wind from ahead", 31.0 * 31.0 / (32.5 * 32.5), [](Fixture& f) {
      f.mission().aircraft.stallSpeed = Speed::fromSi(25.0);
      f.mission().wind = {test::layerOf(0.0, 90.0, 0.0, 3.0, 5.0)};
    });
    rowOf("wind of either kind", 37.9 * 37.9 / (33.4 * 33.4), [](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 90.0, 0.0, 5.0, 5.0), test::layerOf(500.0, 270.0, 0.0, 3.0, 3.0)};
    });
    const auto addOtherEnd = [](Fixture& f, double elevation) {
      mission::LandingSite other = site(f);
      other.runwayIdent = "27";
      other.elevation = geo::HeightMsl::fromMetres(elevation);
      f.plan().sites.push_back({other, {}});
    };
    rowOf("two percent downhill", 1.1, [addOtherEnd](Fixture& f) { addOtherEnd(f, -20.0); });
    rowOf("uphill", 1.0, [addOtherEnd](Fixture& f) { addOtherEnd(f, 20.0); });
  }

  void landingLength_byHand() {
    QFETCH(Change, change);
    QFETCH(double, factor);
    Fixture fixture;
    fixture.mission().aircraft.landingDistance = Length::fromSi(400.0);
    site(fixture).surface = mission::Surface::Hard;
    site(fixture).landingCourse = Angle::degrees(90.0);
    site(fixture).length = Length::fromSi(1000.0);
    change(fixture);
    const std::optional<double> needed = safety::landingLength(fixture.plan(), site(fixture));
    QVERIFY2(needed && std::abs(*needed / 400.0 / factor - 1.0) < 2e-5, QByteArray::number(needed.value_or(0.0) / 400.0, 'g', 9));
    fixture.mission().aircraft.landingDistance.reset();
    QVERIFY(!safety::landingLength(fixture.plan(), site(fixture)));
  }
};

QTEST_APPLESS_MAIN(TestApproachRules)
#include "tst_approach_rules.moc"
