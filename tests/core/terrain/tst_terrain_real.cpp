// Real elevation files of many kinds, judged post by post against a plain reading of the file.
#include "core/terrain/terrain_pyramid.h"
#include "core/terrain/terrain_reader.h"
#include "tests/core/terrain/raster_fixture.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace vp::terrain {

using test::SourceOracle;

class TestTerrainReal : public QObject {
  Q_OBJECT

private:
  static constexpr unsigned kSeed = 4711;

  std::string dem(const std::string& name) const { return folder_ + "/dem/" + name; }

  static bool isVoid(double raw) { return std::isnan(raw) || raw < -12'000.0 || raw > 9'500.0; }

  static double highestOf(const ElevationGrid& grid) {
    double highest = -1e9;
    for (const float value : grid.values()) {
      highest = value < kUnknownUpper ? std::max(highest, static_cast<double>(value)) : highest;
    }
    return highest;
  }

private slots:
  void initTestCase() {
    folder_ = test::realDataFolder(VOLPLANE_SOURCE_DIR);
    if (folder_.empty()) {
      QSKIP("the real data for tests are not here; set VOLPLANE_DATA to their folder");
    }
  }

  void readTerrain_everyFile_boundsItsPosts_data() {
    QTest::addColumn<double>("cell");
    for (const auto& [name, cell] : {std::pair{"N43E007.hgt", 67.397},
                                     {"bc_coast_N49W123_srtm3_voids.tif", 60.364},
                                     {"bigtujunga_srtm30m_utm11n.tif", 30.008},
                                     {"canberra_S36E149_srtm3.tif", 75.608},
                                     {"davos_srtm1_utm32n_30m.asc", 30.01},
                                     {"davos_srtm1_utm32n_30m.tif", 30.01},
                                     {"davos_srtm1_wgs84.tif", 21.205},
                                     {"davosdorf_lv03_10m.tif", 10.0},
                                     {"duebendorf_lv03_10m.tif", 10.0},
                                     {"duerrboden_lv03_5m.tif", 5.0},
                                     {"fluela_lv03_10m.tif", 10.0},
                                     {"n46e008_voids.dt1", 63.969},
                                     {"retezat_srtm90_stereo70.tif", 89.964},
                                     {"sertig_lv03_5m.tif", 5.0},
                                     {"swiss_alps_N46E008_srtm3_voids.tif", 63.969},
                                     {"victorian_alps_benalla_srtm90_xcsoar.tif", 75.623}}) {
      QTest::newRow(name) << cell;
    }
  }

  void readTerrain_everyFile_boundsItsPosts() {
    QFETCH(double, cell);
    const std::string file = dem(QTest::currentDataTag());
    const auto info = inspectTerrain({file});
    QVERIFY2(info.has_value(), info ? "" : info.error().message().c_str());
    const geo::LocalFrame frame(info->centre());
    const auto grid = readTerrain({file}, frame, {}, Job());
    QVERIFY2(grid.has_value(), grid ? "" : grid.error().message().c_str());
    QVERIFY(std::abs(grid->cellSize() - cell) < 0.02);

    SourceOracle oracle(file, frame, isVoid);
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    qInfo("seed %u", kSeed);
    const geo::Box box = grid->extent();
    int known = 0;
    for (int i = 0; i < 10'000; ++i) {
      const geo::Point p{box.minX + unit(random) * (box.maxX - box.minX), box.minY + unit(random) * (box.maxY - box.minY)};
      const double upper = grid->upperAt(p);
      QVERIFY(upper >= oracle.highestAround(p));
      QVERIFY(upper <= oracle.highestWithin(p, 2.5, 2.5));
      known += std::isinf(upper) ? 0 : 1;
    }
    QVERIFY(known > 5000);
    // every post itself: a share of them, all over the file
    for (int i = 0; i < 10'000; ++i) {
      const int column = static_cast<int>(unit(random) * oracle.columns());
      const int row = static_cast<int>(unit(random) * oracle.rows());
      QVERIFY(grid->upperAt(oracle.placeOf(column, row)) >= oracle.post(column, row));
    }
    // nothing is higher than the file; its summit is there unless a void or the border takes it
    QVERIFY(highestOf(*grid) <= oracle.highest());
    const QByteArray name = QTest::currentDataTag();
    if (!name.contains("voids") && name != "duerrboden_lv03_5m.tif" && name != "sertig_lv03_5m.tif") {
      QCOMPARE(highestOf(*grid), oracle.highest());
    }
  }

