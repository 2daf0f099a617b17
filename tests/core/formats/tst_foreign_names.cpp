// What files may name: a mission, or any other file, from the mail makes the program neither read devices nor ask servers nor write anything.
#include "core/base/local_file.h"
#include "core/formats/aircraft_file.h"
#include "core/formats/airfields.h"
#include "core/formats/airspace/openair.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"
#include "core/formats/population_file.h"
#include "core/formats/targets/target_import.h"
#include "core/formats/weather_file.h"
#include "core/terrain/gdal_support.h"
#include "core/terrain/terrain_reader.h"
#include "tests/core/formats/format_samples.h"
#include "tests/support/file_server.h"

#include <QElapsedTimer>
#include <gdal_priv.h>

#include <functional>
#include <set>
#include <sys/stat.h>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

/// Every way that a name leads to a reader; each gives the error or nothing.
using Attempt = std::pair<const char*, std::function<std::optional<Error>(const std::string&)>>;

template <typename T>
std::optional<Error> errorIn(const Result<T>& result) {
  return result ? std::nullopt : std::optional(result.error());
}

const std::vector<Attempt>& attempts() {
  static const std::vector<Attempt> list{
      {"mission", [](const std::string& path) { return errorIn(readMission(path)); }},
      {"draft", [](const std::string& path) { return errorIn(readDraft(path)); }},
      {"plan", [](const std::string& path) { return errorIn(readPlan(path)); }},
      {"aircraft", [](const std::string& path) { return errorIn(readAircraft(path)); }},
      {"aircraft of a mission",
       [](const std::string& path) {
         return errorIn(parseMission(
             R"({"format":"volplane-mission","version":1,"name":"m","terrain":["t.tif"],"aircraft":")" + path + R"(","targets":[]})", "/x/m.vpm"));
       }},
      {"terrain", [](const std::string& path) { return errorIn(terrain::inspectTerrain({path})); }},
      {"terrain of a mission", [](const std::string& path) { return errorIn(loadTerrain({path}, "/nowhere", Job{})); }},
      {"checksum", [](const std::string& path) { return errorIn(terrain::sha256OfFile(path)); }},
      {"airfields",
       [](const std::string& path) {
         return errorIn(readAirfields({path, ""}, "/nowhere", {}, std::nullopt));
       }},
      {"runways", [](const std::string& path) { return errorIn(readOurAirports(path, path, {}, std::nullopt)); }},
      {"airspace", [](const std::string& path) { return isOpenAir(path) ? std::nullopt : errorIn(readOpenAir(path)); }},
      {"targets", [](const std::string& path) { return errorIn(importTargets(path, {}, {})); }},
      {"population", [](const std::string& path) { return isPopulationFile(path) ? std::nullopt : errorIn(readPopulation(path)); }},
      {"weather", [](const std::string& path) { return isWeatherFile(path) ? std::nullopt : errorIn(readWeather(path)); }},
  };
  return list;
}

std::set<std::string> namesIn(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    names.insert(entry.path().string());
  }
  return names;
}

const std::string kRing = "[[[8.1,46.8],[8.12,46.8],[8.12,46.82],[8.1,46.8]]]";

std::string geoJsonWithCrs(const std::string& crs) {
  return R"({"type":"FeatureCollection","crs":)" + crs +
         R"(,"features":[{"type":"Feature","properties":{"POP":10},"geometry":{"type":"Polygon","coordinates":)" + kRing + "}}]}";
}

}  // namespace

class TestForeignNames : public QObject {
  Q_OBJECT
  Folder folder_;
  test::FileServer server_;

