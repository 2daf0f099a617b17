// Bundled and real missions under wind: planned, certified by the checker and exported, or refused with the target and the reason.
// VOLPLANE_ALL_WINDS=1 takes every mission with calm, 10 and 20 kt from eight directions, layers and an uncertain wind.
#include "tests/support/cli_run.h"
#include "tests/support/data_folder.h"
#include "tests/support/real_missions.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

namespace {

QStringList winds() {
  QStringList list{"240+-20/15+-5kt", "0ft 180/5kt; 6000ft 250/20kt"};
  if (!qEnvironmentVariableIsSet("VOLPLANE_ALL_WINDS")) {
    return list << "045/20kt";
  }
  list << "calm";
  for (const int knots : {10, 20}) {
    for (int direction = 0; direction < 8; ++direction) {
      list << QStringLiteral("%1/%2kt").arg(45 * direction, 3, 10, QLatin1Char('0')).arg(knots);
    }
  }
  return list;
}

}  // namespace

class TestWindMissions : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    const QDir maps(QStringLiteral(VOLPLANE_SOURCE_DIR "/maps"));
    const bool isAll = qEnvironmentVariableIsSet("VOLPLANE_ALL_WINDS");
    for (const QString& name : maps.entryList({"*.vpm"})) {
      const bool hasTargets = !QJsonDocument::fromJson(readAll(maps.filePath(name))).object()["targets"].toArray().isEmpty();
      if (hasTargets && (isAll || name == QLatin1String("mountain-n20.vpm") || name == QLatin1String("alpine-n10.vpm"))) {
        missions_.emplace_back(name, maps.filePath(name));
      }
    }
    if (const QString data = dataFolder(); !data.isEmpty()) {
      int number = 0;
      for (const RealMission& mission : realMissions(data)) {
        const QString file = folder_.filePath(QStringLiteral("real-%1.vpm").arg(++number));
        QVERIFY(writeAll(file, mission.text()));
        missions_.emplace_back(QLatin1String(mission.name), file);
      }
    }
  }

  void inWind_isCertifiedOrSaysWhy_data() {
    QTest::addColumn<QString>("mission");
    QTest::addColumn<QString>("wind");
    for (const auto& [name, file] : missions_) {
      for (const QString& wind : winds()) {
        QTest::newRow(qPrintable(name + QStringLiteral(", ") + wind)) << file << wind;
      }
    }
  }
  void inWind_isCertifiedOrSaysWhy() {
    QFETCH(QString, mission);
    QFETCH(QString, wind);
    const QString plan = folder_.filePath("plan.vpp");
    QFile::remove(plan);
    const CliResult planned = runCli({"plan", mission, "--wind", wind, "-o", plan, "--threads", "2"});
    if (planned.status == 1) {
      QVERIFY2(planned.err.contains("target") || planned.err.contains("landing site"), planned.err);
      qInfo().noquote() << "no plan:" << planned.err.trimmed();
      return;
    }
    QVERIFY2(planned.status == 0, planned.err + planned.out);
    const CliResult verified = runCli({"verify", plan});
    QVERIFY2(verified.status == 0, verified.out + verified.err);
    QVERIFY2(wind == QLatin1String("calm") || verified.out.contains("in every wind") || verified.out.contains("in a wind"), verified.out);
    const CliResult exported = runCli({"--json", "export", plan, "--folder", folder_.path(), "--pattern", "x-{format}", "-f", "fms,kml"});
    QVERIFY2(exported.status == 0, exported.out + exported.err);
  }

private:
  QTemporaryDir folder_;
  std::vector<std::pair<QString, QString>> missions_;
};

QTEST_GUILESS_MAIN(TestWindMissions)
#include "tst_wind_missions.moc"
