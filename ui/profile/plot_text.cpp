#include "ui/profile/plot_text.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace vp::profile {
namespace {

bool hasTabularFigures(const QFont& font) {
  const QFontMetricsF metrics(font);
  const double width = metrics.horizontalAdvance(QLatin1Char('0'));
  for (char digit = '1'; digit <= '9'; ++digit) {
    if (std::abs(metrics.horizontalAdvance(QLatin1Char(digit)) - width) > 0.01 * width) {
      return false;
    }
  }
  return true;
}

}  // namespace

QFont tabularFont(const QFont& font) {
  if (hasTabularFigures(font)) {
    return font;
  }
  for (const QString& family : {QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans")}) {
    QFont candidate = font;
    candidate.setFamily(family);
    if (QFontInfo(candidate).family() == family && hasTabularFigures(candidate)) {
      return candidate;
    }
  }
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setPixelSize(QFontInfo(font).pixelSize());
  return fixed;
}

QFont scaledFont(const QFont& font, double factor) {
  QFont scaled = font;
  scaled.setPixelSize(std::max(8, static_cast<int>(std::lround(QFontInfo(font).pixelSize() * factor))));
  return scaled;
}

void drawHaloText(QPainter& painter, QPointF baseline, const QString& text, const QColor& color, const QColor& halo) {
  QPainterPath path;
  path.addText(baseline, painter.font(), text);
  painter.strokePath(path, QPen(halo, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setPen(color);
  painter.drawText(baseline, text);
}

void hatchUnknown(QPainter& painter, const QRectF& area, const style::ChartColors& colors) {
  constexpr double kSpacing = 7.0;
  painter.save();
  painter.setClipRect(area, Qt::IntersectClip);
  painter.fillRect(area, colors.unknownBase);
  painter.setPen(QPen(colors.unknown, 1.0));
  const double height = area.height();
  const int first = static_cast<int>(std::floor((area.left() - height) / kSpacing));
  const int last = static_cast<int>(std::ceil(area.right() / kSpacing));
  for (int i = first; i <= last; ++i) {
    const double x = i * kSpacing;
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x + height, area.top()));
  }
  painter.restore();
}

QString groupedNumber(double value, int decimals) {
  QString digits = QString::number(std::abs(value), 'f', decimals);
  const qsizetype point = digits.indexOf(QLatin1Char('.'));
  for (qsizetype i = (point < 0 ? digits.size() : point) - 3; i > 0; i -= 3) {
    digits.insert(i, QChar(0x2009));
  }
  return value < 0.0 && digits.contains(QRegularExpression(QStringLiteral("[1-9]"))) ? QChar(0x2212) + digits : digits;
}

void drawMark(QPainter& painter, QPointF centre, double size, Mark mark, const QColor& color, const QColor& casing) {
  const double h = 0.5 * size;
  QPolygonF shape;
  switch (mark) {
    case Mark::LeastClearance:  // a wedge that points at the ground
      shape << centre + QPointF(-h, -h) << centre + QPointF(h, -h) << centre + QPointF(0.0, h);
      break;
    case Mark::LeastMargin:  // a diamond
      shape << centre + QPointF(0.0, -h) << centre + QPointF(h, 0.0) << centre + QPointF(0.0, h) << centre + QPointF(-h, 0.0);
      break;
    case Mark::HighestGround:  // a peak
      shape << centre + QPointF(0.0, -h) << centre + QPointF(h, h * 0.8) << centre + QPointF(-h, h * 0.8);
      break;
    case Mark::Warning:  // a triangle with a stroke in it
      shape << centre + QPointF(0.0, -h) << centre + QPointF(h * 1.1, h * 0.9) << centre + QPointF(-h * 1.1, h * 0.9);
      break;
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(casing, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(color);
  painter.drawPolygon(shape);
  if (mark == Mark::Warning) {
    painter.setPen(QPen(casing, std::max(1.2, size * 0.12), Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(centre + QPointF(0.0, -h * 0.4), centre + QPointF(0.0, h * 0.25));
    painter.drawPoint(centre + QPointF(0.0, h * 0.6));
  }
  painter.restore();
}

}  // namespace vp::profile
