// Every bundled mission is one that the readers take without complaint, and that comes back the same when written.
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"
#include "core/safety/checker.h"
#include "tests/core/formats/format_samples.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;

class TestMapMissions : public QObject {
  Q_OBJECT

private:
  const QDir maps_{QStringLiteral(VOLPLANE_SOURCE_DIR "/maps")};
  QTemporaryDir fresh_;

private slots:
  void mission_isReadAndLoaded_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("targets");
    QTest::addColumn<int>("sites");
    QTest::addColumn<QStringList>("notes");
    const QStringList none;
    for (const int count : {5, 10, 20, 50, 100}) {
      QTest::addRow("mountain, %d targets", count) << QStringLiteral("mountain-n%1.vpm").arg(count) << count << 5 << none;
    }
    // Twelve airfields with a site at each end; of all the notes only the heliport's is meant to be there.
    const QStringList heliport{QStringLiteral("1 left out: heliport (VAH1)")};
    QTest::newRow("alpine, 10 targets") << QStringLiteral("alpine-n10.vpm") << 10 << 24 << heliport;
    QTest::newRow("alpine, 30 targets") << QStringLiteral("alpine-n30.vpm") << 30 << 24 << heliport;
    QTest::newRow("flat ground") << QStringLiteral("flat.vpm") << 0 << 1 << none;
    QTest::newRow("three blocks") << QStringLiteral("three-blocks.vpm") << 0 << 1 << none;
    QTest::newRow("two runways") << QStringLiteral("two-runways.vpm") << 0 << 2 << none;
  }

  void mission_isReadAndLoaded() {
    QFETCH(QString, name);
    QFETCH(int, targets);
    QFETCH(int, sites);
    QFETCH(QStringList, notes);
    const auto mission = formats::readMission(maps_.filePath(name).toStdString());
    QVERIFY2(mission, mission ? "" : mission.error().message().c_str());
    const auto loaded = formats::loadMission(*mission, maps_.path().toStdString(), Job{});
    QVERIFY2(loaded, loaded ? "" : loaded.error().message().c_str());
    QStringList said;
    for (const std::string& note : loaded->notes) {
      said << QString::fromStdString(note);
    }
    QCOMPARE(said, notes);
    QCOMPARE(static_cast<int>(loaded->targets.size()), targets);
    QCOMPARE(static_cast<int>(loaded->sites.size()), sites);
    for (const mission::SiteInFrame& site : loaded->sites) {
      const double ground = loaded->terrain->upperAt(site.pose.point());
      QVERIFY2(std::isfinite(ground) && site.site.elevation.metres() >= ground - 1.0, site.site.id.c_str());
      QVERIFY2(!site.site.isApproximate(), site.site.id.c_str());
    }
    for (const mission::TargetInFrame& target : loaded->targets) {
      const double ground = loaded->terrain->upperAt(target.point);
      QVERIFY2(std::isfinite(ground) && target.altitude >= ground, target.target.name.c_str());
    }
  }

  void mission_writtenAndRead_isTheSame_data() { mission_isReadAndLoaded_data(); }

  void mission_writtenAndRead_isTheSame() {
    QFETCH(QString, name);
    QVERIFY(fresh_.isValid());
    const auto mission = formats::readMission(maps_.filePath(name).toStdString());
    QVERIFY(mission);
    const std::string path = fresh_.filePath(name).toStdString();
    const auto written = formats::writeMission(*mission, path);
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    const auto back = formats::readMission(path);
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QVERIFY(formats::samples::sameMission(*mission, *back));
  }

  void rows_coverEveryBundledMission() { QCOMPARE(maps_.entryList({QStringLiteral("*.vpm")}, QDir::Files).size(), 5 + 2 + 3); }

  void bundledPlan_isCertifiedForItsMission() {
    const auto mission = formats::readMission(maps_.filePath("alpine-n10.vpm").toStdString());
    auto plan = formats::readPlan(maps_.filePath("alpine-n10.vpp").toStdString());
    QVERIFY(mission && plan);
    QCOMPARE(plan->mission.targets.size(), mission->targets.size());
    QVERIFY(plan->mission.targets == mission->targets);
    QVERIFY(plan->mission.planner == mission->planner);
    QVERIFY(plan->certificate.has_value());
    std::vector<std::string> checksums;
    const auto terrain = formats::readPlanTerrain(*plan, maps_.path().toStdString(), checksums, Job{});
    QVERIFY2(terrain, terrain ? "" : terrain.error().message().c_str());
    const auto report = safety::check({*plan, *terrain, checksums}, Job{});
    QVERIFY(report.has_value());
    QVERIFY2(report->isSafe(), report->findings.empty() ? "" : report->findings.front().text.c_str());
  }
};

QTEST_APPLESS_MAIN(TestMapMissions)
#include "tst_map_missions.moc"
