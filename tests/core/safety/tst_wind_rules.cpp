// Plans in wind: one per rule that breaks exactly that rule and keeps it in still air, what a certificate says, engine failures.

#include "core/geo/local_frame.h"
#include "core/safety/checker.h"
#include "core/safety/witness_check.h"
#include "tests/core/safety/plan_fixture.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace vp;

namespace {

using Layers = std::vector<air::WindLayer>;

/// From the west-south-west, 4 to 12 kt.
const Layers kBreeze{test::layerOf(0.0, 250.0, 20.0, 4.0 * kMpsPerKnot, 12.0 * kMpsPerKnot)};
const Layers kEasterly{test::layerOf(0.0, 90.0, 0.0, 6.0, 6.0)};
const Layers kWesterly{test::layerOf(0.0, 270.0, 0.0, 0.0, 6.0)};

struct Fixture : test::PlanFixture {
  /// Lets it blow, with glides and safe altitudes that are made for it.
  void blow(const Layers& layers) {
    plan().mission.wind = layers;
    safety::GlideRates rates(plan().mission.aircraft, layers);
    for (std::size_t i = 0; i < plan().tour.size(); ++i) {
      builder.rebuildGlide(i, plan().sites[0].pose, rates.leastGlideRadius());
      point(i).safeAltitude = safety::requiredStartHeight(point(i).pose, point(i).witness.pieces, plan().mission.safety.arrivalMargin.si(),
                                                          terrain.grid(), plan().mission.safety.clearance.si(), rates);
    }
  }
  void descend(double radius, int turns) {
    plan().mission.planner.lowTargets = mission::LowTargets::Descend;
    plan().spirals = {{1, 600.0, 300.0, flight::Turn::Left, radius, turns, turns}};
    builder.updateMetrics();
  }
  /// Ground 100 to 150 m behind tour point 18, westbound, that a glide along the tour just clears.
  [[nodiscard]] float groundUnderGlide() const {
    safety::GlideRates rates(builder.plan().mission.aircraft, builder.plan().mission.wind);
    return static_cast<float>(500.0 - rates.along(Angle::kPi, {flight::Turn::Straight, 0.0, 150.0}).upTo(150.0));
  }
};

using Change = std::function<void(Fixture&)>;

/// Margins of the worst engine failure on an interval: by every failure and every place after it, and by one at the start alone.
struct Failure {
  double worst = std::numeric_limits<double>::infinity();
  double atEnds = std::numeric_limits<double>::infinity();
};

Failure worstFailure(const mission::Plan& plan, safety::GlideRates& rates, const terrain::ElevationGrid& grid, double required, int count,
                     double near) {
  const mission::DecisionPoint& from = plan.tour[0];
  const double length = from.onward.length;
  const safety::LossAlong loss = rates.along(from.pose.heading, from.onward);
  const auto points = test::fly(from.pose, {from.onward}, length / count);
  std::vector<double> floors;
  std::vector<double> lost;
  for (const test::FlownPoint& point : points) {
    floors.push_back(test::groundNear(grid, point.x, point.y, near) + plan.mission.safety.clearance.si());
    lost.push_back(loss.upTo(point.distance));
  }
  Failure failure;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double altitude = from.altitude + (plan.tour[1].altitude - from.altitude) * points[i].distance / length;
    double least = altitude - (lost.back() - lost[i]) - required;
    for (std::size_t k = i; k < points.size(); ++k) {
      least = std::min(least, altitude - (lost[k] - lost[i]) - floors[k]);
    }
    failure.worst = std::min(failure.worst, least);
    failure.atEnds = std::min(failure.atEnds, i == 0 ? least : altitude - floors[i]);
  }
  return failure;
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestWindRules : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

  static void addRunwayRows() {  // landing to the east: 12 kt from behind, 7.7 kt across at most
    row("runway with too much wind from behind", "site.excluded", [](Fixture& f) {
      f.blow(kBreeze);
      f.plan().mission.aircraft.maxTailwind = Speed::fromSi(11.9 * kMpsPerKnot);
    });
    row("runway with too much wind across", "site.excluded", [](Fixture& f) {
      f.blow(kBreeze);
      f.plan().mission.aircraft.maxCrosswind = Speed::fromSi(7.6 * kMpsPerKnot);
    });
  }

