// The window goes on turning: whatever runs, no turn of the GUI thread's loop takes longer than a stated bound. Processor time is
// counted, so that a busy machine does not fail the test; packaging/long-use measures by the clock.
#include "app/gui/briefing_controller.h"
#include "app/gui/export_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "tests/support/loop_watch.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp;
using Activity = jobs::Workspace::Activity;

namespace {

constexpr int kLong = 240'000;  // ms; patience, not a measurement
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kBound = 1000.0;  // ms of processor time
#else
constexpr double kBound = 100.0;  // ms of processor time: what still feels immediate
#endif

QString bundled(const char* name) {
  return QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/") + QLatin1String(name);
}

}  // namespace

class TestEventLoop : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;
  std::unique_ptr<test::LoopWatch> watch_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  void settle() const { QTRY_VERIFY_WITH_TIMEOUT(desk().activity() == Activity::Idle && window_->mapView().isComplete(), kLong); }

private slots:
  void initTestCase() {
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath(QStringLiteral("settings.ini")));
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    watch_ = std::make_unique<test::LoopWatch>();
  }
  void init() {
    QTest::qWait(50);
    watch_->reset();
  }
  void cleanup() {
    watch_->tick();
    qInfo("longest turn: %.0f ms of processor time, %.0f ms by the clock, %d turns", watch_->longestWork(), watch_->longestGap(), watch_->turns());
    QVERIFY2(watch_->longestWork() < kBound, qPrintable(QString::number(watch_->longestWork())));
    QVERIFY2(watch_->turns() > 5, "it turned at all");
  }

  void openingAMissionWithItsPlan() {
    window_->take({bundled("alpine-n10.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr, kLong);
    settle();
  }

  void movingAlongTheTour() {
    const double length = desk().situation().plan->length();
    for (int i = 0; i < 100; ++i) {
      desk().view().setHovered(length * i / 100.0);
      QTest::qWait(5);
    }
    desk().view().setHovered(std::nullopt);
    settle();
  }

  void editingAndUndoing() {
    for (int i = 0; i < 10; ++i) {
      desk().document().edit(QStringLiteral("Move"), [](mission::Mission& m) { m.targets[0].position.latitude_deg += 1e-4; });
      QTest::qWait(10);
    }
    while (desk().document().undoStack().canUndo()) {
      desk().document().undoStack().undo();
      QTest::qWait(10);
    }
    settle();
  }

  void exportingPicturingBriefingAndSaving() {
    auto* exports = window_->findChild<gui::ExportController*>();
    QSignalSpy exported(exports, &gui::ExportController::finished);
    exports->exportTo("gpx", folder_.filePath(QStringLiteral("tour.gpx")));
    QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kLong);
    exports->exportTo("profile", folder_.filePath(QStringLiteral("tour.png")));
    QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 2, kLong);
    QSignalSpy briefed(&window_->briefings(), &gui::BriefingController::finished);
    window_->briefings().write({}, folder_.filePath(QStringLiteral("tour.pdf")), false);
    QTRY_COMPARE_WITH_TIMEOUT(briefed.count(), 1, kLong);
    QVERIFY(briefed.front().front().toBool());
    window_->files().saveTo(folder_.filePath(QStringLiteral("tour.vpm")));
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder_.filePath(QStringLiteral("tour.vpp"))) && !window_->files().isBusy(), kLong);
  }

  void planningAndStopping() {
    window_->action(QStringLiteral("planStart"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().sketch != nullptr || desk().activity() == Activity::Idle, kLong);
    window_->action(QStringLiteral("planStop"))->trigger();
    settle();
  }

  void planningToTheEnd() {
    window_->take({bundled("mountain-n5.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().document().mission().targets.size() == 5U && desk().activity() == Activity::Idle, kLong);
    desk().document().edit(QStringLiteral("Coarse"), [](mission::Mission& m) {
      m.planner.headings = 4;
      m.planner.step = Length::fromSi(100.0);
      m.planner.roadmapSamples = 800;
    });
    window_->action(QStringLiteral("planStart"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr && desk().activity() == Activity::Idle, kLong);
    settle();
  }
};

QTEST_MAIN(TestEventLoop)
#include "tst_event_loop.moc"
