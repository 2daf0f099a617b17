#include "ui/dialogs/condition_values.h"

#include "core/mission/settings_check.h"
#include "ui/dialogs/field_tools.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <cmath>
#include <initializer_list>

namespace vp::dialogs {
namespace {

constexpr double kUsualSlope = 5.0;     // degrees, proposed
constexpr double kUsualKey = 300.0;     // m, proposed: about 1000 ft
constexpr double kUsualSurface = 0.05;  // proposed: 1 : 20, ICAO Annex 14 table 4-1, code number 1
constexpr double kPercent = 100.0;
constexpr double kLeastFinal = 100.0;  // m

QDoubleSpinBox* numberBox(const char* name, const QString& accessible, int decimals, double step, const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setAccessibleName(accessible);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setSuffix(suffix);
  return box;
}

QCheckBox* check(const char* name, const QString& text) {
  auto* box = new QCheckBox(text);
  box->setObjectName(QLatin1String(name));
  return box;
}

/// A check box above the fields that it is about.
QWidget* group(QCheckBox* check, std::initializer_list<QWidget*> fields) {
  auto* both = new QWidget;
  auto* column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(check);
  auto* row = new QHBoxLayout;
  for (QWidget* field : fields) {
    row->addWidget(field, 1);
  }
  column->addLayout(row);
  return both;
}

/// Takes what a box says, unless it still shows what it was given.
void takeNumber(double& value, const QDoubleSpinBox* box, double perShown) {
  if (!isUntouched(value / perShown, box)) {
    value = box->value() * perShown;
  }
}

void takeLength(Length& value, const QDoubleSpinBox* box, double perShown) {
  double metres = value.si();
  takeNumber(metres, box, perShown);
  value = Length::fromSi(metres);
}

void setEntryEnabled(QComboBox* box, int data, bool isEnabled) {
  auto* model = qobject_cast<QStandardItemModel*>(box->model());
  const int index = box->findData(data);
  if (model != nullptr && index >= 0) {
    model->item(index)->setEnabled(isEnabled);
  }
}

}  // namespace

ConditionValues::ConditionValues(const style::Units& units, QObject* parent) : QObject(parent), units_(units) {
  buildAir();
  buildApproach();
  connect(kind_, &QComboBox::currentIndexChanged, this, &ConditionValues::enableFields);
  for (QCheckBox* box : {hasAir_, hasSlope_, hasKey_, hasSurface_}) {
    connect(box, &QCheckBox::toggled, this, &ConditionValues::enableFields);
  }
  fill();
}

void ConditionValues::buildAir() {
  airPage_ = new QWidget;
  auto* form = new QFormLayout(airPage_);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  hasAir_ = check("hasAir", tr("Count with the air of the day"));
  temperature_ = numberBox("temperatureOffset", tr("Temperature above the standard atmosphere"), 0, 1.0, tr(" °C from standard"));
  temperature_->setRange(mission::kTemperatureOffset.least, mission::kTemperatureOffset.most);
  qnh_ = numberBox("qnh", tr("QNH"), 0, 1.0, tr(" hPa QNH"));
  qnh_->setRange(mission::kQnh.least, mission::kQnh.most);
  addField(form, tr("&Air"), group(hasAir_, {temperature_, qnh_}),
           tr("In thin air the same indicated speed is a faster one: turns are wider and landings longer. Standard is 15 °C at sea level, 2 °C less "
              "every 1000 ft, and 1013 hPa (29.92 inHg). Without it the density of the aircraft’s polar counts at every height."),
           hasAir_);
  propeller_ = new QComboBox;
  propeller_->setObjectName(QStringLiteral("propeller"));
  propeller_->addItem(tr("As the aircraft’s polar has it"), static_cast<int>(aircraft::Propeller::AsInPolar));
  propeller_->addItem(tr("Windmilling, turned by the air"), static_cast<int>(aircraft::Propeller::Windmilling));
  propeller_->addItem(tr("Stopped"), static_cast<int>(aircraft::Propeller::Stopped));
  addField(form, tr("&Propeller"), propeller_,
           tr("What it does after the engine has stopped. A windmilling propeller brakes most; count on a stopped one only if you know that it "
              "stops. What "
              "the aircraft’s profile says nothing of cannot be chosen."));
  power_ = new QComboBox;
  power_->setObjectName(QStringLiteral("power"));
  addField(form, tr("P&ower on the tour"), power_,
           tr("The airspeed of the tour between glides: faster is sooner home, but turns are wider and more ground goes by before you react."));
}

void ConditionValues::buildApproach() {
  approachPage_ = new QWidget;
  auto* form = new QFormLayout(approachPage_);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  kind_ = new QComboBox;
  kind_->setObjectName(QStringLiteral("approachKind"));
  kind_->addItem(tr("At the threshold, by any curve"), static_cast<int>(mission::ApproachKind::Threshold));
  kind_->addItem(tr("Straight in"), static_cast<int>(mission::ApproachKind::Straight));
  kind_->addItem(tr("From overhead, by a full circle"), static_cast<int>(mission::ApproachKind::Overhead));
  addField(form, tr("&Glides end"), kind_,
           tr("At the threshold is the lowest and the hardest to fly: the last turn may end at the runway. Straight in ends it before. From overhead "
              "is the "
              "key-point pattern of forced landings: high key above the runway, low key abeam."));
  const bool isAviation = units_.system() == style::UnitSystem::Aviation;
  finalLength_ = numberBox("finalLength", tr("Length of the final approach"), 2, 0.1, QLatin1Char(' ') + units_.distanceUnit());
  finalLength_->setRange(units_.distanceFromSi(kLeastFinal), units_.distanceFromSi(mission::kFinalLength.most));
  addField(form, tr("&Final"), finalLength_, tr("Straight in: length over ground of the last straight on the landing course."));
  hasSlope_ = check("hasSlope", tr("At a slope of my choice"));
  slope_ = numberBox("slope", tr("Slope of the final approach"), 1, 0.5, QStringLiteral("°"));
  slope_->setRange(0.1, mission::kApproachSlope.most);
  addField(
      form, tr("&Slope"), group(hasSlope_, {slope_}),
      tr("Straight in: descent over ground with flaps, brakes or a slip; otherwise that of the best glide. Needs an aircraft whose profile has its "
         "steepest descent."),
      hasSlope_);
  hasKey_ = check("hasKey", tr("High key no lower than"));
  key_ = numberBox("keyHeight", tr("Height of high key above the runway"), 0, isAviation ? 50.0 : 10.0, QLatin1Char(' ') + units_.heightUnit());
  key_->setRange(0.0, std::floor(units_.heightFromSi(mission::kKeyHeight.most)));
  addField(form, tr("High &key"), group(hasKey_, {key_}),
           tr("From overhead: height above the runway where the circle begins; otherwise what the circle loses."), hasKey_);
  buildSurface(form);
  hold_ = check("hold", tr("Circles to lose height before each approach"));
  addField(form, tr("S&urplus height"), hold_,
           tr("Only runways where a circle over the beginning of the approach is clear of terrain: most failures happen higher than the lowest safe "
              "altitude, "
              "and the rest of the height has to go somewhere."));
}

void ConditionValues::buildSurface(QFormLayout* form) {
  hasSurface_ = check("hasSurface", tr("Above an obstacle surface instead of the clearance"));
  surfaceSlope_ = numberBox("surfaceSlope", tr("Slope of the obstacle surface"), 1, 0.5, tr(" % slope"));
  surfaceSlope_->setRange(0.1, kPercent * mission::kSurfaceSlope.most);
  surfaceStart_ = numberBox("surfaceStart", tr("Begin of the obstacle surface before touchdown"), 0, 10.0,
                            QLatin1Char(' ') + units_.heightUnit() + tr(" before touchdown"));
  surfaceStart_->setRange(0.0, std::floor(units_.heightFromSi(mission::kSurfaceStart.most)));
  addField(
      form, tr("Obstac&les"), group(hasSurface_, {surfaceSlope_, surfaceStart_}),
      tr("Straight in and from overhead, on the last part only: runways are kept clear above such a surface (ICAO: 5 % from 60 m for short ones, "
         "2.5 % for long ones). Runways in narrow valleys then count that the whole clearance would rule out."),
      hasSurface_);
}

void ConditionValues::show(const mission::Mission& mission) {
  mission_ = mission;
  fill();
}

void ConditionValues::fillChoices() {
  const aircraft::AircraftProfile& craft = mission_.aircraft;
  setEntryEnabled(propeller_, static_cast<int>(aircraft::Propeller::Windmilling), craft.windmillingDrag.has_value());
  setEntryEnabled(propeller_, static_cast<int>(aircraft::Propeller::Stopped), craft.stoppedDrag.has_value());
  choose(propeller_, static_cast<int>(mission_.propeller));
  power_->clear();
  power_->addItem(tr("At best glide speed, %1").arg(units_.speed(craft.bestGlideSpeed.si())), QString());
  for (const aircraft::PowerSetting& one : craft.powerSettings) {
    const QString name = QString::fromStdString(one.name);
    power_->addItem(tr("%1, %2 TAS").arg(name, units_.speed(one.trueAirspeed.si())), name);
  }
  const QString chosen = QString::fromStdString(mission_.powerSetting);
  if (power_->findData(chosen) < 0) {
    power_->addItem(tr("%1, which the aircraft lacks").arg(chosen), chosen);  // planning will say so
  }
  power_->setCurrentIndex(power_->findData(chosen));
}

void ConditionValues::fill() {
  const air::Atmosphere air = mission_.atmosphere.value_or(air::Atmosphere());
  hasAir_->setChecked(mission_.atmosphere.has_value());
  temperature_->setValue(air.temperatureOffset_K);
  qnh_->setValue(air.qnh_hPa);
  fillChoices();
  const mission::ApproachSettings& approach = mission_.approach;
  choose(kind_, static_cast<int>(approach.kind));
  finalLength_->setValue(units_.distanceFromSi(approach.finalLength.si()));
  hasSlope_->setChecked(approach.slope.has_value());
  slope_->setValue(approach.slope ? approach.slope->degrees() : kUsualSlope);
  hasKey_->setChecked(approach.keyHeight.has_value());
  key_->setValue(units_.heightFromSi(approach.keyHeight ? approach.keyHeight->si() : kUsualKey));
  hasSurface_->setChecked(approach.surfaceSlope.has_value());
  surfaceSlope_->setValue(kPercent * approach.surfaceSlope.value_or(kUsualSurface));
  surfaceStart_->setValue(units_.heightFromSi(approach.surfaceStart.si()));
  hold_->setChecked(approach.hold);
  enableFields();
}

void ConditionValues::enableFields() {
  const auto kind = static_cast<mission::ApproachKind>(kind_->currentData().toInt());
  const bool isStraight = kind == mission::ApproachKind::Straight;
  const bool isOverhead = kind == mission::ApproachKind::Overhead;
  temperature_->setEnabled(hasAir_->isChecked());
  qnh_->setEnabled(hasAir_->isChecked());
  finalLength_->setEnabled(isStraight);
  hasSlope_->setEnabled(isStraight && (mission_.aircraft.steepestDescent || hasSlope_->isChecked()));  // one that is not allowed can be taken away
  slope_->setEnabled(isStraight && hasSlope_->isChecked());
  hasKey_->setEnabled(isOverhead);
  key_->setEnabled(isOverhead && hasKey_->isChecked());
  hasSurface_->setEnabled(isStraight || isOverhead);
  surfaceSlope_->setEnabled(hasSurface_->isEnabled() && hasSurface_->isChecked());
  surfaceStart_->setEnabled(surfaceSlope_->isEnabled());
}

void ConditionValues::takeApproach(mission::ApproachSettings& approach) const {
  approach.kind = static_cast<mission::ApproachKind>(kind_->currentData().toInt());
  takeLength(approach.finalLength, finalLength_, units_.distanceToSi(1.0));
  if (!hasSlope_->isChecked()) {
    approach.slope.reset();
  } else if (!approach.slope || !isUntouched(approach.slope->degrees(), slope_)) {
    approach.slope = Angle::degrees(slope_->value());
  }
  if (!hasKey_->isChecked()) {
    approach.keyHeight.reset();
  } else if (!approach.keyHeight || !isUntouched(units_.heightFromSi(approach.keyHeight->si()), key_)) {
    approach.keyHeight = Length::fromSi(units_.heightToSi(key_->value()));
  }
  if (!hasSurface_->isChecked()) {
    approach.surfaceSlope.reset();
  } else if (!approach.surfaceSlope || !isUntouched(kPercent * *approach.surfaceSlope, surfaceSlope_)) {
    approach.surfaceSlope = surfaceSlope_->value() / kPercent;
  }
  takeLength(approach.surfaceStart, surfaceStart_, units_.heightToSi(1.0));
  approach.hold = hold_->isChecked();
}

void ConditionValues::take(mission::Mission& mission) const {
  if (hasAir_->isChecked()) {
    air::Atmosphere air = mission_.atmosphere.value_or(air::Atmosphere());
    takeNumber(air.temperatureOffset_K, temperature_, 1.0);
    takeNumber(air.qnh_hPa, qnh_, 1.0);
    mission.atmosphere = air;
  } else {
    mission.atmosphere.reset();
  }
  mission.propeller = static_cast<aircraft::Propeller>(propeller_->currentData().toInt());
  mission.powerSetting = power_->currentData().toString().toStdString();
  mission.approach = mission_.approach;
  takeApproach(mission.approach);
}

void ConditionValues::restore() {
  mission_.atmosphere.reset();
  mission_.propeller = aircraft::Propeller::AsInPolar;
  mission_.powerSetting.clear();
  mission_.approach = {};
  fill();
}

}  // namespace vp::dialogs
