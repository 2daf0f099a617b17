// A machine without OpenGL, made by hiding all drivers: nothing may crash, and the reason is said.
#include "tests/ui/scene3d/scene_fixture.h"
#include "ui/scene3d/image_scene_widget.h"
#include "ui/scene3d/scene_picture.h"
#include "ui/scene3d/scene_view_factory.h"

#include <QLabel>
#include <QTest>

#include <memory>

namespace vp::scene3d {

class TstNoOpenGl : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qputenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent"); }
  void picture_isRefusedWithTheReason();
  void view_saysWhy();
};

void TstNoOpenGl::picture_isRefusedWithTheReason() {
  const auto image = renderScene(test::sceneSituation(), {}, {}, QSize(320, 200), style::Theme::Light, {});
  QVERIFY(!image.has_value());
  QCOMPARE(image.error().code, Errc::Unsupported);
  QVERIFY(!image.error().what.empty());
}

void TstNoOpenGl::view_saysWhy() {
  document::ViewState state;
  const std::unique_ptr<SceneView> view(createSceneView(state, nullptr));
  view->resize(500, 300);
  view->show();
  view->setSituation(test::sceneSituation());
  QTRY_VERIFY(!view->problem().isEmpty());
  const auto labels = view->findChildren<QLabel*>();
  QCOMPARE(labels.size(), 1);
  QTRY_VERIFY(labels.front()->isVisible());
  QVERIFY(labels.front()->text().contains(QStringLiteral("3D")));
  // it still takes part in the rest
  state.setPinned(100.0);
  view->showPreset(Preset::Top);
  view->startFlight(5.0);
  QTRY_VERIFY(state.pinned().value_or(0.0) > 100.0);
  view->stopFlight();
}

}  // namespace vp::scene3d

QTEST_MAIN(vp::scene3d::TstNoOpenGl)
#include "tst_no_opengl.moc"
