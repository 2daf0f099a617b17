// Waypoints of every bundled mission, flown with fly-by turns: the independent checker accepts that path as it accepts the tour.
#include "core/formats/aircraft_file.h"
#include "core/route/build_route.h"
#include "tests/support/quick_plan.h"

#include <QTest>
#include <fmt/core.h>

#include <cmath>

using namespace vp;

namespace {

std::string faultsOf(const safety::SafetyReport& report) {
  std::string text;
  for (const safety::Finding& finding : report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      text += "[" + finding.rule + "] " + finding.text + "\n";
    }
  }
  return text;
}

safety::SafetyReport judge(const mission::Plan& plan, const terrain::ElevationGrid& terrain) {
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : plan.terrain) {
    checksums.push_back(file.sha256);
  }
  return *safety::check({plan, terrain, checksums}, Job{});
}

bool isWholeFeet(double metres) {
  return std::abs(metres / kMetresPerFoot - std::round(metres / kMetresPerFoot)) < 1e-6;
}

}  // namespace

class TestRoute : public QObject {
  Q_OBJECT
private slots:
  void bundledMission_asWaypoints_isVerified_data() {
    QTest::addColumn<QString>("mission");
    for (const char* name : {"mountain-n5", "mountain-n10", "mountain-n20", "mountain-n50", "mountain-n100", "alpine-n10", "alpine-n30",
                             "three-blocks", "two-runways", "flat"}) {
      QTest::newRow(name) << name;
    }
  }

  void bundledMission_asWaypoints_isVerified() {
    QFETCH(QString, mission);
    const mission::Mission wanted = test::quickMission((QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/") + mission + ".vpm").toStdString());
    if (wanted.targets.empty()) {
      return;
    }
    const test::QuickPlan made = test::quickPlan(wanted);
    QVERIFY(made.plan->certificate);
    const auto ground = route::prepareGround(*made.plan, made.loaded.terrain, Job{});
    QVERIFY2(ground, ground ? "" : ground.error().what.c_str());
    for (const double steps : {1e6, 360000.0, 60000.0}) {
      route::RouteOptions options;
      options.stepsPerDegree = steps;
      const auto built = route::buildRoute(*made.plan, &*ground, options, Job{});
      QVERIFY2(built, built ? "" : built.error().what.c_str());
      const mission::Route& route = built->route;
      qInfo("%s",
            fmt::format("{} at {}: {} targets, {} waypoints, {:.0f} m, lateral {:.2f} m, above {:.1f} m, visit {:.2f} m, waypoint beside {:.2f} m",
                        mission.toStdString(), steps, made.plan->targets.size(), route.waypoints.size(), route.length, route.lateral, route.above,
                        route.visit, route.besideWaypoint)
                .c_str());
      const safety::SafetyReport report = judge(built->reflown, *made.loaded.terrain);
      QVERIFY2(report.isSafe(), faultsOf(report).c_str());
      // fewer than three a target; with a corner of its own for each target, also those within a turn, there were 153
      QVERIFY2(mission != "mountain-n50" || route.waypoints.size() < 150, std::to_string(route.waypoints.size()).c_str());
      QVERIFY2(route.lateral < 25.0 && route.visit < 12.0, fmt::format("lateral {:.1f} m, visit {:.1f} m", route.lateral, route.visit).c_str());
      for (const mission::RouteWaypoint& waypoint : route.waypoints) {
        QVERIFY(isWholeFeet(waypoint.altitude));
        QVERIFY(std::abs(waypoint.place.latitude_deg * steps - std::round(waypoint.place.latitude_deg * steps)) < 1e-3);
      }
    }
  }

  void homeMission_asWaypoints_isVerified_data() {
    QTest::addColumn<QString>("mission");
    QTest::addColumn<QString>("aircraft");
    QTest::addColumn<QString>("takeoff");
    QTest::addColumn<QString>("landing");
    const auto row = [](const char* mission, const char* aircraft, const char* takeoff, const char* landing) {
      QTest::newRow((std::string(mission) + " " + takeoff + " to " + landing).c_str()) << mission << aircraft << takeoff << landing;
    };
    for (const char* runway : {"MTSW/13", "MTSW/31", "MTNE/12", "MTNE/30"}) {
      row("mountain-n5", "cessna172-elasp", runway, "MTSW/13");
      row("mountain-n20", "cessna172-elasp", "MTSW/31", runway);
    }
    for (const char* runway : {"VA01/21", "VA01/03", "VA02/08", "VA03/13", "VA04/12"}) {
      row("alpine-n10", "cessna172-operational", runway, runway);
    }
    for (const char* mission : {"mountain-n50", "mountain-n100"}) {
      row(mission, "cessna172-elasp", "MTNE/12", "MTSW/31");
    }
    row("alpine-n30", "cessna172-operational", "VA01/21", "VA01/03");
  }

  void homeMission_asWaypoints_isVerified() {
    QFETCH(QString, mission);
    QFETCH(QString, aircraft);
    QFETCH(QString, takeoff);
    QFETCH(QString, landing);
    mission::Mission wanted = test::quickMission((QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/") + mission + ".vpm").toStdString());
    wanted.aircraft = formats::findAircraft(aircraft.toStdString(), ".").value();
    wanted.home = mission::HomeBase{takeoff.toStdString(), landing.toStdString()};
    const test::QuickPlan made = test::quickPlan(wanted);
    QVERIFY(made.plan->certificate && made.plan->departure);
    const auto ground = route::prepareGround(*made.plan, made.loaded.terrain, Job{});
    QVERIFY2(ground, ground ? "" : ground.error().what.c_str());
    for (const double steps : {1e6, 360000.0, 60000.0}) {
      route::RouteOptions options;
      options.stepsPerDegree = steps;
      const auto built = route::buildRoute(*made.plan, &*ground, options, Job{});
      QVERIFY2(built, built ? "" : built.error().what.c_str());
      const mission::Route& route = built->route;
      qInfo("%s", fmt::format("{} waypoints, {:.0f} m, lateral {:.2f} m, above {:.1f} m. {}", route.waypoints.size(), route.length, route.lateral,
                              route.above, route.guarantee)
                      .c_str());
      const safety::SafetyReport report = judge(built->reflown, *made.loaded.terrain);
      QVERIFY2(report.isSafe(), faultsOf(report).c_str());
      double ways = 0.0;
      for (const std::optional<mission::HomePath>* way : {&built->reflown.departure, &built->reflown.arrival}) {
        QVERIFY(*way);
        for (const mission::DecisionPoint& point : (*way)->points) {
          ways += point.onward.length;
        }
      }
      // never around the tour once more only for the paths to become one
      QVERIFY2(route.length < 1.5 * made.plan->metrics.length + ways + 5000.0, std::to_string(route.length).c_str());
      QVERIFY(built->reflown.departure && built->reflown.arrival && built->reflown.mission.home == wanted.home);
    }
  }
};

QTEST_APPLESS_MAIN(TestRoute)
#include "tst_route.moc"
