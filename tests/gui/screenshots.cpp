// Makes the pictures of the README: screenshots FOLDER [MISSION]. With --dialogs: one of each dialog and of the range
// rings, light and dark, for looking at; with --manual: those of the manual; --size=1024x700 sets the size of the window, --language=de its language.
// Opens the real window on the bundled plan, puts it into each state and grabs it. packaging/screenshots calls it under Xvfb.
#include "app/gui/bundled.h"
#include "app/gui/main_window.h"
#include "tests/gui/shooting.h"
#include "ui/dialogs/import_targets_dialog.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/landing_case.h"
#include "ui/map/map_view.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/style/language.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

using namespace vp;

namespace {

constexpr int kPatience = 30'000;  // ms

}  // namespace

bool waitFor(const std::function<bool()>& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < kPatience) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  return condition();
}

void settle(gui::MainWindow& window) {
  waitFor([&] { return window.mapView().isComplete() && window.workspace().activity() == jobs::Workspace::Activity::Idle; });
  QElapsedTimer timer;
  timer.start();
  while (timer.elapsed() < 1500) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
}

void write(const QPixmap& picture, const QDir& folder, const QString& name) {
  const QString file = folder.filePath(name + QStringLiteral(".png"));
  std::printf("%s %s\n", qPrintable(file), picture.save(file) ? "written" : "NOT WRITTEN");
}

void shoot(QWidget& window, const QDir& folder, const QString& name, const QWidget* part) {
  const bool onScreen = QGuiApplication::platformName() == QStringLiteral("xcb");
  const QPixmap picture = onScreen ? window.screen()->grabWindow(window.window()->winId()) : window.grab();
  write(part == nullptr ? picture : picture.copy(QRect(part->mapTo(&window, QPoint(0, 0)), part->size())), folder, name);
}

void inModal(gui::MainWindow& window, const char* action, const std::function<void(QDialog&)>& look) {
  QTimer timer;  // ends with this function: an action that opens nothing leaves no call behind
  timer.setSingleShot(true);
  QObject::connect(&timer, &QTimer::timeout, &window, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) {
      std::fprintf(stderr, "%s: no dialog\n", action);
      return;
    }
    look(*dialog);
    dialog->reject();
  });
  timer.start(400);
  window.action(QLatin1String(action))->trigger();
  if (timer.isActive()) {
    std::fprintf(stderr, "%s: no dialog\n", action);
  }
}

namespace {

/// Opens a dialog that blocks, takes a picture of each of its pages and closes it.
void shootModal(gui::MainWindow& window, const char* action, const QDir& folder, const QString& name,
                const std::function<void(QDialog&)>& prepare = {}) {
  inModal(window, action, [&](QDialog& dialog) {
    if (prepare) {
      prepare(dialog);
    }
    auto* tabs = dialog.findChild<QTabWidget*>();
    for (int page = 0; page < (tabs != nullptr ? tabs->count() : 1); ++page) {
      if (tabs != nullptr) {
        tabs->setCurrentIndex(page);
      }
      QCoreApplication::processEvents();
      write(dialog.grab(), folder, QStringLiteral("%1-%2").arg(name).arg(page + 1));
    }
  });
}

/// The dialogs that a menu opens, each page of each; they are named after their actions.
constexpr std::array kDialogs{"editPreferences",  "editSettings", "editAircraft",         "editAirspaces", "editTarget",
                              "fileFetchTerrain", "fileBriefing", "export-safe-altitude", "exportSeveral", "helpShortcuts"};

}  // namespace

