// Every limit of core/formats/limits.h and of terrain, each passed by a little: a sentence, in bounded time and memory.
#include "core/formats/airfields.h"
#include "core/formats/airspace/openair.h"
#include "core/formats/json_value.h"
#include "core/formats/limits.h"
#include "core/formats/mission_file.h"
#include "core/formats/targets/target_import.h"
#include "core/formats/text_file.h"
#include "core/terrain/gdal_support.h"
#include "core/terrain/terrain_reader.h"
#include "tests/core/formats/format_samples.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <zlib.h>

#include <array>
#include <memory>
#include <sys/resource.h>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

constexpr const char* kWgs84 =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";
/// A GeoTIFF in UTM whose posts were never written, so that it takes a few hundred bytes.
void writeEmptyRaster(const std::string& path, int columns, int rows, std::array<double, 6> edges) {
  const terrain::detail::GdalMessages quiet;
  CPLStringList options;
  options.SetNameValue("SPARSE_OK", "YES");
  const std::unique_ptr<GDALDataset> raster(
      GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, 1, GDT_Byte, options.List()));
  OGRSpatialReference system;
  system.importFromEPSG(32632);
  QVERIFY(raster != nullptr && raster->SetSpatialRef(&system) == CE_None && raster->SetGeoTransform(edges.data()) == CE_None);
}

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  text.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) {
    text += piece;
  }
  return text;
}

/// Empty if a result is an error with these words in its sentence.
template <typename T>
std::string notRefused(const Result<T>& result, const std::vector<std::string>& words) {
  return result ? "was read" : samples::lacking(result.error().message(), words);
}

std::string missionText(const std::string& sites, const std::string& targets) {
  return "{\"format\":\"volplane-mission\",\"version\":1,\"name\":\"m\",\"terrain\":[\"t.tif\"],\"aircraft\":\"cessna172-elasp\",\"landingSites\":[" +
         sites + "],\"targets\":[" + targets + "]}";
}

std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) {
    text += note + "\n";
  }
  return text;
}

}  // namespace

#define VP_REFUSED(result, ...)                                    \
  do {                                                             \
    const std::string wrong = notRefused((result), {__VA_ARGS__}); \
    QVERIFY2(wrong.empty(), wrong.c_str());                        \
  } while (false)

class TestLimits : public QObject {
  Q_OBJECT
  Folder folder_;

  /// Bytes packed by gzip, all the same.
  std::string packed(const std::string& name, std::size_t bytes, char byte) const {
    const std::string path = folder_.path(name);
    const std::string block(1 << 20, byte);
    gzFile file = gzopen(path.c_str(), "wb1");
    for (std::size_t done = 0; done < bytes; done += block.size()) {
      gzwrite(file, block.data(), static_cast<unsigned>(block.size()));
    }
    gzclose(file);
    return path;
  }

private Q_SLOTS:
  void file_tooLargeIsNotRead() {
    const std::string path = folder_.write("hole.cup", "name,code");
    std::filesystem::resize_file(path, kMostFileBytes + 1);  // a hole takes no room
    VP_REFUSED(readFile(path), "hole.cup", "larger than 1 GiB");
    VP_REFUSED(readText(path), "larger than 256 MiB");
    VP_REFUSED(readCup(path, {}, std::nullopt), "larger than 256 MiB");
    VP_REFUSED(readMission(path), "larger than 256 MiB");
    VP_REFUSED(importTargets(path, {}, {}), "hole.cup");
  }

  void gzip_isUnpackedToTheLimitOnly() {
    const std::string path = packed("bomb.txt.gz", kMostTextBytes + (1 << 20), 'a');
    QVERIFY(std::filesystem::file_size(path) < (2u << 20));
    VP_REFUSED(readText(path), "bomb.txt.gz", "larger than 256 MiB");
    VP_REFUSED(readOpenAir(path), "larger than 256 MiB");
  }

