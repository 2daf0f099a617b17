// Targets from the files of other programs.
#include "core/formats/targets/survey_lines.h"
#include "core/formats/targets/target_import.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>
#include <zlib.h>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) {
    all += line + "\n";
  }
  return all;
}

void append(std::string& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i) {
    bytes += static_cast<char>((value >> (8 * i)) & 0xffu);
  }
}

/// A zip archive of one deflated member; `claimed` is the unpacked size that it pretends to have.
std::string zipOf(const std::string& name, const std::string& content, std::uint32_t claimed) {
  std::string packed(compressBound(static_cast<uLong>(content.size())) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  std::string zip = "PK\x03\x04";
  const auto sizes = [&](std::string& out) {
    append(out, 0, 2);  // flags
    append(out, 8, 2);  // deflate
    append(out, 0, 4);  // time
    append(out, 0, 4);  // checksum
    append(out, static_cast<std::uint32_t>(packed.size()), 4);
    append(out, claimed, 4);
    append(out, static_cast<std::uint32_t>(name.size()), 2);
    append(out, 0, 2);
  };
  append(zip, 20, 2);
  sizes(zip);
  zip += name + packed;
  const auto directory = static_cast<std::uint32_t>(zip.size());
  zip += "PK\x01\x02";
  append(zip, 20, 2);
  append(zip, 20, 2);
  sizes(zip);
  append(zip, 0, 2);
  append(zip, 0, 2);
  append(zip, 0, 2);
  append(zip, 0, 4);
  append(zip, 0, 4);
  zip += name;
  const auto size = static_cast<std::uint32_t>(zip.size()) - directory;
  zip += std::string("PK\x05\x06\0\0\0\0\x01\0\x01\0", 12);
  append(zip, size, 4);
  append(zip, directory, 4);
  append(zip, 0, 2);
  return zip;
}

const std::string kKml =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n"
    "<Placemark><name>Hut</name><Point><altitudeMode>absolute</altitudeMode><coordinates>9.8,46.5,2100</coordinates></Point></Placemark>\n"
    "<Placemark><name>Dam</name><Point><altitudeMode>relativeToGround</altitudeMode><coordinates>9.81,46.5,150</coordinates></Point></Placemark>\n"
    "<Placemark><name>Bend</name><Point><coordinates>9.82,46.5,99 9.83,146.5</coordinates></Point></Placemark>\n"
    "<Placemark><name>Wood</name><Polygon><outerBoundaryIs><LinearRing><coordinates>\n"
    "9.9,46.5 9.91,46.5 9.91,46.51 9.9,46.51 9.9,46.5</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>\n"
    "<NetworkLink><Link><href>http://example.org/more.kml</href></Link></NetworkLink>\n"
    "</Document></kml>";

}  // namespace

class TestTargets : public QObject {
  Q_OBJECT
  Folder folder_;

  ImportedTargets read(const std::string& path, const TargetImportOptions& options = {}, const std::vector<mission::Target>& existing = {}) {
    const Result<ImportedTargets> imported = importTargets(path, options, existing);
    if (!imported) {
      qWarning("%s", imported.error().message().c_str());
      return {};
    }
    return *imported;
  }

  std::string refusal(const std::string& name, const std::string& content, const TargetImportOptions& options = {}) {
    const Result<ImportedTargets> imported = importTargets(folder_.write(name, content), options, {});
    return imported ? "read" : imported.error().message();
  }

private slots:
  void gpx_givesWaypointsRoutesAndByChoiceTracks() {
    const std::string path = folder_.write("a.gpx", R"(<?xml version="1.0"?><gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1">
      <wpt lat="46.5" lon="9.8"><ele>1800</ele><name>A &amp; B</name></wpt>
      <wpt lat="96.5" lon="9.8"><name>off</name></wpt>
      <rte><rtept lat="46.6" lon="9.8"/><rtept lat="46.5" lon="9.8"/></rte>
      <trk><trkseg><trkpt lat="46.7" lon="9.8"/></trkseg></trk></gpx>)");
    const ImportedTargets plain = read(path);
    QCOMPARE(plain.targets.size(), std::size_t{2});
    QCOMPARE(plain.targets[0].name, std::string("A & B"));
    QCOMPARE(plain.targets[0].height_m, 100.0);  // an elevation is that of the ground
    QCOMPARE(plain.targets[1].name, std::string("Target 1"));
    VP_CONTAINS(joined(plain.notes),
                {"lat and lon are no place in degrees (line 3)", "at the place of another target", "1 points of tracks were not taken"});
    TargetImportOptions options;
    options.tracks = options.fileHeights = true;
    const ImportedTargets all = read(path, options);
    QCOMPARE(all.targets.size(), std::size_t{3});
    QCOMPARE(all.targets[0].height_m, 1800.0);
    QCOMPARE(all.targets[0].reference, mission::HeightReference::Msl);
  }

