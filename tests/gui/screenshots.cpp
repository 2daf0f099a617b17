// Makes the pictures of the README: screenshots FOLDER [MISSION]. With --dialogs: one of each dialog and of the range
// rings, light and dark, for looking at; --size=1024x700 sets the size of the window. Opens the real window on the bundled plan, puts it into each
// state and grabs it. packaging/screenshots calls it under Xvfb.
#include "app/gui/bundled.h"
#include "app/gui/main_window.h"
#include "ui/dialogs/import_targets_dialog.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/landing_case.h"
#include "ui/map/map_view.h"
#include "ui/panels/engine_out_panel.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>

#include <array>
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

/// Opens a dialog that blocks, takes a picture of each of its pages and closes it.
void shootModal(gui::MainWindow& window, const char* action, const QDir& folder, const QString& name,
                const std::function<void(QDialog&)>& prepare = {}) {
  QTimer::singleShot(400, &window, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) {
      std::fprintf(stderr, "%s: no dialog\n", action);
      return;
    }
    if (prepare) {
      prepare(*dialog);
    }
    auto* tabs = dialog->findChild<QTabWidget*>();
    for (int page = 0; page < (tabs != nullptr ? tabs->count() : 1); ++page) {
      if (tabs != nullptr) {
        tabs->setCurrentIndex(page);
      }
      QCoreApplication::processEvents();
      const QString file = folder.filePath(QStringLiteral("%1-%2.png").arg(name).arg(page + 1));
      std::printf("%s %s\n", qPrintable(file), dialog->grab().save(file) ? "written" : "NOT WRITTEN");
    }
    dialog->reject();
  });
  window.action(QLatin1String(action))->trigger();
}

/// The dialogs that a menu opens, each page of each; they are named after their actions.
constexpr std::array kDialogs{"editPreferences",  "editSettings", "editAircraft",         "editAirspaces", "editTarget",
                              "fileFetchTerrain", "fileBriefing", "export-safe-altitude", "exportSeveral", "helpShortcuts"};

/// The one that asks how a file becomes targets, which a menu opens only after a file has been chosen.
void shootImport(gui::MainWindow& window, const QDir& folder, const QString& suffix) {
  jobs::TargetsOfFile places;
  places.path = QString(60, QLatin1Char('n')) + QStringLiteral(".gpx");
  places.read = [](const formats::TargetImportOptions& options, const Job&) -> jobs::TargetsOfFile::Found {
    formats::ImportedTargets found;
    for (int i = 0; i < 40; ++i) {
      const std::string name = i % 7 == 3 ? std::string(60, 'm') : "Point " + std::to_string(i + 1);
      found.targets.push_back(
          {name, {46.6 + 0.01 * i, 9.9 + 0.02 * i}, options.heightAboveGround_m.value_or(150.0), mission::HeightReference::AboveGround});
    }
    return found;
  };
  places.found = places.read({}, Job{});
  dialogs::ImportTargetsDialog dialog(places, window.workspace().view().units(), &window);
  dialog.show();
  QCoreApplication::processEvents();
  const QString file = folder.filePath(QStringLiteral("importTargets-%1.png").arg(suffix));
  std::printf("%s %s\n", qPrintable(file), dialog.grab().save(file) ? "written" : "NOT WRITTEN");
}

/// An engine failure beside the tour, well above the ground: what each planner answers.
void shootLanding(gui::MainWindow& window, const QDir& folder) {
  document::ViewState& view = window.workspace().view();
  const geo::Box ground = window.workspace().situation().terrain->grid->extent();
  const std::optional<double> pinned = view.pinned();
  view.setPinned(std::nullopt);
  emit window.mapView().engineOutRequested({0.65 * ground.minX + 0.35 * ground.maxX, 0.35 * ground.minY + 0.65 * ground.maxY}, std::nullopt);
  window.findChild<QDoubleSpinBox*>(QStringLiteral("landingAltitude"))->setValue(11000.0);
  waitFor([&] { return view.landing() != nullptr && !view.landing()->isRunning; });
  window.mapView().showAll();
  settle(window);
  shoot(window, folder, QStringLiteral("landing-now"));
  window.findChild<QPushButton*>(QStringLiteral("landingClear"))->click();
  window.findChild<QDockWidget*>(QStringLiteral("engineOutDock"))->raise();
  view.setPinned(pinned);
}

