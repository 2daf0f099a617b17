// Airfield files as they are published.
#include "core/formats/airfields.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace vp;
using namespace vp::formats;

namespace {

const mission::LandingSite* find(const AirfieldReport& report, const std::string& id) {
  const auto site = std::find_if(report.sites.begin(), report.sites.end(), [&](const mission::LandingSite& s) { return s.id == id; });
  return site == report.sites.end() ? nullptr : &*site;
}

/// What must hold of every site, whatever the file says; "" if it does.
std::string fault(const AirfieldReport& report) {
  std::map<std::string, int> ids;
  for (const mission::LandingSite& site : report.sites) {
    const double course = site.landingCourse.degrees();
    const bool sane = std::abs(site.touchdown.latitude_deg) <= 90.0 && std::abs(site.touchdown.longitude_deg) <= 180.0 && course >= 0.0 &&
                      course < 360.0 && site.elevation.metres() > -500.0 && site.elevation.metres() < 6000.0 &&
                      (!site.length || (site.length->si() > 0.0 && site.length->si() < 20000.0));
    if (!sane || ++ids[site.id] > 1 || site.id.empty() || site.surface == mission::Surface::Water) {
      return site.id;
    }
  }
  return {};
}

}  // namespace

class TestAirfieldsRealdata : public QObject {
  Q_OBJECT
  std::string folder_;

private slots:
  void init() {
    const auto data = samples::dataFolder();
    if (!data) {
      QSKIP("the folder of real data is absent");
    }
    folder_ = *data + "/airports/";
  }

  void ourAirports_ofTheWholeWorld_isRead() {
    const auto report = readOurAirports(folder_ + "ourairports_airports.csv.gz", folder_ + "ourairports_runways.csv.gz", {}, {});
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(fault(*report), std::string());
    const auto exact = std::count_if(report->sites.begin(), report->sites.end(), [](const auto& site) { return !site.isApproximate(); });
    const auto unknown =
        std::count_if(report->sites.begin(), report->sites.end(), [](const auto& site) { return site.surface == mission::Surface::Unknown; });
    qInfo("%zu sites, %ld exact, %ld of unknown surface", report->sites.size(), static_cast<long>(exact), static_cast<long>(unknown));
    for (const std::string& note : report->notes) {
      qInfo("%s", note.c_str());
    }
    QVERIFY(report->sites.size() > 55000 && report->sites.size() < 80000);  // two ends of 40,884 runways less closed ones and water
    QVERIFY(exact > 15000);
    QVERIFY(unknown * 20 < static_cast<long>(report->sites.size()));
  }

  void samedan_isWhereItIs() {
    const geo::GeoBox davos{{46.5, 9.6}, {47.1, 10.2}};
    const auto report = readOurAirports(folder_ + "ourairports_alps_43-48N_4.5-13.5E_airports.csv",
                                        folder_ + "ourairports_alps_43-48N_4.5-13.5E_runways.csv", {}, davos);
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    const mission::LandingSite* north = find(*report, "LSZS/03");
    const mission::LandingSite* south = find(*report, "LSZS/21");
    QVERIFY(north != nullptr && south != nullptr);
    // Ends as in the file; 21 has its threshold 360 ft down the runway.
    QVERIFY(geo::geodesicDistance(north->touchdown, {46.526798, 9.878290}).si() < 50.0);
    QVERIFY(geo::geodesicDistance(south->touchdown, {46.541401, 9.889990}).si() < 160.0);
    QVERIFY(std::abs(geo::geodesicDistance(south->touchdown, {46.541401, 9.889990}).si() - 360 * 0.3048) < 0.1);
    QVERIFY(std::abs(north->landingCourse.degrees() - 29.0) < 1.5);
    QVERIFY(std::abs(south->landingCourse.degrees() - 209.0) < 1.5);
    QVERIFY(std::abs(south->elevation.feet() - 5574.0) < 1e-6);
    QVERIFY(std::abs(north->length->si() - 1800.0) < 70.0);
    QCOMPARE(north->surface, mission::Surface::Hard);
    QCOMPARE(fault(*report), std::string());
  }

  void alps_haveHundredsOfSites() {
    const auto report = readOurAirports(folder_ + "ourairports_alps_43-48N_4.5-13.5E_airports.csv",
                                        folder_ + "ourairports_alps_43-48N_4.5-13.5E_runways.csv", {}, {});
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    qInfo("%zu sites", report->sites.size());
    QVERIFY(report->sites.size() > 300 && report->sites.size() < 1500);
    QCOMPARE(fault(*report), std::string());
    const auto other = readOurAirports(folder_ + "ourairports_LI_DC_Flagstaff_Dubuque_BigTujunga_BC_airports.csv",
                                       folder_ + "ourairports_LI_DC_Flagstaff_Dubuque_BigTujunga_BC_runways.csv", {}, {});
    QVERIFY2(other, other ? "" : other.error().message().c_str());
    QCOMPARE(fault(*other), std::string());
  }

  void cupFiles_areRead_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("least");
    QTest::addColumn<int>("most");
    QTest::newRow("CH") << "CH-WPT-National-XCSoar.cup" << 200 << 3000;
    QTest::newRow("FR") << "FR-WPT-National-XCSoar.cup" << 500 << 8000;
    QTest::newRow("US") << "US-WPT-National-XCSoar.cup" << 5000 << 40000;
    QTest::newRow("DE") << "DE-WPT-SchwarzwaldLandeFelder-XCSoar.cup" << 50 << 500;
    QTest::newRow("odd header") << "seeyou_euregio9.cup" << 0 << 100;
    QTest::newRow("tasks") << "../flightplans/seeyou_tasks_GLB-WPT-ProvingGrounds-XCSoar.cup" << 200 << 8000;
    QTest::newRow("2018") << "../flightplans/seeyou_v1_waypoints.cup" << 2 << 4;
    QTest::newRow("2022") << "../flightplans/seeyou_v2_rwwidth_waypoints.cup" << 2 << 4;
  }
  void cupFiles_areRead() {
    QFETCH(QString, file);
    QFETCH(int, least);
    QFETCH(int, most);
    const auto report = readCup(folder_ + file.toStdString(), {}, {});
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    qInfo("%zu sites", report->sites.size());
    for (const std::string& note : report->notes) {
      qInfo("%s", note.c_str());
    }
    QVERIFY(static_cast<int>(report->sites.size()) >= least && static_cast<int>(report->sites.size()) <= most);
    QCOMPARE(fault(*report), std::string());
  }

  void samedan_ofTheCupFile_agreesWithOurAirports() {
    const auto cup = readCup(folder_ + "CH-WPT-National-XCSoar.cup", {}, geo::GeoBox{{46.5, 9.6}, {47.1, 10.2}});
    QVERIFY2(cup, cup ? "" : cup.error().message().c_str());
    const auto site = std::find_if(cup->sites.begin(), cup->sites.end(),
                                   [](const auto& s) { return s.airportIdent == "LSZS" && s.landingCourse.degrees() < 90.0; });
    QVERIFY(site != cup->sites.end());
    QVERIFY(geo::geodesicDistance(site->touchdown, {46.526798, 9.878290}).si() < 500.0);
    QVERIFY(std::abs(site->elevation.metres() - 1707.0) < 15.0);
  }
};

QTEST_APPLESS_MAIN(TestAirfieldsRealdata)
#include "tst_airfields_realdata.moc"
