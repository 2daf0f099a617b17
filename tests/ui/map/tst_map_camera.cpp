// The camera of the map: round trips, zooming at a point, fitting.
#include "ui/map/map_camera.h"

#include <QTest>

#include <random>

using namespace vp;
using namespace vp::map;

namespace {

constexpr unsigned kSeed = 7;

bool near(geo::Point a, geo::Point b, double within) {
  return geo::distance(a, b) <= within;
}

}  // namespace

class TestMapCamera : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void northIsUp() {
    const MapCamera camera({1000.0, 2000.0}, 10.0, {400.0, 300.0});
    QCOMPARE(camera.toScreen({1000.0, 2000.0}), QPointF(200.0, 150.0));
    QCOMPARE(camera.toScreen({1100.0, 2000.0}), QPointF(210.0, 150.0));
    QCOMPARE(camera.toScreen({1000.0, 2100.0}), QPointF(200.0, 140.0));
  }

  void roundTrip_underRandomCameras_comesBack() {
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> place(-2e5, 2e5);
    std::uniform_real_distribution<double> pixel(0.0, 2000.0);
    std::uniform_real_distribution<double> octave(-4.0, 12.0);
    for (int i = 0; i < 10000; ++i) {
      const MapCamera camera({place(random), place(random)}, std::exp2(octave(random)), {pixel(random) + 1.0, pixel(random) + 1.0});
      const QPointF at(pixel(random), pixel(random));
      const QPointF back = camera.toScreen(camera.toGround(at));
      QVERIFY(std::abs(back.x() - at.x()) < 1e-4 && std::abs(back.y() - at.y()) < 1e-4);
    }
  }

  void zoom_underRandomAnchors_keepsTheGroundThere() {
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> pixel(0.0, 1000.0);
    std::uniform_real_distribution<double> factor(0.3, 3.0);
    MapCamera camera({5e4, -3e4}, 30.0, {1000.0, 800.0});
    for (int i = 0; i < 10000; ++i) {
      const QPointF anchor(pixel(random), pixel(random));
      const geo::Point held = camera.toGround(anchor);
      const MapCamera zoomed = camera.zoomedAt(anchor, factor(random));
      QVERIFY(near(zoomed.toGround(anchor), held, 1e-6));
      QVERIFY(zoomed.metresPerPixel() >= 0.99 * MapCamera::kFinest && zoomed.metresPerPixel() <= 1.01 * MapCamera::kCoarsest);
    }
  }

  void zoom_inAndOut_givesTheSameScaleBit_forBit() {
    const MapCamera start = MapCamera({0.0, 0.0}, 40.0, {800.0, 600.0}).withScale(40.0);
    MapCamera camera = start;
    for (int i = 0; i < 9; ++i) {
      camera = camera.zoomedAt({100.0, 100.0}, 1.41);
    }
    QVERIFY(camera.metresPerPixel() < 3.0);
    for (int i = 0; i < 9; ++i) {
      camera = camera.zoomedAt({300.0, 20.0}, 1.0 / 1.41);
    }
    QCOMPARE(camera.metresPerPixel(), start.metresPerPixel());
  }

  void fit_underBox_showsAllOfItAndNotMuchMore() {
    const geo::Box box{-3000.0, 1000.0, 9000.0, 4000.0};
    const MapCamera camera = MapCamera({}, 1.0, {800.0, 600.0}).fittedTo(box, 40.0);
    const QRectF inner = camera.screen().adjusted(39.999, 39.999, -39.999, -39.999);
    QVERIFY(inner.contains(camera.toScreen({box.minX, box.minY})));
    QVERIFY(inner.contains(camera.toScreen({box.maxX, box.maxY})));
    QVERIFY((box.maxX - box.minX) / camera.metresPerPixel() > 0.95 * 720.0);
    QCOMPARE(MapCamera({}, 1.0, {800.0, 600.0}).fittedTo(geo::Box{}, 40.0), MapCamera({}, 1.0, {800.0, 600.0}));
  }

  void pan_movesThePictureWithTheMouse() {
    const MapCamera camera({0.0, 0.0}, 5.0, {400.0, 300.0});
    const geo::Point under = camera.toGround({100.0, 80.0});
    QVERIFY(near(camera.panned({30.0, -12.0}).toGround({130.0, 68.0}), under, 1e-9));
  }

  void visible_isWhatTheCornersShow() {
    const MapCamera camera({100.0, 50.0}, 2.0, {400.0, 300.0});
    const geo::Box box = camera.visible();
    QCOMPARE(box.minX, -300.0);
    QCOMPARE(box.maxX, 500.0);
    QCOMPARE(box.minY, -250.0);
    QCOMPARE(box.maxY, 350.0);
  }
};

QTEST_APPLESS_MAIN(TestMapCamera)
#include "tst_map_camera.moc"
