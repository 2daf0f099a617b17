#include "ui/panels/site_panel.h"

#include "ui/panels/site_model.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/plot_text.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vp::panels {
namespace {

constexpr double kLongestAsked = 5000.0;  // m, no airport is excluded for less

}  // namespace

SitePanel::SitePanel(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setAccessibleName(tr("Runways"));
  model_ = new SiteModel(this);
  sorted_ = new QSortFilterProxyModel(this);
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(kSortRole);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  sorted_->setFilterKeyColumn(-1);
  buildLayout();
  connect(model_, &SiteModel::excludeRequested, this, &SitePanel::excludeRequested);
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->setFilterFixedString(text.trimmed());
    showCount();
  });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    if (const document::ShownSite* shown = model_->site(sorted_->mapToSource(index).row())) {
      state_.showPlace(shown->site.pose.point());
    }
  });
  connect(&state_, &document::ViewState::unitsChanged, this, &SitePanel::restyle);
  connect(&state_, &document::ViewState::themeChanged, this, &SitePanel::restyle);
  restyle();
  showCount();
}

void SitePanel::buildLayout() {
  search_ = new QLineEdit(this);
  search_->setPlaceholderText(tr("Find a runway or airport"));
  search_->setAccessibleName(tr("Find a runway or airport"));
  search_->setClearButtonEnabled(true);
  count_ = new QLabel(this);
  count_->setFont(profile::tabularFont(count_->font()));
  auto* top = new QHBoxLayout;
  top->addWidget(search_, 1);
  top->addWidget(count_);
  table_ = new QTableView(this);
  table_->setModel(sorted_);
  setUpTable(*table_, tr("Runways"));
  table_->setSortingEnabled(true);
  table_->sortByColumn(SiteModel::Runway, Qt::AscendingOrder);
  fitColumns(*table_, {QStringLiteral("MMMM 88L MMM"), QStringLiteral("MMMMMMMMMM"), QStringLiteral("888° T"), QStringLiteral("10 000 ft"),
                       tr("unknown surface"), QStringLiteral("10 000 ft MSL")});
  auto* column = new QVBoxLayout(this);
  column->addLayout(top);
  column->addWidget(table_, 1);
  column->addWidget(buildRules());
  notes_ = new QPlainTextEdit(this);
  notes_->setReadOnly(true);
  notes_->setAccessibleName(tr("Notes on the airfields"));
  notes_->setFrameShape(QFrame::NoFrame);
  notes_->setMaximumHeight(4 * fontMetrics().lineSpacing() + 8);
  notes_->hide();
  column->addWidget(notes_);
  setFocusProxy(table_);
}

void SitePanel::setNotes(const QStringList& notes) {
  notes_->setPlainText(notes.join(QLatin1Char('\n')));
  notes_->setVisible(!notes.isEmpty());
}

QWidget* SitePanel::buildRules() {
  auto* rules = new QWidget(this);
  auto* column = new QVBoxLayout(rules);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("&Shortest runway"), rules);
  minLength_ = new QDoubleSpinBox(rules);
  minLength_->setDecimals(0);
  minLength_->setSpecialValueText(tr("any length"));
  minLength_->setAccessibleName(tr("Shortest runway that is used"));
  minLength_->setKeyboardTracking(false);  // 9, 90, 900 must not filter three times
  label->setBuddy(minLength_);
  row->addWidget(label);
  row->addWidget(minLength_);
  row->addStretch(1);
  column->addLayout(row);
  approximate_ = new QCheckBox(tr("Use runways whose position is &estimated"), rules);
  closed_ = new QCheckBox(tr("Use &closed runways"), rules);
  water_ = new QCheckBox(tr("Use &water"), rules);
  for (QCheckBox* box : {approximate_, closed_, water_}) {
    column->addWidget(box);
    connect(box, &QCheckBox::toggled, this, &SitePanel::emitFilter);
  }
  connect(minLength_, &QDoubleSpinBox::valueChanged, this, &SitePanel::emitFilter);
  return rules;
}

void SitePanel::setSituation(const document::Situation& situation) {
  const bool changed = situation.sites != situation_.sites;
  situation_ = situation;
  if (changed) {
    model_->setSites(situation_.sites);
    showCount();
  }
}

void SitePanel::setFilter(const mission::SiteFilter& filter) {
  filter_ = filter;
  model_->setFilter(filter_);
  showRules();
}

void SitePanel::showSite(const QString& siteId) {
  for (int row = 0; row < sorted_->rowCount(); ++row) {
    const QModelIndex index = sorted_->index(row, 0);
    const document::ShownSite* shown = model_->site(sorted_->mapToSource(index).row());
    if (shown != nullptr && QString::fromStdString(shown->site.site.id) == siteId) {
      table_->setCurrentIndex(index);
      table_->scrollTo(index);
      return;
    }
  }
}

void SitePanel::showRules() {
  const QSignalBlocker quietLength(minLength_);
  const QSignalBlocker quietApproximate(approximate_);
  const QSignalBlocker quietClosed(closed_);
  const QSignalBlocker quietWater(water_);
  const style::Units& units = state_.units();
  minLength_->setRange(0.0, std::round(units.heightFromSi(kLongestAsked)));
  minLength_->setSingleStep(units.system() == style::UnitSystem::Aviation ? 100.0 : 50.0);
  minLength_->setSuffix(QLatin1Char(' ') + units.heightUnit());
  minLength_->setValue(filter_.minLength ? units.heightFromSi(filter_.minLength->si()) : 0.0);
  approximate_->setChecked(filter_.approximate);
  closed_->setChecked(filter_.closed);
  water_->setChecked(filter_.water);
}

void SitePanel::emitFilter() {
  const style::Units& units = state_.units();
  mission::SiteFilter changed = filter_;
  changed.approximate = approximate_->isChecked();
  changed.closed = closed_->isChecked();
  changed.water = water_->isChecked();
  const double shown = filter_.minLength ? std::round(units.heightFromSi(filter_.minLength->si())) : 0.0;
  if (std::round(minLength_->value()) != shown) {  // an untouched box must not round the value
    changed.minLength = minLength_->value() > 0.0 ? std::optional(Length::fromSi(units.heightToSi(minLength_->value()))) : std::nullopt;
  }
  if (!(changed == filter_)) {
    filter_ = changed;
    emit filterChanged(filter_);
  }
}

void SitePanel::showCount() {
  const int all = model_->rowCount();
  if (all == 0) {
    count_->setText(tr("No runways yet: load airfields"));
    return;
  }
  const auto used = std::count_if(situation_.sites->begin(), situation_.sites->end(), [](const document::ShownSite& shown) { return shown.usable; });
  count_->setText(sorted_->rowCount() == all ? tr("%1 of %2 used").arg(used).arg(all) : tr("%1 found").arg(sorted_->rowCount()));
}

void SitePanel::restyle() {
  model_->setStyle(state_.units(), state_.theme());
  showRules();
}

}  // namespace vp::panels
