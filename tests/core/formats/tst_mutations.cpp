// Damaged files of every kind: readers answer with a result or an error, never otherwise.
#include "core/formats/airfields.h"
#include "core/formats/airspace/openair.h"
#include "core/formats/mission_file.h"
#include "core/formats/plan_file.h"
#include "core/formats/targets/target_import.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <functional>
#include <random>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

constexpr int kCases = 10000;

/// Changes a text in one to four places: a byte, a cut, a copy, a swap of numbers and words that matter.
std::string mutated(std::string text, std::mt19937_64& random) {
  static const std::vector<std::string> kPieces{"\"",
                                                ",",
                                                "{",
                                                "}",
                                                "[",
                                                "]",
                                                ":",
                                                "\n",
                                                "\r\n",
                                                "null",
                                                "true",
                                                "-1",
                                                "1e999",
                                                "NaN",
                                                "99999999999999999999",
                                                "0.0000001",
                                                "\xff",
                                                "\\u0000",
                                                "\\ud800",
                                                "-",
                                                ".",
                                                "e",
                                                " ",
                                                "S",
                                                "W",
                                                "\"\"",
                                                "360",
                                                std::string(1, '\0'),
                                                "-----Related Tasks-----"};
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
  const std::size_t changes = 1 + below(4);
  if (below(2) == 0) {  // only digits, so that the structure stands and the values are tried
    for (std::size_t i = 0; i < changes; ++i) {
      const std::size_t digit = text.find_first_of("0123456789", below(text.size()));
      if (digit != std::string::npos) {
        text[digit] = "0123456789-.e"[below(13)];
      }
    }
    return text;
  }
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 3:
        text.replace(at, std::min<std::size_t>(1 + below(5), text.size() - at), kPieces[below(kPieces.size())]);
        break;
      case 4:
        text.insert(at, text.substr(below(text.size()), 1 + below(40)));
        break;
      default:
        if (below(8) == 0) {
          text.resize(at);
        } else {
          std::swap(text[at], text[below(text.size())]);
        }
        break;
    }
  }
  return text;
}

/// What an error must be like whatever happened.
bool isPresentable(const Error& error) {
  return !error.what.empty() && !error.where.empty() && error.message().size() < 2000;
}

}  // namespace

class TestMutations : public QObject {
  Q_OBJECT
  Folder folder_;

  /// Reads kCases damaged forms; `read` gives the error or nothing.
  void damage(const std::string& name, const std::string& text, std::uint64_t seed,
              const std::function<std::optional<Error>(const std::string&)>& read) {
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    int refused = 0;
    for (int i = 0; i < kCases; ++i) {
      const std::string path = folder_.write(std::to_string(i) + name, mutated(text, random));  // a new name: rewriting a file waits for the disk
      try {
        if (const std::optional<Error> error = read(path)) {
          ++refused;
          QVERIFY2(isPresentable(*error), error->message().c_str());
        }
      } catch (const std::exception& exception) {
        QFAIL(("case " + std::to_string(i) + " threw " + exception.what()).c_str());
      }
      std::filesystem::remove(path);
    }
    qInfo("%d of %d refused", refused, kCases);
    QVERIFY(refused > 0 && refused < kCases);
  }

private slots:
  void damagedMissions_areReadOrRefused() {
    QVERIFY(writeMission(samples::sampleMission(), folder_.path("good.vpm")));
    damage("m.vpm", samples::readBytes(folder_.path("good.vpm")), 1, [](const std::string& path) -> std::optional<Error> {
      const auto mission = readMission(path);
      return mission ? std::nullopt : std::optional(mission.error());
    });
  }

  void damagedPlans_areReadOrRefused() {
    mission::Plan plan = samples::samplePlan(60.0, 20.0);
    damage("p.vpp", planToJson(plan), 2, [](const std::string& path) -> std::optional<Error> {
      const auto read = readPlan(path);
      if (read) {
        planToJson(*read);  // what was read can be written again
      }
      return read ? std::nullopt : std::optional(read.error());
    });
  }

