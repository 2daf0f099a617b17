// Terrain files as posts: seams, voids, other coordinates, and against the cells that the checker uses, which must never be lower.
#include "core/audit/raw_ground.h"
#include "core/geo/local_frame.h"
#include "core/terrain/terrain_reader.h"
#include "tests/support/data_folder.h"

#include <QTemporaryDir>
#include <QTest>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <functional>
#include <random>

using namespace vp;
using namespace vp::audit;

namespace {

constexpr geo::LatLon kOrigin{46.5, 9.0};

/// Posts in UTM zone 32N, the first (north-west) post at (east, north), 100 m apart.
std::string writeRaster(const QTemporaryDir& folder, const char* name, double east, double north, int columns, int rows,
                        const std::function<float(int column, int row)>& height, const char* unit = "m") {
  GDALAllRegister();
  const std::string path = folder.filePath(QString::fromLatin1(name)).toStdString();
  GDALDataset* file = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, 1, GDT_Float32, nullptr);
  OGRSpatialReference utm;
  utm.importFromEPSG(32632);
  file->SetSpatialRef(&utm);
  double transform[6] = {east - 50.0, 100.0, 0.0, north + 50.0, 0.0, -100.0};
  file->SetGeoTransform(transform);
  std::vector<float> posts;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      posts.push_back(height(column, row));
    }
  }
  GDALRasterBand* band = file->GetRasterBand(1);
  band->SetNoDataValue(-1.0);
  band->SetUnitType(unit);
  const CPLErr written = band->RasterIO(GF_Write, 0, 0, columns, rows, posts.data(), columns, rows, GDT_Float32, 0, 0, nullptr);
  GDALClose(file);
  return written == CE_None ? path : std::string();
}

/// A place of the frame by its UTM coordinates.
geo::Point fromUtm(double east, double north) {
  OGRSpatialReference utm;
  utm.importFromEPSG(32632);
  OGRSpatialReference degrees;
  degrees.SetWellKnownGeogCS("WGS84");
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformation* transform = OGRCreateCoordinateTransformation(&utm, &degrees);
  transform->Transform(1, &east, &north);
  OGRCoordinateTransformation::DestroyCT(transform);
  return geo::LocalFrame(kOrigin).toPoint({north, east});
}

double heightAt(const std::vector<std::string>& files, geo::Point place) {
  const Result<RawGround> ground = RawGround::read(files, kOrigin, Job());
  if (!ground) {
    throw std::runtime_error(ground.error().message());
  }
  std::vector<double> heights;
  ground->lookup().value()({place}, heights);
  return heights.at(0);
}

}  // namespace

class TestRawGround : public QObject {
  Q_OBJECT

private slots:
  void place_isAsHighAsTheHighestOfFourPosts() {
    const QTemporaryDir folder;
    const auto height = [](int column, int row) { return static_cast<float>(100 * row + column); };
    const std::string file = writeRaster(folder, "a.tif", 500000.0, 5150000.0, 20, 10, height);
    QCOMPARE(heightAt({file}, fromUtm(500250.0, 5149750.0)), 303.0);  // between columns 2 and 3, rows 2 and 3
    QCOMPARE(heightAt({file}, fromUtm(500201.0, 5149799.0)), 303.0);
    QCOMPARE(heightAt({file}, fromUtm(500199.0, 5149801.0)), 202.0);
    QVERIFY(std::isinf(heightAt({file}, fromUtm(499990.0, 5149750.0))));  // outside
    QVERIFY(std::isinf(heightAt({file}, fromUtm(501910.0, 5149750.0))));
    QVERIFY(std::isinf(heightAt({file}, fromUtm(500250.0, 5149090.0))));
    QVERIFY(std::isinf(heightAt({file}, fromUtm(500250.0, 5150010.0))));
  }

  void voidAmongTheFour_isUnknown() {
    const QTemporaryDir folder;
    const std::string file =
        writeRaster(folder, "v.tif", 500000.0, 5150000.0, 20, 10, [](int column, int row) { return column == 5 && row == 5 ? -1.0F : 7.0F; });
    QVERIFY(std::isinf(heightAt({file}, fromUtm(500510.0, 5149490.0))));
    QVERIFY(std::isinf(heightAt({file}, fromUtm(500410.0, 5149590.0))));
    QCOMPARE(heightAt({file}, fromUtm(500610.0, 5149490.0)), 7.0);
    const std::string code =
        writeRaster(folder, "c.tif", 500000.0, 5150000.0, 20, 10, [](int column, int row) { return column == 5 && row == 5 ? -9999.0F : 7.0F; });
    QVERIFY(std::isinf(heightAt({code}, fromUtm(500510.0, 5149490.0))));
    // another file that knows the post fills it, and where both know it the higher counts
    const std::string filling = writeRaster(folder, "f.tif", 500000.0, 5150000.0, 20, 10, [](int, int) { return 9.0F; });
    QCOMPARE(heightAt({file, filling}, fromUtm(500510.0, 5149490.0)), 9.0);
    const std::string lower = writeRaster(folder, "l.tif", 500000.0, 5150000.0, 20, 10, [](int, int) { return 3.0F; });
    QCOMPARE(heightAt({lower, file}, fromUtm(500610.0, 5149490.0)), 7.0);
  }

