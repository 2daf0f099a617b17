#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QDialog>

class QLineEdit;

namespace vp::dialogs {

class MissionValues;

/** Name, safety values and planner values of the open mission. What new missions start with is in the preferences. */
class MissionSettingsDialog : public QDialog {
  Q_OBJECT

public:
  MissionSettingsDialog(const mission::Mission& mission, const style::Units& units, QWidget* parent = nullptr);

  /** The mission with the values of the dialog. */
  [[nodiscard]] mission::Mission result() const;

private:
  QLineEdit* name_ = nullptr;
  MissionValues* values_ = nullptr;
};

}  // namespace vp::dialogs
