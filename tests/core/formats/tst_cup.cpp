#include "core/formats/airfields.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <cmath>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

const std::string kHead2018 = "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\n";

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    all += text + "; ";
  }
  return all;
}

}  // namespace

class TestCup : public QObject {
  Q_OBJECT
  Folder folder_;

  Result<AirfieldReport> read(const std::string& text, const mission::SiteFilter& filter = {}, const std::optional<geo::GeoBox>& area = {}) {
    return readCup(folder_.write("a.cup", text), filter, area);
  }

private slots:
  void airfield_givesBothEndsAboutThePoint() {
    const auto report = read(kHead2018 + "\"Alpha \"\"A\"\", Field\",LSAA,CH,4630.000N,00900.000E,500.0m,5,040,1000.0m,128.475,\"x\"\n");
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(report->sites.size(), std::size_t{2});
    const mission::LandingSite& site = report->sites[0];
    QCOMPARE(site.id, std::string("LSAA/04"));
    QCOMPARE(report->sites[1].id, std::string("LSAA/22"));
    QCOMPARE(site.airportName, std::string("Alpha \"A\", Field"));
    QVERIFY(near(site.landingCourse.degrees(), 40.0, 1e-9));
    QVERIFY(near(report->sites[1].landingCourse.degrees(), 220.0, 1e-9));
    QVERIFY(near(geo::geodesicDistance(site.touchdown, {46.5, 9.0}).si(), 500.0, 0.01));
    QVERIFY(near(geo::geodesicCourse(site.touchdown, {46.5, 9.0}).degrees(), 40.0, 0.01));
    QVERIFY(near(site.elevation.metres(), 500.0, 1e-9));
    QVERIFY(near(site.length->si(), 1000.0, 1e-9));
    QCOMPARE(site.surface, mission::Surface::Hard);
    VP_CONTAINS(joined(site.approximations), {"whole degrees", "derived from the airport's position"});
    QCOMPARE(site.source, std::string("a.cup"));
  }

  void columnsOf2022AndOddNames_areFound() {
    const auto report = read(
        "name,code,country,lat,lon,elev,style,rwdir,rwlen,rwwidth,freq,desc,userdata,pics\nB,,CH,4630.000N,00900.000E,1640ft,2,90,0.5nm,30m,,,,\n");
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QVERIFY(near(report->sites[0].elevation.metres(), 1640 * 0.3048, 1e-9));
    QVERIFY(near(report->sites[0].length->si(), 926.0, 1e-9));
    QVERIFY(near(report->sites[0].width->si(), 30.0, 1e-9));
    QCOMPARE(report->sites[0].id, std::string("B/09"));
    const auto odd = read(
        "Title,Code,Country,Latitude,Longitude,Elevation,Style,Direction,Length,Frequency,Description\nC,CC,DE,4630.000S,00900.000W,100m,4,10,0.5ml,,"
        "\n");
    QVERIFY2(odd, odd ? "" : odd.error().message().c_str());
    QVERIFY(near(odd->sites[0].length->si(), 804.672, 1e-9));
    QVERIFY(odd->sites[0].touchdown.latitude_deg < -46.0 && odd->sites[0].touchdown.longitude_deg < -8.9);
  }

  void stylesAndTasks_decideWhatIsRead() {
    std::string text = kHead2018;
    for (int style = 1; style <= 21; ++style) {
      text += "P" + std::to_string(style) + ",,CH,4630.000N,00900.000E,500m," + std::to_string(style) + ",90,500m,,\n";
    }
    text += "-----Related Tasks-----\n\"T\",\"P1\",\"P2\"\nOptions,NoStart=1\n\"open\n";
    const auto report = read(text);
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(report->sites.size(), std::size_t{8});
    QCOMPARE(report->sites[0].surface, mission::Surface::Grass);
    QCOMPARE(report->sites[2].surface, mission::Surface::Unknown);
    VP_CONTAINS(joined(report->sites[2].approximations), {"outlanding field"});
  }

  void windows1252_becomesUtf8() {
    const auto report = read(kHead2018 + "Z\xFCrich \x80,,CH,4630.000N,00900.000E,500m,5,90,500m,,\n");
    QCOMPARE(report->sites[0].airportName, std::string("Zürich €"));
    const auto utf8 = read("\xEF\xBB\xBF" + kHead2018 + "Zürich,,CH,4630.000N,00900.000E,500m,5,90,500m,,\n");
    QCOMPARE(utf8->sites[0].airportName, std::string("Zürich"));
  }

  void quotesAndSpaces_areTakenAsSeeYouDoes() {
    const auto report =
        read(kHead2018 + "\"B\",\"\",,4630.000N  ,00900.000E,  488.0m,  5  ,040,590m,\"123.650\" , \"Rabbit holes, 20\" ditch south end of rwy\"\n" +
             "\"C\",\"CC\",,4630.000N,00900.000E,488.0m,5,040,590m,,\"ends with "
             "\"\"quote\"\"\"\n\"D\",\"DD\",,4630.000N,00900.000E,488.0m,5,040,590m,,\"odd \"quote\"\"\n");
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(report->sites.size(), std::size_t{6});
    QCOMPARE(report->sites[0].id, std::string("B/04"));
    QCOMPARE(report->sites[4].id, std::string("DD/04"));
  }

