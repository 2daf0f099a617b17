// OpenAir airspace files.
#include "core/formats/airspace/openair.h"
#include "core/formats/airspace/openair_fields.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;
using namespace vp::formats;
using samples::Folder;
using Kind = mission::AirspaceLimit::Kind;

namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) {
    all += line + "\n";
  }
  return all;
}

const mission::Airspace* find(const AirspaceReport& report, const std::string& name) {
  const auto found = std::find_if(report.airspaces.begin(), report.airspaces.end(), [&](const auto& airspace) { return airspace.name == name; });
  return found == report.airspaces.end() ? nullptr : &*found;
}

}  // namespace

class TestOpenAir : public QObject {
  Q_OBJECT
  Folder folder_;

private slots:
  void limits_areUnderstood_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("metres");
    const auto row = [](const char* text, Kind kind, double metres) { QTest::newRow(text) << text << static_cast<int>(kind) << metres; };
    row("FL 65", Kind::FlightLevel, 1981.2);
    row("FL100", Kind::FlightLevel, 3048.0);
    row("5000 STD", Kind::FlightLevel, 1524.0);
    row("2000 ft", Kind::Msl, 609.6);
    row("4500ft MSL", Kind::Msl, 1371.6);
    row("4500MSL", Kind::Msl, 1371.6);
    row("3000 AMSL", Kind::Msl, 914.4);
    row("450m", Kind::Msl, 450.0);
    row("450 m MSL", Kind::Msl, 450.0);
    row("100m GND", Kind::AboveGround, 100.0);
    row("100 Agl", Kind::AboveGround, 30.48);
    row("1000ft AGL", Kind::AboveGround, 304.8);
    row("0 GND", Kind::Surface, 0.0);
    row("-100 ft AGL", Kind::Surface, 0.0);
    row("-500 ft", Kind::Msl, -152.4);
    row("4,500 ft MSL", Kind::Msl, 1371.6);
    row("SFC", Kind::Surface, 0.0);
    row("GND", Kind::Surface, 0.0);
    row("UNLIM", Kind::Unlimited, 0.0);
    row("UNL FT", Kind::Unlimited, 0.0);
    row("NOTAM", Kind::Unknown, 0.0);
    row("", Kind::Unknown, 0.0);
    row("1e999 ft", Kind::Unknown, 0.0);
  }
  void limits_areUnderstood() {
    QFETCH(QString, text);
    QFETCH(int, kind);
    QFETCH(double, metres);
    const mission::AirspaceLimit limit = parseOpenAirLimit(text.toStdString(), false);
    QCOMPARE(static_cast<int>(limit.kind), kind);
    QVERIFY2(std::abs(limit.metres - metres) < 1e-9, qPrintable(QString::number(limit.metres)));
  }

  void places_areUnderstood() {
    QCOMPARE(parseOpenAirPlace("01:30:30 S 001:30:30 W")->latitude_deg, -(1.0 + 30.0 / 60.0 + 30.0 / 3600.0));
    QCOMPARE(parseOpenAirPlace("46:30.5N 009:45.0E")->longitude_deg, 9.75);
    QCOMPARE(parseOpenAirPlace("46.5 n 9.75 w")->longitude_deg, -9.75);
    for (const char* text : {"", "46 N", "91:00 N 009:00 E", "46:99 N 009:00 E", "N E", "46:00:00:00 N 9 E", "nan N 9 E", "46 N 9 E 7"}) {
      QVERIFY2(!parseOpenAirPlace(text), text);
    }
  }

  void circlesAndArcs_stayWithinAMetre() {
    const auto report =
        readOpenAir(folder_.write("a.txt",
                                  "AC C\nAN Circle\nAL GND\nAH 2000 ft\nV X=46:30.0 N 009:45.0 E\nDC 5\n"
                                  "AC D\nAN Arc\nAL GND\nAH 2000 ft\nV X=46:30.0 N 009:45.0 E\nV D=-\nDA 5,90,0\nDP 46:30.0 N 009:45.0 E\n"));
    QVERIFY(report);
    const geo::LatLon centre{46.5, 9.75};
    const mission::Airspace& circle = report->airspaces[0];
    for (std::size_t i = 0; i < circle.outline.size(); ++i) {
      const geo::LatLon a = circle.outline[i];
      const geo::LatLon b = circle.outline[(i + 1) % circle.outline.size()];
      const geo::LatLon middle{(a.latitude_deg + b.latitude_deg) / 2.0, (a.longitude_deg + b.longitude_deg) / 2.0};
      QVERIFY(geo::geodesicDistance(centre, a).si() < 9260.0 + 1.1);
      QVERIFY(geo::geodesicDistance(centre, middle).si() > 9260.0 - 0.1);  // nowhere inside the circle
    }
    // counter-clockwise from east to north is three quarters of the way round the other side
    const mission::Airspace& arc = report->airspaces[1];
    QCOMPARE(arc.kind, std::string("D"));
    const auto isNorthEast = [&](const geo::LatLon& p) {
      return p.latitude_deg > centre.latitude_deg + 1e-3 && p.longitude_deg > centre.longitude_deg + 1e-3;
    };
    QVERIFY(std::all_of(arc.outline.begin() + 1, arc.outline.end() - 2, isNorthEast));
  }

  void incompleteAirspaces_areNamedByLine() {
    const auto report =
        readOpenAir(folder_.write("b.txt",
                                  "* comment\nAC C\nAN Good\nAL NOTAM\nAH FL 100\nDP 46:00 N 009:00 E\nDP 46:00 N 009:10 E\nDP 46:10 N 009:00 E\n"
                                  "AC D\nAN Two corners\nAL GND\nAH FL 100\nDP 46:00 N 009:00 E\nDP 46:00 N 009:10 E\n"
                                  "AC R\nAN No floor\nAH FL 100\nDP 46:00 N 009:00 E\nDP 46:00 N 009:10 E\nDP 46:10 N 009:00 E\n"
                                  "AC R\nAN Lost\nAL GND\nAH FL 100\nDC 5\n"));
    QVERIFY(report);
    QCOMPARE(report->airspaces.size(), std::size_t{1});
    VP_CONTAINS(joined(report->notes),
                {"1 limits given in words: a floor counts as the surface (line 4)", "less than three corners (Two corners in line 9)",
                 "floor or ceiling missing (No floor in line 15)", "circle without centre", "line 25", "(Lost in line 21)"});
  }

  void otherFiles_areRefused() {
    const auto none = readOpenAir(folder_.write("c.txt", "hello\n"));
    QVERIFY(!none);
    VP_CONTAINS(none.error().message(), {"no airspace", "c.txt"});
    QVERIFY(!readOpenAir(folder_.write("d.txt", std::string("AC C\0", 5))));
    QVERIFY(!readOpenAir(folder_.path("missing")));
  }

  void nonsense_isLeftOutWithASentence_data() {
    QTest::addColumn<QByteArray>("records");
    QTest::addColumn<QString>("says");
    QTest::newRow("NaN corner") << QByteArray("DP nan N nan E\n") << "corner is no place";
    QTest::newRow("infinite corner") << QByteArray("DP inf N 009:00 E\n") << "corner is no place";
    QTest::newRow("beyond the pole") << QByteArray("DP 91:00 N 009:00 E\n") << "corner is no place";
    QTest::newRow("minutes above 60") << QByteArray("DP 46:75:00 N 009:00 E\n") << "corner is no place";
    QTest::newRow("NaN centre") << QByteArray("V X=nan N nan E\nDC 5\n") << "centre is no place";
    QTest::newRow("NaN radius") << QByteArray("V X=46:00 N 009:00 E\nDC nan\n") << "radius that makes no sense";
    QTest::newRow("radius around the world") << QByteArray("V X=46:00 N 009:00 E\nDC 1e9\n") << "radius that makes no sense";
    QTest::newRow("negative radius") << QByteArray("V X=46:00 N 009:00 E\nDC -5\n") << "radius that makes no sense";
    QTest::newRow("NaN angles") << QByteArray("V X=46:00 N 009:00 E\nDA 5,nan,inf\n") << "make no sense";
    QTest::newRow("arc between nothings") << QByteArray("V X=46:00 N 009:00 E\nDB ,\n") << "arc without centre";
  }
  void nonsense_isLeftOutWithASentence() {
    QFETCH(QByteArray, records);
    QFETCH(QString, says);
    const std::string good = "AC C\nAN Good\nAL GND\nAH FL 100\nDP 46:00 N 009:00 E\nDP 46:00 N 009:10 E\nDP 46:10 N 009:00 E\n";
    const auto report = readOpenAir(folder_.write("n.txt", "AC R\nAN Bad\nAL GND\nAH FL 100\n" + records.toStdString() + good));
    QVERIFY(report);
    QCOMPARE(report->airspaces.size(), std::size_t{1});
    QCOMPARE(report->airspaces.front().name, std::string("Good"));
    VP_CONTAINS(joined(report->notes), {says.toStdString(), "Bad in line 1"});
  }

  void limitsThatAreNoNumbers_countAsTheWorst() {
    for (const char* text : {"nan", "FL nan", "inf ft MSL", "1e400 m", "-nan AGL", "4'500 ft", "FL 200000", "FL-95", "199999 m", "1,5 ft MSL"}) {
      for (const bool isFloor : {false, true}) {
        QVERIFY2(parseOpenAirLimit(text, isFloor) == (mission::AirspaceLimit{Kind::Unknown, 0.0}), text);
      }
    }
  }

  void hugeBinaryAndWronglyEncodedFiles_areReadOrRefused() {
    // 10^6 rows: 100 000 triangles of which every second lacks a ceiling, then one airspace without end
    std::string rows;
    for (int i = 0; i < 100'000; ++i) {
      rows += i % 2 == 0 ? "AC C\nAN Zone\nAL GND\nAH FL 100\n" : "AC C\nAN Zone\nAL GND\n";
      rows += "DP 46:00 N 009:00 E\nDP 46:00 N 009:10 E\nDP 46:10 N 009:00 E\n";
    }
    rows += "AC R\nAN Endless\nAL GND\nAH UNL\n";
    for (int i = 0; i < 350'000; ++i) {
      rows += i % 2 == 0 ? "DP 46:00 N 009:00 E\n" : "DP 46:00 N 009:10 E\n";
    }
    const auto many = readOpenAir(folder_.write("many.txt", rows));
    QVERIFY(many);
    QCOMPARE(many->airspaces.size(), std::size_t{50'000});
    VP_CONTAINS(joined(many->notes), {"50000", "floor or ceiling missing", "too many corners"});
    QVERIFY2(joined(many->notes).size() < 2000, joined(many->notes).c_str());

    std::string noise(200'000, '\0');
    for (std::size_t i = 0; i < noise.size(); ++i) {
      noise[i] = static_cast<char>((i * 2654435761U) >> 13U);
    }
    const auto binary = readOpenAir(folder_.write("noise.txt", noise));
    QVERIFY(!binary && !binary.error().message().empty());

    const std::string latin = "AC R\nAN Z\xfcrich\nAL GND\nAH FL 100\nDP 46:00 N 009:00 E\nDP 46:00 N 009:10 E\nDP 46:10 N 009:00 E\n";
    const auto western = readOpenAir(folder_.write("latin.txt", latin));
    QVERIFY(western);
    QCOMPARE(western->airspaces.front().name, std::string("Z\xc3\xbcrich"));

    std::string wide("\xff\xfe", 2);  // UTF-16
    for (const char letter : latin) {
      wide += letter;
      wide += '\0';
    }
    const auto utf16 = readOpenAir(folder_.write("wide.txt", wide));
    QVERIFY(!utf16 && !utf16.error().message().empty());
  }

  void realFiles_areRead_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("airspaces");
    QTest::newRow("Australia") << "AirspaceAus-DAA.txt" << 662;
    QTest::newRow("competition") << "DE-ASP-HahnweideComp2017-XCSoar.txt" << 468;
    QTest::newRow("Germany") << "germany_2008_MBG08_openair.txt" << 234;
    QTest::newRow("parser test 1") << "xcsoar_openair_testcases.txt" << 24;
    QTest::newRow("parser test 2") << "xcsoar_openair_2_testcases.txt" << 4;
  }
  void realFiles_areRead() {
    QFETCH(QString, file);
    QFETCH(int, airspaces);
    const auto data = samples::dataFolder();
    if (!data) {
      QSKIP("the folder of real data is absent");
    }
    const auto report = readOpenAir(*data + "/airspace/" + file.toStdString());
    QVERIFY2(report, report ? "" : report.error().message().c_str());
    qInfo("%zu airspaces; %s", report->airspaces.size(), joined(report->notes).c_str());
    QVERIFY(static_cast<int>(report->airspaces.size()) * 100 >= airspaces * 97);
    if (file.startsWith(QStringLiteral("xcsoar_openair_2"))) {
      QCOMPARE(find(*report, "Type-GLIDING_SECTOR-Test")->kind, std::string("GSEC"));
      QCOMPARE(find(*report, "Type-TMA-Test")->kind, std::string("E"));
    }
  }
};

QTEST_APPLESS_MAIN(TestOpenAir)
#include "tst_openair.moc"
