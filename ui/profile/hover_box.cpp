#include "ui/profile/hover_box.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace vp::profile {

QRectF paintHoverBox(QPainter& painter, const std::vector<HoverRow>& rows, double x, const QRectF& area, const ProfileStyle& style) {
  constexpr double kPad = 6.0;
  constexpr double kGap = 14.0;
  const QFont font = scaledFont(tabularFont(style.font), 0.9);
  const QFontMetricsF metrics(font);
  double names = 0.0;
  double values = 0.0;
  for (const HoverRow& row : rows) {
    names = std::max(names, metrics.horizontalAdvance(row.name));
    values = std::max(values, metrics.horizontalAdvance(row.value));
  }
  const QSizeF size(names + values + kGap + 2.0 * kPad, static_cast<double>(rows.size()) * metrics.height() + 2.0 * kPad);
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
  double base = box.top() + kPad + metrics.ascent();
  for (const HoverRow& row : rows) {
    painter.setPen(colors.mutedText);
    painter.drawText(QPointF(box.left() + kPad, base), row.name);
    painter.setPen(row.isViolated ? colors.violation : colors.text);
    painter.drawText(QPointF(box.right() - kPad - metrics.horizontalAdvance(row.value), base), row.value);
    base += metrics.height();
  }
  painter.restore();
  return box;
}

}  // namespace vp::profile
