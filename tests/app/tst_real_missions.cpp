// Real terrain and airfields end in verified plans. Needs the data folder beside the checkout (or VOLPLANE_DATA).
#include "tests/support/cli_run.h"
#include "tests/support/data_folder.h"
#include "tests/support/real_missions.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

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
    QTest::addColumn<QByteArray>("mission");
    for (const RealMission& mission : realMissions(data_)) {
      QTest::newRow(mission.name) << mission.text();
    }
  }

  void realTerrain_planned_isCertified() {
    QFETCH(QByteArray, mission);
    QTemporaryDir folder;
    const QString missionFile = folder.filePath("mission.vpm");
    const QString plan = folder.filePath("plan.vpp");
    QVERIFY(writeAll(missionFile, mission));
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
        {"targets", realTargets({{34.30, -118.10}}, 100.0)}};
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