  /// Files that would make GDAL ask a server, by name.
  std::map<std::string, std::string> lures() const {
    const std::string web = server_.address();
    const std::string band =
        "<SRS>EPSG:4326</SRS><GeoTransform>8,0.01,0,47,0,-0.01</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource>"
        "<SourceFilename>";
    const std::string end = "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
    const std::string begin = "<VRTDataset rasterXSize=\"8\" rasterYSize=\"8\">";
    const std::string wms = "<GDAL_WMS><Service name=\"TMS\"><ServerUrl>" + web +
                            "/${z}/${x}/${y}.png</ServerUrl></Service><DataWindow><UpperLeftX>8</UpperLeftX><UpperLeftY>47</UpperLeftY><LowerRightX>9"
                            "</LowerRightX><LowerRightY>46</LowerRightY><TileLevel>3</TileLevel></DataWindow><Projection>EPSG:4326</Projection>"
                            "<BandsCount>1</BandsCount></GDAL_WMS>";
    return {
        {"curl.vrt", begin + band + "/vsicurl/" + web + "/t.tif" + end},
        {"streaming.vrt", begin + band + "/vsicurl_streaming/" + web + "/t.tif" + end},
        {"http.vrt", begin + band + web + "/t.tif" + end},
        {"wms.vrt", begin + band + "WMS:" + web + "/wms?SERVICE=WMS&amp;VERSION=1.1.1&amp;REQUEST=GetMap&amp;LAYERS=l" + end},
        {"wms.xml", wms},
        {"named.tif", wms},
        {"ogr.vrt",
         "<OGRVRTDataSource><OGRVRTLayer name=\"l\"><SrcDataSource>/vsicurl/" + web + "/p.geojson</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>"},
        {"link.geojson", geoJsonWithCrs(R"({"type":"link","properties":{"href":")" + web + R"(/crs","type":"proj4"}})")},
        {"url.geojson", geoJsonWithCrs(R"({"type":"URL","properties":{"url":")" + web + R"(/crs"}})")},
        {"name.geojson", geoJsonWithCrs(R"({"type":"name","properties":{"name":")" + web + R"(/crs"}})")},
        {"link.kml", "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><NetworkLink><Link><href>" + web +
                         "/l.kml</href></Link></NetworkLink><GroundOverlay><Icon><href>" + web +
                         "/i.png</href></Icon></GroundOverlay><Placemark><styleUrl>" + web + "/s.kml#s</styleUrl></Placemark></Document></kml>"},
        {"schema.gml",
         "<?xml version=\"1.0\"?><wfs:FeatureCollection xmlns:wfs=\"http://www.opengis.net/wfs\" xmlns:gml=\"http://www.opengis.net/gml\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:schemaLocation=\"x " +
             web + "/s.xsd\"><gml:featureMember/></wfs:FeatureCollection>"},
        {"entity.kml",
         "<?xml version=\"1.0\"?><!DOCTYPE kml SYSTEM \"" + web + "/d.dtd\" [<!ENTITY e SYSTEM \"" + web +
             "/e.xml\">]><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark><name>&e;</name></Placemark></Document></kml>"},
        {"service.wfs", "<OGRWFSDataSource><URL>" + web + "/wfs</URL></OGRWFSDataSource>"},
    };
  }

private Q_SLOTS:
  void onlyOrdinaryFiles_areReadable() {
    QCOMPARE(kindOfFile(folder_.write("a.txt", "a")), FileKind::Ordinary);
    QCOMPARE(kindOfFile(folder_.path()), FileKind::Folder);
    QCOMPARE(kindOfFile(folder_.path("none")), FileKind::Missing);
    QCOMPARE(kindOfFile(""), FileKind::Missing);
    QCOMPARE(kindOfFile("/dev/zero"), FileKind::Special);
    QCOMPARE(kindOfFile("/proc/self/environ"), FileKind::Special);
    QCOMPARE(kindOfFile("/proc/../proc/self/./environ"), FileKind::Special);
    std::filesystem::create_symlink("/dev/zero", folder_.path("link"));
    QCOMPARE(kindOfFile(folder_.path("link")), FileKind::Special);
    QCOMPARE(kindOfFile("http://example.org/a.tif"), FileKind::Remote);
    QCOMPARE(kindOfFile("/home/a/https:/example.org/a.tif"), FileKind::Remote);  // as a mission's relative path comes out
    QCOMPARE(kindOfFile("/vsicurl/http://example.org/a.tif"), FileKind::Remote);
    QCOMPARE(kindOfFile("/vsizip/" + folder_.path("a.zip")), FileKind::Remote);
    QCOMPARE(kindOfFile("D:/maps/a.tif"), FileKind::Missing);
    QVERIFY(checkLocalFile(folder_.path("a.txt"), 1));
    QVERIFY(checkLocalFile(folder_.write("b.txt", std::string(2 << 20, 'x')), 1 << 20).error().what.starts_with("larger than 1 MiB"));
    QVERIFY(!checkLocalFile(std::string("/tmp\0/a", 7), 1));
  }

