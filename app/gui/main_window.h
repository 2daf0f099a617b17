#pragma once

#include "ui/jobs/workspace.h"

#include <QMainWindow>
#include <QPointer>
#include <QString>

#include <memory>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;
class QSplitter;
class QToolBar;

namespace vp::dialogs {
class MessageBanner;
class MissionFilesDialog;
}  // namespace vp::dialogs
namespace vp::map {
class MapView;
}
namespace vp::panels {
class DecisionTable;
class EngineOutPanel;
class LandingPanel;
class PlanSummaryPanel;
class SitePanel;
class TargetPanel;
}  // namespace vp::panels
namespace vp::profile {
class ProfileView;
}
namespace vp::scene3d {
class SceneView;
}

namespace vp::gui {

class AlternativesFeed;
class AutosaveKeeper;
class BriefingController;
class EditController;
class ExportController;
class FetchController;
class FileController;
class HelpController;
class LandingController;
class PlanningController;
class PreferencesController;
class StatusLine;
class TaskbarProgress;
class WeatherController;

/** The window: map in the middle, docks around it, actions in menus and tool bar. Composition only: what actions do is in
 *  the controllers beside this file, what is drawn in ui/. */
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /** @param iniFile  where settings live; empty: the user's own */
  explicit MainWindow(const QString& iniFile = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  /** Opens a mission or plan, or adds terrain and airfields. */
  void take(const QStringList& paths);
  /** What a start without arguments shows: work of a crashed session, else the last mission, else the bundled one. */
  void welcome();

  [[nodiscard]] jobs::Workspace& workspace() { return *workspace_; }
  [[nodiscard]] map::MapView& mapView() { return *map_; }
  [[nodiscard]] profile::ProfileView& profileView() { return *profile_; }
  [[nodiscard]] dialogs::MessageBanner& banner() { return *banner_; }
  /** The action of a name as in objectName, for tests and for the manual's pictures. */
  [[nodiscard]] QAction* action(const QString& name) const;
  /** Shows or hides the 3D view beside the map; it is made when it is first shown. */
  void showScene(bool visible);
  [[nodiscard]] scene3d::SceneView* sceneView() { return scene_; }
  [[nodiscard]] PreferencesController& preferences() { return *preferences_; }
  [[nodiscard]] FileController& files() { return *files_; }
  [[nodiscard]] FetchController& fetches() { return *fetches_; }
  [[nodiscard]] BriefingController& briefings() { return *briefings_; }
  [[nodiscard]] WeatherController& weather() { return *weather_; }
  [[nodiscard]] HelpController& help() { return *help_; }

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void buildCentre();
  void buildDocks();
  void buildActions();
  void buildFileMenu();
  void buildEditMenu();
  void buildMissionMenu();
  void buildPlanMenu();
  void buildViewMenu();
  void buildOverlayMenu();
  void buildPlaceActions(QMenu* menu);
  void buildUnitsMenu(QMenu* menu);
  void buildAppearanceMenu(QMenu* menu);
  void buildHelpMenu();
  void buildToolBar();
  QAction* add(QMenu* menu, const char* name, const QString& text, const char* iconName, const QKeySequence& shortcut);
  void connectViews();
  void connectMap();
  void connectPanels();
  void showSituation();
  void refreshActions();
  void refreshTitle();
  void refreshRecent();
  void applyTheme();
  void restoreLayout();
  void openLast(const QString& problem);
  void showHint();
  void showShortcuts();
  void showFiles();
  void jump();
  void fetchTerrain();
  void setFullScreen(bool on);

  std::unique_ptr<jobs::Workspace> workspace_;
  dialogs::MessageBanner* banner_ = nullptr;
  QSplitter* centre_ = nullptr;
  map::MapView* map_ = nullptr;
  scene3d::SceneView* scene_ = nullptr;
  QWidget* sceneHost_ = nullptr;
  profile::ProfileView* profile_ = nullptr;
  panels::TargetPanel* targets_ = nullptr;
  panels::SitePanel* sites_ = nullptr;
  panels::EngineOutPanel* engineOut_ = nullptr;
  panels::LandingPanel* landing_ = nullptr;
  panels::DecisionTable* decisions_ = nullptr;
  panels::PlanSummaryPanel* summary_ = nullptr;
  StatusLine* status_ = nullptr;
  EditController* edits_ = nullptr;
  FileController* files_ = nullptr;
  PlanningController* planning_ = nullptr;
  HelpController* help_ = nullptr;
  LandingController* landings_ = nullptr;
  PreferencesController* preferences_ = nullptr;
  ExportController* exports_ = nullptr;
  FetchController* fetches_ = nullptr;
  BriefingController* briefings_ = nullptr;
  AlternativesFeed* alternatives_ = nullptr;
  AutosaveKeeper* autosave_ = nullptr;
  TaskbarProgress* taskbar_ = nullptr;
  WeatherController* weather_ = nullptr;
  QPointer<dialogs::MissionFilesDialog> filesDialog_;
  QMenu* recent_ = nullptr;
  QMenu* view_ = nullptr;
  QToolBar* tools_ = nullptr;
  std::vector<std::pair<QAction*, QString>> icons_;  ///< drawn again when the theme changes
  QString iniFile_;
};

}  // namespace vp::gui
