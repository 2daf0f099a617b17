#pragma once

#include "ui/document/mission_defaults.h"
#include "ui/scene3d/scene_options.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QTabWidget;

namespace vp::dialogs {

class MissionValues;

/** What the operator sets once for all missions. */
struct Preferences {
  style::UnitSystem units = style::UnitSystem::Aviation;
  std::optional<style::Theme> theme;      ///< nothing: as the desktop
  QString language;                       ///< code of style::languages(), from the next start on; empty: that of the system
  document::MissionDefaults newMissions;  ///< what a new mission starts with
  scene3d::SceneOptions scene;
  bool operator==(const Preferences&) const = default;
};

/** Units, appearance, values of new missions and the 3D view. Every change is told at once; there is nothing to confirm. The
 *  values of the open mission are not touched here: a button leads to where they are. */
class PreferencesDialog : public QDialog {
  Q_OBJECT

public:
  /** @param openMission  its title, for the sentence that says what is not changed */
  PreferencesDialog(const Preferences& preferences, const QString& openMission, QWidget* parent = nullptr);

  [[nodiscard]] const Preferences& preferences() const { return preferences_; }

signals:
  void changed(const vp::dialogs::Preferences& preferences);
  /// The operator wants the settings of the open mission instead.
  void missionSettingsRequested();

private:
  QWidget* generalPage();
  QWidget* scenePage();
  QWidget* newMissionPage(QWidget* values, const QString& openMission);
  void fill();
  void take();
  void restorePage();

  Preferences preferences_;
  bool isFilling_ = false;
  MissionValues* values_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QComboBox* units_ = nullptr;
  QComboBox* theme_ = nullptr;
  QComboBox* language_ = nullptr;
  QDoubleSpinBox* exaggeration_ = nullptr;
  QCheckBox* curtain_ = nullptr;
  QCheckBox* allGlides_ = nullptr;
  QCheckBox* runways_ = nullptr;
  QCheckBox* excludedRunways_ = nullptr;
  QCheckBox* labels_ = nullptr;
};

}  // namespace vp::dialogs
