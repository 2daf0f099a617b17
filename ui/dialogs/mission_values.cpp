#include "ui/dialogs/mission_values.h"

#include "core/mission/settings_check.h"
#include "ui/dialogs/field_tools.h"
#include "ui/document/mission_defaults.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vp::dialogs {
namespace {

constexpr double kHighestClearance = 5000.0;  // m, as the schema of missions
constexpr double kHighestArrival = 2000.0;    // m
constexpr double kLowestCeiling = -500.0;     // m MSL, as the schema
constexpr double kHighestCeiling = 20000.0;   // m MSL, as the schema
constexpr double kUsualCeiling = 4000.0;      // m MSL, proposed where neither mission nor aircraft has one
constexpr int kUsualSamples = 7500;           // [1]: what 30 s of RRT* gave
constexpr int kLargestSeed = std::numeric_limits<int>::max();

}  // namespace

MissionValues::MissionValues(Scope scope, const style::Units& units, QObject* parent) : QObject(parent), units_(units) {
  buildSafety(scope);
  buildPlanner();
  fitToUnits();
  fill();
  for (QDoubleSpinBox* box : {clearance_, arrival_, reactionTime_, reactionLoss_, dragFactor_, ceiling_, step_, beta_}) {
    if (box != nullptr) {
      connect(box, &QDoubleSpinBox::valueChanged, this, &MissionValues::tell);
    }
  }
  for (QSpinBox* box : {headings_, samples_, seed_}) {
    connect(box, &QSpinBox::valueChanged, this, &MissionValues::tell);
  }
  for (QComboBox* box : {lowTargets_, method_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &MissionValues::tell);
  }
  for (QCheckBox* box : {hasCeiling_, hasSamples_}) {
    if (box != nullptr) {
      connect(box, &QCheckBox::toggled, this, &MissionValues::tell);
    }
  }
}

void MissionValues::tell() {
  if (!isFilling_) {
    emit edited();
  }
}

void MissionValues::buildSafety(Scope scope) {
  safetyPage_ = new QWidget;
  auto* form = new QFormLayout(safetyPage_);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  clearance_ = new QDoubleSpinBox;
  clearance_->setObjectName(QStringLiteral("clearance"));
  addField(form, tr("Terrain &clearance"), clearance_,
           tr("Kept above the highest terrain post everywhere, on the tour and on every landing glide; includes the height that rolling into turns "
              "costs. Raise it for coarse terrain data, turbulence or an aircraft that you do not know well."));
  arrival_ = new QDoubleSpinBox;
  arrival_->setObjectName(QStringLiteral("arrivalMargin"));
  addField(form, tr("&Arrival height"), arrival_,
           tr("Height above the runway that every glide must still have at the touchdown point. Raise it to keep room for a circuit; 0 trusts the "
              "glide to the last metre."));
  buildSkill(form);
  if (scope == Scope::OpenMission) {
    buildCeiling(form);
  }
  lowTargets_ = new QComboBox;
  lowTargets_->setObjectName(QStringLiteral("lowTargets"));
  lowTargets_->addItem(tr("Pass above at the safe altitude"), static_cast<int>(mission::LowTargets::PassAbove));
  lowTargets_->addItem(tr("Descend to the target in a spiral"), static_cast<int>(mission::LowTargets::Descend));
  addField(
      form, tr("&Low targets"), lowTargets_,
      tr("For targets below the lowest safe altitude. In a spiral the gliding guarantee is suspended, and the certificate says so: choose it only "
         "where the sensor needs the height."));
}

void MissionValues::buildSkill(QFormLayout* form) {
  reactionTime_ = new QDoubleSpinBox;
  reactionTime_->setObjectName(QStringLiteral("reactionTime"));
  reactionTime_->setRange(mission::kReactionTime.least, mission::kReactionTime.most);
  reactionTime_->setDecimals(1);
  reactionTime_->setSuffix(tr(" s"));
  addField(
      form, tr("Rea&ction time"), reactionTime_,
      tr("After the engine stops the aircraft flies on for so long before it turns. Pilots take about 4 seconds (FAA-H-8083-3) when they expect it, "
         "and much longer when they do not."));
  reactionLoss_ = new QDoubleSpinBox;
  reactionLoss_->setObjectName(QStringLiteral("reactionLoss"));
  addField(
      form, tr("Height &lost in it"), reactionLoss_,
      tr("Until the glide is established, beyond what gliding loses: slowing down or speeding up, a wrong first turn. Try it with an instructor at a "
         "safe height."));
  dragFactor_ = new QDoubleSpinBox;
  dragFactor_->setObjectName(QStringLiteral("dragFactor"));
  dragFactor_->setRange(mission::kDragFactor.least, mission::kDragFactor.most);
  dragFactor_->setDecimals(2);
  dragFactor_->setSingleStep(0.05);
  dragFactor_->setPrefix(tr("× "));
  addField(
      form, tr("&Drag"), dragFactor_,
      tr("What your glides cost more than the aircraft’s profile says: speed and bank not held exactly, an aircraft that is no longer new. 1.1 makes "
         "a glide of 9 : 1 one of about 8 : 1."));
}

