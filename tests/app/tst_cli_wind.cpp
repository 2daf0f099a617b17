// Wind by command line: into missions and plans, out again in words, and refused with a sentence.
#include "tests/support/cli_run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");

QJsonObject jsonIn(const QString& path) {
  return QJsonDocument::fromJson(readAll(path)).object();
}

}  // namespace

class TestCliWind : public QObject {
  Q_OBJECT

  /// A mission over the alpine map with the options given.
  CliResult newMission(const QString& output, const QStringList& options) {
    return runCli(QStringList{"new-mission", "--terrain", kMaps + "alpine.tif", "--airports", kMaps + "alpine-airports.csv", "--runways",
                              kMaps + "alpine-runways.csv", "--target", "46.312462732,-27.308986398", "-o", output, "--replace"} +
                  options);
  }

  /// A quick plan; whether it is safe is not what is asked here.
  CliResult quickPlan(const QString& mission, const QString& plan, const QStringList& options) {
    return runCli(QStringList{"plan", mission, "-o", plan, "--headings", "2", "--step", "200", "--refine", "none", "--keep-unverified"} + options);
  }

private slots:
  void init() { QVERIFY(folder_.isValid()); }

  void newMission_withAReport_holdsItsWindAndInfoSaysIt() {
    const QString mission = folder_.filePath("report.vpm");
    const CliResult made =
        newMission(mission, {"--aircraft", "cessna172-operational", "--wind", "METAR LPAZ 121250Z 27015G25KT 240V300 9999 TEMPO 29030KT="});
    QVERIFY2(made.status == 0, made.err);
    QVERIFY2(made.out.contains("note: --wind: ignored: 9999 TEMPO 29030KT") && made.out.contains("taken for all heights"), made.out);
    const QJsonObject layer = jsonIn(mission)["wind"].toArray().at(0).toObject();
    QCOMPARE(layer["from_deg"].toDouble(), 270.0);
    QCOMPARE(layer["spread_deg"].toDouble(), 30.0);
    QVERIFY(qAbs(layer["mostSpeed_mps"].toDouble() - 12.8611) < 1e-4);
    const CliResult info = runCli({"info", mission});
    QVERIFY2(info.out.contains("  wind 15 to 25 kt from 240 to 300 degrees at every height\n"), info.out);
    const QJsonObject wind = QJsonDocument::fromJson(runCli({"--json", "info", mission}).out).object()["wind"].toObject();
    QCOMPARE(wind["text"].toString(), QStringLiteral("270\u00B130/15-25kt"));
    QCOMPARE(wind["layers"].toArray().at(0).toObject()["spread_deg"].toDouble(), 30.0);
    QCOMPARE(wind["words"].toArray().size(), 1);
  }

  void newMission_withLayers_takesThemInOneOptionOrSeveral() {
    const QString one = folder_.filePath("one.vpm");
    const QString several = folder_.filePath("several.vpm");
    QCOMPARE(newMission(one, {"--name", "m", "--wind", "0ft 270/5kt; 5000ft 290/10kt"}).status, 0);
    QCOMPARE(newMission(several, {"--name", "m", "--wind", "0ft 270/5kt", "--wind", "5000ft 290/10kt"}).status, 0);
    QCOMPARE(jsonIn(one)["wind"].toArray().size(), 2);
    QCOMPARE(readAll(one), readAll(several));
    QVERIFY(runCli({"info", one}).out.contains("  wind 5000 ft: 10 kt from 290 degrees\n"));
  }

  void newMission_inWindThatNoRunwayAllows_saysThatItIsTheWind() {
    const CliResult made = newMission(folder_.filePath("gale.vpm"), {"--wind", "VRB20KT"});
    QCOMPARE(made.status, 2);
    QVERIFY2(made.err.contains("in this wind the aircraft may land on no runway") && made.err.contains("the aircraft's limit is 10 kt"), made.err);
    QVERIFY(!QFile::exists(folder_.filePath("gale.vpm")));
  }

