// Every bundled mission with targets ends in a certified plan, and the certificate survives a second, separate look.
#include "tests/support/cli_run.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

class TestBundledMissions : public QObject {
  Q_OBJECT

private slots:
  void mission_planned_isCertified_data() {
    QTest::addColumn<QString>("mission");
    const QDir maps(QStringLiteral(VOLPLANE_SOURCE_DIR "/maps"));
    for (const QString& name : maps.entryList({"*.vpm"}, QDir::Files)) {
      if (readAll(maps.filePath(name)).contains("\"height_m\"")) {
        QTest::newRow(qPrintable(name)) << maps.filePath(name);
      }
    }
  }

  void mission_planned_isCertified() {
    QFETCH(QString, mission);
    QTemporaryDir folder;
    const QString plan = folder.filePath("plan.vpp");
    const CliResult planned = runCli({"plan", mission, "-o", plan, "--threads", "2"});
    QVERIFY2(planned.status == 0, planned.err + planned.out);
    const CliResult verified = runCli({"verify", plan});
    QVERIFY2(verified.status == 0, verified.out);
    QVERIFY(verified.out.contains("VERIFIED SAFE"));
  }
};

QTEST_GUILESS_MAIN(TestBundledMissions)
#include "tst_bundled_missions.moc"
