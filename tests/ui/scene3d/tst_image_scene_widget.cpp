#include "tests/ui/scene3d/picture_check.h"
#include "tests/ui/scene3d/scene_fixture.h"
#include "ui/scene3d/image_scene_widget.h"
#include "ui/scene3d/scene_tool_bar.h"
#include "ui/scene3d/scene_view_factory.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <memory>

namespace vp::scene3d {
namespace {

constexpr int kSettleMs = 20000;

/// A shown view of the fixture, drawn at its best.
struct Shown {
  document::ViewState state;
  std::unique_ptr<ImageSceneWidget> view = std::make_unique<ImageSceneWidget>(state, nullptr);
  document::Situation situation = test::sceneSituation();
  std::shared_ptr<const TerrainModel> model = TerrainModel::build(situation.terrain);

  Shown() {
    view->resize(640, 400);
    view->show();
    view->setSituation(situation);
  }
  /// The terrain is there and the camera at home; the picture may not be drawn yet.
  [[nodiscard]] bool loads() const {
    return QTest::qWaitFor([this] { return view->findChild<QLabel*>()->isHidden(); }, kSettleMs);
  }
  [[nodiscard]] bool settles() const {
    return QTest::qWaitFor([this] { return view->isSettled(); }, kSettleMs);
  }
  [[nodiscard]] QPoint placeOf(double distance) const {
    const document::TourState s = situation.plan->at(distance);
    const auto at = view->camera().project({s.pose.x, s.pose.y, s.altitude * view->options().verticalExaggeration});
    return at ? QPoint(static_cast<int>(std::lround(at->x)), static_cast<int>(std::lround(at->y))) : QPoint(-1, -1);
  }
};

void wheel(QWidget& widget, QPoint at, int units) {
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, units}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace

class TstImageSceneWidget : public QObject {
  Q_OBJECT

private slots:
  void factory_underOffscreenMakesNoOpenGlWidget();
  void view_showsTheTourWhereItIs();
  void hovering_setsTheSharedCursorAndLeavingClearsIt();
  void click_pinsTheTourAndSelectsTargets();
  void cursor_ofAnotherViewDrawsItsGlide();
  void leftDrag_movesTheGroundWithTheMouse();
  void wheel_zoomsAtThePointer();
  void keys_moveTheCamera();
  void middleDrag_orbitsAboutThePivot();
  void flight_movesTheSharedCursorAndStops();
  void exaggeration_keepsThePlaceAndIsLimited();
  void placeRequested_bringsItToTheMiddle();
  void themeChanged_changesThePicture();
  void newTerrain_whileBuilding_isTheOneShown();
  void emptySituation_saysWhatToDo();
  void toolBar_drivesTheViewAndShowsItsState();
  void toolBar_underLittleWidth_offersAllInItsMenu();
  void destruction_whileBusy_isClean();
};

void TstImageSceneWidget::factory_underOffscreenMakesNoOpenGlWidget() {
  QCOMPARE(QGuiApplication::platformName(), QStringLiteral("offscreen"));
  QCOMPARE(sceneHost(), SceneHost::Images);
  document::ViewState state;
  const std::unique_ptr<SceneView> view(createSceneView(state, nullptr));
  QVERIFY(qobject_cast<ImageSceneWidget*>(view.get()) != nullptr);
  QVERIFY(view->findChildren<QOpenGLWidget*>().isEmpty());
  view->show();
  QVERIFY(QTest::qWaitForWindowExposed(view.get()));
}

void TstImageSceneWidget::view_showsTheTourWhereItIs() {
  const Shown shown;
  QVERIFY(shown.settles());
  QVERIFY2(shown.view->problem().isEmpty(), qPrintable(shown.view->problem()));
  QVERIFY(!shown.view->rendererName().isEmpty());
  const double part = test::tourShown(shown.view->picture(), *shown.situation.plan, *shown.model, shown.view->camera(), 1.0);
  QVERIFY2(part > 0.9, qPrintable(QString::number(part)));
  // and so it is on the widget, under the overlay
  const QImage grabbed = shown.view->grab().toImage();
  QVERIFY(test::tourShown(grabbed, *shown.situation.plan, *shown.model, shown.view->camera(), 1.0) > 0.8);
}

void TstImageSceneWidget::hovering_setsTheSharedCursorAndLeavingClearsIt() {
  Shown shown;
  QVERIFY(shown.loads());
  QTest::mouseMove(shown.view.get(), shown.placeOf(1500.0));
  QTRY_VERIFY(shown.state.hovered().has_value());
  QVERIFY(std::abs(*shown.state.hovered() - 1500.0) < 60.0);
  QTest::mouseMove(shown.view.get(), QPoint(5, 200));
  QTRY_VERIFY(!shown.state.hovered().has_value());
  QTest::mouseMove(shown.view.get(), shown.placeOf(2500.0));
  QTRY_VERIFY(shown.state.hovered().has_value());
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(shown.view.get(), &leave);
  QVERIFY(!shown.state.hovered().has_value());
}

void TstImageSceneWidget::click_pinsTheTourAndSelectsTargets() {
  Shown shown;
  QVERIFY(shown.loads());
  QTest::mouseClick(shown.view.get(), Qt::LeftButton, {}, shown.placeOf(2600.0));
  QVERIFY(shown.state.pinned().has_value());
  QVERIFY(std::abs(*shown.state.pinned() - 2600.0) < 60.0);
  const document::ShownTarget& target = (*shown.situation.targets)[1];
  const auto head = shown.view->camera().project({target.point.x, target.point.y, *target.altitude});
  QTest::mouseClick(shown.view.get(), Qt::LeftButton, {}, QPoint(static_cast<int>(head->x), static_cast<int>(head->y)));
  QCOMPARE(shown.state.selectedTarget(), 1);
}

void TstImageSceneWidget::cursor_ofAnotherViewDrawsItsGlide() {
  Shown shown;
  QVERIFY(shown.settles());
  const QImage before = shown.view->picture();
  shown.state.setPinned(500.0);
  QTRY_VERIFY_WITH_TIMEOUT(shown.view->isSettled() && shown.view->picture() != before, kSettleMs);
  const document::EngineOut glide = shown.situation.plan->engineOutAt(500.0);
  const document::GlidePoint& middle = glide.path[glide.path.size() / 2];
  const auto at = shown.view->camera().project({middle.pose.x, middle.pose.y, middle.altitude});
  const QPoint p(static_cast<int>(at->x), static_cast<int>(at->y));
  QVERIFY(shown.view->picture().copy(QRect(p - QPoint(3, 3), QSize(7, 7))) != before.copy(QRect(p - QPoint(3, 3), QSize(7, 7))));
  shown.state.setPinned(std::nullopt);
  QTRY_VERIFY_WITH_TIMEOUT(shown.view->isSettled() && shown.view->picture() == before, kSettleMs);
}

void TstImageSceneWidget::leftDrag_movesTheGroundWithTheMouse() {
  Shown shown;
  QVERIFY(shown.loads());
  const CameraState before = shown.view->camera();
  const Vec3 ground = shown.model->hit(before.eye, before.rayThrough(300.0, 250.0), 1.0, 1e6).value();
  QTest::mousePress(shown.view.get(), Qt::LeftButton, {}, QPoint(300, 250));
  QTest::mouseMove(shown.view.get(), QPoint(340, 255));
  QTest::mouseMove(shown.view.get(), QPoint(380, 270));
  const auto at = shown.view->camera().project(ground);
  QVERIFY2(std::hypot(at->x - 380.0, at->y - 270.0) < 1.0, qPrintable(QStringLiteral("%1 %2").arg(at->x).arg(at->y)));
  QTest::mouseRelease(shown.view.get(), Qt::LeftButton, {}, QPoint(380, 270));
  QVERIFY(!shown.state.pinned().has_value());  // a drag is no click
}

void TstImageSceneWidget::wheel_zoomsAtThePointer() {
  Shown shown;
  QVERIFY(shown.loads());
  const CameraState before = shown.view->camera();
  const Vec3 ground = shown.model->hit(before.eye, before.rayThrough(200.0, 260.0), 1.0, 1e6).value();
  wheel(*shown.view, QPoint(200, 260), 360);
  const CameraState after = shown.view->camera();
  const auto at = after.project(ground);
  QVERIFY(std::hypot(at->x - 200.0, at->y - 260.0) < 1.0);
  QVERIFY(length(after.eye - ground) < 0.8 * length(before.eye - ground));
}

void TstImageSceneWidget::keys_moveTheCamera() {
  Shown shown;
  QVERIFY(shown.loads());
  const CameraState home = shown.view->camera();
  QTest::keyClick(shown.view.get(), Qt::Key_1);
  QTRY_VERIFY(!shown.view->controller().isMoving());
  QVERIFY(shown.view->camera().forward.z < -0.99);
  QTest::keyClick(shown.view.get(), Qt::Key_Right);
  QVERIFY(shown.view->controller().orbit().pivot.x > 100.0);
  QTest::keyClick(shown.view.get(), Qt::Key_Left, Qt::ShiftModifier);
  QVERIFY(std::abs(shown.view->controller().orbit().azimuth - 1.5707963) > 0.05);
  QTest::keyClick(shown.view.get(), Qt::Key_Space);
  QTRY_VERIFY(!shown.view->controller().isMoving());
  QVERIFY(length(shown.view->camera().eye - home.eye) < 1.0);
  QTest::keyClick(shown.view.get(), Qt::Key_Plus);
  QVERIFY(shown.view->controller().orbit().distance < length(home.eye) * 0.95);
}

void TstImageSceneWidget::middleDrag_orbitsAboutThePivot() {
  Shown shown;
  QVERIFY(shown.loads());
  const CameraOrbit before = shown.view->controller().orbit();
  QTest::mousePress(shown.view.get(), Qt::MiddleButton, {}, QPoint(300, 200));
  QTest::mouseMove(shown.view.get(), QPoint(380, 230));
  QTest::mouseRelease(shown.view.get(), Qt::MiddleButton, {}, QPoint(380, 230));
  const CameraOrbit after = shown.view->controller().orbit();
  QVERIFY(length(after.pivot - before.pivot) < 1e-6);
  QVERIFY(std::abs(after.azimuth - before.azimuth) > 0.3);
  QVERIFY(after.pitch > before.pitch);
}

void TstImageSceneWidget::flight_movesTheSharedCursorAndStops() {
  Shown shown;
  QVERIFY(shown.loads());
  QSignalSpy changed(shown.view.get(), &SceneView::flightChanged);
  shown.state.setPinned(300.0);
  shown.view->startFlight(40.0);
  QVERIFY(shown.view->isFlying() && shown.view->isFollowing());
  QTRY_VERIFY(shown.state.pinned().value_or(0.0) > 900.0);
  shown.view->stopFlight();
  QVERIFY(!shown.view->isFlying());
  QVERIFY(shown.view->isFollowing());
  const double stopped = shown.state.pinned().value();
  QCOMPARE(shown.view->controller().followedDistance().value(), stopped);
  QTRY_VERIFY(!shown.view->controller().isMoving());
  QCOMPARE(shown.state.pinned().value(), stopped);
  QTest::keyClick(shown.view.get(), Qt::Key_Escape);
  QVERIFY(!shown.view->isFollowing());
  QVERIFY(changed.count() >= 3);
}

void TstImageSceneWidget::exaggeration_keepsThePlaceAndIsLimited() {
  Shown shown;
  QVERIFY(shown.settles());
  const Vec3 pivot = shown.view->controller().orbit().pivot;
  SceneOptions options;
  options.verticalExaggeration = 9.0;
  shown.view->setOptions(options);
  QCOMPARE(shown.view->options().verticalExaggeration, 5.0);
  const Vec3 after = shown.view->controller().orbit().pivot;
  QVERIFY(std::hypot(after.x - pivot.x, after.y - pivot.y) < 1e-6);
  QVERIFY(shown.settles());
  const double part = test::tourShown(shown.view->picture(), *shown.situation.plan, *shown.model, shown.view->camera(), 5.0);
  QVERIFY2(part > 0.9 || part < 0.0, qPrintable(QString::number(part)));
}

void TstImageSceneWidget::placeRequested_bringsItToTheMiddle() {
  Shown shown;
  QVERIFY(shown.loads());
  shown.state.showPlace({-3500.0, -3200.0});
  QTRY_VERIFY(!shown.view->controller().isMoving());
  const auto at = shown.view->camera().project({-3500.0, -3200.0, shown.model->surfaceAt({-3500.0, -3200.0})});
  QVERIFY(at && std::hypot(at->x - 320.0, at->y - 200.0) < 2.0);
}

void TstImageSceneWidget::themeChanged_changesThePicture() {
  Shown shown;
  QVERIFY(shown.settles());
  const int light = qGray(shown.view->picture().pixel(320, 200));
  shown.state.setTheme(style::Theme::Dark);
  QTRY_VERIFY_WITH_TIMEOUT(shown.view->isSettled() && qGray(shown.view->picture().pixel(320, 200)) < light - 40, kSettleMs);
}

void TstImageSceneWidget::newTerrain_whileBuilding_isTheOneShown() {
  Shown shown;
  document::Situation other;
  other.terrain = test::sceneTerrain(120, 30.0);
  shown.view->setSituation(other);
  QVERIFY(shown.settles());
  const double side = shown.view->controller().orbit().distance;
  QVERIFY2(side < 12000.0, qPrintable(QString::number(side)));  // the small terrain fills the picture
  QVERIFY(test::tourShown(shown.view->picture(), *shown.situation.plan, *shown.model, shown.view->camera(), 1.0) <= 0.0);
}

void TstImageSceneWidget::emptySituation_saysWhatToDo() {
  document::ViewState state;
  ImageSceneWidget view(state, nullptr);
  view.resize(400, 300);
  view.show();
  const auto labels = view.findChildren<QLabel*>();
  QCOMPARE(labels.size(), 1);
  QVERIFY(labels.front()->isVisible());
  QVERIFY(labels.front()->text().contains(QStringLiteral("terrain")));
  view.startFlight(2.0);
  QVERIFY(!view.isFlying());
  QTest::keyClick(&view, Qt::Key_4);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, QPoint(100, 100));
}

void TstImageSceneWidget::toolBar_drivesTheViewAndShowsItsState() {
  document::ViewState state;
  ImageSceneWidget view(state, nullptr);
  SceneToolBar bar(view, nullptr);
  QVERIFY(!bar.flyAction()->isEnabled());
  view.resize(400, 300);
  view.show();
  view.setSituation(test::sceneSituation());
  QVERIFY(bar.flyAction()->isEnabled());
  QTRY_VERIFY_WITH_TIMEOUT(view.isSettled(), kSettleMs);
  bar.presetActions()[0]->trigger();
  QTRY_VERIFY(!view.controller().isMoving());
  QVERIFY(view.camera().forward.z < -0.99);
  bar.flyAction()->trigger();
  QVERIFY(view.isFlying());
  QCOMPARE(view.controller().flightFactor(), bar.flightSpeed());
  QVERIFY(bar.followAction()->isChecked());
  view.setFollowing(false);
  QVERIFY(!bar.flyAction()->isChecked());
  bar.allGlidesAction()->trigger();
  QVERIFY(view.options().allGlides);
  SceneOptions options = view.options();
  options.verticalExaggeration = 3.0;
  options.curtain = false;
  view.setOptions(options);
  QVERIFY(bar.heightsAction()->text().contains(QStringLiteral("3×")));
  bar.heightsAction()->menu()->actions().front()->trigger();
  QCOMPARE(view.options().verticalExaggeration, 1.0);
  bar.flyAction()->trigger();
  bar.speedAction()->menu()->actions().front()->trigger();
  QCOMPARE(view.controller().flightFactor(), 1.0);
  QVERIFY(!bar.curtainAction()->isChecked());
}

void TstImageSceneWidget::toolBar_underLittleWidth_offersAllInItsMenu() {
  document::ViewState state;
  ImageSceneWidget view(state, nullptr);
  QWidget host;
  auto* column = new QVBoxLayout(&host);
  auto* bar = new SceneToolBar(view, &host);
  column->addWidget(bar);
  host.resize(260, 60);
  host.show();
  QVERIFY(QTest::qWaitForWindowExposed(&host));
  auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
  QVERIFY(more != nullptr);
  QTRY_VERIFY(more->isVisible() && more->menu() != nullptr);
  int reachable = 0;
  for (QAction* action : bar->actions()) {
    QWidget* button = bar->widgetForAction(action);
    const bool isShown = button != nullptr && button->isVisible() && bar->rect().contains(button->geometry());
    QVERIFY2(isShown || action->isSeparator() || more->menu()->actions().contains(action), qPrintable(action->text()));
    reachable += isShown ? 0 : 1;
  }
  QVERIFY2(reachable > 3, "the bar is too narrow for all of them");
}

void TstImageSceneWidget::destruction_whileBusy_isClean() {
  for (int i = 0; i < 5; ++i) {
    Shown shown;
    shown.state.setPinned(100.0 * i);
    if (i > 2) {
      QVERIFY(QTest::qWaitFor([&] { return !shown.view->picture().isNull(); }, kSettleMs));
    }
    QVERIFY(shown.view != nullptr);
  }
}

}  // namespace vp::scene3d

QTEST_MAIN(vp::scene3d::TstImageSceneWidget)
#include "tst_image_scene_widget.moc"
