// What a new user does, from an empty folder to an exported plan in a real area, with the servers simulated on 127.0.0.1.
// Needs the data folder beside the checkout (or VOLPLANE_DATA).
#include "core/fetch/tile.h"
#include "core/formats/text_file.h"
#include "tests/support/cli_run.h"
#include "tests/support/data_folder.h"
#include "tests/support/file_server.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp::test;

namespace {

std::string bytesOf(const QString& path) {
  return *vp::formats::readFile(path.toStdString());  // unpacks .gz
}

QJsonObject jsonOf(const CliResult& result) {
  return QJsonDocument::fromJson(result.out).object();
}

QByteArray said(const CliResult& result) {
  return result.out + result.err;
}

}  // namespace

class TestRealArea : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    const QString data = dataFolder();
    if (data.isEmpty()) {
      QSKIP("the folder with real terrain is not here; set VOLPLANE_DATA to it");
    }
    const std::string name = vp::fetch::nameOf({46, 8});
    bucket_.put("/" + name + "/" + name + ".tif", bytesOf(data + "/dem/swiss_alps_N46E008_srtm3_voids.tif"));
    bucket_.put("/tileList.txt", name + "\n" + vp::fetch::nameOf({46, 7}) + "\n");
    airfields_.put("/airports.csv", bytesOf(data + "/airports/ourairports_airports.csv.gz"));
    airfields_.put("/runways.csv", bytesOf(data + "/airports/ourairports_runways.csv.gz"));
    for (const char* proxy : {"http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"}) {
      qunsetenv(proxy);
    }
    qputenv("XDG_CACHE_HOME", folder_.filePath("cache").toLocal8Bit());
    qputenv("VOLPLANE_TERRAIN_URL", bucket_.address().c_str());
    qputenv("VOLPLANE_AIRFIELDS_URL", airfields_.address().c_str());
    QVERIFY(QDir(folder_.path()).mkdir("work"));
    work_ = folder_.filePath("work");
  }

  void wholeJob_fromAnEmptyFolder_endsInAnExportedPlan() {
    const CliResult early = run({"fetch-terrain", "--around", "LSPG", "--radius", "9km"});
    QCOMPARE(early.status, 2);
    QVERIFY2(early.err.contains("run `volplane-cli fetch-airfields` first"), early.err);

    const CliResult airfields = run({"fetch-airfields"});
    QVERIFY2(airfields.status == 0, said(airfields));
    QVERIFY2(airfields.out.contains("landing sites"), airfields.out);

    const CliResult dry = run({"--json", "fetch-terrain", "--around", "LSPG", "--radius", "9km", "--dry-run"});
    QVERIFY2(dry.status == 0, said(dry));
    QVERIFY(jsonOf(dry)["bytesToFetch"].toDouble() > 1e6);
    QCOMPARE(QDir(work_).entryList(QDir::Files).size(), 0);

    const CliResult terrain = run({"fetch-terrain", "--around", "LSPG", "--radius", "9km", "-o", "kaegiswil.tif"});
    QVERIFY2(terrain.status == 0, said(terrain));
    QVERIFY2(terrain.out.contains("next: volplane-cli new-mission --terrain kaegiswil.tif"), terrain.out);

    const CliResult mission = run({"new-mission", "--terrain", "kaegiswil.tif", "--target", "46.935,8.30,Stans", "--target", "46.88,8.24", "--target",
                                   "46.87,8.28,Melchtal,250", "-o", "survey.vpm"});
    QVERIFY2(mission.status == 0, said(mission));
    QVERIFY2(mission.out.contains("3 targets"), mission.out);

    const CliResult plan = run({"plan", "survey.vpm", "-o", "survey.vpp", "--step", "100"});
    QVERIFY2(plan.status == 0, said(plan));
    const CliResult verified = run({"verify", "survey.vpp"});
    QVERIFY2(verified.status == 0, said(verified));
    const CliResult exported = run({"export", "survey.vpp", "--format", "fms", "-o", "survey.fms"});
    QVERIFY2(exported.status == 0, said(exported));
    QVERIFY(readAll(work_ + "/survey.fms").contains("1100 Version"));
    const CliResult map = run({"--json", "safe-altitude", "survey.vpp", "--cell", "100", "-o", "survey-safe.kml"});
    QVERIFY2(map.status == 0, said(map));
    QVERIFY2(jsonOf(map)["contours"].toInt() > 3 && jsonOf(map)["knownShare"].toDouble() > 0.3, map.out);
  }

  void again_withoutNetwork_worksFromTheCache() {
    bucket_.stop();
    airfields_.stop();
    const CliResult terrain = run({"fetch-terrain", "--around", "LSPG", "--radius", "7km", "-o", "again.tif"});
    QVERIFY2(terrain.status == 0, said(terrain));
    QVERIFY2(terrain.out.contains("1 on this machine, 0 to fetch"), terrain.out);
    const CliResult elsewhere = run({"fetch-terrain", "--bbox", "7.2,46.3,7.8,46.6", "-o", "elsewhere.tif"});
    QCOMPARE(elsewhere.status, 2);
    QVERIFY2(elsewhere.err.contains("no server answers there"), elsewhere.err);
    QVERIFY(!QFile::exists(work_ + "/elsewhere.tif"));
  }

private:
  [[nodiscard]] CliResult run(const QStringList& arguments) const { return runCli(arguments, work_); }

  FileServer bucket_;
  FileServer airfields_;
  QTemporaryDir folder_;
  QString work_;
};

QTEST_GUILESS_MAIN(TestRealArea)
#include "tst_real_area.moc"
