#include "app/gui/main_window.h"

#include "app/gui/alternatives_feed.h"
#include "app/gui/autosave_keeper.h"
#include "app/gui/briefing_controller.h"
#include "app/gui/edit_controller.h"
#include "app/gui/export_controller.h"
#include "app/gui/fetch_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/help_controller.h"
#include "app/gui/landing_controller.h"
#include "app/gui/planning_controller.h"
#include "app/gui/preferences_controller.h"
#include "app/gui/status_line.h"
#include "app/gui/taskbar_progress.h"
#include "app/gui/weather_controller.h"
#include "core/emergency/planners.h"
#include "ui/dialogs/message_banner.h"
#include "ui/dialogs/mission_files_dialog.h"
#include "ui/document/settings.h"
#include "ui/map/map_view.h"
#include "ui/panels/decision_table.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/panels/landing_panel.h"
#include "ui/panels/plan_summary_panel.h"
#include "ui/panels/site_panel.h"
#include "ui/panels/target_panel.h"
#include "ui/profile/profile_view.h"
#include "ui/scene3d/scene_tool_bar.h"
#include "ui/scene3d/scene_view.h"
#include "ui/scene3d/scene_view_factory.h"
#include "ui/style/icons.h"
#include "ui/style/theme.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

namespace vp::gui {
namespace {

constexpr int kTargetsWidth = 340;
constexpr int kSideWidth = 364;  // the figures of the next-best runways are not cut off
constexpr int kProfileHeight = 190;

QDockWidget* makeDock(QMainWindow* window, const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  dock->setTitleBarWidget(new QWidget(dock));  // the tab above says the name
  content->setAccessibleName(title);
  window->addDockWidget(area, dock);
  return dock;
}

}  // namespace

MainWindow::MainWindow(const QString& iniFile, QWidget* parent)
    : QMainWindow(parent), workspace_(std::make_unique<jobs::Workspace>()), iniFile_(iniFile) {
  setAcceptDrops(true);
  setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
  preferences_ = new PreferencesController(*workspace_, iniFile_, this);
  style::applyTheme(workspace_->view().theme());
  buildCentre();
  buildDocks();
  status_ = new StatusLine(*workspace_, *statusBar());
  edits_ = new EditController(*workspace_, this);
  files_ = new FileController(*workspace_, *banner_, this);
  planning_ = new PlanningController(*workspace_, *edits_, *banner_, this);
  exports_ = new ExportController(*workspace_, *banner_, this);
  fetches_ = new FetchController(*workspace_, *banner_, iniFile, this);
  briefings_ = new BriefingController(*workspace_, *banner_, this);
  weather_ = new WeatherController(*workspace_, *banner_, this);
  help_ = new HelpController(workspace_->view(), this);
  landings_ = new LandingController(*workspace_, *landing_, this);
  alternatives_ = new AlternativesFeed(*workspace_, *engineOut_, this);
  autosave_ = new AutosaveKeeper(*workspace_, *banner_,
                                 iniFile_.isEmpty() ? QString() : QFileInfo(iniFile_).absolutePath() + QStringLiteral("/recovery"), this);
  taskbar_ = new TaskbarProgress(this);
  buildActions();
  connectViews();
  connectMap();
  connectPanels();
  applyTheme();
  showSituation();
  refreshTitle();
  restoreLayout();
}

MainWindow::~MainWindow() {
  workspace_->stopAll();
  // views point into the workspace, so they go first
  delete takeCentralWidget();
  qDeleteAll(findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

void MainWindow::buildCentre() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  banner_ = new dialogs::MessageBanner;
  column->addWidget(banner_);
  centre_ = new QSplitter(Qt::Horizontal);
  centre_->setChildrenCollapsible(false);
  map_ = new map::MapView(workspace_->view());
  centre_->addWidget(map_);
  column->addWidget(centre_, 1);
  setCentralWidget(page);
}

void MainWindow::buildDocks() {
  document::ViewState& view = workspace_->view();
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  targets_ = new panels::TargetPanel(view);
  sites_ = new panels::SitePanel(view);
  engineOut_ = new panels::EngineOutPanel(view);
  landing_ = new panels::LandingPanel(view, emergency::plannerNames());
  summary_ = new panels::PlanSummaryPanel(view);
  decisions_ = new panels::DecisionTable(view);
  profile_ = new profile::ProfileView(view);
  QDockWidget* targets = makeDock(this, "targetsDock", tr("Targets"), targets_, Qt::LeftDockWidgetArea);
  QDockWidget* sites = makeDock(this, "runwaysDock", tr("Runways"), sites_, Qt::LeftDockWidgetArea);
  tabifyDockWidget(targets, sites);
  targets->raise();
  QDockWidget* engine = makeDock(this, "engineOutDock", tr("Engine out"), engineOut_, Qt::RightDockWidgetArea);
  QDockWidget* plan = makeDock(this, "planDock", tr("Plan"), summary_, Qt::RightDockWidgetArea);
  QDockWidget* landing = makeDock(this, "landingDock", tr("Landing now"), landing_, Qt::RightDockWidgetArea);
  tabifyDockWidget(engine, landing);
  tabifyDockWidget(landing, plan);
  engine->raise();
  QDockWidget* profile = makeDock(this, "profileDock", tr("Profile"), profile_, Qt::BottomDockWidgetArea);
  QDockWidget* decisions = makeDock(this, "decisionsDock", tr("Decision points"), decisions_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(profile, decisions);
  profile->raise();
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  engineOut_->setMinimumWidth(kSideWidth);
  landing_->setMinimumWidth(kSideWidth);
  summary_->setMinimumWidth(kSideWidth);
  profile_->setMinimumHeight(kProfileHeight);
}

void MainWindow::showScene(bool visible) {
  if (visible && scene_ == nullptr) {
    scene_ = scene3d::createSceneView(workspace_->view(), centre_);
    sceneHost_ = new QWidget;
    auto* column = new QVBoxLayout(sceneHost_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new scene3d::SceneToolBar(*scene_, sceneHost_));
    column->addWidget(scene_, 1);
    centre_->addWidget(sceneHost_);
    centre_->setSizes({centre_->width() / 2, centre_->width() / 2});
    scene_->setOptions(preferences_->now().scene);
    connect(scene_, &scene3d::SceneView::optionsChanged, preferences_, [this] { preferences_->setScene(scene_->options()); });
    scene_->setSituation(workspace_->situation());
  }
  if (sceneHost_ != nullptr) {
    sceneHost_->setVisible(visible);
  }
  if (QAction* toggle = action(QStringLiteral("viewScene")); toggle != nullptr && toggle->isChecked() != visible) {
    toggle->setChecked(visible);
  }
}

QAction* MainWindow::action(const QString& name) const {
  return findChild<QAction*>(name);
}

void MainWindow::connectViews() {
  connect(workspace_.get(), &jobs::Workspace::situationChanged, this, &MainWindow::showSituation);
  connect(workspace_.get(), &jobs::Workspace::activityChanged, this, &MainWindow::refreshActions);
  connect(workspace_.get(), &jobs::Workspace::notesChanged, this, [this] { sites_->setNotes(workspace_->notes()); });
  connect(workspace_.get(), &jobs::Workspace::progressed, this, [this](double fraction) {
    if (workspace_->activity() == jobs::Workspace::Activity::Planning) {
      taskbar_->show(fraction);
      setWindowTitle(tr("%1 % – %2").arg(qRound(fraction * 100.0)).arg(workspace_->document().title()));
    }
  });
  connect(workspace_.get(), &jobs::Workspace::planningEnded, this, [this] {
    taskbar_->hide();
    refreshTitle();
  });
  connect(&workspace_->document(), &document::MissionDocument::stateChanged, this, &MainWindow::refreshTitle);
  connect(&workspace_->document(), &document::MissionDocument::missionChanged, this, [this] {
    sites_->setFilter(workspace_->document().mission().siteFilter);
    if (filesDialog_) {
      filesDialog_->setMission(workspace_->document().mission());
    }
  });
  connect(preferences_, &PreferencesController::changed, this, [this] {
    if (scene_ != nullptr) {
      scene_->setOptions(preferences_->now().scene);
    }
  });
  connect(preferences_, &PreferencesController::notRemembered, this,
          [this](const QString& problem) { banner_->show(dialogs::MessageBanner::Kind::Warning, problem); });
  connect(preferences_, &PreferencesController::missionSettingsRequested, edits_, &EditController::editMissionSettings);
  connect(&workspace_->document().undoStack(), &QUndoStack::indexChanged, this, &MainWindow::refreshActions);
  connect(&workspace_->view(), &document::ViewState::themeChanged, this, &MainWindow::applyTheme);
  connect(&workspace_->view(), &document::ViewState::selectionChanged, this, &MainWindow::refreshActions);
  connect(status_, &StatusLine::cancelRequested, planning_, &PlanningController::cancel);
  const auto remember = [this](const QString& path) {
    document::Settings(iniFile_).addRecentFile(path);
    refreshRecent();
  };
  connect(files_, &FileController::opened, this, [this, remember](const QString& path) {
    remember(path);
    map_->showAll();
  });
  connect(files_, &FileController::saved, this, remember);
  connect(files_, &FileController::working, status_, &StatusLine::showWork);
  connect(fetches_, &FetchController::working, status_, &StatusLine::showWork);
}

void MainWindow::connectMap() {
  connect(map_, &map::MapView::targetAddRequested, edits_, &EditController::addTarget);
  connect(map_, &map::MapView::targetMoveRequested, edits_, &EditController::moveTarget);
  connect(map_, &map::MapView::targetRemoveRequested, edits_, &EditController::removeTarget);
  connect(map_, &map::MapView::targetRenameRequested, edits_, &EditController::renameTarget);
  connect(map_, &map::MapView::targetEditRequested, edits_, &EditController::editTarget);
  connect(map_, &map::MapView::siteExcludeRequested, edits_, &EditController::excludeSite);
  connect(map_, &map::MapView::homeRequested, edits_, &EditController::setHome);
  connect(map_, &map::MapView::airspaceUseRequested, edits_, &EditController::setAirspaceUse);
  connect(map_, &map::MapView::airspaceRulesRequested, edits_, &EditController::editAirspaces);
  connect(map_, &map::MapView::weatherDrawn, weather_, &WeatherController::add);
  connect(map_, &map::MapView::weatherCornerMoved, weather_, &WeatherController::moveCorner);
  connect(map_, &map::MapView::weatherEditRequested, weather_, &WeatherController::edit);
  connect(map_, &map::MapView::weatherRemoveRequested, weather_, &WeatherController::remove);
  connect(map_, &map::MapView::problemFound, weather_, &WeatherController::tell);
  connect(weather_, &WeatherController::drawRequested, this, [this] {
    map_->setTool(map::MapView::Tool::DrawWeather);
    activateWindow();
    map_->setFocus();
  });
  connect(weather_, &WeatherController::addRequested, files_, &FileController::addWeatherByDialog);
  connect(map_, &map::MapView::engineOutRequested, landings_, &LandingController::askAt);
  connect(map_, &map::MapView::siteClicked, sites_, &panels::SitePanel::showSite);
  connect(map_, &map::MapView::pointerMoved, status_, &StatusLine::showPlace);
  const auto showWidth = [this] { status_->showMapWidth(map_->camera().size().width() * map_->camera().metresPerPixel()); };
  connect(map_, &map::MapView::cameraChanged, status_, showWidth);
  showWidth();
}

void MainWindow::connectPanels() {
  connect(targets_, &panels::TargetPanel::targetEdited, edits_, &EditController::replaceTarget);
  connect(targets_, &panels::TargetPanel::removeRequested, edits_, &EditController::removeTarget);
  connect(targets_, &panels::TargetPanel::moveRequested, edits_, &EditController::reorderTarget);
  connect(sites_, &panels::SitePanel::excludeRequested, edits_, &EditController::excludeSite);
  connect(sites_, &panels::SitePanel::filterChanged, edits_, &EditController::setFilter);
  connect(sites_, &panels::SitePanel::oneWayRequested, edits_, &EditController::setOneWay);
  connect(sites_, &panels::SitePanel::noteEdited, edits_, &EditController::setSiteNote);
  connect(landings_, &LandingController::asked, this, [this] {
    auto* dock = findChild<QDockWidget*>(QStringLiteral("landingDock"));
    dock->show();
    dock->raise();
  });
  connect(planning_, &PlanningController::reportReady, summary_, &panels::PlanSummaryPanel::setReport);
}

void MainWindow::showSituation() {
  const document::Situation& situation = workspace_->situation();
  map_->setSituation(situation);
  if (scene_ != nullptr) {
    scene_->setSituation(situation);
  }
  profile_->setSituation(situation);
  targets_->setSituation(situation);
  sites_->setSituation(situation);
  engineOut_->setSituation(situation);
  landing_->setSituation(situation);
  decisions_->setSituation(situation);
  summary_->setSituation(situation);
  const bool isOld = situation.plan && !situation.planIsCurrent;
  findChild<QDockWidget*>(QStringLiteral("planDock"))->setWindowTitle(isOld ? tr("Plan !") : tr("Plan"));
  refreshActions();
}

void MainWindow::refreshTitle() {
  setWindowTitle(QStringLiteral("%1[*] – Volplane").arg(workspace_->document().title()));
  setWindowModified(workspace_->document().isModified());
  setWindowFilePath(workspace_->document().path());
}

void MainWindow::applyTheme() {
  const style::Theme theme = workspace_->view().theme();
  style::applyTheme(theme);
  banner_->setTheme(theme);
  status_->refreshTheme();
  for (const auto& [target, name] : icons_) {
    target->setIcon(style::icon(name, theme));
  }
}

void MainWindow::restoreLayout() {
  resize(1480, 920);
  const document::Settings settings(iniFile_);
  if (settings.windowGeometry().isEmpty()) {
    const auto dock = [this](const char* name) { return findChild<QDockWidget*>(QLatin1String(name)); };
    resizeDocks({dock("targetsDock"), dock("engineOutDock")}, {kTargetsWidth, kSideWidth}, Qt::Horizontal);
    resizeDocks({dock("profileDock")}, {kProfileHeight + 60}, Qt::Vertical);
    return;
  }
  restoreGeometry(settings.windowGeometry());
  restoreState(settings.windowState());
}

void MainWindow::take(const QStringList& paths) {
  files_->take(paths);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayClose([this] { close(); })) {
    event->ignore();
    return;
  }
  workspace_->stopAll();
  document::Settings settings(iniFile_);
  settings.setWindowGeometry(saveGeometry());
  settings.setWindowState(saveState());
  autosave_->discard();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) {
      paths << url.toLocalFile();
    }
  }
  if (!paths.isEmpty()) {
    event->acceptProposedAction();
    QTimer::singleShot(0, this, [this, paths] { files_->take(paths); });  // a dialog must not open while the drag still runs
  }
}

}  // namespace vp::gui
