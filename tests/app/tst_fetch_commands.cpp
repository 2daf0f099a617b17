// fetch-terrain, fetch-airfields and new-mission as a user runs them: what is refused, and how.
#include "tests/support/cli_run.h"
#include "tests/support/file_server.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp::test;

class TestFetchCommands : public QObject {
  Q_OBJECT

private slots:
  void init() {
    for (const char* name : {"http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY", "VOLPLANE_TERRAIN_URL", "VOLPLANE_AIRFIELDS_URL"}) {
      qunsetenv(name);
    }
    folder_ = std::make_unique<QTemporaryDir>();
    qputenv("XDG_CACHE_HOME", folder_->filePath("cache").toLocal8Bit());
    qputenv("VOLPLANE_TERRAIN_URL", server_.address().c_str());
    qputenv("VOLPLANE_AIRFIELDS_URL", server_.address().c_str());
  }

  void badInput_isRefusedWithASentence_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("sentence");
    const auto terrain = [](const QStringList& more) { return QStringList{"fetch-terrain"} + more; };
    const QStringList mission{"new-mission", "--terrain", VOLPLANE_SOURCE_DIR "/maps/alpine.tif", "-o", "m.vpm"};
    QTest::newRow("no area") << terrain({}) << QByteArray("[--bbox,--around] is required");
    QTest::newRow("two areas") << terrain({"--bbox", "8,46,9,47", "--around", "46,8"}) << QByteArray("2 were given");
    QTest::newRow("three numbers") << terrain({"--bbox", "8,46,9"}) << QByteArray("WEST,SOUTH,EAST,NORTH");
    QTest::newRow("the world") << terrain({"--bbox", "-180,-90,180,90"}) << QByteArray("at most 20");
    QTest::newRow("exchanged") << terrain({"--bbox", "9,46,8,47"}) << QByteArray("west lies east of east");
    QTest::newRow("not on earth") << terrain({"--around", "146.5,8"}) << QByteArray("is not on earth");
    QTest::newRow("in the far south, but a huge radius") << terrain({"--around", "-35.3,149.2", "--radius", "9000km"}) << QByteArray("0.1 to 300 km");
    QTest::newRow("no distance") << terrain({"--around", "46.5,8.5", "--radius", "far"}) << QByteArray("is no distance");
    QTest::newRow("no airfields to look in") << terrain({"--around", "LSZS"}) << QByteArray("run `volplane-cli fetch-airfields` first");
    QTest::newRow("no address") << terrain({"--bbox", "8,46,9,47", "--base-url", "file:///etc"}) << QByteArray("no address of a server");
    QTest::newRow("nothing there") << terrain({"--bbox", "8,46,9,47"}) << QByteArray("the address is wrong");
    QTest::newRow("no airfield tables there") << QStringList{"fetch-airfields"} << QByteArray("the server has no such file");
    QTest::newRow("mission without target") << mission << QByteArray("--target");
    QTest::newRow("mission without airfields") << mission + QStringList{"--target", "46,8"} << QByteArray("no airfields are here yet");
    QTest::newRow("no target") << mission + QStringList{"--airports", "a.csv", "--target", "north"} << QByteArray("this is no target");
    QTest::newRow("target not on earth") << mission + QStringList{"--airports", "a.csv", "--target", "95,8"} << QByteArray("is not on earth");
    const QStringList map{"safe-altitude", VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm", "-o"};
    QTest::newRow("map of no kind") << map + QStringList{"map.txt"} << QByteArray("the name says what to write");
    QTest::newRow("map without interval") << map + QStringList{"map.kml", "--contours", "0m"} << QByteArray("is no distance");
    QTest::newRow("map of two kinds") << map + QStringList{"map.tif", "--worst", "--best"} << QByteArray("excludes");
    QTest::newRow("map into no folder") << map + QStringList{"no/map.tif", "--worst", "--cell", "500"} << QByteArray("no such folder");
    QTest::newRow("map of no mission") << QStringList{"safe-altitude", "none.vpm", "-o", "map.tif"} << QByteArray("none.vpm");
    QTest::newRow("no terrain file") << QStringList{"new-mission", "--terrain", "none.tif", "-o", "m.vpm", "--airports", "a.cup", "--target", "46,8"}
                                     << QByteArray("none.tif");
  }
  void badInput_isRefusedWithASentence() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, sentence);
    const CliResult result = runCli(arguments, folder_->path());
    QVERIFY(!result.crashed);
    QCOMPARE(result.status, 2);
    QVERIFY2((result.err + result.out).contains(sentence), result.err + result.out);
    QVERIFY(!QFile::exists(folder_->filePath("m.vpm")));
  }

  void failure_asJson_isAnObject() {
    const CliResult result = runCli({"--json", "fetch-terrain", "--bbox", "8,46,9,47"}, folder_->path());
    QCOMPARE(result.status, 2);
    const QJsonObject object = QJsonDocument::fromJson(result.out).object();
    QVERIFY2(object["error"].toString().contains("the address is wrong"), result.out);
    QCOMPARE(object["exit"].toInt(), 2);
  }

  void safeAltitude_ofAMission_isWritten_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("bands");
    QTest::newRow("values for all courses") << "map.tif" << QStringList{"--courses", "4"} << 5;
    QTest::newRow("values for one course") << "map.tif" << QStringList{"--heading", "240"} << 1;
    QTest::newRow("contours for the best course") << "map.kml" << QStringList{"--best"} << 1;
    QTest::newRow("contours for any course") << "map.gpkg" << QStringList{"--worst", "--contours", "200m"} << 1;
  }
  void safeAltitude_ofAMission_isWritten() {
    QFETCH(QString, file);
    QFETCH(QStringList, options);
    const CliResult result = runCli(
        QStringList{"--json", "safe-altitude", VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm", "--cell", "150", "-o", file} + options, folder_->path());
    QVERIFY2(result.status == 0, result.err);
    const QJsonObject object = QJsonDocument::fromJson(result.out).object();
    QTEST(object["bands"].toInt(), "bands");
    QCOMPARE(object["contours"].toInt() > 0, !file.endsWith(".tif"));
    QVERIFY2(object["knownShare"].toDouble() > 0.5 && object["highest_m"].toDouble() > object["lowest_m"].toDouble(), result.out);
    QVERIFY(QFile::exists(folder_->filePath(file)));
  }

  void newMission_overAnExistingFile_isRefused() {
    QVERIFY(writeAll(folder_->filePath("m.vpm"), "mine"));
    const CliResult result = runCli({"new-mission", "--terrain", "t.tif", "--target", "46,8", "-o", "m.vpm"}, folder_->path());
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("there already"), result.err);
    QCOMPARE(readAll(folder_->filePath("m.vpm")), QByteArray("mine"));
  }

private:
  FileServer server_;
  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestFetchCommands)
#include "tst_fetch_commands.moc"
