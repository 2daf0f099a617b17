// Airfields of X-Plane and of one's own tables and GeoJSON.
#include "core/formats/airfields.h"
#include "core/formats/runway_names.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

const mission::LandingSite* find(const AirfieldReport& report, const std::string& id) {
  const auto site = std::find_if(report.sites.begin(), report.sites.end(), [&](const mission::LandingSite& s) { return s.id == id; });
  return site == report.sites.end() ? nullptr : &*site;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) {
    all += line + "\n";
  }
  return all;
}

const std::string kApt =
    "I\n1100 Version - test\n\n"
    "1     3799 0 1 E46  02 Ranch\n"
    "100   30.48   4   0 0.25 0 2 0 15   29.88083567 -103.70108085  100.00    0.00 1  0 0 0 33   29.86895821 -103.69317249    0.00    0.00 1  0 0 0\n"
    "102 H1   29.02736300 -103.37448800 296.45   14.94   14.94   1 0   0 0.25 1\n"
    "100   30.48   4   0 0.25 0 0 0 05   29.87181142\n"
    "1302 icao_code KE46\n"
    "16    10 0 0 SEA1 Water base\n"
    "101 30 0 09 29.5 -103.7 27 29.5 -103.69\n"
    "1    500 0 0 XOLD [X] Old field\n"
    "100 20 3 0 0.25 0 0 0 09 29.6 -103.7 0 0 1 0 0 0 27 29.6 -103.69 0 0 1 0 0 0\n"
    "100 20 3 0 0.25 0 0 0 09 129.6 -103.7 0 0 1 0 0 0 27 29.6 -103.69 0 0 1 0 0 0\n"
    "99\n";

}  // namespace

class TestOwnAirfields : public QObject {
  Q_OBJECT
  Folder folder_;

  AirfieldReport read(const std::string& path, const mission::SiteFilter& filter = {}) {
    const Result<AirfieldReport> report = readAirfields({path, ""}, folder_.path(), filter, {});
    if (!report) {
      qWarning("%s", report.error().message().c_str());
      return {};
    }
    return *report;
  }

private slots:
  void aptDat_givesBothEndsWithThreshold() {
    folder_.write("any name.txt", kApt);
    const AirfieldReport report = read("any name.txt");
    QCOMPARE(report.sites.size(), std::size_t{2});
    const mission::LandingSite* low = find(report, "KE46/15");
    QVERIFY(low != nullptr && find(report, "KE46/33") != nullptr);
    QVERIFY(std::abs(geo::geodesicDistance(low->touchdown, {29.88083567, -103.70108085}).si() - 100.0) < 0.01);  // displaced threshold in metres
    QVERIFY(std::abs(low->length->si() + 100.0 - find(report, "KE46/33")->length->si()) < 0.01);
    QVERIFY(std::abs(low->landingCourse.degrees() - 150.0) < 3.0);
    QVERIFY(std::abs(low->elevation.feet() - 3799.0) < 1e-9);
    QCOMPARE(low->airportName, std::string("02 Ranch"));
    QCOMPARE(low->surface, mission::Surface::Dirt);
    QVERIFY(low->lighted);
    VP_CONTAINS(joined(report.notes), {"1 left out: helipad (E46/H1)", "row of a runway cut short (E46 in line 7)", "2 left out: water",
                                       "2 left out: closed", "makes no sense (XOLD in line 13)"});
  }

  void aptDat_withWaterAndClosed_givesThoseToo() {
    folder_.write("apt.dat", kApt);
    mission::SiteFilter filter;
    filter.water = filter.closed = true;
    const AirfieldReport report = read("apt.dat", filter);
    QCOMPARE(report.sites.size(), std::size_t{6});
    QCOMPARE(find(report, "SEA1/09")->surface, mission::Surface::Water);
    QCOMPARE(find(report, "XOLD/27")->surface, mission::Surface::Grass);
  }

  void aptDat_ofOtherVersions_isRefused() {
    const auto old = readAptDat(folder_.write("old.dat", "I\n715 Version\n1 0 0 0 AAA A\n"), {}, {});
    QVERIFY(!old);
    VP_CONTAINS(old.error().message(), {"version 715", "850 to 1299", "line 2"});
    const auto cut = readAptDat(folder_.write("cut.dat", "I\n1200 Version\n"), {}, {});
    QVERIFY(!cut);
    VP_CONTAINS(cut.error().message(), {"no airport", "cut.dat"});
  }

