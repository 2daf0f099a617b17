#include "ui/panels/site_panel.h"

#include "ui/panels/site_model.h"
#include "ui/panels/site_rules.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/plot_text.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace vp::panels {
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
  connect(model_, &SiteModel::oneWayRequested, this, &SitePanel::oneWayRequested);
  connect(model_, &SiteModel::noteEdited, this, &SitePanel::noteEdited);
  connect(rules_, &SiteRules::filterChanged, this, [this](const mission::SiteFilter& filter) {
    filter_ = filter;
    emit filterChanged(filter);
  });
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
  fitColumns(*table_, {QStringLiteral("MMMM 88L MMM"),
                       QStringLiteral("MMMMMMMMMM"),
                       QStringLiteral("888° T"),
                       QStringLiteral("10 000 ft"),
                       QStringLiteral("100 ft"),
                       tr("unknown surface"),
                       tr("lit"),
                       QStringLiteral("10 000 ft MSL"),
                       QStringLiteral("888.8 NM"),
                       {},
                       QStringLiteral("MMMMMMMMMMMMMM")});
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  auto* column = new QVBoxLayout(this);
  column->addLayout(top);
  column->addWidget(table_, 1);
  rules_ = new SiteRules(this);
  column->addWidget(rules_);
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

void SitePanel::setSituation(const document::Situation& situation) {
  const bool changed = situation.sites != situation_.sites;
  if (situation.targets != situation_.targets) {
    model_->setTargets(situation.targets);
  }
  situation_ = situation;
  if (changed) {
    model_->setSites(situation_.sites);
    showCount();
  }
}

void SitePanel::setFilter(const mission::SiteFilter& filter) {
  filter_ = filter;
  model_->setFilter(filter_);
  rules_->setFilter(filter_);
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
  rules_->setUnits(state_.units());
}

}  // namespace vp::panels