  void oddPoints_areMarkedOrLeftOutWithANote_data() {
    QTest::addColumn<QString>("fields");  // elev,style,rwdir,rwlen
    QTest::addColumn<int>("sites");
    QTest::addColumn<QString>("text");
    QTest::newRow("no direction") << "500m,5,,500m" << 0 << "no runway direction (LSAA)";
    QTest::newRow("zero means none") << "500m,3,0,0.0m" << 0 << "no runway direction";
    QTest::newRow("zero with a length is north") << "500m,3,0,500m" << 2 << "whole degrees";
    QTest::newRow("360") << "500m,3,360,500m" << 2 << "whole degrees";
    QTest::newRow("direction 400") << "500m,5,400,500m" << 0 << "runway direction makes no sense";
    QTest::newRow("direction text") << "500m,5,N,500m" << 0 << "runway direction makes no sense";
    QTest::newRow("no length") << "500m,5,90," << 2 << "runway length unknown; the airport's position is taken";
    QTest::newRow("length without unit") << "500m,5,90,500" << 2 << "runway length unknown";
    QTest::newRow("frequency as length") << "500m,5,90,123650m" << 2 << "runway length unknown";
    QTest::newRow("no elevation") << ",5,90,500m" << 0 << "no usable elevation with a unit";
    QTest::newRow("elevation without unit") << "500,5,90,500m" << 0 << "no usable elevation with a unit";
    QTest::newRow("elevation nonsense") << "99999m,5,90,500m" << 0 << "no usable elevation";
    QTest::newRow("elevation zero") << "0.0m,5,90,500m" << 2 << "elevation 0 in the file";
    QTest::newRow("style text") << "500m,x,90,500m" << 0 << "";
  }
  void oddPoints_areMarkedOrLeftOutWithANote() {
    QFETCH(QString, fields);
    QFETCH(int, sites);
    QFETCH(QString, text);
    const auto report = read(kHead2018 + "A,LSAA,CH,4630.000N,00900.000E," + fields.toStdString() + ",,\n");
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    QCOMPARE(static_cast<int>(report->sites.size()), sites);
    VP_CONTAINS(joined(report->notes) + (sites > 0 ? joined(report->sites[0].approximations) : std::string()), {text.toStdString()});
    if (sites > 0 && text.contains("length unknown")) {
      QVERIFY(near(report->sites[0].touchdown.latitude_deg, 46.5, 1e-12));
      QVERIFY(!report->sites[0].length);
    }
  }

  void northernRunway_isNumbered36And18() {
    const auto report = read(kHead2018 + "A,LSAA,CH,4630.000N,00900.000E,500m,5,360,500m,,\n");
    QCOMPARE(report->sites[0].id, std::string("LSAA/36"));
    QCOMPARE(report->sites[1].id, std::string("LSAA/18"));
    QVERIFY(near(report->sites[0].landingCourse.degrees(), 0.0, 1e-9));
  }

  void area_keepsWhatLiesInside() {
    const std::string text = kHead2018 + "A,AA,CH,4630.000N,00900.000E,500m,5,90,500m,,\nB,BB,CH,4030.000N,00900.000E,500m,5,,500m,,\n";
    const auto report = read(text, {}, geo::GeoBox{{46.0, 8.0}, {47.0, 10.0}});
    QCOMPARE(report->sites.size(), std::size_t{2});
    QVERIFY(report->notes.empty());
  }

  void brokenFiles_areRefusedWithRowAndColumn_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("parts");
    const QString head = QString::fromStdString(kHead2018);
    QTest::newRow("no header") << QString("A,LSAA,CH,4630.000N,00900.000E,500m,5,90,500m,,\n")
                               << QStringList{"a.cup, row 1", "no column \"name\"", "begins with name,code"};
    QTest::newRow("empty") << QString() << QStringList{"no column"};
    QTest::newRow("latitude") << head + "A,LSAA,CH,4660.000N,00900.000E,500m,5,90,500m,,\n"
                              << QStringList{"a.cup, row 2, column 4 (lat)", "\"4660.000N\" is not a latitude", "4632.046N"};
    QTest::newRow("decimal") << head + "A,LSAA,CH,46.5,00900.000E,500m,5,90,500m,,\n" << QStringList{"row 2, column 4 (lat)"};
    QTest::newRow("longitude") << head + "A,LSAA,CH,4630.000N,0900.000E,500m,5,90,500m,,\n"
                               << QStringList{"row 2, column 5 (lon)", "is not a longitude"};
    QTest::newRow("side") << head + "A,LSAA,CH,4630.000E,00900.000E,500m,5,90,500m,,\n" << QStringList{"row 2, column 4 (lat)"};
    QTest::newRow("minus") << head + "A,LSAA,CH,-430.000N,00900.000E,500m,5,90,500m,,\n" << QStringList{"row 2, column 4 (lat)"};
    QTest::newRow("exponent") << head + "A,LSAA,CH,461e1000N,00900.000E,500m,5,90,500m,,\n" << QStringList{"row 2, column 4 (lat)"};
    QTest::newRow("short row") << head + "A,LSAA,CH,4630.000N,00900.000E,500m,5,90,500m,,\n\nB,,CH,4630.000N,,,5\n"
                               << QStringList{"row 4, column 5 (lon)", "\"\" is not a longitude"};
    QTest::newRow("open quote") << head + "A,\"LSAA,CH,4630.000N,00900.000E,500m,5,90,500m,,\nB,,,\n"
                                << QStringList{"row 2, column 2", "never closed"};
  }
  void brokenFiles_areRefusedWithRowAndColumn() {
    QFETCH(QString, text);
    QFETCH(QStringList, parts);
    const auto report = read(text.toStdString());
    QVERIFY(!report);
    QCOMPARE(report.error().code, Errc::BadFormat);
    for (const QString& part : parts) {
      VP_CONTAINS(report.error().message(), {part.toStdString()});
    }
  }
};

QTEST_APPLESS_MAIN(TestCup)
#include "tst_cup.moc"
