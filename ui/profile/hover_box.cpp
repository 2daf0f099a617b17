#include "ui/profile/hover_box.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace vp::profile {

QRectF paintHoverBox(QPainter& painter, const std::vector<HoverRow>& rows, double x, const QRectF& area, const ProfileStyle& style) {
  constexpr double kPad = 6.0;
  constexpr double kGap = 12.0;      // between name and value
  constexpr double kBetween = 22.0;  // between columns
  const QFont font = scaledFont(tabularFont(style.font), 0.9);
  const QFontMetricsF metrics(font);
  // two columns where one would cover most of a low plot
  const auto count = static_cast<int>(rows.size());
  const bool isLow = count * metrics.height() + 2.0 * kPad > 0.55 * area.height();
  const int perColumn = isLow ? (count + 1) / 2 : count;
  const int columns = isLow ? 2 : 1;
  double names = 0.0;
  double values = 0.0;
  for (const HoverRow& row : rows) {
    names = std::max(names, metrics.horizontalAdvance(row.name));
    values = std::max(values, metrics.horizontalAdvance(row.value));
  }
  const double columnWidth = names + values + kGap;
  const QSizeF size(columns * columnWidth + (columns - 1) * kBetween + 2.0 * kPad, perColumn * metrics.height() + 2.0 * kPad);
  const double right = x + 14.0;
  const double left = right + size.width() <= area.right() ? right : x - 14.0 - size.width();
  const QRectF box(QPointF(std::max(area.left(), left), area.top()), size);

  const style::ChartColors& colors = style.colors();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font);
  QColor back = colors.panel;
  back.setAlpha(240);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(back);
  painter.drawRoundedRect(box, 4.0, 4.0);
  for (int i = 0; i < count; ++i) {
    const HoverRow& row = rows[static_cast<std::size_t>(i)];
    const int column = i / perColumn;
    const double from = box.left() + kPad + column * (columnWidth + kBetween);
    const double base = box.top() + kPad + metrics.ascent() + (i % perColumn) * metrics.height();
    painter.setPen(colors.mutedText);
    painter.drawText(QPointF(from, base), row.name);
    painter.setPen(row.isViolated ? colors.violation : colors.text);
    painter.drawText(QPointF(from + columnWidth - metrics.horizontalAdvance(row.value), base), row.value);
  }
  painter.restore();
  return box;
}

}  // namespace vp::profile
