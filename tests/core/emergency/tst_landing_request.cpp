// What is said to requests that make no sense, by every planner.
#include "core/emergency/planners.h"
#include "tests/support/landing_cases.h"

#include <QTest>

using namespace vp;
using namespace vp::emergency;

namespace {

LandingRequest usual() {
  mission::Mission mission = test::landingMission();
  mission.ceiling = geo::HeightMsl::fromMetres(3000.0);
  return test::mountainRequest(mission, {900.0, 1400.0, -1.0}, 1200.0);
}

}  // namespace

class TestLandingRequest : public QObject {
  Q_OBJECT

private slots:
  void fault_isASentence_data() {
    QTest::addColumn<QByteArray>("part");
    QTest::addColumn<int>("number");
    const auto row = [](const char* name, const char* part, int number) { QTest::newRow(name) << QByteArray(part) << number; };
    row("deadline", "A deadline of zero leaves no time", 0);
    row("outside", "outside the terrain of the mission", 1);
    row("below the terrain", "The aircraft would be below the ground: 300 m MSL where the terrain is up to ", 2);
    row("above the ceiling", "at 3001 m MSL, above the ceiling of 3000 m MSL", 3);
    row("no site", "no landing site at all", 4);
    row("no number", "must be finite numbers", 5);
    row("unknown ground", "The terrain has no data at the aircraft's place", 6);
  }
  void fault_isASentence() {
    QFETCH(QByteArray, part);
    QFETCH(int, number);
    LandingRequest request = usual();
    QVERIFY(!requestFault(request));
    switch (number) {
      case 0:
        request.deadline = 0.0;
        break;
      case 1:
        request.pose.x = 2600.0;
        break;
      case 2:
        request.pose = {300.0, -200.0, 0.0};
        request.altitude = 300.0;
        break;
      case 3:
        request.altitude = 3001.0;
        break;
      case 4: {
        landing::World world = *request.world;
        world.sites.clear();
        request.world = std::make_shared<const landing::World>(world);
        break;
      }
      case 5:
        request.pose.heading = std::numeric_limits<double>::quiet_NaN();
        break;
      default: {
        landing::World world = *request.world;
        world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double x, double y) {
          return std::hypot(x - 900.0, y - 1400.0) < 100.0 ? std::numeric_limits<double>::infinity() : 0.0;
        }));
        request.world = std::make_shared<const landing::World>(world);
      }
    }
    const std::optional<std::string> fault = requestFault(request);
    QVERIFY(fault);
    QVERIFY2(QByteArray::fromStdString(*fault).contains(part), fault->c_str());
    for (const std::string& name : plannerNames()) {
      const LandingAnswer answer = makePlanner(name)->plan(request);
      QCOMPARE(answer.whyNot, *fault);
      QVERIFY(!answer.path);
    }
  }

  void planners_areFoundByTheirNames() {
    const std::vector<std::string> names = plannerNames();
    QVERIFY(names.size() >= 3 && names.back() == "combined");
    for (const std::string& name : names) {
      QCOMPARE(std::string(makePlanner(name)->name()), name);
    }
    QVERIFY(makePlanner("autoland") == nullptr);
  }
};

QTEST_APPLESS_MAIN(TestLandingRequest)
#include "tst_landing_request.moc"
