#include "ui/dialogs/mission_settings_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vp::dialogs {
namespace {

/// A field with the sentence that explains it underneath.
void addField(QFormLayout* form, const QString& label, QWidget* field, const QString& explanation) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 6);
  column->setSpacing(2);
  column->addWidget(field);
  auto* text = new QLabel(explanation);
  text->setWordWrap(true);
  text->setForegroundRole(QPalette::PlaceholderText);
  column->addWidget(text);
  auto* name = new QLabel(label);
  name->setBuddy(field);
  field->setAccessibleName(label);
  field->setAccessibleDescription(explanation);
  form->addRow(name, box);
}

/// Rounded display must not change a value that nobody touched.
bool isUntouched(double shown, const QDoubleSpinBox* box) {
  return std::abs(box->value() - shown) <= 0.5 * std::pow(10.0, -box->decimals());
}

}  // namespace

MissionSettingsDialog::MissionSettingsDialog(const mission::Mission& mission, const style::Units& units, QWidget* parent)
    : QDialog(parent), mission_(mission), units_(units) {
  setWindowTitle(tr("Mission settings"));
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("missionName"));
  form->addRow(tr("&Name"), name_);
  column->addLayout(form);
  auto* tabs = new QTabWidget;
  tabs->addTab(safetyPage(), tr("Safety"));
  tabs->addTab(plannerPage(), tr("Planner"));
  column->addWidget(tabs);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, &MissionSettingsDialog::restoreDefaults);
  column->addWidget(buttons);
  show(mission_);
  resize(560, sizeHint().height());
}

QDoubleSpinBox* MissionSettingsDialog::heightBox(double min, double max, const QString& name) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setDecimals(0);
  box->setRange(std::ceil(units_.heightFromSi(min)), std::floor(units_.heightFromSi(max)));
  box->setSingleStep(units_.system() == style::UnitSystem::Aviation ? 50.0 : 10.0);
  box->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  box->setGroupSeparatorShown(true);
  return box;
}

QWidget* MissionSettingsDialog::safetyPage() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  clearance_ = heightBox(0.0, 5000.0, QStringLiteral("clearance"));
  addField(form, tr("Terrain &clearance"), clearance_,
           tr("Kept above the highest terrain post everywhere, on the tour and on every landing glide. Includes the height that rolling into turns "
              "costs."));
  arrival_ = heightBox(0.0, 2000.0, QStringLiteral("arrivalMargin"));
  addField(form, tr("&Arrival height"), arrival_, tr("Height above the runway that every glide must still have at the touchdown point."));
  auto* ceilingRow = new QWidget;
  auto* row = new QVBoxLayout(ceilingRow);
  row->setContentsMargins(0, 0, 0, 0);
  hasCeiling_ = new QCheckBox(tr("Limit the tour's altitude"));
  hasCeiling_->setObjectName(QStringLiteral("hasCeiling"));
  ceiling_ = heightBox(-500.0, 20000.0, QStringLiteral("ceiling"));
  ceiling_->setSuffix(ceiling_->suffix() + tr(" MSL"));
  connect(hasCeiling_, &QCheckBox::toggled, ceiling_, &QWidget::setEnabled);
  row->addWidget(hasCeiling_);
  row->addWidget(ceiling_);
  addField(form, tr("C&eiling"), ceilingRow, tr("The aircraft's own ceiling counts as well; the lower of the two limits the tour."));
  lowTargets_ = new QComboBox;
  lowTargets_->setObjectName(QStringLiteral("lowTargets"));
  lowTargets_->addItem(tr("Pass above at the safe altitude"), static_cast<int>(mission::LowTargets::PassAbove));
  lowTargets_->addItem(tr("Descend to the target in a spiral"), static_cast<int>(mission::LowTargets::Descend));
  addField(form, tr("&Low targets"), lowTargets_,
           tr("For targets below the lowest safe altitude. In a spiral the gliding guarantee is suspended, and the certificate says so."));
  return page;
}

