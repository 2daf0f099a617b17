// One plan per rule, each breaking exactly that rule.

#include "core/geo/local_frame.h"
#include "core/safety/checker.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace vp;

namespace {

/** A plan, its terrain and the checksums of the terrain files. */
struct Fixture {
  test::PlanBuilder builder;
  test::TestTerrain terrain;
  std::vector<std::string> checksums{std::string(64, 'a')};

  mission::Plan& plan() { return builder.plan(); }
  mission::DecisionPoint& point(std::size_t index) { return builder.plan().tour[index]; }
  void raise(std::size_t index, double metres) {
    point(index).altitude += metres;
    builder.updateMetrics();
  }
  /// Lowest flat tour altitude at which nothing is violated, plus `extra`.
  void flyLow(double extra) { builder.flyAt(builder.highestSafeAltitude() + extra); }
  void rebuildGlides() {
    for (std::size_t i = 0; i < plan().tour.size(); ++i) {
      builder.rebuildGlide(i, plan().sites[0].pose, 65.7);
    }
  }
};

using Tamper = std::function<void(Fixture&)>;

safety::SafetyReport checked(Fixture& fixture) {
  const terrain::ElevationGrid grid = fixture.terrain.grid();
  const auto report = safety::check({fixture.plan(), grid, fixture.checksums}, Job());
  return report.value();
}

std::size_t indexOfHighestSafeAltitude(Fixture& fixture) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < fixture.plan().tour.size(); ++i) {
    best = fixture.point(i).safeAltitude > fixture.point(best).safeAltitude ? i : best;
  }
  return best;
}

/// Between tour points 5 and 6, 200 intervals of one metre that rise by `slope` each; back down to point 7.
void climbInShortSteps(Fixture& fixture, double slope) {
  mission::DecisionPoint point = fixture.point(5);
  fixture.point(5).onward.length = 1.0;
  std::vector<mission::DecisionPoint> steps;
  for (int i = 1; i < 200; ++i) {
    point.pose.x += 1.0;
    point.altitude += slope;
    point.onward.length = 1.0;
    steps.push_back(point);
  }
  fixture.point(6).altitude += 200.0 * slope;
  auto& tour = fixture.plan().tour;
  tour.insert(tour.begin() + 6, steps.begin(), steps.end());
  fixture.rebuildGlides();
  fixture.builder.updateMetrics();
}

/// Ground of the cell 100 to 150 m after tour point 5 that a glide from there along the tour just clears.
float highestGroundUnderGlide(const Fixture& fixture) {
  return static_cast<float>(600.0 - fixture.builder.lossOf({{flight::Turn::Straight, 0.0, 150.0}}) - 100.0);
}

void descendAt(Fixture& fixture, double radius, int turns) {
  fixture.plan().mission.planner.lowTargets = mission::LowTargets::Descend;
  fixture.plan().spirals = {{1, 600.0, 300.0, flight::Turn::Left, radius, turns, turns}};
  fixture.builder.updateMetrics();
}

}  // namespace

Q_DECLARE_METATYPE(Tamper)

