#include "ui/dialogs/safe_altitude_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace vp::dialogs {

SafeAltitudeDialog::SafeAltitudeDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Lowest safe altitude map"));
  setObjectName(QStringLiteral("safeAltitudeDialog"));
  courses_ = new QComboBox;
  courses_->setObjectName(QStringLiteral("chartCourses"));
  courses_->addItem(tr("Any course, and each course by itself"), static_cast<int>(charts::Courses::All));
  courses_->addItem(tr("Any course (the worst counts)"), static_cast<int>(charts::Courses::Worst));
  courses_->addItem(tr("The best course at each place"), static_cast<int>(charts::Courses::Best));
  courses_->addItem(tr("One course"), static_cast<int>(charts::Courses::One));
  course_ = new QDoubleSpinBox;
  course_->setObjectName(QStringLiteral("chartCourse"));
  course_->setRange(0.0, 360.0);
  course_->setDecimals(0);
  course_->setWrapping(true);
  course_->setSuffix(tr("° true"));
  cell_ = new QSpinBox;
  cell_->setObjectName(QStringLiteral("chartCell"));
  cell_->setRange(0, 2000);
  cell_->setSingleStep(10);
  cell_->setSpecialValueText(tr("as fine as sensible"));
  cell_->setSuffix(tr(" m"));
  interval_ = new QSpinBox;
  interval_->setObjectName(QStringLiteral("chartInterval"));
  interval_->setRange(10, 1000);
  interval_->setSingleStep(10);
  interval_->setValue(100);
  interval_->setSuffix(tr(" m"));
  auto* meaning =
      new QLabel(tr("From every place of a cell, at its altitude or above, engine off and in the mission's wind, a glide reaches a runway. GeoTIFF (.tif) "
                    "holds the values, KML "
                    "and GeoPackage (.kml, .gpkg) hold contours: between two lines the higher one counts."));
  meaning->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("&Write to…"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(courses_, &QComboBox::currentIndexChanged, this, &SafeAltitudeDialog::showChoice);
  auto* form = new QFormLayout;
  form->addRow(tr("&For"), courses_);
  form->addRow(tr("C&ourse"), course_);
  form->addRow(tr("&Cells"), cell_);
  form->addRow(tr("Contours &every"), interval_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(meaning);
  column->addWidget(buttons);
  setMinimumWidth(460);  // px: the explanation in few lines
  showChoice();
}

void SafeAltitudeDialog::showChoice() {
  course_->setEnabled(request().courses == charts::Courses::One);
}

charts::ChartRequest SafeAltitudeDialog::request() const {
  charts::ChartRequest request;
  request.courses = static_cast<charts::Courses>(courses_->currentData().toInt());
  request.course_deg = course_->value();
  request.cell = cell_->value() == 0 ? 0.0 : std::max(10.0, static_cast<double>(cell_->value()));
  request.interval = interval_->value();
  return request;
}

}  // namespace vp::dialogs