QWidget* MissionSettingsDialog::plannerPage() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  headings_ = new QSpinBox;
  headings_->setObjectName(QStringLiteral("headings"));
  headings_->setRange(1, 64);
  addField(form, tr("&Headings per target"), headings_, tr("Directions that each target may be passed in. More give shorter tours and take longer."));
  step_ = new QDoubleSpinBox;
  step_->setObjectName(QStringLiteral("step"));
  step_->setRange(1.0, 1000.0);
  step_->setDecimals(0);
  step_->setSuffix(tr(" m"));
  addField(form, tr("&Distance between decision points"), step_,
           tr("Each decision point has its own landing glide; between them the aircraft glides on to the next."));
  beta_ = new QDoubleSpinBox;
  beta_->setObjectName(QStringLiteral("beta"));
  beta_->setRange(2.0, 1000.0);
  beta_->setDecimals(1);
  addField(form, tr("Cost of passing &above targets"), beta_, tr("Metres of detour that one metre above a target is worth; at least 2."));
  method_ = new QComboBox;
  method_->addItem(tr("Lazy: proves only the legs that matter"), static_cast<int>(mission::Method::Lazy));
  method_->addItem(tr("Base: computes every leg (slow)"), static_cast<int>(mission::Method::Base));
  addField(form, tr("&Method"), method_, tr("Both end with the same tour."));
  hasSamples_ = new QCheckBox(tr("Set the number of glides in the roadmap"));
  samples_ = new QSpinBox;
  samples_->setRange(0, 10'000'000);
  samples_->setSingleStep(1000);
  samples_->setGroupSeparatorShown(true);
  connect(hasSamples_, &QCheckBox::toggled, samples_, &QWidget::setEnabled);
  auto* roadmap = new QWidget;
  auto* column = new QVBoxLayout(roadmap);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(hasSamples_);
  column->addWidget(samples_);
  addField(form, tr("&Roadmap"), roadmap, tr("Left alone, it is chosen from the size of the area."));
  seed_ = new QSpinBox;
  seed_->setRange(0, std::numeric_limits<int>::max());
  addField(form, tr("&Seed"), seed_, tr("The same seed gives the same plan."));
  return page;
}

void MissionSettingsDialog::show(const mission::Mission& mission) {
  name_->setText(QString::fromStdString(mission.name));
  clearance_->setValue(units_.heightFromSi(mission.safety.clearance.si()));
  arrival_->setValue(units_.heightFromSi(mission.safety.arrivalMargin.si()));
  hasCeiling_->setChecked(mission.ceiling.has_value());
  ceiling_->setEnabled(mission.ceiling.has_value());
  const double ceiling = mission.ceiling ? mission.ceiling->metres() : mission.aircraft.ceiling ? mission.aircraft.ceiling->metres() : 4000.0;
  ceiling_->setValue(units_.heightFromSi(ceiling));
  lowTargets_->setCurrentIndex(lowTargets_->findData(static_cast<int>(mission.planner.lowTargets)));
  headings_->setValue(mission.planner.headings);
  step_->setValue(mission.planner.step.si());
  beta_->setValue(mission.planner.beta);
  method_->setCurrentIndex(method_->findData(static_cast<int>(mission.planner.method)));
  hasSamples_->setChecked(mission.planner.roadmapSamples.has_value());
  samples_->setEnabled(mission.planner.roadmapSamples.has_value());
  samples_->setValue(mission.planner.roadmapSamples.value_or(7500));
  seed_->setValue(static_cast<int>(std::min<std::uint64_t>(mission.planner.seed, std::numeric_limits<int>::max())));
}

void MissionSettingsDialog::restoreDefaults() {
  mission::Mission defaults = mission_;
  defaults.safety = {};
  defaults.planner = {};
  defaults.ceiling.reset();
  show(defaults);
}

mission::Mission MissionSettingsDialog::result() const {
  mission::Mission m = mission_;
  m.name = name_->text().trimmed().toStdString();
  const auto setHeight = [this](Length& value, const QDoubleSpinBox* box) {
    if (!isUntouched(units_.heightFromSi(value.si()), box)) {
      value = Length::fromSi(units_.heightToSi(box->value()));
    }
  };
  setHeight(m.safety.clearance, clearance_);
  setHeight(m.safety.arrivalMargin, arrival_);
  if (!hasCeiling_->isChecked()) {
    m.ceiling.reset();
  } else if (!m.ceiling || !isUntouched(units_.heightFromSi(m.ceiling->metres()), ceiling_)) {
    m.ceiling = geo::HeightMsl::fromMetres(units_.heightToSi(ceiling_->value()));
  }
  m.planner.lowTargets = static_cast<mission::LowTargets>(lowTargets_->currentData().toInt());
  m.planner.headings = headings_->value();
  if (!isUntouched(m.planner.step.si(), step_)) {
    m.planner.step = Length::fromSi(step_->value());
  }
  if (!isUntouched(m.planner.beta, beta_)) {
    m.planner.beta = beta_->value();
  }
  m.planner.method = static_cast<mission::Method>(method_->currentData().toInt());
  if (!hasSamples_->isChecked()) {
    m.planner.roadmapSamples.reset();
  } else {
    m.planner.roadmapSamples = samples_->value();
    m.planner.roadmapTime.reset();
  }
  if (m.planner.seed <= static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
    m.planner.seed = static_cast<std::uint64_t>(seed_->value());
  }
  return m;
}

}  // namespace vp::dialogs
