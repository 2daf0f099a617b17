#include "ui/map/chart_text.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QStaticText>
#include <QTextLayout>
#include <QTextOption>

#include <algorithm>
#include <array>

namespace vp::map {
namespace {

constexpr double kHalo = 1.4;  // px around the letters
constexpr double kPlateX = 7.0;
constexpr double kPlateY = 3.0;

}  // namespace

QFont chartFont(TextSize size, bool bold) {
  QFont font = QGuiApplication::font();
  font.setPixelSize(static_cast<int>(size));
  font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
  return font;
}

void drawHaloText(QPainter& painter, QPointF at, const QStringList& lines, const QFont& font, const QColor& color, const QColor& halo) {
  // the halo is the text itself, shifted all around: glyphs come from a cache, outlines of letters would take ten times as long
  constexpr double kDiagonal = 0.7 * kHalo;
  const std::array shifts{QPointF(kHalo, 0.0),
                          QPointF(-kHalo, 0.0),
                          QPointF(0.0, kHalo),
                          QPointF(0.0, -kHalo),
                          QPointF(kDiagonal, kDiagonal),
                          QPointF(-kDiagonal, kDiagonal),
                          QPointF(kDiagonal, -kDiagonal),
                          QPointF(-kDiagonal, -kDiagonal)};
  const double lineHeight = QFontMetricsF(font).height();
  painter.save();
  painter.setFont(font);
  QPointF corner = at;
  for (const QString& line : lines) {
    QStaticText text(line);
    text.setTextFormat(Qt::PlainText);
    text.prepare(painter.transform(), font);
    painter.setPen(halo);
    for (const QPointF& shift : shifts) {
      painter.drawStaticText(corner + shift, text);
    }
    painter.setPen(color);
    painter.drawStaticText(corner, text);
    corner.ry() += lineHeight;
  }
  painter.restore();
}

QStringList brokenLines(const QString& text, const QFont& font, double width) {
  if (QFontMetricsF(font).horizontalAdvance(text) <= width) {
    return {text};
  }
  QTextLayout layout(text, font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  QStringList lines;
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  layout.endLayout();
  return lines;
}

void drawPanel(QPainter& painter, const QRectF& box, const style::ChartColors& colors) {
  QColor panel = colors.panel;
  panel.setAlphaF(0.90F);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(panel);
  painter.drawRoundedRect(box, 5.0, 5.0);
}

QSizeF plateSize(const QString& text, const QFont& font, double maxWidth) {
  return textSize(brokenLines(text, font, maxWidth - 2.0 * kPlateX), font) + QSizeF(2.0 * kPlateX, 2.0 * kPlateY);
}

void drawPlate(QPainter& painter, const QRectF& box, const QString& text, const QFont& font, const QColor& color, const QColor& plate,
               const QColor& border) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(border, 1.0));
  painter.setBrush(plate);
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setFont(font);
  painter.setPen(color);
  constexpr double kRounding = 1e-3;  // px: what fits just so is not broken again
  painter.drawText(box, Qt::AlignCenter, brokenLines(text, font, box.width() - 2.0 * kPlateX + kRounding).join(QLatin1Char('\n')));
  painter.restore();
}

QRectF drawPlate(QPainter& painter, QPointF centre, const QString& text, const QFont& font, const QColor& color, const QColor& plate,
                 const QColor& border) {
  QRectF box(QPointF(), textSize({text}, font) + QSizeF(2.0 * kPlateX, 2.0 * kPlateY));
  box.moveCenter(centre);
  drawPlate(painter, box, text, font, color, plate, border);
  return box;
}

QRectF readoutBox(QPointF at, const QStringList& lines, const QRectF& within) {
  QRectF box(at, textSize(lines, chartFont(TextSize::Normal)) + QSizeF(2.0 * kPlateX, 2.0 * kPlateY));
  box.moveLeft(std::clamp(box.left(), within.left() + 2.0, std::max(within.left() + 2.0, within.right() - box.width() - 2.0)));
  box.moveTop(std::clamp(box.top(), within.top() + 2.0, std::max(within.top() + 2.0, within.bottom() - box.height() - 2.0)));
  return box;
}

QRectF drawReadout(QPainter& painter, QPointF at, const QStringList& lines, const style::ChartColors& colors, const QRectF& within) {
  const QFont font = chartFont(TextSize::Normal);
  const QRectF box = readoutBox(at, lines, within);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QColor plate = colors.panel;
  plate.setAlphaF(0.93F);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(plate);
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setFont(font);
  painter.setPen(colors.text);
  painter.drawText(box.adjusted(kPlateX, kPlateY, 0.0, 0.0), Qt::AlignLeft | Qt::AlignTop, lines.join(QLatin1Char('\n')));
  painter.restore();
  return box;
}

bool LabelPlacer::isFree(const QRectF& box) const {
  return within_.contains(box) && std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return other.intersects(box); });
}

bool LabelPlacer::placeAt(const QRectF& box) {
  if (!isFree(box)) {
    return false;
  }
  taken_.push_back(box);
  return true;
}

bool LabelPlacer::isClear(const QRectF& box) const {
  return std::none_of(avoided_.begin(), avoided_.end(), [&](const QRectF& other) { return other.intersects(box); });
}

bool LabelPlacer::placeClear(const QRectF& box) {
  return isClear(box) && placeAt(box);
}

std::optional<QPointF> LabelPlacer::place(QPointF anchor, double radius, QSizeF size) {
  const double w = size.width();
  const double h = size.height();
  const double diagonal = 0.75 * radius;
  // as on printed charts: to the right first, then above and below, last to the left
  const std::array offsets{QPointF(radius, -0.5 * h),
                           QPointF(diagonal, -h - 0.4 * diagonal),
                           QPointF(diagonal, 0.4 * diagonal),
                           QPointF(-0.5 * w, -h - radius),
                           QPointF(-0.5 * w, radius),
                           QPointF(-w - radius, -0.5 * h),
                           QPointF(-w - diagonal, -h - 0.4 * diagonal),
                           QPointF(-w - diagonal, 0.4 * diagonal)};
  for (const bool avoiding : {true, false}) {
    for (const QPointF& offset : offsets) {
      const QRectF box(anchor + offset, size);
      if ((!avoiding || isClear(box)) && placeAt(box)) {
        return anchor + offset;
      }
    }
  }
  return std::nullopt;
}

}  // namespace vp::map
