#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QObject>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QWidget;

namespace vp::dialogs {

/** Air, propeller and power of a mission, and how its glides end, as two pages of fields, each with what it does. What the mission's aircraft
 *  says nothing of cannot be chosen. A value that is not touched comes back bit for bit. */
class ConditionValues : public QObject {
  Q_OBJECT

public:
  ConditionValues(const style::Units& units, QObject* parent);

  /** The pages; they belong to whoever takes them into a layout. */
  [[nodiscard]] QWidget* airPage() const { return airPage_; }
  [[nodiscard]] QWidget* approachPage() const { return approachPage_; }

  void show(const mission::Mission& mission);
  /** Gives a mission the values of the fields. */
  void take(mission::Mission& mission) const;
  /** As in the source papers: any curve to the threshold, the polar's air and propeller, best glide speed. */
  void restore();

private:
  void buildAir();
  void buildApproach();
  void buildSurface(QFormLayout* form);
  void fill();
  void fillChoices();
  void enableFields();
  void takeApproach(mission::ApproachSettings& approach) const;

  mission::Mission mission_;
  style::Units units_;
  QWidget* airPage_ = nullptr;
  QWidget* approachPage_ = nullptr;
  QCheckBox* hasAir_ = nullptr;
  QDoubleSpinBox* temperature_ = nullptr;
  QDoubleSpinBox* qnh_ = nullptr;
  QComboBox* propeller_ = nullptr;
  QComboBox* power_ = nullptr;
  QComboBox* kind_ = nullptr;
  QDoubleSpinBox* finalLength_ = nullptr;
  QCheckBox* hasSlope_ = nullptr;
  QDoubleSpinBox* slope_ = nullptr;
  QCheckBox* hasKey_ = nullptr;
  QDoubleSpinBox* key_ = nullptr;
  QCheckBox* hasSurface_ = nullptr;
  QDoubleSpinBox* surfaceSlope_ = nullptr;
  QDoubleSpinBox* surfaceStart_ = nullptr;
  QCheckBox* hold_ = nullptr;
};

}  // namespace vp::dialogs
