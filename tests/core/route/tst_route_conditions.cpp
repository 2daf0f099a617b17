// Waypoints of plans with reaction, approaches and holds: the path that they give is flown on days of the mission.
#include "core/landing/approach.h"
#include "core/route/build_route.h"
#include "tests/support/drawn_mission.h"
#include "tests/support/plan_flights.h"

#include <QTest>

using namespace vp;

class TestRouteConditions : public QObject {
  Q_OBJECT

private slots:
  void randomSettings_asWaypoints_holdOnEveryDay_data() {
    QTest::addColumn<int>("number");
    for (int i = 0; i < 12; ++i) {
      QTest::addRow("mission %d", i) << i;
    }
  }
  void randomSettings_asWaypoints_holdOnEveryDay() {
    QFETCH(int, number);
    const tour::PlanInput input = test::drawnInput(number);
    qInfo("%s", qPrintable(test::describe(input.mission)));
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
    const auto ground = route::prepareGround(*plan, input.terrain, Job{});
    QVERIFY2(ground, ground ? "" : ground.error().what.c_str());
    const auto built = route::buildRoute(*plan, &*ground, {}, Job{});
    QVERIFY2(built, built ? "" : built.error().what.c_str());
    const mission::Plan& flown = built->reflown;
    test::Flights flights(flown, *input.terrain);
    const QString wrong = flights.fly(flown.tour, 0, true, 600);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    QCOMPARE(flown.departure.has_value(), input.mission.home.has_value());
    if (flown.departure) {
      const QString out = flights.fly(flown.departure->points, static_cast<std::size_t>(flown.departure->guaranteed), false, 200);
      QVERIFY2(out.isEmpty(), qPrintable("departure, " + out));
      const QString in = flights.fly(flown.arrival->points, 0, false, 200);
      QVERIFY2(in.isEmpty(), qPrintable("arrival, " + in));
    }
    mission::Plan held = flown;
    landing::setHolds(ground->world, held);
    QVERIFY(held.holds == flown.holds && flown.holds.empty() != input.mission.approach.hold);
    // no dearer than what fly-by turns and whole feet ask for
    QVERIFY2(built->route.above < 150.0, qPrintable(QString::number(built->route.above)));
  }
};

QTEST_APPLESS_MAIN(TestRouteConditions)
#include "tst_route_conditions.moc"