void shootImport(gui::MainWindow& window, const QDir& folder, const QString& name, bool longNames) {
  jobs::TargetsOfFile places;
  places.path = longNames ? QString(60, QLatin1Char('n')) + QStringLiteral(".gpx") : QStringLiteral("huts.gpx");
  places.read = [longNames](const formats::TargetImportOptions& options, const Job&) -> jobs::TargetsOfFile::Found {
    formats::ImportedTargets found;
    for (int i = 0; i < 40; ++i) {
      const std::string title = longNames && i % 7 == 3 ? std::string(60, 'm') : "Point " + std::to_string(i + 1);
      found.targets.push_back(
          {title, {46.6 + 0.01 * i, 9.9 + 0.02 * i}, options.heightAboveGround_m.value_or(150.0), mission::HeightReference::AboveGround});
    }
    return found;
  };
  places.found = places.read({}, Job{});
  dialogs::ImportTargetsDialog dialog(places, window.workspace().view().units(), &window);
  dialog.show();
  QCoreApplication::processEvents();
  write(dialog.grab(), folder, name);
}

namespace {

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

/// Polygons of people over a box: a town in its middle, villages, empty hills; a file of the kind that a census office publishes.
QString writePeople(const QString& path, const geo::LocalFrame& frame, const geo::Box& box) {
  constexpr int kFields = 28;  // to each side
  QByteArray text = R"({"type":"FeatureCollection","features":[)";
  const double wide = (box.maxX - box.minX) / kFields;
  const double high = (box.maxY - box.minY) / kFields;
  for (int i = 0; i < kFields * kFields; ++i) {
    const double x = i % kFields;
    const double y = i / kFields;
    const auto near = [&](double cx, double cy, double width) { return std::exp(-(std::pow(x - cx, 2) + std::pow(y - cy, 2)) / (width * width)); };
    const double density =
        4000.0 * near(13.0, 15.0, 2.2) + 900.0 * near(6.0, 21.0, 2.0) + 600.0 * near(21.0, 7.0, 2.6) + 25.0 * near(14.0, 14.0, 9.0);
    QByteArray ring;
    for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}) {
      const geo::LatLon place = frame.toLatLon({box.minX + (x + dx) * wide, box.minY + (y + dy) * high});
      ring += (ring.isEmpty() ? "[" : ",[") + QByteArray::number(place.longitude_deg, 'g', 12) + ',' +
              QByteArray::number(place.latitude_deg, 'g', 12) + ']';
    }
    text += QByteArray(i > 0 ? "," : "") + R"({"type":"Feature","properties":{"DENSITY":)" + QByteArray::number(density) +
            R"(},"geometry":{"type":"Polygon","coordinates":[[)" + ring + "]]}}";
  }
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(text + "]}") > 0 ? path : QString();
}

}  // namespace

void addWeatherAndPeople(gui::MainWindow& window, const QString& peopleFile) {
  const geo::LocalFrame frame = window.workspace().situation().terrain->frame;
  const geo::Box box = window.workspace().situation().terrain->grid->extent();
  const auto cell = [&](const char* name, double x, double y, double radius, int corners, double success, std::optional<double> top) {
    mission::WeatherCell made;
    made.name = name;
    made.success = success;
    made.top = top;
    for (int i = 0; i < corners; ++i) {
      const double at = 2.0 * Angle::kPi * i / corners;
      const double away = radius * (1.0 + 0.25 * std::sin(3.0 * at));
      made.outline.push_back(frame.toLatLon(
          {box.minX + (x + away * std::cos(at)) * (box.maxX - box.minX), box.minY + (y + away * std::sin(at)) * (box.maxY - box.minY)}));
    }
    return made;
  };
  const QString people = writePeople(peopleFile, frame, box);
  window.workspace().document().edit(QStringLiteral("weather"), [&](mission::Mission& m) {
    m.weather = {cell("Thunderstorm", 0.50, 0.62, 0.11, 15, 0.5, std::nullopt), cell("Showers", 0.25, 0.38, 0.10, 12, 0.9, 3048.0),
                 cell("Mist", 0.74, 0.30, 0.09, 10, 0.98, 1800.0)};
    m.populationFiles = {people.toStdString()};
  });
  waitFor([&] { return window.workspace().situation().population != nullptr; });
}

