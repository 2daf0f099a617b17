// Air, pilot, engine and approach by command line: into missions and plans, out again in words, and refused with a sentence.
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

class TestCliSettings : public QObject {
  Q_OBJECT

  CliResult newMission(const QString& output, const QStringList& options) {
    return runCli(QStringList{"new-mission", "--terrain", kMaps + "alpine.tif", "--airports", kMaps + "alpine-airports.csv", "--runways",
                              kMaps + "alpine-runways.csv", "--target", "46.312462732,-27.308986398", "-o", output, "--replace"} +
                  options);
  }

private slots:
  void init() { QVERIFY(folder_.isValid()); }

  void newMission_withEveryOption_holdsThemAndInfoSaysThem() {
    const QString mission = folder_.filePath("all.vpm");
    const CliResult made =
        newMission(mission, {"--reaction", "5s", "--reaction-loss", "100ft", "--drag-factor", "1.1", "--air", "ISA-10", "--qnh", "1005", "--approach",
                             "straight:1500m", "--obstacle-surface", "0.05:30m", "--hold", "--propeller", "stopped", "--power", "65 %"});
    QVERIFY2(made.status == 0, made.err);
    const QJsonObject json = jsonIn(mission);
    const QJsonObject safety = json["safety"].toObject();
    QCOMPARE(safety["reactionTime_s"].toDouble(), 5.0);
    QVERIFY(qAbs(safety["reactionLoss_m"].toDouble() - 30.48) < 1e-9);
    QCOMPARE(safety["dragFactor"].toDouble(), 1.1);
    QCOMPARE(json["atmosphere"].toObject()["temperatureOffset_K"].toDouble(), -10.0);
    QCOMPARE(json["atmosphere"].toObject()["qnh_hPa"].toDouble(), 1005.0);
    const QJsonObject approach = json["approach"].toObject();
    QCOMPARE(approach["kind"].toString(), QStringLiteral("straight"));
    QCOMPARE(approach["finalLength_m"].toDouble(), 1500.0);
    QCOMPARE(approach["surfaceSlope"].toDouble(), 0.05);
    QCOMPARE(approach["surfaceStart_m"].toDouble(), 30.0);
    QCOMPARE(approach["hold"].toBool(), true);
    QCOMPARE(json["propeller"].toString(), QStringLiteral("stopped"));
    QCOMPARE(json["powerSetting"].toString(), QStringLiteral("65 %"));
    const CliResult info = runCli({"info", mission});
    for (const char* line :
         {"  reaction 5 s, 30.48 m of height lost in it\n", "  drag 1.1 times that of the profile\n", "  air ISA-10, QNH 1005 hPa\n",
          "  approach straight for the last 1500 m, at best glide; above an obstacle surface of 0.05 from 30 m before touchdown; circles to lose "
          "height at each site\n",
          "  propeller stopped after the engine has stopped\n", "  power 65 %: 115 kt true airspeed, 27.6 l per hour\n"}) {
      QVERIFY2(info.out.contains(line), info.out);
    }
    QCOMPARE(QJsonDocument::fromJson(runCli({"--json", "info", mission}).out).object()["settings"].toArray().size(), 6);
  }

  void newMission_withoutOptions_reactsAsAPilotDoes() {
    const QString mission = folder_.filePath("plain.vpm");
    QCOMPARE(newMission(mission, {}).status, 0);
    const QJsonObject json = jsonIn(mission);
    QCOMPARE(json["safety"].toObject()["reactionTime_s"].toDouble(), 4.0);  // FAA-H-8083-3
    for (const char* member : {"atmosphere", "approach", "propeller", "powerSetting"}) {
      QVERIFY2(!json.contains(QLatin1String(member)), member);
    }
    QVERIFY(runCli({"info", mission}).out.contains("  reaction 4 s, 0 m of height lost in it\n"));
    QCOMPARE(newMission(mission, {"--reaction", "0"}).status, 0);
    QVERIFY(!jsonIn(mission)["safety"].toObject().contains("reactionTime_s"));
  }

  void plan_overridesTheMission_andClearsIt() {
    QByteArray text = readAll(kMaps + "mountain-n5.vpm");
    text.replace("\"terrain\"",
                 "\"atmosphere\": {\"temperatureOffset_K\": 15}, \"approach\": {\"kind\": \"overhead\", \"keyHeight_m\": 250, \"hold\": true}, "
                 "\"terrain\"");
    text.replace("\"mountain.tif\"", QByteArray("\"") + (kMaps + "mountain.tif").toUtf8() + "\"");
    const QString mission = folder_.filePath("set.vpm");
    QVERIFY(writeAll(mission, text));
    QVERIFY(runCli({"info", mission}).out.contains("  approach from overhead by a full circle, high key at least 250 m above the runway; circles"));
    const QString kept = folder_.filePath("kept.vpp");
    const CliResult asIs = runCli({"plan", mission, "-o", kept, "--headings", "2", "--step", "200", "--refine", "none", "--keep-unverified"});
    const QJsonObject as = jsonIn(kept)["mission"].toObject();
    QVERIFY2(as["approach"].toObject()["hold"].toBool() && as["approach"].toObject()["keyHeight_m"].toDouble() == 250.0, asIs.err + asIs.out);
    QCOMPARE(as["atmosphere"].toObject()["temperatureOffset_K"].toDouble(), 15.0);
    const QString plan = folder_.filePath("cleared.vpp");
    const CliResult planned = runCli({"plan", mission, "-o", plan, "--headings", "2", "--step", "200", "--refine", "none", "--keep-unverified",
                                      "--air", "none", "--approach", "threshold", "--no-hold", "--drag-factor", "1.05"});
    QVERIFY2(planned.out.contains("  drag 1.05 times that of the profile\n") && !planned.out.contains("approach"), planned.err + planned.out);
    const QJsonObject written = jsonIn(plan)["mission"].toObject();
    QVERIFY(!written.contains("atmosphere") && !written.contains("approach"));
    QCOMPARE(written["safety"].toObject()["dragFactor"].toDouble(), 1.05);
    QVERIFY(runCli({"info", plan}).out.contains("  drag 1.05 times that of the profile\n"));
  }