void MissionValues::buildCeiling(QFormLayout* form) {
  auto* both = new QWidget;
  auto* column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  hasCeiling_ = new QCheckBox(tr("Limit the tour's altitude"));
  hasCeiling_->setObjectName(QStringLiteral("hasCeiling"));
  ceiling_ = new QDoubleSpinBox;
  ceiling_->setObjectName(QStringLiteral("ceiling"));
  ceiling_->setAccessibleName(tr("Ceiling above mean sea level"));
  connect(hasCeiling_, &QCheckBox::toggled, ceiling_, &QWidget::setEnabled);
  column->addWidget(hasCeiling_);
  column->addWidget(ceiling_);
  addField(form, tr("C&eiling"), both,
           tr("The aircraft's own ceiling counts as well; the lower of the two limits the tour. Set it for airspace, cloud or oxygen."), hasCeiling_);
}

void MissionValues::buildPlanner() {
  plannerPage_ = new QWidget;
  auto* form = new QFormLayout(plannerPage_);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  headings_ = new QSpinBox;
  headings_->setObjectName(QStringLiteral("headings"));
  headings_->setRange(1, 64);
  addField(form, tr("&Headings per target"), headings_,
           tr("Directions that each target may be passed in. More give shorter tours and take longer; lower it for quick looks at many targets."));
  step_ = new QDoubleSpinBox;
  step_->setObjectName(QStringLiteral("step"));
  step_->setRange(1.0, 1000.0);
  step_->setDecimals(0);
  step_->setSuffix(tr(" m"));
  addField(form, tr("&Distance between decision points"), step_,
           tr("Each decision point has its own landing glide; between them the aircraft glides on to the next. Shorter steps allow lower tours over "
              "rough ground and take longer."));
  beta_ = new QDoubleSpinBox;
  beta_->setObjectName(QStringLiteral("beta"));
  beta_->setRange(2.0, 1000.0);
  beta_->setDecimals(1);
  addField(form, tr("Cost of passing &above targets"), beta_,
           tr("Metres of detour that one metre above a target is worth; at least 2. Raise it if targets must be seen from close by."));
  method_ = new QComboBox;
  method_->setObjectName(QStringLiteral("method"));
  method_->addItem(tr("Lazy: proves only the legs that matter"), static_cast<int>(mission::Method::Lazy));
  method_->addItem(tr("Base: computes every leg (slow)"), static_cast<int>(mission::Method::Base));
  addField(form, tr("&Method"), method_, tr("Both end with the same tour. Base is for comparing."));
  buildRoadmap(form);
  refine_ = new QCheckBox(tr("Turn headings and try other orders around the tour"));
  refine_->setObjectName(QStringLiteral("refine"));
  addField(form, tr("Re&finement"), refine_,
           tr("Makes the tour cheaper, most in steep country; takes a fraction of a second for twenty targets. Without it the tour is that of the "
              "source paper."));
  seed_ = new QSpinBox;
  seed_->setObjectName(QStringLiteral("seed"));
  seed_->setRange(0, kLargestSeed);
  addField(form, tr("&Seed"), seed_, tr("The same seed gives the same plan. Try another one if a plan looks odd."));
}

void MissionValues::buildRoadmap(QFormLayout* form) {
  hasSamples_ = new QCheckBox(tr("Random samples (RRT*) instead of a lattice"));
  hasSamples_->setObjectName(QStringLiteral("hasSamples"));
  samples_ = new QSpinBox;
  samples_->setObjectName(QStringLiteral("samples"));
  samples_->setAccessibleName(tr("Number of random samples"));
  samples_->setRange(1, 10'000'000);
  samples_->setSingleStep(1000);
  samples_->setGroupSeparatorShown(true);
  connect(hasSamples_, &QCheckBox::toggled, samples_, &QWidget::setEnabled);
  auto* both = new QWidget;
  auto* column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(hasSamples_);
  column->addWidget(samples_);
  addField(form, tr("&Roadmap"), both,
           tr("The lattice is faster and finds lower safe altitudes. Random samples are the method of the source paper, for comparing; more of them "
              "find lower altitudes and take longer."),
           hasSamples_);
}

void MissionValues::fitToUnits() {
  const auto fit = [this](QDoubleSpinBox* box, double least, double most, const QString& datum) {
    box->setDecimals(0);
    box->setRange(std::ceil(units_.heightFromSi(least)), std::floor(units_.heightFromSi(most)));
    box->setSingleStep(units_.system() == style::UnitSystem::Aviation ? 50.0 : 10.0);
    box->setSuffix(QLatin1Char(' ') + units_.heightUnit() + datum);
    box->setGroupSeparatorShown(true);
  };
  fit(clearance_, 0.0, kHighestClearance, {});
  fit(arrival_, 0.0, kHighestArrival, {});
  fit(reactionLoss_, mission::kReactionLoss.least, mission::kReactionLoss.most, {});
  if (ceiling_ != nullptr) {
    fit(ceiling_, kLowestCeiling, kHighestCeiling, tr(" MSL"));
  }
}

