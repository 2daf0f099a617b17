#include "ui/panels/decision_table.h"

#include "ui/panels/decision_model.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/plot_text.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QTableView>
#include <QVBoxLayout>

namespace vp::panels {

DecisionTable::DecisionTable(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setAccessibleName(tr("Decision points"));
  model_ = new DecisionModel(this);
  filter_ = new QLineEdit(this);
  filter_->setPlaceholderText(tr("Filter by target, runway or number"));
  filter_->setAccessibleName(tr("Filter of decision points"));
  filter_->setClearButtonEnabled(true);
  count_ = new QLabel(this);
  count_->setFont(profile::tabularFont(count_->font()));
  table_ = new QTableView(this);
  table_->setModel(model_);
  setUpTable(*table_, tr("Decision points"));
  table_->setSortingEnabled(true);
  table_->sortByColumn(DecisionModel::Number, Qt::AscendingOrder);
  const QString altitude = QStringLiteral("10 000 ft MSL");
  fitColumns(*table_, {QStringLiteral("88888"), QStringLiteral("888.8 NM"), QStringLiteral("MMMMMM"), altitude, altitude, altitude,
                       QStringLiteral("+10 000 ft"), QStringLiteral("MMMM 88L"), QStringLiteral("88.8 NM"), QStringLiteral("88:88 min")});
  auto* top = new QHBoxLayout;
  top->addWidget(filter_, 1);
  top->addWidget(count_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(top);
  column->addWidget(table_, 1);
  setFocusProxy(table_);

  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    model_->setFilter(text);
    showCount();
    followCursor();
  });
  connect(table_, &QTableView::activated, this, &DecisionTable::activate);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &DecisionTable::pinCurrent);
  connect(&state_, &document::ViewState::cursorChanged, this, &DecisionTable::followCursor);
  connect(&state_, &document::ViewState::unitsChanged, this, &DecisionTable::restyle);
  connect(&state_, &document::ViewState::themeChanged, this, &DecisionTable::restyle);
  restyle();
  showCount();
}

void DecisionTable::setSituation(const document::Situation& situation) {
  const bool changed = situation.plan != situation_.plan;
  situation_ = situation;
  if (changed) {
    const QScopedValueRollback guard(following_, true);
    model_->setPlan(situation_.plan);
    showCount();
    followCursor();
  }
}

void DecisionTable::showCount() {
  const int all = situation_.plan == nullptr ? 0 : static_cast<int>(situation_.plan->plan().tour.size());
  count_->setText(all == 0                    ? tr("No plan yet")
                  : model_->rowCount() == all ? tr("%n points", nullptr, all).replace(QStringLiteral("%n"), QString::number(all))
                                              : tr("%1 of %2 points").arg(model_->rowCount()).arg(all));
}

void DecisionTable::followCursor() {
  const std::optional<double> position = state_.position();
  if (situation_.plan == nullptr || !position) {
    return;
  }
  const int row = model_->rowOf(situation_.plan->at(*position).point);
  const QScopedValueRollback guard(following_, true);
  if (row < 0) {
    table_->clearSelection();
  } else if (row != table_->currentIndex().row() || !table_->selectionModel()->isRowSelected(row)) {
    const QModelIndex index = model_->index(row, std::max(0, table_->currentIndex().column()));
    table_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    table_->scrollTo(index);
  }
}

void DecisionTable::pinCurrent(const QModelIndex& current) {
  if (!following_ && current.isValid() && situation_.plan != nullptr) {
    state_.setPinned(situation_.plan->distanceOf(static_cast<std::size_t>(model_->pointOf(current.row()))));
  }
}

void DecisionTable::activate(const QModelIndex& index) {
  if (index.isValid() && situation_.plan != nullptr) {
    jumpTo(state_, *situation_.plan, situation_.plan->distanceOf(static_cast<std::size_t>(model_->pointOf(index.row()))));
  }
}

void DecisionTable::restyle() {
  model_->setStyle(state_.units(), state_.theme());
}

}  // namespace vp::panels