  void newMission_withoutWind_saysNothingOfIt() {
    const QString mission = folder_.filePath("still.vpm");
    QCOMPARE(newMission(mission, {}).status, 0);
    QCOMPARE(jsonIn(mission)["aircraft"].toString(), QStringLiteral("cessna172-handbook"));
    QVERIFY(!jsonIn(mission).contains("wind"));
    QVERIFY(runCli({"info", mission}).out.contains("  wind still air\n"));
    QCOMPARE(newMission(mission, {"--wind", "calm"}).status, 0);
    QVERIFY(!jsonIn(mission).contains("wind"));
  }

  void plan_withWind_holdsItAndCalmClearsIt() {
    const QString plan = folder_.filePath("wind.vpp");
    const CliResult planned = quickPlan(kMaps + "mountain-n5.vpm", plan, {"--wind", "270+-20/2-4kt"});
    QVERIFY2(planned.out.contains("  wind 2 to 4 kt from 250 to 290 degrees at every height\n"), planned.err + planned.out);
    QCOMPARE(jsonIn(plan)["mission"].toObject()["wind"].toArray().at(0).toObject()["spread_deg"].toDouble(), 20.0);
    QVERIFY(runCli({"info", plan}).out.contains("  wind 2 to 4 kt from 250 to 290 degrees at every height\n"));
    QCOMPARE(QJsonDocument::fromJson(runCli({"info", plan, "--json"}).out).object()["wind"].toObject()["text"].toString(),
             QStringLiteral("270\u00B120/2-4kt"));
    QByteArray text = readAll(kMaps + "mountain-n5.vpm");
    text.replace("\"terrain\"", "\"wind\": [{\"altitude_m\": 0, \"from_deg\": 270, \"speed_mps\": 3}], \"terrain\"");
    text.replace("\"mountain.tif\"", QByteArray("\"") + (kMaps + "mountain.tif").toUtf8() + "\"");
    QVERIFY(writeAll(folder_.filePath("windy.vpm"), text));
    const QString windy = folder_.filePath("windy.vpp");
    const QString cleared = folder_.filePath("cleared.vpp");
    quickPlan(folder_.filePath("windy.vpm"), windy, {});
    QCOMPARE(jsonIn(windy)["mission"].toObject()["wind"].toArray().size(), 1);
    const CliResult calm = quickPlan(folder_.filePath("windy.vpm"), cleared, {"--wind", "calm"});
    QVERIFY2(calm.status == 0, calm.err + calm.out);
    QVERIFY(!jsonIn(cleared)["mission"].toObject().contains("wind"));
    QVERIFY(jsonIn(windy)["tour"] != jsonIn(cleared)["tour"]);
  }

  void badWind_isRefusedWithASentence_data() {
    QTest::addColumn<QStringList>("winds");
    QTest::addColumn<QByteArray>("part");
    QTest::newRow("two digits") << QStringList{"27/15kt"} << QByteArray("wind \"27/15kt\" at character 1: a direction of three digits");
    QTest::newRow("empty") << QStringList{""} << QByteArray("the wind is empty");
    QTest::newRow("twice everywhere") << QStringList{"270/15kt", "280/15kt"} << QByteArray("each needs its altitude");
    QTest::newRow("turned") << QStringList{"5000ft 270/15kt", "0ft 280/15kt"} << QByteArray("at 0 ft comes after the one at 5000 ft");
    QTest::newRow("too strong") << QStringList{"0ft 270/15kt", "5000ft 280/70kt"}
                                << QByteArray("the wind of 70 kt at 5000 ft is not below the gliding speed of 64.9 kt");
  }
  void badWind_isRefusedWithASentence() {
    QFETCH(QStringList, winds);
    QFETCH(QByteArray, part);
    QStringList options;
    for (const QString& wind : winds) {
      options += {"--wind", wind};
    }
    const QString output = folder_.filePath("refused");
    for (const CliResult& result :
         {newMission(output, options + QStringList{"--aircraft", "cessna172-operational"}), quickPlan(kMaps + "mountain-n5.vpm", output, options)}) {
      QVERIFY2(result.status == 2, result.out + result.err);
      QVERIFY2(result.err.contains("--wind: ") && result.err.contains(part), result.err);
      QCOMPARE(result.err.trimmed().count('\n'), 0);
      QVERIFY(!QFile::exists(output));
    }
  }

private:
  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCliWind)
#include "tst_cli_wind.moc"