  void devicesAndPipes_areRefusedByEveryReader_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"/dev/zero", "/dev/stdin", "/dev/full", "/proc/self/environ", "pipe", "link"}) {
      QTest::newRow(name) << QString::fromLatin1(name);
    }
  }
  void devicesAndPipes_areRefusedByEveryReader() {
    QFETCH(QString, name);
    std::string path = name.toStdString();
    if (name == "pipe") {
      path = folder_.path("pipe");
      QCOMPARE(mkfifo(path.c_str(), 0600), 0);  // opening it would wait for ever
    } else if (name == "link") {
      path = folder_.path("to-zero.tif");
      std::filesystem::create_symlink("/dev/zero", path);
    }
    QElapsedTimer clock;
    clock.start();
    for (const auto& [what, attempt] : attempts()) {
      const std::optional<Error> error = attempt(path);
      QVERIFY2(error.has_value(), what);
      QVERIFY2(error->message().find(path) != std::string::npos, (std::string(what) + ": " + error->message()).c_str());
    }
    QVERIFY(clock.elapsed() < 10'000);
  }

  void addresses_areRefusedByEveryReaderAndNobodyIsAsked_data() {
    QTest::addColumn<QString>("prefix");
    for (const char* prefix :
         {"", "/vsicurl/", "/vsicurl_streaming/", "/vsis3/", "WMS:", "WFS:", "GTIFF_DIR:1:", "/vsizip//vsicurl/", "/vsigzip//vsicurl/", "folder/"}) {
      QTest::newRow(*prefix == '\0' ? "plain" : prefix) << QString::fromLatin1(prefix);
    }
  }
  void addresses_areRefusedByEveryReaderAndNobodyIsAsked() {
    QFETCH(QString, prefix);
    const std::string name = prefix.toStdString() + server_.address() + "/secret.tif";
    for (const auto& [what, attempt] : attempts()) {
      QVERIFY2(attempt(name).has_value(), what);
    }
    QVERIFY(server_.requests().empty());
  }

  void filesThatNameAddresses_makeNobodyAsk_data() {
    QTest::addColumn<QString>("name");
    for (const auto& [name, text] : lures()) {
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void filesThatNameAddresses_makeNobodyAsk() {
    QFETCH(QString, name);
    const std::string path = folder_.write(name.toStdString(), lures().at(name.toStdString()));
    const std::set<std::string> before = namesIn(folder_.path());
    for (const auto& attempt : attempts()) {
      attempt.second(path);
    }
    QVERIFY2(server_.requests().empty(), server_.requests().empty() ? "" : server_.requests().front().head.c_str());
    QCOMPARE(namesIn(folder_.path()), before);  // nothing is written beside what is read
  }

  void vrt_isRefusedWithARemedy() {
    const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({folder_.write("mosaic.vrt", lures().at("curl.vrt"))});
    QVERIFY(!info);
    QVERIFY(info.error().what.find("name those files themselves") != std::string::npos);
  }

  /// PROJ opens files of datum shifts by itself: a pipe would hold the program for ever.
  void terrainWhoseSystemNamesAFileOfShifts_isRefusedWithARemedy() {
    const std::string pipe = folder_.path("shifts.gsb");
    QCOMPARE(mkfifo(pipe.c_str(), 0600), 0);
    const auto system = [](const std::string& grids) {
      return "GEOGCS[\"lure\",DATUM[\"lure\",SPHEROID[\"Bessel 1841\",6377397.155,299.1528128],EXTENSION[\"PROJ4_GRIDS\",\"" + grids +
             "\"]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";
    };
    const std::string path = folder_.write("shifted.asc", "ncols 3\nnrows 3\nxllcorner 8\nyllcorner 46\ncellsize 0.01\n1 2 3\n4 5 6\n7 8 9\n");
    QElapsedTimer clock;
    clock.start();
    for (const std::string& grids : {pipe, "@" + pipe, "@none.gsb," + pipe, std::string("/dev/zero")}) {
      folder_.write("shifted.prj", system(grids));
      const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({path});
      QVERIFY2(!info, grids.c_str());
      QVERIFY2(info.error().what.find("names a file of datum shifts; state a system that needs none") != std::string::npos,
               info.error().what.c_str());
    }
    QVERIFY(clock.elapsed() < 10'000);
    folder_.write("shifted.prj",
                  "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
                  "UNIT[\"degree\",0.0174532925199433]]");
    QVERIFY(terrain::inspectTerrain({path}));
  }

  /// The same lure works where the network is allowed, so the tests above can fail; GDAL's file systems stay closed even then.
  void network_isOpenOnCommandOnly() {
    const std::string link = folder_.write("asks.geojson", lures().at("link.geojson"));
    const std::size_t before = server_.requests().size();
    {
      const terrain::detail::NetworkAllowed allowed;
      (void)readPopulation(link);
      QCOMPARE(server_.requests().size(), before + 1);
      QCOMPARE(server_.requests().back().path, std::string("/crs"));
    }
    (void)readPopulation(link);
    QCOMPARE(server_.requests().size(), before + 1);
    const terrain::detail::GdalMessages quiet;
    QVERIFY(GDALDataset::Open(("/vsicurl/" + server_.address() + "/secret.tif").c_str(), GDAL_OF_RASTER) == nullptr);
    QVERIFY(GDALDataset::Open((server_.address() + "/secret.tif").c_str(), GDAL_OF_RASTER) == nullptr);
    QCOMPARE(server_.requests().size(), before + 1);
  }

  void entities_ofXmlDoNotGrow() {
    std::string text = "<?xml version=\"1.0\"?><!DOCTYPE kml [<!ENTITY a \"aaaaaaaaaa\">";
    for (char c = 'b'; c <= 'p'; ++c) {
      text += std::string("<!ENTITY ") + c + " \"";
      for (int i = 0; i < 10; ++i) {
        text += std::string("&") + static_cast<char>(c - 1) + ";";
      }
      text += "\">";
    }
    text +=
        R"(]><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><name>&p;</name><ExtendedData><Data name="POP"><value>&p;</value></Data>)"
        R"(</ExtendedData><Polygon><outerBoundaryIs><LinearRing><coordinates>8,46 8,47 9,47 8,46</coordinates></LinearRing></outerBoundaryIs></Polygon>)"
        R"(</Placemark></Document></kml>)";
    const std::string path = folder_.write("laughs.kml", text);
    QElapsedTimer clock;
    clock.start();
    for (const auto& attempt : attempts()) {
      attempt.second(path);
    }
    QVERIFY2(clock.elapsed() < 10'000, qPrintable(QString::number(clock.elapsed())));
  }
};

QTEST_APPLESS_MAIN(TestForeignNames)
#include "tst_foreign_names.moc"
