// What the command line does when the machine fails it: a full disk, a folder that may not be written, terrain that is gone or
// another one, no OpenGL. Exit 2 (3 for terrain of another plan), one sentence with place and remedy, and nothing lost or left.
#include "tests/support/cli_run.h"
#include "tests/support/faults.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp::test;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");

struct Command {
  const char* name;
  QStringList arguments;  // OUT stands for the file to be written, PLAN for the bundled plan
  const char* output;
};

QStringList quickPlan(const QString& plan) {
  return {"plan", kMaps + "mountain-n5.vpm", "-o", plan, "--headings", "4", "--step", "100", "--roadmap-samples", "800"};
}

QList<Command> writingCommands() {
  return {
      {"plan", quickPlan("OUT"), "tour.vpp"},
      {"export", {"export", "PLAN", "--format", "fms", "-o", "OUT"}, "tour.fms"},
      {"export through GDAL", {"export", "PLAN", "--format", "gpkg", "-o", "OUT"}, "tour.gpkg"},
      {"render map", {"render", "PLAN", "--view", "map", "--width", "300", "--height", "200", "-o", "OUT"}, "map.png"},
      {"brief", {"brief", "PLAN", "-o", "OUT"}, "tour.pdf"},
      {"safe altitude raster", {"safe-altitude", "PLAN", "--cell", "500", "--courses", "4", "-o", "OUT"}, "safe.tif"},
      {"new mission",
       {"new-mission", "--terrain", kMaps + "alpine.tif", "--airports", kMaps + "alpine-airports.csv", "--runways", kMaps + "alpine-runways.csv",
        "--target", "46.56,-27.14", "--replace", "-o", "OUT"},
       "new.vpm"},
  };
}

}  // namespace

class TestCliFaults : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QString plan_;

  [[nodiscard]] QStringList filledIn(QStringList arguments, const QString& output) const {
    return arguments.replaceInStrings(QStringLiteral("OUT"), output).replaceInStrings(QStringLiteral("PLAN"), plan_);
  }
  /// A plan with its terrain, in a folder of its own.
  [[nodiscard]] QString copyOfPlan(const char* name) const {
    const QString place = folder_.filePath(QLatin1String(name));
    QDir().mkpath(place);
    QFile::copy(plan_, place + "/tour.vpp");
    QFile::copy(kMaps + "mountain.tif", place + "/mountain.tif");
    return place;
  }
  static void sentence(const CliResult& result, int status, const QList<QByteArray>& words) {
    QVERIFY2(!result.crashed && result.status == status, QByteArray::number(result.status) + ": " + result.err + result.out);
    QVERIFY2(result.err.trimmed().count('\n') == 0, result.err);
    for (const QByteArray& word : words) {
      QVERIFY2(result.err.contains(word), result.err + " lacks " + word);
    }
  }

