// One checker for many landing paths: its reports are those of a check by itself, whatever was asked before, at any altitudes and from many threads.

#include "core/safety/landing_check.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

#include <atomic>
#include <thread>

using namespace vp;

namespace {

using flight::Piece;
using flight::Turn;

/// Everything that a report says.
std::string textOf(const safety::LandingReport& report) {
  std::string text = report.reachesRunway ? "to a runway;" : "to nowhere;";
  for (const safety::Finding& finding : report.findings) {
    text += finding.rule + ": " + finding.text + ";";
  }
  for (const mission::Margin& margin : report.margins) {
    text += margin.kind + " " + std::to_string(margin.value) + ";";
  }
  return text;
}

struct Paths {
  test::PlanFixture fixture;
  test::WindCases cases;

  explicit Paths(std::uint64_t seed) : cases(seed) { fixture.mission().aircraft.steepestDescent = Angle::degrees(40.0); }

  /// Down to the runway or to nowhere, well planned or too flat.
  mission::LandingPath path(double altitude) {
    safety::GlideRates rates(safety::conditionsOf(fixture.plan()), fixture.mission().aircraft);
    const geo::Pose touchdown = fixture.plan().sites[0].pose;
    mission::LandingPath path;
    path.start = {touchdown.x + 2000.0 * (cases.unit() - 0.5), touchdown.y + 2000.0 * (cases.unit() - 0.5), 6.0 * cases.unit()};
    path.altitude = altitude;
    std::vector<Piece> pieces = test::glideTo(path.start, touchdown, rates.leastGlideRadius() * (1.0 + cases.below(3)));
    path.site = 0;
    if (cases.below(3) == 0) {
      path.site = -1;
      pieces.pop_back();
    }
    double length = 0.0;
    for (const Piece& piece : pieces) {
      length += piece.length;
    }
    const double slope = (altitude - 110.0) / length;
    for (const Piece& piece : pieces) {
      altitude -= slope * piece.length;
      path.legs.push_back({piece, altitude});
    }
    if (cases.below(20) == 0) {
      path.legs.back().endAltitude = std::nan("");
    }
    return path;
  }
};

}  // namespace

class TestLandingChecker : public QObject {
  Q_OBJECT

private slots:
  void reports_areThoseOfOneCheckByItself_data() {
    QTest::addColumn<int>("layers");
    QTest::addColumn<bool>("hasAir");
    QTest::newRow("calm") << 0 << false;
    QTest::newRow("wind") << 1 << false;
    QTest::newRow("layers") << 3 << false;
    QTest::newRow("layers in an atmosphere") << 2 << true;
  }
  void reports_areThoseOfOneCheckByItself() {
    QFETCH(int, layers);
    QFETCH(bool, hasAir);
    Paths paths(20270601);
    for (int i = 0; i < layers; ++i) {
      paths.fixture.mission().wind.push_back(test::layerOf(300.0 * i, 240.0 + 20.0 * i, 15.0, 1.0 + i, 3.0 + 2.0 * i));
    }
    if (hasAir) {
      paths.fixture.mission().atmosphere = air::Atmosphere();
    }
    const terrain::ElevationGrid grid = paths.fixture.terrain.grid();
    const safety::LandingInput input{paths.fixture.mission(), paths.fixture.plan().sites, paths.fixture.plan().frameOrigin, grid};
    const safety::LandingChecker checker(input);
    std::vector<mission::LandingPath> all;
    std::vector<std::string> expected;
    int flyable = 0;
    for (int i = 0; i < 60; ++i) {
      all.push_back(paths.path(hasAir ? 600.0 + 10.0 * paths.cases.below(40) : 400.0 + 700.0 * paths.cases.unit()));
      const safety::LandingReport report = safety::checkLanding(input, all.back());
      flyable += report.isFlyable() ? 1 : 0;
      expected.push_back(textOf(report));
      QVERIFY2(textOf(checker.check(all.back())) == expected.back(), expected.back().c_str());
    }
    QVERIFY2(flyable > 5 && flyable < 55, QByteArray::number(flyable));
    std::atomic<int> wrong = 0;
    {
      std::vector<std::jthread> threads;
      for (std::size_t thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&, thread] {
          for (std::size_t i = thread; i < all.size() + thread; ++i) {
            const std::size_t k = i % all.size();
            wrong += textOf(checker.check(all[k])) == expected[k] ? 0 : 1;
          }
        });
      }
    }
    QCOMPARE(wrong.load(), 0);
  }

  /// What is wrong with the mission is said of every path.
  void unsoundMissions_areRefusedEachTime() {
    Paths paths(20270602);
    const mission::LandingPath path = paths.path(900.0);
    const terrain::ElevationGrid grid = paths.fixture.terrain.grid();
    for (const int fault : {0, 1, 2}) {
      mission::Mission mission = paths.fixture.mission();
      std::vector<mission::SiteInFrame> sites = paths.fixture.plan().sites;
      if (fault == 0) {
        mission.wind = {test::layerOf(0.0, 90.0, 0.0, 40.0, 40.0)};
      } else if (fault == 1) {
        mission.aircraft.mass_kg = -1.0;
      } else {
        sites[0].pose.x = std::nan("");
      }
      const safety::LandingInput input{mission, sites, paths.fixture.plan().frameOrigin, grid};
      const safety::LandingChecker checker(input);
      const std::string expected = textOf(safety::checkLanding(input, path));
      for (int i = 0; i < 3; ++i) {
        const safety::LandingReport report = checker.check(path);
        QVERIFY2(!report.isFlyable() && textOf(report) == expected, textOf(report).c_str());
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestLandingChecker)
#include "tst_landing_checker.moc"