class TestCheckerRules : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Tamper tamper) { QTest::newRow(name) << QString(rule) << tamper; }

  static void addStructureRows() {
    row("no tour", "plan.empty", [](Fixture& f) { f.plan().tour.clear(); });
    row("altitude that is no number", "plan.number", [](Fixture& f) { f.point(4).altitude = std::nan(""); });
    row("position beyond all bounds", "plan.number", [](Fixture& f) { f.point(4).pose.x = 1e300; });
    row("infinite glide", "plan.number", [](Fixture& f) { f.point(4).witness.pieces[1].length = std::numeric_limits<double>::infinity(); });
    row("negative length", "plan.number", [](Fixture& f) { f.point(4).onward.length = -200.0; });
    row("origin off the globe", "plan.number", [](Fixture& f) { f.plan().frameOrigin.latitude_deg = 146.0; });
    row("glide of a million pieces", "plan.number", [](Fixture& f) { f.point(4).witness.pieces.resize(1000000); });
    row("straight with a radius", "plan.piece", [](Fixture& f) { f.point(4).witness.pieces[1].radius = 65.7; });
    row("glide in thousands of circles", "plan.piece", [](Fixture& f) { f.point(4).witness.pieces[0].length = 9e5; });
    row("glide to no site of the plan", "plan.index", [](Fixture& f) { f.point(4).witness.site = 1; });
    row("glide to site -1", "plan.index", [](Fixture& f) { f.point(4).witness.site = -1; });
    row("visit of a target that is not listed", "plan.index", [](Fixture& f) { f.point(4).target = 2; });
    row("massless aircraft", "aircraft.profile", [](Fixture& f) { f.plan().mission.aircraft.mass_kg = 0.0; });
    row("bank of 90 degrees", "aircraft.profile", [](Fixture& f) { f.plan().mission.aircraft.glideBanks = {Angle::degrees(90.0)}; });
    row("airspace on no globe", "plan.number", [](Fixture& f) {
      f.plan().airspaces = {{"X", "C", {}, {}, {{146.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}}}};
      f.plan().mission.airspace.otherwise = mission::AirspaceUse::Warn;
    });
    row("tour in a forbidden airspace", "airspace.tour", [](Fixture& f) {
      const geo::LocalFrame frame(f.plan().frameOrigin);
      f.plan().airspaces = {{"X",
                             "C",
                             {mission::AirspaceLimit::Kind::Msl, 500.0},
                             {mission::AirspaceLimit::Kind::Unlimited, 0.0},
                             {frame.toLatLon({100.0, 1400.0}), frame.toLatLon({200.0, 1400.0}), frame.toLatLon({200.0, 1700.0})}}};
      f.plan().mission.airspace.otherwise = mission::AirspaceUse::Forbid;
    });
    row("polar that is a stone's", "aircraft.profile", [](Fixture& f) { f.plan().mission.aircraft.zeroLiftDrag = 3.0; });
    row("polar better than any", "aircraft.profile", [](Fixture& f) {
      f.plan().mission.aircraft.zeroLiftDrag *= 0.1;
      f.plan().mission.aircraft.inducedDrag *= 0.1;
    });
    row("polar without induced drag", "aircraft.profile", [](Fixture& f) { f.plan().mission.aircraft.inducedDrag = 1e-300; });
    row("negative clearance", "settings", [](Fixture& f) { f.plan().mission.safety.clearance = Length::fromSi(-1.0); });
  }

  static void addTerrainRows() {
    row("terrain swapped", "terrain.changed", [](Fixture& f) { f.checksums = {std::string(64, 'b')}; });
    row("terrain file missing", "terrain.changed", [](Fixture& f) { f.checksums.clear(); });
    row("other cell size", "terrain.grid", [](Fixture& f) { f.plan().terrainCell = 25.0; });
    row("unknown cell under a glide", "terrain.unknown", [](Fixture& f) { f.terrain.setCell(25.0, -325.0, terrain::kUnknownUpper); });
    row("unknown cell under the tour", "terrain.unknown", [](Fixture& f) { f.terrain.setCell(125.0, 1025.0, terrain::kUnknownUpper); });
    row("no-data value taken for ground", "terrain.unknown", [](Fixture& f) { f.terrain.setCell(125.0, 1025.0, -9999.0F); });
  }

  static void addMissionRows() {
    row("site moved in the frame", "site.position", [](Fixture& f) {
      f.plan().sites[0].pose.x += 1.0;
      f.rebuildGlides();
    });
    row("site moved on the globe", "site.data", [](Fixture& f) {
      const geo::LocalFrame frame(f.plan().frameOrigin);
      f.plan().sites[0].pose.x += 500.0;
      f.plan().sites[0].site.touchdown = frame.toLatLon(f.plan().sites[0].pose.point());
      f.plan().sites[0].site.landingCourse = frame.trueCourseOf(0.0, f.plan().sites[0].pose.point());
      f.rebuildGlides();
    });
    row("site lowered", "site.data", [](Fixture& f) { f.plan().sites[0].site.elevation = geo::HeightMsl::fromMetres(-5.0); });
    row("site from nowhere", "site.excluded", [](Fixture& f) { f.plan().mission.sites.clear(); });
    row("site excluded", "site.excluded", [](Fixture& f) { f.plan().mission.siteFilter.exclude = {"TEST"}; });
    row("wrong end of a one-way runway", "site.excluded", [](Fixture& f) { f.plan().mission.siteFilter.oneWay = {"TEST/27"}; });
    row("approximate site where none is wanted", "site.excluded", [](Fixture& f) {
      f.plan().mission.airfields = {{"airports.csv", "runways.csv"}};
      f.plan().mission.sites.clear();
      f.plan().mission.siteFilter.approximate = false;
      f.plan().sites[0].site.approximations = {"course from the runway's name"};
    });
    row("target dropped from the plan", "target.skipped", [](Fixture& f) {
      f.plan().targets.pop_back();
      f.point(18).target = -1;
      f.builder.updateMetrics();
    });
    row("target never visited", "target.skipped", [](Fixture& f) {
      f.point(18).target = -1;
      f.builder.updateMetrics();
    });
    row("target lowered", "target.data", [](Fixture& f) { f.plan().mission.targets[1].height_m += 20.0; });
    row("target that nobody asked for", "target.data", [](Fixture& f) { f.plan().mission.targets.pop_back(); });
    row("target moved in the frame", "target.position", [](Fixture& f) {
      f.plan().targets[1].point.x += 200.0;
      f.point(18).target = -1;
      f.point(17).target = 1;
    });
    row("target put below the ground", "target.altitude", [](Fixture& f) {
      f.plan().targets[0].altitude -= 30.0;
      f.builder.updateMetrics();
    });
    row("ground rising under a target", "target.altitude", [](Fixture& f) { f.terrain.setCell(-375.0, 1025.0, 30.0F); });
    row("target passed beside it", "target.missed", [](Fixture& f) { std::swap(f.point(18).target, f.point(19).target); });
    row("target passed below it", "target.low", [](Fixture& f) {
      f.plan().mission.targets[1].height_m = 650.0;
      f.plan().targets[1].target.height_m = 650.0;
      f.plan().targets[1].altitude = 650.0;
      f.plan().metrics.penalty = 2.0 * 490.0;
      f.plan().metrics.cost = f.plan().metrics.length + f.plan().metrics.penalty;
    });
    row("length that is not true", "metrics.mismatch", [](Fixture& f) { f.plan().metrics.length -= 50.0; });
    row("cost that is not true", "metrics.mismatch", [](Fixture& f) { f.plan().metrics.cost += 50.0; });
    row("bound above the tour that was refined", "metrics.bound", [](Fixture& f) {
      f.plan().metrics.sampledCost = f.plan().metrics.cost + 10.0;
      f.plan().metrics.lowerBound = f.plan().metrics.cost + 20.0;
    });
    row("refined to something dearer", "metrics.bound", [](Fixture& f) {
      f.plan().metrics.lowerBound = 0.0;
      f.plan().metrics.sampledCost = f.plan().metrics.cost - 10.0;
    });
    row("bound of any tour above the cost", "metrics.bound", [](Fixture& f) { f.plan().metrics.freeLowerBound = f.plan().metrics.cost + 1.0; });
    row("bound above the cost", "metrics.bound", [](Fixture& f) { f.plan().metrics.lowerBound = f.plan().metrics.cost + 1.0; });
  }

  static void addTourRows() {
    row("gap", "tour.gap", [](Fixture& f) { f.point(4).onward.length -= 0.01; });
    row("jump of the heading", "tour.gap", [](Fixture& f) {
      f.point(5).pose.heading = 2e-6;
      f.point(5).onward.length -= 1e-9;
    });
    row("turn where the tour goes straight", "tour.gap", [](Fixture& f) { f.point(4).onward = {flight::Turn::Left, 300.0, 200.0}; });
    row("turn too tight", "tour.radius", [](Fixture& f) { f.plan().mission.aircraft.tourBank = Angle::degrees(20.0); });
    row("decision points too far apart", "tour.spacing", [](Fixture& f) { f.plan().mission.planner.step = Length::fromSi(199.0); });
    row("climb too steep", "tour.climb", [](Fixture& f) {
      f.plan().mission.aircraft.maxClimb = Angle::degrees(12.0);
      f.raise(5, 50.0);
    });
    row("descent too steep on the closing interval", "tour.descent", [](Fixture& f) {
      f.plan().mission.aircraft.maxDescent = Angle::degrees(12.0);
      f.raise(f.plan().tour.size() - 1, 45.0);
    });
    row("above the mission's ceiling", "tour.ceiling", [](Fixture& f) { f.plan().mission.ceiling = geo::HeightMsl::fromMetres(599.0); });
    row("above the aircraft's ceiling", "tour.ceiling", [](Fixture& f) {
      f.plan().mission.ceiling = geo::HeightMsl::fromMetres(700.0);
      f.plan().mission.aircraft.ceiling = geo::HeightMsl::fromMetres(599.0);
    });
    row("wall across a straight between decision points", "tour.clearance", [](Fixture& f) { f.terrain.setCell(125.0, 1025.0, 3000.0F); });
    row("wall touched along a grid line only", "tour.clearance", [](Fixture& f) { f.terrain.setCell(125.0, 975.0, 3000.0F); });
    row("wall under a turn between decision points", "tour.clearance", [](Fixture& f) { f.terrain.setCell(1125.0, 1025.0, 3000.0F); });
    row("ground a metre too high", "tour.clearance", [](Fixture& f) { f.terrain.setCell(125.0, 1025.0, 501.0F); });
    row("below the safe altitude that the plan gives", "tour.safeAltitude", [](Fixture& f) { f.point(4).safeAltitude = 601.0; });
    row("turn that no glide could follow", "between.radius", [](Fixture& f) {
      f.plan().mission.aircraft.glideBanks = {Angle::degrees(15.0)};
      for (std::size_t i = 0; i < f.plan().tour.size(); ++i) {
        f.builder.rebuildGlide(i, f.plan().sites[0].pose, 430.0);
      }
      f.builder.flyAt(1500.0);
    });
    row("too low between points that are high enough", "between.height", [](Fixture& f) { f.flyLow(5.0); });
    row("ground that the tour meets in a descent", "tour.clearance", [](Fixture& f) {
      f.raise(6, -20.0);  // 590 m where the cell begins, 585 m where it ends
      f.terrain.setCell(125.0, 1025.0, 487.0F);
    });
    row("a millimetre too much on each of many short intervals", "tour.climb", [](Fixture& f) {
      f.plan().mission.aircraft.maxDescent = Angle::degrees(20.0);
      climbInShortSteps(f, std::tan(Angle::degrees(15.0).radians()) + 0.0009);
    });
    row("ground that a glide along the tour meets at its last edge", "between.clearance",
        [](Fixture& f) { f.terrain.setCell(125.0, 1025.0, highestGroundUnderGlide(f) + 0.01F); });
    row("ground that only a glide along the tour meets", "between.clearance", [](Fixture& f) { f.terrain.setCell(125.0, 1025.0, 495.0F); });
  }

  static void addGlideRows() {
    row("altitude lowered at one point, low arrival", "glide.arrival", [](Fixture& f) {
      f.plan().mission.safety.arrivalMargin = Length::fromSi(150.0);
      f.rebuildGlides();
      f.flyLow(30.0);
      f.raise(indexOfHighestSafeAltitude(f), -40.0);
    });
    row("altitude lowered at one point, low over ground", "glide.clearance", [](Fixture& f) {
      f.flyLow(30.0);
      f.raise(indexOfHighestSafeAltitude(f), -40.0);
    });
    row("block under glides", "glide.clearance", [](Fixture& f) { f.terrain.setCell(25.0, -325.0, 3000.0F); });
    row("safe altitude understated", "glide.safeAltitude", [](Fixture& f) { f.point(4).safeAltitude -= 0.02; });
    row("ground that makes a safe altitude too low", "glide.safeAltitude", [](Fixture& f) { f.terrain.setCell(25.0, -975.0, 20.0F); });
    row("glide cut short", "glide.site", [](Fixture& f) { f.point(4).witness.pieces[1].length -= 10.0; });
    row("glide without pieces", "glide.heading glide.site", [](Fixture& f) { f.point(15).witness.pieces.clear(); });
    row("glide that arrives off the landing course", "glide.heading", [](Fixture& f) {
      geo::Pose off = f.plan().sites[0].pose;
      off.heading += 0.01;
      f.builder.rebuildGlide(4, off, 65.7);
    });
    row("glide against the landing course", "glide.heading", [](Fixture& f) {
      geo::Pose off = f.plan().sites[0].pose;
      off.heading += 3.14159265358979;
      f.builder.rebuildGlide(4, off, 65.7);
    });
    row("glide with turns too tight", "glide.radius", [](Fixture& f) { f.builder.rebuildGlide(4, f.plan().sites[0].pose, 60.0); });
    row("straight turned into a turn of radius 0", "glide.radius", [](Fixture& f) { f.point(4).witness.pieces[1].turn = flight::Turn::Left; });
    row("glide of another point", "glide.site", [](Fixture& f) {
      f.point(4).witness = f.point(5).witness;
      f.point(4).safeAltitude = f.point(5).safeAltitude;
    });
  }

  static void addSpiralRows() {
    row("spiral that the mission does not allow", "spiral.notAllowed", [](Fixture& f) {
      descendAt(f, 200.0, 2);
      f.plan().mission.planner.lowTargets = mission::LowTargets::PassAbove;
    });
    row("spiral of the wrong heights", "spiral.data", [](Fixture& f) {
      descendAt(f, 200.0, 2);
      f.plan().spirals[0].bottom = 290.0;  // below the target
      f.builder.updateMetrics();
      f.plan().metrics.penalty += 20.0;  // below the target nothing is gained
      f.plan().metrics.cost += 20.0;
    });
    row("spiral of half a way", "spiral.data", [](Fixture& f) {
      descendAt(f, 200.0, 2);
      f.plan().spirals[0].turnsUp = 0;
      f.builder.updateMetrics();
    });
    row("two spirals at one target", "spiral.data", [](Fixture& f) {
      descendAt(f, 200.0, 2);
      f.plan().spirals.push_back(f.plan().spirals[0]);
      f.builder.updateMetrics();
      f.plan().metrics.penalty += 600.0;  // the second descent is not rewarded
      f.plan().metrics.cost += 600.0;
    });
    row("spiral too tight", "spiral.radius", [](Fixture& f) { descendAt(f, 50.0, 9); });
    row("spiral too steep", "spiral.pitch", [](Fixture& f) { descendAt(f, 100.0, 1); });
    row("spiral into the ground", "spiral.clearance", [](Fixture& f) {
      descendAt(f, 200.0, 2);
      const geo::Pose pose = f.point(18).pose;  // westbound, so the circle lies to the south of it
      f.terrain.setCell(pose.x + 196.0, pose.y - 204.0, 350.0F);
    });
  }

