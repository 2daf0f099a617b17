#include "ui/dialogs/preferences_dialog.h"

#include "ui/dialogs/field_tools.h"
#include "ui/dialogs/mission_values.h"
#include "ui/style/language.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTabWidget>
#include <QVBoxLayout>

namespace vp::dialogs {
namespace {

constexpr int kFollow = -1;  // in the list of appearances: as the desktop
constexpr QSize kSize{660, 640};
enum Page { General, Safety, Planner, Scene };

mission::Mission missionOf(const document::MissionDefaults& defaults) {
  mission::Mission mission;
  mission.safety = defaults.safety;
  mission.planner = defaults.planner;
  return mission;
}

}  // namespace

PreferencesDialog::PreferencesDialog(const Preferences& preferences, const QString& openMission, QWidget* parent)
    : QDialog(parent), preferences_(preferences) {
  setWindowTitle(tr("Preferences"));
  setObjectName(QStringLiteral("preferencesDialog"));
  values_ = new MissionValues(MissionValues::Scope::NewMissions, style::Units(preferences.units), this);
  tabs_ = new QTabWidget;
  tabs_->setObjectName(QStringLiteral("preferencePages"));
  tabs_->insertTab(General, generalPage(), tr("&General"));
  tabs_->insertTab(Safety, newMissionPage(values_->safetyPage(), openMission), tr("New missions: &safety"));
  tabs_->insertTab(Planner, newMissionPage(values_->plannerPage(), openMission), tr("New missions: &planner"));
  tabs_->insertTab(Scene, scenePage(), tr("&3D view"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(tabs_, 1);
  auto* note = new QLabel(tr("Changes apply at once and are remembered."));
  note->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* restore = buttons->addButton(tr("&Defaults of this page"), QDialogButtonBox::ResetRole);
  restore->setObjectName(QStringLiteral("restorePage"));
  restore->setAutoDefault(false);
  connect(restore, &QPushButton::clicked, this, &PreferencesDialog::restorePage);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(note);
  column->addWidget(buttons);
  fill();
  connect(values_, &MissionValues::edited, this, &PreferencesDialog::take);
  for (QComboBox* box : {units_, theme_, language_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::take);
  }
  for (QCheckBox* box : {curtain_, allGlides_, runways_, excludedRunways_, labels_}) {
    connect(box, &QCheckBox::toggled, this, &PreferencesDialog::take);
  }
  connect(exaggeration_, &QDoubleSpinBox::valueChanged, this, &PreferencesDialog::take);
  resize(kSize);
}

QWidget* PreferencesDialog::generalPage() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  units_ = new QComboBox;
  units_->setObjectName(QStringLiteral("units"));
  units_->addItem(tr("Aviation: ft, NM, kt, ft/min"), static_cast<int>(style::UnitSystem::Aviation));
  units_->addItem(tr("Metric: m, km, km/h, m/s"), static_cast<int>(style::UnitSystem::Metric));
  addField(
      form, tr("&Units"), units_,
      tr("How heights, distances and speeds are shown and typed everywhere. Files keep their own units; heights always say whether they are above "
         "mean sea level (MSL) or above ground (AGL)."));
  theme_ = new QComboBox;
  theme_->setObjectName(QStringLiteral("theme"));
  theme_->addItem(tr("As the desktop"), kFollow);
  theme_->addItem(tr("Light"), static_cast<int>(style::Theme::Light));
  theme_->addItem(tr("Dark"), static_cast<int>(style::Theme::Dark));
  addField(form, tr("&Appearance"), theme_,
           tr("Light for daylight and print, dark for dim rooms and night briefings. “As the desktop” takes what the desktop had when Volplane was "
              "started."));
  language_ = new QComboBox;
  language_->setObjectName(QStringLiteral("language"));
  language_->addItem(tr("That of the system"), QString());
  for (const QString& code : style::languages()) {
    language_->addItem(style::languageName(code), code);
  }
  addField(
      form, tr("&Language"), language_,
      tr("Of the window and of briefings written from it, from the next start on. Messages about files and findings of the checker are in English."));
  return scrolled(page);
}

QWidget* PreferencesDialog::newMissionPage(QWidget* values, const QString& openMission) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  auto* row = new QHBoxLayout;
  auto* scope = new QLabel(tr("New missions start with these values. The open mission, “%1”, keeps its own.").arg(openMission));
  scope->setWordWrap(true);
  auto* lead = new QPushButton(tr("&Open mission’s settings…"));
  lead->setObjectName(QStringLiteral("openMissionSettings"));
  lead->setAutoDefault(false);
  connect(lead, &QPushButton::clicked, this, &PreferencesDialog::missionSettingsRequested);
  row->addWidget(scope, 1);
  row->addWidget(lead, 0, Qt::AlignTop);
  column->addLayout(row);
  column->addWidget(scrolled(values), 1);
  return page;
}

QWidget* PreferencesDialog::scenePage() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  exaggeration_ = new QDoubleSpinBox;
  exaggeration_->setObjectName(QStringLiteral("exaggeration"));
  exaggeration_->setRange(1.0, 5.0);
  exaggeration_->setDecimals(1);
  exaggeration_->setSingleStep(0.5);
  exaggeration_->setPrefix(tr("× "));
  addField(
      form, tr("&Heights drawn"), exaggeration_,
      tr("1 is true to scale. More makes gentle relief visible; the picture then says so, because slopes and glides look steeper than they are."));
  const auto flag = [&](QCheckBox*& box, const char* name, const QString& label, const QString& text, const QString& explanation) {
    box = new QCheckBox(text);
    box->setObjectName(QLatin1String(name));
    addField(form, label, box, explanation);
  };
  flag(curtain_, "curtain", tr("&Tour"), tr("Curtain down to the ground"),
       tr("Shows where the tour is over the terrain. Take it away if it hides what is behind."));
  flag(allGlides_, "allGlides", tr("G&lides"), tr("Of every decision point"),
       tr("All landing glides at once instead of the one from the point that is looked at. Slower on plans with thousands of points."));
  flag(runways_, "runways", tr("&Runways"), tr("Runways that may be used"), tr("Drawn to scale on the terrain."));
  flag(excludedRunways_, "excludedRunways", tr("E&xcluded"), tr("Runways that the filter leaves out"),
       tr("Drawn weaker, to see what is being given up."));
  flag(labels_, "labels", tr("&Names"), tr("Of targets and runways"), tr("Take them away for pictures."));
  return scrolled(page);
}

