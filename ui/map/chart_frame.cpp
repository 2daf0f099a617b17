#include "ui/map/chart_frame.h"

#include "ui/map/hatch.h"
#include "ui/map/margin_pattern.h"
#include "ui/map/tour_lines.h"
#include "ui/map/words.h"

#include <QFontMetricsF>
#include <QLinearGradient>

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr double kEdge = 12.0;          // px to the edge of the map
constexpr double kScaleLength = 150.0;  // px at most
constexpr double kPad = 9.0;
constexpr double kSignWidth = 34.0;
constexpr double kRow = 18.0;
constexpr double kScaleRow = 46.0;  // of the altitude scale
constexpr double kLegendWidth = 210.0;

double rowHeight(bool isScale) {
  return isScale ? kScaleRow : kRow;
}

void drawPanel(QPainter& painter, const QRectF& box, const style::ChartColors& colors) {
  QColor panel = colors.panel;
  panel.setAlphaF(0.90F);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(panel);
  painter.drawRoundedRect(box, 5.0, 5.0);
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

QString ChartFrame::courseText() const {
  return scene_.options.safeAltitudeCourse ? Words::tr("on course %1").arg(style::Units::course(*scene_.options.safeAltitudeCourse))
                                           : Words::tr("on the worst course");
}

std::vector<ChartFrame::Entry> ChartFrame::entries() const {
  using Sign = Entry::Sign;
  std::vector<Entry> list;
  if (!scene_.options.legend) {
    return list;
  }
  const MapOptions& options = scene_.options;
  const document::Situation& now = scene_.situation;
  const bool hasField = safeAltitude_ != nullptr && !safeAltitude_->isEmpty();
  if (options.safeAltitude && safeAltitude_ != nullptr) {
    if (hasField) {
      list.push_back({Sign::AltitudeScale, Words::tr("Lowest safe altitude %1, %2 MSL").arg(courseText(), scene_.units.heightUnit())});
    }
    list.push_back({Sign::NoGlide, Words::tr("No glide from any altitude")});
  }
  if (options.reachableFrom && safeAltitude_ != nullptr) {
    list.push_back({Sign::Reachable, Words::tr("Runway reachable from %1").arg(scene_.units.altitudeMsl(*options.reachableFrom))});
  }
  const bool marginShown = now.plan != nullptr && ((options.tourMargin && now.planIsCurrent) || options.allGlides || scene_.cursor);
  if (marginShown) {
    const auto height = [&](double metres) { return scene_.units.height(metres); };
    list.push_back(
        {Sign::Margin, Words::tr("Glide margin %1 or more").arg(height(style::ChartColors::kAmpleMargin)), style::ChartColors::kAmpleMargin});
    list.push_back({Sign::Margin, Words::tr("less than %1").arg(height(style::ChartColors::kAmpleMargin)),
                    0.5 * (kTightMargin + style::ChartColors::kAmpleMargin)});
    list.push_back({Sign::Margin, Words::tr("less than %1").arg(height(kTightMargin)), 0.0});
    if (marginClass(now.plan->leastGlideMargin().state.glideMargin()) == MarginClass::Violated) {
      list.push_back({Sign::Margin, Words::tr("none: no glide arrives"), -1.0});
    }
  }
  if (options.decisionPoints && now.plan != nullptr) {
    const double spacing = now.plan->length() / static_cast<double>(now.plan->plan().tour.size());
    list.push_back({Sign::DecisionPoint, spacing / camera_.metresPerPixel() < kDotSpacing ? Words::tr("Decision points, not all at this scale")
                                                                                          : Words::tr("Decision points")});
  }
  if (now.sketch != nullptr && now.sketch->tour != nullptr) {
    list.push_back({Sign::SafeLeg, Words::tr("Leg proved safe")});
    list.push_back({Sign::BoundLeg, Words::tr("Leg not yet checked")});
  }
  if (now.sketch != nullptr && now.sketch->roadmap != nullptr) {
    list.push_back({Sign::Roadmap, Words::tr("Glides to the runways")});
  }
  return list;
}

QRectF ChartFrame::legendBox(const std::vector<Entry>& entries) const {
  double height = 2.0 * kPad;
  double width = kLegendWidth;
  const QFontMetricsF metrics(chartFont(TextSize::Small));
  for (const Entry& entry : entries) {
    const bool isScale = entry.sign == Entry::Sign::AltitudeScale;
    height += rowHeight(isScale);
    width = std::max(width, metrics.horizontalAdvance(entry.text) + 2.0 * kPad + (isScale ? 0.0 : kSignWidth + 8.0));
  }
  const QRectF screen = camera_.screen();
  return {screen.right() - kEdge - width, screen.bottom() - kEdge - height, width, height};
}

QRectF ChartFrame::scaleBox() const {
  const QFontMetricsF metrics(chartFont(TextSize::Small));
  const double metres = scaleBarLength(camera_.metresPerPixel(), kScaleLength, scene_.units);
  const double width = metres / camera_.metresPerPixel() + 2.0 * kPad + metrics.horizontalAdvance(QStringLiteral("100 NM"));
  return {kEdge, camera_.size().height() - kEdge - 34.0, width, 34.0};
}

QRectF ChartFrame::northBox() const {
  return {camera_.size().width() - kEdge - 30.0, kEdge, 30.0, 44.0};
}

std::vector<QRectF> ChartFrame::covered() const {
  std::vector<QRectF> boxes{scaleBox(), northBox()};
  const std::vector<Entry> list = entries();
  if (!list.empty()) {
    boxes.push_back(legendBox(list));
  }
  return boxes;
}

void ChartFrame::draw(QPainter& painter) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  drawScale(painter);
  drawNorth(painter);
  drawLegend(painter);
  painter.restore();
}

