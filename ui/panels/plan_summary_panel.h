#pragma once

#include "core/safety/checker.h"
#include "ui/document/situation.h"
#include "ui/document/view_state.h"

#include <QWidget>

class QFormLayout;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QScrollArea;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace vp::panels {

/** What the plan is worth: verified or not and what exactly is guaranteed, cost, length, time, how far from the best
 *  possible, the least margins and where they are, warnings, and why a plan was refused. Margins and findings jump to
 *  their places. */
class PlanSummaryPanel : public QWidget {
  Q_OBJECT

public:
  enum class State { NoPlan, Verified, Unverified, OutOfDate };

  explicit PlanSummaryPanel(document::ViewState& state, QWidget* parent = nullptr);

  void setSituation(const document::Situation& situation);
  /** What the checker said last; its violations are listed if it refused. An empty report clears the list. */
  void setReport(const safety::SafetyReport& report);

  [[nodiscard]] State planState() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void refresh();
  void fitPage();
  void showState();
  void showFigures();
  void showMargins();
  void showMessages();
  void jumpToMargin(QTreeWidgetItem* item);
  void jumpToFinding(QListWidgetItem* item);
  QLabel* addFigure(QFormLayout& form, const QString& name);
  QVBoxLayout* scrolledColumn();

  document::ViewState& state_;
  document::Situation situation_;
  safety::SafetyReport report_;
  QScrollArea* area_ = nullptr;
  QLabel* icon_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* statement_ = nullptr;
  QWidget* figures_ = nullptr;
  QLabel* length_ = nullptr;
  QLabel* time_ = nullptr;
  QLabel* cost_ = nullptr;
  QLabel* gap_ = nullptr;
  QLabel* altitudes_ = nullptr;
  QLabel* checked_ = nullptr;
  QLabel* marginsTitle_ = nullptr;
  QTreeWidget* margins_ = nullptr;
  QLabel* messagesTitle_ = nullptr;
  QListWidget* messages_ = nullptr;
};

/** What a kind of margin (a rule of core/safety) means to a pilot; the rule itself if it has no words. */
QString marginName(const std::string& kind);

}  // namespace vp::panels