  void json_isBounded() {
    VP_REFUSED(parseJson(repeated("[", kMostJsonDepth + 1), "a.json"), "deeper than 64 levels");
    VP_REFUSED(parseJson(repeated("{\"a\":", 100'000), "a.json"), "deeper than 64 levels");
    std::string members = "{";
    for (std::size_t i = 0; i <= kMostJsonMembers; ++i) {
      members += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":0";
    }
    VP_REFUSED(parseJson(members + "}", "a.json"), "more than 1000 members");
    VP_REFUSED(parseJson("[" + repeated("0,", kMostJsonValues) + "0]", "a.json"), "a.json", "more than 10000000 values");
    QVERIFY(parseJson(repeated("[", kMostJsonDepth) + repeated("]", kMostJsonDepth), "a.json"));
  }

  void xml_isBounded() {
    const std::string path = folder_.write("long.gpx", "<gpx>" + std::string(kMostXmlBytes, ' ') + "</gpx>");
    VP_REFUSED(importTargets(path, {}, {}), "long.gpx", "larger than 64 MiB");
    // nesting costs no stack
    VP_REFUSED(importTargets(folder_.write("deep.kml", "<kml>" + repeated("<Folder>", 1'000'000)), {}, {}), "deep.kml", "cannot be read here");
    VP_REFUSED(
        importTargets(folder_.write("deeper.kml", "<kml>" + repeated("<Folder>", 200'000) + repeated("</Folder>", 200'000) + "</kml>"), {}, {}),
        "no places for targets");
  }

  void landingSites_areBounded() {
    const std::string path =
        folder_.write("many.csv", "latitude,longitude,end_latitude,end_longitude,runway\n" + repeated("46,8,46.01,8,36\n", kMostSites / 2 + 1));
    const Result<AirfieldReport> report = readAirfields({path, ""}, "", {}, std::nullopt);
    QVERIFY2(report.has_value(), report ? "" : report.error().message().c_str());
    QCOMPARE(report->sites.size(), kMostSites);
    QVERIFY2(joined(report->notes).find("2 left out: more than 500000 landing sites") != std::string::npos, joined(report->notes).c_str());
  }

  void missions_areBounded() {
    std::string targets;
    std::string sites;
    for (std::size_t i = 0; i <= kMostMissionTargets; ++i) {
      const std::string comma = i > 0 ? "," : "";
      targets += comma + "{\"name\":\"T" + std::to_string(i) + "\",\"latitude_deg\":46,\"longitude_deg\":8,\"height_m\":100,\"reference\":\"agl\"}";
      sites += comma + "{\"id\":\"S" + std::to_string(i) + "\",\"latitude_deg\":46,\"longitude_deg\":8,\"elevation_m\":0,\"landingCourse_deg\":90}";
    }
    VP_REFUSED(parseMission(missionText("", targets), "m.vpm"), "m.vpm", "20001 are too many", "20000 at most");
    VP_REFUSED(parseMission(missionText(sites, ""), "m.vpm"), "m.vpm", "20001 are too many", "20000 at most");
  }

  void airspaces_areBounded() {
    const std::string circle = "AC D\nAN C\nAL SFC\nAH FL100\nV X=46:00:00 N 008:00:00 E\nDC 500\n";
    const Result<AirspaceReport> one = readOpenAir(folder_.write("one.txt", circle));
    QVERIFY(one && one->airspaces.size() == 1);
    const std::size_t most = kMostAirspacesCorners / one->airspaces[0].outline.size();
    const Result<AirspaceReport> many = readOpenAir(folder_.write("many.txt", repeated(circle, most + 3)));
    QVERIFY(many.has_value());
    QCOMPARE(many->airspaces.size(), most);
    QVERIFY2(joined(many->notes).find("3 left out: more than 1000000 corners") != std::string::npos, joined(many->notes).c_str());
    const std::string corners =
        "AC D\nAN C\nAL SFC\nAH FL100\n" + repeated("DP 46:00:00 N 008:00:00 E\nDP 46:10:00 N 008:00:00 E\n", kMostAirspaceCorners);
    const Result<AirspaceReport> long_ = readOpenAir(folder_.write("long.txt", corners));
    QVERIFY(long_ && long_->airspaces.empty());
    QVERIFY2(joined(long_->notes).find("too many corners") != std::string::npos, joined(long_->notes).c_str());
  }

  void surveyAreas_areBounded() {
    std::string corners;
    for (std::size_t i = 0; i <= kMostSurveyCorners + 2; ++i) {
      corners += i % 2 == 0 ? "8.0,46.0 " : "8.01,46.01 ";
    }
    const std::string begin = "<kml><Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>";
    const std::string end = "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></kml>";
    VP_REFUSED(importTargets(folder_.write("zigzag.kml", begin + corners + end), {}, {}), "zigzag.kml", "more than 100000 corners");
    // many areas of many lines: given up when there are too many targets already
    const std::string area =
        "<Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>8,46 8.5,46 8.5,46.5 8,46.5</coordinates></LinearRing>"
        "</outerBoundaryIs></Polygon></Placemark>";
    TargetImportOptions options;
    options.spacing = Length::fromSi(15.0);
    VP_REFUSED(importTargets(folder_.write("areas.kml", "<kml>" + repeated(area, 10'000) + "</kml>"), options, {}), "areas.kml", "targets or more");
  }

  void rasters_areBounded() {
    // headers that promise what is not there; nothing of that size is ever made room for
    const std::string huge = folder_.write("huge.asc", "ncols 40000\nnrows 40000\nxllcorner 8\nyllcorner 46\ncellsize 0.0001\n1 2 3\n");
    folder_.write("huge.prj", kWgs84);
    VP_REFUSED(terrain::readTerrain({huge}, geo::LocalFrame({48.0, 10.0}), {}, Job{}), "huge.asc", "40000 x 40000 heights, more than 300 million");
    // three files beside each other whose columns add up to 2^32 + 10, which an int takes for 10
    const std::array<int, 3> widths{1'431'655'766, 1'431'655'770, 1'431'655'770};
    constexpr double kPost = 0.0001220703125;  // m, 2^-13: sums are exact
    std::vector<std::string> files;
    double west = 300'000.0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      files.push_back(folder_.path("wide" + std::to_string(i) + ".tif"));
      writeEmptyRaster(files.back(), widths[i], 2, {west, kPost, 0.0, 5'100'000.0, 0.0, -kPost});
      west += widths[i] * kPost;
    }
    VP_REFUSED(terrain::readTerrain(files, geo::LocalFrame({46.0, 9.0}), {}, Job{}), "more than 300 million");
  }

  /// The last: what all of the above took together at its highest.
  void memory_staysBelowTwoGigabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    qInfo("%ld MiB at most", usage.ru_maxrss / 1024);
    QVERIFY(usage.ru_maxrss < 2L * 1024 * 1024);  // KiB
  }
};

QTEST_APPLESS_MAIN(TestLimits)
#include "tst_limits.moc"