  void readTerrain_neighboursOfTheCoast_joinWithoutASeam() {
    const std::string west = dem("bc_coast_N49W124_srtm3_voids.tif");
    const std::string east = dem("bc_coast_N49W123_srtm3_voids.tif");
    const auto info = inspectTerrain({west, east});
    QVERIFY(info.has_value());
    QCOMPARE(info->centre(), (geo::LatLon{49.5, -123.0}));
    const geo::LocalFrame frame(info->centre());
    const auto grid = readTerrain({west, east}, frame, {}, Job());
    QVERIFY(grid.has_value());
    SourceOracle inWest(west, frame, isVoid);
    SourceOracle inEast(east, frame, isVoid);
    int onSeam = 0;
    for (double latitude = 49.01; latitude < 49.99; latitude += 0.0007) {
      const geo::Point seam = frame.toPoint({latitude, -123.0});
      const double around =
          std::max(inWest.highestWithin({seam.x - 200.0, seam.y}, 3.0, 3.0), inEast.highestWithin({seam.x + 200.0, seam.y}, 3.0, 3.0));
      if (around < 1e9) {
        QVERIFY(grid->isKnownAt(seam));
        ++onSeam;
      }
    }
    QVERIFY(onSeam > 1000);
  }

  void readTerrain_voidsOfTheAlps_stayUnknown() {
    const std::string file = dem("swiss_alps_N46E008_srtm3_voids.tif");
    const geo::LocalFrame frame({46.5, 8.5});
    const auto grid = readTerrain({file}, frame, {}, Job());
    QVERIFY(grid.has_value());
    SourceOracle oracle(file, frame, isVoid);
    int voids = 0;
    for (int row = 0; row < oracle.rows(); row += 3) {
      for (int column = 0; column < oracle.columns(); column += 3) {
        if (std::isinf(oracle.post(column, row))) {
          QVERIFY(!grid->isKnownAt(oracle.placeOf(column, row)));
          ++voids;
        }
      }
    }
    QVERIFY(voids > 5000);
    // the same tile as DTED gives the same terrain
    const auto dted = readTerrain({dem("n46e008_voids.dt1")}, frame, {}, Job());
    QVERIFY(dted.has_value());
    QVERIFY(dted->values() == grid->values());
  }

  void upperIn_realTerrain_isNeverBelowDenseSamples() {
    const auto grid = readTerrain({dem("davos_srtm1_utm32n_30m.tif")}, geo::LocalFrame({46.8, 9.9}), {}, Job());
    QVERIFY(grid.has_value());
    const TerrainPyramid pyramid(std::make_shared<const ElevationGrid>(*grid));
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    qInfo("seed %u", kSeed);
    const geo::Box all = grid->extent();
    for (int i = 0; i < 10'000; ++i) {
      const geo::Point corner{all.minX + unit(random) * (all.maxX - all.minX), all.minY + unit(random) * (all.maxY - all.minY)};
      const double side = std::pow(10.0, 1.0 + 2.5 * unit(random));
      const geo::Box box{corner.x, corner.y, corner.x + side * unit(random), corner.y + side * unit(random)};
      const double upper = pyramid.upperIn(box);
      for (int k = 0; k < 20; ++k) {
        QVERIFY(upper >= grid->upperAt({box.minX + unit(random) * (box.maxX - box.minX), box.minY + unit(random) * (box.maxY - box.minY)}));
      }
    }
  }

  void sha256_realFile_hasItsLength() {
    const auto sum = sha256OfFile(dem("davos_srtm1_utm32n_30m.tif"));
    QVERIFY(sum.has_value());
    QCOMPARE(sum->size(), 64U);
  }

private:
  std::string folder_;
};

}  // namespace vp::terrain

using vp::terrain::TestTerrainReal;
QTEST_APPLESS_MAIN(TestTerrainReal)
#include "tst_terrain_real.moc"