private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    QFile::copy(kMaps + "mountain.tif", folder_.filePath("mountain.tif"));
    QFile::copy(kMaps + "mountain-n5.vpm", folder_.filePath("mountain-n5.vpm"));
    plan_ = folder_.filePath("tour.vpp");
    const CliResult planned = runCli(quickPlan(plan_).replaceInStrings(kMaps, folder_.path() + '/'));
    QVERIFY2(planned.status == 0, planned.err + planned.out);
  }

  void output_underAFullDisk_saysSoAndLosesNothing_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("output");
    for (const Command& command : writingCommands()) {
      QTest::newRow(command.name) << command.arguments << QString(command.output);
    }
  }

  void output_underAFullDisk_saysSoAndLosesNothing() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, output);
    SmallDisk disk(folder_.filePath("full"), 256);
    QVERIFY(writeAll(disk.path(output), "what was there"));
    disk.fill();
    const auto before = contentsOf(disk.folder());
    const CliResult result = runCli(filledIn(arguments, disk.path(output)));
    const auto after = contentsOf(disk.folder());
    sentence(result, 2, {output.toUtf8(), disk.fullWords()});
    QCOMPARE(after.keys(), before.keys());
    QVERIFY(after == before);
    disk.free();
    const CliResult again = runCli(filledIn(arguments, folder_.filePath("free-" + output)));
    QVERIFY2(again.status == 0, again.err);  // the same command is right where there is room
  }

  void severalExports_ofWhichOneFindsNoRoom_leaveWhatWasThere() {
    SmallDisk disk(folder_.filePath("nearly"), 256);
    QVERIFY(writeAll(disk.path("tour-gpx.gpx"), "what was there"));
    disk.fill();
    const auto before = contentsOf(disk.folder());
    const CliResult result = runCli({"export", plan_, "-f", "fms,gpx,kml", "--folder", disk.folder(), "--pattern", "tour-{format}"});
    const auto after = contentsOf(disk.folder());
    disk.free();
    sentence(result, 2, {disk.fullWords()});
    QVERIFY(after == before);
  }

  void output_inAReadOnlyFolder_saysSoAndLosesNothing_data() { output_underAFullDisk_saysSoAndLosesNothing_data(); }

  void output_inAReadOnlyFolder_saysSoAndLosesNothing() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, output);
    SmallDisk disk(folder_.filePath("readonly"), 256);
    QVERIFY(writeAll(disk.path("mine"), "what was there"));
    disk.makeReadOnly();
    const auto before = contentsOf(disk.folder());
    const CliResult result = runCli(filledIn(arguments, disk.path(output)));
    sentence(result, 2, {output.toUtf8(), disk.readOnlyWords(), "choose another folder"});
    QVERIFY(contentsOf(disk.folder()) == before);
  }

  void output_withoutPermission_saysSo() {
    if (::geteuid() != 0) {
      QSKIP("others than root have had this in the rows above");
    }
    const QString place = folder_.filePath("of-root");
    QVERIFY(QDir().mkpath(place));
    QFile::setPermissions(folder_.path(), QFile::Permissions(0x7755));
    QProcess process;
    process.start(QStringLiteral("setpriv"), {"--reuid=65534", "--regid=65534", "--clear-groups", VOLPLANE_BIN_DIR "/volplane-cli", "export", plan_,
                                              "--format", "fms", "-o", place + "/tour.fms"});
    QVERIFY(process.waitForFinished(60'000));
    const CliResult result{process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError(), false};
    sentence(result, 2, {"tour.fms", "there is no permission to write there"});
    QVERIFY(contentsOf(place).isEmpty());
  }

  void results_thatCannotBePrinted_areNotDone() {
    for (const QStringList& arguments : {QStringList{"info", plan_}, QStringList{"--json", "verify", plan_}}) {
      QProcess process;
      process.setStandardOutputFile(QStringLiteral("/dev/full"));
      process.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane-cli"), arguments);
      QVERIFY(process.waitForFinished(60'000));
      const CliResult result{process.exitCode(), {}, process.readAllStandardError(), process.exitStatus() == QProcess::CrashExit};
      sentence(result, 2, {"the results cannot be written", "the disk is full"});
    }
  }

  void terrain_replacedByAnother_failsVerificationAndExport() {
    const QString place = copyOfPlan("replaced");
    QFile terrain(place + "/mountain.tif");
    QVERIFY(terrain.open(QIODevice::Append));
    terrain.write("x");  // still the same heights to a reader, but not the file that the plan names
    terrain.close();
    const CliResult verified = runCli({"verify", place + "/tour.vpp"});
    QCOMPARE(verified.status, 3);
    QVERIFY2((verified.out + verified.err).contains("is not the terrain that the plan was made with"), verified.out + verified.err);
    const CliResult exported = runCli({"export", place + "/tour.vpp", "--format", "fms", "-o", place + "/tour.fms"});
    QCOMPARE(exported.status, 3);
    QVERIFY2((exported.out + exported.err).contains("is not the terrain that the plan was made with"), exported.out + exported.err);
    QVERIFY(!QFile::exists(place + "/tour.fms"));
    const CliResult brief = runCli({"brief", place + "/tour.vpp", "-o", place + "/tour.pdf"});
    QVERIFY2(brief.status == 3, QByteArray::number(brief.status) + brief.err + brief.out);
    QVERIFY(!QFile::exists(place + "/tour.pdf"));
  }

  void terrain_gone_isNamed() {
    const QString place = copyOfPlan("gone");
    QVERIFY(QFile::remove(place + "/mountain.tif"));
    sentence(runCli({"verify", place + "/tour.vpp"}), 2, {"mountain.tif", "there is no such file", "needs the terrain it was made with"});
    sentence(runCli({"export", place + "/tour.vpp", "--format", "fms", "-o", place + "/tour.fms"}), 2, {"mountain.tif"});
    QVERIFY(!QFile::exists(place + "/tour.fms"));
  }

  void sceneWithoutOpenGl_isRefusedWithTheReason_otherViewsAreDrawn() {
    qputenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent");
    const CliResult scene = runCli({"render", plan_, "--view", "3d", "-o", folder_.filePath("scene.png")});
    const CliResult map = runCli({"render", plan_, "--view", "map", "-o", folder_.filePath("map.png")});
    qunsetenv("__EGL_VENDOR_LIBRARY_DIRS");
    sentence(scene, 2, {"install the OpenGL driver"});
    QVERIFY(!QFile::exists(folder_.filePath("scene.png")));
    QCOMPARE(map.status, 0);
  }

  void planOfANewerProgram_isRefusedAndStaysAsItIs() {
    QByteArray newer = readAll(plan_);
    QVERIFY(newer.contains("\"version\": 1"));
    newer.replace("\"version\": 1", "\"version\": 99");
    QVERIFY(writeAll(folder_.filePath("newer.vpp"), newer));
    sentence(runCli({"verify", folder_.filePath("newer.vpp")}), 2, {"newer.vpp", "written by a newer Volplane", "update Volplane"});
    QVERIFY(readAll(folder_.filePath("newer.vpp")) == newer);
  }
};

QTEST_GUILESS_MAIN(TestCliFaults)
#include "tst_cli_faults.moc"
