// long_use [ROUNDS]: edits, plans, stops, plans again, looks at glides and undoes, in one process, and measures every 50 rounds
// what the process holds. Exit 0 if memory stays within 5 % of what it was after a fifth of the rounds, and handles and threads
// do not grow.
#include "app/gui/main_window.h"
#include "tests/support/loop_watch.h"
#include "tests/support/work_folder.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <cstdio>
#include <functional>
#include <malloc.h>

using namespace vp;
using Activity = jobs::Workspace::Activity;

namespace {

constexpr int kStep = 50;  // rounds between measurements
constexpr double kMostGrowth = 0.05;

/// What the process holds.
struct Held {
  double resident = 0.0;  ///< MiB, after what is free was given back
  double inUse = 0.0;     ///< MiB that the allocator has handed out: growth here is a leak, growth of the other alone fragmentation
  qsizetype handles = 0;
  qsizetype threads = 0;
  qsizetype objects = 0;  ///< of the window, all the way down
};

double residentNow() {
  QFile status(QStringLiteral("/proc/self/status"));
  if (status.open(QIODevice::ReadOnly)) {
    for (const QByteArray& line : status.readAll().split('\n')) {
      if (line.startsWith("VmRSS:")) {
        return line.simplified().split(' ').value(1).toDouble() / 1024.0;
      }
    }
  }
  return 0.0;
}

Held measure(const QObject& window) {
  ::malloc_trim(0);
  const struct mallinfo2 info = ::mallinfo2();
  const auto entries = [](const char* folder) {
    return QDir(QLatin1String(folder)).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size();
  };
  return {residentNow(), static_cast<double>(info.uordblks + info.hblkhd) / 1048576.0, entries("/proc/self/fd"), entries("/proc/self/task"),
          window.findChildren<QObject*>().size()};
}

void waitFor(const std::function<bool()>& reached) {
  while (!reached()) {
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
}

class LongUse {
public:
  bool begin() {
    const QString mission = test::makeWorkFolder(folder_.filePath(QStringLiteral("flights")));
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath(QStringLiteral("settings.ini")));
    window_->show();
    window_->take({mission});
    waitFor([this] { return desk().situation().sites != nullptr && isIdle(); });
    return desk().situation().terrain != nullptr;
  }

  /// @return whether there was a plan in the end
  bool round(int number) {
    document::MissionDocument& document = desk().document();
    document.edit(QStringLiteral("Move"), [number](mission::Mission& m) {
      m.targets[static_cast<std::size_t>(number) % m.targets.size()].position.latitude_deg += 1e-5 * (1 + number % 7);
    });
    trigger("planStart");
    for (int turn = 0; turn < number % 5; ++turn) {  // stopped early, late and in between
      QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    if (isPlanning()) {
      trigger("planStop");
    }
    waitFor([this] { return !isPlanning(); });
    trigger("planStart");
    waitFor([this] { return !isPlanning(); });
    waitFor([this] { return desk().situation().plan != nullptr && desk().situation().planIsCurrent; });
    const double length = desk().situation().plan->length();
    for (int i = 0; i < 8; ++i) {
      desk().view().setHovered(length * i / 8.0);
      QApplication::processEvents();
    }
    desk().view().setHovered(std::nullopt);
    const bool isPlanned = desk().document().plan() != nullptr && desk().document().plan()->certificate.has_value();
    document.undoStack().undo();
    return isPlanned;
  }

  Held settle() {
    waitFor([this] { return isIdle() && window_->mapView().isComplete(); });
    for (int i = 0; i < 20; ++i) {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return measure(*window_);
  }

private:
  [[nodiscard]] jobs::Workspace& desk() { return window_->workspace(); }
  [[nodiscard]] bool isIdle() { return desk().activity() == Activity::Idle; }
  [[nodiscard]] bool isPlanning() { return desk().activity() == Activity::Planning; }
  void trigger(const char* action) { window_->action(QLatin1String(action))->trigger(); }

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;
};

void print(int round, const Held& held, double seconds, const test::LoopWatch& watch) {
  std::printf("%6d  %9.1f  %9.2f  %7d  %7d  %7d  %8.1f  %9.0f  %9.0f\n", round, held.resident, held.inUse, static_cast<int>(held.handles),
              static_cast<int>(held.threads), static_cast<int>(held.objects), seconds, watch.longestWork(), watch.longestGap());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const int rounds = argc > 1 ? QByteArray(argv[1]).toInt() : 1000;
  if (rounds < 1) {
    std::fputs("long_use [ROUNDS]\n", stderr);
    return 2;
  }
  QTimer heartbeat;  // so that waiting looks again
  heartbeat.start(20);
  LongUse use;
  if (!use.begin()) {
    std::puts("FAILED: the mission could not be loaded");
    return 1;
  }
  std::puts(
      " round   resident     in use  handles  threads  objects   seconds  work (ms)   gap (ms)\n            (MiB)      (MiB)                         "
      "             longest turn of the loop");
  test::LoopWatch watch;
  QElapsedTimer clock;
  clock.start();
  const int warm = std::max(1, rounds / 5 / kStep) * kStep;
  Held first;
  Held last;
  int planned = 0;
  for (int round = 1; round <= rounds; ++round) {
    planned += use.round(round) ? 1 : 0;
    if (round % kStep == 0 || round == rounds) {
      last = use.settle();
      print(round, last, 1e-3 * static_cast<double>(clock.elapsed()), watch);
      watch.reset();
      first = round <= warm ? last : first;
    }
  }
  const auto grown = [](double before, double after) { return before > 0.0 ? after / before - 1.0 : 0.0; };
  const double resident = grown(first.resident, last.resident);
  const double inUse = grown(first.inUse, last.inUse);
  const bool isFlat = resident <= kMostGrowth && inUse <= kMostGrowth && last.handles <= first.handles && last.threads <= first.threads;
  std::printf("%d of %d rounds ended with a verified plan; since round %d resident %+.1f %%, in use %+.1f %%, handles %+d, threads %+d: %s\n",
              planned, rounds, std::min(warm, rounds), 100.0 * resident, 100.0 * inUse, static_cast<int>(last.handles - first.handles),
              static_cast<int>(last.threads - first.threads), isFlat && planned == rounds ? "flat" : "FAILED");
  return isFlat && planned == rounds ? 0 : 1;
}
