#include "ui/dialogs/aircraft_dialog.h"

#include "core/formats/aircraft_file.h"
#include "ui/dialogs/polar_preview.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

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

QDoubleSpinBox* AircraftDialog::addNumber(QFormLayout* form, const QString& label, const QString& unit, int decimals, double min, double max,
                                          std::function<double(const AircraftProfile&)> get, std::function<void(AircraftProfile&, double)> set) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(decimals);
  box->setRange(min, max);
  box->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
  box->setSingleStep(std::pow(10.0, -decimals) * (decimals > 2 ? 10.0 : 1.0));
  box->setAccessibleName(label);
  form->addRow(label, box);
  fields_.push_back({box, std::move(get), std::move(set)});
  connect(box, &QDoubleSpinBox::valueChanged, this, &AircraftDialog::fieldEdited);
  return box;
}

QWidget* AircraftDialog::buildForm() {
  form_ = new QWidget;
  auto* form = new QFormLayout(form_);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("aircraftName"));
  form->addRow(tr("Name"), name_);
  connect(name_, &QLineEdit::textEdited, this, &AircraftDialog::fieldEdited);
  using P = AircraftProfile;
  addNumber(
      form, tr("Mass"), tr("kg"), 0, 1, 600000, [](const P& p) { return p.mass_kg; }, [](P& p, double v) { p.mass_kg = v; });
  addNumber(
      form, tr("Wing area"), tr("m²"), 2, 0.01, 1000, [](const P& p) { return p.wingArea_m2; }, [](P& p, double v) { p.wingArea_m2 = v; });
  addNumber(
      form, tr("Zero-lift drag C_D0"), {}, 4, 0.001, 1, [](const P& p) { return p.zeroLiftDrag; }, [](P& p, double v) { p.zeroLiftDrag = v; })
      ->setObjectName(QStringLiteral("zeroLiftDrag"));
  addNumber(
      form, tr("Induced drag factor L"), {}, 4, 0.001, 1, [](const P& p) { return p.inducedDrag; }, [](P& p, double v) { p.inducedDrag = v; });
  addNumber(
      form, tr("Air density"), tr("kg/m³"), 3, 0.1, 1.6, [](const P& p) { return p.airDensity_kgm3; }, [](P& p, double v) { p.airDensity_kgm3 = v; });
  addNumber(
      form, tr("Best glide speed (TAS)"), tr("m/s"), 1, 5, 150, [](const P& p) { return p.bestGlideSpeed.si(); },
      [](P& p, double v) { p.bestGlideSpeed = Speed::fromSi(v); });
  glideBanks_ = new QLineEdit;
  glideBanks_->setObjectName(QStringLiteral("glideBanks"));
  glideBanks_->setToolTip(tr("Bank angles that a glide may choose among in its turns, in degrees, separated by commas"));
  form->addRow(tr("Banks in a glide (°)"), glideBanks_);
  connect(glideBanks_, &QLineEdit::textEdited, this, &AircraftDialog::fieldEdited);
  addNumber(
      form, tr("Bank on the tour"), tr("°"), 1, 1, 80, [](const P& p) { return p.tourBank.degrees(); },
      [](P& p, double v) { p.tourBank = Angle::degrees(v); });
  addNumber(
      form, tr("Steepest climb"), tr("°"), 1, 0.1, 60, [](const P& p) { return p.maxClimb.degrees(); },
      [](P& p, double v) { p.maxClimb = Angle::degrees(v); });
  addNumber(
      form, tr("Steepest descent"), tr("°"), 1, 0.1, 60, [](const P& p) { return p.maxDescent.degrees(); },
      [](P& p, double v) { p.maxDescent = Angle::degrees(v); });
  QDoubleSpinBox* stall = addNumber(
      form, tr("Stall speed, wings level"), tr("m/s"), 1, 0, 150, [](const P& p) { return p.stallSpeed ? p.stallSpeed->si() : 0.0; },
      [](P& p, double v) { p.stallSpeed = v > 0.0 ? std::optional(Speed::fromSi(v)) : std::nullopt; });
  QDoubleSpinBox* load = addNumber(
      form, tr("Highest load factor"), {}, 2, 0, 20, [](const P& p) { return p.maxLoadFactor.value_or(0.0); },
      [](P& p, double v) { p.maxLoadFactor = v >= 1.0 ? std::optional(v) : std::nullopt; });
  QDoubleSpinBox* ceiling = addNumber(
      form, tr("Ceiling"), tr("m MSL"), 0, 0, 20000, [](const P& p) { return p.ceiling ? p.ceiling->metres() : 0.0; },
      [](P& p, double v) { p.ceiling = v > 0.0 ? std::optional(geo::HeightMsl::fromMetres(v)) : std::nullopt; });
  for (QDoubleSpinBox* box : {stall, load, ceiling}) {
    box->setSpecialValueText(tr("not given"));
  }
  sources_ = new QPlainTextEdit;
  sources_->setPlaceholderText(tr("Where each number comes from, one sentence a line"));
  sources_->setMinimumHeight(90);
  form->addRow(tr("Sources"), sources_);
  connect(sources_, &QPlainTextEdit::textChanged, this, &AircraftDialog::fieldEdited);
  return form_;
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
    QMessageBox::warning(this, windowTitle(), QString::fromStdString(profile.error().message()));
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
    QMessageBox::warning(this, windowTitle(), QString::fromStdString(profile.error().message()));
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
    QMessageBox::warning(this, windowTitle(), QString::fromStdString(written.error().message()));
    return;
  }
  reference_ = path.toStdString();
  fillChoices();
  showProfile();
}

void AircraftDialog::showProfile() {
  filling_ = true;
  name_->setText(QString::fromStdString(profile_.name));
  for (const Field& field : fields_) {
    field.box->setValue(field.get(profile_));
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
  for (const Field& field : fields_) {
    const double step = std::pow(10.0, -field.box->decimals());
    if (std::abs(field.box->value() - field.get(profile_)) > 0.5 * step) {  // rounding for display changes nothing
      field.set(profile_, field.box->value());
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
    lines << QString::fromStdString(read.error().what);
  } else {
    for (const std::string& warning : aircraft::profileWarnings(profile_)) {
      lines << QStringLiteral("⚠ ") + QString::fromStdString(warning);
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
