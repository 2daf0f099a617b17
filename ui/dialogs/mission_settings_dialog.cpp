#include "ui/dialogs/mission_settings_dialog.h"

#include "ui/dialogs/field_tools.h"
#include "ui/dialogs/mission_values.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace vp::dialogs {
namespace {
constexpr QSize kSize{640, 620};
}

MissionSettingsDialog::MissionSettingsDialog(const mission::Mission& mission, const style::Units& units, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Mission settings"));
  auto* column = new QVBoxLayout(this);
  auto* scope = new QLabel(tr("These values belong to the open mission and are saved with it."));
  scope->setWordWrap(true);
  column->addWidget(scope);
  auto* form = new QFormLayout;
  name_ = new QLineEdit(QString::fromStdString(mission.name));
  name_->setObjectName(QStringLiteral("missionName"));
  form->addRow(tr("&Name"), name_);
  column->addLayout(form);
  values_ = new MissionValues(MissionValues::Scope::OpenMission, units, this);
  values_->show(mission);
  auto* tabs = new QTabWidget;
  tabs->addTab(scrolled(values_->safetyPage()), tr("Safety"));
  tabs->addTab(scrolled(values_->plannerPage()), tr("Planner"));
  column->addWidget(tabs, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
    values_->restoreSafety();
    values_->restorePlanner();
  });
  column->addWidget(buttons);
  resize(kSize);
}

mission::Mission MissionSettingsDialog::result() const {
  mission::Mission m = values_->values();
  m.name = name_->text().trimmed().toStdString();
  return m;
}

}  // namespace vp::dialogs
