// The menus and the tool bar of the main window.
#include "app/gui/briefing_controller.h"
#include "app/gui/bundled.h"
#include "app/gui/edit_controller.h"
#include "app/gui/export_controller.h"
#include "app/gui/fetch_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/help_controller.h"
#include "app/gui/landing_controller.h"
#include "app/gui/main_window.h"
#include "app/gui/planning_controller.h"
#include "app/gui/preferences_controller.h"
#include "app/gui/weather_controller.h"
#include "ui/about/about_dialog.h"
#include "ui/document/settings.h"
#include "ui/map/map_view.h"
#include "ui/style/icons.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace vp::gui {

QAction* MainWindow::add(QMenu* menu, const char* name, const QString& text, const char* iconName, const QKeySequence& shortcut) {
  auto* made = new QAction(text, this);
  made->setObjectName(QLatin1String(name));
  made->setShortcut(shortcut);
  if (iconName != nullptr) {
    icons_.emplace_back(made, QLatin1String(iconName));
  }
  menu->addAction(made);
  return made;
}

void MainWindow::buildActions() {
  buildFileMenu();
  buildEditMenu();
  buildMissionMenu();
  buildPlanMenu();
  buildViewMenu();
  buildHelpMenu();
  buildToolBar();
  refreshRecent();
}

void MainWindow::buildFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  connect(add(menu, "fileNew", tr("&New mission"), "new", QKeySequence::New), &QAction::triggered, files_, &FileController::startNew);
  connect(add(menu, "fileOpen", tr("&Open…"), "open", QKeySequence::Open), &QAction::triggered, files_, &FileController::openByDialog);
  recent_ = menu->addMenu(tr("Open &recent"));
  connect(add(menu, "fileExample", tr("Open &example"), nullptr, {}), &QAction::triggered, this, [this] {
    const QString example = bundledExample();
    if (!example.isEmpty()) {
      files_->open(example);
    }
  });
  menu->addSeparator();
  connect(add(menu, "fileSave", tr("&Save"), "save", QKeySequence::Save), &QAction::triggered, files_, [this] { files_->save(); });
  connect(add(menu, "fileSaveAs", tr("Save &as…"), nullptr, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)), &QAction::triggered, files_,
          [this] { files_->saveAs(); });
  menu->addSeparator();
  connect(add(menu, "fileTerrain", tr("Add &terrain…"), "terrain", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T)), &QAction::triggered, files_,
          &FileController::addTerrainByDialog);
  connect(add(menu, "fileAirfields", tr("Add air&fields…"), "runway", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A)), &QAction::triggered, files_,
          &FileController::addAirfieldsByDialog);
  connect(add(menu, "fileAirspaces", tr("Add airs&paces…"), nullptr, {}), &QAction::triggered, files_, &FileController::addAirspacesByDialog);
  connect(add(menu, "filePopulation", tr("Add popu&lation…"), nullptr, {}), &QAction::triggered, files_, &FileController::addPopulationByDialog);
  connect(add(menu, "fileWeather", tr("Add &weather…"), nullptr, {}), &QAction::triggered, files_, &FileController::addWeatherByDialog);
  connect(add(menu, "fileFetchTerrain", tr("Fetch terrain for t&his area…"), nullptr, {}), &QAction::triggered, this, &MainWindow::fetchTerrain);
  connect(add(menu, "fileUpdateAirfields", tr("&Update airfields…"), nullptr, {}), &QAction::triggered, fetches_, &FetchController::updateAirfields);
  connect(add(menu, "fileTargets", tr("&Import targets…"), "target", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)), &QAction::triggered, files_,
          &FileController::importTargetsByDialog);
  menu->addSeparator();
  QMenu* exportMenu = menu->addMenu(tr("E&xport"));
  exportMenu->menuAction()->setObjectName(QStringLiteral("fileExport"));
  icons_.emplace_back(exportMenu->menuAction(), QStringLiteral("export"));
  connect(add(exportMenu, "exportSeveral", tr("&Several formats…"), nullptr, {}), &QAction::triggered, exports_,
          [this] { exports_->exportSeveral(); });
  exportMenu->addSeparator();
  for (const ExportController::Format& format : ExportController::formats()) {
    connect(add(exportMenu, format.actionName.c_str(), format.text, nullptr, {}), &QAction::triggered, exports_,
            [this, id = format.id] { exports_->exportByDialog(id); });
  }
  connect(add(exportMenu, "export-safe-altitude", tr("Lowest safe altitude map…"), nullptr, {}), &QAction::triggered, fetches_,
          &FetchController::writeSafeAltitudesByDialog);
  connect(add(menu, "fileBriefing", tr("&Briefing…"), "table", QKeySequence::Print), &QAction::triggered, briefings_,
          &BriefingController::openDialog);
  menu->addSeparator();
  connect(add(menu, "fileQuit", tr("&Quit"), nullptr, QKeySequence::Quit), &QAction::triggered, this, &QWidget::close);
}