  void safeAltitude_takesThemToo() {
    const auto lowest = [&](const QStringList& options) {
      const CliResult made = runCli(
          QStringList{"--json", "safe-altitude", kMaps + "mountain-n5.vpm", "-o", folder_.filePath("x.tif"), "--worst", "--cell", "200"} + options);
      return QJsonDocument::fromJson(made.out).object()["highest_m"].toDouble();
    };
    QVERIFY(lowest({"--drag-factor", "1.3"}) > lowest({}) + 10.0);
    QCOMPARE(runCli({"safe-altitude", kMaps + "mountain-n5.vpm", "-o", folder_.filePath("x.tif"), "--qnh", "29.92"}).status, 2);
  }

  void badSetting_isRefusedWithASentence_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("part");
    const auto row = [](const char* name, const QStringList& options, const char* part) { QTest::newRow(name) << options << QByteArray(part); };
    row("reaction word", {"--reaction", "soon"}, "--reaction: \"soon\" is no time; give for example 5s");
    row("reaction unit", {"--reaction", "5min"}, "--reaction: \"5min\" is no time");
    row("reaction long", {"--reaction", "61s"}, "--reaction: the reaction time of 61 s is not between 0 and 60 s");
    row("loss", {"--reaction-loss", "501m"}, "--reaction-loss: the height lost in the reaction of 501 m is not between 0 and 500 m");
    row("drag", {"--drag-factor", "0.9"}, "--drag-factor: the drag factor of 0.9 is not between 1 and 3");
    row("air", {"--air", "hot"}, "--air: \"hot\" is no air; give for example ISA, ISA+10");
    row("air far", {"--air", "ISA+51"}, "--air: the temperature offset of 51 K is not between -60 and 50 K");
    row("qnh", {"--qnh", "29.92"}, "--qnh: the QNH of 29.92 hPa is not between 850 and 1090 hPa");
    row("qnh without air", {"--qnh", "1013", "--air", "none"}, "--qnh: a QNH makes no sense with --air none");
    row("approach", {"--approach", "final"}, "--approach: \"final\" is no approach; give for example threshold, straight:1500m");
    row("approach length", {"--approach", "straight:0m"}, "--approach: the final approach of 0 m is not more than 0 and at most 20000 m");
    row("approach slope", {"--approach", "straight:1500m:25deg"}, "--approach: the approach slope of 25 degrees is not more than 0 and at most 20");
    row("slope without figure", {"--approach", "straight:1500m:4deg"},
        "--approach: an approach slope of 4 degrees needs a profile that says how steeply");
    row("key", {"--approach", "overhead:3001m"}, "--approach: the height at high key of 3001 m is not between 0 and 3000 m");
    row("surface", {"--obstacle-surface", "5"}, "--obstacle-surface: the slope of the obstacle surface of 5 is not more than 0 and at most 1");
    row("surface words", {"--obstacle-surface", "low"}, "--obstacle-surface: \"low\" is no obstacle surface");
    row("propeller", {"--propeller", "feathered"}, "--propeller: \"feathered\" is nothing that a propeller does");
    row("propeller unknown", {"--propeller", "stopped", "--aircraft", "motorglider-hk36"},
        "--propeller: the profile of Motor glider HK 36 Super Dimona does not say what the drag is with the propeller stopped");
    row("power", {"--power", "80 %"}, "--power: Cessna 172 (handbook glide) has no power setting \"80 %\"; it has \"75 %\", \"65 %\", \"55 %\"");
    row("power none", {"--power", "80 %", "--aircraft", "uav-aerosonde"}, "its profile has none");
  }
  void badSetting_isRefusedWithASentence() {
    QFETCH(QStringList, options);
    QFETCH(QByteArray, part);
    const CliResult made = newMission(folder_.filePath("bad.vpm"), options);
    QCOMPARE(made.status, 2);
    QVERIFY2(made.err.contains(part), made.err);
    QVERIFY(!QFile::exists(folder_.filePath("bad.vpm")));
  }

  void plan_withPropellerThatTheAircraftLacks_isRefusedBeforePlanning() {
    const CliResult planned = runCli({"plan", kMaps + "mountain-n5.vpm", "-o", folder_.filePath("no.vpp"), "--propeller", "windmilling"});
    QCOMPARE(planned.status, 2);
    QVERIFY2(planned.err.contains("--propeller: the profile of "), planned.err);
  }

private:
  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCliSettings)
#include "tst_cli_settings.moc"
