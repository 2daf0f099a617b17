#include "ui/scene3d/camera_controller.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace vp::scene3d {
namespace {

constexpr double kPi = std::numbers::pi;

double duneHeight(geo::Point p) {
  return 300.0 + 150.0 * std::sin(p.x / 1500.0) + 100.0 * std::cos(p.y / 1100.0);
}

/// Rolling ground of 40 x 40 km, met by marching along the ray.
CameraGround dunes() {
  CameraGround ground;
  ground.heightAt = duneHeight;
  ground.extent.add({-20000.0, -20000.0, 0.0});
  ground.extent.add({20000.0, 20000.0, 600.0});
  ground.hit = [](Vec3 eye, Vec3 direction) -> std::optional<Vec3> {
    double before = 0.0;
    for (double t = 0.0; t < 2e5; t += 5.0) {
      const Vec3 p = eye + t * direction;
      if (p.z <= duneHeight(p.ground())) {
        double after = t;
        for (int i = 0; i < 50; ++i) {
          const double middle = 0.5 * (before + after);
          const Vec3 m = eye + middle * direction;
          (m.z <= duneHeight(m.ground()) ? after : before) = middle;
        }
        return eye + after * direction;
      }
      before = t;
    }
    return std::nullopt;
  };
  return ground;
}

CameraController controllerAt(double distance, double pitch) {
  CameraController controller;
  controller.setPicture(1280.0, 720.0);
  controller.setGround(dunes());
  controller.jumpTo({{1000.0, -500.0, duneHeight({1000.0, -500.0})}, distance, 0.7, pitch});
  return controller;
}

/// A circle of 2 km radius, 800 m high, flown counter-clockwise.
FlightPath circle() {
  FlightPath path;
  path.length = 2.0 * kPi * 2000.0;
  path.speed = 40.0;
  path.at = [](double distance) {
    const double angle = distance / 2000.0;
    return FlightPoint{{2000.0 * std::cos(angle), 2000.0 * std::sin(angle), 800.0}, angle + 0.5 * kPi};
  };
  return path;
}

void compareNear(Vec3 a, Vec3 b, double tolerance) {
  QVERIFY2(length(a - b) <= tolerance, qPrintable(QStringLiteral("%1 m apart").arg(length(a - b))));
}

}  // namespace

class TstCameraController : public QObject {
  Q_OBJECT

private slots:
  void project_ofRayThrough_givesThePixelBack();
  void matrices_agreeWithProject();
  void orbitBy_keepsThePivotInTheMiddle();
  void zoomAt_keepsTheGroundUnderThePointer();
  void panTo_keepsTheHeldGroundUnderThePointer();
  void anyMovement_staysAboveTheGround();
  void fitted_showsTheWholeBox();
  void flyTo_arrivesWhereverTheStepsEnd();
  void fly_staysOnTheTour();
  void fly_isIndependentOfTheFrameRate();
  void follow_turnsWithTheAircraft();
  void maySee_isTrueForAllThatIsSeen();
};

void TstCameraController::project_ofRayThrough_givesThePixelBack() {
  const CameraState camera = controllerAt(5000.0, 0.5).camera();
  for (const double x : {10.0, 640.0, 1200.0}) {
    for (const double y : {5.0, 360.0, 700.0}) {
      const auto at = camera.project(camera.eye + 3210.0 * camera.rayThrough(x, y));
      QVERIFY(at.has_value());
      QVERIFY(std::abs(at->x - x) < 1e-6 && std::abs(at->y - y) < 1e-6);
    }
  }
}

void TstCameraController::matrices_agreeWithProject() {
  const CameraState camera = controllerAt(5000.0, 0.5).camera();
  const Vec3 p{1500.0, 200.0, 450.0};
  const auto view = camera.viewMatrix();
  const auto projection = camera.projectionMatrix();
  const auto times = [](const std::array<double, 16>& m, const std::array<double, 4>& v) {
    std::array<double, 4> r{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        r[i] += m[k * 4 + i] * v[k];
      }
    }
    return r;
  };
  const auto clip = times(projection, times(view, {p.x, p.y, p.z, 1.0}));
  const auto at = camera.project(p);
  QVERIFY(at.has_value());
  QVERIFY(std::abs((clip[0] / clip[3] + 1.0) * 640.0 - at->x) < 1e-6);
  QVERIFY(std::abs((1.0 - clip[1] / clip[3]) * 360.0 - at->y) < 1e-6);
}

