// The real OpenGL widget; needs a windowing system (CTest starts a virtual one).
#include "tests/ui/scene3d/picture_check.h"
#include "tests/ui/scene3d/scene_fixture.h"
#include "ui/scene3d/gl_scene_widget.h"
#include "ui/scene3d/scene_view_factory.h"

#include <QMainWindow>
#include <QTest>
#include <QVBoxLayout>

#include <memory>

namespace vp::scene3d {
namespace {

constexpr int kSettleMs = 30000;

double tourIn(GlSceneWidget& view, const document::Situation& situation, const TerrainModel& model) {
  return test::tourShown(view.grabPicture(), *situation.plan, model, view.camera(), view.options().verticalExaggeration);
}

}  // namespace

class TstGlSceneWidget : public QObject {
  Q_OBJECT

private slots:
  void initTestCase();
  void factory_makesTheOpenGlWidget();
  void view_showsTheTourWhereItIs();
  void hovering_setsTheSharedCursor();
  void reparenting_keepsThePicture();
  void creatingAndDestroying_isClean();
};

void TstGlSceneWidget::initTestCase() {
  if (sceneHost() != SceneHost::OpenGlWidget) {
    QSKIP("this platform has no OpenGL widgets");
  }
}

void TstGlSceneWidget::factory_makesTheOpenGlWidget() {
  document::ViewState state;
  const std::unique_ptr<SceneView> view(createSceneView(state, nullptr));
  QVERIFY(qobject_cast<GlSceneWidget*>(view.get()) != nullptr);
}

void TstGlSceneWidget::view_showsTheTourWhereItIs() {
  const document::Situation situation = test::sceneSituation();
  const auto model = TerrainModel::build(situation.terrain);
  document::ViewState state;
  GlSceneWidget view(state, true, nullptr);
  view.resize(640, 400);
  view.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view));
  view.setSituation(situation);
  QTRY_VERIFY_WITH_TIMEOUT(view.isSettled(), kSettleMs);
  QVERIFY(!view.rendererName().isEmpty());
  const double part = tourIn(view, situation, *model);
  QVERIFY2(part > 0.9, qPrintable(QString::number(part)));
  SceneOptions options;
  options.verticalExaggeration = 2.0;
  view.setOptions(options);
  QTRY_VERIFY_WITH_TIMEOUT(view.isSettled(), kSettleMs);
  QVERIFY(tourIn(view, situation, *model) > 0.9);
}

void TstGlSceneWidget::hovering_setsTheSharedCursor() {
  const document::Situation situation = test::sceneSituation();
  document::ViewState state;
  GlSceneWidget view(state, true, nullptr);
  view.resize(640, 400);
  view.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view));
  view.setSituation(situation);
  QTRY_VERIFY_WITH_TIMEOUT(view.isSettled(), kSettleMs);
  const QImage before = view.grabPicture();
  const document::TourState place = situation.plan->at(1500.0);
  const auto at = view.camera().project({place.pose.x, place.pose.y, place.altitude});
  QTest::mouseMove(&view, QPoint(static_cast<int>(at->x), static_cast<int>(at->y)));
  QTRY_VERIFY(state.hovered().has_value());
  QVERIFY(std::abs(*state.hovered() - 1500.0) < 60.0);
  QTRY_VERIFY_WITH_TIMEOUT(view.isSettled() && view.grabPicture() != before, kSettleMs);
}

void TstGlSceneWidget::reparenting_keepsThePicture() {
  const document::Situation situation = test::sceneSituation();
  const auto model = TerrainModel::build(situation.terrain);
  document::ViewState state;
  auto first = std::make_unique<QMainWindow>();
  QMainWindow second;
  auto* view = new GlSceneWidget(state, true, first.get());
  first->setCentralWidget(view);
  first->resize(640, 400);
  first->show();
  QVERIFY(QTest::qWaitForWindowExposed(first.get()));
  view->setSituation(situation);
  QTRY_VERIFY_WITH_TIMEOUT(view->isSettled(), kSettleMs);
  second.resize(700, 420);
  second.setCentralWidget(first->takeCentralWidget());
  second.show();
  first.reset();
  QVERIFY(QTest::qWaitForWindowExposed(&second));
  QTRY_VERIFY_WITH_TIMEOUT(view->isSettled(), kSettleMs);
  const double part = tourIn(*view, situation, *model);
  QVERIFY2(part > 0.9, qPrintable(QString::number(part)));
}

void TstGlSceneWidget::creatingAndDestroying_isClean() {
  const document::Situation situation = test::sceneSituation();
  for (int i = 0; i < 4; ++i) {
    document::ViewState state;
    GlSceneWidget view(state, true, nullptr);
    view.resize(300, 200);
    view.show();
    view.setSituation(situation);
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    if (i % 2 == 1) {
      QTRY_VERIFY_WITH_TIMEOUT(view.isSettled(), kSettleMs);
    }
  }
}

}  // namespace vp::scene3d

QTEST_MAIN(vp::scene3d::TstGlSceneWidget)
#include "tst_gl_scene_widget.moc"
