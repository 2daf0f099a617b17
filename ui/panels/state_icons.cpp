#include "ui/panels/state_icons.h"

#include <QFont>
#include <QHash>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPolygonF>

#include <cmath>
#include <numbers>
#include <utility>

namespace vp::panels {
namespace {

constexpr double kUnit = 16.0;  // all shapes are drawn on a square of 16

QPen strokeOf(const QColor& color, double width = 1.8) {
  return {color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void tick(QPainter& painter, const QColor& color, double scale = 1.0) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(strokeOf(color, 2.0));
  painter.drawPolyline(QPolygonF() << QPointF(8.0 - 3.2 * scale, 8.2) << QPointF(8.0 - 0.8 * scale, 8.2 + 2.4 * scale)
                                   << QPointF(8.0 + 3.4 * scale, 8.2 - 2.8 * scale));
}

QPainterPath shield() {
  QPainterPath path;
  path.moveTo(8.0, 1.2);
  path.lineTo(13.8, 3.4);
  path.lineTo(13.8, 7.6);
  path.cubicTo(13.8, 11.4, 11.2, 13.8, 8.0, 15.0);
  path.cubicTo(4.8, 13.8, 2.2, 11.4, 2.2, 7.6);
  path.lineTo(2.2, 3.4);
  path.closeSubpath();
  return path;
}

void letter(QPainter& painter, const QColor& color, QChar symbol) {
  QFont font;
  font.setPixelSize(10);
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(QRectF(0.0, 0.4, kUnit, kUnit), Qt::AlignCenter, QString(symbol));
}

void ring(QPainter& painter, const QColor& color) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(strokeOf(color));
  painter.drawEllipse(QPointF(8.0, 8.0), 6.4, 6.4);
}

void aroundTerrain(QPainter& painter, const style::ChartColors& colors) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.ground);
  painter.drawPolygon(QPolygonF() << QPointF(8.0, 6.4) << QPointF(12.4, 15.0) << QPointF(3.6, 15.0));
  QPainterPath path;
  path.moveTo(1.6, 12.0);
  path.cubicTo(2.4, 2.0, 12.0, 0.0, 14.0, 9.4);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(strokeOf(colors.glideAmple));
  painter.drawPath(path);
  painter.drawPolyline(QPolygonF() << QPointF(11.2, 7.8) << QPointF(14.1, 10.2) << QPointF(15.2, 6.6));
}

void warning(QPainter& painter, const QColor& fill, const QColor& stroke) {
  painter.setPen(strokeOf(fill, 1.4));
  painter.setBrush(fill);
  painter.drawPolygon(QPolygonF() << QPointF(8.0, 2.0) << QPointF(14.8, 14.0) << QPointF(1.2, 14.0));
  painter.setPen(strokeOf(stroke));
  painter.drawLine(QPointF(8.0, 6.4), QPointF(8.0, 9.8));
  painter.drawPoint(QPointF(8.0, 12.2));
}

void violation(QPainter& painter, const QColor& fill, const QColor& stroke) {
  QPolygonF octagon;
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4.0;
    octagon << QPointF(8.0 + 7.2 * std::cos(angle), 8.0 + 7.2 * std::sin(angle));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(fill);
  painter.drawPolygon(octagon);
  painter.setPen(strokeOf(stroke));
  painter.drawLine(QPointF(8.0, 4.2), QPointF(8.0, 8.8));
  painter.drawPoint(QPointF(8.0, 11.8));
}

/// Buttons of the player, in the colour of text.
void player(QPainter& painter, Sign sign, const QColor& color) {
  painter.setPen(QPen(color, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(color);
  const QPolygonF forward = QPolygonF() << QPointF(4.0, 2.8) << QPointF(12.6, 8.0) << QPointF(4.0, 13.2);
  if (sign == Sign::Previous) {
    painter.translate(kUnit, 0.0);
    painter.scale(-1.0, 1.0);
  }
  if (sign == Sign::Pause) {
    painter.drawRect(QRectF(3.8, 3.0, 2.6, 10.0));
    painter.drawRect(QRectF(9.6, 3.0, 2.6, 10.0));
    return;
  }
  painter.drawPolygon(sign == Sign::Play ? forward : forward.translated(-1.6, 0.0));
  if (sign != Sign::Play) {
    painter.drawRect(QRectF(12.0, 3.0, 1.4, 10.0));
  }
}

void drawSign(QPainter& painter, Sign sign, const style::ChartColors& colors) {
  switch (sign) {
    case Sign::Reachable:
      painter.setPen(Qt::NoPen);
      painter.setBrush(colors.glideAmple);
      painter.drawEllipse(QPointF(8.0, 8.0), 7.0, 7.0);
      tick(painter, colors.panel);
      break;
    case Sign::AroundTerrain:
      aroundTerrain(painter, colors);
      break;
    case Sign::NotReachable:
      ring(painter, colors.violation);
      painter.drawLine(QPointF(5.4, 5.4), QPointF(10.6, 10.6));
      painter.drawLine(QPointF(5.4, 10.6), QPointF(10.6, 5.4));
      break;
    case Sign::Verified:
      painter.setPen(Qt::NoPen);
      painter.setBrush(colors.glideAmple);
      painter.drawPath(shield());
      tick(painter, colors.panel, 0.95);
      break;
    case Sign::Unverified:
      painter.setPen(strokeOf(colors.glideTight));
      painter.setBrush(Qt::NoBrush);
      painter.drawPath(shield());
      letter(painter, colors.text, QLatin1Char('?'));
      break;
    case Sign::OutOfDate:
      ring(painter, colors.glideTight);
      painter.setPen(strokeOf(colors.text));
      painter.drawPolyline(QPolygonF() << QPointF(8.0, 4.4) << QPointF(8.0, 8.2) << QPointF(10.6, 9.8));
      break;
    case Sign::Warning:
      warning(painter, colors.glideTight, QColor(0x1B, 0x1E, 0x24));
      break;
    case Sign::Violation:
      violation(painter, colors.violation, colors.panel);
      break;
    case Sign::Note:
      ring(painter, colors.selection);
      letter(painter, colors.selection, QLatin1Char('i'));
      break;
    case Sign::Previous:
    case Sign::Next:
    case Sign::Play:
    case Sign::Pause:
      player(painter, sign, colors.text);
      break;
  }
}

QIcon drawnIcon(Sign sign, style::Theme theme) {
  QIcon icon;
  for (const int pixels : {16, 24, 32, 48, 64}) {
    QPixmap pixmap(pixels, pixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(pixels / kUnit, pixels / kUnit);
    drawSign(painter, sign, style::ChartColors::of(theme));
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace

QIcon signIcon(Sign sign, style::Theme theme) {
  // Each is drawn once: Qt keeps what is scaled from a new icon for long, so icons drawn anew for every change would fill its cache.
  static auto& drawn = *new QHash<std::pair<int, int>, QIcon>;  // never destroyed: pixmaps must not outlive the application and be freed then
  QIcon& icon = drawn[{static_cast<int>(sign), static_cast<int>(theme)}];
  if (icon.isNull()) {
    icon = drawnIcon(sign, theme);
  }
  return icon;
}

}  // namespace vp::panels