void TstCameraController::orbitBy_keepsThePivotInTheMiddle() {
  CameraController controller = controllerAt(4000.0, 0.6);
  const Vec3 pivot = controller.orbit().pivot;
  for (int i = 0; i < 40; ++i) {
    controller.orbitBy(0.3, i % 2 == 0 ? 0.05 : -0.07);
    const auto at = controller.camera().project(pivot);
    QVERIFY(at.has_value());
    QVERIFY(std::abs(at->x - 640.0) < 1e-6 && std::abs(at->y - 360.0) < 1e-6);
    QVERIFY(std::abs(at->depth - 4000.0) < 1e-6);
  }
}

void TstCameraController::zoomAt_keepsTheGroundUnderThePointer() {
  for (const double factor : {1.3, 0.8, 2.5}) {
    CameraController controller = controllerAt(6000.0, 0.7);
    const double x = 900.0;
    const double y = 500.0;
    const CameraState before = controller.camera();
    const Vec3 ground = dunes().hit(before.eye, before.rayThrough(x, y)).value();
    controller.zoomAt(factor, x, y);
    const CameraState after = controller.camera();
    const auto at = after.project(ground);
    QVERIFY(at.has_value());
    QVERIFY2(std::hypot(at->x - x, at->y - y) < 0.5, qPrintable(QStringLiteral("factor %1: %2 %3").arg(factor).arg(at->x).arg(at->y)));
    const double ratio = length(before.eye - ground) / length(after.eye - ground);
    QVERIFY2(std::abs(ratio - factor) < 0.01 * factor, qPrintable(QString::number(ratio)));
  }
}

void TstCameraController::panTo_keepsTheHeldGroundUnderThePointer() {
  CameraController controller = controllerAt(6000.0, 0.7);
  const CameraState before = controller.camera();
  const Vec3 ground = dunes().hit(before.eye, before.rayThrough(400.0, 500.0)).value();
  controller.beginPan(400.0, 500.0);
  for (int i = 1; i <= 20; ++i) {
    controller.panTo(400.0 + 15.0 * i, 500.0 - 8.0 * i);
    const auto at = controller.camera().project(ground);
    QVERIFY(at.has_value());
    QVERIFY(std::hypot(at->x - (400.0 + 15.0 * i), at->y - (500.0 - 8.0 * i)) < 0.01);
  }
  const Vec3 eye = controller.camera().eye;
  controller.endPan();
  compareNear(controller.camera().eye, eye, 1e-6);
  compareNear(controller.camera().forward, before.forward, 1e-9);
}

void TstCameraController::anyMovement_staysAboveTheGround() {
  CameraController controller = controllerAt(3000.0, 0.4);
  const auto verifyAbove = [&](const char* what, int i) {
    const Vec3 eye = controller.camera().eye;
    const double above = eye.z - duneHeight(eye.ground());
    QVERIFY2(above >= CameraController::kClearance - 1.0, qPrintable(QStringLiteral("%1 %2: %3 m").arg(QLatin1String(what)).arg(i).arg(above)));
  };
  for (int i = 0; i < 60; ++i) {
    controller.orbitBy(0.1, -0.1);
    verifyAbove("orbit", i);
    controller.zoomAt(1.4, 100.0 + 15.0 * i, 500.0);
    verifyAbove("zoom", i);
    controller.panBy(0.3, 0.4);
    verifyAbove("pan", i);
    if (i % 10 == 9) {
      controller.zoomAt(0.05, 640.0, 360.0);
    }
  }
}

void TstCameraController::fitted_showsTheWholeBox() {
  const CameraController controller = controllerAt(3000.0, 0.4);
  Bounds box;
  box.add({-4000.0, 2000.0, 300.0});
  box.add({9000.0, 8000.0, 2400.0});
  for (const double pitch : {0.3, 0.62, CameraController::kHighestPitch}) {
    CameraController shown = controllerAt(1000.0, 0.5);
    shown.jumpTo(controller.fitted(box, 0.5 * kPi, pitch));
    const CameraState camera = shown.camera();
    double widest = 0.0;
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner{(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y, (k & 4) != 0 ? box.high.z : box.low.z};
      const auto at = camera.project(corner);
      QVERIFY(at.has_value());
      QVERIFY(at->x > 0.0 && at->x < 1280.0 && at->y > 0.0 && at->y < 720.0);
      widest = std::max({widest, std::abs(at->x - 640.0) / 640.0, std::abs(at->y - 360.0) / 360.0});
    }
    QVERIFY2(widest > 0.8, "the box fills the picture");
  }
}

