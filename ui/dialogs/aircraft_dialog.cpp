#include "ui/dialogs/aircraft_dialog.h"

#include "core/formats/aircraft_file.h"
#include "ui/dialogs/polar_preview.h"
#include "ui/style/core_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace vp::dialogs {
namespace {

using aircraft::AircraftProfile;

QString joined(const std::vector<Angle>& banks) {
  QStringList texts;
  for (const Angle bank : banks) {
    texts << QString::number(bank.degrees(), 'g', 4);
  }
  return texts.join(QStringLiteral(", "));
}

/// Ascending angles from "30, 45"; nothing if a part is no number.
std::optional<std::vector<Angle>> parseBanks(const QString& text) {
  std::vector<double> degrees;
  for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    bool ok = false;
    degrees.push_back(part.trimmed().toDouble(&ok));
    if (!ok) {
      return std::nullopt;
    }
  }
  std::sort(degrees.begin(), degrees.end());
  std::vector<Angle> banks;
  banks.reserve(degrees.size());
  for (const double d : degrees) {
    banks.push_back(Angle::degrees(d));
  }
  return banks;
}

}  // namespace

AircraftDialog::AircraftDialog(const AircraftProfile& profile, std::string reference, const style::Units& units, style::Theme theme, QWidget* parent)
    : QDialog(parent), profile_(profile), reference_(std::move(reference)), units_(units), theme_(theme) {
  setWindowTitle(tr("Aircraft"));
  auto* column = new QVBoxLayout(this);
  auto* top = new QHBoxLayout;
  choice_ = new QComboBox;
  choice_->setObjectName(QStringLiteral("aircraftChoice"));
  choice_->setAccessibleName(tr("Aircraft profile"));
  choice_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* copy = new QPushButton(tr("&Duplicate and edit"));
  copy->setObjectName(QStringLiteral("duplicateAircraft"));
  auto* open = new QPushButton(tr("&Open…"));
  save_ = new QPushButton(tr("&Save as file…"));
  top->addWidget(choice_, 1);
  top->addWidget(copy);
  top->addWidget(open);
  top->addWidget(save_);
  column->addLayout(top);
  auto* middle = new QHBoxLayout;
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(buildForm());
  scroll->setMinimumWidth(430);
  middle->addWidget(scroll, 1);
  preview_ = new PolarPreview;
  middle->addWidget(preview_, 1);
  column->addLayout(middle, 1);
  problem_ = new QLabel;
  problem_->setWordWrap(true);
  problem_->setObjectName(QStringLiteral("aircraftProblem"));
  column->addWidget(problem_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  column->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(copy, &QPushButton::clicked, this, &AircraftDialog::duplicate);
  connect(open, &QPushButton::clicked, this, &AircraftDialog::openFile);
  connect(save_, &QPushButton::clicked, this, &AircraftDialog::saveFile);
  fillChoices();
  connect(choice_, &QComboBox::activated, this, &AircraftDialog::choose);
  showProfile();
  resize(900, 620);
}

void AircraftDialog::fillChoices() {
  choice_->clear();
  for (const std::string& name : formats::bundledAircraft()) {
    const Result<AircraftProfile> profile = formats::findAircraft(name, "");
    if (profile) {
      choice_->addItem(tr("%1 (bundled)").arg(QString::fromStdString(profile->name)), QString::fromStdString(name));
    }
  }
  int current = choice_->findData(QString::fromStdString(reference_));
  if (current < 0) {
    const QString where = reference_.empty() ? tr("in this mission") : QString::fromStdString(reference_);
    choice_->addItem(tr("%1 (%2)").arg(QString::fromStdString(profile_.name), where), QString::fromStdString(reference_));
    current = choice_->count() - 1;
  }
  choice_->setCurrentIndex(current);
}

void AircraftDialog::choose(int index) {
  const std::string name = choice_->itemData(index).toString().toStdString();
  if (name == reference_) {
    return;
  }
  const Result<AircraftProfile> profile = formats::findAircraft(name, "");
  if (!profile) {
    QMessageBox::warning(this, windowTitle(), style::coreText(profile.error()));
    fillChoices();
    return;
  }
  profile_ = *profile;
  reference_ = name;
  showProfile();
}

void AircraftDialog::duplicate() {
  profile_.name = tr("%1, copy").arg(QString::fromStdString(profile_.name)).toStdString();
  profile_.id.clear();
  reference_.clear();
  fillChoices();
  showProfile();
  name_->setFocus();
  name_->selectAll();
}

void AircraftDialog::openFile() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Open aircraft profile"), {}, tr("Aircraft profiles (*.json)"));
  if (path.isEmpty()) {
    return;
  }
  const Result<AircraftProfile> profile = formats::readAircraft(path.toStdString());
  if (!profile) {
    QMessageBox::warning(this, windowTitle(), style::coreText(profile.error()));
    return;
  }
  profile_ = *profile;
  reference_ = path.toStdString();
  fillChoices();
  showProfile();
}

