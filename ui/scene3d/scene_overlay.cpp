#include "ui/scene3d/scene_overlay.h"

#include "ui/style/chart_colors.h"
#include "ui/style/wind_figure.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vp::scene3d {
namespace {

constexpr double kMargin = 12.0;
constexpr double kScaleWidth = 14.0;
constexpr double kScaleHeight = 132.0;
constexpr double kPadding = 9.0;

QFont textFont(bool isBold = false) {
  QFont font;
  font.setPixelSize(12);
  font.setBold(isBold);
  return font;
}

QString legendTitle() {
  return QCoreApplication::translate("vp::scene3d::SceneOverlay", "Altitude");
}

void paintPanel(QPainter& painter, const QRectF& rect, style::Theme theme) {
  const style::ChartColors& colors = style::ChartColors::of(theme);
  QColor panel = colors.panel;
  panel.setAlpha(222);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(panel);
  painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
}

/// Round altitudes for the scale, in the shown unit: three to six of them.
std::vector<double> ticksOf(const AltitudeRange& range, const style::Units& units) {
  const double low = units.heightFromSi(range.low);
  const double high = units.heightFromSi(range.high);
  const double raw = std::max(high - low, 1.0) / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * power;
  for (const double nice : {1.0, 2.0, 2.5, 5.0}) {
    if (nice * power >= raw) {
      step = nice * power;
      break;
    }
  }
  std::vector<double> ticks;
  const int last = static_cast<int>(std::floor(high / step + 1e-9));
  for (int i = static_cast<int>(std::ceil(low / step - 1e-9)); i <= last; ++i) {
    const double t = i * step;
    ticks.push_back(units.heightToSi(t));
  }
  return ticks;
}

QString contourText(const LegendContent& content, const SceneStyle& style) {
  return QCoreApplication::translate("vp::scene3d::SceneOverlay", "Contours %1").arg(style.units.height(content.contourInterval));
}

/// Title, colours and their altitudes, from the upper left corner of a rectangle.
void paintScale(QPainter& painter, const QRectF& rect, const AltitudeRange& range, const SceneStyle& style) {
  const style::ChartColors& colors = style::ChartColors::of(style.theme);
  const QFontMetricsF metrics(textFont());
  painter.setPen(colors.text);
  painter.setFont(textFont(true));
  painter.drawText(QRectF(rect.left(), rect.top() - 2.0, rect.width(), metrics.height()), Qt::AlignLeft | Qt::AlignVCenter, legendTitle());
  const QRectF scale(rect.left(), rect.top() + 1.6 * metrics.height(), kScaleWidth, kScaleHeight);
  QLinearGradient gradient(scale.bottomLeft(), scale.topLeft());
  constexpr int kStops = 16;
  for (int i = 0; i <= kStops; ++i) {
    gradient.setColorAt(static_cast<double>(i) / kStops, style::ChartColors::altitudeScale(static_cast<double>(i) / kStops));
  }
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(gradient);
  painter.drawRect(scale);
  painter.setFont(textFont());
  painter.setPen(colors.text);
  for (const double altitude : ticksOf(range, style.units)) {
    const double y = scale.bottom() - range.fraction(altitude) * scale.height();
    painter.drawLine(QPointF(scale.right(), y), QPointF(scale.right() + 4.0, y));
    painter.drawText(QRectF(scale.right() + 8.0, y - 0.5 * metrics.height(), rect.right() + kPadding - scale.right() - 8.0, metrics.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, style.units.altitudeMsl(altitude));
  }
}

}  // namespace

void paintCompass(QPainter& painter, const QRectF& rect, double azimuth, style::Theme theme) {
  const style::ChartColors& colors = style::ChartColors::of(theme);
  const double radius = 0.5 * std::min(rect.width(), rect.height()) - 1.0;
  QColor panel = colors.panel;
  panel.setAlpha(222);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(rect.center());
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(panel);
  painter.drawEllipse(QPointF(0.0, 0.0), radius, radius);
  // Looking north (azimuth 90 degrees) the needle points up.
  const double turn = azimuth * 180.0 / std::numbers::pi - 90.0;
  painter.rotate(turn);
  const double tip = 0.60 * radius;
  const double half = 0.17 * radius;
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.text);
  painter.drawPolygon(QPolygonF({QPointF(0.0, -tip), QPointF(half, 0.0), QPointF(-half, 0.0)}));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.text, 1.2));
  painter.drawPolygon(QPolygonF({QPointF(0.0, tip), QPointF(half, 0.0), QPointF(-half, 0.0)}));
  QFont font = textFont(true);
  painter.setFont(font);
  painter.setPen(colors.text);
  painter.translate(0.0, -0.79 * radius);
  painter.rotate(-turn);
  painter.drawText(QRectF(-10.0, -8.0, 20.0, 16.0), Qt::AlignCenter, QCoreApplication::translate("vp::scene3d::SceneOverlay", "N"));
  painter.restore();
}

QSizeF windSize(const std::vector<air::WindLayer>& winds, const SceneStyle& style) {
  return style::WindFigure(winds, style.units, style::ChartColors::of(style.theme), textFont()).size().value_or(QSizeF());
}

