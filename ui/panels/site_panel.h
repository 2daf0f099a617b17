#pragma once

#include "core/mission/mission.h"
#include "ui/document/situation.h"
#include "ui/document/view_state.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QSortFilterProxyModel;
class QTableView;

namespace vp::panels {

class SiteModel;
class SiteRules;

/** The runways that a glide may land on: which are used, and the rules that leave others out. Changes nothing itself;
 *  whoever owns the document answers the signals. */
class SitePanel : public QWidget {
  Q_OBJECT

public:
  explicit SitePanel(document::ViewState& state, QWidget* parent = nullptr);

  void setSituation(const document::Situation& situation);
  /** The mission's rules, as edited elsewhere; emits nothing. */
  void setFilter(const mission::SiteFilter& filter);

  /** Sentences on what reading the airfields left out or derived, and why. */
  void setNotes(const QStringList& notes);

  /** Selects the runway in the table and brings it into view; nothing if the search hides it. */
  void showSite(const QString& siteId);

  [[nodiscard]] QTableView& table() { return *table_; }

signals:
  void excludeRequested(const QString& siteId, bool excluded);
  void filterChanged(const vp::mission::SiteFilter& filter);
  /// only this end of the runway may be landed on, or both again
  void oneWayRequested(const QString& siteId, bool oneWay);
  void noteEdited(const QString& siteId, const QString& text);

private:
  void buildLayout();
  void showCount();
  void restyle();

  document::ViewState& state_;
  document::Situation situation_;
  mission::SiteFilter filter_;
  SiteModel* model_ = nullptr;
  QSortFilterProxyModel* sorted_ = nullptr;
  QLineEdit* search_ = nullptr;
  QLabel* count_ = nullptr;
  QTableView* table_ = nullptr;
  QPlainTextEdit* notes_ = nullptr;
  SiteRules* rules_ = nullptr;
};

}  // namespace vp::panels
