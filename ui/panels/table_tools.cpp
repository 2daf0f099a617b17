#include "ui/panels/table_tools.h"

#include "ui/profile/plot_text.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QLabel>
#include <QProxyStyle>
#include <QStyleOption>
#include <QTableView>

#include <algorithm>

namespace vp::panels {
namespace {

/// A place is on the tour if it is this near [m]: margins between decision points lie on its curve, glides start there.
constexpr double kOnTour = 60.0;

/// Room between the edge of a cell and its text: a right-aligned number beside a left-aligned name must not touch it.
class RoomyStyle : public QProxyStyle {
public:
  using QProxyStyle::QProxyStyle;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    return metric == PM_FocusFrameHMargin || metric == PM_HeaderMargin ? kRoom : QProxyStyle::pixelMetric(metric, option, widget);
  }
  QRect subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const override {
    if (element == SE_HeaderArrow) {  // the common style squeezes the arrow by the margin
      const QRect all = option->rect;
      return {all.right() - kRoom - kArrow, all.center().y() - kArrow / 2 + 1, kArrow, kArrow};
    }
    return QProxyStyle::subElementRect(element, option, widget);
  }

private:
  static constexpr int kRoom = 6;
  static constexpr int kArrow = 8;
};

}  // namespace

void setUpTable(QTableView& table, const QString& accessibleName) {
  table.setAccessibleName(accessibleName);
  table.setFont(profile::tabularFont(table.font()));
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
  table.setAlternatingRowColors(true);
  table.setWordWrap(false);
  table.setTextElideMode(Qt::ElideRight);
  table.setTabKeyNavigation(false);  // Tab leaves the table; arrows move in it
  table.setCornerButtonEnabled(false);
  auto* roomy = new RoomyStyle;
  roomy->setParent(&table);
  table.setStyle(roomy);
  table.horizontalHeader()->setStyle(roomy);
  table.verticalHeader()->hide();
  table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table.verticalHeader()->setDefaultSectionSize(QFontMetrics(table.font()).height() + 8);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setStretchLastSection(true);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
}

void fitColumns(QTableView& table, const QStringList& widest) {
  const QFontMetrics metrics(table.font());
  for (int column = 0; column < widest.size(); ++column) {
    const QString header = table.model()->headerData(column, Qt::Horizontal).toString();
    const int text = std::max(metrics.horizontalAdvance(widest[column]) + 20, metrics.horizontalAdvance(header) + 34);
    table.setColumnWidth(column, text);
  }
}

void fitWholeColumns(QTableView& table) {
  const QAbstractItemView& view = table;
  const QHeaderView& header = *table.horizontalHeader();
  const int last = table.model()->columnCount() - 1;
  const int room = table.viewport()->width();
  const int leastName = header.sectionSizeHint(0);
  int others = 0;
  bool allFit = true;
  for (int column = 1; column <= last; ++column) {
    const int content = std::max(view.sizeHintForColumn(column), header.sectionSizeHint(column));
    const int width = column == last ? header.sectionSizeHint(column) : content;
    table.setColumnWidth(column, content);
    allFit = allFit && leastName + others + width <= room;
    others += allFit ? width : 0;
  }
  const int name = std::max(leastName, view.sizeHintForColumn(0));
  table.setColumnWidth(0, std::max(leastName, allFit ? std::min(name, room - others) : room - others));
}

QLabel* sentenceLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setFocusPolicy(Qt::NoFocus);
  label->setMinimumWidth(1);
  return label;
}

void jumpTo(document::ViewState& state, const document::PlanView* plan, geo::Point place) {
  if (plan != nullptr) {
    if (const std::optional<double> distance = plan->nearest(place, kOnTour)) {
      state.setPinned(*distance);
    }
  }
  state.showPlace(place);
}

void jumpTo(document::ViewState& state, const document::PlanView& plan, double distance) {
  state.setPinned(distance);
  state.showPlace(plan.at(distance).pose.point());
}

}  // namespace vp::panels
