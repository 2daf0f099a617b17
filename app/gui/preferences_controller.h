#pragma once

#include "ui/dialogs/preferences_dialog.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>

class QWidget;

namespace vp::gui {

/** What the operator set once for all missions: read at the start, applied at once when it changes, remembered. Menus, the
 *  preferences window and the 3D view's tool bar all change it here, so none of them can show an old state. */
class PreferencesController : public QObject {
  Q_OBJECT

public:
  /** Applies what is remembered. @param iniFile  where settings live; empty: the user's own */
  PreferencesController(jobs::Workspace& workspace, const QString& iniFile, QWidget* window);

  [[nodiscard]] const dialogs::Preferences& now() const { return now_; }
  void set(const dialogs::Preferences& preferences);
  void setUnits(style::UnitSystem units);
  void setTheme(std::optional<style::Theme> theme);
  void setScene(const scene3d::SceneOptions& options);
  void openDialog();

signals:
  void changed();
  /// A sentence that says why they will be forgotten at the end.
  void notRemembered(const QString& problem);
  /// From the dialog: the operator wants the settings of the open mission.
  void missionSettingsRequested();

private:
  void apply();

  jobs::Workspace& workspace_;
  QString iniFile_;
  QWidget* window_;
  dialogs::Preferences now_;
};

}  // namespace vp::gui
