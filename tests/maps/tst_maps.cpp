// The bundled maps are what the generator writes, and what their README promises.
#include "core/geo/local_frame.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLatin1Char>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <gdal_priv.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

struct Raster {
  int columns = 0;
  int rows = 0;
  std::array<double, 6> transform{};
  std::string projection;
  std::vector<double> posts;  // row-major from the north-west
  bool operator==(const Raster&) const = default;

  /// Highest of the four posts around a point of the raster's own projection: the upper bound that planning uses.
  [[nodiscard]] double highestAround(vp::geo::Point p) const {
    const double u = (p.x - transform[0]) / transform[1] - 0.5;
    const double v = (p.y - transform[3]) / transform[5] - 0.5;
    double highest = -1e9;
    for (const double i : {std::floor(u), std::ceil(u)}) {
      for (const double j : {std::floor(v), std::ceil(v)}) {
        highest = std::max(highest, posts.at(static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)));
      }
    }
    return highest;
  }
};

std::optional<Raster> readRaster(const QString& path) {
  const std::unique_ptr<GDALDataset, CloseDataset> dataset(GDALDataset::Open(path.toUtf8().constData(), GDAL_OF_RASTER));
  if (!dataset) {
    return std::nullopt;
  }
  Raster raster;
  raster.columns = dataset->GetRasterXSize();
  raster.rows = dataset->GetRasterYSize();
  raster.projection = dataset->GetProjectionRef();
  raster.posts.resize(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  if (dataset->GetGeoTransform(raster.transform.data()) != CE_None ||
      dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, raster.columns, raster.rows, raster.posts.data(), raster.columns, raster.rows, GDT_Float64,
                                          0, 0, nullptr) != CE_None) {
    return std::nullopt;
  }
  return raster;
}

QByteArray readBytes(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

vp::geo::LatLon placeOf(const Json& object) {
  return {object.at("latitude_deg").get<double>(), object.at("longitude_deg").get<double>()};
}

/// Origin of the frame that each terrain is drawn in, as maps/README.md says.
vp::geo::LocalFrame frameOf(const std::string& terrain) {
  if (terrain == "mountain.tif") {
    return vp::geo::LocalFrame({47.0, -25.0});
  }
  return vp::geo::LocalFrame(terrain == "alpine.tif" ? vp::geo::LatLon{46.5, -27.0} : vp::geo::LatLon{47.0, -26.0});
}

}  // namespace

class TestMaps : public QObject {
  Q_OBJECT

private:
  QTemporaryDir fresh_;
  const QDir bundled_{QStringLiteral(VOLPLANE_SOURCE_DIR "/maps")};

