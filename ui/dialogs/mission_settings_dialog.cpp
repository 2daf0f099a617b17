#include "ui/dialogs/mission_settings_dialog.h"

#include "ui/dialogs/condition_values.h"
#include "ui/dialogs/field_tools.h"
#include "ui/dialogs/mission_values.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vp::dialogs {
namespace {
constexpr QSize kSize{640, 620};
}

QComboBox* MissionSettingsDialog::runwayChoice(const QStringList& runways, const std::string& chosen, const char* objectName,
                                               const QString& accessibleName) {
  auto* box = new QComboBox(this);
  box->setObjectName(QLatin1String(objectName));
  box->setAccessibleName(accessibleName);
  box->addItems(runways);
  const QString id = QString::fromStdString(chosen);
  if (!id.isEmpty() && !runways.contains(id)) {
    box->addItem(id);  // not usable at present; planning will say so
  }
  box->setCurrentIndex(std::max(0, box->findText(id)));
  return box;
}

MissionSettingsDialog::MissionSettingsDialog(const mission::Mission& mission, const QStringList& runways, const style::Units& units, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Mission settings"));
  auto* column = new QVBoxLayout(this);
  auto* scope = new QLabel(tr("These values belong to the open mission and are saved with it."));
  scope->setWordWrap(true);
  column->addWidget(scope);
  auto* form = new QFormLayout;
  name_ = new QLineEdit(QString::fromStdString(mission.name));
  name_->setObjectName(QStringLiteral("missionName"));
  form->addRow(tr("&Name"), name_);
  const mission::HomeBase home = mission.home.value_or(mission::HomeBase{});
  takeoff_ = runwayChoice(QStringList{tr("nowhere: the tour alone")} + runways, home.takeoff, "homeTakeoff", tr("Runway to start at"));
  landing_ = runwayChoice(QStringList{tr("where it starts")} + runways, home.landing == home.takeoff ? std::string() : home.landing, "homeLanding",
                          tr("Runway to end at"));
  landing_->setEnabled(takeoff_->currentIndex() > 0);
  connect(takeoff_, &QComboBox::currentIndexChanged, this, [this](int index) { landing_->setEnabled(index > 0); });
  auto* row = new QHBoxLayout;
  row->addWidget(takeoff_, 1);
  row->addWidget(new QLabel(tr("end")));
  row->addWidget(landing_, 1);
  auto* start = new QLabel(tr("&Start"));
  start->setBuddy(takeoff_);
  form->addRow(start, row);
  column->addLayout(form);
  values_ = new MissionValues(MissionValues::Scope::OpenMission, units, this);
  values_->show(mission);
  conditions_ = new ConditionValues(units, this);
  conditions_->show(mission);
  auto* tabs = new QTabWidget;
  tabs->setObjectName(QStringLiteral("missionPages"));
  tabs->addTab(scrolled(values_->safetyPage()), tr("Safety"));
  tabs->addTab(scrolled(conditions_->approachPage()), tr("Approach"));
  tabs->addTab(scrolled(conditions_->airPage()), tr("Air and engine"));
  tabs->addTab(scrolled(values_->plannerPage()), tr("Planner"));
  column->addWidget(tabs, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
    values_->restoreSafety();
    values_->restorePlanner();
    conditions_->restore();
  });
  column->addWidget(buttons);
  resize(kSize);
}

mission::Mission MissionSettingsDialog::result() const {
  mission::Mission m = values_->values();
  conditions_->take(m);
  m.name = name_->text().trimmed().toStdString();
  m.home.reset();
  if (takeoff_->currentIndex() > 0) {
    const QString takeoff = takeoff_->currentText();
    m.home = mission::HomeBase{takeoff.toStdString(), (landing_->currentIndex() > 0 ? landing_->currentText() : takeoff).toStdString()};
  }
  return m;
}

}  // namespace vp::dialogs
