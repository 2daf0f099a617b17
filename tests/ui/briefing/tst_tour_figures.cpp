// The numbers of a briefing: against a racetrack worked out by hand, and against what the checker says of a plan.
#include "core/aircraft/glide_model.h"
#include "core/geo/magnetic_field.h"
#include "tests/core/safety/plan_fixture.h"
#include "tests/support/plan_builder.h"
#include "ui/briefing/tour_figures.h"

#include <QTest>

#include <cmath>

using namespace vp;
using namespace vp::briefing;

namespace {

constexpr std::chrono::year_month_day kDay{std::chrono::year(2026), std::chrono::month(6), std::chrono::day(1)};
constexpr double kPi = Angle::kPi;

TourFigures figuresOf(const mission::Plan& plan, const terrain::ElevationGrid& grid) {
  const Result<TourFigures> figures = tourFigures(plan, grid, kDay, Job());
  if (!figures) {
    qFatal("%s", figures.error().message().c_str());
  }
  return *figures;
}

/// A second runway, landing to the west, that the points from `first` on glide to.
void addRunway(test::PlanBuilder& builder, std::size_t first) {
  mission::Plan& plan = builder.plan();
  mission::SiteInFrame site = plan.sites[0];
  const geo::LocalFrame frame(plan.frameOrigin);
  site.pose = {0.0, 3000.0, kPi};
  site.site.id = "TEST/27";
  site.site.runwayIdent = "27";
  site.site.touchdown = frame.toLatLon(site.pose.point());
  site.site.landingCourse = frame.trueCourseOf(kPi, site.pose.point());
  plan.sites.push_back(site);
  plan.mission.sites.push_back(site.site);
  for (std::size_t i = first; i < plan.tour.size(); ++i) {
    builder.rebuildGlide(i, site.pose, 65.7);
    plan.tour[i].witness.site = 1;
  }
}

}  // namespace

class TestTourFigures : public QObject {
  Q_OBJECT

private slots:
  /// Targets at points 3 (x = -400 on the eastbound straight) and 18 (600 m into the westbound one).
  void racetrack_hasTwoLegs_ofTheLengthsByHand() {
    const test::PlanBuilder builder(600.0);
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    const double half = 300.0 * kPi;
    QCOMPARE(figures.visits.size(), std::size_t{2});
    QCOMPARE(figures.legs.size(), std::size_t{2});
    QVERIFY(std::abs(figures.legs[0].length - (1400.0 + half + 600.0)) < 1e-6);
    QVERIFY(std::abs(figures.legs[1].length - (1400.0 + half + 600.0)) < 1e-6);
    QVERIFY(std::abs(figures.length - (4000.0 + 2.0 * half)) < 1e-6);
    QVERIFY(std::abs(figures.legs[0].seconds - figures.legs[0].length / 33.4) < 1e-6);
    QVERIFY(std::abs(figures.visits[1].distance - (2000.0 + half + 600.0)) < 1e-6);
    QCOMPARE(figures.visits[0].clearance, 600.0);
  }