  [[nodiscard]] QStringList bundledFiles() const {
    return bundled_.entryList({QStringLiteral("*.tif"), QStringLiteral("*.vpm"), QStringLiteral("*.csv")}, QDir::Files, QDir::Name);
  }
  [[nodiscard]] Json mission(const QString& name) const { return Json::parse(readBytes(bundled_.filePath(name)).toStdString()); }

private slots:
  void initTestCase() {
    GDALAllRegister();
    QVERIFY(fresh_.isValid());
    QProcess generator;
    generator.start(QStringLiteral(VOLPLANE_BIN_DIR "/generate_maps"), {fresh_.path()});
    QVERIFY(generator.waitForFinished(280'000));
    QVERIFY2(generator.exitStatus() == QProcess::NormalExit && generator.exitCode() == 0, generator.readAllStandardError().constData());
  }

  void generator_writesTheSameListOfFiles() {
    const QStringList written = QDir(fresh_.path()).entryList(QDir::Files, QDir::Name);
    QCOMPARE(written, bundledFiles());
    QCOMPARE(written.size(), 17);
  }

  void generator_writesTheSameContents() {
    for (const QString& name : bundledFiles()) {
      const QString path = fresh_.filePath(name);
      if (name.endsWith(QStringLiteral(".tif"))) {
        const auto expected = readRaster(bundled_.filePath(name));
        const auto actual = readRaster(path);
        QVERIFY2(expected && actual, qPrintable(name));
        QVERIFY2(*expected == *actual, qPrintable(name));
      } else {
        QVERIFY2(!readBytes(path).isEmpty() && readBytes(path) == readBytes(bundled_.filePath(name)), qPrintable(name));
      }
    }
  }

  void everyFile_isBelow2MB() {
    for (const QString& name : bundledFiles()) {
      QVERIFY2(QFileInfo(bundled_.filePath(name)).size() < 2'000'000, qPrintable(name));
    }
  }

  void mountain_reachesFrom0To1500() {
    const auto raster = readRaster(bundled_.filePath(QStringLiteral("mountain.tif")));
    QVERIFY(raster);
    const auto [lowest, highest] = std::minmax_element(raster->posts.begin(), raster->posts.end());
    QCOMPARE(*lowest, 0.0);
    QCOMPARE(*highest, 1500.0);
    QCOMPARE((raster->columns - 1) * raster->transform[1], 5000.0);
    QCOMPARE((raster->rows - 1) * raster->transform[5], -5000.0);
  }

  void mountainMissions_haveFiveSitesAndTheirTargets() {
    for (const int count : {5, 10, 20, 50, 100}) {
      const Json json = mission(QStringLiteral("mountain-n%1.vpm").arg(count));
      QCOMPARE(json.at("landingSites").size(), std::size_t{5});
      QCOMPARE(json.at("targets").size(), static_cast<std::size_t>(count));
      const vp::geo::LocalFrame frame = frameOf("mountain.tif");
      for (const Json& target : json.at("targets")) {
        const vp::geo::Point p = frame.toPoint(placeOf(target));
        QVERIFY(std::abs(p.x) <= 2200.001 && std::abs(p.y) <= 2200.001);
        QCOMPARE(target.at("height_m").get<double>(), 100.0);
      }
    }
  }

  void inlineSites_areNotBelowTheTerrain() {
    int sites = 0;
    for (const QString& name : bundledFiles().filter(QStringLiteral(".vpm"))) {
      const Json json = mission(name);
      if (!json.contains("landingSites")) {
        continue;
      }
      const std::string terrain = json.at("terrain").at(0).get<std::string>();
      const auto raster = readRaster(bundled_.filePath(QString::fromStdString(terrain)));
      QVERIFY(raster);
      for (const Json& site : json.at("landingSites")) {
        const double ground = raster->highestAround(frameOf(terrain).toPoint(placeOf(site)));
        QCOMPARE(ground, site.at("elevation_m").get<double>());
        ++sites;
      }
    }
    QCOMPARE(sites, 5 * 5 + 1 + 1 + 2);
  }

  void figureWorlds_haveTheSitesOfThePaper() {
    const Json json = mission(QStringLiteral("two-runways.vpm"));
    const vp::geo::LocalFrame frame = frameOf("two-runways.tif");
    const Json& first = json.at("landingSites").at(0);
    const Json& second = json.at("landingSites").at(1);
    QVERIFY(vp::geo::distance(frame.toPoint(placeOf(first)), {0.0, 0.0}) < 0.001);
    QVERIFY(vp::geo::distance(frame.toPoint(placeOf(second)), {-2500.0, 1500.0}) < 0.001);
    QCOMPARE(first.at("elevation_m").get<double>(), 0.0);
    QCOMPARE(second.at("elevation_m").get<double>(), 100.0);
    QVERIFY(std::abs(first.at("landingCourse_deg").get<double>() - 90.0) < 1e-6);
    QVERIFY(std::abs(second.at("landingCourse_deg").get<double>() - 315.0) < 0.05);  // grid course; the meridian is turned by 0.03 degree there
  }

  void alpine_isAlpineAndHasAirfields() {
    const auto raster = readRaster(bundled_.filePath(QStringLiteral("alpine.tif")));
    QVERIFY(raster);
    const auto [lowest, highest] = std::minmax_element(raster->posts.begin(), raster->posts.end());
    QVERIFY2(*lowest >= 200.0 && *lowest <= 600.0, qPrintable(QString::number(*lowest)));
    QVERIFY2(*highest >= 3000.0 && *highest <= 3800.0, qPrintable(QString::number(*highest)));
    QVERIFY(std::abs((raster->columns - 1) * raster->transform[1] - 60'000.0) < 500.0);

    const QStringList lines =
        QString::fromUtf8(readBytes(bundled_.filePath(QStringLiteral("alpine-runways.csv")))).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    const QStringList header = lines.front().split(QLatin1Char(','));
    std::set<QString> airports;
    for (const QString& line : lines.mid(1)) {
      const QStringList cells = line.split(QLatin1Char(','));
      QCOMPARE(cells.size(), header.size());
      if (cells.at(header.indexOf(QStringLiteral("le_latitude_deg"))).isEmpty()) {
        continue;  // the heliport
      }
      airports.insert(cells.at(header.indexOf(QStringLiteral("airport_ident"))));
      for (const QString& end : {QStringLiteral("le"), QStringLiteral("he")}) {
        const auto number = [&](const char* column) { return cells.at(header.indexOf(end + QLatin1String(column))).toDouble(); };
        const double elevation = number("_elevation_ft") * vp::kMetresPerFoot;
        const double ground = raster->highestAround(frameOf("alpine.tif").toPoint({number("_latitude_deg"), number("_longitude_deg")}));
        QVERIFY2(elevation >= ground && elevation - ground < vp::kMetresPerFoot, qPrintable(line));
      }
    }
    QVERIFY(airports.size() >= 8);
  }
};

QTEST_APPLESS_MAIN(TestMaps)
#include "tst_maps.moc"
