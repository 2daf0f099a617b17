#include "ui/map/chart_legend.h"

#include "ui/map/area_layer.h"
#include "ui/map/margin_pattern.h"
#include "ui/map/tour_lines.h"
#include "ui/map/words.h"

#include <QFontMetricsF>
#include <QLinearGradient>

#include <algorithm>
#include <numeric>

namespace vp::map {
namespace {

constexpr double kPad = 9.0;
constexpr double kSignWidth = 34.0;
constexpr double kSignHeight = 12.0;
constexpr double kBesideSign = 8.0;
constexpr double kRow = 18.0;      // at least
constexpr double kBetween = 3.0;   // at least, between the lines of two rows
constexpr double kColorBar = 9.0;  // height of the altitude scale
constexpr double kBelowScale = 4.0;
constexpr double kLeastWidth = 210.0;
constexpr double kApart = 10.0;  // between the two numbers below the altitude scale

QFont legendFont() {
  return chartFont(TextSize::Small);
}

/// Whether a row is a scale of colours below its text, and not a sign beside it.
template <typename Row>
bool isScaleRow(const Row& row) {
  return row.sign == Row::Sign::AltitudeScale || row.sign == Row::Sign::PopulationScale;
}

double besideSign(bool isScale) {
  return isScale ? 0.0 : kSignWidth + kBesideSign;
}

}  // namespace

ChartLegend::ChartLegend(const MapScene& scene, const MapCamera& camera, const SafeAltitudeLayer* safeAltitude, double maxWidth)
    : scene_(scene), safeAltitude_(safeAltitude) {
  if (scene.options.legend) {
    addSafeAltitude();
    addAreas();
    addMargins();
    addTour(camera);
    measure(maxWidth);
  }
}

void ChartLegend::add(Group group) {
  if (!group.empty()) {
    groups_.push_back(std::move(group));
  }
}

QString ChartLegend::courseText() const {
  return scene_.options.safeAltitudeCourse ? Words::tr("on course %1").arg(style::Units::course(*scene_.options.safeAltitudeCourse))
                                           : Words::tr("on the worst course");
}

void ChartLegend::addSafeAltitude() {
  const MapOptions& options = scene_.options;
  if (safeAltitude_ == nullptr) {
    return;
  }
  Group group;
  if (options.safeAltitude) {
    if (!safeAltitude_->isEmpty()) {
      group.push_back({Row::Sign::AltitudeScale, Words::tr("Lowest safe altitude %1, %2 MSL").arg(courseText(), scene_.units.heightUnit())});
    }
    group.push_back({Row::Sign::NoGlide, Words::tr("No glide from any altitude")});
  }
  if (options.reachableFrom) {
    group.push_back({Row::Sign::Reachable, Words::tr("Runway reachable from %1").arg(scene_.units.altitudeMsl(*options.reachableFrom))});
  }
  add(std::move(group));
}

void ChartLegend::addMargins() {
  using Colors = style::ChartColors;
  const MapOptions& options = scene_.options;
  const document::Situation& now = scene_.situation;
  const bool isShown = now.plan != nullptr && ((options.tourMargin && now.planIsCurrent) || options.allGlides || scene_.cursor);
  if (!isShown) {
    return;
  }
  const QString ample = scene_.units.height(Colors::kAmpleMargin);
  Group group{{Row::Sign::Margin, Words::tr("Glide margin %1 or more").arg(ample), Colors::kAmpleMargin},
              {Row::Sign::Margin, Words::tr("less than %1").arg(ample), 0.5 * (kTightMargin + Colors::kAmpleMargin)},
              {Row::Sign::Margin, Words::tr("less than %1").arg(scene_.units.height(kTightMargin)), 0.0}};
  if (marginClass(now.plan->leastGlideMargin().state.glideMargin()) == MarginClass::Violated) {
    group.push_back({Row::Sign::Margin, Words::tr("none: no glide arrives"), -1.0});
  }
  add(std::move(group));
}

void ChartLegend::addAreas() {
  const document::Situation& now = scene_.situation;
  if (scene_.options.weather && now.weather != nullptr) {
    add({{Row::Sign::Weather, Words::tr("Weather: the closer the lines, the less likely to come through"), 0.9}});
  }
  if (scene_.options.population && now.population != nullptr) {
    add({{Row::Sign::PopulationScale, Words::tr("People per km²")}});
  }
}

void ChartLegend::addTour(const MapCamera& camera) {
  const document::Situation& now = scene_.situation;
  if (scene_.options.decisionPoints && now.plan != nullptr) {
    const double spacing = now.plan->length() / static_cast<double>(now.plan->plan().tour.size());
    add({{Row::Sign::DecisionPoint,
          spacing / camera.metresPerPixel() < kDotSpacing ? Words::tr("Decision points, not all at this scale") : Words::tr("Decision points")}});
  }
  if (now.sketch != nullptr && now.sketch->tour != nullptr) {
    add({{Row::Sign::SafeLeg, Words::tr("Leg proved safe")}, {Row::Sign::BoundLeg, Words::tr("Leg not yet checked")}});
  }
  if (now.sketch != nullptr && now.sketch->roadmap != nullptr) {
    add({{Row::Sign::Roadmap, Words::tr("Glides to the runways")}});
  }
}

void ChartLegend::measure(double maxWidth) {
  const QFontMetricsF metrics(legendFont());
  width_ = kLeastWidth;
  for (const Group& group : groups_) {
    for (const Row& row : group) {
      width_ = std::max(width_, metrics.horizontalAdvance(row.text) + 2.0 * kPad + besideSign(isScaleRow(row)));
      if (row.sign == Row::Sign::AltitudeScale) {
        width_ = std::max(width_, 2.0 * kPad + kApart + metrics.horizontalAdvance(scene_.units.requiredMsl(safeAltitude_->lowest())) +
                                      metrics.horizontalAdvance(scene_.units.requiredMsl(safeAltitude_->highest())));
      }
    }
  }
  width_ = std::min(width_, maxWidth);
  for (Group& group : groups_) {
    for (Row& row : group) {
      const double room = width_ - 2.0 * kPad - besideSign(isScaleRow(row));
      const QStringList lines = brokenLines(row.text, legendFont(), room);
      row.text = lines.join(QLatin1Char('\n'));
      row.textHeight = std::max(kRow, metrics.lineSpacing() * static_cast<double>(lines.size()) + kBetween);
    }
  }
}

double ChartLegend::padding() {
  return 2.0 * kPad;
}

double ChartLegend::heightOf(const Row& row) {
  const double numbers = std::max(kRow - kBetween, QFontMetricsF(legendFont()).height());
  return row.textHeight + (isScaleRow(row) ? kColorBar + numbers + kBelowScale : 0.0);
}

std::vector<double> ChartLegend::groupHeights() const {
  std::vector<double> heights;
  for (const Group& group : groups_) {
    heights.push_back(std::accumulate(group.begin(), group.end(), 0.0, [](double sum, const Row& row) { return sum + heightOf(row); }));
  }
  return heights;
}

void ChartLegend::draw(QPainter& painter, const QRectF& box, std::size_t groups) const {
  drawPanel(painter, box, scene_.colors());
  painter.setFont(legendFont());
  double y = box.top() + kPad;
  for (std::size_t i = 0; i < groups; ++i) {
    for (const Row& row : groups_[i]) {
      drawRow(painter, row, {box.left() + kPad, y, box.width() - 2.0 * kPad, heightOf(row)});
      y += heightOf(row);
    }
  }
}

void ChartLegend::drawRow(QPainter& painter, const Row& row, const QRectF& box) const {
  painter.setPen(scene_.colors().text);
  const bool isScale = isScaleRow(row);
  painter.drawText(QRectF(box.left() + besideSign(isScale), box.top(), box.width() - besideSign(isScale), row.textHeight),
                   Qt::AlignLeft | Qt::AlignVCenter, row.text);
  if (isScale) {
    const QRectF scale = box.adjusted(0.0, row.textHeight, 0.0, -kBelowScale);
    row.sign == Row::Sign::AltitudeScale ? drawAltitudeScale(painter, scale) : drawPopulationScale(painter, scale);
  } else {
    drawSign(painter, row, {box.left(), box.center().y() - 0.5 * kSignHeight, kSignWidth, kSignHeight});
  }
}

void ChartLegend::drawAltitudeScale(QPainter& painter, const QRectF& box) const {
  const style::ChartColors& colors = scene_.colors();
  QLinearGradient gradient(box.topLeft(), box.topRight());
  for (int i = 0; i <= 16; ++i) {
    gradient.setColorAt(i / 16.0, style::ChartColors::altitudeScale(i / 16.0));
  }
  const QRectF bar(box.left(), box.top(), box.width(), kColorBar);
  painter.setPen(QPen(colors.panelBorder, 1.0));
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setPen(colors.mutedText);
  const QRectF text(box.left(), bar.bottom() + 1.0, box.width(), box.height() - kColorBar - 1.0);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop, scene_.units.requiredMsl(safeAltitude_->lowest()));
  painter.drawText(text, Qt::AlignRight | Qt::AlignTop, scene_.units.requiredMsl(safeAltitude_->highest()));
}