void paintWind(QPainter& painter, const QRectF& rect, const std::vector<air::WindLayer>& winds, double azimuth, const SceneStyle& style) {
  painter.save();
  paintPanel(painter, rect, style.theme);
  const double north = 0.5 * std::numbers::pi - azimuth;  // looking north, north is up
  style::WindFigure(winds, style.units, style::ChartColors::of(style.theme), textFont()).draw(painter, rect, north);
  painter.restore();
}

QSizeF legendSize(const LegendContent& content, const SceneStyle& style) {
  const QFontMetricsF metrics(textFont());
  double wide = 0.0;
  double high = 0.0;
  if (content.altitudes) {
    const double text = metrics.horizontalAdvance(style.units.altitudeMsl(style.units.heightToSi(88888.0)));
    wide = std::max(kScaleWidth + 10.0 + text, QFontMetricsF(textFont(true)).horizontalAdvance(legendTitle()));
    high = 1.6 * metrics.height() + kScaleHeight + 6.0;
  }
  if (content.contourInterval > 0.0) {
    wide = std::max(wide, metrics.horizontalAdvance(contourText(content, style)));
    high += metrics.height() + (content.altitudes ? 6.0 : 0.0);
  }
  return high > 0.0 ? QSizeF(std::ceil(2.0 * kPadding + wide), std::ceil(2.0 * kPadding + high)) : QSizeF();
}

void paintLegend(QPainter& painter, const QRectF& rect, const LegendContent& content, const SceneStyle& style) {
  painter.save();
  paintPanel(painter, rect, style.theme);
  const QRectF inside = rect.adjusted(kPadding, kPadding, -kPadding, -kPadding);
  if (content.altitudes) {
    paintScale(painter, inside, *content.altitudes, style);
  }
  if (content.contourInterval > 0.0) {
    painter.setFont(textFont());
    painter.setPen(style::ChartColors::of(style.theme).text);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom, contourText(content, style));
  }
  painter.restore();
}

QString exaggerationText(double factor) {
  return std::abs(factor - 1.0) < 1e-6 ? QString()
                                       : QCoreApplication::translate("vp::scene3d::SceneOverlay", "Heights drawn %1×").arg(factor, 0, 'g', 3);
}

QSizeF noteSize(const QString& text) {
  const QFontMetricsF metrics(textFont(true));
  return {std::ceil(metrics.horizontalAdvance(text) + 2.0 * kPadding), std::ceil(metrics.height() + kPadding)};
}

void paintNote(QPainter& painter, const QRectF& rect, const QString& text, style::Theme theme) {
  painter.save();
  paintPanel(painter, rect, theme);
  painter.setFont(textFont(true));
  painter.setPen(style::ChartColors::of(theme).text);
  painter.drawText(rect, Qt::AlignCenter, text);
  painter.restore();
}

std::vector<QRectF> OverlayLayout::shown() const {
  std::vector<QRectF> parts;
  for (const QRectF& part : {compass, wind, legend, note}) {
    if (!part.isEmpty()) {
      parts.push_back(part);
    }
  }
  return parts;
}

OverlayLayout layOutOverlay(QSizeF size, const OverlayContent& content, const SceneStyle& style) {
  constexpr double kLeastHeight = 260.0;  // of the picture, below which the legend would cover too much
  constexpr double kWidest = 0.4;         // of the width of the picture, for the same reason
  OverlayLayout layout;
  layout.compass = QRectF(size.width() - kMargin - kCompassSide, kMargin, kCompassSide, kCompassSide);
  const QSizeF windPart = windSize(content.winds, style);
  if (!windPart.isEmpty() && windPart.width() <= kWidest * size.width() &&
      layout.compass.bottom() + windPart.height() + 2.0 * kMargin <= size.height()) {
    layout.wind = QRectF(QPointF(size.width() - kMargin - windPart.width(), layout.compass.bottom() + 0.5 * kMargin), windPart);
  }
  const QSizeF legendPart = legendSize(content.legend, style);
  if (size.height() >= kLeastHeight && legendPart.width() <= kWidest * size.width() && !legendPart.isEmpty()) {
    layout.legend = QRectF(QPointF(kMargin, size.height() - kMargin - legendPart.height()), legendPart);
  }
  const QString note = exaggerationText(content.exaggeration);
  if (!note.isEmpty()) {
    layout.note = QRectF(QPointF(kMargin, kMargin), noteSize(note));
  }
  return layout;
}

void paintOverlay(QPainter& painter, QSizeF size, double azimuth, const OverlayContent& content, const SceneStyle& style) {
  const OverlayLayout layout = layOutOverlay(size, content, style);
  paintCompass(painter, layout.compass, azimuth, style.theme);
  if (!layout.wind.isEmpty()) {
    paintWind(painter, layout.wind, content.winds, azimuth, style);
  }
  if (!layout.legend.isEmpty()) {
    paintLegend(painter, layout.legend, content.legend, style);
  }
  if (!layout.note.isEmpty()) {
    paintNote(painter, layout.note, exaggerationText(content.exaggeration), style.theme);
  }
}

}  // namespace vp::scene3d