void MissionValues::setUnits(const style::Units& units) {
  if (units == units_) {
    return;
  }
  const QScopedValueRollback guard(isFilling_, true);
  mission_ = values();
  units_ = units;
  fitToUnits();
  fill();
}

void MissionValues::show(const mission::Mission& mission) {
  mission_ = mission;
  fill();
}

void MissionValues::fill() {
  const QScopedValueRollback guard(isFilling_, true);
  clearance_->setValue(units_.heightFromSi(mission_.safety.clearance.si()));
  arrival_->setValue(units_.heightFromSi(mission_.safety.arrivalMargin.si()));
  reactionTime_->setValue(mission_.safety.reactionTime.si());
  reactionLoss_->setValue(units_.heightFromSi(mission_.safety.reactionLoss.si()));
  dragFactor_->setValue(mission_.safety.dragFactor);
  if (ceiling_ != nullptr) {
    hasCeiling_->setChecked(mission_.ceiling.has_value());
    ceiling_->setEnabled(mission_.ceiling.has_value());
    const double ceiling = mission_.ceiling            ? mission_.ceiling->metres()
                           : mission_.aircraft.ceiling ? mission_.aircraft.ceiling->metres()
                                                       : kUsualCeiling;
    ceiling_->setValue(units_.heightFromSi(ceiling));
  }
  choose(lowTargets_, static_cast<int>(mission_.planner.lowTargets));
  headings_->setValue(mission_.planner.headings);
  step_->setValue(mission_.planner.step.si());
  beta_->setValue(mission_.planner.beta);
  choose(method_, static_cast<int>(mission_.planner.method));
  const bool isRandom = mission_.planner.roadmap == mission::RoadmapKind::RrtStar;
  hasSamples_->setChecked(isRandom);
  samples_->setEnabled(isRandom);
  refine_->setChecked(mission_.planner.refine == mission::Refine::Full);
  samples_->setValue(mission_.planner.roadmapSamples.value_or(kUsualSamples));
  seed_->setValue(static_cast<int>(std::min<std::uint64_t>(mission_.planner.seed, kLargestSeed)));
}

void MissionValues::restoreSafety() {
  mission_ = values();
  mission_.safety = document::usualSafety();
  mission_.ceiling.reset();
  mission_.planner.lowTargets = mission::PlannerSettings{}.lowTargets;  // stands on that page
  fill();
  tell();
}

void MissionValues::restorePlanner() {
  mission_ = values();
  const mission::LowTargets lowTargets = mission_.planner.lowTargets;
  mission_.planner = {};
  mission_.planner.lowTargets = lowTargets;
  fill();
  tell();
}

void MissionValues::takeSafety(mission::Mission& m) const {
  const auto take = [this](Length& value, const QDoubleSpinBox* box) {
    if (!isUntouched(units_.heightFromSi(value.si()), box)) {
      value = Length::fromSi(units_.heightToSi(box->value()));
    }
  };
  take(m.safety.clearance, clearance_);
  take(m.safety.arrivalMargin, arrival_);
  take(m.safety.reactionLoss, reactionLoss_);
  if (!isUntouched(m.safety.reactionTime.si(), reactionTime_)) {
    m.safety.reactionTime = Duration::fromSi(reactionTime_->value());
  }
  if (!isUntouched(m.safety.dragFactor, dragFactor_)) {
    m.safety.dragFactor = dragFactor_->value();
  }
  m.planner.lowTargets = static_cast<mission::LowTargets>(lowTargets_->currentData().toInt());
  if (ceiling_ == nullptr) {
    return;
  }
  if (!hasCeiling_->isChecked()) {
    m.ceiling.reset();
  } else if (!m.ceiling || !isUntouched(units_.heightFromSi(m.ceiling->metres()), ceiling_)) {
    m.ceiling = geo::HeightMsl::fromMetres(units_.heightToSi(ceiling_->value()));
  }
}

void MissionValues::takePlanner(mission::Mission& m) const {
  m.planner.headings = headings_->value();
  if (!isUntouched(m.planner.step.si(), step_)) {
    m.planner.step = Length::fromSi(step_->value());
  }
  if (!isUntouched(m.planner.beta, beta_)) {
    m.planner.beta = beta_->value();
  }
  m.planner.method = static_cast<mission::Method>(method_->currentData().toInt());
  m.planner.roadmap = hasSamples_->isChecked() ? mission::RoadmapKind::RrtStar : mission::RoadmapKind::Lattice;
  if (hasSamples_->isChecked()) {
    m.planner.roadmapSamples = samples_->value();
    m.planner.roadmapTime.reset();
  }
  m.planner.refine = refine_->isChecked() ? mission::Refine::Full : mission::Refine::None;
  if (m.planner.seed <= static_cast<std::uint64_t>(kLargestSeed)) {
    m.planner.seed = static_cast<std::uint64_t>(seed_->value());
  }
}

mission::Mission MissionValues::values() const {
  mission::Mission m = mission_;
  takeSafety(m);
  takePlanner(m);
  return m;
}

}  // namespace vp::dialogs
