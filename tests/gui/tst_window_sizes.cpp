// The window on small and large screens: as narrow as it is told to be, nothing in its status bar cut off or on top of another.
#include "app/gui/main_window.h"
#include "ui/map/map_view.h"

#include <QDockWidget>
#include <QLabel>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <memory>
#include <vector>

using namespace vp;

class TestWindowSizes : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QVERIFY(settings_.isValid());
    window_ = std::make_unique<gui::MainWindow>(settings_.filePath(QStringLiteral("volplane.ini")));
    window_->resize(1480, 920);
    window_->show();
    window_->take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpp")});
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().situation().plan != nullptr, 120'000);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().activity() == jobs::Workspace::Activity::Idle, 120'000);
  }
  void cleanupTestCase() { window_.reset(); }

  void smallScreen_takesTheWholeWindow() {
    for (const char* front : {"targetsDock", "runwaysDock", "planDock", "engineOutDock", "decisionsDock", "profileDock"}) {
      window_->findChild<QDockWidget*>(QLatin1String(front))->raise();
      window_->resize(1024, 700);
      QTRY_COMPARE(window_->size(), QSize(1024, 700));
      QVERIFY2(window_->mapView().width() >= 240, front);
    }
  }

  void statusBar_isWhole_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("units");
    for (const int width : {1024, 1100, 1280, 1480, 1920, 2560}) {
      QTest::addRow("%d px, aviation", width) << width << static_cast<int>(style::UnitSystem::Aviation);
      QTest::addRow("%d px, metric", width) << width << static_cast<int>(style::UnitSystem::Metric);
    }
  }
  void statusBar_isWhole() {
    QFETCH(int, width);
    QFETCH(int, units);
    window_->workspace().view().setUnits(style::Units(static_cast<style::UnitSystem>(units)));
    window_->resize(width, 700);
    QTRY_COMPARE(window_->width(), width);
    const geo::LatLon place = window_->workspace().situation().targets->front().target.position;
    emit window_->mapView().pointerMoved(place);
    QTRY_VERIFY(isWhole());
    const QString shown = text("statusPlace");
    QVERIFY2(shown.startsWith(style::Units::position(place)), qPrintable(shown));
    QVERIFY2(shown.contains(QStringLiteral("Ground ")) && shown.contains(QStringLiteral(" MSL")), qPrintable(shown));
    QVERIFY2(shown.contains(QStringLiteral("Var ")), qPrintable(shown));
    emit window_->mapView().pointerMoved(std::nullopt);
    QVERIFY(text("statusPlace").isEmpty());
  }

  void mapWidth_followsTheZoom() {
    window_->workspace().view().setUnits(style::Units(style::UnitSystem::Metric));
    window_->resize(2560, 900);
    QTRY_COMPARE(window_->width(), 2560);
    window_->mapView().zoomIn();
    const map::MapCamera& camera = window_->mapView().camera();
    const QString expected = window_->workspace().view().units().distance(camera.size().width() * camera.metresPerPixel());
    QCOMPARE(text("statusMapWidth"), QStringLiteral("Map %1 wide").arg(expected));
  }

private:
  [[nodiscard]] QString text(const char* name) const { return window_->findChild<QLabel*>(QLatin1String(name))->text(); }

  /// Every text has its room, and none lies on another.
  [[nodiscard]] bool isWhole() const {
    std::vector<QRect> taken;
    for (const QWidget* piece :
         window_->statusBar()->findChildren<QWidget*>(QRegularExpression(QStringLiteral("^status")), Qt::FindDirectChildrenOnly)) {
      if (!piece->isVisible() || piece->objectName() == QStringLiteral("statusMessage")) {
        continue;
      }
      const QRect box = piece->geometry();
      if (box.width() < piece->sizeHint().width() || !window_->statusBar()->rect().contains(box)) {
        return false;
      }
      for (const QRect& other : taken) {
        if (other.intersects(box)) {
          return false;
        }
      }
      taken.push_back(box);
    }
    return taken.size() >= 2;
  }

  QTemporaryDir settings_;
  std::unique_ptr<gui::MainWindow> window_;
};

QTEST_MAIN(TestWindowSizes)
#include "tst_window_sizes.moc"
