#include "ui/dialogs/weather_dialog.h"

#include "ui/dialogs/field_tools.h"
#include "ui/document/weather_view.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace vp::dialogs {
namespace {

constexpr double kLowest = -1000.0;  // m MSL, as in mission files
constexpr double kHighest = 100000.0;
constexpr double kUsualFloor = 0.0;    // m MSL, where a floor is wished for the first time
constexpr double kUsualTop = 3048.0;   // 10000 ft
constexpr double kLeastSuccess = 0.1;  // percent
constexpr double kStep = 500.0;        // of the unit of heights

QDoubleSpinBox* heightField(const style::Units& units, double metres, const QString& name) {
  auto* field = new QDoubleSpinBox;
  field->setObjectName(name);
  field->setDecimals(0);
  field->setRange(std::ceil(units.heightFromSi(kLowest)), std::floor(units.heightFromSi(kHighest)));
  field->setSingleStep(kStep);
  field->setGroupSeparatorShown(true);
  field->setSuffix(QStringLiteral(" %1 MSL").arg(units.heightUnit()));
  field->setValue(units.heightFromSi(metres));
  return field;
}

QWidget* beside(QWidget* left, QWidget* right) {
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(left, 1);
  row->addWidget(right);
  return both;
}

}  // namespace

WeatherDialog::WeatherDialog(const mission::WeatherCell& cell, const QString& title, const style::Units& units, QWidget* parent)
    : QDialog(parent), cell_(cell), units_(units) {
  setObjectName(QStringLiteral("weatherDialog"));
  setWindowTitle(title);
  name_ = new QLineEdit(QString::fromStdString(cell.name));
  name_->setObjectName(QStringLiteral("weatherName"));
  name_->setPlaceholderText(title);
  name_->setMinimumWidth(320);
  floor_ = heightField(units, cell.floor.value_or(kUsualFloor), QStringLiteral("weatherFloor"));
  top_ = heightField(units, cell.top.value_or(std::max(kUsualTop, cell.floor.value_or(0.0) + kUsualTop)), QStringLiteral("weatherTop"));
  fromGround_ = new QCheckBox(tr("from the &ground"));
  fromGround_->setObjectName(QStringLiteral("weatherFromGround"));
  fromGround_->setChecked(!cell.floor);
  unlimited_ = new QCheckBox(tr("&unlimited"));
  unlimited_->setObjectName(QStringLiteral("weatherUnlimited"));
  unlimited_->setChecked(!cell.top);
  success_ = new QDoubleSpinBox;
  success_->setObjectName(QStringLiteral("weatherSuccess"));
  success_->setDecimals(1);
  success_->setRange(kLeastSuccess, 100.0);
  success_->setSuffix(tr(" % for each %1").arg(units.distanceUnit()));
  success_->setValue(100.0 * document::weatherSuccess(cell, units));
  shownSuccess_ = success_->value();
  auto* form = new QFormLayout;
  form->addRow(tr("&Name"), name_);
  addField(form, tr("&Floor"), beside(floor_, fromGround_), {}, floor_);
  addField(form, tr("&Top"), beside(top_, unlimited_), {}, top_);
  addField(
      form, tr("&Coming through"), success_,
      tr("How likely a flight is to come through so much of it. A guess in round figures will do: planners of landings keep out of weather where "
         "they can, and say how likely the rest is."));
  problem_ = new QLabel;
  problem_->setWordWrap(true);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(problem_);
  column->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QCheckBox* box : {fromGround_, unlimited_}) {
    connect(box, &QCheckBox::toggled, this, &WeatherDialog::check);
  }
  for (QDoubleSpinBox* field : {floor_, top_}) {
    connect(field, &QDoubleSpinBox::valueChanged, this, &WeatherDialog::check);
  }
  check();
}

void WeatherDialog::check() {
  floor_->setEnabled(!fromGround_->isChecked());
  top_->setEnabled(!unlimited_->isChecked());
  const bool isUpsideDown = floor_->isEnabled() && top_->isEnabled() && floor_->value() >= top_->value();
  problem_->setText(isUpsideDown ? tr("The top must be above the floor.") : QString());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(!isUpsideDown);
}

std::optional<double> WeatherDialog::heightOf(const QCheckBox& none, const QDoubleSpinBox& field, const std::optional<double>& before) const {
  if (none.isChecked()) {
    return std::nullopt;
  }
  const bool isKept = before && std::abs(units_.heightFromSi(*before) - field.value()) <= 0.5;
  return isKept ? before : std::optional(units_.heightToSi(field.value()));
}

mission::WeatherCell WeatherDialog::result() const {
  mission::WeatherCell cell = cell_;
  cell.name = name_->text().trimmed().toStdString();
  cell.floor = heightOf(*fromGround_, *floor_, cell_.floor);
  cell.top = heightOf(*unlimited_, *top_, cell_.top);
  if (success_->value() != shownSuccess_) {
    cell.success = success_->value() / 100.0;
    cell.perDistance = units_.distanceToSi(1.0);
  }
  return cell;
}

}  // namespace vp::dialogs
