// A clock that is set forward and back while the program works: autosave, jobs and their times keep a clock of their own.
#include "app/gui/main_window.h"
#include "tests/support/work_folder.h"

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <ctime>
#include <memory>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

std::atomic<long> shift{0};  // s that the time of day is off

}  // namespace

// These take the place of the C library's, for Qt and the standard library as well: the time of day jumps, nothing else does.
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const long result = syscall(SYS_clock_gettime, clock, time);
  if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) {
    time->tv_sec += shift.load();
  }
  return static_cast<int>(result);
}

extern "C" int gettimeofday(timeval* time, void* /*zone*/) noexcept {
  timespec now{};
  const int result = clock_gettime(CLOCK_REALTIME, &now);
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return result;
}

using namespace vp;
using Activity = jobs::Workspace::Activity;

class TestClock : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;
  QTimer jumps_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }

private slots:
  void initTestCase() {
    const QDateTime before = QDateTime::currentDateTime();
    const auto beforeStd = std::chrono::system_clock::now();
    shift = 86'400;
    QVERIFY2(before.daysTo(QDateTime::currentDateTime()) == 1, "the clock that Qt sees is the one that is set here");
    QVERIFY(std::chrono::system_clock::now() - beforeStd > std::chrono::hours(23));
    shift = 0;
    const QString mission = test::makeWorkFolder(folder_.filePath(QStringLiteral("flights")));
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath(QStringLiteral("settings.ini")));
    window_->show();
    window_->take({mission});
    QTRY_VERIFY_WITH_TIMEOUT(desk().activity() == Activity::Idle && desk().situation().sites != nullptr, 60'000);
    connect(&jumps_, &QTimer::timeout, &jumps_, [] { shift = shift > 0 ? -86'400 : 86'400; });  // a day forward, two back, ...
    jumps_.start(150);
  }

  void autosave_isKeptInTime() {
    QElapsedTimer clock;
    clock.start();
    desk().document().edit(QStringLiteral("Name"), [](mission::Mission& m) { m.name = "unsaved"; });
    const QDir recovery(folder_.filePath(QStringLiteral("recovery")));
    QTRY_VERIFY_WITH_TIMEOUT(!recovery.entryList({QStringLiteral("*.recovery")}).isEmpty(), 60'000);
    QVERIFY2(clock.elapsed() >= 1000, "not at every jump either");
  }

  void planning_takesTheTimeThatItTakes_andProgressComes() {
    QSignalSpy progress(&desk(), &jobs::Workspace::progressed);
    jobs::PlanningOutcome outcome;
    connect(&desk(), &jobs::Workspace::planningEnded, this, [&outcome](const jobs::PlanningOutcome& ended) { outcome = ended; });
    QElapsedTimer clock;
    clock.start();
    window_->action(QStringLiteral("planStart"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr && desk().activity() == Activity::Idle, 120'000);
    const double seconds = 1e-3 * static_cast<double>(clock.elapsed());
    QVERIFY2(outcome.seconds > 0.0 && outcome.seconds <= seconds, qPrintable(QString::number(outcome.seconds)));
    QVERIFY(!progress.isEmpty());
    QVERIFY2(progress.count() <= 3 + static_cast<int>(seconds * 20.0), "at most ten times a second of each of two jobs");
  }
};

QTEST_MAIN(TestClock)
#include "tst_clock.moc"
