#include "ui/dialogs/import_targets_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace vp::dialogs {
namespace {

enum Heights { AsMeant, FromFile, AboveGround, Msl };
constexpr double kUsualHeight = 100.0;      // m, as targets have it that are clicked on the map
constexpr double kUsualSpacing = 500.0;     // m
constexpr double kWidestSpacing = 20000.0;  // m

}  // namespace

ImportTargetsDialog::ImportTargetsDialog(const QString& fileName, const style::Units& units, QWidget* parent) : QDialog(parent), units_(units) {
  setWindowTitle(tr("Import targets from %1").arg(fileName));
  setObjectName(QStringLiteral("importTargetsDialog"));
  heights_ = new QComboBox;
  heights_->addItem(tr("those of the file where they are flown at, else %1").arg(units_.heightAboveGround(kUsualHeight)), AsMeant);
  heights_->addItem(tr("elevations of the file (.cup, GPX, Little Navmap) too"), FromFile);
  heights_->addItem(tr("one height above ground (AGL)"), AboveGround);
  heights_->addItem(tr("one altitude above mean sea level (MSL)"), Msl);
  height_ = new QDoubleSpinBox;
  height_->setDecimals(0);
  height_->setRange(std::ceil(units_.heightFromSi(-500.0)), std::floor(units_.heightFromSi(20000.0)));
  height_->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  height_->setValue(units_.heightFromSi(kUsualHeight));
  spacing_ = new QDoubleSpinBox;
  spacing_->setDecimals(0);
  spacing_->setRange(std::ceil(units_.heightFromSi(1.0)), std::floor(units_.heightFromSi(kWidestSpacing)));
  spacing_->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  spacing_->setValue(units_.heightFromSi(kUsualSpacing));
  alongLongest_ = new QCheckBox(tr("along the &longest side of each area"));
  alongLongest_->setChecked(true);
  course_ = new QDoubleSpinBox;
  course_->setDecimals(0);
  course_->setRange(0.0, 359.0);
  course_->setWrapping(true);
  course_->setSuffix(QStringLiteral("° T"));
  tracks_ = new QCheckBox(tr("Points of &tracks too"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Heights"), heights_);
  form->addRow(tr("H&eight"), height_);
  form->addRow(tr("&Spacing of survey lines"), spacing_);
  form->addRow(tr("Lines run"), alongLongest_);
  form->addRow(tr("True &course of lines"), course_);
  form->addRow(QString(), tracks_);
  auto* hint =
      new QLabel(tr("Points, corners of lines and waypoints become targets. Areas become parallel survey lines; the ends of the lines are targets."));
  hint->setWordWrap(true);
  hint->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(hint);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(heights_, &QComboBox::currentIndexChanged, this, &ImportTargetsDialog::showState);
  connect(alongLongest_, &QCheckBox::toggled, this, &ImportTargetsDialog::showState);
  showState();
}

void ImportTargetsDialog::showState() {
  const int heights = heights_->currentData().toInt();
  height_->setEnabled(heights == AboveGround || heights == Msl);
  course_->setEnabled(!alongLongest_->isChecked());
}

formats::TargetImportOptions ImportTargetsDialog::options() const {
  formats::TargetImportOptions options;
  const double height = units_.heightToSi(height_->value());
  switch (heights_->currentData().toInt()) {
    case FromFile:
      options.fileHeights = true;
      break;
    case AboveGround:
      options.heightAboveGround_m = height;
      break;
    case Msl:
      options.heightMsl_m = height;
      break;
    default:
      break;
  }
  options.spacing = Length::fromSi(units_.heightToSi(spacing_->value()));
  if (!alongLongest_->isChecked()) {
    options.lineCourse = Angle::degrees(course_->value());
  }
  options.tracks = tracks_->isChecked();
  return options;
}

}  // namespace vp::dialogs
