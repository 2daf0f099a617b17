// The menu of what the map shows on top of terrain, runways and tour.
#include "app/gui/main_window.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QActionGroup>
#include <QInputDialog>
#include <QMenu>

#include <cmath>

namespace vp::gui {
namespace {

constexpr int kCourseStep = 45;  // deg; the overlay is computed for so many headings

}  // namespace

void MainWindow::buildOverlayMenu() {
  auto* menu = new QMenu(tr("&Overlays"), this);
  menu->menuAction()->setObjectName(QStringLiteral("overlayMenu"));
  menu->menuAction()->setToolTip(tr("What the map shows beside terrain, runways and tour"));
  icons_.emplace_back(menu->menuAction(), QStringLiteral("layers"));
  view_->addMenu(menu);
  const auto change = [this](const std::function<void(map::MapOptions&)>& how) {
    map::MapOptions options = map_->options();
    how(options);
    map_->setOptions(options);
    workspace_->setSafeAltitudesWanted(options.safeAltitude || options.reachableFrom.has_value());
  };
  const auto addFlag = [&](const char* name, const QString& text, bool map::MapOptions::*flag) {
    QAction* made = add(menu, name, text, nullptr, {});
    made->setCheckable(true);
    made->setChecked(map_->options().*flag);
    connect(made, &QAction::toggled, this, [change, flag](bool on) { change([&](map::MapOptions& o) { o.*flag = on; }); });
    return made;
  };
  addFlag("overlaySafe", tr("&Lowest safe altitude"), &map::MapOptions::safeAltitude)->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_L));
  QMenu* courses = menu->addMenu(tr("…for the &course"));
  auto* group = new QActionGroup(this);
  const auto addCourse = [&](const QString& text, std::optional<double> course) {
    QAction* made = courses->addAction(text);
    made->setCheckable(true);
    made->setChecked(!course);
    group->addAction(made);
    connect(made, &QAction::triggered, this, [change, course] { change([&](map::MapOptions& o) { o.safeAltitudeCourse = course; }); });
  };
  addCourse(tr("Worst of all courses"), std::nullopt);
  for (int course = kCourseStep; course <= 360; course += kCourseStep) {
    addCourse(style::Units::course(course), course);
  }
  QAction* reach = add(menu, "overlayReach", tr("&Where a runway is in reach from…"), nullptr, {});
  reach->setCheckable(true);
  connect(reach, &QAction::triggered, this, [this, change, reach](bool on) {
    std::optional<double> altitude;
    if (on) {
      const style::Units units = workspace_->view().units();
      const auto& terrain = workspace_->situation().terrain;
      const double start = std::round(units.heightFromSi(terrain ? terrain->highest : 3000.0) / 100.0) * 100.0;
      bool ok = false;
      const double shown = QInputDialog::getDouble(this, tr("Glide range"), tr("Altitude of the aircraft (%1 MSL)").arg(units.heightUnit()), start,
                                                   -1000.0, 60000.0, 0, &ok, {}, 100.0);
      altitude = ok ? std::optional(units.heightToSi(shown)) : std::nullopt;
    }
    reach->setChecked(altitude.has_value());
    change([&](map::MapOptions& o) { o.reachableFrom = altitude; });
  });
  menu->addSeparator();
  addFlag("overlayMargin", tr("Glide &margin along the tour"), &map::MapOptions::tourMargin);
  addFlag("overlayDecisions", tr("&Decision points"), &map::MapOptions::decisionPoints);
  addFlag("overlayGlides", tr("&All landing glides"), &map::MapOptions::allGlides);
  menu->addSeparator();
  addFlag("overlayWeather", tr("W&eather"), &map::MapOptions::weather);
  addFlag("overlayPopulation", tr("&Population"), &map::MapOptions::population);
  addFlag("overlayContours", tr("Terrain con&tours"), &map::MapOptions::contours);
  addFlag("overlayExcluded", tr("E&xcluded runways"), &map::MapOptions::excludedSites);
  addFlag("overlayLegend", tr("Le&gend"), &map::MapOptions::legend);
}

}  // namespace vp::gui
