// The whole job by command line: plan, verify, export, info, reproducibility, Ctrl-C.
#include "tests/support/cli_run.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace vp::test;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");

QStringList quickPlan(const QString& mission, const QString& plan, const QStringList& more = {}) {
  return QStringList{"plan", mission, "-o", plan, "--headings", "4", "--step", "100", "--roadmap-samples", "800"} + more;
}

}  // namespace

class TestCli : public QObject {
  Q_OBJECT

  void exportsSeveral(const QString& plan) {
    const QStringList several{"--json", "export", plan, "-f", "gpx,fpl,fms3", "--folder", folder_.filePath("out/june"), "--pattern", "a-{format}"};
    const CliResult first = runCli(several);
    QVERIFY2(first.status == 0, first.err + first.out);
    const QJsonObject json = QJsonDocument::fromJson(first.out).object();
    QVERIFY(json["verified"].toBool());
    QCOMPARE(json["files"].toArray().size(), 3);
    QVERIFY(json["routes"].toArray().at(0)["verified"].toBool() && json["routes"].toArray().at(0)["margins"].toArray().size() > 3);
    QVERIFY(writeAll(folder_.filePath("out/june/a-gpx.gpx"), "mine"));
    const CliResult second = runCli(several);
    QCOMPARE(second.status, 0);
    QCOMPARE(readAll(folder_.filePath("out/june/a-gpx.gpx~")), QByteArray("mine"));
    QVERIFY(readAll(folder_.filePath("out/june/a-gpx.gpx")).startsWith("<?xml"));
    QCOMPARE(runCli({"export", plan, "-f", "gpx,fpl", "-o", folder_.filePath("x.gpx")}).status, 2);
    QCOMPARE(runCli({"export", plan, "-f", "gpx"}).status, 2);
  }

private slots:
  void init() { QVERIFY(folder_.isValid()); }

  void wholeJob_underTheBundledMission_works() {
    const QString plan = folder_.filePath("n5.vpp");
    const CliResult planned = runCli(quickPlan(kMaps + "mountain-n5.vpm", plan));
    QVERIFY2(planned.status == 0, planned.err + planned.out);
    QVERIFY(planned.out.contains("VERIFIED SAFE"));
    const CliResult verified = runCli({"verify", plan});
    QCOMPARE(verified.status, 0);
    const CliResult fms = runCli({"export", plan, "--format", "fms", "-o", folder_.filePath("n5.fms")});
    QVERIFY2(fms.status == 0, fms.err);
    QVERIFY(fms.out.contains("rounded up"));
    QVERIFY(readAll(folder_.filePath("n5.fms")).startsWith("I\n1100 Version\nCYCLE "));
    QCOMPARE(runCli({"export", plan, "--format", "geojson", "-o", folder_.filePath("n5.geojson")}).status, 0);
    QVERIFY(QJsonDocument::fromJson(readAll(folder_.filePath("n5.geojson"))).object()["features"].toArray().size() > 10);
    exportsSeveral(plan);
    const CliResult info = runCli({"info", plan});
    QCOMPARE(info.status, 0);
    QVERIFY(info.out.contains("5 targets"));
    QVERIFY(runCli({"info", kMaps + "mountain-n5.vpm"}).out.contains("5 landing sites"));
    QVERIFY(runCli({"info", kMaps + "mountain.tif"}).out.contains("posts"));
    QVERIFY(runCli({"info", VOLPLANE_SOURCE_DIR "/resources/aircraft/cessna172-elasp.json"}).out.contains("stalls"));
  }

  void importTargets_addsThemAndListsThoseOutsideTheTerrain() {
    const QString mission = folder_.filePath("import.vpm");
    QVERIFY(QFile::copy(kMaps + "mountain-n5.vpm", mission));
    QVERIFY(QFile::copy(kMaps + "mountain.tif", folder_.filePath("mountain.tif")));
    QFile table(folder_.filePath("more.csv"));
    QVERIFY(table.open(QIODevice::WriteOnly));
    table.write("name,lat,lon\nInside,47.0,-25.0\nFar,10.0,10.0\nBad,x,1\n");
    table.close();
    const CliResult imported = runCli({"import-targets", mission, table.fileName(), "--agl", "250", "-o", folder_.filePath("out.vpm")});
    QVERIFY2(imported.status == 0, imported.err);
    QVERIFY2(imported.out.contains("2 targets added, 7 in all") && imported.out.contains("row 4") && imported.out.contains("target Far"),
             imported.out);
    const QJsonArray targets = QJsonDocument::fromJson(readAll(folder_.filePath("out.vpm"))).object()["targets"].toArray();
    QCOMPARE(targets.size(), 7);
    QCOMPARE(targets[5].toObject()["height_m"].toDouble(), 250.0);
    QCOMPARE(runCli({"import-targets", mission, kMaps + "mountain.tif"}).status, 2);
  }