  static void addDataRows() {
    row("layers not ascending", "wind.data", [](Fixture& f) { f.plan().mission.wind = {kBreeze[0], kBreeze[0]}; });
    row("direction that is no number", "wind.data", [](Fixture& f) {
      f.plan().mission.wind = kBreeze;
      f.plan().mission.wind[0].wind.from_deg = std::nan("");
    });
    row("infinite wind", "wind.data", [](Fixture& f) {
      f.plan().mission.wind = kBreeze;
      f.plan().mission.wind[0].wind.mostSpeed = std::numeric_limits<double>::infinity();
    });
    row("least above the greatest", "wind.data", [](Fixture& f) {
      f.plan().mission.wind = kBreeze;
      f.plan().mission.wind[0].wind.leastSpeed = 7.0;
    });
    row("negative speed", "wind.data", [](Fixture& f) {
      f.plan().mission.wind = kBreeze;
      f.plan().mission.wind[0].wind.leastSpeed = -1.0;
    });
    row("more than all directions", "wind.data", [](Fixture& f) {
      f.plan().mission.wind = kBreeze;
      f.plan().mission.wind[0].wind.spread_deg = 181.0;
    });
    row("faster than the aircraft glides", "wind.data", [](Fixture& f) { f.plan().mission.wind = {test::layerOf(0.0, 250.0, 20.0, 4.0, 33.0)}; });
  }

