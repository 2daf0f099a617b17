// Measures what an operator feels of the window: bench_window [LARGE_TERRAIN]. Start, event-loop gaps while planning, loading,
// saving and exporting, time from cancel to idle, memory. Without a display; one JSON object per result and line.
#include "app/gui/export_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTimer>
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <sys/resource.h>
#include <unistd.h>

using namespace vp;
using Activity = jobs::Workspace::Activity;

namespace {

constexpr qint64 kPatience = 300'000;  // ms

/// Longest time between two turns of the event loop while it lives.
class GapMeter {
public:
  GapMeter() {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(1);
    QObject::connect(&timer_, &QTimer::timeout, [this] { worst_ = std::max(worst_, clock_.nsecsElapsed()), clock_.restart(); });
    clock_.start();
    timer_.start();
  }
  [[nodiscard]] double worst_ms() const { return static_cast<double>(worst_) * 1e-6; }

private:
  QTimer timer_;
  QElapsedTimer clock_;
  qint64 worst_ = 0;
};

bool waitFor(const std::function<bool()>& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < kPatience) {
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
  }
  return condition();
}

void print(const char* metric, double value, const char* unit, double reference, const char* note) {
  fmt::print(R"({{"bench": "window", "metric": "{}", "value": {:.4g}, "unit": "{}", "reference": {:.4g}, "note": "{}"}})"
             "\n",
             metric, value, unit, reference, note);
  std::fflush(stdout);
}

/// Milliseconds since the process was started, from the kernel (10 ms steps).
double sinceExec_ms() {
  QFile stat(QStringLiteral("/proc/self/stat"));
  QFile uptime(QStringLiteral("/proc/uptime"));
  if (!stat.open(QIODevice::ReadOnly) || !uptime.open(QIODevice::ReadOnly)) {
    return 0.0;
  }
  const QByteArray text = stat.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  constexpr int kStartTime = 19;  // field 22 of proc(5), counted after the name
  const double started = fields.at(kStartTime).toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
  return (uptime.readAll().split(' ').front().toDouble() - started) * 1000.0;
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void measureStart(gui::MainWindow& window) {
  window.show();
  QCoreApplication::processEvents();
  print("start to shown window", sinceExec_ms(), "ms", 1000.0, "process start to first paint");
  window.welcome();
  waitFor([&] { return window.workspace().situation().plan != nullptr && window.mapView().isComplete(); });
  print("start to bundled plan drawn", sinceExec_ms(), "ms", 1000.0, "terrain, runways and tour on the map");
}

void measurePlanning(gui::MainWindow& window) {
  window.take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/mountain-n50.vpm")});
  waitFor([&] { return window.workspace().activity() == Activity::Idle && window.workspace().roadmap() != nullptr; });
  double worstCancel = 0.0;
  for (const int delay : {100, 400, 900, 1600, 3000}) {  // in different stages
    if (!window.workspace().startPlanning()) {
      return;
    }
    QElapsedTimer running;
    running.start();
    waitFor([&] { return running.elapsed() > delay; });
    QElapsedTimer cancel;
    cancel.start();
    window.workspace().cancelPlanning();
    waitFor([&] { return window.workspace().activity() == Activity::Idle; });
    worstCancel = std::max(worstCancel, static_cast<double>(cancel.nsecsElapsed()) * 1e-6);
  }
  print("cancel to idle", worstCancel, "ms", 100.0, "worst of five, n=50");
  const GapMeter gaps;
  if (window.workspace().startPlanning()) {
    waitFor([&] { return window.workspace().activity() == Activity::Idle; });
  }
  print("worst event-loop gap while planning", gaps.worst_ms(), "ms", 50.0, "n=50");
}

/// The bundled plan saved and opened again, in the background as the operator does it.
void measureFiles(gui::MainWindow& window, const QTemporaryDir& folder) {
  window.workspace().document().startNew();  // nothing unsaved to be asked about
  bool isThere = false;
  window.files().open(QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpm"), [&isThere](bool) { isThere = true; });
  waitFor([&] { return isThere && window.workspace().activity() == Activity::Idle && window.workspace().roadmap() != nullptr; });
  if (!window.workspace().document().plan()) {
    return;
  }
  const QString file = folder.filePath(QStringLiteral("measured.vpm"));
  for (const char* what : {"first save", "second save"}) {
    window.workspace().document().edit(QStringLiteral("Name"), [what](mission::Mission& m) { m.name = what; });
    bool done = false;
    const GapMeter gaps;
    QElapsedTimer saving;
    saving.start();
    window.files().saveTo(file, [&done] { done = true; });
    waitFor([&] { return done; });
    print("worst event-loop gap while saving", gaps.worst_ms(), "ms", 50.0, what);
    print("saved", static_cast<double>(saving.elapsed()), "ms", 0.0, what);
  }
  const qint64 kilobytes = QFileInfo(folder.filePath(QStringLiteral("measured.vpp"))).size() / 1000;
  for (int i = 0; i < 3; ++i) {
    bool done = false;
    const GapMeter gaps;
    QElapsedTimer opening;
    opening.start();
    window.files().open(file, [&done](bool) { done = true; });
    waitFor([&] { return done; });
    print("opened", static_cast<double>(opening.elapsed()), "ms", 0.0, qPrintable(QStringLiteral("plan of %1 kB").arg(kilobytes)));
    waitFor([&] {
      return window.workspace().situation().plan != nullptr && window.workspace().activity() == Activity::Idle && window.mapView().isComplete();
    });
    print("worst event-loop gap while opening", gaps.worst_ms(), "ms", 50.0, "until all of it is drawn");
  }
}

void measureExport(gui::MainWindow& window, const QTemporaryDir& folder) {
  auto* exports = window.findChild<gui::ExportController*>();
  for (const char* id : {"geojson", "map"}) {
    bool done = false;
    const auto connection = QObject::connect(exports, &gui::ExportController::finished, [&done] { done = true; });
    const GapMeter gaps;
    exports->exportTo(id, folder.filePath(QLatin1String(id)));
    waitFor([&] { return done; });
    QObject::disconnect(connection);
    print("worst event-loop gap while exporting", gaps.worst_ms(), "ms", 50.0, id);
  }
}

void measureLargeTerrain(gui::MainWindow& window, const QString& file) {
  window.workspace().document().startNew();
  waitFor([&] { return window.workspace().activity() == Activity::Idle; });
  const GapMeter gaps;
  QElapsedTimer loading;
  loading.start();
  window.take({file});
  waitFor([&] { return window.workspace().situation().terrain != nullptr && window.mapView().isComplete(); });
  print("large terrain loaded and drawn", static_cast<double>(loading.elapsed()) / 1000.0, "s", 0.0, qPrintable(file));
  print("worst event-loop gap while loading", gaps.worst_ms(), "ms", 50.0, "large terrain");
  print("peak memory with large terrain", peakMegabytes(), "MB", 1500.0, "whole program");
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  const QTemporaryDir folder;
  gui::MainWindow window(folder.filePath(QStringLiteral("settings.ini")));
  window.resize(1400, 900);
  measureStart(window);
  measurePlanning(window);
  measureFiles(window, folder);
  measureExport(window, folder);
  if (argc > 1) {
    measureLargeTerrain(window, QString::fromLocal8Bit(argv[1]));
  }
  window.workspace().stopAll();
  return 0;
}