void ChartFrame::drawScale(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  const QRectF box = scaleBox();
  drawPanel(painter, box, colors);
  const QFont font = chartFont(TextSize::Small);
  const QFontMetricsF metrics(font);
  const double metres = scaleBarLength(camera_.metresPerPixel(), kScaleLength, scene_.units);
  const double length = metres / camera_.metresPerPixel();
  const double left = box.left() + kPad + 4.0;
  const double bottom = box.bottom() - 7.0;
  painter.setPen(QPen(colors.text, 1.0));
  for (int quarter = 0; quarter < 4; ++quarter) {
    painter.setBrush(quarter % 2 == 0 ? colors.text : colors.panel);
    painter.drawRect(QRectF(left + 0.25 * quarter * length, bottom - 5.0, 0.25 * length, 5.0));
  }
  painter.setFont(font);
  const double shown = scene_.units.distanceFromSi(metres);
  const auto number = [](double value) { return QString::number(value, 'g', 3); };
  const auto label = [&](double at, const QString& text) {
    painter.drawText(QPointF(at - 0.5 * metrics.horizontalAdvance(text), bottom - 9.0), text);
  };
  label(left, QStringLiteral("0"));
  label(left + 0.5 * length, number(0.5 * shown));
  const QString end = number(shown);
  painter.drawText(QPointF(left + length - 0.5 * metrics.horizontalAdvance(end), bottom - 9.0),
                   QStringLiteral("%1 %2").arg(end, scene_.units.distanceUnit()));
}

