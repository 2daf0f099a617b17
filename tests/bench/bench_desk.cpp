// What the working desk costs the thread of the user interface: single actions, and the longest gap of its event loop while
// loading and planning go on beside it.
//   bench_desk MISSION     one JSON line per figure (tests/bench/README.md)
#include "ui/jobs/workspace.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTimer>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>
#include <string>

using namespace vp;

namespace {

using Clock = std::chrono::steady_clock;

double wallMs() {
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

double cpuMs() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

void report(const std::string& bench, const char* metric, double value, double reference) {
  fmt::print(R"~({{"bench": "desk {}", "metric": "{}", "value": {:.2f}, "unit": "ms", "reference": {}}})~"
             "\n",
             bench, metric, value, reference);
  std::fflush(stdout);
}

template <typename Action>
void time(const char* what, int times, Action action) {
  double longest = 0.0;
  for (int i = 0; i < times; ++i) {
    const double start = cpuMs();
    action(i);
    longest = std::max(longest, cpuMs() - start);
  }
  report(what, "longest", longest, 16.0);
}

/// Runs the event loop until something holds and reports how long it did not turn: the time between two ticks of a timer
/// beyond its interval, and the processor time in between.
template <typename Until>
void watch(const char* what, Until until) {
  constexpr int kInterval = 2;  // ms
  double lastWall = wallMs();
  double lastCpu = cpuMs();
  double gap = 0.0;
  double busy = 0.0;
  QTimer tick;
  tick.setTimerType(Qt::PreciseTimer);
  QObject::connect(&tick, &QTimer::timeout, &tick, [&] {
    gap = std::max(gap, wallMs() - lastWall - kInterval);
    busy = std::max(busy, cpuMs() - lastCpu);
    lastWall = wallMs();
    lastCpu = cpuMs();
  });
  tick.start(kInterval);
  while (!until()) {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  gap = std::max(gap, wallMs() - lastWall - kInterval);
  busy = std::max(busy, cpuMs() - lastCpu);
  report(what, "longest gap of the event loop", gap, 50.0);
  report(what, "longest processor time between two of its rounds", busy, 16.0);
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication app(argc, argv);
  const QString path = QString::fromLocal8Bit(argc > 1 ? argv[1] : "maps/mountain-n50.vpm");
  const QTemporaryDir folder;
  jobs::Workspace desk;
  auto& document = desk.document();
  time("open mission", 1, [&](int) { document.open(path); });
  watch("loading", [&] { return desk.activity() == jobs::Workspace::Activity::Idle; });
  watch("growing glides", [&] { return desk.roadmap() != nullptr; });
  desk.setSafeAltitudesWanted(true);
  watch("safe altitudes", [&] { return desk.situation().safeAltitudes != nullptr; });
  desk.setSafeAltitudesWanted(false);
  const geo::Point place = desk.situation().targets->front().point;
  time("safe altitude under the pointer", 200, [&](int i) { (void)desk.safeAltitudeAt({place.x + 7.0 * i, place.y - 5.0 * i}); });
  bool ended = false;
  QObject::connect(&desk, &jobs::Workspace::planningEnded, &desk, [&] { ended = true; });
  double start = 0.0;
  time("start planning", 1, [&](int) { (void)desk.startPlanning(); });
  watch("planning, to be stopped", [&] { return desk.situation().sketch && desk.situation().sketch->tour; });
  start = wallMs();
  desk.cancelPlanning();
  watch("stopping", [&] { return ended; });
  report("stopping", "from the request to idle", wallMs() - start, 100.0);
  ended = false;
  (void)desk.startPlanning();
  watch("planning", [&] { return ended; });
  watch("viewing the plan", [&] { return desk.situation().plan != nullptr || !document.plan(); });
  time("drag a target", 200, [&](int i) {
    document.edit(
        QStringLiteral("Move"), [i](mission::Mission& m) { m.targets.front().position.latitude_deg += 1e-6 * (i + 1); }, QStringLiteral("drag"));
  });
  time("undo", 1, [&](int) { document.undoStack().undo(); });
  time("save", 1, [&](int) { (void)document.saveAs(folder.filePath(QStringLiteral("saved.vpm"))); });
  time("save again", 1, [&](int) { (void)document.saveAs(document.path()); });
  time("open mission and plan", 1, [&](int) { (void)document.open(document.path()); });
  time("copy for recovery (on a worker)", 1, [&](int) { (void)document::MissionDocument::recoveryData(document.snapshot()); });
  return 0;
}
