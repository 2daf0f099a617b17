#include "ui/style/wind_figure.h"

#include "ui/style/text_size.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::style {
namespace {

constexpr double kArrowLength = 26.0;  // px
constexpr double kRowHeight = 36.0;    // px at least
constexpr double kPad = 7.0;
constexpr double kBeside = 8.0;   // between arrow and numbers
constexpr double kBetween = 7.0;  // between two layers
constexpr double kHead = 8.0;     // of the arrow

struct Words {
  Q_DECLARE_TR_FUNCTIONS(vp::style::WindFigure)
};

int degreesOf(double degrees) {
  const int rounded = static_cast<int>(std::lround(degrees)) % 360;
  return rounded <= 0 ? rounded + 360 : rounded;
}

QString directionText(const air::WindSector& wind) {
  if (wind.spread_deg >= 180.0) {
    return Words::tr("from anywhere", "wind");
  }
  const auto digits = [](double degrees) { return QStringLiteral("%1").arg(degreesOf(degrees), 3, 10, QLatin1Char('0')); };
  if (wind.spread_deg < 0.5) {
    return QStringLiteral("%1° T").arg(digits(wind.from_deg));
  }
  return QStringLiteral("%1°–%2° T").arg(digits(wind.from_deg - wind.spread_deg), digits(wind.from_deg + wind.spread_deg));
}

QString speedText(const air::WindSector& wind, const Units& units) {
  const double least = std::floor(units.speedFromSi(wind.leastSpeed) + 1e-6);  // outwards: the range shown holds all that is meant
  const double most = std::ceil(units.speedFromSi(wind.mostSpeed) - 1e-6);
  if (wind.leastSpeed == wind.mostSpeed) {
    return QStringLiteral("%1 %2").arg(std::round(units.speedFromSi(wind.mostSpeed))).arg(units.speedUnit());
  }
  return QStringLiteral("%1–%2 %3").arg(least).arg(most).arg(units.speedUnit());
}

}  // namespace

WindFigure::WindFigure(const std::vector<air::WindLayer>& winds, const Units& units, const ChartColors& colors, QFont font)
    : colors_(colors), font_(std::move(font)) {
  if (std::all_of(winds.begin(), winds.end(), [](const air::WindLayer& layer) { return layer.wind.isCalm(); })) {
    return;
  }
  const auto add = [&](const air::WindLayer& layer) {
    Row row{layer.wind, {}};
    if (winds.size() > 1) {
      row.lines << units.altitudeMsl(layer.altitude.metres());
    }
    if (layer.wind.isCalm()) {
      row.lines << Words::tr("still air");
    } else {
      row.lines << directionText(layer.wind) << speedText(layer.wind, units);
    }
    rows_.push_back(std::move(row));
  };
  if (winds.size() > 1) {
    add(winds.back());
  }
  add(winds.front());
}

std::optional<QSizeF> WindFigure::size() const {
  if (rows_.empty()) {
    return std::nullopt;
  }
  QSizeF size(0.0, 2.0 * kPad + kBetween * static_cast<double>(rows_.size() - 1));
  for (const Row& row : rows_) {
    const QSizeF text = textSize(row.lines, font_);
    size = {std::max(size.width(), kArrowLength + kBeside + text.width() + 2.0 * kPad), size.height() + std::max(kRowHeight, text.height())};
  }
  return size;
}

void WindFigure::draw(QPainter& painter, const QRectF& box, double north) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  double top = box.top() + kPad;
  for (const Row& row : rows_) {
    const QSizeF text = textSize(row.lines, font_);
    const double height = std::max(kRowHeight, text.height());
    drawArrow(painter, {box.left() + kPad + 0.5 * kArrowLength, top + 0.5 * height}, row.wind, north);
    painter.setFont(font_);
    painter.setPen(colors_.text);
    painter.drawText(QRectF(box.left() + kPad + kArrowLength + kBeside, top, text.width() + 2.0, height), Qt::AlignLeft | Qt::AlignVCenter,
                     row.lines.join(QLatin1Char('\n')));
    top += height + kBetween;
  }
  painter.restore();
}

/// @param centre  of the arrow
void WindFigure::drawArrow(QPainter& painter, QPointF centre, const air::WindSector& wind, double north) const {
  const double half = 0.5 * kArrowLength;
  painter.setPen(QPen(colors_.text, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::MiterJoin));
  if (wind.isCalm() || wind.spread_deg >= 180.0) {
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, 0.6 * half, 0.6 * half);
    return;
  }
  const double towards = wind.towards() + north;
  const QPointF along(std::cos(towards), -std::sin(towards));  // y grows downwards on the screen
  const QPointF across(-along.y(), along.x());
  const QPointF tip = centre + half * along;
  const QPointF tail = centre - half * along;
  if (wind.spread_deg >= 0.5) {
    QColor fan = colors_.text;
    fan.setAlphaF(0.25F);
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(fan);
    const double middle = Angle::radians(towards).degrees();
    painter.drawPie(QRectF(centre.x() - half, centre.y() - half, kArrowLength, kArrowLength),
                    static_cast<int>(16.0 * (middle + 180.0 - wind.spread_deg)), static_cast<int>(32.0 * wind.spread_deg));
    painter.restore();
  }
  painter.drawLine(tail, tip - 0.5 * kHead * along);
  painter.setBrush(colors_.text);
  painter.drawPolygon(QPolygonF{tip, tip - kHead * along + 0.5 * kHead * across, tip - kHead * along - 0.5 * kHead * across});
}

}  // namespace vp::style