  void roadmapOptions_underPlan_chooseTheKind() {
    const auto plannerOf = [&](const QStringList& options) {
      const QString plan = folder_.filePath("kind.vpp");
      const CliResult planned = runCli(QStringList{"plan", kMaps + "mountain-n5.vpm", "-o", plan, "--headings", "2", "--step", "200"} + options);
      return planned.status == 0 ? QJsonDocument::fromJson(readAll(plan)).object()["mission"].toObject()["planner"].toObject() : QJsonObject();
    };
    const QJsonObject samples = plannerOf({"--roadmap-samples", "300", "--refine", "none"});
    QCOMPARE(samples["roadmap"].toString(), QStringLiteral("rrtstar"));  // lattices have no samples
    QCOMPARE(samples["refine"].toString(), QStringLiteral("none"));
    const QJsonObject lattice = plannerOf({"--roadmap", "lattice", "--roadmap-samples", "300"});
    QCOMPARE(lattice["roadmap"].toString(), QStringLiteral("lattice"));
    QCOMPARE(lattice["refine"].toString(), QStringLiteral("full"));
  }

  void sameSeed_underTwoRunsAndThreads_givesTheSameBytes() {
    const QString a = folder_.filePath("a.vpp");
    const QString b = folder_.filePath("b.vpp");
    const QString c = folder_.filePath("c.vpp");
    QCOMPARE(runCli(quickPlan(kMaps + "mountain-n5.vpm", a, {"--seed", "3"})).status, 0);
    QCOMPARE(runCli(quickPlan(kMaps + "mountain-n5.vpm", b, {"--seed", "3", "--threads", "2"})).status, 0);
    QCOMPARE(runCli(quickPlan(kMaps + "mountain-n5.vpm", c, {"--seed", "4"})).status, 0);
    QVERIFY(!readAll(a).isEmpty());
    QCOMPARE(readAll(a), readAll(b));
    QVERIFY(readAll(a) != readAll(c));
  }

  void json_underPlanAndVerify_isMachineReadable() {
    const QString plan = folder_.filePath("json.vpp");
    const CliResult planned = runCli(quickPlan(kMaps + "mountain-n5.vpm", plan, {"--json"}));
    const QJsonObject result = QJsonDocument::fromJson(planned.out).object();
    QVERIFY2(result["cost_m"].toDouble() > 1000.0, planned.out);
    QVERIFY(result["verification"].toObject()["safe"].toBool());
    QVERIFY(result["sampledCost_m"].toDouble() >= result["cost_m"].toDouble() && result["movesTried"].toInt() > 0);
    const CliResult paper = runCli(quickPlan(kMaps + "mountain-n5.vpm", plan, {"--json", "--refine", "none"}));
    QCOMPARE(QJsonDocument::fromJson(paper.out).object()["cost_m"].toDouble(), result["sampledCost_m"].toDouble());
    QCOMPARE(QJsonDocument::fromJson(paper.out).object()["movesTried"].toInt(), 0);
    QCOMPARE(runCli(quickPlan(kMaps + "mountain-n5.vpm", plan, {"--quiet"})).status, 0);
    QCOMPARE(result["order"].toArray().size(), 5);
    const QJsonObject verdict = QJsonDocument::fromJson(runCli({"verify", plan, "--json"}).out).object();
    QVERIFY(verdict["safe"].toBool() && verdict["margins"].toArray().size() >= 4);
    const CliResult failed = runCli({"verify", folder_.filePath("none.vpp"), "--json"});
    QCOMPARE(failed.status, 2);
    QCOMPARE(QJsonDocument::fromJson(failed.out).object()["exit"].toInt(), 2);
  }

  void tamperedPlan_isRefusedByVerifyAndExport() {
    const QString plan = folder_.filePath("t.vpp");
    QCOMPARE(runCli(quickPlan(kMaps + "mountain-n5.vpm", plan)).status, 0);
    QByteArray bytes = readAll(plan);
    bytes.replace("\"clearance_m\": 100", "\"clearance_m\": 180");  // asks for more than was planned for
    QVERIFY(writeAll(plan, bytes));
    const CliResult verified = runCli({"verify", plan});
    QCOMPARE(verified.status, 3);
    QVERIFY2(verified.out.contains("NOT SAFE") && verified.out.contains("clearance"), verified.out);
    const CliResult refused = runCli({"export", plan, "-f", "fms", "-o", folder_.filePath("t.fms")});
    QCOMPARE(refused.status, 3);
    QVERIFY(!QFile::exists(folder_.filePath("t.fms")));
    const CliResult forced = runCli({"export", plan, "-f", "fms", "-o", folder_.filePath("t.fms"), "--unverified"});
    QCOMPARE(forced.status, 0);
    QVERIFY(forced.err.contains("UNVERIFIED"));
    QVERIFY(QFile::exists(folder_.filePath("t.fms")));
    QVERIFY(forced.err.contains("nothing in this file can say that it is unverified"));
    const CliResult told = runCli({"--json", "export", plan, "-f", "cup", "-o", folder_.filePath("t.cup")});
    QCOMPARE(told.status, 3);
    QVERIFY(!QJsonDocument::fromJson(told.out).object()["findings"].toArray().isEmpty());
    QVERIFY(!QFile::exists(folder_.filePath("t.cup")));
    QCOMPARE(runCli({"export", plan, "-f", "cup", "-o", folder_.filePath("t.cup"), "--unverified"}).status, 0);
    QVERIFY(readAll(folder_.filePath("t.cup")).contains("UNVERIFIED - DO NOT FLY"));
  }