void TstCameraController::flyTo_arrivesWhereverTheStepsEnd() {
  for (const double step : {0.004, 0.016, 0.3}) {
    CameraController controller = controllerAt(3000.0, 0.5);
    const CameraOrbit goal{{-3000.0, 4000.0, 300.0}, 9000.0, -2.0, 0.8};
    controller.flyTo(goal);
    QVERIFY(controller.isMoving());
    for (double t = 0.0; t < 1.3; t += step) {
      controller.advance(step);
    }
    QVERIFY(!controller.isMoving());
    compareNear(controller.orbit().pivot, goal.pivot, 1e-6);
    QVERIFY(std::abs(controller.orbit().distance - goal.distance) < 1e-6);
    QVERIFY(std::abs(turnBetween(controller.orbit().azimuth, goal.azimuth)) < 1e-9);
  }
}

void TstCameraController::fly_staysOnTheTour() {
  CameraController controller = controllerAt(3000.0, 0.5);
  controller.setPath(circle());
  controller.follow(100.0);
  controller.fly(10.0);
  double flown = 0.0;
  for (int i = 0; i < 400; ++i) {
    controller.advance(0.02);
    flown += 0.02;
    if (flown < CameraController::kFlightSeconds + 0.1) {
      continue;  // still on its way there
    }
    const double distance = controller.followedDistance().value();
    compareNear(controller.orbit().pivot, circle().at(distance).position, 1e-6);
  }
  const double expected = 100.0 + 10.0 * 40.0 * flown;
  QVERIFY(std::abs(controller.followedDistance().value() - std::fmod(expected, circle().length)) < 10.0);
}

void TstCameraController::fly_isIndependentOfTheFrameRate() {
  const auto after = [](double step, int count) {
    CameraController controller = controllerAt(3000.0, 0.5);
    controller.setPath(circle());
    controller.fly(5.0);
    for (int i = 0; i < count; ++i) {
      controller.advance(step);
    }
    return controller;
  };
  const CameraController fast = after(1.0 / 120.0, 480);
  const CameraController slow = after(1.0 / 10.0, 40);
  QCOMPARE(fast.followedDistance().value(), slow.followedDistance().value());
  compareNear(fast.camera().eye, slow.camera().eye, 1e-6);
}

void TstCameraController::follow_turnsWithTheAircraft() {
  CameraController controller = controllerAt(3000.0, 0.5);
  controller.setPath(circle());
  controller.follow(0.0);
  for (int i = 0; i < 300; ++i) {
    controller.advance(0.02);
  }
  QVERIFY(std::abs(turnBetween(controller.orbit().azimuth, circle().at(0.0).heading + CameraController::kBesideTurn)) < 0.01);
  controller.orbitBy(1.0, 0.0);
  controller.follow(3000.0);
  for (int i = 0; i < 300; ++i) {
    controller.advance(0.02);
  }
  const double expected = circle().at(3000.0).heading + CameraController::kBesideTurn + 1.0;
  QVERIFY2(std::abs(turnBetween(controller.orbit().azimuth, expected)) < 0.01, "the chosen side stays");
  controller.stopFollowing();
  QVERIFY(!controller.isMoving());
}

void TstCameraController::maySee_isTrueForAllThatIsSeen() {
  const CameraState camera = controllerAt(5000.0, 0.5).camera();
  int hidden = 0;
  for (int i = 0; i < 4000; ++i) {
    const double a = 0.61803398875 * i;
    const double b = 0.75487766625 * i;
    const Vec3 p{(a - std::floor(a) - 0.5) * 30000.0, (b - std::floor(b) - 0.5) * 30000.0, 300.0};
    Bounds box;
    box.add(p - Vec3{200.0, 100.0, 50.0});
    box.add(p + Vec3{100.0, 300.0, 80.0});
    const auto at = camera.project(p);
    const bool isSeen = at && at->x > 0.0 && at->x < 1280.0 && at->y > 0.0 && at->y < 720.0;
    QVERIFY(!isSeen || camera.maySee(box));
    hidden += camera.maySee(box) ? 0 : 1;
  }
  QVERIFY2(hidden > 1000, "most of what is behind the camera is left out");
}

}  // namespace vp::scene3d

QTEST_APPLESS_MAIN(vp::scene3d::TstCameraController)
#include "tst_camera_controller.moc"