void AircraftDialog::saveFile() {
  QString path = QFileDialog::getSaveFileName(this, tr("Save aircraft profile"), {}, tr("Aircraft profiles (*.json)"));
  if (path.isEmpty()) {
    return;
  }
  if (!path.endsWith(QStringLiteral(".json"))) {
    path += QStringLiteral(".json");
  }
  const Result<void> written = formats::writeAircraft(profile_, path.toStdString());
  if (!written) {
    QMessageBox::warning(this, windowTitle(), style::coreText(written.error()));
    return;
  }
  reference_ = path.toStdString();
  fillChoices();
  showProfile();
}

void AircraftDialog::showProfile() {
  filling_ = true;
  name_->setText(QString::fromStdString(profile_.name));
  for (Field& field : fields_) {
    field.box->setValue(field.get(profile_));
    field.shown = field.box->value();
  }
  glideBanks_->setText(joined(profile_.glideBanks));
  QStringList lines;
  for (const std::string& source : profile_.sources) {
    lines << QString::fromStdString(source);
  }
  sources_->setPlainText(lines.join(QLatin1Char('\n')));
  const bool editable = reference_.empty();
  name_->setReadOnly(!editable);
  glideBanks_->setReadOnly(!editable);
  sources_->setReadOnly(!editable);
  for (const Field& field : fields_) {
    field.box->setReadOnly(!editable);
    field.box->setButtonSymbols(editable ? QAbstractSpinBox::UpDownArrows : QAbstractSpinBox::NoButtons);
  }
  save_->setEnabled(editable);
  filling_ = false;
  check();
}

void AircraftDialog::fieldEdited() {
  if (filling_ || !reference_.empty()) {
    return;
  }
  profile_.name = name_->text().trimmed().toStdString();
  for (Field& field : fields_) {
    if (field.box->value() != field.shown) {  // rounding for display changes nothing
      field.set(profile_, field.box->value());
      field.shown = field.box->value();
    }
  }
  if (glideBanks_->text() != joined(profile_.glideBanks)) {
    profile_.glideBanks = parseBanks(glideBanks_->text()).value_or(std::vector<Angle>{});
  }
  profile_.sources.clear();
  for (const QString& line : sources_->toPlainText().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
    profile_.sources.push_back(line.trimmed().toStdString());
  }
  check();
}

void AircraftDialog::check() {
  const Result<AircraftProfile> read = formats::parseAircraft(formats::aircraftToText(profile_), "profile");
  QStringList lines;
  if (!read) {
    lines << style::coreText(read.error().what);
  } else {
    for (const std::string& warning : aircraft::profileWarnings(profile_)) {
      lines << QStringLiteral("⚠ ") + style::coreText(warning);
    }
  }
  if (lines.isEmpty() && !reference_.empty()) {
    lines << tr("This profile is not changed here; duplicate it to make one of your own.");
  }
  problem_->setText(lines.join(QLatin1Char('\n')));
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(read.has_value());
  preview_->setProfile(profile_, units_, theme_);
}

}  // namespace vp::dialogs