/// The classes side by side, each with its lower limit below its left edge.
void ChartLegend::drawPopulationScale(QPainter& painter, const QRectF& box) const {
  const style::ChartColors& colors = scene_.colors();
  const double part = box.width() / static_cast<double>(PopulationLayer::kClasses.size());
  for (std::size_t i = 0; i < PopulationLayer::kClasses.size(); ++i) {
    const QRectF field(box.left() + static_cast<double>(i) * part, box.top(), part, kColorBar);
    painter.setPen(QPen(colors.panelBorder, 1.0));
    painter.setBrush(PopulationLayer::colorOf(static_cast<int>(i), scene_.theme));
    painter.drawRect(field);
    painter.setPen(colors.mutedText);
    painter.drawText(QRectF(field.left(), field.bottom() + 1.0, part, box.height() - kColorBar - 1.0), Qt::AlignLeft | Qt::AlignTop,
                     QStringLiteral("%1+").arg(PopulationLayer::kClasses[i]));
  }
}

void ChartLegend::drawSign(QPainter& painter, const Row& row, const QRectF& box) const {
  const style::ChartColors& colors = scene_.colors();
  const double y = box.center().y();
  const auto line = [&](const QPen& pen) {
    painter.setPen(pen);
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
  };
  painter.save();
  switch (row.sign) {
    case Row::Sign::NoGlide: {
      QColor veil = colors.text;
      veil.setAlphaF(0.22F);
      painter.fillRect(box, veil);
      QColor ink = colors.text;
      ink.setAlphaF(0.6F);
      painter.fillRect(box, QBrush(ink, Qt::DiagCrossPattern));
      break;
    }
    case Row::Sign::Reachable: {
      QColor ink = colors.glideAmple;
      ink.setAlphaF(0.16F);
      painter.fillRect(box, ink);
      painter.fillRect(box, QBrush(colors.glideAmple, Qt::FDiagPattern));
      painter.setPen(QPen(colors.glideAmple, 2.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(box.adjusted(1.0, 1.0, -1.0, -1.0));
      break;
    }
    case Row::Sign::Margin:
      line(QPen(colors.routeCasing, 7.0));
      line(marginPen(row.margin, colors, 4.0));
      break;
    case Row::Sign::DecisionPoint:
      line(QPen(colors.route, kSignWidth / 9.0));
      painter.setPen(QPen(colors.textHalo, 1.2));
      painter.setBrush(colors.cursor);
      for (const double at : {0.25, 0.5, 0.75}) {
        painter.drawEllipse(QPointF(box.left() + at * box.width(), y), 2.4, 2.4);
      }
      break;
    case Row::Sign::SafeLeg:
      line(QPen(colors.route, 3.0));
      break;
    case Row::Sign::BoundLeg: {
      QPen pen(colors.route, 2.0, Qt::SolidLine, Qt::FlatCap);
      pen.setDashPattern({4.0, 3.0});
      line(pen);
      break;
    }
    case Row::Sign::Roadmap:
      line(QPen(colors.safeAltitude, 1.0));
      break;
    case Row::Sign::Weather: {
      QColor ink = colors.weather;
      ink.setAlphaF(0.16F);
      painter.fillRect(box, ink);
      ink.setAlphaF(0.75F);
      painter.setBrushOrigin(box.topLeft());
      painter.fillRect(box, weatherHatch(row.margin, ink, 1.0));
      painter.setPen(QPen(colors.weather, 2.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(box.adjusted(1.0, 1.0, -1.0, -1.0));
      break;
    }
    case Row::Sign::AltitudeScale:
    case Row::Sign::PopulationScale:
      break;
  }
  painter.restore();
}

}  // namespace vp::map