  void brief_underTheBundledPlan_writesAPdf() {
    const QString pdf = folder_.filePath("alpine.pdf");
    const CliResult brief = runCli({"brief", kMaps + "alpine-n10.vpp", "-o", pdf, "--date", "2026-06-01"});
    QVERIFY2(brief.status == 0, brief.err + brief.out);
    QVERIFY(brief.out.startsWith("briefing of "));
    const QByteArray bytes = readAll(pdf);
    QVERIFY(bytes.startsWith("%PDF-"));
    QVERIFY(bytes.contains("/CreationDate (D:20260601"));
    QCOMPARE(runCli({"brief", kMaps + "alpine-n10.vpp", "-o", pdf, "--date", "2026-06-01", "--quiet"}).status, 0);
    QVERIFY(readAll(pdf) == bytes);
    const CliResult other =
        runCli({"brief", kMaps + "alpine-n10.vpp", "-o", pdf, "--paper", "letter", "--units", "metric", "--monochrome", "--json"});
    QCOMPARE(other.status, 0);
    const QJsonObject json = QJsonDocument::fromJson(other.out).object();
    QVERIFY(json["pages"].toInt() >= 5 && json["verified"].toBool());
  }

  void brief_ofATamperedPlan_isRefused_orMarked() {
    const QString plan = folder_.filePath("b.vpp");
    const QString pdf = folder_.filePath("b.pdf");
    QCOMPARE(runCli(quickPlan(kMaps + "mountain-n5.vpm", plan)).status, 0);
    QByteArray bytes = readAll(plan);
    bytes.replace("\"clearance_m\": 100", "\"clearance_m\": 180");  // asks for more than was planned for
    QVERIFY(writeAll(plan, bytes));
    const CliResult refused = runCli({"brief", plan, "-o", pdf});
    QCOMPARE(refused.status, 3);
    QVERIFY(refused.out.contains("NOT SAFE") && refused.err.contains("not briefed"));
    QVERIFY(!QFile::exists(pdf));
    const CliResult forced = runCli({"brief", plan, "-o", pdf, "--unverified"});
    QCOMPARE(forced.status, 0);
    QVERIFY(forced.err.contains("UNVERIFIED"));
    QVERIFY(QFile::exists(pdf));
  }

  void planAndTerrain_movedTogether_stayVerifiable() {
    QDir(folder_.path()).mkpath("moved/maps");
    QVERIFY(QFile::copy(kMaps + "mountain.tif", folder_.filePath("moved/maps/mountain.tif")));
    QVERIFY(QFile::copy(kMaps + "mountain-n5.vpm", folder_.filePath("moved/maps/mountain-n5.vpm")));
    QCOMPARE(runCli(quickPlan("maps/mountain-n5.vpm", "n5.vpp"), folder_.filePath("moved")).status, 0);
    QVERIFY(QDir(folder_.path()).rename("moved", "elsewhere"));
    const CliResult verified = runCli({"verify", folder_.filePath("elsewhere/n5.vpp")});
    QVERIFY2(verified.status == 0, verified.err + verified.out);
  }

  void interrupt_underPlanning_stopsWithoutAFile() {
    const QString plan = folder_.filePath("stopped.vpp");
    QProcess process;
    process.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane-cli"),
                  {"plan", kMaps + "mountain-n100.vpm", "-o", plan, "--roadmap-samples", "5000000"});
    QVERIFY(process.waitForStarted());
    // planning of this size takes minutes; the signal mask is set before the first file is read
    QVERIFY(!process.waitForFinished(1500));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(20'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(process.readAllStandardError().contains("stopped"));
    QCOMPARE(QDir(folder_.path()).entryList({"stopped*", ".stopped*"}, QDir::Files | QDir::Hidden).size(), 0);
  }

  void help_listsTheCommands() {
    const CliResult help = runCli({"--help"});
    QCOMPARE(help.status, 0);
    for (const char* command : {"plan", "verify", "export", "info"}) {
      QVERIFY(help.out.contains(command));
    }
    QVERIFY(runCli({"--version"}).out.startsWith("volplane-cli "));
  }

private:
  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCli)
#include "tst_cli.moc"
