#include "core/terrain/terrain_reader.h"
#include "tests/core/terrain/raster_fixture.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>
#include <thread>
#include <vector>

namespace vp::terrain {

using test::RasterSpec;
using test::writeRaster;

/// Small rasters that lie in the local frame itself, so that every cell's value is known by hand.
class TestTerrainReader : public QObject {
  Q_OBJECT

private:
  /// Posts every 30 m at multiples of 30 m from (west, north), the frame's own projection.
  RasterSpec aligned(double west, double north) const {
    RasterSpec spec;
    spec.crs = frame_.projString();
    spec.withPosts(west, north, 30.0, 30.0);
    return spec;
  }

  static double wave(int column, int row) { return 1000.0 + 37.0 * ((column * 7 + row * 13) % 29); }

  ElevationGrid read(const std::vector<std::string>& files, const ReadOptions& options = {}) const {
    const auto grid = readTerrain(files, frame_, options, Job());
    if (!grid) {
      qFatal("%s", grid.error().message().c_str());
    }
    return *grid;
  }

  /// One raster of constant height read with changes by the caller: the value in its middle cell.
  double heightWith(RasterSpec spec) const {
    const QTemporaryDir folder;
    const ElevationGrid grid = read({writeRaster(folder, spec)});
    return static_cast<double>(grid.upperInCell(grid.columns() / 2, grid.rows() / 2));
  }

private slots:
  void readTerrain_sourceAlignedWithTheFrame_keepsTheHighestOfFourPosts() {
    const QTemporaryDir folder;
    const auto spec = aligned(-600.0, 900.0).filled(41, 61, wave);
    const ElevationGrid grid = read({writeRaster(folder, spec)});
    QCOMPARE(grid.cellSize(), 30.0);
    QCOMPARE(grid.columns(), 40);
    QCOMPARE(grid.rows(), 60);
    QCOMPARE(grid.originX(), -600.0);
    QCOMPARE(grid.originY(), -900.0);
    for (int row = 0; row < 60; ++row) {
      for (int column = 0; column < 40; ++column) {
        const int fileRow = 59 - row;  // north of the cell
        const double expected =
            std::max({wave(column, fileRow), wave(column + 1, fileRow), wave(column, fileRow + 1), wave(column + 1, fileRow + 1)});
        QCOMPARE(static_cast<double>(grid.upperInCell(column, row)), expected);
      }
    }
  }

  void readTerrain_voidPost_makesTheCellsAroundItUnknown() {
    const QTemporaryDir folder;
    auto spec = aligned(0.0, 300.0).filled(11, 11, [](int column, int row) { return column == 5 && row == 4 ? -32767.0 : 100.0; });
    spec.noData = -32767.0;
    const ElevationGrid grid = read({writeRaster(folder, spec)});
    for (int row = 0; row < 10; ++row) {
      for (int column = 0; column < 10; ++column) {
        const bool isBeside = (column == 4 || column == 5) && (row == 5 || row == 6);
        QCOMPARE(grid.upperInCell(column, row), isBeside ? kUnknownUpper : 100.0F);
      }
    }
  }