  void damagedRunways_areReadOrRefused() {
    const std::string airports =
        folder_.write("airports.csv", "ident,type,name,latitude_deg,longitude_deg,elevation_ft\nAAA,small_airport,\"A \"\"x\"\"\",46.5,9.0,1000\n");
    const std::string runways =
        "airport_ident,length_ft,width_ft,surface,lighted,closed,le_ident,le_latitude_deg,le_longitude_deg,le_elevation_ft,le_heading_degT,"
        "le_displaced_threshold_ft,he_ident,he_latitude_deg,he_longitude_deg,he_elevation_ft,he_heading_degT,he_displaced_threshold_ft\n"
        "AAA,3937,98,\"ASP, good\",1,0,09,46.5,8.9921815,980,90,,27,46.5,9.0078185,1010,270,328\nAAA,3937,98,TURF,1,0,18,,,980,,,36,,,1010,,\n";
    damage("r.csv", runways, 3, [&](const std::string& path) -> std::optional<Error> {
      const auto report = readOurAirports(airports, path, {}, {});
      return report ? std::nullopt : std::optional(report.error());
    });
  }

  void damagedAirports_areReadOrRefused() {
    const std::string runways = folder_.path("r2.csv");
    folder_.write("r2.csv",
                  "airport_ident,length_ft,width_ft,surface,lighted,closed,le_ident,le_latitude_deg,le_longitude_deg,le_elevation_ft,le_heading_degT,"
                  "le_displaced_threshold_ft,he_ident,he_latitude_deg,he_longitude_deg,he_elevation_ft,he_heading_degT,he_displaced_threshold_ft\n"
                  "AAA,3937,98,TURF,1,0,18,,,980,,,36,,,1010,,\n");
    damage("a.csv",
           "ident,type,name,latitude_deg,longitude_deg,elevation_ft\nAAA,small_airport,\"A \"\"x\"\"\",46.5,9.0,1000\nBBB,heliport,B,46.5,9.0,\n", 4,
           [&](const std::string& path) -> std::optional<Error> {
             const auto report = readOurAirports(path, runways, {}, {});
             return report ? std::nullopt : std::optional(report.error());
           });
  }

  void damagedCupFiles_areReadOrRefused() {
    damage("c.cup",
           "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\n\"Alpha "
           "\"\"A\"\"\",LSAA,CH,4630.000N,00900.000E,500.0m,5,040,1000.0m,128.475,\"x\"\n"
           "Z\xFCrich,,CH,4630.000N,00900.000E,1640ft,2,90,0.5nm,,\n-----Related Tasks-----\n\"T\",\"Alpha\"\n",
           5, [](const std::string& path) -> std::optional<Error> {
             const auto report = readCup(path, {}, {});
             return report ? std::nullopt : std::optional(report.error());
           });
  }

  void damagedAptDat_isReadOrRefused() {
    damage("x.dat",
           "I\n1100 Version\n1 3799 0 1 E46 02 Ranch\n"
           "100 30.48 4 0 0.25 0 2 0 15 29.88 -103.70 100.00 0.00 1 0 0 0 33 29.86 -103.69 0.00 0.00 1 0 0 0\n"
           "101 30 0 09 29.5 -103.7 27 29.5 -103.69\n1302 icao_code KE46\n99\n",
           6, [](const std::string& path) -> std::optional<Error> {
             const auto report = readAptDat(path, {}, {});
             return report ? std::nullopt : std::optional(report.error());
           });
  }

