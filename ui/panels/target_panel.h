#pragma once

#include "ui/document/situation.h"
#include "ui/document/view_state.h"

#include <QWidget>

class QLabel;
class QTableView;
class QToolButton;

namespace vp::panels {

class TargetModel;

/** The targets of the mission: edited in place (F2 or double click), shown on the map with Enter, reordered with
 *  Ctrl+Up/Down, removed with Del. Changes
 *  nothing itself; whoever owns the document answers the signals. */
class TargetPanel : public QWidget {
  Q_OBJECT

public:
  explicit TargetPanel(document::ViewState& state, QWidget* parent = nullptr);

  void setSituation(const document::Situation& situation);

  [[nodiscard]] TargetModel& model() { return *model_; }
  [[nodiscard]] QTableView& table() { return *table_; }

signals:
  void targetEdited(int index, const vp::mission::Target& target);
  void removeRequested(int index);
  void moveRequested(int from, int to);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void buildLayout();
  void followSelection();
  void removeCurrent();
  void showCurrent();
  void moveCurrent(int by);
  void updateButtons();
  void restyle();

  document::ViewState& state_;
  document::Situation situation_;
  TargetModel* model_ = nullptr;
  QTableView* table_ = nullptr;
  QLabel* hint_ = nullptr;
  QToolButton* up_ = nullptr;
  QToolButton* down_ = nullptr;
  QToolButton* remove_ = nullptr;
  bool following_ = false;
};

}  // namespace vp::panels