private slots:
  void untouchedPlan_isCertified() {
    Fixture fixture;
    const safety::SafetyReport report = checked(fixture);
    QCOMPARE(test::rulesBroken(report), std::string());
    QVERIFY(report.isSafe());
    QCOMPARE(report.certificate->pointsChecked, std::int64_t{30});
  }

  void variantsWithinTheRules_areCertified_data() {
    QTest::addColumn<Tamper>("change");
    QTest::newRow("just high enough") << Tamper([](Fixture& f) { f.flyLow(18.5); });
    QTest::newRow("ground under the tour with room for the glide") << Tamper([](Fixture& f) { f.terrain.setCell(125.0, 1025.0, 480.0F); });
    QTest::newRow("ground as high as the clearance allows") << Tamper([](Fixture& f) {
      f.terrain.setCell(125.0, 1025.0, 500.0F);
      f.point(6).altitude += 15.0;
      f.builder.updateMetrics();
      f.point(5).altitude += 15.0;
      f.builder.updateMetrics();
    });
    QTest::newRow("ground as high as the glide along the tour allows")
        << Tamper([](Fixture& f) { f.terrain.setCell(125.0, 1025.0, highestGroundUnderGlide(f) - 0.01F); });
    QTest::newRow("as steep as allowed in many short intervals")
        << Tamper([](Fixture& f) { climbInShortSteps(f, std::tan(Angle::degrees(15.0).radians())); });
    QTest::newRow("target on high ground") << Tamper([](Fixture& f) {
      f.terrain.setCell(-375.0, 1025.0, 30.0F);
      f.plan().targets[0].altitude += 30.0;
      f.builder.updateMetrics();
    });
    QTest::newRow("rounded by less than the tolerances") << Tamper([](Fixture& f) {
      f.point(4).pose.x += 4e-4;
      f.point(4).safeAltitude -= 0.005;
    });
    QTest::newRow("wall right beside the tour") << Tamper([](Fixture& f) { f.terrain.setCell(125.0, 1675.0, 3000.0F); });
    QTest::newRow("wide circle of 30 degrees of bank") << Tamper([](Fixture& f) { f.builder.rebuildGlide(4, f.plan().sites[0].pose, 197.2); });
    QTest::newRow("tour of one point and one circle") << Tamper([](Fixture& f) {
      f.plan().mission.planner.step = Length::fromSi(1885.0);
      f.plan().mission.targets.clear();
      f.plan().targets.clear();
      f.plan().tour.resize(1);
      f.point(0).onward = {flight::Turn::Left, 300.0, 600.0 * Angle::kPi};
      f.builder.updateMetrics();
    });
    QTest::newRow("glide with pieces of length 0") << Tamper([](Fixture& f) {
      f.point(4).witness.pieces.insert(f.point(4).witness.pieces.begin() + 1, {flight::Turn::Right, 70.0, 0.0});
    });
    QTest::newRow("spiral") << Tamper([](Fixture& f) { descendAt(f, 200.0, 2); });
    QTest::newRow("spiral that ends above the target, where the ground asks for it") << Tamper([](Fixture& f) {
      descendAt(f, 200.0, 2);
      f.plan().spirals[0].bottom = 340.0;
      f.builder.updateMetrics();
    });
    QTest::newRow("this end of a one-way runway") << Tamper([](Fixture& f) { f.plan().mission.siteFilter.oneWay = {"TEST/09"}; });
    QTest::newRow("site of an airfield file") << Tamper([](Fixture& f) {
      f.plan().mission.sites.clear();
      f.plan().mission.airfields = {{"airports.csv", "runways.csv"}};
    });
  }

  void variantsWithinTheRules_areCertified() {
    QFETCH(Tamper, change);
    Fixture fixture;
    change(fixture);
    const safety::SafetyReport report = checked(fixture);
    QVERIFY2(test::rulesBroken(report).empty(), test::textsOfFindings(report));
    QVERIFY(report.isSafe());
  }

  void tamperedPlan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Tamper>("tamper");
    addStructureRows();
    addTerrainRows();
    addMissionRows();
    addTourRows();
    addGlideRows();
    addSpiralRows();
  }

  void tamperedPlan_breaksExactlyItsRule() {
    QFETCH(QString, rule);
    QFETCH(Tamper, tamper);
    Fixture fixture;
    tamper(fixture);
    const safety::SafetyReport report = checked(fixture);
    for (const safety::Finding& finding : report.findings) {
      QVERIFY(!finding.text.empty());
    }
    QVERIFY2(QString::fromStdString(test::rulesBroken(report)) == rule, test::textsOfFindings(report));
    QVERIFY(!report.isSafe());
  }

  void indices_areToldAsNumbersFromOne() {
    Fixture fixture;
    fixture.point(4).target = 2;
    fixture.point(5).witness.site = std::numeric_limits<int>::max();
    const QByteArray texts = test::textsOfFindings(checked(fixture));
    QVERIFY2(texts.contains("target no. 3, but the plan lists 2"), texts);
    QVERIFY2(texts.contains("landing site no. 2147483648, but the plan lists 1"), texts);
  }
};

QTEST_APPLESS_MAIN(TestCheckerRules)
#include "tst_checker_rules.moc"