  void kml_givesPlacesWithHeightsAndSurveyLines() {
    TargetImportOptions options;
    options.spacing = Length::fromSi(400.0);
    const ImportedTargets found = read(folder_.write("a.kml", kKml), options);
    QCOMPARE(found.targets[0].height_m, 2100.0);
    QCOMPARE(found.targets[0].reference, mission::HeightReference::Msl);
    QCOMPARE(found.targets[1].height_m, 150.0);
    QCOMPARE(found.targets[1].reference, mission::HeightReference::AboveGround);
    QCOMPARE(found.targets[2].height_m, 100.0);
    // 0.01 degrees are 767 x 1112 m, the longest side runs north: two lines 383 m apart
    QCOMPARE(found.surveyLines, 2);
    QCOMPARE(found.targets.size(), std::size_t{7});
    QCOMPARE(found.targets[3].name, std::string("Wood L1 a"));
    VP_CONTAINS(joined(found.notes), {"a coordinate is no place in degrees (line 5)", "link to another file", "2 survey lines"});
  }

  void kmz_isUnpackedWithoutTrustingItsSizes() {
    QCOMPARE(read(folder_.write("a.kmz", zipOf("../../doc.KML", kKml, 1))).targets.size(), read(folder_.write("b.kml", kKml)).targets.size());
  }

  void zipBomb_isStoppedAtItsLimit() {
    const std::string bomb = zipOf("doc.kml", std::string(std::size_t{300} << 20, ' '), 10);
    QVERIFY(bomb.size() < (1u << 20));
    VP_CONTAINS(refusal("bomb.kmz", bomb), {"more than 64 MiB", "bomb.kmz"});
    VP_CONTAINS(refusal("cut.kmz", bomb.substr(0, bomb.size() / 2)), {"damaged or cut short"});
  }

  void entities_areNotExpanded() {
    std::string text = "<?xml version=\"1.0\"?><!DOCTYPE gpx [<!ENTITY a \"aaaaaaaaaa\">";
    for (char c = 'b'; c <= 'p'; ++c) {
      text += std::string("<!ENTITY ") + c + " \"";
      for (int i = 0; i < 10; ++i) {
        text += std::string("&") + static_cast<char>(c - 1) + ";";
      }
      text += "\">";
    }
    text += "]><gpx><wpt lat=\"46.5\" lon=\"9.8\"><name>&p;</name></wpt></gpx>";
    const ImportedTargets found = read(folder_.write("bomb.gpx", text));
    QCOMPARE(found.targets.size(), std::size_t{1});
    QCOMPARE(found.targets[0].name, std::string("&p;"));
  }

  void deepNesting_isSurvived() {
    std::string text = "<gpx>";
    for (int i = 0; i < 500000; ++i) {
      text += "<a>";
    }
    text += "<wpt lat=\"46.5\" lon=\"9.8\"/>";
    for (int i = 0; i < 500000; ++i) {
      text += "</a>";
    }
    QCOMPARE(read(folder_.write("deep.gpx", text + "</gpx>")).targets.size(), std::size_t{1});
  }

  void tables_areReadAsPeopleWriteThem() {
    const ImportedTargets found = read(folder_.write(
        "t.csv",
        "Target;Lat;Lon;Height (m);Reference\nH\xFCtte;46,5;9,8;150;\nGrat;46,6;9,8;2500;msl\nBad;x;9;;\nWorse;46;9;nan;\nHH;46,7;9,8;500 ft;agl\n"));
    QCOMPARE(found.targets.size(), std::size_t{3});
    QCOMPARE(found.targets[0].name, std::string("H\xC3\xBCtte"));
    QCOMPARE(found.targets[0].height_m, 150.0);
    QCOMPARE(found.targets[1].reference, mission::HeightReference::Msl);
    QVERIFY(std::abs(found.targets[2].height_m - 152.4) < 1e-9);
    VP_CONTAINS(joined(found.notes), {"no place in degrees (row 4)", "height makes no sense", "(row 5)"});
  }