/// What the map shows as a box of latitude and longitude; without terrain it shows no place on earth.
void MainWindow::fetchTerrain() {
  std::optional<geo::GeoBox> area;
  if (const auto& terrain = workspace_->situation().terrain) {
    const geo::Box box = map_->camera().visible();
    geo::GeoBox seen{{90.0, 180.0}, {-90.0, -180.0}};
    for (const geo::Point corner : {geo::Point{box.minX, box.minY}, {box.maxX, box.minY}, {box.minX, box.maxY}, {box.maxX, box.maxY}}) {
      const geo::LatLon place = terrain->frame.toLatLon(corner);
      seen.southWest = {std::min(seen.southWest.latitude_deg, place.latitude_deg), std::min(seen.southWest.longitude_deg, place.longitude_deg)};
      seen.northEast = {std::max(seen.northEast.latitude_deg, place.latitude_deg), std::max(seen.northEast.longitude_deg, place.longitude_deg)};
    }
    area = seen;
  }
  fetches_->fetchTerrainByDialog(area);
}

void MainWindow::buildEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QUndoStack& undo = workspace_->document().undoStack();
  QAction* undoAction = undo.createUndoAction(this, tr("&Undo"));
  QAction* redoAction = undo.createRedoAction(this, tr("&Redo"));
  undoAction->setObjectName(QStringLiteral("editUndo"));
  redoAction->setObjectName(QStringLiteral("editRedo"));
  undoAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
  redoAction->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Y), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
  icons_.emplace_back(undoAction, QStringLiteral("undo"));
  icons_.emplace_back(redoAction, QStringLiteral("redo"));
  menu->addAction(undoAction);
  menu->addAction(redoAction);
  menu->addSeparator();
  const auto selected = [this] { return workspace_->view().selectedTarget(); };
  connect(add(menu, "editTarget", tr("Edit &target…"), nullptr, QKeySequence(Qt::CTRL | Qt::Key_E)), &QAction::triggered, this,
          [this, selected] { edits_->editTarget(selected()); });
  connect(add(menu, "editRename", tr("Re&name target…"), nullptr, {}), &QAction::triggered, this,
          [this, selected] { edits_->renameTarget(selected()); });
  connect(add(menu, "editDelete", tr("&Delete target"), "remove", {}), &QAction::triggered, this,
          [this, selected] { edits_->removeTarget(selected()); });
  const auto move = [this, selected](int by) { edits_->reorderTarget(selected(), selected() + by); };
  connect(add(menu, "editUp", tr("Mo&ve target up"), nullptr, QKeySequence(Qt::CTRL | Qt::Key_Up)), &QAction::triggered, this, [move] { move(-1); });
  connect(add(menu, "editDown", tr("Move target d&own"), nullptr, QKeySequence(Qt::CTRL | Qt::Key_Down)), &QAction::triggered, this,
          [move] { move(1); });
  menu->addSeparator();
  connect(add(menu, "editPreferences", tr("&Preferences…"), nullptr, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Comma)), &QAction::triggered,
          preferences_, &PreferencesController::openDialog);
}

