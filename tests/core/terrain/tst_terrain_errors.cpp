// Every kind of bad terrain file gets one sentence that names the file and what to do, and nothing on stderr.
#include "core/terrain/terrain_reader.h"
#include "tests/core/terrain/raster_fixture.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <unistd.h>
#include <utility>
#include <vector>

namespace vp::terrain {

using test::RasterSpec;
using test::writeRaster;

namespace {

/// What is written on file descriptor 2 while this lives.
class StderrCapture {
public:
  explicit StderrCapture(const QString& path) : path_(path), saved_(::dup(2)) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
      qFatal("no place for a capture");
    }
    ::dup2(file.handle(), 2);
  }
  QByteArray end() {
    ::fsync(2);
    ::dup2(saved_, 2);
    ::close(saved_);
    QFile file(path_);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unread");
  }

private:
  QString path_;
  int saved_;
};

void truncateTo(const std::string& path, double share) {
  QFile file(QString::fromStdString(path));
  QVERIFY(file.resize(static_cast<qint64>(share * static_cast<double>(file.size()))));
}

}  // namespace

class TestTerrainErrors : public QObject {
  Q_OBJECT

private:
  RasterSpec good(const std::string& name = "good.tif") const {
    RasterSpec spec;
    spec.name = name;
    spec.crs = "EPSG:4326";
    spec.withPosts(9.0, 47.0, 0.001, 0.001).filled(300, 300, [](int column, int row) { return 500.0 + (column * 31 + row * 17) % 401; });
    return spec;
  }

  Error errorOf(const std::vector<std::string>& files) {
    StderrCapture capture(folder_.filePath("stderr.txt"));
    const auto grid = readTerrain(files, geo::LocalFrame({46.9, 9.1}), {}, Job());
    const QByteArray spilled = capture.end();
    if (!spilled.isEmpty()) {
      qWarning("spilled: %s", spilled.constData());
      return Error{Errc::Unsupported, "something was written on stderr", {}};
    }
    return grid ? Error{Errc::Unsupported, "no error at all", {}} : grid.error();
  }

  /// One line, ends without a stop, names the file, holds the words.
  static bool isSentence(const Error& error, Errc code, const std::string& path, const std::vector<std::string>& words) {
    bool isGood = error.code == code && error.where == path && error.what.find('\n') == std::string::npos;
    for (const std::string& word : words) {
      isGood = isGood && error.message().find(word) != std::string::npos;
    }
    if (!isGood) {
      qWarning("got: %s", error.message().c_str());
    }
    return isGood;
  }

  std::string textFile(const char* name, const QByteArray& text) {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      qFatal("cannot write");
    }
    return file.fileName().toStdString();
  }