  void names_areMadeUniqueAndTidy() {
    const std::vector<mission::Target> existing{{"Hut", {46.0, 9.0}, 100.0, mission::HeightReference::AboveGround}};
    const ImportedTargets found =
        read(folder_.write("n.csv", "name,lat,lon\nHut,46.1,9\nHut,46.2,9\n,46.3,9\n../../etc/passwd,46.4,9\n\"a\nb\",46.5,9\nHut,46.0,9.0\n"), {},
             existing);
    std::vector<std::string> names;
    for (const mission::Target& target : found.targets) {
      names.push_back(target.name);
    }
    QCOMPARE(names, (std::vector<std::string>{"Hut 2", "Hut 3", "Target 1", "../../etc/passwd", "a b"}));
    VP_CONTAINS(joined(found.notes), {"at the place of another target (Hut)"});
  }

  void fittedTargets_keepHeightsAndGiveWay() {
    const std::vector<mission::Target> existing{{"Hut", {46.0, 9.0}, 100.0, mission::HeightReference::AboveGround},
                                                {"Hut 2", {46.1, 9.0}, 100.0, mission::HeightReference::AboveGround}};
    const std::vector<mission::Target> chosen{{"Hut", {46.5, 9.0}, 2100.0, mission::HeightReference::Msl},
                                              {"Dam", {46.6, 9.0}, 80.0, mission::HeightReference::AboveGround},
                                              {"Top", {46.1, 9.000001}, 80.0, mission::HeightReference::AboveGround}};
    const ImportedTargets fitted = fitTargets(chosen, existing);
    QCOMPARE(fitted.targets.size(), std::size_t(2));
    QVERIFY((fitted.targets[0] == mission::Target{"Hut 3", {46.5, 9.0}, 2100.0, mission::HeightReference::Msl}));
    QVERIFY(fitted.targets[1] == chosen[1]);
    VP_CONTAINS(joined(fitted.notes), {"at the place of another target (Top)"});
    QVERIFY(fitTargets(chosen, {}).targets == chosen && fitTargets(chosen, {}).notes.empty());
    QVERIFY(fitTargets({}, existing).targets.empty());
  }

  void most_canBeRaised() {
    std::string text = "name,lat,lon\n";
    for (int i = 0; i < 5001; ++i) {
      text += "T,46." + std::to_string(10000 + i) + ",9\n";
    }
    TargetImportOptions options;
    VP_CONTAINS(refusal("m.csv", text), {"5001 places", "at most 5000"});
    options.most = 5001;
    QCOMPARE(read(folder_.write("m.csv", text), options).targets.size(), std::size_t(5001));
  }

  void tracksAlone_areAnErrorOnlyWhereNobodyCanAskForThem() {
    const std::string gpx = R"(<gpx version="1.1"><trk><trkseg><trkpt lat="46.5" lon="9.5"/></trkseg></trk></gpx>)";
    VP_CONTAINS(refusal("t.gpx", gpx), {"no places for targets", "1 points of tracks"});
    TargetImportOptions options;
    options.tracksAlone = true;
    const Result<ImportedTargets> none = importTargets(folder_.write("t.gpx", gpx), options, {});
    QVERIFY(none && none->targets.empty());
    VP_CONTAINS(joined(none->notes), {"points of tracks were not taken"});
    VP_CONTAINS(refusal("e.gpx", "<gpx/>", options), {"no places for targets"});
  }

