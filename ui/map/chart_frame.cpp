#include "ui/map/chart_frame.h"

#include "ui/map/words.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr double kScaleLength = 150.0;  // px at most
constexpr double kScaleHeight = 34.0;   // at least
constexpr double kBar = 5.0;            // height of the scale bar
constexpr double kBelowBar = 7.0;
constexpr double kAboveBar = 4.0;  // to the base line of the numbers
constexpr double kPad = 9.0;
constexpr double kBesideZero = 4.0;
constexpr double kApart = 4.0;        // between two numbers of the scale bar
constexpr QSizeF kNorth(30.0, 44.0);  // at least
constexpr double kArrow = 24.0;       // of it, to the letter

QFont scaleFont() {
  return chartFont(TextSize::Small);
}

QString scaleNumber(double value) {
  return QString::number(value, 'g', 3);
}

QString northLetter() {
  return Words::tr("N", "north on the map's arrow");
}

QSizeF northSize() {
  const QSizeF letter = textSize({northLetter()}, chartFont(TextSize::Small, true));
  return QSizeF(letter.width() + kPad, kArrow + letter.height()).expandedTo(kNorth);
}

}  // namespace

double scaleBarLength(double metresPerPixel, double pixels, const style::Units& units) {
  const double shown = units.distanceFromSi(metresPerPixel * pixels);
  const double power = std::pow(10.0, std::floor(std::log10(shown)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= shown) {
      return units.distanceToSi(step * power);
    }
  }
  return units.distanceToSi(power);
}

ChartFrame::ChartFrame(const MapScene& scene, const MapCamera& camera, const SafeAltitudeLayer* safeAltitude, const QString& message)
    : scene_(scene),
      camera_(camera),
      message_(message),
      scale_(scaleBarLength(camera.metresPerPixel(), scalePixels(), scene.units)),
      legend_(scene, camera, safeAltitude, camera.size().width() - 2.0 * kFurnitureEdge),
      wind_(scene.situation.wind, scene.units, scene.colors(), chartFont(TextSize::Small)) {
  FurnitureSizes sizes;
  sizes.wind = wind_.size();
  sizes.scale = scaleSize();
  sizes.north = northSize();
  if (!message.isEmpty()) {
    sizes.message = plateSize(message, chartFont(TextSize::Normal), camera.size().width() - 2.0 * kFurnitureEdge);
  }
  sizes.legendWidth = legend_.width();
  sizes.legendPadding = ChartLegend::padding();
  sizes.legendGroups = legend_.groupHeights();
  layout_ = layOutChart(camera.size(), sizes);
}

/// How long the bar may be so that it fits into the map with its numbers.
double ChartFrame::scalePixels() const {
  const double words = QFontMetricsF(scaleFont()).horizontalAdvance(QStringLiteral("0.005 %1").arg(scene_.units.distanceUnit()));
  return std::clamp(camera_.size().width() - 2.0 * (kFurnitureEdge + kPad) - kBesideZero - words, 1.0, kScaleLength);
}

QSizeF ChartFrame::scaleSize() const {
  const QFontMetricsF metrics(scaleFont());
  const QString end = scaleNumber(scene_.units.distanceFromSi(scale_));
  const double words =
      metrics.horizontalAdvance(QStringLiteral("%1 %2").arg(end, scene_.units.distanceUnit())) - 0.5 * metrics.horizontalAdvance(end);
  const double width =
      scale_ / camera_.metresPerPixel() + 2.0 * kPad + std::max(kBesideZero + words, metrics.horizontalAdvance(QStringLiteral("100 NM")));
  return {std::min(width, camera_.size().width() - 2.0 * kFurnitureEdge),
          std::max(kScaleHeight, kBelowBar + kBar + kAboveBar + metrics.height() + 1.0)};
}

void ChartFrame::draw(QPainter& painter) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  drawScale(painter);
  if (layout_.north) {
    drawNorth(painter, *layout_.north);
  }
  if (layout_.wind) {
    drawPanel(painter, *layout_.wind, scene_.colors());
    wind_.draw(painter, *layout_.wind);
  }
  if (layout_.legend) {
    legend_.draw(painter, *layout_.legend, layout_.legendGroups);
  }
  if (layout_.message) {
    const style::ChartColors& colors = scene_.colors();
    drawPlate(painter, *layout_.message, message_, chartFont(TextSize::Normal), colors.text, colors.panel, colors.panelBorder);
  }
  painter.restore();
}

void ChartFrame::drawScale(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  const QRectF& box = layout_.scale;
  drawPanel(painter, box, colors);
  const QFontMetricsF metrics(scaleFont());
  const double length = scale_ / camera_.metresPerPixel();
  const double left = box.left() + kPad + kBesideZero;
  const double bottom = box.bottom() - kBelowBar;
  painter.setPen(QPen(colors.text, 1.0));
  for (int quarter = 0; quarter < 4; ++quarter) {
    painter.setBrush(quarter % 2 == 0 ? colors.text : colors.panel);
    painter.drawRect(QRectF(left + 0.25 * quarter * length, bottom - kBar, 0.25 * length, kBar));
  }
  painter.setFont(scaleFont());
  const double shown = scene_.units.distanceFromSi(scale_);
  const QString zero = QStringLiteral("0");
  const QString middle = scaleNumber(0.5 * shown);
  const QString end = scaleNumber(shown);
  const auto half = [&](const QString& text) { return 0.5 * metrics.horizontalAdvance(text); };
  const auto write = [&](double at, const QString& number, const QString& unit = {}) {
    painter.drawText(QPointF(at - half(number), bottom - kBar - kAboveBar), number + unit);
  };
  write(left, zero);
  if (half(middle) + std::max(half(zero), half(end)) + kApart <= 0.5 * length) {
    write(left + 0.5 * length, middle);
  }
  write(left + length, end, QLatin1Char(' ') + scene_.units.distanceUnit());
}

void ChartFrame::drawNorth(QPainter& painter, const QRectF& box) const {
  const style::ChartColors& colors = scene_.colors();
  drawPanel(painter, box, colors);
  const double x = box.center().x();
  const double top = box.top() + 5.0;
  painter.setPen(QPen(colors.text, 1.2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.setBrush(colors.text);
  painter.drawPolygon(QPolygonF{QPointF(x, top), QPointF(x, top + 17.0), QPointF(x - 7.0, top + 21.0)});
  painter.setBrush(colors.panel);
  painter.drawPolygon(QPolygonF{QPointF(x, top), QPointF(x + 7.0, top + 21.0), QPointF(x, top + 17.0)});
  painter.setFont(chartFont(TextSize::Small, true));
  painter.drawText(box.adjusted(0.0, kArrow, 0.0, 0.0), Qt::AlignCenter, northLetter());
}

}  // namespace vp::map
