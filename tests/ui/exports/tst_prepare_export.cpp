// What an export says and writes when the waypoints of a verified plan are not safe.
#include "tests/support/ring_mission.h"
#include "ui/exports/prepare_export.h"

#include <QTest>

#include <algorithm>

using namespace vp;

class TestPrepareExport : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    input_ = test::mountainInput();
    test::addTarget(input_, "North", {0.0, 1700.0});
    test::addTarget(input_, "South-west", {-1500.0, -900.0});
    test::addTarget(input_, "South-east", {1500.0, -900.0});
    auto plan = tour::planTour(input_, Job{});
    QVERIFY(plan);
    const auto report = safety::check({*plan, *input_.terrain, sums()}, Job{});
    QVERIFY(report && report->isSafe());
    plan_ = std::move(*plan);
    plan_.certificate = report->certificate;
  }

  void safeRoute_isNeitherRefusedNorMarked() {
    const auto prepared = exports::prepareExport({plan_, input_.terrain, sums(), {"cup", "gpx", "fms"}}, Job{});
    QVERIFY(prepared);
    QVERIFY(prepared->isVerified);
    QCOMPARE(prepared->refusal, std::string());
    for (const exports::ExportFile& file : prepared->files) {
      QVERIFY(file.bytes.find("DO NOT FLY") == std::string::npos);
    }
  }

  void unsafeRoute_saysFormatPlaceAndRemedy_andMarksTheFile() {
    const auto prepared = exports::prepareExport({plan_, withHole(), sums(), {"cup"}}, Job{});
    QVERIFY(prepared);
    QVERIFY(!prepared->isVerified && prepared->hasWarnings());
    for (const char* part : {"SeeYou waypoints and tasks: ", "NOT SAFE", "unknown height", "km from ", "shorter step", "such as GPX"}) {
      QVERIFY2(prepared->refusal.find(part) != std::string::npos, prepared->refusal.c_str());
    }
    QVERIFY(prepared->files.front().bytes.find("UNVERIFIED - DO NOT FLY") != std::string::npos);
  }

  void unsafeRoute_ofTheFinestPlaces_namesAllItsFormatsAndNoFinerOne() {
    const auto prepared = exports::prepareExport({plan_, withHole(), sums(), {"fms", "gpx"}}, Job{});
    QVERIFY(prepared);
    QVERIFY2(prepared->refusal.find("X-Plane 11/12 flight plan (1100), GPX route and track: ") != std::string::npos, prepared->refusal.c_str());
    QVERIFY(prepared->refusal.find("such as GPX") == std::string::npos);
    const auto isSaid = [](const exports::Remark& remark) {
      return remark.isWarning &&
             remark.text == "X-Plane 11/12 flight plan (1100): nothing in this file can say that it is unverified; name the file so";
    };
    QCOMPARE(std::count_if(prepared->remarks.begin(), prepared->remarks.end(), isSaid), 1);
  }

private:
  [[nodiscard]] static std::vector<std::string> sums() { return {std::string(64, '0')}; }

  /// The terrain with unknown ground under the tour, too wide for any rounding to lead past it.
  [[nodiscard]] std::shared_ptr<const terrain::ElevationGrid> withHole() const {
    const terrain::ElevationGrid& grid = *input_.terrain;
    const geo::Point at = plan_.tour[plan_.tour.size() / 2].pose.point();
    std::vector<float> values = grid.values();
    for (const int up : {-1, 0, 1}) {
      for (const int right : {-1, 0, 1}) {
        const int cell = (grid.rowOf(at.y) + up) * grid.columns() + grid.columnOf(at.x) + right;
        values[static_cast<std::size_t>(cell)] = terrain::kUnknownUpper;
      }
    }
    return std::make_shared<const terrain::ElevationGrid>(grid.originX(), grid.originY(), grid.cellSize(), grid.columns(), grid.rows(),
                                                          std::move(values));
  }

  tour::PlanInput input_;
  mission::Plan plan_;
};

QTEST_APPLESS_MAIN(TestPrepareExport)
#include "tst_prepare_export.moc"