  void stoppedReading_givesNothing_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("text");
    QTest::newRow("table") << "a.csv"
                           << "name,lat,lon\nHut,46.5,9.5\n";
    QTest::newRow("cup") << "a.cup"
                         << "name,code,country,lat,lon,elev,style\nHut,,CH,4632.046N,00953.046E,500m,1\n";
    QTest::newRow("gpx") << "a.gpx"
                         << R"(<gpx version="1.1"><wpt lat="46.5" lon="9.5"/></gpx>)";
    QTest::newRow("kml") << "a.kml" << QString::fromStdString(kKml);
    QTest::newRow("geojson") << "a.geojson"
                             << R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[9.5,46.5]}})";
  }

  void stoppedReading_givesNothing() {
    QFETCH(QString, name);
    QFETCH(QString, text);
    const std::string path = folder_.write(name.toStdString(), text.toStdString());
    QVERIFY(importTargets(path, {}, {}));
    std::stop_source stop;
    stop.request_stop();
    const Result<ImportedTargets> imported = importTargets(path, {}, {}, Job(stop.get_token()));
    QVERIFY(!imported && imported.error().code == Errc::Cancelled);
  }

  void millionRows_areRefusedWithTheirNumber() {
    std::string text = "name,lat,lon\n";
    for (int i = 0; i < 1000000; ++i) {
      text += "T,46." + std::to_string(i) + ",9\n";
    }
    VP_CONTAINS(refusal("m.csv", text), {"1000000 places", "at most 5000"});
  }

  void geoJson_givesPointsLinesAndAreas() {
    const ImportedTargets found = read(folder_.write("g.geojson", R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"name":"P","altitude_ft":9000},"geometry":{"type":"Point","coordinates":[9.8,46.5]}},
      {"type":"Feature","properties":{"name":"L"},"geometry":{"type":"LineString","coordinates":[[9.7,46.5],[9.7,46.6]]}},
      {"type":"Feature","properties":{"name":"X"},"geometry":{"type":"Point","coordinates":[46.5,99.8]}},
      {"type":"Feature","properties":{"name":"A"},"geometry":{"type":"Polygon","coordinates":[[[9,46],[9.02,46],[9.02,46.004],[9,46.004],[9,46]],
        [[9.005,46.001],[9.015,46.001],[9.015,46.003],[9.005,46.003],[9.005,46.001]]]}}]})"));
    QCOMPARE(found.targets.size(), std::size_t{7});
    QVERIFY(std::abs(found.targets[0].height_m - 2743.2) < 1e-9);
    QCOMPARE(found.targets[2].name, std::string("L 2"));
    QCOMPARE(found.surveyLines, 2);  // one line through the middle, cut in two by the hole
    VP_CONTAINS(joined(found.notes), {"no places in degrees of longitude and latitude (line 4)"});
  }

  void qgcPlan_givesWaypointsWithHeights() {
    const ImportedTargets found =
        read(folder_.write("q.plan", R"({"fileType":"Plan","version":1,"mission":{"plannedHomePosition":[-35.36,149.16,580],"items":[
      {"type":"SimpleItem","command":22,"frame":3,"params":[15,0,0,null,-35.36,149.16,50]},
      {"type":"SimpleItem","command":16,"frame":3,"params":[0,0,0,null,-35.35,149.18,120]},
      {"type":"SimpleItem","command":16,"frame":0,"params":[0,0,0,null,-35.34,149.18,784]},
      {"type":"SimpleItem","command":16,"frame":10,"params":[0,0,0,null,-35.33,149.18,90]},
      {"type":"ComplexItem","complexItemType":"survey","polygon":[[-35.3,149.1],[-35.3,149.11],[-35.31,149.11]]}]}})"));
    QCOMPARE(found.targets[0].height_m, 700.0);
    QCOMPARE(found.targets[0].reference, mission::HeightReference::Msl);
    QCOMPARE(found.targets[1].height_m, 784.0);
    QCOMPARE(found.targets[2].height_m, 90.0);
    QCOMPARE(found.targets[2].reference, mission::HeightReference::AboveGround);
    QVERIFY(found.surveyLines >= 2);
    VP_CONTAINS(joined(found.notes), {"no waypoint (take-off, landing or another command) (item 1)"});
  }

  void survey_coversTheAreaAndStaysInside() {
    const std::uint64_t seed = 20261124;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int round = 0; round < 10000; ++round) {
      std::vector<geo::LatLon> ring;  // a star about the middle, so it does not cross itself
      const int corners = 3 + static_cast<int>(random() % 9);
      for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * Angle::kPi * (i + 0.4 * unit(random)) / corners;
        const double reach = 0.005 + 0.02 * unit(random);
        ring.push_back({46.0 + reach * std::sin(angle), 9.0 + reach * std::cos(angle)});
      }
      const Angle course = Angle::degrees(360.0 * unit(random));
      const double spacing = 200.0 + 800.0 * unit(random);
      const auto lines = surveyLines(ring, {}, Length::fromSi(spacing), course);
      QVERIFY(lines && !lines->empty());
      const geo::LocalFrame frame({46.0, 9.0});
      std::vector<geo::Point> placed;
      for (const geo::LatLon& corner : ring) {
        placed.push_back(frame.toPoint(corner));
      }
      const auto edgeDistance = [&](geo::Point p) {
        double least = 1e300;
        for (std::size_t i = 0; i < placed.size(); ++i) {
          const geo::Point a = placed[i];
          const geo::Point b = placed[(i + 1) % placed.size()];
          const double length = geo::distance(a, b);
          const double t = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (length * length), 0.0, 1.0);
          least = std::min(least, geo::distance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
        }
        return least;
      };
      for (const SurveyLine& line : *lines) {
        QVERIFY(edgeDistance(frame.toPoint(line.from)) < 0.5 && edgeDistance(frame.toPoint(line.to)) < 0.5);  // ends lie on the outline
        const double flown = geo::geodesicCourse(line.from, line.to).degrees();
        const double off = std::fmod(std::abs(flown - course.degrees()), 180.0);
        QVERIFY2(std::min(off, 180.0 - off) < 0.05, qPrintable(QString::number(off)));
      }
      for (const geo::Point& corner : placed) {  // no corner farther than half the spacing across the lines from one
        const geo::Point along{std::cos(frame.headingOf(course, frame.origin())), std::sin(frame.headingOf(course, frame.origin()))};
        double least = 1e300;
        for (const SurveyLine& line : *lines) {
          const geo::Point a = frame.toPoint(line.from);
          least = std::min(least, std::abs((corner.x - a.x) * along.y - (corner.y - a.y) * along.x));
        }
        QVERIFY2(least <= 0.5 * spacing + 3.0, qPrintable(QString::number(least)));
      }
    }
  }

  void survey_withTooManyLines_isRefused() {
    TargetImportOptions options;
    options.spacing = Length::fromSi(0.01);
    VP_CONTAINS(refusal("w.kml", kKml, options), {"survey lines", "choose a wider one", "Wood"});
  }

  void otherFiles_areRefusedWithASentence() {
    VP_CONTAINS(refusal("x.bin", std::string("\0\1\2\3", 4)), {"this is no file of targets"});
    VP_CONTAINS(refusal("x.gpx", "<gpx><wpt lat=\"46\" lon=\"9\">"), {"line 1", "damaged or cut short"});
    VP_CONTAINS(refusal("e.gpx", "<gpx/>"), {"no places for targets"});
    VP_CONTAINS(refusal("x.json", "{\"type\":\"Feature\", \"coordinates\""), {"x.json"});
    VP_CONTAINS(refusal("", ""), {"folder"});
    QCOMPARE(targetFileOf(folder_.path("missing")), TargetFile::None);
  }

  void realFiles_areRead_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("targets");
    QTest::newRow("gpx route") << "gpsbabel_route.gpx" << -1;
    QTest::newRow("lnmpln") << "lnm_VFR_LFLP_LFLE_alps.lnmpln" << -1;
    QTest::newRow("qgc") << "qgc_ArduPilotSITL-ArduPlane_canberra.plan" << -1;
    QTest::newRow("cup") << "seeyou_v1_waypoints.cup" << 5;
    QTest::newRow("cup 2022") << "seeyou_v2_rwwidth_waypoints.cup" << -1;
  }
  void realFiles_areRead() {
    QFETCH(QString, file);
    QFETCH(int, targets);
    const auto data = samples::dataFolder();
    if (!data) {
      QSKIP("the folder of real data is absent");
    }
    const auto imported = importTargets(*data + "/flightplans/" + file.toStdString(), {}, {});
    QVERIFY2(imported, imported ? "" : imported.error().message().c_str());
    qInfo("%zu targets; %s", imported->targets.size(), joined(imported->notes).c_str());
    QVERIFY(targets < 0 || static_cast<int>(imported->targets.size()) == targets);
  }
};

QTEST_APPLESS_MAIN(TestTargets)
#include "tst_targets.moc"
