// Tour and glides against airspaces: where they are inside is solved for, not sampled.

#include "core/base/quantity.h"
#include "core/safety/airspace_crossing.h"
#include "core/safety/checker.h"
#include "core/safety/ground_path.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vp;
using Kind = mission::AirspaceLimit::Kind;

namespace {

/// A square airspace in the frame of the test plan.
mission::Airspace square(const mission::Plan& plan, double minX, double minY, double maxX, double maxY, mission::AirspaceLimit floor,
                         mission::AirspaceLimit ceiling) {
  const geo::LocalFrame frame(plan.frameOrigin);
  return {"BOX",
          "C",
          floor,
          ceiling,
          {frame.toLatLon({minX, minY}), frame.toLatLon({maxX, minY}), frame.toLatLon({maxX, maxY}), frame.toLatLon({minX, maxY})}};
}

std::vector<safety::Finding> findings(test::PlanBuilder& builder, const mission::Airspace& airspace, mission::AirspaceUse use, float ground = 0.0F) {
  builder.plan().airspaces = {airspace};
  builder.plan().mission.airspace = {{"air.txt"}, {}, use};
  const terrain::ElevationGrid grid = test::TestTerrain(ground).grid();
  const Result<safety::SafetyReport> report = safety::check({builder.plan(), grid, builder.checksums()}, Job{});
  return report ? report->findings : std::vector<safety::Finding>{};
}

const safety::Finding* find(const std::vector<safety::Finding>& all, const std::string& rule) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const safety::Finding& finding) { return finding.rule == rule; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

class TestAirspace : public QObject {
  Q_OBJECT

private slots:
  void stretches_agreeWithDenseSampling() {
    const std::uint64_t seed = 20261124;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int round = 0; round < 10000; ++round) {
      std::vector<geo::Point> corners;
      const int count = 3 + static_cast<int>(random() % 8);
      for (int i = 0; i < count; ++i) {
        corners.push_back({1000.0 * unit(random), 1000.0 * unit(random)});
      }
      const safety::Outline outline(corners);
      const geo::Pose start{1200.0 * unit(random), 1200.0 * unit(random), 4.0 * unit(random)};
      flight::Piece piece{static_cast<flight::Turn>(static_cast<int>(random() % 3) - 1), 0.0, 10.0 + 2500.0 * std::abs(unit(random))};
      if (piece.turn != flight::Turn::Straight) {
        piece.radius = 50.0 + 600.0 * std::abs(unit(random));
      }
      const std::vector<safety::InsideStretch> stretches = outline.stretchesInside(start, piece);
      constexpr int kSamples = 200;
      for (int i = 0; i <= kSamples; ++i) {
        const double at = piece.length * i / kSamples;
        const bool isSolved = std::any_of(stretches.begin(), stretches.end(), [&](const auto& s) { return at >= s.from && at <= s.to; });
        const bool isNearEdge = std::any_of(stretches.begin(), stretches.end(),
                                            [&](const auto& s) { return std::abs(at - s.from) < 0.01 || std::abs(at - s.to) < 0.01; });
        if (!isNearEdge) {
          QVERIFY2(isSolved == outline.contains(safety::poseOn(start, piece, at).point()), qPrintable(QString("case %1 at %2").arg(round).arg(at)));
        }
      }
    }
  }

  void narrowAirspace_betweenDecisionPoints_isFound() {
    test::PlanBuilder builder;  // straight eastbound at y = 1000, points every 200 m
    const mission::Airspace strip = square(builder.plan(), 110.0, 900.0, 110.5, 1100.0, {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0});
    const auto all = findings(builder, strip, mission::AirspaceUse::Forbid);
    const safety::Finding* tour = find(all, "airspace.tour");
    QVERIFY(tour != nullptr);
    QCOMPARE(tour->severity, safety::Severity::Violated);
    QVERIFY(std::abs(*tour->margin + 0.5) < 0.01);
    QVERIFY(tour->where.has_value());
  }

  void floorsAndCeilings_decide_data() {
    QTest::addColumn<int>("floorKind");
    QTest::addColumn<double>("floor");
    QTest::addColumn<int>("ceilingKind");
    QTest::addColumn<double>("ceiling");
    QTest::addColumn<bool>("isEntered");
    const auto row = [](const char* name, Kind floorKind, double floor, Kind ceilingKind, double ceiling, bool isEntered) {
      QTest::newRow(name) << static_cast<int>(floorKind) << floor << static_cast<int>(ceilingKind) << ceiling << isEntered;
    };
    // the tour flies at 600 m MSL over ground of 100 m
    row("around it", Kind::Msl, 500.0, Kind::Msl, 700.0, true);
    row("on the ceiling", Kind::Surface, 0.0, Kind::Msl, 600.0, false);
    row("on the floor", Kind::Msl, 600.0, Kind::Unlimited, 0.0, false);
    row("just above the floor", Kind::Msl, 599.9, Kind::Unlimited, 0.0, true);
    row("flight level below", Kind::FlightLevel, 590.0, Kind::FlightLevel, 3000.0, true);
    row("flight level above", Kind::FlightLevel, 610.0, Kind::FlightLevel, 3000.0, false);
    row("above ground, below the tour", Kind::AboveGround, 450.0, Kind::Unlimited, 0.0, true);
    row("above ground, above the tour", Kind::AboveGround, 550.0, Kind::Unlimited, 0.0, false);
    row("ceiling above ground, above the tour", Kind::Surface, 0.0, Kind::AboveGround, 550.0, true);
    row("ceiling above ground, below the tour", Kind::Surface, 0.0, Kind::AboveGround, 450.0, false);
    row("in words", Kind::Unknown, 0.0, Kind::Unknown, 0.0, true);
  }
  void floorsAndCeilings_decide() {
    QFETCH(int, floorKind);
    QFETCH(double, floor);
    QFETCH(int, ceilingKind);
    QFETCH(double, ceiling);
    QFETCH(bool, isEntered);
    test::PlanBuilder builder;
    const mission::Airspace box =
        square(builder.plan(), -500.0, 900.0, 500.0, 1100.0, {static_cast<Kind>(floorKind), floor}, {static_cast<Kind>(ceilingKind), ceiling});
    const auto all = findings(builder, box, mission::AirspaceUse::Warn, 100.0F);
    const safety::Finding* tour = find(all, "airspace.tour");
    QCOMPARE(tour != nullptr, isEntered);
    if (tour != nullptr) {
      QCOMPARE(tour->severity, safety::Severity::Warning);
    }
  }

  void glides_warnAndNeverForbid() {
    test::PlanBuilder builder;
    const mission::Airspace field = square(builder.plan(), -3000.0, -1200.0, 3000.0, 0.0, {Kind::Surface, 0.0}, {Kind::Msl, 5000.0});
    const auto all = findings(builder, field, mission::AirspaceUse::Forbid);
    QVERIFY(find(all, "airspace.tour") == nullptr);
    const safety::Finding* glide = find(all, "airspace.glide");
    QVERIFY(glide != nullptr);
    QCOMPARE(glide->severity, safety::Severity::Warning);
    QVERIFY(glide->text.find("BOX (class C, the surface to 5000 m MSL)") != std::string::npos);
  }

  void spirals_areInsideByTheirLaps_data() {
    QTest::addColumn<double>("floor");
    QTest::addColumn<double>("ceiling");
    QTest::addColumn<bool>("isEntered");
    // the tour flies at 600 m MSL, the spiral goes down to 300 m
    QTest::newRow("below the tour") << 0.0 << 400.0 << true;
    QTest::newRow("between the laps' ends") << 450.0 << 451.0 << true;
    QTest::newRow("up to the bottom") << 0.0 << 300.0 << false;
    QTest::newRow("from the tour up") << 600.0 << 900.0 << false;
  }
  void spirals_areInsideByTheirLaps() {
    QFETCH(double, floor);
    QFETCH(double, ceiling);
    QFETCH(bool, isEntered);
    test::PlanBuilder builder;
    const auto& tour = builder.plan().tour;
    const auto visit = std::find_if(tour.begin(), tour.end(), [](const mission::DecisionPoint& point) { return point.target == 1; });
    QVERIFY(visit != tour.end());
    builder.plan().mission.planner.lowTargets = mission::LowTargets::Descend;
    builder.plan().spirals = {{1, 600.0, 300.0, flight::Turn::Left, 200.0, 3, 3}};
    builder.updateMetrics();
    const double x = visit->pose.x - 400.0 * std::sin(visit->pose.heading);  // opposite on the circle, away from the tour
    const double y = visit->pose.y + 400.0 * std::cos(visit->pose.heading);
    const auto all = findings(builder, square(builder.plan(), x - 30.0, y - 30.0, x + 30.0, y + 30.0, {Kind::Msl, floor}, {Kind::Msl, ceiling}),
                              mission::AirspaceUse::Forbid);
    const safety::Finding* tourFinding = find(all, "airspace.tour");
    QCOMPARE(tourFinding != nullptr, isEntered);
    if (tourFinding != nullptr) {
      QCOMPARE(tourFinding->severity, safety::Severity::Violated);
      QVERIFY2(tourFinding->text.find("in the spiral at target") != std::string::npos, tourFinding->text.c_str());
    }
  }

  void shownOrHiddenAirspaces_giveNoFinding() {
    test::PlanBuilder builder;
    const mission::Airspace box = square(builder.plan(), -500.0, 900.0, 500.0, 1100.0, {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0});
    for (const mission::AirspaceUse use : {mission::AirspaceUse::Show, mission::AirspaceUse::Hide}) {
      const auto all = findings(builder, box, use);
      QVERIFY(find(all, "airspace.tour") == nullptr && find(all, "airspace.glide") == nullptr);
    }
  }

  void rules_onNamesGoBeforeThoseOnKinds() {
    const mission::Airspace airspace{"BERN", "C", {}, {}, {}};
    const mission::AirspaceSettings settings{
        {}, {{"C", "", mission::AirspaceUse::Forbid}, {"", "BERN", mission::AirspaceUse::Hide}}, mission::AirspaceUse::Show};
    QCOMPARE(mission::useOf(airspace, settings), mission::AirspaceUse::Hide);
    QCOMPARE(mission::useOf({"GENF", "C", {}, {}, {}}, settings), mission::AirspaceUse::Forbid);
    QCOMPARE(mission::useOf({"GENF", "E", {}, {}, {}}, settings), mission::AirspaceUse::Show);
  }
};

QTEST_APPLESS_MAIN(TestAirspace)
#include "tst_airspace.moc"
