#pragma once

#include "ui/document/situation.h"
#include "ui/document/view_state.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QTableView;

namespace vp::panels {

class DecisionModel;

/** The table of all decision points: sorted by any column, filtered by target or runway. Selecting a row pins its point,
 *  Enter or a double click brings it into view; the selection follows the cursor of the other views. */
class DecisionTable : public QWidget {
  Q_OBJECT

public:
  explicit DecisionTable(document::ViewState& state, QWidget* parent = nullptr);

  void setSituation(const document::Situation& situation);

  [[nodiscard]] DecisionModel& model() { return *model_; }
  [[nodiscard]] QTableView& table() { return *table_; }

private:
  void followCursor();
  void activate(const QModelIndex& index);
  void pinCurrent(const QModelIndex& current);
  void showCount();
  void restyle();

  document::ViewState& state_;
  document::Situation situation_;
  DecisionModel* model_ = nullptr;
  QLineEdit* filter_ = nullptr;
  QLabel* count_ = nullptr;
  QTableView* table_ = nullptr;
  bool following_ = false;  ///< the selection moves because the cursor did
};

}  // namespace vp::panels
