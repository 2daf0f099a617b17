#pragma once

#include "ui/document/plan_view.h"
#include "ui/document/view_state.h"

#include <QString>
#include <QStringList>

class QLabel;
class QTableView;
class QWidget;

namespace vp::panels {

/// Role of the plain number (or text) that a column sorts by.
inline constexpr int kSortRole = 0x0100;  // Qt::UserRole

/** The look of all tables: whole rows selected, rows of one line, tabular figures, text that does not fit elided (the model
 *  gives it as tool tip), accessible name set. Rows have a fixed height, so thousands of them cost nothing. */
void setUpTable(QTableView& table, const QString& accessibleName);

/** Column widths from texts as wide as the column will meet, and from its header. */
void fitColumns(QTableView& table, const QStringList& widest);

/** Column widths with which no number is cut: columns are as wide as their header and texts, and the first, of names, takes what is left so
 *  that the right edge of the table lies between two columns; names that need more are elided. The last column takes the rest. */
void fitWholeColumns(QTableView& table);

/** A label for sentences: wraps, can be selected, read by screen readers. */
QLabel* sentenceLabel(QWidget* parent);

/** Pins the point of the tour at a place, if the tour passes there, and brings the place into view. */
void jumpTo(document::ViewState& state, const document::PlanView* plan, geo::Point place);
/** Pins a point of the tour and brings it into view. */
void jumpTo(document::ViewState& state, const document::PlanView& plan, double distance);

}  // namespace vp::panels
