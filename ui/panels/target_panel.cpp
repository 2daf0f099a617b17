#include "ui/panels/target_panel.h"

#include "ui/panels/table_tools.h"
#include "ui/panels/target_delegate.h"
#include "ui/panels/target_model.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vp::panels {

TargetPanel::TargetPanel(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setAccessibleName(tr("Targets"));
  model_ = new TargetModel(this);
  buildLayout();
  connect(model_, &TargetModel::targetEdited, this, &TargetPanel::targetEdited);
  connect(model_, &TargetModel::editRefused, this, [this](const QString& reason) {
    hint_->setText(reason);
    hint_->show();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (!following_) {
      state_.selectTarget(current.isValid() ? current.row() : -1);
    }
    updateButtons();
  });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (!model_->flags(index).testFlag(Qt::ItemIsEditable)) {
      showCurrent();
    }
  });
  connect(&state_, &document::ViewState::selectionChanged, this, &TargetPanel::followSelection);
  connect(&state_, &document::ViewState::unitsChanged, this, &TargetPanel::restyle);
  connect(&state_, &document::ViewState::themeChanged, this, &TargetPanel::restyle);
  restyle();
  setSituation({});
}

void TargetPanel::buildLayout() {
  table_ = new QTableView(this);
  table_->setModel(model_);
  setUpTable(*table_, tr("Targets"));
  table_->verticalHeader()->show();
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
  table_->setItemDelegate(new TargetDelegate(table_));
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerItem);
  table_->installEventFilter(this);
  table_->viewport()->installEventFilter(this);
  hint_ = sentenceLabel(this);
  auto* row = new QHBoxLayout;
  const auto button = [&](const QString& text, const QString& tip, const char* name) {
    auto* made = new QToolButton(this);
    made->setText(text);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setObjectName(QLatin1String(name));
    made->setFocusPolicy(Qt::TabFocus);
    row->addWidget(made);
    return made;
  };
  up_ = button(tr("Up"), tr("Move target up (Ctrl+Up)"), "moveUp");
  down_ = button(tr("Down"), tr("Move target down (Ctrl+Down)"), "moveDown");
  remove_ = button(tr("Remove"), tr("Remove target (Del)"), "remove");
  row->addStretch(1);
  connect(up_, &QToolButton::clicked, this, [this] { moveCurrent(-1); });
  connect(down_, &QToolButton::clicked, this, [this] { moveCurrent(1); });
  connect(remove_, &QToolButton::clicked, this, &TargetPanel::removeCurrent);
  auto* column = new QVBoxLayout(this);
  column->addWidget(table_, 1);
  column->addWidget(hint_);
  column->addLayout(row);
  setFocusProxy(table_);
}

void TargetPanel::setSituation(const document::Situation& situation) {
  const bool changed = situation.targets != situation_.targets || situation.terrain != situation_.terrain;
  situation_ = situation;
  if (changed) {
    const QScopedValueRollback guard(following_, true);
    model_->setTargets(situation_.targets, situation_.terrain);
    followSelection();
    fitWholeColumns(*table_);
  }
  if (model_->rowCount() == 0) {
    hint_->setText(tr("No targets yet. Click on the map with the target tool to add one."));
  } else {
    const auto broken = std::count_if(situation_.targets->begin(), situation_.targets->end(),
                                      [](const document::ShownTarget& shown) { return !shown.problem.empty(); });
    hint_->setText(broken == 0   ? QString()
                   : broken == 1 ? tr("One target cannot be planned; its row says why.")
                                 : tr("%1 targets cannot be planned; their rows say why.").arg(broken));
  }
  hint_->setVisible(!hint_->text().isEmpty());
  updateButtons();
}

void TargetPanel::followSelection() {
  const QScopedValueRollback guard(following_, true);
  const int row = state_.selectedTarget();
  if (model_->target(row) == nullptr) {
    table_->clearSelection();
    table_->setCurrentIndex({});
  } else if (table_->currentIndex().row() != row) {
    table_->setCurrentIndex(model_->index(row, 0));
    table_->scrollTo(model_->index(row, 0));
  }
  updateButtons();
}

void TargetPanel::updateButtons() {
  const int row = table_->currentIndex().isValid() ? table_->currentIndex().row() : -1;
  up_->setEnabled(row > 0);
  down_->setEnabled(row >= 0 && row + 1 < model_->rowCount());
  remove_->setEnabled(row >= 0);
}

void TargetPanel::removeCurrent() {
  if (table_->currentIndex().isValid()) {
    emit removeRequested(table_->currentIndex().row());
  }
}

void TargetPanel::showCurrent() {
  if (const document::ShownTarget* shown = model_->target(table_->currentIndex().row())) {
    state_.showPlace(shown->point);
  }
}

void TargetPanel::moveCurrent(int by) {
  const int from = table_->currentIndex().isValid() ? table_->currentIndex().row() : -1;
  const int to = from + by;
  if (from >= 0 && to >= 0 && to < model_->rowCount()) {
    emit moveRequested(from, to);
    state_.selectTarget(to);
  }
}

bool TargetPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && (event->type() == QEvent::Resize || event->type() == QEvent::Show)) {
    fitWholeColumns(*table_);  // as it is shown the row numbers take their room without another resize
  }
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool control = key->modifiers().testFlag(Qt::ControlModifier);
    if (control && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down)) {
      moveCurrent(key->key() == Qt::Key_Up ? -1 : 1);
      return true;
    }
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
      showCurrent();
      return true;
    }
    if (key->key() == Qt::Key_Delete) {
      removeCurrent();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void TargetPanel::restyle() {
  model_->setStyle(state_.units(), state_.theme());
  fitWholeColumns(*table_);
}

}  // namespace vp::panels
