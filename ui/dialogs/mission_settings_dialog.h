#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QDialog>
#include <QStringList>

class QComboBox;
class QLineEdit;

namespace vp::dialogs {

class ConditionValues;
class MissionValues;

/** Name, safety values and planner values of the open mission. What new missions start with is in the preferences. */
class MissionSettingsDialog : public QDialog {
  Q_OBJECT

public:
  /** @param runways  ids of the landing sites that the flight may start and end at */
  MissionSettingsDialog(const mission::Mission& mission, const QStringList& runways, const style::Units& units, QWidget* parent = nullptr);

  /** The mission with the values of the dialog. */
  [[nodiscard]] mission::Mission result() const;

private:
  QComboBox* runwayChoice(const QStringList& runways, const std::string& chosen, const char* objectName, const QString& accessibleName);

  QLineEdit* name_ = nullptr;
  QComboBox* takeoff_ = nullptr;  ///< first entry: none
  QComboBox* landing_ = nullptr;  ///< first entry: as takeoff_
  MissionValues* values_ = nullptr;
  ConditionValues* conditions_ = nullptr;
};

}  // namespace vp::dialogs
