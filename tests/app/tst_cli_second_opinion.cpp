// volplane-cli verify --independent-samples: report, exit status, sameness, and plans that were tampered with.
#include "tests/support/cli_run.h"
#include "tests/support/schema_check.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <csignal>

using namespace vp::test;

namespace {

const QString kPlan = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpp");

/// "" if a report fits its schema.
std::string misfit(const QByteArray& report) {
  return schemaMisfit("second-opinion", nlohmann::json::parse(report.toStdString()));
}

QJsonObject reportIn(const QString& file) {
  return QJsonDocument::fromJson(readAll(file)).object();
}

}  // namespace

class TestCliSecondOpinion : public QObject {
  Q_OBJECT

private slots:
  void init() { QVERIFY(folder_.isValid()); }

  void bundledPlan_isSafeAndReported() {
    const QString file = folder_.filePath("a.json");
    const CliResult result = runCli({"verify", kPlan, "--independent-samples", "300", "--seed", "3", "--report", file});
    QVERIFY2(result.status == 0, result.out + result.err);
    QVERIFY2(result.out.contains("After each of 300 engine failures at random places the aircraft came down as the plan promises."), result.out);
    QVERIFY2(misfit(readAll(file)).empty(), misfit(readAll(file)).c_str());
    const QJsonObject report = reportIn(file);
    QVERIFY(report["safe"].toBool());
    QCOMPARE(report["samples"].toInt(), 300);
    QCOMPARE(report["seed"].toInt(), 3);
    QCOMPARE(report["margins"].toArray().size(), 3);
    const QJsonObject inputs = report["inputs"].toObject();
    QCOMPARE(inputs["terrain"][0]["sha256"].toString(), inputs["terrain"][0]["sha256InPlan"].toString());
    QCOMPARE(inputs["airfields"].toArray().size(), 2);
    QCOMPARE(inputs["airfields"][0]["sha256"].toString().size(), 64);
    // the same seed gives the same bytes, by any number of threads
    const QString again = folder_.filePath("b.json");
    QCOMPARE(runCli({"verify", kPlan, "--independent-samples", "300", "--seed", "3", "--threads", "3", "--report", again}).status, 0);
    QCOMPARE(readAll(again), readAll(file));
    QCOMPARE(runCli({"verify", kPlan, "--independent-samples", "300", "--seed", "4", "--report", again}).status, 0);
    QVERIFY(readAll(again) != readAll(file));
  }

  void json_holdsBothVerdicts() {
    const CliResult result = runCli({"--json", "verify", kPlan, "--independent-samples", "20"});
    QCOMPARE(result.status, 0);
    const QJsonObject json = QJsonDocument::fromJson(result.out).object();
    QVERIFY(json["safe"].toBool() && json["secondOpinion"]["safe"].toBool());
    QCOMPARE(json["secondOpinion"]["samples"].toInt(), 20);
    QVERIFY(!QJsonDocument::fromJson(runCli({"--json", "verify", kPlan}).out).object().contains("secondOpinion"));
  }

  /// The checker finds all of these too; here the second opinion's own count is looked at.
  void tamperedPlan_isUnsafe_data() {
    QTest::addColumn<QString>("what");
    QTest::newRow("tour 10 m lower") << "lower";
    QTest::newRow("wind") << "wind";
    QTest::newRow("worse polar") << "drag";
    QTest::newRow("another site's elevation") << "elevation";
    QTest::newRow("site moved") << "site";
  }
  void tamperedPlan_isUnsafe() {
    QFETCH(QString, what);
    QJsonObject plan = QJsonDocument::fromJson(readAll(kPlan)).object();
    plan["terrain"] =
        QJsonArray{QJsonObject{{"path", QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine.tif")}, {"sha256", plan["terrain"][0]["sha256"]}}};
    QJsonObject mission = plan["mission"].toObject();
    if (what == "lower") {
      QJsonArray tour = plan["tour"].toArray();
      for (QJsonValueRef point : tour) {
        QJsonObject lower = point.toObject();
        lower["altitude_m"] = lower["altitude_m"].toDouble() - 10.0;
        point = lower;
      }
      plan["tour"] = tour;
    } else if (what == "wind") {
      mission["wind"] = QJsonArray{QJsonObject{{"altitude_m", 0.0}, {"from_deg", 250.0}, {"speed_mps", 10.0}}};
    } else if (what == "drag") {
      QJsonObject safety = mission["safety"].toObject();
      safety["dragFactor"] = 1.1;
      mission["safety"] = safety;
    } else {
      QJsonArray sites = plan["sites"].toArray();
      for (QJsonValueRef site : sites) {
        QJsonObject changed = site.toObject();
        if (what == "elevation") {
          changed["elevation_m"] = changed["elevation_m"].toDouble() + 300.0;
        } else {
          QJsonArray pose = changed["pose"].toArray();
          pose[0] = pose[0].toDouble() + 1.0;
          changed["pose"] = pose;
        }
        site = changed;
      }
      plan["sites"] = sites;
    }
    plan["mission"] = mission;
    const QString file = folder_.filePath("tampered.vpp");
    const QString report = folder_.filePath("tampered.json");
    QFile::remove(report);
    QVERIFY(writeAll(file, QJsonDocument(plan).toJson()));
    const CliResult result = runCli({"verify", file, "--independent-samples", "400", "--report", report});
    QVERIFY2(result.status == 3, result.out + result.err);
    QVERIFY2(reportIn(report)["unsafe"].toInt() > 0, readAll(report));
    QVERIFY2(misfit(readAll(report)).empty(), misfit(readAll(report)).c_str());
    QVERIFY(!reportIn(report)["safe"].toBool());
    QVERIFY(result.out.contains("NOT SAFE: after") && result.out.contains("unsafe: tour point"));
  }

  void changedTerrain_isSaid() {
    QJsonObject plan = QJsonDocument::fromJson(readAll(kPlan)).object();
    plan["terrain"] = QJsonArray{QJsonObject{{"path", QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine.tif")}, {"sha256", QString(64, 'a')}}};
    QVERIFY(writeAll(folder_.filePath("t.vpp"), QJsonDocument(plan).toJson()));
    const CliResult result = runCli({"verify", folder_.filePath("t.vpp"), "--independent-samples", "50"});
    QCOMPARE(result.status, 3);
    QVERIFY2(result.out.contains("NOT SAFE: the terrain is not the one that the plan was made with"), result.out);
  }

  void usage_isChecked() {
    QCOMPARE(runCli({"verify", kPlan, "--seed", "3"}).status, 2);
    QCOMPARE(runCli({"verify", kPlan, "--report", "x.json"}).status, 2);
    QCOMPARE(runCli({"verify", kPlan, "--independent-samples", "0"}).status, 2);
    QCOMPARE(runCli({"verify", kPlan, "--independent-samples", "5", "--report", "/no/such/folder/x.json"}).status, 2);
  }

  void stopped_writesNothing() {
    const QString file = folder_.filePath("stopped.json");
    QProcess process;
    process.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane-cli"), {"verify", kPlan, "--independent-samples", "10000000", "--report", file});
    QVERIFY(process.waitForStarted());
    QTest::qWait(1500);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(!QFile::exists(file));
  }

private:
  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCliSecondOpinion)
#include "tst_cli_second_opinion.moc"
