// Names, extents and limits of terrain tiles.
#include "core/fetch/cache_folder.h"
#include "core/fetch/tile.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::fetch;

class TestTile : public QObject {
  Q_OBJECT

private slots:
  void name_isThatOfTheBucket() {
    QCOMPARE(nameOf({46, 8}), std::string("Copernicus_DSM_COG_10_N46_00_E008_00_DEM"));
    QCOMPARE(nameOf({-36, 149}), std::string("Copernicus_DSM_COG_10_S36_00_E149_00_DEM"));
    QCOMPARE(nameOf({0, -1}), std::string("Copernicus_DSM_COG_10_N00_00_W001_00_DEM"));
    QCOMPARE(urlOf("http://x", {46, 8}),
             std::string("http://x/Copernicus_DSM_COG_10_N46_00_E008_00_DEM/Copernicus_DSM_COG_10_N46_00_E008_00_DEM.tif"));
  }

  void columns_shrinkWithLatitude_data() {
    QTest::addColumn<int>("south");
    QTest::addColumn<int>("columns");
    const std::pair<int, int> rows[] = {{0, 3600}, {49, 3600}, {50, 2400},  {59, 2400},  {60, 1800},  {70, 1200},  {80, 720},  {84, 720},
                                        {85, 360}, {89, 360},  {-50, 3600}, {-51, 2400}, {-61, 1800}, {-71, 1200}, {-81, 720}, {-86, 360}};
    for (const auto& [south, columns] : rows) {
      QTest::addRow("%d", south) << south << columns;
    }
  }
  void columns_shrinkWithLatitude() {
    QFETCH(int, south);
    QTEST(columnsOf({south, 0}), "columns");
  }

  void tilesUnder_aBox_goNorthToSouth() {
    const Result<std::vector<TileId>> tiles = tilesUnder({{45.9, 7.9}, {46.1, 8.1}});
    QVERIFY(tiles.has_value());
    QCOMPARE(tiles->size(), std::size_t{4});
    QCOMPARE(tiles->front(), (TileId{46, 7}));
    QCOMPARE(tiles->back(), (TileId{45, 8}));
    QCOMPARE(tilesUnder({{46.0, 8.0}, {47.0, 9.0}})->size(), std::size_t{1});  // ends on full degrees: one tile
    QCOMPARE(tilesUnder({{-36.0, -1.0}, {-35.0, 0.0}})->front(), (TileId{-36, -1}));
  }

  void tilesUnder_nonsense_isRefusedWithTheReason_data() {
    QTest::addColumn<double>("west");
    QTest::addColumn<double>("south");
    QTest::addColumn<double>("east");
    QTest::addColumn<double>("north");
    QTest::addColumn<QString>("reason");
    QTest::newRow("the world") << -180.0 << -90.0 << 180.0 << 90.0 << "64800 tiles";
    QTest::newRow("empty") << 8.0 << 46.0 << 8.0 << 46.0 << "empty";
    QTest::newRow("exchanged") << 9.0 << 46.0 << 8.0 << 47.0 << "west lies east";
    QTest::newRow("not on earth") << 8.0 << 46.0 << 9.0 << 97.0 << "not on earth";
    QTest::newRow("no number") << std::nan("") << 46.0 << 9.0 << 47.0 << "not on earth";
  }
  void tilesUnder_nonsense_isRefusedWithTheReason() {
    QFETCH(double, west);
    QFETCH(double, south);
    QFETCH(double, east);
    QFETCH(double, north);
    QFETCH(QString, reason);
    const Result<std::vector<TileId>> tiles = tilesUnder({{south, west}, {north, east}});
    QVERIFY(!tiles.has_value());
    QCOMPARE(tiles.error().code, Errc::OutOfRange);
    QVERIFY2(QString::fromStdString(tiles.error().what).contains(reason), tiles.error().what.c_str());
  }

  void boxAround_aPlace_holdsTheCircle() {
    const unsigned seed = 20240611;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 10'000; ++i) {
      const geo::LatLon place{-80.0 + 160.0 * unit(random), -150.0 + 300.0 * unit(random)};
      const double radius = 100.0 + 99'900.0 * unit(random);
      const Result<geo::GeoBox> box = boxAround(place, radius);
      QVERIFY(box.has_value());
      const geo::LatLon rim = geo::geodesicDestination(place, Angle::degrees(360.0 * unit(random)), Length::fromSi(radius));
      QVERIFY2(box->contains(rim), qPrintable(QString("%1 %2 %3").arg(place.latitude_deg).arg(place.longitude_deg).arg(radius)));
      // and wastes no more than a fortieth
      const double width = box->northEast.longitude_deg - box->southWest.longitude_deg;
      QVERIFY(geo::geodesicDistance(place, {place.latitude_deg, place.longitude_deg + width / 2.0}).si() <
              1.025 * radius + 0.05 * radius * (std::abs(place.latitude_deg) > 60.0 ? 1.0 : 0.0));
    }
    QVERIFY(!boxAround({89.9, 0.0}, 50'000.0).has_value());
    QVERIFY(!boxAround({0.0, 179.9}, 50'000.0).has_value());
    QVERIFY(!boxAround({0.0, 0.0}, 1.0).has_value());
  }

  void missingTile_overLandThatIsNotPublished_isNotSea() {
    QVERIFY(isWithheld({40, 44}));  // Yerevan
    QVERIFY(isWithheld({40, 49}));  // Baku
    QVERIFY(!isWithheld({46, 8}));
    QVERIFY(!isWithheld({40, -10}));
  }

  void cacheFolder_followsXdg() {
    qputenv("XDG_CACHE_HOME", "/somewhere/cache");
    QCOMPARE(*cacheFolder(), std::string("/somewhere/cache/volplane"));
    qputenv("XDG_CACHE_HOME", "relative");  // to be ignored
    qputenv("HOME", "/home/pilot");
    QCOMPARE(*cacheFolder(), std::string("/home/pilot/.cache/volplane"));
    qunsetenv("HOME");
    qunsetenv("XDG_CACHE_HOME");
    QVERIFY(!cacheFolder().has_value());
    QCOMPARE(folderOfServer("/c", "terrain", "http://127.0.0.1:80/../x"), std::string("/c/terrain/127.0.0.1_80_.._x"));
  }

  void address_ofNoServer_isRefused() {
    QCOMPARE(*checkedBase("http://x/y//"), std::string("http://x/y"));
    for (const char* bad : {"", "ftp://x", "x.org", "https://", "https:///", "https://a b", "file:///etc"}) {
      QVERIFY2(!checkedBase(bad).has_value(), bad);
    }
  }
};

QTEST_APPLESS_MAIN(TestTile)
#include "tst_tile.moc"