void shootDialogs(gui::MainWindow& window, const QDir& folder) {
  for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
    const QString suffix = theme == style::Theme::Light ? QStringLiteral("light") : QStringLiteral("dark");
    window.workspace().view().setTheme(theme);
    window.mapView().clearRings();
    window.mapView().toggleRings(window.mapView().camera().centre());
    settle(window);
    shoot(window, folder, QStringLiteral("rings-") + suffix);
    window.findChild<QDockWidget*>(QStringLiteral("runwaysDock"))->raise();
    window.findChild<QDockWidget*>(QStringLiteral("planDock"))->raise();
    emit window.mapView().pointerMoved(window.workspace().situation().targets->front().target.position);
    settle(window);
    shoot(window, folder, QStringLiteral("runways-") + suffix);
    window.findChild<QDockWidget*>(QStringLiteral("targetsDock"))->raise();
    window.findChild<QDockWidget*>(QStringLiteral("engineOutDock"))->raise();
    window.workspace().view().selectTarget(0);
    for (const char* dialog : kDialogs) {
      shootModal(window, dialog, folder, QLatin1String(dialog) + QLatin1Char('-') + suffix);
    }
    shootImport(window, folder, suffix);
    shootModal(window, "viewJump", folder, QStringLiteral("jump-") + suffix, [](QDialog& dialog) {
      dialog.findChild<QLineEdit*>()->setText(QStringLiteral("Atlantis"));
      dialog.accept();
    });
    window.action(QStringLiteral("missionFiles"))->trigger();
    if (auto* files = window.findChild<QDialog*>(QStringLiteral("missionFilesDialog"))) {
      QCoreApplication::processEvents();
      const QString file = folder.filePath(QStringLiteral("files-%1.png").arg(suffix));
      std::printf("%s %s\n", qPrintable(file), files->grab().save(file) ? "written" : "NOT WRITTEN");
      files->close();
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QStringList arguments = QCoreApplication::arguments().mid(1);
  const bool wantsDialogs = arguments.removeAll(QStringLiteral("--dialogs")) > 0;
  QSize size(1480, 920);
  for (const QString& argument : arguments.filter(QRegularExpression(QStringLiteral("^--size=\\d+x\\d+$")))) {
    const QStringList sides = argument.mid(7).split(QLatin1Char('x'));
    size = QSize(sides[0].toInt(), sides[1].toInt());
    arguments.removeAll(argument);
  }
  if (arguments.isEmpty()) {
    std::fprintf(stderr, "usage: screenshots [--dialogs] [--size=WIDTHxHEIGHT] FOLDER [MISSION]\n");
    return 2;
  }
  const QDir folder(arguments.front());
  QDir().mkpath(folder.path());
  const QTemporaryDir settings;
  gui::MainWindow window(settings.filePath(QStringLiteral("volplane.ini")));
  window.workspace().view().setTheme(style::Theme::Light);
  window.resize(size);
  window.show();
  if (arguments.size() > 1) {
    window.take({arguments.at(1)});
  } else {
    window.welcome();
  }
  if (!waitFor([&] { return window.workspace().situation().plan != nullptr; })) {
    std::fprintf(stderr, "no plan to show\n");
    return 1;
  }
  settle(window);
  window.banner().hide();
  if (wantsDialogs) {
    shootDialogs(window, folder);
    return 0;
  }
  document::ViewState& view = window.workspace().view();
  view.setPinned(window.workspace().situation().plan->length() * 0.45);
  auto* runways = window.findChild<panels::EngineOutPanel*>()->findChild<QTableView*>();
  waitFor([&] { return runways->model()->rowCount() > 0; });
  settle(window);
  shoot(window, folder, QStringLiteral("engine-out"));
  shootLanding(window, folder);

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
