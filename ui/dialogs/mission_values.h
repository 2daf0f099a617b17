#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QObject>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;
class QWidget;

namespace vp::dialogs {

/** Safety and planner values as two pages of fields, each with what it does and when to change it: of the open mission, or
 *  those that new missions start with. Heights are shown in the operator's units and kept in SI; a value that is not touched
 *  comes back bit for bit. */
class MissionValues : public QObject {
  Q_OBJECT

public:
  enum class Scope { OpenMission, NewMissions };  ///< a ceiling belongs to one mission: new ones start without

  MissionValues(Scope scope, const style::Units& units, QObject* parent);

  /** The pages; they belong to whoever takes them into a layout. */
  [[nodiscard]] QWidget* safetyPage() const { return safetyPage_; }
  [[nodiscard]] QWidget* plannerPage() const { return plannerPage_; }

  /** Shows the values of a mission; emits nothing. */
  void show(const mission::Mission& mission);
  /** The mission that was shown, with the values of the fields. */
  [[nodiscard]] mission::Mission values() const;
  void setUnits(const style::Units& units);
  void restoreSafety();
  void restorePlanner();

signals:
  void edited();

private:
  void buildSafety(Scope scope);
  void buildSkill(QFormLayout* form);
  void buildCeiling(QFormLayout* form);
  void buildPlanner();
  void buildRoadmap(QFormLayout* form);
  void fitToUnits();
  void fill();
  void takeSafety(mission::Mission& m) const;
  void takePlanner(mission::Mission& m) const;
  void tell();

  mission::Mission mission_;
  style::Units units_;
  bool isFilling_ = false;
  QWidget* safetyPage_ = nullptr;
  QWidget* plannerPage_ = nullptr;
  QDoubleSpinBox* clearance_ = nullptr;
  QDoubleSpinBox* arrival_ = nullptr;
  QDoubleSpinBox* reactionTime_ = nullptr;
  QDoubleSpinBox* reactionLoss_ = nullptr;
  QDoubleSpinBox* dragFactor_ = nullptr;
  QCheckBox* hasCeiling_ = nullptr;  ///< null for new missions, as the next
  QDoubleSpinBox* ceiling_ = nullptr;
  QComboBox* lowTargets_ = nullptr;
  QSpinBox* headings_ = nullptr;
  QDoubleSpinBox* step_ = nullptr;
  QDoubleSpinBox* beta_ = nullptr;
  QComboBox* method_ = nullptr;
  QCheckBox* hasSamples_ = nullptr;
  QSpinBox* samples_ = nullptr;
  QCheckBox* refine_ = nullptr;
  QSpinBox* seed_ = nullptr;
};

}  // namespace vp::dialogs