  /// Each of these keeps all rules in still air.
  static void addRows() {
    row("safe altitudes of still air", "glide.safeAltitude", [](Fixture& f) {
      f.blow(kBreeze);
      for (std::size_t i = 0; i < f.plan().tour.size(); ++i) {
        f.builder.rebuildGlide(i, f.plan().sites[0].pose, 110.0);
      }
    });
    row("glide with turns of still air", "glide.radius", [](Fixture& f) {
      f.blow(kBreeze);
      f.builder.rebuildGlide(4, f.plan().sites[0].pose, 70.0);
    });
    row("tour with turns of still air", "tour.radius", [](Fixture& f) {
      f.plan().mission.aircraft.tourBank = Angle::degrees(25.0);
      f.blow(kBreeze);
    });
    row("turn of the tour that a glide cannot follow", "between.radius", [](Fixture& f) {
      f.plan().mission.aircraft.glideBanks = {Angle::degrees(25.0)};
      f.blow(kBreeze);
      f.builder.flyAt(1500.0);
    });
    row("climb with the wind from behind", "tour.climb", [](Fixture& f) {
      f.plan().mission.aircraft.maxClimb = Angle::degrees(14.0);
      f.blow(kBreeze);
      f.raise(5, 45.0);
    });
    row("descent with the wind from behind", "tour.descent", [](Fixture& f) {
      f.plan().mission.aircraft.maxDescent = Angle::degrees(14.0);
      f.blow(kBreeze);
      f.raise(5, 45.0);
    });
    row("too low for a glide against the wind", "glide.clearance", [](Fixture& f) {
      f.blow(kBreeze);
      f.flyLow(30.0);
      f.raise(f.highest(), -40.0);
    });
    row("arrival against the wind", "glide.arrival", [](Fixture& f) {
      f.plan().mission.safety.arrivalMargin = Length::fromSi(150.0);
      f.blow(kBreeze);
      f.flyLow(30.0);
      f.raise(f.highest(), -40.0);
    });
    row("too low between two points", "between.height", [](Fixture& f) {
      f.blow(kBreeze);
      f.flyLow(5.0);
    });
    row("ground that a glide along the tour meets against the wind", "between.clearance", [](Fixture& f) {
      f.blow(kWesterly);
      f.terrain.setCell(275.0, 1625.0, f.groundUnderGlide() + 0.01F);
    });
    row("spiral of still air", "spiral.radius", [](Fixture& f) {
      f.blow(kBreeze);
      f.descend(80.0, 9);
    });
    row("spiral that the wind makes steep", "spiral.pitch", [](Fixture& f) {
      f.blow(kBreeze);
      f.descend(100.0, 2);
    });
  }

private slots:
  void plan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    addDataRows();
    addRunwayRows();
    addRows();
  }

  void plan_breaksExactlyItsRule() {
    QFETCH(QString, rule);
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyBreaksExactly(fixture, rule);
    if (QTest::currentTestFailed()) {
      return;
    }
    fixture.plan().mission.wind.clear();
    const safety::SafetyReport still = test::checkedPlan(fixture);
    QVERIFY2(still.isSafe() || rule == "glide.clearance" || rule == "glide.arrival", test::textsOfFindings(still));
  }

  void plan_isCertified_data() {
    QTest::addColumn<Change>("change");
    QTest::newRow("in a breeze") << Change([](Fixture& f) { f.blow(kBreeze); });
    QTest::newRow("in wind from all around") << Change([](Fixture& f) { f.blow({test::layerOf(0.0, 0.0, 180.0, 0.0, 5.0)}); });
    QTest::newRow("in several layers") << Change([](Fixture& f) { f.blow({kBreeze[0], test::layerOf(800.0, 300.0, 10.0, 5.0, 9.0)}); });
    QTest::newRow("runway within the limits of wind") << Change([](Fixture& f) {
      f.blow(kBreeze);
      f.plan().mission.aircraft.maxTailwind = Speed::fromSi(12.1 * kMpsPerKnot);
      f.plan().mission.aircraft.maxCrosswind = Speed::fromSi(7.8 * kMpsPerKnot);
    });
    QTest::newRow("just high enough") << Change([](Fixture& f) {
      f.blow(kBreeze);
      f.flyLow(27.0);
    });
    QTest::newRow("over ground that a glide along the tour clears") << Change([](Fixture& f) {
      f.blow(kWesterly);
      f.terrain.setCell(275.0, 1625.0, f.groundUnderGlide() - 0.01F);
    });
    QTest::newRow("climbing against the wind as steeply as the air allows") << Change([](Fixture& f) {
      f.blow(kEasterly);  // 27.4 m/s over ground eastbound
      f.plan().mission.aircraft.maxClimb = Angle::degrees(11.0);
      f.raise(5, 45.0);
    });
  }

  void plan_isCertified() {
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyIsCertified(fixture);
  }

  void certificate_namesTheWind_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QVector<double>>("wind");  // from, spread, least, most in kt, per layer
    QTest::newRow("calm") << "at 33.4 m/s in calm air with the polar" << QVector<double>{};
    QTest::newRow("layers of no wind") << "at 33.4 m/s in calm air with the polar" << QVector<double>{250, 20, 0, 0, 0, 0, 0, 0};
    QTest::newRow("sector") << "in every wind from 230 to 270 degrees true at 4 to 12 kt with the polar" << QVector<double>{250, 20, 4, 12};
    QTest::newRow("over north") << "in every wind from 340 to 20 degrees true at 4 to 12 kt with the polar" << QVector<double>{0, 20, 4, 12};
    QTest::newRow("one wind") << "in every wind from 250 degrees true at 12 kt with the polar" << QVector<double>{250, 0, 12, 12};
    QTest::newRow("all around") << "in every wind from any direction at 0 to 8.5 kt with the polar" << QVector<double>{0, 180, 0, 8.5};
    QTest::newRow("layers")
        << "in every wind that at its height lies between those of the layers next to it, and changes from the one to the "
           "other nowhere faster than evenly between those that differ most: from 230 to 270 degrees true at 4 to 12 kt (0 m MSL), calm air "
           "(500 m MSL), from 300 degrees true at 10 kt (1000 m MSL) with the polar"
        << QVector<double>{250, 20, 4, 12, 0, 0, 0, 0, 300, 0, 10, 10};
  }

  void certificate_namesTheWind() {
    QFETCH(QString, text);
    QFETCH(QVector<double>, wind);
    Layers layers;
    for (int i = 0; i + 3 < wind.size(); i += 4) {
      layers.push_back(test::layerOf(125.0 * i, wind[i], wind[i + 1], wind[i + 2] * kMpsPerKnot, wind[i + 3] * kMpsPerKnot));
    }
    Fixture fixture;
    fixture.blow(layers);
    const safety::SafetyReport report = test::checkedPlan(fixture);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    QVERIFY2(report.certificate->statement.find(text.toStdString()) != std::string::npos, report.certificate->statement.c_str());
    QCOMPARE(report.certificate->statement.find("against the strongest wind") != std::string::npos, !text.contains("calm air with"));
  }

  void airspaceUnderAGlide_isEnteredInWindOnly() {
    Fixture fixture;
    fixture.blow(kEasterly);
    mission::Plan still = fixture.plan();
    still.mission.wind.clear();
    safety::GlideRates rates(still.mission.aircraft, {});
    double arrival = std::numeric_limits<double>::infinity();
    for (const mission::DecisionPoint& point : still.tour) {
      arrival = std::min(arrival, 600.0 - fixture.builder.lossOf(point.witness.pieces));
    }
    const geo::LocalFrame frame(still.frameOrigin);
    still.airspaces = {{"X",
                        "D",
                        {mission::AirspaceLimit::Kind::Surface, 0.0},
                        {mission::AirspaceLimit::Kind::Msl, arrival - 30.0},
                        {frame.toLatLon({-20.0, -1020.0}), frame.toLatLon({20.0, -1020.0}), frame.toLatLon({0.0, -980.0})}}};
    still.mission.airspace.otherwise = mission::AirspaceUse::Warn;
    fixture.plan().airspaces = still.airspaces;
    fixture.plan().mission.airspace = still.mission.airspace;
    QVERIFY(!test::isNamed(test::checkedPlan(still, fixture.terrain.grid()), "airspace.glide"));
    QVERIFY(test::isNamed(test::checkedPlan(fixture), "airspace.glide"));
  }

  void random_failuresInTurns_againstBruteForce_areJudgedAlike() {
    constexpr std::uint64_t kSeed = 20240721;
    constexpr int kCases = 700;
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    test::WindCases cases(kSeed);
    test::PlanBuilder builder;
    mission::Plan plan = builder.plan();
    plan.mission.planner.step = Length::fromSi(1000.0);
    plan.sites[0].site.elevation = geo::HeightMsl::fromMetres(-1000.0);
    const mission::DecisionPoint sample = plan.tour[0];
    int broken = 0;
    int kept = 0;
    int inside = 0;
    for (int number = 0; number < kCases; ++number) {
      plan.mission.wind = {test::layerOf(0.0, 360.0 * cases.unit(), 0.0, 14.0, 14.0)};
      safety::GlideRates rates(plan.mission.aircraft, plan.mission.wind);
      std::vector<float> values(40 * 40);
      for (float& value : values) {
        value = static_cast<float>(10.0 * cases.unit());
      }
      const terrain::ElevationGrid grid(-1000.0, -1000.0, 50.0, 40, 40, values);
      mission::DecisionPoint from = sample;
      from.pose = {200.0 * cases.unit() - 100.0, 200.0 * cases.unit() - 100.0, 6.0 * cases.unit()};
      from.onward = {cases.below(2) == 0 ? flight::Turn::Left : flight::Turn::Right, 150.0, 100.0 + 440.0 * cases.unit()};
      mission::DecisionPoint to = sample;
      const test::FlownPoint end = test::fly(from.pose, {from.onward}, 5.0).back();
      to.pose = {end.x, end.y, wrapTwoPi(end.heading)};
      to.witness.pieces = {{flight::Turn::Straight, 0.0, 10.0}};
      const double required = safety::requiredStartHeight(to.pose, to.witness.pieces, -950.0, grid, 100.0, rates);
      to.altitude = required + 0.02 + 5.0 * cases.unit();  // high enough for its own glide, which has rules of its own
      const double lost = rates.along(from.pose.heading, from.onward).upTo(from.onward.length);
      from.altitude = to.altitude + lost * (0.95 + 0.2 * cases.unit());  // about as steep as the glide
      plan.tour = {from, to};
      bool found = false;
      for (const safety::Finding& finding : test::checkedPlan(plan, grid).findings) {
        found = found || (finding.tourPoint == 0 && (finding.rule.starts_with("between.") || finding.rule == "tour.clearance"));
      }
      const Failure failure = worstFailure(plan, rates, grid, required, 180, 0.0);
      const double bound = worstFailure(plan, rates, grid, required, 180, 3.0).worst - 1.5;  // samples are less than 3 m apart
      const QByteArray label = QString("case %1: worst margin between %2 and %3, %4").arg(number).arg(bound).arg(failure.worst).arg(found).toUtf8();
      if (failure.worst < -0.0011) {
        ++broken;
        inside += failure.atEnds > 0.01 ? 1 : 0;
        QVERIFY2(found, label);
      } else if (bound > 0.0) {
        ++kept;
        QVERIFY2(!found, label);
      }
    }
    qInfo("%d broken, %d of them by a failure inside alone, %d kept", broken, inside, kept);
    QVERIFY(broken > 80 && kept > 100 && inside > 10);
  }
};

QTEST_APPLESS_MAIN(TestWindRules)
#include "tst_wind_rules.moc"