void PreferencesDialog::fill() {
  const QScopedValueRollback guard(isFilling_, true);
  choose(units_, static_cast<int>(preferences_.units));
  choose(theme_, preferences_.theme ? static_cast<int>(*preferences_.theme) : kFollow);
  language_->setCurrentIndex(language_->findData(preferences_.language));
  values_->setUnits(style::Units(preferences_.units));
  values_->show(missionOf(preferences_.newMissions));
  exaggeration_->setValue(preferences_.scene.verticalExaggeration);
  curtain_->setChecked(preferences_.scene.curtain);
  allGlides_->setChecked(preferences_.scene.allGlides);
  runways_->setChecked(preferences_.scene.runways);
  excludedRunways_->setChecked(preferences_.scene.excludedRunways);
  labels_->setChecked(preferences_.scene.labels);
}

void PreferencesDialog::take() {
  if (isFilling_) {
    return;
  }
  Preferences now = preferences_;
  now.units = static_cast<style::UnitSystem>(units_->currentData().toInt());
  const int theme = theme_->currentData().toInt();
  now.theme = theme == kFollow ? std::nullopt : std::optional(static_cast<style::Theme>(theme));
  now.language = language_->currentData().toString();
  const mission::Mission values = values_->values();
  now.newMissions = {values.safety, values.planner};
  if (!isUntouched(now.scene.verticalExaggeration, exaggeration_)) {
    now.scene.verticalExaggeration = exaggeration_->value();
  }
  now.scene.curtain = curtain_->isChecked();
  now.scene.allGlides = allGlides_->isChecked();
  now.scene.runways = runways_->isChecked();
  now.scene.excludedRunways = excludedRunways_->isChecked();
  now.scene.labels = labels_->isChecked();
  if (now == preferences_) {
    return;
  }
  preferences_ = now;
  values_->setUnits(style::Units(now.units));
  emit changed(preferences_);
}

void PreferencesDialog::restorePage() {
  const Preferences defaults;
  switch (tabs_->currentIndex()) {
    case Safety:
      values_->restoreSafety();
      return;
    case Planner:
      values_->restorePlanner();
      return;
    case General: {
      preferences_.units = defaults.units;
      preferences_.theme = defaults.theme;
      preferences_.language = defaults.language;
      break;
    }
    default:
      preferences_.scene = defaults.scene;
      break;
  }
  fill();
  emit changed(preferences_);
}

}  // namespace vp::dialogs
