// The window's menus of units and appearance, and the small dialogs that ask for places and files.
#include "app/gui/edit_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "app/gui/preferences_controller.h"
#include "ui/dialogs/jump_dialog.h"
#include "ui/dialogs/mission_files_dialog.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace vp::gui {

void MainWindow::buildUnitsMenu(QMenu* menu) {
  QMenu* units = menu->addMenu(tr("&Units"));
  auto* group = new QActionGroup(this);
  const auto addUnits = [&](const char* name, const QString& text, style::UnitSystem system) {
    QAction* made = add(units, name, text, nullptr, {});
    made->setCheckable(true);
    group->addAction(made);
    const auto show = [this, made, system] { made->setChecked(preferences_->now().units == system); };
    show();
    connect(preferences_, &PreferencesController::changed, made, show);
    connect(made, &QAction::triggered, preferences_, [this, system] { preferences_->setUnits(system); });
  };
  addUnits("unitsAviation", tr("&Aviation: ft, NM, kt, ft/min"), style::UnitSystem::Aviation);
  addUnits("unitsMetric", tr("&Metric: m, km, km/h, m/s"), style::UnitSystem::Metric);
}

void MainWindow::buildAppearanceMenu(QMenu* menu) {
  QMenu* looks = menu->addMenu(tr("Appearan&ce"));
  auto* group = new QActionGroup(this);
  const auto addTheme = [&](const char* name, const QString& text, std::optional<style::Theme> theme) {
    QAction* made = add(looks, name, text, nullptr, {});
    made->setCheckable(true);
    group->addAction(made);
    const auto show = [this, made, theme] { made->setChecked(preferences_->now().theme == theme); };
    show();
    connect(preferences_, &PreferencesController::changed, made, show);
    connect(made, &QAction::triggered, preferences_, [this, theme] { preferences_->setTheme(theme); });
  };
  addTheme("themeSystem", tr("As the &desktop"), std::nullopt);
  addTheme("themeLight", tr("&Light"), style::Theme::Light);
  addTheme("themeDark", tr("Da&rk"), style::Theme::Dark);
}

void MainWindow::showFiles() {
  if (!filesDialog_) {
    filesDialog_ = new dialogs::MissionFilesDialog(this);
    filesDialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(filesDialog_, &dialogs::MissionFilesDialog::terrainRemoveRequested, edits_, &EditController::removeTerrain);
    connect(filesDialog_, &dialogs::MissionFilesDialog::airfieldsRemoveRequested, edits_, &EditController::removeAirfields);
    connect(filesDialog_, &dialogs::MissionFilesDialog::airspacesRemoveRequested, edits_, &EditController::removeAirspaces);
    connect(filesDialog_, &dialogs::MissionFilesDialog::populationRemoveRequested, edits_, &EditController::removePopulation);
    connect(filesDialog_, &dialogs::MissionFilesDialog::addPopulationRequested, files_, &FileController::addPopulationByDialog);
    connect(filesDialog_, &dialogs::MissionFilesDialog::addTerrainRequested, files_, &FileController::addTerrainByDialog);
    connect(filesDialog_, &dialogs::MissionFilesDialog::addAirfieldsRequested, files_, &FileController::addAirfieldsByDialog);
    connect(filesDialog_, &dialogs::MissionFilesDialog::addAirspacesRequested, files_, &FileController::addAirspacesByDialog);
    filesDialog_->addActions({action(QStringLiteral("editUndo")), action(QStringLiteral("editRedo"))});  // their keys work there too
    filesDialog_->setMission(workspace_->document().mission());
  }
  filesDialog_->show();
  filesDialog_->raise();
  filesDialog_->activateWindow();
}

void MainWindow::jump() {
  dialogs::JumpDialog dialog(workspace_->situation(), this);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  if (dialog.found().target >= 0) {
    workspace_->view().selectTarget(dialog.found().target);
  }
  workspace_->view().showPlace(*dialog.found().point);
}

}  // namespace vp::gui
