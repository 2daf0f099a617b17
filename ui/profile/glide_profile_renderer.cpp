#include "ui/profile/glide_profile_renderer.h"

#include "ui/profile/tour_curves.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace vp::profile {
namespace {

constexpr double kPad = 6.0;
constexpr double kLeastRange = 60.0;    // m
constexpr double kLeastSurplus = 5.0;   // m, less is not worth a bracket
constexpr double kRunwayPixels = 26.0;  // length of the runway sign at the end of the glide

struct Words {
  Q_DECLARE_TR_FUNCTIONS(GlideProfileRenderer)
};

}  // namespace

GlideProfileRenderer::GlideProfileRenderer(const document::PlanView& plan, const document::EngineOut& glide, ProfileStyle style, const QRectF& area)
    : GlideProfileRenderer(glide, glide.site >= 0 ? &plan.plan().sites[static_cast<std::size_t>(glide.site)].site : nullptr,
                           plan.plan().mission.safety.clearance.si(), std::move(style), area) {}

GlideProfileRenderer::GlideProfileRenderer(const document::EngineOut& glide, const mission::LandingSite* site, double clearance, ProfileStyle style,
                                           const QRectF& area)
    : glide_(glide), site_(site), style_(std::move(style)), font_(scaledFont(tabularFont(style_.font), 0.88)), area_(area), clearance_(clearance) {
  PlotWindow window{0.0, std::max(glide.length, 1.0), glide.from.altitude, glide.from.altitude};
  for (const document::GlidePoint& point : glide.path) {
    window.low = std::min({window.low, point.altitude, std::isfinite(point.ground) ? point.ground : window.low});
    window.high = std::max({window.high, point.altitude, std::isfinite(point.ground) ? point.ground + clearance_ : window.high});
  }
  if (site_ != nullptr) {
    window.low = std::min(window.low, site_->elevation.metres());
  }
  const double range = std::max(window.height(), kLeastRange);
  window.low -= 0.12 * range;
  window.high = window.low + 1.24 * range;
  const QFontMetricsF metrics(font_);
  const QString widest = groupedNumber(style_.units.heightFromSi(window.high), 0);
  const double left = area.left() + kPad +
                      std::max(metrics.horizontalAdvance(widest), metrics.horizontalAdvance(style_.units.heightUnit() + Words::tr(" MSL")) - 20.0) +
                      6.0;
  frame_ = QRectF(QPointF(left, area.top() + metrics.height() + 4.0), QPointF(area.right() - kPad, area.bottom() - metrics.height() - 5.0));
  // room behind the touchdown point for the runway
  scale_ = PlotScale(frame_.adjusted(0.0, 0.0, -kRunwayPixels - 6.0, 0.0), window);
}

void GlideProfileRenderer::paint(QPainter& painter) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font_);
  painter.fillRect(frame_, style_.colors().sky);
  painter.save();
  painter.setClipRect(frame_);
  paintGround(painter);
  painter.restore();
  paintAxes(painter);
  painter.save();
  painter.setClipRect(frame_.adjusted(-6.0, 0.0, 1.0, 0.0));
  paintGlide(painter);
  paintRunway(painter);
  paintLeastClearance(painter);
  painter.restore();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style_.colors().panelBorder, 1.0));
  painter.drawRect(frame_);
  painter.restore();
}

void GlideProfileRenderer::paintGround(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  QPolygonF ground;
  QPolygonF limit;
  const auto flush = [&] {
    if (ground.size() > 1) {
      QPolygonF area = ground;
      area << QPointF(ground.last().x(), frame_.bottom() + 1.0) << QPointF(ground.first().x(), frame_.bottom() + 1.0);
      painter.setPen(Qt::NoPen);
      painter.setBrush(colors.ground);
      painter.drawPolygon(area);
      painter.setPen(QPen(colors.mutedText, 1.0, Qt::DashLine));
      painter.drawPolyline(limit);
    }
    ground.clear();
    limit.clear();
  };
  for (std::size_t i = 0; i < glide_.path.size(); ++i) {
    const document::GlidePoint& point = glide_.path[i];
    const double x = scale_.xOf(point.distance);
    if (std::isfinite(point.ground)) {
      ground << QPointF(x, scale_.yOf(point.ground));
      limit << QPointF(x, scale_.yOf(point.ground + clearance_));
      continue;
    }
    flush();
    const double next = i + 1 < glide_.path.size() ? scale_.xOf(glide_.path[i + 1].distance) : x + 2.0;
    hatchUnknown(painter, QRectF(QPointF(x, frame_.top()), QPointF(next, frame_.bottom())), colors);
  }
  if (!ground.isEmpty() && site_ != nullptr) {  // the runway's ground goes on behind the touchdown point
    ground << QPointF(frame_.right() + 1.0, ground.last().y());
    limit << limit.last();
  }
  flush();
}