  void filesOfOneLattice_joinWithoutASeam() {
    const QTemporaryDir folder;
    const std::string west = writeRaster(folder, "w.tif", 500000.0, 5150000.0, 10, 10, [](int, int) { return 10.0F; });
    const std::string east = writeRaster(folder, "e.tif", 501000.0, 5150000.0, 10, 10, [](int, int) { return 20.0F; });
    QVERIFY(std::isinf(heightAt({west}, fromUtm(500950.0, 5149750.0))));
    QCOMPARE(heightAt({west, east}, fromUtm(500950.0, 5149750.0)), 20.0);
    QCOMPARE(heightAt({east, west}, fromUtm(500850.0, 5149750.0)), 10.0);
  }

  void feet_areMetres() {
    const QTemporaryDir folder;
    const std::string file = writeRaster(
        folder, "ft.tif", 500000.0, 5150000.0, 5, 5, [](int, int) { return 1000.0F; }, "ft");
    QVERIFY(std::abs(heightAt({file}, fromUtm(500150.0, 5149850.0)) - 304.8) < 1e-4);
    const std::string odd = writeRaster(
        folder, "odd.tif", 500000.0, 5150000.0, 5, 5, [](int, int) { return 1000.0F; }, "fathom");
    const auto ground = RawGround::read({odd}, kOrigin, Job());
    QVERIFY(!ground && ground.error().what.find("fathom") != std::string::npos);
    QVERIFY(!RawGround::read({folder.filePath("none.tif").toStdString()}, kOrigin, Job()));
  }

  void frame_isThatOfTheRest() {
    const geo::LocalFrame frame(kOrigin);
    const std::vector<geo::LatLon> places{{46.5, 9.0}, {46.9, 9.6}, {46.0, 8.1}, {47.2, 9.01}};
    const auto points = RawGround::toFrame(kOrigin, places);
    QVERIFY(points.has_value());
    for (std::size_t i = 0; i < places.size(); ++i) {
      QVERIFY(geo::distance(points->at(i), frame.toPoint(places[i])) < 1e-3);
    }
  }

  /// The checker's cells bound the ground from above: nowhere below the posts, and seldom far above.
  void cells_areNeverBelowThePosts_data() {
    QTest::addColumn<QStringList>("files");
    QTest::newRow("bundled") << QStringList{QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine.tif")};
    if (const QString data = test::dataFolder(); !data.isEmpty()) {
      QTest::newRow("geographic, voids") << QStringList{data + "/dem/swiss_alps_N46E008_srtm3_voids.tif"};
      QTest::newRow("two tiles") << QStringList{data + "/dem/bc_coast_N49W123_srtm3_voids.tif", data + "/dem/bc_coast_N49W124_srtm3_voids.tif"};
      QTest::newRow("UTM") << QStringList{data + "/dem/bigtujunga_srtm30m_utm11n.tif"};
    }
  }
  void cells_areNeverBelowThePosts() {
    QFETCH(QStringList, files);
    std::vector<std::string> paths;
    for (const QString& file : files) {
      paths.push_back(file.toStdString());
    }
    const auto info = terrain::inspectTerrain(paths);
    QVERIFY(info.has_value());
    const geo::LocalFrame frame(info->centre());
    const auto grid = terrain::readTerrain(paths, frame, {}, Job());
    const auto ground = RawGround::read(paths, info->centre(), Job());
    QVERIFY(grid && ground);
    const unsigned seed = 20261130;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    const geo::Box box = grid->extent();
    std::vector<geo::Point> places;
    for (int i = 0; i < 100'000; ++i) {
      places.push_back(
          {std::uniform_real_distribution<double>(box.minX, box.maxX)(random), std::uniform_real_distribution<double>(box.minY, box.maxY)(random)});
    }
    std::vector<double> heights;
    ground->lookup().value()(places, heights);
    int known = 0;
    int same = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double upper = grid->upperAt(places[i]);
      QVERIFY2(upper >= heights[i] - 1e-3,
               qPrintable(QStringLiteral("%1 %2: cell %3, posts %4").arg(places[i].x).arg(places[i].y).arg(upper).arg(heights[i])));
      known += heights[i] < kUnknownGround ? 1 : 0;
      same += upper - heights[i] < 50.0 ? 1 : 0;
    }
    qInfo("%d of 100000 known, %d within 50 m", known, same);
    QVERIFY(known > 50'000 && same > known / 2);
  }
};

QTEST_GUILESS_MAIN(TestRawGround)
#include "tst_raw_ground.moc"
