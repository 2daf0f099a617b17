// Tours planned under wind, re-flown by the equations of motion in winds of the set: no glide may come too low or miss its runway.
#include "tests/support/plan_flights.h"
#include "tests/support/quick_plan.h"
#include "tests/support/wind_flight.h"

#include <QTest>

#include <random>

using namespace vp;

namespace {

air::WindSector sectorOf(double from_deg, double knots, double spread_deg = 0.0, double spreadKnots = 0.0) {
  return {from_deg, spread_deg, std::max(0.0, knots - spreadKnots) * test::kKnot, (knots + spreadKnots) * test::kKnot};
}

/// Flies `winds` winds of the plan's set from `places` random places of the tour each.
void reflown(const mission::Plan& plan, const terrain::ElevationGrid& terrain, int winds, int places) {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::size_t> points(0, plan.tour.size() - 1);
  std::uniform_real_distribution<double> parts(0.0, 1.0);
  for (int w = 0; w < winds; ++w) {
    const test::SteadyWind wind = test::windOf(plan.mission.wind, random);
    for (int k = 0; k < places; ++k) {
      const std::size_t point = points(random);
      const double part = k % 2 == 0 ? 0.0 : parts(random);
      const test::Outcome outcome = test::failAt(plan, terrain, point, part, wind);
      const mission::DecisionPoint& proof = plan.tour[part > 0.0 ? (point + 1) % plan.tour.size() : point];
      const mission::SiteInFrame& site = plan.sites.at(static_cast<std::size_t>(proof.witness.site));
      const double arrival = outcome.endAltitude - site.site.elevation.metres() - plan.mission.safety.arrivalMargin.si();
      QVERIFY2(outcome.leastSpare > -1e-3 && arrival > -1e-3,
               qPrintable(QString("point %1 + %2: spare %3, arrival %4").arg(point).arg(part).arg(outcome.leastSpare).arg(arrival)));
      QVERIFY(geo::distance(outcome.end.point(), site.pose.point()) < 0.1);
    }
  }
}

}  // namespace

class TestWind : public QObject {
  Q_OBJECT

private slots:
  void everyWind_givesATourThatHolds_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("knots");
    for (const double knots : {10.0, 20.0}) {
      for (int direction = 0; direction < 8; ++direction) {
        QTest::addRow("%.0f kt from %d", knots, direction * 45) << direction * 45.0 << knots;
      }
    }
  }
  void everyWind_givesATourThatHolds() {
    QFETCH(double, from);
    QFETCH(double, knots);
    mission::Mission mission = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm");
    mission.wind = {{geo::HeightMsl(), sectorOf(from, knots)}};
    const test::QuickPlan made = test::quickPlan(mission);
    QVERIFY(made.plan->certificate.has_value());
    reflown(*made.plan, *made.loaded.terrain, 1, 400);
  }

  void uncertainWind_holdsInAThousandOfItsWinds() {
    mission::Mission mission = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n10.vpm");
    mission.wind = {{geo::HeightMsl(), sectorOf(240.0, 15.0, 20.0, 5.0)}};
    const test::QuickPlan made = test::quickPlan(mission);
    QVERIFY(made.plan->certificate.has_value());
    reflown(*made.plan, *made.loaded.terrain, 1000, 20);
  }

  void layers_holdForTheWindsOfEachHeight() {
    mission::Mission mission = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm");
    mission.wind = {{geo::HeightMsl::fromMetres(200.0), sectorOf(180.0, 5.0)},
                    {geo::HeightMsl::fromMetres(500.0), sectorOf(270.0, 20.0, 10.0)},
                    {geo::HeightMsl::fromMetres(900.0), sectorOf(300.0, 12.0)}};
    const test::QuickPlan made = test::quickPlan(mission);
    QVERIFY(made.plan->certificate.has_value() || !test::kCheckerKnowsBands);
    test::Flights flights(*made.plan, *made.loaded.terrain);
    const QString wrong = flights.fly(made.plan->tour, 0, true, 6000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
  }

  void layersAbove_costNoMoreThanTheirWindsEverywhere() {
    mission::Mission mission = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm");
    mission.wind = {{geo::HeightMsl(), sectorOf(270.0, 5.0)},
                    {geo::HeightMsl::fromMetres(1000.0), sectorOf(270.0, 15.0)},
                    {geo::HeightMsl::fromMetres(2000.0), sectorOf(270.0, 30.0)}};
    const double byAltitude = test::quickPlan(mission).plan->metrics.cost;
    for (air::WindLayer& layer : mission.wind) {
      layer.wind = sectorOf(270.0, 17.5, 0.0, 12.5);
    }
    mission.wind.resize(1);
    const double everywhere = test::quickPlan(mission).plan->metrics.cost;
    qInfo("%.0f m by altitude, %.0f m with all of it everywhere", byAltitude, everywhere);
    QVERIFY(byAltitude < everywhere);
  }

  void windOfNothing_isThePlanOfCalmAir() {
    mission::Mission mission = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm");
    const test::QuickPlan calm = test::quickPlan(mission);
    mission.wind = {{geo::HeightMsl(), sectorOf(90.0, 0.0)}};
    const test::QuickPlan nothing = test::quickPlan(mission);
    QVERIFY(calm.plan->tour == nothing.plan->tour);
    QCOMPARE(calm.plan->metrics.cost, nothing.plan->metrics.cost);
  }
};

QTEST_APPLESS_MAIN(TestWind)
#include "tst_wind.moc"