void MainWindow::buildMissionMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Mission"));
  connect(add(menu, "missionFiles", tr("&Files…"), nullptr, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F)), &QAction::triggered, this,
          &MainWindow::showFiles);
  menu->addSeparator();
  connect(add(menu, "editAircraft", tr("&Aircraft…"), "aircraft", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C)), &QAction::triggered, edits_,
          &EditController::editAircraft);
  connect(add(menu, "editWind", tr("&Wind…"), "wind", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W)), &QAction::triggered, edits_,
          &EditController::editWind);
  connect(add(menu, "editAirspaces", tr("Airs&pace…"), nullptr, {}), &QAction::triggered, edits_, &EditController::editAirspaces);
  connect(edits_, &EditController::airspaceFilesRequested, files_, &FileController::addAirspacesByDialog);
  menu->addSeparator();
  QAction* draw = add(menu, "toolWeather", tr("&Draw weather"), "weather", QKeySequence(Qt::Key_W));
  draw->setCheckable(true);
  connect(draw, &QAction::triggered, map_, [this](bool on) {
    map_->setTool(on ? map::MapView::Tool::DrawWeather : map::MapView::Tool::Select);
    map_->setFocus();
  });
  connect(map_, &map::MapView::toolChanged, draw, [draw](map::MapView::Tool now) { draw->setChecked(now == map::MapView::Tool::DrawWeather); });
  connect(add(menu, "missionWeather", tr("Weat&her…"), nullptr, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H)), &QAction::triggered, weather_,
          &WeatherController::showList);
  connect(add(menu, "exportWeather", tr("E&xport weather…"), nullptr, {}), &QAction::triggered, weather_, &WeatherController::exportByDialog);
  menu->addSeparator();
  connect(add(menu, "editSettings", tr("Mission &settings…"), "settings", QKeySequence(Qt::ALT | Qt::Key_Return)), &QAction::triggered, edits_,
          &EditController::editMissionSettings);
}

void MainWindow::buildPlanMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Plan"));
  QAction* plan = add(menu, "planStart", tr("&Plan tour"), "plan", QKeySequence(Qt::CTRL | Qt::Key_Return));
  plan->setIconText(tr("Plan tour"));
  connect(plan, &QAction::triggered, planning_, &PlanningController::plan);
  QAction* stop = add(menu, "planStop", tr("&Stop planning"), "stop", QKeySequence(Qt::CTRL | Qt::Key_Period));
  connect(stop, &QAction::triggered, planning_, &PlanningController::cancel);
  menu->addSeparator();
  connect(add(menu, "planWorst", tr("Show &worst point"), "worst", QKeySequence(Qt::CTRL | Qt::Key_W)), &QAction::triggered, this, [this] {
    if (const auto& shown = workspace_->situation().plan) {
      const document::TourState& worst = shown->leastGlideMargin().state;
      workspace_->view().setPinned(worst.distance);
      workspace_->view().showPlace(worst.pose.point());
    }
  });
  connect(add(menu, "planLanding", tr("&Land now from the chosen point"), "engine-out", QKeySequence(Qt::CTRL | Qt::Key_G)), &QAction::triggered,
          landings_, &LandingController::askAtCursor);
}