void ChartFrame::drawNorth(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  const QRectF box = northBox();
  drawPanel(painter, box, colors);
  const double x = box.center().x();
  const double top = box.top() + 5.0;
  painter.setPen(QPen(colors.text, 1.2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.setBrush(colors.text);
  painter.drawPolygon(QPolygonF{QPointF(x, top), QPointF(x, top + 17.0), QPointF(x - 7.0, top + 21.0)});
  painter.setBrush(colors.panel);
  painter.drawPolygon(QPolygonF{QPointF(x, top), QPointF(x + 7.0, top + 21.0), QPointF(x, top + 17.0)});
  painter.setFont(chartFont(TextSize::Small, true));
  painter.drawText(QRectF(box.left(), top + 20.0, box.width(), 18.0), Qt::AlignCenter, Words::tr("N", "north on the map's arrow"));
}

void ChartFrame::drawLegend(QPainter& painter) const {
  const std::vector<Entry> list = entries();
  if (list.empty()) {
    return;
  }
  const style::ChartColors& colors = scene_.colors();
  const QRectF box = legendBox(list);
  drawPanel(painter, box, colors);
  painter.setFont(chartFont(TextSize::Small));
  double y = box.top() + kPad;
  for (const Entry& entry : list) {
    const bool isScale = entry.sign == Entry::Sign::AltitudeScale;
    const QRectF row(box.left() + kPad, y, box.width() - 2.0 * kPad, rowHeight(isScale));
    painter.setPen(colors.text);
    if (isScale) {
      painter.drawText(row.adjusted(0.0, 0.0, 0.0, kRow - kScaleRow), Qt::AlignLeft | Qt::AlignVCenter, entry.text);
      drawAltitudeScale(painter, row.adjusted(0.0, kRow, 0.0, -4.0));
    } else {
      painter.drawText(row.adjusted(kSignWidth + 8.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, entry.text);
      drawSign(painter, entry, {row.left(), row.top() + 3.0, kSignWidth, kRow - 6.0});
    }
    y += row.height();
  }
}

void ChartFrame::drawAltitudeScale(QPainter& painter, const QRectF& box) const {
  const style::ChartColors& colors = scene_.colors();
  QLinearGradient gradient(box.topLeft(), box.topRight());
  for (int i = 0; i <= 16; ++i) {
    gradient.setColorAt(i / 16.0, style::ChartColors::altitudeScale(i / 16.0));
  }
  const QRectF bar(box.left(), box.top(), box.width(), 9.0);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setPen(colors.mutedText);
  const QRectF text(box.left(), bar.bottom() + 1.0, box.width(), box.height() - 10.0);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop, scene_.units.requiredMsl(safeAltitude_->lowest()));
  painter.drawText(text, Qt::AlignRight | Qt::AlignTop, scene_.units.requiredMsl(safeAltitude_->highest()));
}

void ChartFrame::drawSign(QPainter& painter, const Entry& entry, const QRectF& box) const {
  const style::ChartColors& colors = scene_.colors();
  const double y = box.center().y();
  const auto line = [&](const QPen& pen) {
    painter.setPen(pen);
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
  };
  painter.save();
  switch (entry.sign) {
    case Entry::Sign::NoGlide: {
      QColor veil = colors.text;
      veil.setAlphaF(0.22F);
      painter.fillRect(box, veil);
      QColor ink = colors.text;
      ink.setAlphaF(0.6F);
      painter.fillRect(box, QBrush(ink, Qt::DiagCrossPattern));
      break;
    }
    case Entry::Sign::Reachable: {
      QColor ink = colors.glideAmple;
      ink.setAlphaF(0.16F);
      painter.fillRect(box, ink);
      painter.fillRect(box, QBrush(colors.glideAmple, Qt::FDiagPattern));
      painter.setPen(QPen(colors.glideAmple, 2.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(box.adjusted(1.0, 1.0, -1.0, -1.0));
      break;
    }
    case Entry::Sign::Margin:
      line(QPen(colors.routeCasing, 7.0));
      line(marginPen(entry.margin, colors, 4.0));
      break;
    case Entry::Sign::DecisionPoint:
      line(QPen(colors.route, kSignWidth / 9.0));
      painter.setPen(QPen(colors.textHalo, 1.2));
      painter.setBrush(colors.cursor);
      for (const double at : {0.25, 0.5, 0.75}) {
        painter.drawEllipse(QPointF(box.left() + at * box.width(), y), 2.4, 2.4);
      }
      break;
    case Entry::Sign::SafeLeg:
      line(QPen(colors.route, 3.0));
      break;
    case Entry::Sign::BoundLeg: {
      QPen pen(colors.route, 2.0, Qt::SolidLine, Qt::FlatCap);
      pen.setDashPattern({4.0, 3.0});
      line(pen);
      break;
    }
    case Entry::Sign::Roadmap:
      line(QPen(colors.safeAltitude, 1.0));
      break;
    case Entry::Sign::AltitudeScale:
      break;
  }
  painter.restore();
}

}  // namespace vp::map
