// Waypoints of tours beside ground of unknown height: rounded places do not lead over it.
#include "core/flight/curve_sampling.h"
#include "core/route/build_route.h"
#include "core/safety/checker.h"
#include "tests/support/ring_mission.h"

#include <QRegularExpression>
#include <QTest>

#include <set>

using namespace vp;

namespace {

constexpr double kMilliMinute = 60000.0;  // places of SeeYou
constexpr double kSample = 0.5;           // m along a path

using Cell = std::pair<int, int>;

tour::PlanInput ringInput(int targets) {
  tour::PlanInput input = test::mountainInput();
  for (int i = 0; i < targets; ++i) {
    const double angle = 2.0 * Angle::kPi * i / targets;
    const double radius = i % 2 == 0 ? 1900.0 : 1100.0;
    test::addTarget(input, "T" + std::to_string(i + 1), {radius * std::cos(angle), radius * std::sin(angle)});
  }
  return input;
}

/// Cells within a distance of a path. @param within  m
std::set<Cell> cellsOf(const terrain::ElevationGrid& grid, const std::vector<mission::DecisionPoint>& path, double within) {
  std::set<Cell> cells;
  for (const mission::DecisionPoint& point : path) {
    for (double at = 0.0; at <= point.onward.length; at += kSample) {
      const geo::Point p = flight::poseAfter(point.pose, point.onward, at).point();
      for (const double dx : {-within, 0.0, within}) {
        for (const double dy : {-within, 0.0, within}) {
          cells.insert({grid.columnOf(p.x + dx), grid.rowOf(p.y + dy)});
        }
      }
    }
  }
  return cells;
}

std::shared_ptr<const terrain::ElevationGrid> withUnknown(const terrain::ElevationGrid& grid, Cell cell) {
  std::vector<float> values = grid.values();
  values[static_cast<std::size_t>(cell.second) * static_cast<std::size_t>(grid.columns()) + static_cast<std::size_t>(cell.first)] =
      terrain::kUnknownUpper;
  return std::make_shared<const terrain::ElevationGrid>(grid.originX(), grid.originY(), grid.cellSize(), grid.columns(), grid.rows(),
                                                        std::move(values));
}

Result<route::BuiltRoute> built(const mission::Plan& plan, const std::shared_ptr<const terrain::ElevationGrid>& grid) {
  const auto ground = route::prepareGround(plan, grid, Job{});
  if (!ground) {
    return forward(ground);
  }
  route::RouteOptions options;
  options.stepsPerDegree = kMilliMinute;
  return route::buildRoute(plan, &*ground, options, Job{});
}

}  // namespace

class TestRouteUnknown : public QObject {
  Q_OBJECT

private slots:
  /// Each cell that the rounded waypoints lead over and the tour keeps a metre off is made unknown: other roundings stay off it.
  void unknownCellBesideTheTour_isNotFlownOver() {
    constexpr double kOff = 1.0;  // m
    int tried = 0;
    for (const int targets : {3, 4, 5, 6}) {
      const tour::PlanInput input = ringInput(targets);
      const auto plan = tour::planTour(input, Job{});
      QVERIFY(plan);
      const auto first = built(*plan, input.terrain);
      QVERIFY(first);
      const std::set<Cell> toured = cellsOf(*input.terrain, plan->tour, kOff);
      for (const Cell& cell : cellsOf(*input.terrain, first->reflown.tour, 0.0)) {
        if (toured.contains(cell)) {
          continue;
        }
        ++tried;
        const auto grid = withUnknown(*input.terrain, cell);
        const auto again = built(*plan, grid);
        QVERIFY2(again, again ? "" : again.error().what.c_str());
        const auto report = safety::check({again->reflown, *grid, {std::string(64, '0')}}, Job{});
        QVERIFY(report && report->isSafe());
      }
    }
    qInfo("%d cells", tried);
    QVERIFY(tried > 0);
  }

  /// Ground that the tour itself comes over cannot be kept off: the sentence names the place.
  void unknownCellUnderTheTour_isNamedByItsNearestTarget() {
    const tour::PlanInput input = ringInput(4);
    const auto plan = tour::planTour(input, Job{});
    QVERIFY(plan);
    const geo::Point under = plan->tour[plan->tour.size() / 2].pose.point();
    const auto again = built(*plan, withUnknown(*input.terrain, {input.terrain->columnOf(under.x), input.terrain->rowOf(under.y)}));
    QVERIFY(!again);
    QCOMPARE(again.error().code, Errc::NoSolution);
    const QString said = QString::fromStdString(again.error().what);
    QVERIFY2(said.contains(QRegularExpression("over ground of unknown height [0-9.]+ km from T[1-4] \\([0-9.]+, [0-9.]+\\)$")), qPrintable(said));
  }
};

QTEST_APPLESS_MAIN(TestRouteUnknown)
#include "tst_route_unknown.moc"
