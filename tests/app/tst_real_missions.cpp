// Real terrain and airfields end in verified plans. Needs the data folder beside the checkout (or VOLPLANE_DATA).
#include "tests/support/cli_run.h"
#include "tests/support/data_folder.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

namespace {

struct Place {
  double latitude;
  double longitude;
};

QJsonArray targets(const QList<Place>& places, double height) {
  QJsonArray list;
  for (const Place& place : places) {
    list.append(QJsonObject{
        {"name", QString("T%1").arg(list.size() + 1)}, {"latitude_deg", place.latitude}, {"longitude_deg", place.longitude}, {"height_m", height}});
  }
  return list;
}

}  // namespace

class TestRealMissions : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    data_ = dataFolder();
    if (data_.isEmpty()) {
      QSKIP("the folder with real terrain is not here; set VOLPLANE_DATA to it");
    }
  }

  void realTerrain_planned_isCertified_data() {
    QTest::addColumn<QStringList>("terrain");
    QTest::addColumn<QJsonObject>("airfields");
    QTest::addColumn<QJsonArray>("targets");
    const auto ours = [this](const QString& stem) {
      return QJsonObject{{"airports", data_ + "/airports/" + stem + "_airports.csv"}, {"runways", data_ + "/airports/" + stem + "_runways.csv"}};
    };
    const QJsonObject world{{"airports", data_ + "/airports/ourairports_airports.csv.gz"},
                            {"runways", data_ + "/airports/ourairports_runways.csv.gz"}};
    QTest::newRow("Swiss Alps, ten targets over the massif, voids")
        << QStringList{data_ + "/dem/swiss_alps_N46E008_srtm3_voids.tif"} << ours("ourairports_alps_43-48N_4.5-13.5E")
        << targets({{46.80, 8.20},
                    {46.75, 8.75},
                    {46.60, 8.50},
                    {46.50, 8.15},
                    {46.45, 8.60},
                    {46.30, 8.30},
                    {46.25, 8.80},
                    {46.15, 8.55},
                    {46.35, 8.05},
                    {46.85, 8.40}},
                   200.0);
    QTest::newRow("Davos, Swiss landables") << QStringList{data_ + "/dem/davos_srtm1_wgs84.tif"}
                                            << QJsonObject{{"airports", data_ + "/airports/CH-WPT-National-XCSoar.cup"}}
                                            << targets({{46.80, 9.83}, {46.70, 9.75}, {46.62, 9.95}, {46.95, 9.70}, {46.85, 10.05}}, 200.0);
    QTest::newRow("Canberra") << QStringList{data_ + "/dem/canberra_S36E149_srtm3.tif"} << world
                              << targets({{-35.35, 149.10}, {-35.55, 149.15}, {-35.45, 148.95 + 0.10}, {-35.25, 149.35}, {-35.60, 149.45}}, 200.0);
    QTest::newRow("British Columbia, two tiles as one")
        << QStringList{data_ + "/dem/bc_coast_N49W123_srtm3_voids.tif", data_ + "/dem/bc_coast_N49W124_srtm3_voids.tif"} << world
        << targets({{49.15, -122.70}, {49.25, -122.95}, {49.20, -123.05}, {49.30, -122.60}, {49.10, -122.40}}, 250.0);
  }

  void realTerrain_planned_isCertified() {
    QFETCH(QStringList, terrain);
    QFETCH(QJsonObject, airfields);
    QFETCH(QJsonArray, targets);
    QTemporaryDir folder;
    QJsonObject mission{{"format", "volplane-mission"},
                        {"version", 1},
                        {"name", QTest::currentDataTag()},
                        {"terrain", QJsonArray::fromStringList(terrain)},
                        {"airfields", QJsonArray{airfields}},
                        {"aircraft", "cessna172-elasp"},
                        {"targets", targets},
                        {"planner", QJsonObject{{"step_m", 100}, {"headings", 8}}}};
    const QString missionFile = folder.filePath("mission.vpm");
    const QString plan = folder.filePath("plan.vpp");
    QVERIFY(writeAll(missionFile, QJsonDocument(mission).toJson()));
    const CliResult planned = runCli({"plan", missionFile, "-o", plan, "--threads", "2"});
    QVERIFY2(planned.status == 0, planned.err + planned.out);
    const CliResult verified = runCli({"verify", plan});
    QVERIFY2(verified.status == 0, verified.out + verified.err);
    const CliResult exported = runCli({"--json", "export", plan, "--folder", folder.path(), "--pattern", "x-{format}", "-f",
                                       "fms,fms3,fpl,wpt,pln,lnmpln,plan,cup,gpx,kml,kmz,fgfp,geojson,gpkg,csv"});
    QVERIFY2(exported.status == 0, exported.out + exported.err);
    const QJsonObject written = QJsonDocument::fromJson(exported.out).object();
    QVERIFY(written["verified"].toBool() && written["files"].toArray().size() >= 15);
    for (const QJsonValue& route : written["routes"].toArray()) {
      qInfo().noquote() << QJsonDocument(QJsonObject{{"lateral_m", route["lateral_m"]},
                                                     {"above_m", route["above_m"]},
                                                     {"visit_m", route["visit_m"]},
                                                     {"waypoints", route["waypoints"]}})
                               .toJson(QJsonDocument::Compact);
    }
    qInfo().noquote() << planned.out.left(planned.out.indexOf("VERIFIED"));
  }

  void terrainWithoutAirfield_saysSo() {
    QTemporaryDir folder;
    const QJsonObject mission{
        {"format", "volplane-mission"},
        {"version", 1},
        {"terrain", QJsonArray{data_ + "/dem/bigtujunga_srtm30m_utm11n.tif"}},
        {"airfields", QJsonArray{QJsonObject{{"airports", data_ + "/airports/ourairports_LI_DC_Flagstaff_Dubuque_BigTujunga_BC_airports.csv"},
                                             {"runways", data_ + "/airports/ourairports_LI_DC_Flagstaff_Dubuque_BigTujunga_BC_runways.csv"}}}},
        {"aircraft", "cessna172-elasp"},
        {"targets", targets({{34.30, -118.10}}, 100.0)}};
    QVERIFY(writeAll(folder.filePath("m.vpm"), QJsonDocument(mission).toJson()));
    const CliResult result = runCli({"plan", folder.filePath("m.vpm"), "-o", folder.filePath("p.vpp")});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("landing site") && result.err.contains("bigtujunga"), result.err);
    QVERIFY(!QFile::exists(folder.filePath("p.vpp")));
  }

private:
  QString data_;
};

QTEST_GUILESS_MAIN(TestRealMissions)
#include "tst_real_missions.moc"