void MainWindow::buildViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  view_ = menu;
  QAction* scene = add(menu, "viewScene", tr("&3D view"), "scene", QKeySequence(Qt::Key_F4));
  scene->setCheckable(true);
  connect(scene, &QAction::toggled, this, &MainWindow::showScene);
  const std::vector<std::tuple<const char*, Qt::Key, const char*>> docks{
      {"targetsDock", Qt::Key_F2, "target"},       {"runwaysDock", Qt::Key_F3, "runway"},  {"profileDock", Qt::Key_F5, "profile"},
      {"engineOutDock", Qt::Key_F6, "engine-out"}, {"decisionsDock", Qt::Key_F7, "table"}, {"planDock", Qt::Key_F8, "verified"},
      {"landingDock", Qt::Key_F9, "runway"},
  };
  for (const auto& [name, key, iconName] : docks) {
    auto* dock = findChild<QDockWidget*>(QLatin1String(name));
    QAction* toggle = dock->toggleViewAction();
    toggle->setObjectName(QLatin1String(name) + QStringLiteral("Toggle"));
    toggle->setShortcut(QKeySequence(key));
    icons_.emplace_back(toggle, QLatin1String(iconName));
    connect(toggle, &QAction::triggered, dock, [dock](bool on) {
      if (on) {
        dock->raise();
      }
    });
    menu->addAction(toggle);
  }
  menu->addSeparator();
  buildOverlayMenu();
  menu->addSeparator();
  connect(add(menu, "viewHome", tr("Show &all"), "home", QKeySequence(Qt::CTRL | Qt::Key_Home)), &QAction::triggered, map_, &map::MapView::showAll);
  connect(add(menu, "viewBack", tr("Previous view"), "previous", QKeySequence(Qt::ALT | Qt::Key_Left)), &QAction::triggered, map_,
          &map::MapView::goBack);
  connect(add(menu, "viewForward", tr("Next view"), "next", QKeySequence(Qt::ALT | Qt::Key_Right)), &QAction::triggered, map_,
          &map::MapView::goForward);
  buildPlaceActions(menu);
  QAction* full = add(menu, "viewFullScreen", tr("&Full-screen map"), nullptr, QKeySequence(Qt::Key_F11));
  full->setCheckable(true);
  connect(full, &QAction::toggled, this, &MainWindow::setFullScreen);
  menu->addSeparator();
  buildUnitsMenu(menu);
  buildAppearanceMenu(menu);
}

void MainWindow::buildPlaceActions(QMenu* menu) {
  connect(add(menu, "viewPlan", tr("Centre the &plan"), nullptr, QKeySequence(Qt::CTRL | Qt::Key_PageDown)), &QAction::triggered, map_,
          &map::MapView::showPlan);
  connect(add(menu, "viewJump", tr("&Jump to…"), nullptr, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Home)), &QAction::triggered, this,
          &MainWindow::jump);
  connect(add(menu, "viewRings", tr("&Range rings from the middle of the map"), nullptr, QKeySequence(Qt::Key_R)), &QAction::triggered, map_,
          [this] { map_->toggleRings(map_->camera().centre()); });
  connect(add(menu, "viewNoRings", tr("Remove all range rings"), nullptr, QKeySequence(Qt::SHIFT | Qt::Key_R)), &QAction::triggered, map_,
          &map::MapView::clearRings);
}

void MainWindow::setFullScreen(bool on) {
  for (QDockWidget* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (on) {
      dock->setProperty("shownBefore", !dock->isHidden());
      dock->hide();
    } else if (dock->property("shownBefore").toBool()) {
      dock->show();
    }
  }
  setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::buildHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  connect(add(menu, "helpManual", tr("&Manual"), "help", QKeySequence(Qt::Key_F1)), &QAction::triggered, help_, &HelpController::showForFocus);
  connect(add(menu, "helpHint", tr("&First steps"), nullptr, {}), &QAction::triggered, this, &MainWindow::showHint);
  connect(add(menu, "helpShortcuts", tr("&Keyboard and mouse"), nullptr, {}), &QAction::triggered, this, &MainWindow::showShortcuts);
  connect(add(menu, "helpAbout", tr("&About Volplane"), nullptr, {}), &QAction::triggered, this, [this] { about::AboutDialog(this).exec(); });
}

