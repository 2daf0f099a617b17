// BASE and LAZY must agree: the same cost where the tour solver is exact, within half a percent where it is not.
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/tour/planner.h"

#include <QTest>

#include <cmath>

using namespace vp;

class TestBaseLazy : public QObject {
  Q_OBJECT

private slots:
  void costs_underTenSeeds_agree_data() {
    QTest::addColumn<QString>("mission");
    QTest::addColumn<int>("seeds");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<bool>("hasLayers");
    QTest::newRow("5 targets, solved exactly") << "mountain-n5.vpm" << 10 << 1e-6 << false;
    QTest::newRow("20 targets") << "mountain-n20.vpm" << 10 << 0.005 << false;
    QTest::newRow("5 targets in layers of wind") << "mountain-n5.vpm" << 6 << 1e-6 << true;
  }

  void costs_underTenSeeds_agree() {
    QFETCH(QString, mission);
    QFETCH(int, seeds);
    QFETCH(double, tolerance);
    QFETCH(bool, hasLayers);
    const std::string folder = VOLPLANE_SOURCE_DIR "/maps";
    const Result<mission::Mission> read = formats::readMission(folder + "/" + mission.toStdString());
    QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
    const Result<formats::LoadedMission> loaded = formats::loadMission(*read, folder, Job{});
    QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().message().c_str());
    tour::PlanInput input{loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "test", "LKH", 2};
    if (hasLayers) {
      input.mission.wind = {{geo::HeightMsl::fromMetres(250.0), {200.0, 20.0, 1.0, 4.0}},
                            {geo::HeightMsl::fromMetres(500.0), {270.0, 10.0, 7.0, 11.0}},
                            {geo::HeightMsl::fromMetres(800.0), {320.0, 0.0, 3.0, 3.0}}};
    }
    input.mission.planner.headings = 4;
    input.mission.planner.refine = mission::Refine::None;
    input.mission.planner.step = Length::fromSi(100.0);
    input.mission.planner.roadmapSamples = 1000;
    for (int seed = 1; seed <= seeds; ++seed) {
      input.mission.planner.seed = static_cast<std::uint64_t>(seed);
      input.mission.planner.method = mission::Method::Base;
      const Result<mission::Plan> base = tour::planTour(input, Job{});
      input.mission.planner.method = mission::Method::Lazy;
      const Result<mission::Plan> lazy = tour::planTour(input, Job{});
      QVERIFY(base && lazy);
      const double difference = std::abs(lazy->metrics.cost / base->metrics.cost - 1.0);
      QVERIFY2(difference <= tolerance, qPrintable(QString("seed %1: BASE %2, LAZY %3").arg(seed).arg(base->metrics.cost).arg(lazy->metrics.cost)));
      QVERIFY(lazy->metrics.safeSegments < base->metrics.safeSegments / 2);
    }
  }
};

QTEST_APPLESS_MAIN(TestBaseLazy)
#include "tst_base_lazy.moc"
