// The warped grid against the source's posts, point by point, over many projections.
#include "core/terrain/terrain_reader.h"
#include "tests/core/terrain/raster_fixture.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>
#include <vector>

namespace vp::terrain {

using test::RasterSpec;
using test::SourceOracle;
using test::writeRaster;

class TestConservativeWarp : public QObject {
  Q_OBJECT

private:
  static constexpr unsigned kSeed = 977;
  static constexpr double kVoid = -32768.0;

  /// White noise, the hardest ground for an upper bound, with a void here and there.
  static RasterSpec noise(const std::string& crs, std::array<double, 6> geotransform) {
    std::mt19937_64 random(kSeed);
    std::uniform_int_distribution<int> height(0, 4000);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    RasterSpec spec;
    spec.crs = crs;
    spec.type = "Int16";
    spec.noData = kVoid;
    spec.filled(140, 110, [&](int, int) { return unit(random) < 0.004 ? kVoid : static_cast<double>(height(random)); });
    spec.geotransform = geotransform;
    return spec;
  }

private slots:
  void frame_byProjAndByGeographicLib_isTheSame() {
    const QTemporaryDir folder;
    const std::string file = writeRaster(folder, noise("EPSG:4326", {8.0, 0.03, 0.0, 48.0, 0.0, -0.03}));
    const geo::LocalFrame frame({46.123, 9.456});
    SourceOracle oracle(file, frame, [](double) { return false; });
    for (int column = 0; column < oracle.columns(); column += 10) {
      for (int row = 0; row < oracle.rows(); row += 10) {
        const geo::Point p = frame.toPoint({48.0 - 0.03 * (row + 0.5), 8.0 + 0.03 * (column + 0.5)});
        QVERIFY(geo::distance(p, oracle.placeOf(column, row)) < 1e-4);
      }
    }
  }

  void readTerrain_anyProjection_isNeverBelowTheSurroundingPosts_data() {
    QTest::addColumn<QString>("crs");
    QTest::addColumn<QList<double>>("geotransform");
    const double arc = 1.0 / 1200.0;
    QTest::newRow("UTM, oblong pixels") << "EPSG:32632" << QList<double>{560'000.0, 30.0, 0.0, 5'180'000.0, 0.0, -45.0};
    QTest::newRow("LV03, 5 m") << "EPSG:21781" << QList<double>{780'000.0, 5.0, 0.0, 185'000.0, 0.0, -5.0};
    QTest::newRow("geographic, 3 arc seconds") << "EPSG:4326" << QList<double>{9.8, arc, 0.0, 46.8, 0.0, -arc};
    QTest::newRow("geographic, far north, 1 km") << "EPSG:4326" << QList<double>{15.0, 0.03, 0.0, 82.0, 0.0, -0.009};
    QTest::newRow("geographic across 180 degrees") << "EPSG:4326" << QList<double>{179.95, arc, 0.0, -16.0, 0.0, -arc};
    QTest::newRow("geographic, south up, 0..360") << "EPSG:4326" << QList<double>{350.2, arc, 0.0, 43.0, 0.0, arc};
    QTest::newRow("UTM, turned by 30 degrees") << "EPSG:32632" << QList<double>{560'000.0, 25.98, 15.0, 5'180'000.0, 15.0, -25.98};
    QTest::newRow("UTM, turned by 50 degrees the other way") << "EPSG:32632" << QList<double>{560'000.0, 19.28, -22.98, 5'180'000.0, -22.98, -19.28};
    QTest::newRow("UTM, skewed and mirrored") << "EPSG:32632" << QList<double>{560'000.0, -20.0, 7.0, 5'180'000.0, 4.0, 33.0};
    QTest::newRow("NTF in grads from Paris") << "EPSG:4807" << QList<double>{5.1, 0.001, 0.0, 51.0, 0.0, -0.001};
    QTest::newRow("Stereo70") << "EPSG:3844" << QList<double>{300'000.0, 89.97, 0.0, 450'000.0, 0.0, -92.5};
    QTest::newRow("another azimuthal frame") << "+proj=aeqd +lat_0=46.5 +lon_0=9.5 +datum=WGS84 +units=m"
                                             << QList<double>{3'000.0, 50.0, 0.0, 4'000.0, 0.0, -50.0};
  }

  void readTerrain_anyProjection_isNeverBelowTheSurroundingPosts() {
    QFETCH(QString, crs);
    QFETCH(QList<double>, geotransform);
    std::array<double, 6> transform{};
    std::copy(geotransform.begin(), geotransform.end(), transform.begin());
    const QTemporaryDir folder;
    const std::string file = writeRaster(folder, noise(crs.toStdString(), transform));
    const auto info = inspectTerrain({file});
    QVERIFY2(info.has_value(), info ? "" : info.error().message().c_str());
    geo::LatLon origin = info->centre();
    origin.latitude_deg -= 0.07;  // not in the middle of the file
    const geo::LocalFrame frame(origin);
    qInfo("seed %u", kSeed);
    for (const double factor : {1.0, 0.37, 2.7}) {
      ReadOptions options;
      options.cell = std::round(factor * info->spacing_m * 1000.0) / 1000.0;
      const auto grid = readTerrain({file}, frame, options, Job());
      QVERIFY2(grid.has_value(), grid ? "" : grid.error().message().c_str());
      comparePoints(*grid, file, frame);
    }
  }

private:
  void comparePoints(const ElevationGrid& grid, const std::string& file, const geo::LocalFrame& frame) {
    SourceOracle oracle(file, frame, [](double raw) { return raw == kVoid; });
    std::mt19937_64 random(kSeed + 1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const geo::Box box = grid.extent().grown(grid.cellSize());
    // how many posts a cell can reach over, seen at the middle
    const geo::Point middle{0.5 * (box.minX + box.maxX), 0.5 * (box.minY + box.maxY)};
    const geo::Point at = oracle.postOf(middle);
    const geo::Point east = oracle.postOf({middle.x + grid.cellSize(), middle.y});
    const geo::Point north = oracle.postOf({middle.x, middle.y + grid.cellSize()});
    const double columns = 1.2 * (std::abs(east.x - at.x) + std::abs(north.x - at.x)) + 0.01;
    const double rows = 1.2 * (std::abs(east.y - at.y) + std::abs(north.y - at.y)) + 0.01;
    int known = 0;
    int unknown = 0;
    for (int i = 0; i < 10'000; ++i) {
      const geo::Point p{box.minX + unit(random) * (box.maxX - box.minX), box.minY + unit(random) * (box.maxY - box.minY)};
      const double upper = grid.upperAt(p);
      QVERIFY(upper >= oracle.highestAround(p));                 // infinity where a post around is void or outside
      QVERIFY(upper <= oracle.highestWithin(p, columns, rows));  // and no higher, nor unknown, without a reason nearby
      (std::isinf(upper) ? unknown : known) += 1;
    }
    QVERIFY(known > 500);
    QVERIFY(unknown > 100);
  }
};

}  // namespace vp::terrain

using vp::terrain::TestConservativeWarp;
QTEST_APPLESS_MAIN(TestConservativeWarp)
#include "tst_conservative_warp.moc"