  void readTerrain_tilesWithOrWithoutSharedPosts_joinWithoutASeam_data() {
    QTest::addColumn<int>("step");
    QTest::newRow("shared edge posts, as SRTM") << 10;
    QTest::newRow("edges one post apart, as GLO-30") << 11;
    QTest::newRow("overlap of four posts") << 7;
  }
  void readTerrain_tilesWithOrWithoutSharedPosts_joinWithoutASeam() {
    QFETCH(int, step);
    const QTemporaryDir folder;
    std::vector<std::string> tiles;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        auto spec = aligned(30.0 * i * step, -30.0 * j * step);
        spec.name = "tile" + std::to_string(i) + std::to_string(j) + ".tif";
        tiles.push_back(writeRaster(folder, spec.filled(11, 11, [&](int column, int row) { return wave(column + i * step, row + j * step); })));
      }
    }
    auto whole = aligned(0.0, 0.0);
    whole.name = "whole.tif";
    const ElevationGrid expected = read({writeRaster(folder, whole.filled(11 + step, 11 + step, wave))});
    const ElevationGrid joined = read({tiles[2], tiles[0], tiles[3], tiles[1]});
    QCOMPARE(joined.originX(), expected.originX());
    QCOMPARE(joined.originY(), expected.originY());
    QCOMPARE(joined.values(), expected.values());
    QCOMPARE(std::count(joined.values().begin(), joined.values().end(), kUnknownUpper), 0);
  }

  void readTerrain_tilesAlmostAligned_boundsThePostsWhereTheyReallyLie() {
    const QTemporaryDir folder;
    // the second tile lies 2 cm (0.0007 post) west of the lattice, so its first mesh begins inside the cell west of 330 m
    auto east = aligned(330.0 - 0.02, 300.0).filled(11, 11, [](int column, int) { return column == 1 ? 2000.0 : 100.0; });
    east.name = "east.tif";
    const ElevationGrid grid =
        read({writeRaster(folder, aligned(0.0, 300.0).filled(11, 11, [](int, int) { return 100.0; })), writeRaster(folder, east)});
    QCOMPARE(grid.cellSize(), 30.0);
    QCOMPARE(grid.upperAt({329.99, 150.1}), 2000.0);
    QCOMPARE(grid.upperAt({299.0, 150.1}), 100.0);
    QVERIFY(grid.isKnownAt({315.0, 150.1}));
  }

  void readTerrain_overlap_takesTheHigherKnownPost() {
    const QTemporaryDir folder;
    auto low = aligned(0.0, 300.0).filled(11, 11, [](int column, int) { return column == 2 ? -32768.0 : 100.0; });
    auto high = aligned(0.0, 300.0).filled(11, 11, [](int column, int) { return column == 8 ? -32768.0 : (column == 5 ? 300.0 : 50.0); });
    low.name = "low.tif";
    high.name = "high.tif";
    const std::string a = writeRaster(folder, low);
    const std::string b = writeRaster(folder, high);
    for (const auto& files : {std::vector{a, b}, std::vector{b, a}}) {
      const ElevationGrid grid = read(files);
      const std::vector<float> expected{100.0F, 100.0F, 100.0F, 100.0F, 300.0F, 300.0F, 100.0F, 100.0F, 100.0F, 100.0F};
      for (int column = 0; column < 10; ++column) {
        QCOMPARE(grid.upperInCell(column, 5), expected[static_cast<std::size_t>(column)]);
      }
    }
  }

  void readTerrain_filesOfDifferentLattices_takesTheHigherKnownCell() {
    const QTemporaryDir folder;
    auto coarse = aligned(0.0, 600.0).filled(21, 21, [](int, int) { return 500.0; });
    RasterSpec fine;
    fine.name = "fine.tif";
    fine.crs = frame_.projString();
    fine.withPosts(105.0, 405.0, 10.0, 10.0).filled(20, 20, [](int column, int) { return column < 10 ? 400.0 : 700.0; });
    const ElevationGrid grid = read({writeRaster(folder, coarse), writeRaster(folder, fine)});
    QCOMPARE(grid.cellSize(), 10.0);
    QCOMPARE(grid.upperAt({125.0, 305.0}), 500.0);
    QCOMPARE(grid.upperAt({285.0, 305.0}), 700.0);
    QCOMPARE(grid.upperAt({285.0, 505.0}), 500.0);
  }

  void readTerrain_tilesAcrossTheDateLine_join() {
    const QTemporaryDir folder;
    RasterSpec west;
    west.crs = "EPSG:4326";
    west.withPosts(179.9, 0.05, 0.01, 0.01).filled(11, 11, wave);
    RasterSpec east = west;
    east.name = "east.tif";
    east.withPosts(-180.0, 0.05, 0.01, 0.01);
    const std::vector<std::string> files{writeRaster(folder, west), writeRaster(folder, east)};
    const auto info = inspectTerrain(files);
    QVERIFY(info.has_value());
    QVERIFY(std::abs(std::abs(info->centre().longitude_deg) - 180.0) < 0.01);
    const auto grid = readTerrain(files, geo::LocalFrame({0.0, 180.0}), {}, Job());
    QVERIFY(grid.has_value());
    QVERIFY(grid->columns() * grid->cellSize() < 25e3);
    for (double x = -10e3; x < 10e3; x += 97.0) {
      QVERIFY(grid->isKnownAt({x, 0.0}));
    }
  }

  void readTerrain_unitScaleOffset_givesMetres() {
    const auto flat = [this](double raw) { return aligned(0.0, 300.0).filled(11, 11, [raw](int, int) { return raw; }); };
    RasterSpec feet = flat(1000.0);
    feet.unit = "ft";
    QVERIFY(std::abs(heightWith(feet) - 304.8) < 1e-4);
    QVERIFY(heightWith(feet) >= 304.8);
    feet.unit = "US survey foot";
    QVERIFY(std::abs(heightWith(feet) - 304.8006096) < 1e-4);
    RasterSpec scaled = flat(15'000.0);
    scaled.type = "UInt16";
    scaled.scale = 0.1;
    scaled.offset = -1000.0;
    QCOMPARE(heightWith(scaled), 500.0);
    RasterSpec both = scaled;
    both.unit = "feet";
    QVERIFY(std::abs(heightWith(both) - 152.4) < 1e-4);
    QVERIFY(heightWith(both) >= 152.4);
  }

  void readTerrain_heightBetweenTwoFloats_roundsUp() {
    auto spec = aligned(0.0, 300.0).filled(11, 11, [](int, int) { return 1000.00001; });
    spec.type = "Float64";
    QVERIFY(heightWith(spec) >= 1000.00001);
  }

  void readTerrain_voidsOfEveryKind_areUnknown_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("noData");
    const double none = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("declared") << "Int16" << 1234.0 << 1234.0;
    QTest::newRow("declared zero") << "Int16" << 0.0 << 0.0;
    QTest::newRow("no number") << "Float32" << std::numeric_limits<double>::quiet_NaN() << none;
    QTest::newRow("declared, rounded to float") << "Float32" << -1234.1 << -1234.1;
    QTest::newRow("least float, declared in few digits") << "Float32" << -3.4028234663852886e38 << -3.402823e38;
    QTest::newRow("least float, undeclared") << "Float32" << -3.4028234663852886e38 << none;
    QTest::newRow("SRTM void, undeclared") << "Int16" << -32768.0 << none;
    QTest::newRow("SRTM void, another declared") << "Int16" << -32767.0 << -32768.0;
    QTest::newRow("ESRI void, undeclared") << "Int32" << -9999.0 << none;
    QTest::newRow("higher than any ground") << "Float32" << 32767.0 << none;
    QTest::newRow("infinite") << "Float32" << std::numeric_limits<double>::infinity() << none;
  }
  void readTerrain_voidsOfEveryKind_areUnknown() {
    QFETCH(QString, type);
    QFETCH(double, value);
    QFETCH(double, noData);
    const QTemporaryDir folder;
    auto spec = aligned(0.0, 300.0).filled(11, 11, [value](int column, int) { return column < 5 ? value : 100.0; });
    spec.type = type.toStdString();
    if (!std::isnan(noData)) {
      spec.noData = noData;
    }
    const ElevationGrid grid = read({writeRaster(folder, spec)});
    QCOMPARE(grid.upperInCell(2, 5), kUnknownUpper);
    QCOMPARE(grid.upperInCell(4, 5), kUnknownUpper);
    QCOMPARE(grid.upperInCell(5, 5), 100.0F);
  }

  void readTerrain_blocksThatWereNeverWritten_areUnknownAndNotSeaLevel() {
    const QTemporaryDir folder;
    auto spec = aligned(0.0, 3000.0).filled(64, 64, [](int column, int) { return column < 32 ? 0.0 : 100.0; });
    spec.options = {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", "SPARSE_OK=YES"};
    const ElevationGrid grid = read({writeRaster(folder, spec)});
    QCOMPARE(grid.upperInCell(10, 30), kUnknownUpper);
    QCOMPARE(grid.upperInCell(40, 30), 100.0F);
  }

  void readTerrain_layout_followsTheOptions() {
    const QTemporaryDir folder;
    const std::string file = writeRaster(folder, aligned(-1500.0, 1500.0).filled(101, 101, wave));
    const double highest = static_cast<double>(read({file}).upperAt({15.0, 15.0}));
    QVERIFY(highest > 0.0);
    ReadOptions options;
    options.cell = 100.0;
    QCOMPARE(read({file}, options).cellSize(), 100.0);
    QCOMPARE(read({file}, options).columns(), 30);
    options = {};
    options.maxCells = 400;
    const ElevationGrid coarse = read({file}, options);
    QVERIFY(coarse.values().size() <= 400 && coarse.values().size() > 250);
    QVERIFY(coarse.cellSize() >= 150.0);
    QVERIFY(coarse.isKnownAt({0.3, 0.7}));
  }

  void readTerrain_filesApart_leavesUnknownBetweenThem() {
    const QTemporaryDir folder;
    auto other = aligned(300'000.0, 300'000.0).filled(11, 11, wave);
    other.name = "other.tif";
    ReadOptions options;
    options.maxCells = 1'000'000;
    const ElevationGrid grid = read({writeRaster(folder, aligned(0.0, 3000.0).filled(101, 101, wave)), writeRaster(folder, other)}, options);
    QVERIFY(grid.values().size() <= options.maxCells);
    QVERIFY(grid.isKnownAt({1500.0, 1500.0}));
    QVERIFY(!grid.isKnownAt({150e3, 150e3}));
  }

  void readTerrain_stopped_isCancelled() {
    const QTemporaryDir folder;
    const std::string file = writeRaster(folder, aligned(0.0, 0.0).filled(400, 400, wave));
    std::stop_source before;
    before.request_stop();
    const auto none = readTerrain({file}, frame_, {}, Job(before.get_token()));
    QVERIFY(!none && none.error().code == Errc::Cancelled);
    for (const double when : {0.0, 0.5, 0.7}) {  // while reading, and while warping
      std::stop_source during;
      const Job job(during.get_token(), [&](double fraction, std::string_view) {
        if (fraction > when) {
          during.request_stop();
        }
      });
      const auto half = readTerrain({file}, frame_, {}, job);
      QVERIFY(!half && half.error().code == Errc::Cancelled);
    }
  }

  void readTerrain_progress_risesToOne() {
    const QTemporaryDir folder;
    std::vector<double> fractions;
    const Job job({}, [&](double fraction, std::string_view text) {
      QVERIFY(!text.empty());
      fractions.push_back(fraction);
    });
    QVERIFY(readTerrain({writeRaster(folder, aligned(0.0, 0.0).filled(300, 300, wave))}, frame_, {}, job).has_value());
    QVERIFY(fractions.size() > 10);
    QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
    QCOMPARE(fractions.back(), 1.0);
  }

  void readTerrain_fromSeveralThreads_givesTheSame() {
    const QTemporaryDir folder;
    const std::string file = writeRaster(folder, aligned(0.0, 0.0).filled(200, 200, wave));
    std::vector<std::vector<float>> values(4);
    {
      std::vector<std::jthread> threads;
      for (auto& result : values) {
        threads.emplace_back([&] { result = read({file}).values(); });
      }
    }
    for (const auto& result : values) {
      QCOMPARE(result, values.front());
      QVERIFY(!result.empty());
    }
  }

  void inspectTerrain_twoTiles_saysWhatTheyCover() {
    const QTemporaryDir folder;
    RasterSpec spec;
    spec.crs = "EPSG:4326";
    spec.withPosts(8.0, 47.0, 1.0 / 120, 1.0 / 120).filled(121, 121, wave);
    RasterSpec second = spec;
    second.name = "second.tif";
    second.withPosts(9.0, 47.0, 1.0 / 120, 1.0 / 120);
    const auto info = inspectTerrain({writeRaster(folder, spec), writeRaster(folder, second)});
    QVERIFY(info.has_value());
    QCOMPARE(info->files.size(), 2U);
    QCOMPARE(info->files[0].driver, std::string("GTiff"));
    QCOMPARE(info->files[0].crs, std::string("WGS 84"));
    QCOMPARE(info->files[0].columns, 121);
    QVERIFY(std::abs(info->southWest.latitude_deg - 46.0) < 1e-9 && std::abs(info->southWest.longitude_deg - 8.0) < 1e-9);
    QVERIFY(std::abs(info->northEast.latitude_deg - 47.0) < 1e-9 && std::abs(info->northEast.longitude_deg - 10.0) < 1e-9);
    QCOMPARE(info->centre(), (geo::LatLon{46.5, 9.0}));
    QVERIFY(std::abs(info->spacing_m - 111'320.0 * std::cos(46.5 * 0.017453293) / 120.0) < 3.0);
  }

private:
  geo::LocalFrame frame_{{46.8, 9.8}};
};

}  // namespace vp::terrain

using vp::terrain::TestTerrainReader;
QTEST_APPLESS_MAIN(TestTerrainReader)
#include "tst_terrain_reader.moc"
