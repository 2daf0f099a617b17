#include "core/formats/airfields.h"
#include "core/formats/surface.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>
#include <zlib.h>

#include <cmath>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

const std::string kAirportsHead = "\"id\",\"ident\",\"type\",\"name\",\"latitude_deg\",\"longitude_deg\",\"elevation_ft\"\n";
const std::string kRunwaysHead =
    "id,airport_ref,airport_ident,length_ft,width_ft,surface,lighted,closed,le_ident,le_latitude_deg,le_longitude_deg,le_elevation_ft,le_heading_"
    "degT,"
    "le_displaced_threshold_ft,he_ident,he_latitude_deg,he_longitude_deg,he_elevation_ft,he_heading_degT,he_displaced_threshold_ft\n";

/// The airport that most rows below refer to: 46.5 N, 9.0 E, 1000 ft.
const std::string kAirport = "1,AAA,small_airport,\"Alpha, \"\"A\"\" Field\",46.5,9.0,1000\n";
/// Its runway due east, 1200 m between ends, both given, with elevations.
const std::string kEast = "1,1,AAA,3937,98,ASP,1,0,09,46.5,8.9921815,980,90,,27,46.5,9.0078185,1010,270,328\n";

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

const mission::LandingSite* find(const AirfieldReport& report, const std::string& id) {
  const auto site = std::find_if(report.sites.begin(), report.sites.end(), [&](const mission::LandingSite& s) { return s.id == id; });
  return site == report.sites.end() ? nullptr : &*site;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    all += text + "; ";
  }
  return all;
}

}  // namespace

class TestOurAirports : public QObject {
  Q_OBJECT
  Folder folder_;

  Result<AirfieldReport> read(const std::string& airports, const std::string& runways, const mission::SiteFilter& filter = {},
                              const std::optional<geo::GeoBox>& area = {}) {
    return readOurAirports(folder_.write("airports.csv", airports), folder_.write("runways.csv", runways), filter, area);
  }
  Result<AirfieldReport> readRows(const std::string& runways, const mission::SiteFilter& filter = {}) {
    return read(kAirportsHead + kAirport, kRunwaysHead + runways, filter);
  }

private slots:
  void fullRow_givesBothEnds() {
    const auto report = readRows(kEast);
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(report->sites.size(), std::size_t{2});
    const mission::LandingSite* east = find(*report, "AAA/09");
    const mission::LandingSite* west = find(*report, "AAA/27");
    QVERIFY(east != nullptr && west != nullptr);
    QCOMPARE(east->airportIdent, std::string("AAA"));
    QCOMPARE(east->airportName, std::string("Alpha, \"A\" Field"));
    QCOMPARE(east->runwayIdent, std::string("09"));
    QCOMPARE(east->touchdown.longitude_deg, 8.9921815);
    QVERIFY(near(east->landingCourse.degrees(), 90.0, 0.02));
    QVERIFY(near(east->elevation.feet(), 980.0, 1e-9));
    QVERIFY(near(east->length->si(), 1200.0, 1.0));
    QVERIFY(near(east->width->si(), 98 * 0.3048, 1e-9));
    QCOMPARE(east->surface, mission::Surface::Hard);
    QVERIFY(east->lighted && !east->isApproximate());
    QCOMPARE(east->source, std::string("runways.csv"));
    // 27: touchdown 328 ft (100 m) west of its end, landing distance shorter by as much
    QVERIFY(near(west->landingCourse.degrees(), 270.0, 0.02));
    QVERIFY(near(geo::geodesicDistance(west->touchdown, {46.5, 9.0078185}).si(), 99.97, 0.01));
    QVERIFY(west->touchdown.longitude_deg < 9.0078185);
    QVERIFY(near(west->length->si(), 1100.0, 1.0));
    QVERIFY(near(west->elevation.feet(), 1010.0, 1e-9));
  }