void MainWindow::buildToolBar() {
  tools_ = addToolBar(tr("Tools"));
  tools_->setObjectName(QStringLiteral("toolsBar"));
  tools_->setMovable(false);
  tools_->setIconSize(QSize(22, 22));
  const auto place = [this](const char* name) { tools_->addAction(action(QLatin1String(name))); };
  place("fileOpen");
  place("fileSave");
  place("fileTerrain");
  place("fileAirfields");
  tools_->addSeparator();
  place("editUndo");
  place("editRedo");
  tools_->addSeparator();
  auto* group = new QActionGroup(this);
  const auto addTool = [&](const char* name, const QString& text, const char* iconName, const QKeySequence& key, map::MapView::Tool tool) {
    auto* made = new QAction(text, this);
    made->setObjectName(QLatin1String(name));
    made->setCheckable(true);
    made->setShortcut(key);
    made->setToolTip(QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
    icons_.emplace_back(made, QLatin1String(iconName));
    group->addAction(made);
    tools_->addAction(made);
    connect(made, &QAction::triggered, this, [this, tool] { map_->setTool(tool); });
    connect(map_, &map::MapView::toolChanged, made, [made, tool](map::MapView::Tool now) { made->setChecked(now == tool); });
    return made;
  };
  addTool("toolSelect", tr("Select and move"), "pointer", QKeySequence(Qt::Key_V), map::MapView::Tool::Select)->setChecked(true);
  addTool("toolAdd", tr("Add targets"), "target-add", QKeySequence(Qt::Key_A), map::MapView::Tool::AddTarget);
  addTool("toolMeasure", tr("Measure"), "measure", QKeySequence(Qt::Key_M), map::MapView::Tool::Measure);
  group->addAction(action(QStringLiteral("toolWeather")));
  place("toolWeather");
  tools_->addSeparator();
  place("planStart");
  if (auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(action(QStringLiteral("planStart"))))) {
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  place("planStop");
  place("planWorst");
  tools_->addSeparator();
  place("overlayMenu");
  place("viewHome");
  place("viewScene");
  place("profileDockToggle");
  place("engineOutDockToggle");
  place("planDockToggle");
  tools_->addSeparator();
  place("editAircraft");
  place("editWind");
  place("editSettings");
  place("fileExport");
  for (const char* name : {"overlayMenu", "fileExport"}) {
    if (auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(action(QLatin1String(name))))) {
      button->setPopupMode(QToolButton::InstantPopup);
    }
  }
}

void MainWindow::refreshRecent() {
  recent_->clear();
  for (const QString& path : document::Settings(iniFile_).recentFiles()) {
    QAction* made = recent_->addAction(QFileInfo(path).fileName());
    made->setToolTip(path);
    made->setStatusTip(path);
    connect(made, &QAction::triggered, this, [this, path] { files_->open(path); });
  }
  recent_->setEnabled(!recent_->isEmpty());
}

void MainWindow::refreshActions() {
  const bool planning = workspace_->activity() == jobs::Workspace::Activity::Planning;
  const bool hasPlan = workspace_->situation().plan != nullptr;
  const bool hasSelection = workspace_->view().selectedTarget() >= 0;
  const auto enable = [this](const char* name, bool on) {
    if (QAction* found = action(QLatin1String(name))) {
      found->setEnabled(on);
    }
  };
  enable("planStart", !planning);
  enable("planStop", planning);
  enable("planWorst", hasPlan);
  enable("planLanding", hasPlan);
  enable("fileExport", hasPlan);
  enable("fileBriefing", hasPlan);
  enable("toolWeather", workspace_->situation().terrain != nullptr);
  enable("exportWeather", !workspace_->document().mission().weather.empty());
  enable("editTarget", hasSelection);
  enable("editRename", hasSelection);
  enable("editDelete", hasSelection);
  const auto count = static_cast<int>(workspace_->document().mission().targets.size());
  enable("editUp", workspace_->view().selectedTarget() > 0);
  enable("editDown", hasSelection && workspace_->view().selectedTarget() + 1 < count);
}

}  // namespace vp::gui