  void table_withCourseAndLength_givesBothEnds() {
    folder_.write("mine.csv",
                  "Name;Latitude;Longitude;Course (deg);Length (m);Elevation (ft);Width_m;Surface;Lights\n"
                  "Wiese;46,5;9,75;90;600;1640;25 m;gras;ja\n");
    const AirfieldReport report = read("mine.csv");
    QCOMPARE(report.sites.size(), std::size_t{2});
    const mission::LandingSite& west = report.sites[0];
    QCOMPARE(west.id, std::string("Wiese/09"));
    QCOMPARE(report.sites[1].id, std::string("Wiese/27"));
    QVERIFY(geo::geodesicDistance(west.touchdown, {46.5, 9.75}).si() < 1e-3);
    QVERIFY(std::abs(geo::geodesicDistance(report.sites[1].touchdown, {46.5, 9.75}).si() - 600.0) < 1e-3);
    QVERIFY(std::abs(west.elevation.metres() - 499.872) < 1e-9);
    QCOMPARE(west.width->si(), 25.0);
    QCOMPARE(west.surface, mission::Surface::Grass);
    QVERIFY(west.lighted);
  }

  void table_withBothEnds_isExact() {
    folder_.write(
        "mine.csv",
        "ident,lat,lon,end_lat,end_lon,elevation_m,one_way,displaced_m\nALM,46.5,9.75,46.5,9.76,1200,no,50\nTAL,46.6,9.75,46.6,9.76,1300,yes,\n");
    const AirfieldReport report = read("mine.csv");
    QCOMPARE(report.sites.size(), std::size_t{3});
    QCOMPARE(report.sites[2].airportIdent, std::string("TAL"));
    QVERIFY(std::abs(report.sites[0].landingCourse.degrees() - 90.0) < 0.01);
    QVERIFY(std::abs(geo::geodesicDistance(report.sites[0].touchdown, {46.5, 9.75}).si() - 50.0) < 0.01);
  }

  void table_withNumberOnly_addsTheVariation() {
    folder_.write("mine.csv", "ident,lat,lon,runway,length_m\nCYX,49.02,-122.37,07,800\n");
    const AirfieldReport report = read("mine.csv");
    QCOMPARE(report.sites.size(), std::size_t{2});
    // Abbotsford has 15 to 16 degrees east; true = magnetic + variation
    QVERIFY(std::abs(report.sites[0].landingCourse.degrees() - 85.5) < 1.0);
    VP_CONTAINS(joined(report.sites[0].approximations), {"magnetic variation of 1", "degrees east", "terrain's is used"});
    QCOMPARE(report.sites[1].runwayIdent, std::string("25"));
    QVERIFY(report.sites[0].elevationFromTerrain);
  }

  void table_withRowsThatMakeNoSense_namesThem() {
    folder_.write("mine.csv",
                  "ident,lat,lon,course,length\nA,91,9,90,500\nB,46,9,nan,500\nC,46,9,,500\nD,46,9,90,-4\nE,46,9,90,500\nF,46\nG,inf,9,90,500\n");
    const AirfieldReport report = read("mine.csv");
    QCOMPARE(report.sites.size(), std::size_t{2});
    VP_CONTAINS(joined(report.notes), {"3 left out: latitude and longitude are no place in degrees (row 2, row 7, row 8)",
                                       "1 left out: course is no number of 0 to 360 degrees (row 3)", "nor a runway number (row 4)",
                                       "1 left out: length makes no sense (row 5)"});
  }