  void crlfAndByteOrderMarkAndGzip_makeNoDifference() {
    const auto plain = readRows(kEast);
    std::string crlf = "\xEF\xBB\xBF" + kRunwaysHead + kEast;
    for (std::size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2) {
      crlf.insert(at, "\r");
    }
    const auto windows = read(kAirportsHead + kAirport, crlf);
    QVERIFY2(windows, windows ? "" : windows.error().message().c_str());
    QVERIFY(windows->sites == plain->sites);
    const std::string packed = folder_.path("r.csv.gz");
    const std::string text = kRunwaysHead + kEast;
    gzFile file = gzopen(packed.c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    const auto zipped = readOurAirports(folder_.path("airports.csv"), packed, {}, {});
    QVERIFY2(zipped, zipped ? "" : zipped.error().message().c_str());
    QCOMPARE(zipped->sites.size(), std::size_t{2});
    folder_.write("cut.csv.gz", samples::readBytes(packed).substr(0, 60));
    VP_CONTAINS(readOurAirports(folder_.path("airports.csv"), folder_.path("cut.csv.gz"), {}, {}).error().message(),
                {"cut.csv.gz", "damaged or cut short"});
  }

  void columnsInAnotherOrderAndMore_areFoundByName() {
    const auto report =
        read("keywords,name,icao_code,ident,elevation_ft,longitude_deg,type,latitude_deg\n\"a\nb\",Alpha,X,AAA,1000,9.0,small_airport,46.5\n",
             kRunwaysHead + kEast);
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(report->sites.size(), std::size_t{2});
  }

  void missingEnds_areDerivedAboutTheAirport() {
    const auto report = readRows("1,1,AAA,3937,,TURF,0,0,09,,,,85,,27,,,,,\n");
    const mission::LandingSite* site = find(*report, "AAA/09");
    const mission::LandingSite* other = find(*report, "AAA/27");
    QVERIFY(site != nullptr && other != nullptr);
    QVERIFY(near(site->landingCourse.degrees(), 85.0, 1e-9));
    QVERIFY(near(other->landingCourse.degrees(), 265.0, 1e-9));
    QVERIFY(near(geo::geodesicDistance(site->touchdown, {46.5, 9.0}).si(), 600.0, 0.01));
    QVERIFY(near(geo::geodesicDistance(other->touchdown, {46.5, 9.0}).si(), 600.0, 0.01));
    QVERIFY(near(geo::geodesicCourse(site->touchdown, other->touchdown).degrees(), 85.0, 0.02));
    QVERIFY(near(site->elevation.feet(), 1000.0, 1e-9));
    VP_CONTAINS(joined(site->approximations), {"derived from the airport's position", "elevation of the airport"});
    QVERIFY(!site->width);
    mission::SiteFilter exactOnly;
    exactOnly.approximate = false;
    const auto none = readRows("1,1,AAA,3937,,TURF,0,0,09,,,,85,,27,,,,,\n", exactOnly);
    QVERIFY(none->sites.empty());
    VP_CONTAINS(joined(none->notes), {"2 left out: geometry only approximate"});
  }

  void heading_comesFromTheOtherEndOrTheNumberOrTheName_data() {
    QTest::addColumn<QString>("le");
    QTest::addColumn<QString>("leHeading");
    QTest::addColumn<QString>("he");
    QTest::addColumn<QString>("heHeading");
    QTest::addColumn<double>("course");
    QTest::addColumn<bool>("fromNumber");
    QTest::newRow("own") << "18"
                         << "175"
                         << "36"
                         << "" << 175.0 << false;
    QTest::newRow("other end") << "18"
                               << ""
                               << "36"
                               << "355" << 175.0 << false;
    QTest::newRow("number") << "05"
                            << ""
                            << "23"
                            << "" << 50.0 << true;
    QTest::newRow("one digit") << "5"
                               << ""
                               << "23"
                               << "" << 50.0 << true;
    QTest::newRow("with letter") << "05L"
                                 << ""
                                 << "23R"
                                 << "" << 50.0 << true;
    QTest::newRow("36") << "36"
                        << ""
                        << "18"
                        << "" << 0.0 << true;
    QTest::newRow("degrees") << "161"
                             << ""
                             << "341"
                             << "" << 161.0 << true;
    QTest::newRow("N") << "N"
                       << ""
                       << "S"
                       << "" << 0.0 << true;
    QTest::newRow("NE") << "NE"
                        << ""
                        << "SW"
                        << "" << 45.0 << true;
    QTest::newRow("ENE") << "ENE"
                         << ""
                         << "WSW"
                         << "" << 67.5 << true;
    QTest::newRow("only the other named") << "?"
                                          << ""
                                          << "36"
                                          << "" << 180.0 << true;
  }
  void heading_comesFromTheOtherEndOrTheNumberOrTheName() {
    QFETCH(QString, le);
    QFETCH(QString, leHeading);
    QFETCH(QString, he);
    QFETCH(QString, heHeading);
    QFETCH(double, course);
    QFETCH(bool, fromNumber);
    const auto report = readRows(("1,1,AAA,3000,,TURF,0,0," + le + ",,,," + leHeading + ",," + he + ",,,," + heHeading + ",\n").toStdString());
    QVERIFY(report);
    const mission::LandingSite* site = find(*report, "AAA/" + le.toStdString());
    QVERIFY(site != nullptr);
    const std::string notes = joined(site->approximations);
    const bool isMagnetic = notes.find("runway number and the magnetic variation of 3 degrees east") != std::string::npos;
    constexpr double kVariation = 3.4;  // degrees east at 46.5 N 9 E in 2025, ngdc.noaa.gov calculator
    QVERIFY(near(site->landingCourse.degrees(), course + (isMagnetic ? kVariation : 0.0), isMagnetic ? 0.3 : 1e-9));
    QCOMPARE(notes.find("heading derived from the runway") != std::string::npos, fromNumber);
    QCOMPARE(isMagnetic, fromNumber && (le.isEmpty() || !le[0].isLetter()));
  }

  void oneEnd_givesTheOther() {
    const auto report = readRows("1,1,AAA,3937,,TURF,0,0,09,,,,,,27,46.5,9.0078185,,270,\n");
    const mission::LandingSite* site = find(*report, "AAA/09");
    QVERIFY(site != nullptr && find(*report, "AAA/27") != nullptr);
    QVERIFY(near(geo::geodesicDistance(site->touchdown, {46.5, 9.0078185}).si(), 3937 * 0.3048, 0.01));
    QVERIFY(site->touchdown.longitude_deg < 9.0);
    VP_CONTAINS(joined(site->approximations), {"one runway end derived"});
  }

  void oneEndWithoutLength_isTheOnlySite() {
    const auto report = readRows("1,1,AAA,,,TURF,0,0,09,46.5,8.9921815,980,90,,27,,,,,\n");
    QCOMPARE(report->sites.size(), std::size_t{1});
    QCOMPARE(report->sites[0].id, std::string("AAA/09"));
    QVERIFY(!report->sites[0].length);
    VP_CONTAINS(joined(report->sites[0].approximations), {"length unknown"});
  }

  void oddRows_areMarkedOrLeftOutWithANote_data() {
    QTest::addColumn<QString>("row");
    QTest::addColumn<int>("sites");
    QTest::addColumn<QString>("text");  // in a note, or in the marks of the first site
    const auto row = [](const char* name, const char* text, int sites, const char* says) { QTest::newRow(name) << text << sites << says; };
    row("closed runway", "1,1,AAA,3937,,ASP,1,1,09,,,,90,,27,,,,,\n", 0, "closed");
    row("surface closed", "1,1,AAA,3937,,CLOSED,1,0,09,,,,90,,27,,,,,\n", 0, "closed");
    row("helipad", "1,1,AAA,80,80,CONC,1,0,H1,,,,,,,,,,,\n", 0, "helipad (AAA/H1)");
    row("water", "1,1,AAA,3937,,WATER-E,1,0,09,,,,90,,27,,,,,\n", 0, "2 left out: water (AAA/09, AAA/27)");
    row("water lane", "1,1,AAA,3937,,UNK,1,0,09W,,,,90,,27W,,,,,\n", 0, "2 left out: water");
    row("no heading", "1,1,AAA,3937,,TURF,0,0,ALL,,,,,,ALL,,,,,\n", 0, "no heading and not both runway ends");
    row("no name", "1,1,AAA,3937,,TURF,0,0,,46.5,8.9921815,,90,,,46.5,9.0078185,,,\n", 0, "runway without a name");
    row("one-ended", "1,1,AAA,3937,,TURF,0,0,09,46.5,8.9921815,980,90,,,46.5,9.0078185,,,\n", 1, "opposite end not in the file");
    row("no length", "1,1,AAA,,,TURF,0,0,09,,,,90,,27,,,,,\n", 2, "runway length unknown; the airport's position");
    row("heading disagrees", "1,1,AAA,3937,,ASP,1,0,09,46.5,8.9921815,980,96,,27,46.5,9.0078185,1010,,\n", 2,
        "differs by 6 degrees from the runway ends; the ends count");
    row("length disagrees", "1,1,AAA,3000,,ASP,1,0,09,46.5,8.9921815,980,90,,27,46.5,9.0078185,1010,,\n", 2,
        "length in the file is 914 m but the runway ends are 1200 m apart");
    row("number disagrees", "1,1,AAA,3000,,ASP,1,0,09,,,980,180,,27,,,1010,,\n", 2, "heading disagrees with the runway number");
    row("headings not opposite", "1,1,AAA,3000,,ASP,1,0,09,,,980,90,,27,,,1010,280,\n", 2, "headings of the two ends are not opposite");
    row("elevation disagrees", "1,1,AAA,3937,,ASP,1,0,09,46.5,8.9921815,300,90,,27,46.5,9.0078185,1010,,\n", 2,
        "threshold (91 m) and of the airport (305 m) disagree; the higher counts");
    row("far end", "1,1,AAA,3937,,ASP,1,0,09,46.5,9.9,980,90,,27,46.5,9.0078185,1010,,\n", 0, "more than 15 km from its airport");
    row("ends at null island", "1,1,AAA,3937,,ASP,1,0,09,0,0,980,90,,27,0,0,1010,,\n", 0, "more than 15 km from its airport");
    row("ends in one place", "1,1,AAA,3937,,ASP,1,0,09,46.5,9.0,980,90,,27,46.5,9.0,1010,,\n", 2, "derived from the airport's position");
    row("displaced too far", "1,1,AAA,3937,,ASP,1,0,09,46.5,8.9921815,980,90,4000,27,46.5,9.0078185,1010,,\n", 1,
        "displaced threshold negative or beyond the runway (AAA/09)");
    row("displaced negative", "1,1,AAA,3937,,ASP,1,0,09,46.5,8.9921815,980,90,-10,27,46.5,9.0078185,1010,,\n", 1, "displaced threshold negative");
    row("nonsense length", "1,1,AAA,long,,ASP,1,0,09,,,980,90,,27,,,1010,,\n", 0, "a value of the runway makes no sense (AAA/09 in row 2)");
    row("nonsense heading", "1,1,AAA,3937,,ASP,1,0,09,,,980,400,,27,,,1010,,\n", 0, "makes no sense");
    row("nonsense elevation", "1,1,AAA,3937,,ASP,1,0,09,,,high,90,,27,,,1010,,\n", 0, "makes no sense");
    row("latitude out of range", "1,1,AAA,3937,,ASP,1,0,09,95,9.0,,90,,27,,,1010,,\n", 0, "makes no sense");
    row("unknown airport", "1,1,ZZZ,3937,,ASP,1,0,09,,,980,90,,27,,,1010,,\n", 0, "");
  }
  void oddRows_areMarkedOrLeftOutWithANote() {
    QFETCH(QString, row);
    QFETCH(int, sites);
    QFETCH(QString, text);
    const auto report = readRows(row.toStdString());
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(static_cast<int>(report->sites.size()), sites);
    VP_CONTAINS(joined(report->notes) + (sites > 0 ? joined(report->sites[0].approximations) : std::string()), {text.toStdString()});
  }

  void lengthAndDisplacement_takeTheShorterLength() {
    const auto report = readRows("1,1,AAA,3000,,ASP,1,0,09,46.5,8.9921815,980,90,100,27,46.5,9.0078185,1010,,\n");
    QVERIFY(near(find(*report, "AAA/09")->length->si(), (3000 - 100) * 0.3048, 1e-6));
    QVERIFY(near(find(*report, "AAA/27")->length->si(), 3000 * 0.3048, 1e-6));
  }

  void airportsOfOtherKinds_areLeftOutWithACount() {
    const std::string airports =
        kAirportsHead + kAirport + "2,BBB,heliport,B,46.5,9,1\n3,CCC,closed,C,46.5,9,1\n4,DDD,closed_airport,D,46.5,9,1\n" +
        "5,EEE,balloonport,E,46.5,9,1\n6,FFF,seaplane_base,F,46.5,9,1\n7,GGG,small_airport,G,,,1\n8,HHH,small_airport,H,46.5,9,\n";
    std::string runways;
    for (const char* ident : {"AAA", "BBB", "CCC", "DDD", "EEE", "FFF", "GGG", "HHH"}) {
      runways += "1,1," + std::string(ident) + ",3000,,TURF,0,0,09,,,,90,,27,,,,,\n";
    }
    const auto report = read(airports, kRunwaysHead + runways);
    QVERIFY(report);
    QCOMPARE(report->sites.size(), std::size_t{4});
    QVERIFY(find(*report, "HHH/09")->elevationFromTerrain && find(*report, "HHH/09")->isApproximate());
    QVERIFY(!find(*report, "AAA/09")->elevationFromTerrain);
    VP_CONTAINS(joined(report->notes), {"1 left out: heliport (BBB)", "2 left out: airport closed (CCC, DDD)", "1 left out: balloonport (EEE)",
                                        "1 left out: seaplane base (FFF)", "airport without a usable position (GGG)"});
    mission::SiteFilter all;
    all.closed = true;
    all.water = true;
    const auto more = read(airports, kRunwaysHead + runways, all);
    QCOMPARE(more->sites.size(), std::size_t{10});
    QCOMPARE(find(*more, "FFF/09")->surface, mission::Surface::Water);
  }

  void filter_excludesAndKeepsOneWay() {
    mission::SiteFilter filter;
    filter.oneWay = {"AAA/09"};
    auto report = readRows(kEast, filter);
    QCOMPARE(report->sites.size(), std::size_t{1});
    QCOMPARE(report->sites[0].id, std::string("AAA/09"));
    VP_CONTAINS(joined(report->notes), {"opposite end of a one-way runway (AAA/27)"});
    filter = {};
    filter.exclude = {"AAA/09", "nothing"};
    report = readRows(kEast, filter);
    QCOMPARE(report->sites.size(), std::size_t{1});
    QCOMPARE(report->sites[0].id, std::string("AAA/27"));
    VP_CONTAINS(joined(report->notes), {"excluded by the mission (AAA/09)"});
    QCOMPARE(unmatchedNames(filter, {*report}), std::vector<std::string>{"nothing"});
    filter.exclude = {"AAA"};
    QVERIFY(readRows(kEast, filter)->sites.empty());
    filter = {};
    filter.minLength = Length::fromSi(1150.0);
    report = readRows(kEast, filter);
    QCOMPARE(report->sites.size(), std::size_t{1});
    VP_CONTAINS(joined(report->notes), {"shorter than 1150 m (AAA/27)"});
    report = readRows("1,1,AAA,,,TURF,0,0,09,,,,90,,27,,,,,\n", filter);
    QCOMPARE(report->sites.size(), std::size_t{2});
    VP_CONTAINS(joined(report->sites[0].approximations), {"least length that the mission asks for is not assured"});
  }

  void equalIds_areNumbered() {
    const auto report = readRows(kEast + "2,1,AAA,2000,,TURF,0,0,09,,,,90,,27,,,,,\n" + "3,1,AAA,1000,,TURF,0,0,09,,,,90,,27,,,,,\n");
    QVERIFY(find(*report, "AAA/09") != nullptr && find(*report, "AAA/09#2") != nullptr && find(*report, "AAA/27#3") != nullptr);
    mission::SiteFilter filter;
    filter.exclude = {"AAA/09"};  // a runway that must not be used is meant, whichever of the equal names it bears
    QCOMPARE(readRows(kEast + "2,1,AAA,2000,,TURF,0,0,09,,,,90,,27,,,,,\n", filter)->sites.size(), std::size_t{2});
    std::vector<mission::LandingSite> sites(3);
    sites[0].id = sites[1].id = "X";
    sites[2].id = "X#2";
    makeIdsUnique(sites);
    QCOMPARE(sites[0].id, std::string("X"));
    QCOMPARE(sites[1].id, std::string("X#3"));
    QCOMPARE(sites[2].id, std::string("X#2"));
  }

  void area_countsByTouchdown() {
    const geo::GeoBox west{{46.0, 8.0}, {47.0, 9.0}};
    const auto report = read(kAirportsHead + kAirport, kRunwaysHead + kEast, {}, west);
    QCOMPARE(report->sites.size(), std::size_t{1});
    QCOMPARE(report->sites[0].id, std::string("AAA/09"));
    const geo::GeoBox far{{50.0, 8.0}, {51.0, 9.0}};
    const auto none = read(kAirportsHead + kAirport, kRunwaysHead + kEast, {}, far);
    QVERIFY(none->sites.empty() && none->notes.empty());
    const geo::GeoBox pacific{{-10.0, 170.0}, {10.0, -170.0}};
    QVERIFY(pacific.contains({0.0, 175.0}) && pacific.contains({0.0, -175.0}) && !pacific.contains({0.0, 0.0}) && !pacific.contains({20.0, 175.0}));
  }

  void missionSites_passTheSameFilter() {
    std::vector<mission::LandingSite> sites{samples::sampleSite("A/21", {46.5, 9.9}, 209.0), samples::sampleSite("A/03", {46.6, 9.8}, 29.5),
                                            samples::sampleSite("A/12", {46.6, 9.8}, 120.0)};
    mission::SiteFilter filter;
    filter.oneWay = {"A/21"};
    const auto report = filterSites(sites, filter, {});
    QCOMPARE(report.sites.size(), std::size_t{2});
    QCOMPARE(report.sites[1].id, std::string("A/12"));
    QVERIFY(unmatchedNames(filter, {report}).empty());
  }

  void brokenFiles_areRefusedWithRowAndColumn_data() {
    QTest::addColumn<QString>("airports");
    QTest::addColumn<QString>("runways");
    QTest::addColumn<QStringList>("parts");
    const auto row = [](const char* name, const std::string& airports, const std::string& runways, const QStringList& parts) {
      QTest::newRow(name) << QString::fromStdString(airports) << QString::fromStdString(runways) << parts;
    };
    const std::string airports = kAirportsHead + kAirport;
    const std::string runways = kRunwaysHead + kEast;
    row("missing column", "ident,type,name,latitude_deg,longitude_deg\n", runways, {"airports.csv, row 1", "no column \"elevation_ft\""});
    row("missing runway column", airports, "airport_ident,length_ft\n", {"runways.csv, row 1", "no column \"width_ft\"", "ourairports.com"});
    row("swapped", runways, airports, {"airports.csv", "this is a runways file; name airports.csv as \"airports\""});
    row("airports twice", airports, airports, {"runways.csv", "this is an airports file; name runways.csv as \"runways\""});
    row("empty", "", runways, {"airports.csv, row 1", "no column \"ident\""});
    row("open quote", airports + "9,\"BBB,small_airport,B,1,2,3\n", runways,
        {"airports.csv, row 3, column 2", "quote is opened here and never closed"});
    row("text after quote", airports + "9,\"BBB\"x,small_airport,B,1,2,3\n", runways,
        {"airports.csv, row 3, column 2", "text follows a closing quote"});
    row("too few fields", airports + "9,BBB,small\n", runways, {"airports.csv, row 3, column 3", "has 3 fields and the header 7"});
    row("too many fields", airports + "9,BBB,small_airport,B,1,2,3,4\n", runways, {"airports.csv, row 3", "has 8 fields"});
    row("coordinate", airports + "9,BBB,small_airport,B,46°,2,3\n", runways,
        {"airports.csv, row 3, column 5 (latitude_deg)", "\"46°\" is not a number of degrees"});
    row("runway coordinate", airports, runways + "1,1,AAA,3937,98,ASP,1,0,09,46.5,8;99,980,90,,27,46.5,9.0,1010,270,328\n",
        {"runways.csv, row 3, column 11 (le_longitude_deg)", "\"8;99\" is not a number"});
    row("row after embedded line", kAirportsHead + "1,AAA,small_airport,\"A\n\nB\",46.5,9.0,1000\n2,BBB,small_airport,B,x,9.0,1000\n", runways,
        {"row 5, column 5"});
  }
  void brokenFiles_areRefusedWithRowAndColumn() {
    QFETCH(QString, airports);
    QFETCH(QString, runways);
    QFETCH(QStringList, parts);
    const auto report = read(airports.toStdString(), runways.toStdString());
    QVERIFY(!report);
    QCOMPARE(report.error().code, Errc::BadFormat);
    for (const QString& part : parts) {
      VP_CONTAINS(report.error().message(), {part.toStdString()});
    }
  }

  void sources_areReadByWhatTheyAre() {
    folder_.write("airports.csv", kAirportsHead + kAirport);
    folder_.write("runways.csv", kRunwaysHead + kEast);
    QCOMPARE(readAirfields({"airports.csv", "runways.csv"}, folder_.path(), {}, {})->sites.size(), std::size_t{2});
    VP_CONTAINS(readAirfields({"airports.csv", ""}, folder_.path(), {}, {}).error().message(),
                {"airports.csv", "needs its runways file", "add \"runways\""});
    folder_.write("y.cup", "name,code,country,lat,lon,elev,style,rwdir,rwlen\n");
    VP_CONTAINS(readAirfields({"y.cup", "runways.csv"}, folder_.path(), {}, {}).error().message(), {"y.cup", "remove \"runways\""});
    VP_CONTAINS(readAirfields({"x.cup", "runways.csv"}, folder_.path(), {}, {}).error().message(), {"x.cup", "no such file"});
    VP_CONTAINS(readAirfields({"apt.dat", ""}, folder_.path(), {}, {}).error().message(), {"apt.dat", "no such file"});
    VP_CONTAINS(readAirfields({"none.csv", "runways.csv"}, folder_.path(), {}, {}).error().message(), {"none.csv", "no such file"});
  }

  void surfaces_areUnderstood_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("surface");
    using mission::Surface;
    const std::vector<std::pair<const char*, Surface>> table{{"ASP", Surface::Hard},
                                                             {"ASPH-G", Surface::Hard},
                                                             {"CON", Surface::Hard},
                                                             {"concrete", Surface::Hard},
                                                             {"PEM", Surface::Hard},
                                                             {"Ashphalt", Surface::Hard},
                                                             {"C", Surface::Hard},
                                                             {"Hard Surfaced", Surface::Hard},
                                                             {"BIT", Surface::Hard},
                                                             {"paved", Surface::Hard},
                                                             {"Rolled Asphalt", Surface::Hard},
                                                             {"TURF", Surface::Grass},
                                                             {"TURF-G", Surface::Grass},
                                                             {"GRASS / SOD", Surface::Grass},
                                                             {"Grassed brown clay", Surface::Grass},
                                                             {"GRS", Surface::Grass},
                                                             {"G", Surface::Grass},
                                                             {"Herba (grass)", Surface::Grass},
                                                             {"GRAVEL", Surface::Gravel},
                                                             {"GVL", Surface::Gravel},
                                                             {"GRVL-DIRT-F", Surface::Gravel},
                                                             {"Piçarra", Surface::Gravel},
                                                             {"PIÇARRA", Surface::Gravel},
                                                             {"CRUSHED ROCK", Surface::Gravel},
                                                             {"Coral", Surface::Gravel},
                                                             {"Graded earth", Surface::Dirt},
                                                             {"GRE", Surface::Dirt},
                                                             {"DIRT", Surface::Dirt},
                                                             {"Unpaved", Surface::Dirt},
                                                             {"SAN", Surface::Dirt},
                                                             {"Red clay", Surface::Dirt},
                                                             {"LAT", Surface::Dirt},
                                                             {"Dry Lake", Surface::Dirt},
                                                             {"SNO", Surface::Snow},
                                                             {"Blue Ice", Surface::Snow},
                                                             {"WATER-E", Surface::Water},
                                                             {"Summer water.", Surface::Water},
                                                             {"WAT", Surface::Water},
                                                             {"TURF/WATER", Surface::Water},
                                                             {"", Surface::Unknown},
                                                             {"UNK", Surface::Unknown},
                                                             {"X", Surface::Unknown},
                                                             {"None", Surface::Unknown},
                                                             {"OLD ASP", Surface::Hard},
                                                             {"TRTD GRVL", Surface::Gravel}};
    for (const auto& [text, surface] : table) {
      QTest::newRow(text) << QString::fromUtf8(text) << static_cast<int>(surface);
    }
  }
  void surfaces_areUnderstood() {
    QFETCH(QString, text);
    QFETCH(int, surface);
    QCOMPARE(static_cast<int>(surfaceFromText(text.toStdString())), surface);
  }
};

QTEST_APPLESS_MAIN(TestOurAirports)
#include "tst_our_airports.moc"