private slots:
  void noFiles_isSaid() {
    QVERIFY(isSentence(errorOf({}), Errc::BadFile, "", {"no terrain file"}));
    const auto info = inspectTerrain({});
    QVERIFY(!info && info.error().code == Errc::BadFile);
  }

  void missingFile_isSaid() {
    const std::string path = folder_.filePath("nowhere.tif").toStdString();
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"no such file"}));
    QVERIFY(isSentence(errorOf({writeRaster(folder_, good()), path}), Errc::BadFile, path, {"no such file"}));
  }

  void folder_isSaid() {
    const std::string path = folder_.path().toStdString();
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"folder", "one by one"}));
  }

  void emptyAndNonRasterFiles_areSaid() {
    for (const auto& [name, text] : {std::pair{"empty.tif", QByteArray()},
                                     {"letter.tif", QByteArray("Dear pilot,\nhere is no terrain.\n")},
                                     {"shape.geojson", QByteArray(R"({"type":"Point","coordinates":[9,47]})")}}) {
      const std::string path = textFile(name, text);
      QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"raster", "GeoTIFF", "GDAL: "}));
      const auto info = inspectTerrain({path});
      QVERIFY(!info && info.error().where == path);
    }
  }

  void rasterWithoutCrs_isSaid() {
    auto spec = good("nocrs.tif");
    spec.crs.clear();
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"no coordinate system", "gdal_edit.py -a_srs"}));
    const auto info = inspectTerrain({path});
    QVERIFY(!info && info.error().code == Errc::BadFile);
  }

  void unknownDatum_isSaid() {
    auto spec = good("datum.tif");
    spec.crs = "+proj=longlat +ellps=bessel";  // could lie hundreds of metres away
    const std::string path = writeRaster(folder_, spec);
    const Error error = errorOf({path});
    QVERIFY(isSentence(error, Errc::BadFile, path, {"no transformation", "datum"}));
    QVERIFY2(error.what.size() < 400, error.what.c_str());
  }

  void rasterWithoutPlace_isSaid() {
    auto spec = good("noplace.tif");
    spec.hasPlace = false;
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"where on the map", "gdalwarp"}));
  }

  void severalBands_areSaid() {
    auto spec = good("bands.tif");
    spec.bands = 3;
    spec.options = {"PHOTOMETRIC=MINISBLACK"};
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"3 bands", "gdal_translate -b"}));
  }

  void rasterWithoutBands_isSaid() {
    auto spec = good("two.gpkg");  // a container of two rasters has no band itself
    spec.driver = "GPKG";
    spec.type = "Byte";
    spec.options = {"RASTER_TABLE=a"};
    writeRaster(folder_, spec);
    spec.options = {"RASTER_TABLE=b", "APPEND_SUBDATASET=YES"};
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"no band"}));
  }

  void onlyVoids_isSaid() {
    auto spec = good("voids.tif").filled(20, 20, [](int, int) { return -32768.0; });
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(isSentence(errorOf({writeRaster(folder_, good()), path}), Errc::BadFile, path, {"no height at all", "leave it out"}));
  }

  void strangeUnit_isSaid() {
    auto spec = good("warm.tif");
    spec.unit = "degC";
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(isSentence(errorOf({path}), Errc::BadFile, path, {"degC", "-units"}));
  }

  void truncatedFile_isSaid_data() {
    QTest::addColumn<QString>("driver");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("option");
    QTest::newRow("GeoTIFF") << "GTiff"
                             << "cut.tif"
                             << "COMPRESS=NONE";
    QTest::newRow("GeoTIFF in tiles") << "GTiff"
                                      << "cuttiles.tif"
                                      << "TILED=YES";
    QTest::newRow("GeoTIFF deflate") << "GTiff"
                                     << "cutdeflate.tif"
                                     << "COMPRESS=DEFLATE";
    QTest::newRow("GeoTIFF LZW") << "GTiff"
                                 << "cutlzw.tif"
                                 << "COMPRESS=LZW";
    QTest::newRow("ASCII grid") << "AAIGrid"
                                << "cut.asc"
                                << "";
    QTest::newRow("HGT") << "SRTMHGT"
                         << "N46E009.hgt"
                         << "";
    QTest::newRow("DTED") << "DTED"
                          << "n46e009.dt1"
                          << "";
  }
  void truncatedFile_isSaid() {
    QFETCH(QString, driver);
    QFETCH(QString, name);
    QFETCH(QString, option);
    RasterSpec spec = good(name.toStdString());
    spec.driver = driver.toStdString();
    spec.type = driver == "AAIGrid" ? "Int32" : "Int16";
    if (!option.isEmpty()) {
      spec.options = {option.toStdString()};
    }
    if (driver == "SRTMHGT" || driver == "DTED") {
      spec.withPosts(9.0, 47.0, 1.0 / 1200, 1.0 / 1200).filled(1201, 1201, [](int column, int row) {
        return 500.0 + (column * 31 + row * 17) % 401;
      });
    }
    const std::string path = writeRaster(folder_, spec);
    QVERIFY(readTerrain({path}, geo::LocalFrame({46.9, 9.1}), {}, Job()).has_value());
    for (const double share : {0.99, 0.5, 0.001}) {
      truncateTo(path, share);
      const Error error = errorOf({path});
      QVERIFY(isSentence(error, Errc::BadFile, path, {}));
      QVERIFY(error.what.find("truncated") != std::string::npos || error.what.find("not a complete raster") != std::string::npos ||
              error.what.find("no coordinate system") != std::string::npos);
    }
  }

  void filesFarApart_areOutOfRange() {
    auto far = good("far.tif");
    far.withPosts(40.0, 47.0, 0.001, 0.001);
    const Error error = errorOf({writeRaster(folder_, good()), writeRaster(folder_, far)});
    QVERIFY(isSentence(error, Errc::OutOfRange, "", {"km", "load only those around the mission"}));
  }

  void wholeEarth_isOutOfRange() {
    auto spec = good("earth.tif");
    spec.withPosts(-179.5, 89.5, 1.0, 1.0).filled(360, 180, [](int, int) { return 10.0; });
    QCOMPARE(errorOf({writeRaster(folder_, spec)}).code, Errc::OutOfRange);
  }

  void impossibleCells_areOutOfRange() {
    const std::string path = writeRaster(folder_, good());
    for (const double cell : {0.0, -5.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e-3, 1e-300}) {
      ReadOptions options;
      options.cell = cell;
      const auto grid = readTerrain({path}, geo::LocalFrame({46.9, 9.1}), options, Job());
      QVERIFY(!grid && grid.error().code == Errc::OutOfRange);
    }
  }

  void sha256_knownTexts_givesKnownSums() {
    QCOMPARE(sha256OfFile(textFile("abc", "abc")).value(), std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
    QCOMPARE(sha256OfFile(textFile("nil", "")).value(), std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    QCOMPARE(sha256OfFile(textFile("million", QByteArray(1'000'000, 'a'))).value(),
             std::string("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"));
  }

  void sha256_missingFileOrFolder_isSaid() {
    const std::string path = folder_.filePath("nowhere").toStdString();
    const auto missing = sha256OfFile(path);
    QVERIFY(!missing && isSentence(missing.error(), Errc::BadFile, path, {"no such file"}));
    const auto folder = sha256OfFile(folder_.path().toStdString());
    QVERIFY(!folder && folder.error().code == Errc::BadFile);
  }

private:
  QTemporaryDir folder_;
};

}  // namespace vp::terrain

using vp::terrain::TestTerrainErrors;
QTEST_APPLESS_MAIN(TestTerrainErrors)
#include "tst_terrain_errors.moc"