  void geoJson_ofLinesAndPoints_isRead() {
    folder_.write("mine.geojson", R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"airport":"ALP","runway":"09","surface":"asphalt","elevation_m":900},
       "geometry":{"type":"LineString","coordinates":[[9.75,46.5],[9.76,46.5]]}},
      {"type":"Feature","properties":{"name":"Kurz","course_deg":180,"one_way":true,"length_m":300},
       "geometry":{"type":"Point","coordinates":[9.8,46.6,1234]}},
      {"type":"Feature","properties":{"name":"nowhere"},"geometry":null},
      {"type":"Feature","properties":{"name":"area"},"geometry":{"type":"Polygon","coordinates":[[[9,46],[9.1,46],[9,46.1],[9,46]]]}}
    ]})");
    const AirfieldReport report = read("mine.geojson");
    QCOMPARE(report.sites.size(), std::size_t{3});
    QVERIFY(find(report, "ALP/27") != nullptr && find(report, "ALP/09") != nullptr);
    QVERIFY(!find(report, "ALP/09")->isApproximate() || find(report, "ALP/09")->approximations.size() == 1);
    QCOMPARE(report.sites[2].airportIdent, std::string("Kurz"));
    VP_CONTAINS(joined(report.notes), {"no geometry (line 6)", "neither a point nor a line (line 7)"});
  }

  void contentCounts_notTheName() {
    QCOMPARE(airfieldFileOf(folder_.write("a.txt", kApt)), AirfieldFile::AptDat);
    QCOMPARE(airfieldFileOf(folder_.write("b.dat", "name,code,country,lat,lon,elev,style\n")), AirfieldFile::SeeYou);
    QCOMPARE(airfieldFileOf(folder_.write("c.csv", "latitude,longitude,course\n")), AirfieldFile::OwnTable);
    QCOMPARE(airfieldFileOf(folder_.write("d.csv", "name,latitude,longitude\n")), AirfieldFile::None);
    QCOMPARE(airfieldFileOf(folder_.write("e.json", "{\"type\":\"Feature\",\"properties\":{\"Runway\":\"09\"}}")), AirfieldFile::GeoJson);
    QCOMPARE(airfieldFileOf(folder_.write("f.json", "{\"type\":\"Feature\",\"properties\":{\"name\":\"09\"}}")), AirfieldFile::None);
    QCOMPARE(airfieldFileOf(folder_.write("g.bin", std::string("I\n1100 Version\0", 15))), AirfieldFile::None);
    QCOMPARE(airfieldFileOf(folder_.path("missing")), AirfieldFile::None);
    const auto nothing = readAirfields({"d.csv", ""}, folder_.path(), {}, {});
    QVERIFY(!nothing);
    VP_CONTAINS(nothing.error().message(), {"apt.dat", "course_deg", "d.csv"});
  }

  void filter_byWidthSurfaceAndLight_saysWhy() {
    folder_.write("mine.csv",
                  "ident,lat,lon,course,length,width,surface,lighted,one_way\nA,46,9,90,500,10,grass,no,yes\nB,46,9,90,500,30,grass,no,yes\n"
                  "C,46,9,90,500,30,asphalt,no,yes\nD,46,9,90,500,30,asphalt,yes,yes\nE,46,9,90,500,,asphalt,yes,yes\nF,46,9,90,500,30,,yes,yes\n");
    mission::SiteFilter filter;
    filter.minWidth = Length::fromSi(18.0);
    filter.surfaces = {mission::Surface::Hard};
    filter.lighted = true;
    filter.exclude = {"D"};
    filter.notes = {{"D", "wires at the threshold"}};
    const AirfieldReport report = read("mine.csv", filter);
    QCOMPARE(report.sites.size(), std::size_t{1});
    QCOMPARE(report.sites[0].airportIdent, std::string("E"));
    VP_CONTAINS(joined(report.sites[0].approximations), {"width unknown"});
    VP_CONTAINS(joined(report.notes), {"narrower than 18 m (A/", "surface not among those that the mission allows (B/", "not lighted", "(C/",
                                       "excluded by the mission: wires at the threshold (D/", "surface unknown (F/"});
  }

  void opposite_ofNames_isTheOtherEnd() {
    QCOMPARE(oppositeIdent("21L"), std::string("03R"));
    QCOMPARE(oppositeIdent("18"), std::string("36"));
    QCOMPARE(oppositeIdent("36C"), std::string("18C"));
    QCOMPARE(oppositeIdent("NE"), std::string("SW"));
    QCOMPARE(oppositeIdent("ALL"), std::string());
    QCOMPARE(oppositeIdent("37"), std::string());
  }

  void numbers_nearTheMagneticPole_areTrue() {
    const auto alert = courseFromName("05", {84.0, -100.0});
    QVERIFY(alert);
    QCOMPARE(alert->course.degrees(), 50.0);
    VP_CONTAINS(alert->how, {"taken as true"});
  }
};

QTEST_APPLESS_MAIN(TestOwnAirfields)
#include "tst_own_airfields.moc"
