#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace vp::dialogs {

/** Name, safety values and planner values of a mission, each with a sentence that says what it does. Values are shown in the
 *  user's units and kept in SI. A value that is not touched is not changed, whatever it looks like when rounded. */
class MissionSettingsDialog : public QDialog {
  Q_OBJECT

public:
  MissionSettingsDialog(const mission::Mission& mission, const style::Units& units, QWidget* parent = nullptr);

  /** The mission with the values of the dialog. */
  [[nodiscard]] mission::Mission result() const;

private:
  QWidget* safetyPage();
  QWidget* plannerPage();
  void restoreDefaults();
  void show(const mission::Mission& mission);
  QDoubleSpinBox* heightBox(double min, double max, const QString& name);

  mission::Mission mission_;
  style::Units units_;
  QLineEdit* name_ = nullptr;
  QDoubleSpinBox* clearance_ = nullptr;
  QDoubleSpinBox* arrival_ = nullptr;
  QCheckBox* hasCeiling_ = nullptr;
  QDoubleSpinBox* ceiling_ = nullptr;
  QComboBox* lowTargets_ = nullptr;
  QSpinBox* headings_ = nullptr;
  QDoubleSpinBox* step_ = nullptr;
  QDoubleSpinBox* beta_ = nullptr;
  QComboBox* method_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QCheckBox* hasSamples_ = nullptr;
  QSpinBox* samples_ = nullptr;
};

}  // namespace vp::dialogs