namespace {

/// A storm in the way, thinner weather beside it, and people below: drawn, kept out of, ranked; light and dark.
void shootWeather(gui::MainWindow& window, const QDir& folder, const QString& peopleFile) {
  document::ViewState& view = window.workspace().view();
  const geo::Box box = window.workspace().situation().terrain->grid->extent();
  addWeatherAndPeople(window, peopleFile);
  const std::optional<double> pinned = view.pinned();
  view.setPinned(std::nullopt);
  view.selectWeather(0);
  emit window.mapView().engineOutRequested({0.35 * box.minX + 0.65 * box.maxX, 0.28 * box.minY + 0.72 * box.maxY}, std::nullopt);
  window.findChild<QDoubleSpinBox*>(QStringLiteral("landingAltitude"))->setValue(9500.0);
  waitFor([&] { return view.landing() != nullptr && !view.landing()->isRunning; });
  window.mapView().showAll();
  auto* tabs = window.findChild<QTabWidget*>(QStringLiteral("landingTabs"));
  settle(window);
  shoot(window, folder, QStringLiteral("weather"));
  tabs->setCurrentIndex(2);
  settle(window);
  shoot(window, folder, QStringLiteral("weather-terms"));
  window.action(QStringLiteral("overlayPopulation"))->setChecked(false);
  tabs->setCurrentIndex(1);
  settle(window);
  shoot(window, folder, QStringLiteral("weather-runways"));
  window.action(QStringLiteral("overlayPopulation"))->setChecked(true);
  view.setTheme(style::Theme::Dark);
  settle(window);
  shoot(window, folder, QStringLiteral("weather-dark"));
  view.setTheme(style::Theme::Light);
  tabs->setCurrentIndex(0);
  window.action(QStringLiteral("missionWeather"))->trigger();
  if (auto* list = window.findChild<QDialog*>(QStringLiteral("weatherListDialog"))) {
    QCoreApplication::processEvents();
    std::printf("weather list %s\n", list->grab().save(folder.filePath(QStringLiteral("weather-list.png"))) ? "written" : "NOT WRITTEN");
    list->close();
  }
  window.findChild<QPushButton*>(QStringLiteral("landingClear"))->click();
  window.findChild<QDockWidget*>(QStringLiteral("engineOutDock"))->raise();
  window.workspace().document().undoStack().undo();
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
    shootImport(window, folder, QStringLiteral("importTargets-") + suffix, true);
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
  const bool wantsManual = arguments.removeAll(QStringLiteral("--manual")) > 0;
  QSize size(1480, 920);
  for (const QString& argument : arguments.filter(QRegularExpression(QStringLiteral("^--size=\\d+x\\d+$")))) {
    const QStringList sides = argument.mid(7).split(QLatin1Char('x'));
    size = QSize(sides[0].toInt(), sides[1].toInt());
    arguments.removeAll(argument);
  }
  QString language = QStringLiteral("en");
  for (const QString& argument : arguments.filter(QRegularExpression(QStringLiteral("^--language=")))) {
    language = argument.section(QLatin1Char('='), 1);
    arguments.removeAll(argument);
  }
  style::useLanguage(language);
  if (arguments.isEmpty()) {
    std::fprintf(stderr, "usage: screenshots [--dialogs | --manual] [--size=WIDTHxHEIGHT] [--language=CODE] FOLDER [MISSION]\n");
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
  if (wantsManual) {
    return shootManual(window, folder, settings.path());
  }
  document::ViewState& view = window.workspace().view();
  view.setPinned(window.workspace().situation().plan->length() * 0.45);
  auto* runways = window.findChild<panels::EngineOutPanel*>()->findChild<QTableView*>();
  waitFor([&] { return runways->model()->rowCount() > 0; });
  settle(window);
  shoot(window, folder, QStringLiteral("engine-out"));
  shootLanding(window, folder);
  shootWeather(window, folder, settings.filePath(QStringLiteral("people.geojson")));

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
