// Tiles from workers: the same pixels as painting at once, nothing blank on the way, bounded memory, prompt end.
#include "tests/ui/map/map_fixture.h"
#include "ui/map/relief_painter.h"
#include "ui/map/tile_layer.h"

#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <cmath>
#include <semaphore>

using namespace vp;
using namespace vp::map;
using namespace vp::map::testing;

namespace {

const QColor kBlank(1, 2, 3);

double rough(double x, double y) {
  return 1500.0 + 600.0 * std::sin(x / 700.0) * std::cos(y / 900.0);
}

std::shared_ptr<const ReliefPainter> reliefOf(style::Theme theme = style::Theme::Light) {
  static const auto terrain = groundOf(rough);
  return std::make_shared<const ReliefPainter>(std::make_shared<const HeightLevels>(terrain->grid),
                                               ReliefStyle{theme, style::UnitSystem::Metric, true, 0.0, 4000.0});
}

QImage drawn(TileLayer& layer, const MapCamera& camera, double ratio = 1.0) {
  QImage image((camera.size() * ratio).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(kBlank);
  QPainter painter(&image);
  layer.draw(painter, camera, ratio);
  return image;
}

QImage drawnNow(const TilePainter& tiles, const MapCamera& camera, double ratio = 1.0) {
  QImage image((camera.size() * ratio).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(kBlank);
  QPainter painter(&image);
  TileLayer::drawNow(painter, tiles, camera, ratio);
  return image;
}

/// Draws until everything is there.
bool complete(TileLayer& layer, const MapCamera& camera, double ratio = 1.0) {
  return QTest::qWaitFor([&] {
    drawn(layer, camera, ratio);
    return layer.isComplete();
  });
}

/// Waits in paint() until it is let go.
class SlowPainter : public TilePainter {
public:
  [[nodiscard]] QImage paint(const PixelWindow& window, double /*devicePixelRatio*/) const override {
    ++started;
    gate.acquire();
    QImage image(window.width, window.height, QImage::Format_RGB32);
    image.fill(Qt::red);
    return image;
  }
  [[nodiscard]] geo::Box extent() const override { return {}; }
  void abandon() const override { gate.release(1000); }

  mutable std::atomic<int> started = 0;
  mutable std::counting_semaphore<100000> gate{0};
};

}  // namespace

class TestTileLayer : public QObject {
  Q_OBJECT

private slots:
  void draw_whenComplete_equalsPaintingAtOnce_data() {
    QTest::addColumn<double>("ratio");
    QTest::newRow("1") << 1.0;
    QTest::newRow("1.5") << 1.5;
    QTest::newRow("2") << 2.0;
  }
  void draw_whenComplete_equalsPaintingAtOnce() {
    QFETCH(double, ratio);
    TileLayer layer(64);
    const auto relief = reliefOf();
    layer.setPainter(relief, TileLayer::OldTiles::Drop);
    const MapCamera camera({123.4, -567.8}, 8.0, {500.0, 360.0});
    QVERIFY(complete(layer, camera, ratio));
    QCOMPARE(drawn(layer, camera, ratio), drawnNow(*relief, camera, ratio));
  }

  void zoom_beforeTilesArrive_showsStandInsWithoutBlanks() {
    TileLayer layer(64);
    layer.setPainter(reliefOf(), TileLayer::OldTiles::Drop);
    const MapCamera camera({0.0, 0.0}, 16.0, {400.0, 300.0});
    QVERIFY(complete(layer, camera));
    QTRY_COMPARE(layer.keptTiles(), std::size_t{20});  // 2 x 2 in view, the ring around them, 2 x 2 parents
    for (const double factor : {2.0, 1.3, 0.5}) {
      const MapCamera zoomed = camera.zoomedAt({200.0, 150.0}, factor);
      const QImage image = drawn(layer, zoomed);
      QVERIFY(!layer.isComplete());
      const int blank = countColor(image, kBlank, 0);
      QVERIFY2(blank == 0, qPrintable(QStringLiteral("%1: %2").arg(factor).arg(blank)));
    }
  }

  void restyle_beforeTilesArrive_keepsTheOldOnes() {
    TileLayer layer(64);
    layer.setPainter(reliefOf(), TileLayer::OldTiles::Drop);
    const MapCamera camera({0.0, 0.0}, 16.0, {400.0, 300.0});
    QVERIFY(complete(layer, camera));
    const QImage light = drawn(layer, camera);
    const auto dark = reliefOf(style::Theme::Dark);
    layer.setPainter(dark, TileLayer::OldTiles::Keep);
    QCOMPARE(drawn(layer, camera), light);
    QVERIFY(complete(layer, camera));
    QCOMPARE(drawn(layer, camera), drawnNow(*dark, camera));
  }

  void otherPlace_dropsTheOldTilesAtOnce() {
    TileLayer layer(64);
    layer.setPainter(reliefOf(), TileLayer::OldTiles::Drop);
    const MapCamera camera({0.0, 0.0}, 16.0, {400.0, 300.0});
    QVERIFY(complete(layer, camera));
    layer.setPainter(nullptr, TileLayer::OldTiles::Drop);
    QCOMPARE(countColor(drawn(layer, camera), kBlank, 0), 400 * 300);
    QCOMPARE(layer.keptBytes(), std::size_t{0});
  }

  void pan_underMuchGround_keepsMemoryBounded() {
    TileLayer layer(8);
    layer.setPainter(reliefOf(), TileLayer::OldTiles::Drop);
    for (int i = 0; i < 12; ++i) {
      QVERIFY(complete(layer, MapCamera({i * 3000.0, 0.0}, 4.0, {400.0, 300.0})));
    }
    QVERIFY2(layer.keptBytes() <= (std::size_t{8} << 20U), qPrintable(QString::number(layer.keptBytes())));
    QVERIFY(layer.keptTiles() > 4);
  }

  void draw_neverWaitsForTheWorker() {
    auto slow = std::make_shared<SlowPainter>();
    TileLayer layer(64);
    QSignalSpy arrived(&layer, &TileLayer::tilesArrived);
    layer.setPainter(slow, TileLayer::OldTiles::Drop);
    const MapCamera camera({0.0, 0.0}, 16.0, {200.0, 200.0});
    QCOMPARE(countColor(drawn(layer, camera), kBlank, 0), 200 * 200);
    QTRY_VERIFY(slow->started > 0);
    QCOMPARE(arrived.count(), 0);
    slow->gate.release(1000);
    QVERIFY(complete(layer, camera));
    QCOMPARE(countColor(drawn(layer, camera), Qt::red, 0), 200 * 200);
    QVERIFY(arrived.count() > 0);
  }

  void destruction_underWork_abandonsIt() {
    auto slow = std::make_shared<SlowPainter>();
    auto layer = std::make_unique<TileLayer>(64);
    layer->setPainter(slow, TileLayer::OldTiles::Drop);
    drawn(*layer, MapCamera({0.0, 0.0}, 16.0, {2000.0, 2000.0}));
    QTRY_VERIFY(slow->started > 0);
    layer.reset();  // would hang if it waited for all 100 tiles
    QVERIFY(slow->started < 20);
  }
};

QTEST_MAIN(TestTileLayer)
#include "tst_tile_layer.moc"
