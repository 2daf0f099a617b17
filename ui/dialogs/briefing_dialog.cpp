#include "ui/dialogs/briefing_dialog.h"

#include "ui/dialogs/field_tools.h"
#include "ui/style/language.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vp::dialogs {
namespace {

constexpr int kWidth = 480;  // px: explanations in two lines

using briefing::BriefingOptions;

QDate toQt(std::chrono::year_month_day date) {
  return {static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())), static_cast<int>(static_cast<unsigned>(date.day()))};
}

}  // namespace

BriefingDialog::BriefingDialog(const BriefingOptions& options, const QString& doubt, QWidget* parent) : QDialog(parent), options_(options) {
  setWindowTitle(tr("Briefing"));
  setObjectName(QStringLiteral("briefingDialog"));
  auto* column = new QVBoxLayout(this);
  if (!doubt.isEmpty()) {
    auto* warning = new QLabel(doubt);
    warning->setObjectName(QStringLiteral("briefingDoubt"));
    warning->setWordWrap(true);
    QFont strong = warning->font();
    strong.setBold(true);
    warning->setFont(strong);
    column->addWidget(warning);
  }
  auto* form = new QFormLayout;
  paper_ = new QComboBox;
  paper_->setObjectName(QStringLiteral("briefingPaper"));
  paper_->addItem(tr("A4"), static_cast<int>(briefing::Paper::A4));
  paper_->addItem(tr("Letter"), static_cast<int>(briefing::Paper::Letter));
  choose(paper_, static_cast<int>(options.paper));
  addField(form, tr("&Paper"), paper_, tr("Upright, with room for a clip at the sides."));
  units_ = new QComboBox;
  units_->addItem(tr("Feet, nautical miles, knots"), static_cast<int>(style::UnitSystem::Aviation));
  units_->addItem(tr("Metres, kilometres, km/h"), static_cast<int>(style::UnitSystem::Metric));
  choose(units_, static_cast<int>(options.units.system()));
  addField(form, tr("&Units"), units_, tr("Of everything but the checker's findings and warnings."));
  date_ = new QDateEdit(toQt(options.date));
  date_->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
  date_->setLocale(style::languageLocale());
  date_->setCalendarPopup(true);
  addField(form, tr("&Day of flight"), date_, tr("Stands on every page and decides the magnetic variation."));
  addPart(form, "briefingMap", tr("&Map"), &BriefingOptions::map);
  addPart(form, "briefingProfile", tr("&Altitude profile"), &BriefingOptions::profile);
  addPart(form, "briefingLegs", tr("&Legs"), &BriefingOptions::legs);
  addPart(form, "briefingEngineOut", tr("&If the engine stops: runways along the tour"), &BriefingOptions::engineOut);
  addPart(form, "briefingGlides", tr("&Glides from the worst places"), &BriefingOptions::glides);
  addPart(form, "briefingTargets", tr("&Targets"), &BriefingOptions::targets);
  addPart(form, "briefingMonochrome", tr("Pictures in g&reys"), &BriefingOptions::monochrome);
  column->addLayout(form);
  column->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Save)->setText(doubt.isEmpty() ? tr("&Save as PDF…") : tr("&Save all the same…"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  setMinimumWidth(kWidth);
}

void BriefingDialog::addPart(QFormLayout* form, const char* name, const QString& text, bool BriefingOptions::*part) {
  auto* box = new QCheckBox(text);
  box->setObjectName(QLatin1String(name));
  box->setChecked(options_.*part);
  form->addRow(parts_.empty() ? tr("Parts") : QString(), box);
  parts_.emplace_back(box, part);
}

BriefingOptions BriefingDialog::options() const {
  BriefingOptions options = options_;
  options.paper = static_cast<briefing::Paper>(paper_->currentData().toInt());
  options.units = style::Units(static_cast<style::UnitSystem>(units_->currentData().toInt()));
  const QDate day = date_->date();
  options.date =
      std::chrono::year(day.year()) / std::chrono::month(static_cast<unsigned>(day.month())) / std::chrono::day(static_cast<unsigned>(day.day()));
  for (const auto& [box, part] : parts_) {
    options.*part = box->isChecked();
  }
  return options;
}

}  // namespace vp::dialogs