void GlideProfileRenderer::paintAxes(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  const style::Units& units = style_.units;
  const QFontMetricsF metrics(font_);
  const PlotWindow& window = scale_.window();
  QColor grid = colors.text;
  grid.setAlpha(30);
  const std::vector<double> heights =
      niceTicks(units.heightFromSi(window.low), units.heightFromSi(window.high), std::max(2, static_cast<int>(frame_.height() / 32.0)));
  for (const double tick : heights) {
    const double y = scale_.yOf(units.heightToSi(tick));
    painter.setPen(QPen(grid, 1.0));
    painter.drawLine(QPointF(frame_.left(), y), QPointF(frame_.right(), y));
    const QString number = groupedNumber(tick, tickDecimals(heights));
    if (y - 0.64 * metrics.ascent() >= frame_.top()) {  // above stands the unit
      painter.setPen(colors.mutedText);
      painter.drawText(QPointF(frame_.left() - 5.0 - metrics.horizontalAdvance(number), y + 0.36 * metrics.ascent()), number);
    }
  }
  painter.setPen(colors.mutedText);
  painter.drawText(QPointF(area_.left() + kPad, frame_.top() - metrics.descent() - 1.0), units.heightUnit() + Words::tr(" MSL"));
  const double base = frame_.bottom() + metrics.ascent() + 2.0;
  const double unitLeft = frame_.right() - metrics.horizontalAdvance(units.distanceUnit());
  painter.drawText(QPointF(unitLeft, base), units.distanceUnit());
  const std::vector<double> distances = niceTicks(0.0, units.distanceFromSi(window.to), std::max(2, static_cast<int>(frame_.width() / 70.0)));
  for (const double tick : distances) {
    const double x = scale_.xOf(units.distanceToSi(tick));
    const QString number = groupedNumber(tick, tickDecimals(distances));
    const double half = 0.5 * metrics.horizontalAdvance(number);
    if (x + half < unitLeft - 4.0) {
      painter.drawText(QPointF(x - half, base), number);
    }
  }
}

void GlideProfileRenderer::paintGlide(QPainter& painter) const {
  QPolygonF line;
  for (const document::GlidePoint& point : glide_.path) {
    line << QPointF(scale_.xOf(point.distance), scale_.yOf(point.altitude));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style_.colors().routeCasing, 4.5, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  // the pattern says the same as the colour: whole with ample margin, dashed with less, dotted below zero
  const double margin = shownMargin(glide_.margin);
  const Qt::PenStyle pattern = margin >= style::ChartColors::kAmpleMargin ? Qt::SolidLine : margin >= 0.0 ? Qt::DashLine : Qt::DotLine;
  painter.setPen(QPen(style_.colors().glide(margin), 2.4, pattern, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  painter.setPen(QPen(style_.colors().cursor, 1.4));
  painter.setBrush(style_.colors().route);
  painter.drawEllipse(line.first(), 4.0, 4.0);
}

void GlideProfileRenderer::paintRunway(QPainter& painter) const {
  if (site_ == nullptr || glide_.path.empty()) {
    return;
  }
  const style::ChartColors& colors = style_.colors();
  const QFontMetricsF metrics(font_);
  const mission::LandingSite& site = *site_;
  const QPointF touchdown(scale_.xOf(glide_.length), scale_.yOf(site.elevation.metres()));
  const QPointF arrival(touchdown.x(), scale_.yOf(glide_.path.back().altitude));
  painter.setPen(QPen(colors.routeCasing, 7.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(touchdown, touchdown + QPointF(kRunwayPixels, 0.0));
  painter.setPen(QPen(colors.runway, 4.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(touchdown, touchdown + QPointF(kRunwayPixels, 0.0));

  QString name = runwayName(site);
  if (glide_.surplus >= kLeastSurplus) {
    painter.setPen(QPen(colors.mutedText, 1.2, Qt::DotLine));
    painter.drawLine(arrival, touchdown);
    name = Words::tr("%1: %2 above on arrival").arg(name, style_.units.margin(glide_.surplus));
  }
  const double width = metrics.horizontalAdvance(name);
  const double right = std::min(touchdown.x() + kRunwayPixels, frame_.right() - 3.0);
  double left = std::max(frame_.left() + 3.0, right - width);
  double base = highestGlideOver(left, left + width) - 8.0;
  if (base - metrics.ascent() < frame_.top() + 2.0) {  // no sky above the glide: below its end
    left = std::max(frame_.left() + 3.0, touchdown.x() - width - 6.0);
    base = std::min(arrival.y() + metrics.height() + 4.0, frame_.bottom() - metrics.descent() - 2.0);
  }
  drawHaloText(painter, QPointF(left, base), name, colors.text, colors.textHalo);
}

double GlideProfileRenderer::highestGlideOver(double left, double right) const {
  double y = frame_.bottom();
  for (const document::GlidePoint& point : glide_.path) {
    const double x = scale_.xOf(point.distance);
    if (x >= left - 8.0 && x <= right + 8.0) {
      y = std::min(y, scale_.yOf(point.altitude));
    }
  }
  return y;
}

void GlideProfileRenderer::paintLeastClearance(QPainter& painter) const {
  if (glide_.path.empty() || !std::isfinite(glide_.leastClearance)) {
    return;
  }
  const style::ChartColors& colors = style_.colors();
  const document::GlidePoint& point = glide_.path[glide_.leastClearanceAt];
  const QPointF top(scale_.xOf(point.distance), scale_.yOf(point.altitude));
  const QPointF bottom(top.x(), scale_.yOf(point.ground));
  const bool low = glide_.leastClearance < clearance_ - 1e-3;
  const QColor color = low ? colors.violation : colors.text;
  painter.setPen(QPen(color, 1.2));
  painter.drawLine(top, bottom);
  drawMark(painter, bottom - QPointF(0.0, 6.0), 9.0, low ? Mark::Warning : Mark::LeastClearance, color, colors.textHalo);
}

}  // namespace vp::profile
