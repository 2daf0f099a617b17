// Makes the pictures of the README: screenshots FOLDER. Opens the real window on the bundled plan, puts it into each state and
// grabs it. packaging/screenshots calls it under Xvfb.
#include "app/gui/bundled.h"
#include "app/gui/main_window.h"
#include "ui/dialogs/message_banner.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QScreen>
#include <QTemporaryDir>

#include <cstdio>
#include <functional>

using namespace vp;

namespace {

constexpr int kPatience = 30'000;  // ms

bool waitFor(const std::function<bool()>& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < kPatience) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  return condition();
}

/// Lets timers and tiles finish: until the map is complete and nothing has happened for a while.
void settle(gui::MainWindow& window) {
  waitFor([&] { return window.mapView().isComplete() && window.workspace().activity() == jobs::Workspace::Activity::Idle; });
  QElapsedTimer timer;
  timer.start();
  while (timer.elapsed() < 1500) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
}

void shoot(QWidget& widget, const QDir& folder, const QString& name) {
  const QString file = folder.filePath(name + QStringLiteral(".png"));
  const bool onScreen = QGuiApplication::platformName() == QStringLiteral("xcb");
  const QPixmap picture = onScreen ? widget.screen()->grabWindow(widget.window()->winId()) : widget.grab();
  std::printf("%s %s\n", qPrintable(file), picture.save(file) ? "written" : "NOT WRITTEN");
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc < 2) {
    std::fprintf(stderr, "usage: screenshots FOLDER [MISSION]\n");
    return 2;
  }
  const QDir folder(QString::fromLocal8Bit(argv[1]));
  QDir().mkpath(folder.path());
  const QTemporaryDir settings;
  gui::MainWindow window(settings.filePath(QStringLiteral("volplane.ini")));
  window.workspace().view().setTheme(style::Theme::Light);
  window.resize(1480, 920);
  window.show();
  if (argc > 2) {
    window.take({QString::fromLocal8Bit(argv[2])});
  } else {
    window.welcome();
  }
  if (!waitFor([&] { return window.workspace().situation().plan != nullptr; })) {
    std::fprintf(stderr, "no plan to show\n");
    return 1;
  }
  settle(window);
  window.banner().hide();
  document::ViewState& view = window.workspace().view();
  view.setPinned(window.workspace().situation().plan->length() * 0.45);
  settle(window);
  shoot(window, folder, QStringLiteral("engine-out"));

  window.action(QStringLiteral("overlaySafe"))->setChecked(true);
  window.action(QStringLiteral("overlayMargin"))->setChecked(true);
  waitFor([&] { return window.workspace().situation().safeAltitudes && window.workspace().situation().safeAltitudes->columns > 100; });
  settle(window);
  shoot(window, folder, QStringLiteral("safe-altitude"));
  window.action(QStringLiteral("overlaySafe"))->setChecked(false);
  window.action(QStringLiteral("overlayMargin"))->setChecked(false);

  window.showScene(true);
  window.action(QStringLiteral("planDockToggle"))->trigger();
  window.action(QStringLiteral("planDockToggle"))->trigger();
  settle(window);
  shoot(window, folder, QStringLiteral("map-and-3d"));

  view.setTheme(style::Theme::Dark);
  window.findChild<QDockWidget*>(QStringLiteral("decisionsDock"))->raise();
  window.findChild<QDockWidget*>(QStringLiteral("planDock"))->raise();
  settle(window);
  shoot(window, folder, QStringLiteral("dark"));
  return 0;
}