  void damagedOwnFields_areReadOrRefused() {
    damage("o.csv", "airport,lat,lon,course,length_m,end_lat,end_lon,surface,one_way\nA,46.5,9.8,90,600 m,,,grass,no\nB,46.5,9.8,,,46.5,9.81,,yes\n",
           7, [](const std::string& path) -> std::optional<Error> {
             const auto report = readOwnTable(path, {}, {});
             return report ? std::nullopt : std::optional(report.error());
           });
    damage("o.json",
           R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"runway":"09","length":500},"geometry":{"type":"LineString",)"
           R"("coordinates":[[9.75,46.5],[9.76,46.5,900]]}}]})",
           8, [](const std::string& path) -> std::optional<Error> {
             const auto report = readOwnGeoJson(path, {}, {});
             return report ? std::nullopt : std::optional(report.error());
           });
  }

  void damagedOpenAir_isReadOrRefused() {
    damage(
        "a.txt",
        "* x\nAC C\nAN Circle\nAL GND\nAH 2000 ft\nV X=46:30.0 N 009:45.0 E\nDC 5\nAC D\nAN Arc\nAL FL 65\nAH UNL\nV X=46:30.0 N 009:45.0 E\nV D=-\n"
        "DA 5,90,0\nDB 46:35 N 009:45 E,46:30 N 009:52 E\nDP 46:30.0 N 009:45.0 E\n",
        10, [](const std::string& path) -> std::optional<Error> {
          const auto report = readOpenAir(path);
          return report ? std::nullopt : std::optional(report.error());
        });
  }

  void damagedTargets_areReadOrRefused_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("gpx") << "t.gpx"
                         << QByteArray(
                                "<?xml version=\"1.0\" encoding=\"UTF-8\"?><gpx><wpt lat=\"46.5\" lon=\"9.8\"><ele>1800</ele><name>A &amp; "
                                "B</name></wpt><rte><rtept lat=\"46.6\" lon=\"9.8\"/></rte></gpx>");
    QTest::newRow("kml") << "t.kml"
                         << QByteArray(
                                "<kml><Placemark><name>A</name><Point><altitudeMode>absolute</altitudeMode><coordinates>9.8,46.5,2100"
                                "</coordinates></Point></Placemark><Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>9.9,46.5 "
                                "9.91,46.5 9.91,46.51 9.9,46.5</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></kml>");
    QTest::newRow("lnmpln") << "t.lnmpln"
                            << QByteArray(
                                   "<LittleNavmap><Flightplan><Waypoints><Waypoint><Ident>A</Ident><Type>USER</Type><Pos Lon=\"9.8\" "
                                   "Lat=\"46.5\" Alt=\"9000\"/></Waypoint></Waypoints></Flightplan></LittleNavmap>");
    QTest::newRow("plan") << "t.plan"
                          << QByteArray(
                                 R"({"fileType":"Plan","mission":{"plannedHomePosition":[46,9,500],"items":[{"type":"SimpleItem","command":16,)"
                                 R"("frame":3,"params":[0,0,0,null,46.5,9.8,120]},{"type":"ComplexItem","polygon":[[46,9],[46,9.1],[46.1,9]]}]}})");
    QTest::newRow("geojson") << "t.json"
                             << QByteArray(
                                    R"({"type":"Feature","properties":{"name":"A","height":120},"geometry":{"type":"Polygon","coordinates":[[[9,46],)"
                                    R"([9.02,46],[9.02,46.01],[9,46]]]}})");
    QTest::newRow("table") << "t.csv" << QByteArray("name;lat;lon;height_m;reference\nA;46,5;9,8;150;agl\nB;46,6;9,8;2500;msl\n");
    QTest::newRow("cup") << "t.cup" << QByteArray("name,code,country,lat,lon,elev,style\n\"A\",A,CH,4630.000N,00900.000E,500.0m,1\n");
  }
  void damagedTargets_areReadOrRefused() {
    QFETCH(QString, name);
    QFETCH(QByteArray, text);
    damage(name.toStdString(), text.toStdString(), 9, [](const std::string& path) -> std::optional<Error> {
      const auto imported = importTargets(path, {}, {});
      return imported ? std::nullopt : std::optional(imported.error());
    });
  }
};

QTEST_APPLESS_MAIN(TestMutations)
#include "tst_mutations.moc"
