#include "ui/dialogs/target_dialog.h"

#include "ui/panels/position_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace vp::dialogs {

using panels::parsePosition;

TargetDialog::TargetDialog(const mission::Target& target, const QStringList& takenNames, const style::Units& units, QWidget* parent)
    : QDialog(parent), target_(target), taken_(takenNames), units_(units), shownPlace_(style::Units::position(target.position)) {
  setWindowTitle(tr("Target %1").arg(QString::fromStdString(target.name)));
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  name_ = new QLineEdit(QString::fromStdString(target.name));
  place_ = new QLineEdit(shownPlace_);
  name_->setMinimumWidth(420);  // px, most names without scrolling
  name_->setCursorPosition(0);
  height_ = new QDoubleSpinBox;
  height_->setDecimals(0);
  height_->setRange(std::ceil(units.heightFromSi(-500.0)), std::floor(units.heightFromSi(20000.0)));
  height_->setSuffix(QLatin1Char(' ') + units.heightUnit());
  height_->setGroupSeparatorShown(true);
  height_->setValue(units.heightFromSi(target.height_m));
  reference_ = new QComboBox;
  reference_->addItem(tr("above ground (AGL)"), static_cast<int>(mission::HeightReference::AboveGround));
  reference_->addItem(tr("above mean sea level (MSL)"), static_cast<int>(mission::HeightReference::Msl));
  reference_->setCurrentIndex(reference_->findData(static_cast<int>(target.reference)));
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Position"), place_);
  form->addRow(tr("&Height"), height_);
  form->addRow(tr("&Measured"), reference_);
  column->addLayout(form);
  problem_ = new QLabel;
  problem_->setWordWrap(true);
  column->addWidget(problem_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons_);
  connect(name_, &QLineEdit::textChanged, this, &TargetDialog::check);
  connect(place_, &QLineEdit::textChanged, this, &TargetDialog::check);
  check();
}

void TargetDialog::check() {
  const QString name = name_->text().trimmed();
  QString problem;
  if (name.isEmpty()) {
    problem = tr("A target needs a name.");
  } else if (taken_.contains(name)) {
    problem = tr("Another target is called %1 already.").arg(name);
  } else if (!parsePosition(place_->text())) {
    problem = tr("This is not a position; write for example 46.6003 9.9017 or 46°36.02′ N 9°54.10′ E.");
  }
  problem_->setText(problem);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

mission::Target TargetDialog::result() const {
  mission::Target target = target_;
  target.name = name_->text().trimmed().toStdString();
  if (place_->text() != shownPlace_) {
    target.position = parsePosition(place_->text()).value_or(target.position);
  }
  if (std::abs(height_->value() - units_.heightFromSi(target.height_m)) > 0.5) {
    target.height_m = units_.heightToSi(height_->value());
  }
  target.reference = static_cast<mission::HeightReference>(reference_->currentData().toInt());
  return target;
}

}  // namespace vp::dialogs