  void level_overFlatGround_hasItsAltitudeAsClearance() {
    const test::PlanBuilder builder(600.0);
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain(20.0F).grid());
    for (const Leg& leg : figures.legs) {
      QCOMPARE(leg.startAltitude, 600.0);
      QCOMPARE(leg.highestAltitude, 600.0);
      QCOMPARE(leg.endAltitude, 600.0);
      QCOMPARE(leg.leastClearance, 580.0);
    }
  }

  /// Eastbound is 090 degrees true but for the convergence of the frame, which is nothing on its middle meridian.
  void track_isOfTheLongestStraight_withTheModelsVariation() {
    const test::PlanBuilder builder(600.0);
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    QVERIFY(figures.legs[0].isStraightPart);
    QVERIFY(std::abs(figures.legs[0].track.trueCourse.degrees() - 90.0) < 0.02);
    QVERIFY(std::abs(figures.legs[1].track.trueCourse.degrees() - 270.0) < 0.02);
    const geo::LocalFrame frame(builder.plan().frameOrigin);
    const double model =
        geo::magneticField(frame.toLatLon({-400.0, 1000.0}), geo::HeightMsl::fromMetres(600.0), geo::decimalYear(kDay)).variation().degrees();
    QVERIFY(figures.legs[0].track.variation.has_value());
    QVERIFY(std::abs(figures.legs[0].track.variation->degrees() - model) < 1e-9);
    QVERIFY(figures.fieldIsCovered);
    QVERIFY(!figures.compassIsUnreliable);
  }

  void oneRunway_givesOneDiversionPerLeg_overAllOfIt() {
    const test::PlanBuilder builder(600.0);
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    QCOMPARE(figures.diverts.size(), std::size_t{2});
    for (int k = 0; k < 2; ++k) {
      QCOMPARE(figures.diverts[static_cast<std::size_t>(k)].leg, k);
      QCOMPARE(figures.diverts[static_cast<std::size_t>(k)].from, 0.0);
      QCOMPARE(figures.diverts[static_cast<std::size_t>(k)].to, figures.legs[static_cast<std::size_t>(k)].length);
      QCOMPARE(figures.diverts[static_cast<std::size_t>(k)].site, 0);
    }
  }

  /// Over flat ground the loss of the whole glide and the height that is asked for on arrival decide: clearance 100 m is more
  /// than the arrival margin of 50 m.
  void margin_overFlatGround_isAltitudeLessLossLessClearance() {
    const test::PlanBuilder builder(600.0);
    const mission::Plan& plan = builder.plan();
    const TourFigures figures = figuresOf(plan, test::TestTerrain().grid());
    double least = 1e300;
    double longest = 0.0;
    const auto judge = [&](std::vector<flight::Piece> pieces) {
      least = std::min(least, 600.0 - builder.lossOf(pieces) - 100.0);
      double length = 0.0;
      for (const flight::Piece& piece : pieces) {
        length += piece.length;
      }
      longest = std::max(longest, length);
    };
    for (std::size_t i = 3; i < 18; ++i) {
      std::vector<flight::Piece> on{plan.tour[i].onward};
      on.insert(on.end(), plan.tour[i + 1].witness.pieces.begin(), plan.tour[i + 1].witness.pieces.end());
      judge(on);
      judge(plan.tour[i + 1].witness.pieces);
    }
    QVERIFY2(std::abs(figures.diverts[0].margin - least) < 1e-6, qPrintable(QString::number(figures.diverts[0].margin - least)));
    QVERIFY(std::abs(figures.diverts[0].greatestGlide - longest) < 1e-6);
    QVERIFY(std::abs(figures.diverts[0].leastClearance - (least + 100.0)) < 1e-6);
    QVERIFY(std::abs(figures.diverts[0].leastArrival - (least + 100.0)) < 1e-6);
    QVERIFY(std::abs(figures.legs[0].leastMargin - least) < 1e-6);
    QVERIFY(std::abs(figures.legs[0].safeAltitude - (600.0 - least)) < 1e-6);
    const double slowest = longest / 33.4;
    QVERIFY(figures.diverts[0].greatestSeconds > slowest && figures.diverts[0].greatestSeconds < 1.1 * slowest);
  }

  /// Between two points the aircraft glides on to the next one: the runway changes behind point 9, not at point 10.
  void secondRunway_beginsBehindTheLastPointOfTheFirst() {
    test::PlanBuilder builder(600.0);
    addRunway(builder, 10);
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    QCOMPARE(figures.diverts.size(), std::size_t{4});
    QCOMPARE(figures.diverts[0].site, 0);
    QVERIFY(std::abs(figures.diverts[0].to - 6.0 * 200.0) < 1e-6);  // points 3 to 9
    QCOMPARE(figures.diverts[1].site, 1);
    QVERIFY(std::abs(figures.diverts[1].from - 6.0 * 200.0) < 1e-6);
    QCOMPARE(figures.diverts[1].to, figures.legs[0].length);
    QCOMPARE(figures.diverts[2].site, 1);
    QCOMPARE(figures.diverts[3].site, 0);
    QVERIFY(std::abs(figures.diverts[3].from - (figures.legs[1].length - 4.0 * 200.0 + 0.0)) < 1e-6 ||
            std::abs(figures.diverts[3].from - figures.diverts[2].to) < 1e-9);
  }

  /// In layered winds and thin air, with a reaction loss and an approach over an obstacle surface, safe altitudes and margins are the checker's.
  void conditionsOfTheMission_giveTheCheckersNumbers() {
    test::PlanFixture fixture;
    fixture.builder.flyAt(1000.0);
    mission::Mission& mission = fixture.mission();
    mission.wind = {test::layerOf(300.0, 90.0, 10.0, 4.0, 7.0), test::layerOf(600.0, 270.0, 10.0, 1.0, 3.0)};
    mission.atmosphere = air::Atmosphere{20.0, 1003.0};
    mission.safety.reactionTime = Duration::fromSi(2.0);
    mission.safety.reactionLoss = Length::fromSi(25.0);
    mission.approach.kind = mission::ApproachKind::Straight;
    mission.approach.surfaceSlope = 0.05;
    mission.aircraft.steepestDescent = Angle::degrees(12.0);
    fixture.refit();
    const safety::SafetyReport report = test::checkedPlan(fixture);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    const TourFigures figures = figuresOf(fixture.plan(), fixture.terrain.grid());
    double highest = 0.0;
    for (const mission::DecisionPoint& point : fixture.plan().tour) {
      highest = std::max(highest, point.safeAltitude);
    }
    double required = 0.0;
    double margin = 1e9;
    double arrival = 1e9;
    double certified = 1e9;
    for (const Leg& leg : figures.legs) {
      required = std::max(required, leg.safeAltitude);
      margin = std::min(margin, leg.leastMargin);
    }
    for (const Divert& divert : figures.diverts) {
      arrival = std::min(arrival, divert.leastArrival);
    }
    for (const mission::Margin& one : report.margins) {
      certified = one.kind == "tour.glide" ? one.value : certified;
    }
    QVERIFY(required >= highest && required < highest + 30.0);  // those just behind a point are higher
    QVERIFY2(margin <= certified + 1e-9 && margin > certified - 10.0, qPrintable(QString("%1 and %2").arg(margin).arg(certified)));
    QVERIFY(std::abs(margin - (1000.0 - required)) < 1e-6 || margin < 1000.0 - required);
    QVERIFY(arrival > mission.safety.arrivalMargin.si());
  }

  void hillBelowTheTour_isTheLegsLeastClearance() {
    const test::PlanBuilder builder(600.0);
    test::TestTerrain terrain;
    terrain.setCell(525.0, 1025.0, 333.0F);
    const TourFigures figures = figuresOf(builder.plan(), terrain.grid());
    QCOMPARE(figures.legs[0].leastClearance, 267.0);
    QVERIFY(figures.legs[1].leastClearance > 400.0);
  }

  void tourWithoutTargets_isOneLeg() {
    test::PlanBuilder builder(600.0);
    for (mission::DecisionPoint& point : builder.plan().tour) {
      point.target = -1;
    }
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    QCOMPARE(figures.legs.size(), std::size_t{1});
    QCOMPARE(figures.legs[0].from, -1);
    QCOMPARE(figures.legs[0].length, figures.length);
  }

  void oneTarget_isOneLegAllAround() {
    test::PlanBuilder builder(600.0);
    builder.plan().tour[18].target = -1;
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    QCOMPARE(figures.legs.size(), std::size_t{1});
    QCOMPARE(figures.legs[0].from, 0);
    QCOMPARE(figures.legs[0].to, 0);
    QVERIFY(std::abs(figures.legs[0].length - figures.length) < 1e-6);
  }

  void nearTheMagneticPole_noMagneticTrackIsGiven() {
    test::PlanBuilder builder(600.0);
    builder.plan().frameOrigin = {85.8, 139.0};  // within 10 km of the north magnetic pole of 2026
    const TourFigures figures = figuresOf(builder.plan(), test::TestTerrain().grid());
    QVERIFY(!figures.legs[0].track.variation.has_value());
    QVERIFY(figures.compassIsUnreliable);
  }

  void stopped_givesCancelled() {
    std::stop_source stop;
    stop.request_stop();
    const test::PlanBuilder builder(600.0);
    const terrain::ElevationGrid grid = test::TestTerrain().grid();
    const Result<TourFigures> figures = tourFigures(builder.plan(), grid, kDay, Job(stop.get_token()));
    QVERIFY(!figures);
    QCOMPARE(figures.error().code, Errc::Cancelled);
  }

  void worst_areTheLeastMargins_apartFromEachOther() {
    TourFigures figures;
    figures.length = 10000.0;
    for (const auto& [margin, at] : {std::pair{50.0, 1000.0}, {3.2, 5000.0}, {2.1, 5100.0}, {90.0, 9900.0}, {3.4, 100.0}}) {
      Divert divert;
      divert.margin = margin;
      divert.marginAt = at;
      figures.diverts.push_back(divert);
    }
    QCOMPARE(worstDiverts(figures, 3), (std::vector<std::size_t>{2, 4, 0}));  // 5000 m is beside 5100 m, 9900 m beside 100 m
  }
};

QTEST_APPLESS_MAIN(TestTourFigures)
#include "tst_tour_figures.moc"
