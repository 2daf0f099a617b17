// The layers of the picture; what goes where is decided in profile_renderer.cpp.
#include "ui/profile/profile_renderer.h"
#include "ui/profile/wind_lane.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vp::profile {
namespace {

constexpr double kPad = 8.0;
constexpr double kThinning = 0.15;  // px, not seen

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ProfileRenderer)
};

double groundOf(const document::TourSample& s) {
  return s.state.ground;
}
double corridorOf(const document::TourSample& s) {
  return s.corridor;
}
double pitchOnlyOf(const document::TourSample& s) {
  return s.pitchOnly;
}
double safeOf(const document::TourSample& s) {
  return s.state.safeAltitude;
}
double altitudeOf(const document::TourSample& s) {
  return s.state.altitude;
}

/// Lines in short runs that overlap by one piece: the rasteriser takes ten times as long for one polyline of thousands of points.
void drawLines(QPainter& painter, const std::vector<QPolygonF>& lines) {
  constexpr qsizetype kRun = 48;
  const QPen pen = painter.pen();
  for (const QPolygonF& whole : lines) {
    const QPolygonF line = thinned(whole, kThinning);
    double drawn = 0.0;
    for (qsizetype first = 0; first + 1 < line.size(); first += kRun) {
      const bool dashed = pen.style() != Qt::SolidLine;
      const qsizetype from = dashed ? first : std::max<qsizetype>(0, first - 1);
      const QPolygonF run = line.mid(from, first + kRun + 1 - from);
      if (dashed) {  // the dashes go on where the last run ended
        QPen next = pen;
        next.setDashOffset(drawn / pen.widthF());
        painter.setPen(next);
        for (qsizetype i = 1; i < run.size(); ++i) {
          drawn += std::hypot(run[i].x() - run[i - 1].x(), run[i].y() - run[i - 1].y());
        }
      }
      painter.drawPolyline(run);
    }
  }
  painter.setPen(pen);
}

QPen pitchOnlyPen(const style::ChartColors& colors) {
  return {colors.pitchOnly, 1.2, Qt::DashLine};
}
QPen safePen(const ProfileStyle& style) {
  return {style.colors().safeAltitude, 1.6, style.onPaper ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin};
}

void fillViolation(QPainter& painter, const QPainterPath& path, const QColor& color) {
  QColor fill = color;
  fill.setAlpha(110);
  painter.setPen(QPen(color, 1.0));
  painter.setBrush(fill);
  painter.drawPath(path);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QBrush(color, Qt::BDiagPattern));
  painter.drawPath(path);
}

}  // namespace

struct ProfileRenderer::LegendEntry {
  enum class Kind { Line, Fill, Hatch, Violation, Tick, Wind };
  Kind kind = Kind::Line;
  QString name;
  QPen pen;
  QColor fill = {};
};

void ProfileRenderer::paintFrame(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style_.colors().panelBorder, 1.0));
  painter.drawRect(frame_);
}

/// Boxes where the tour lies over or under an airspace, from floor to ceiling; heights above ground follow the ground.
void ProfileRenderer::paintAirspaces(QPainter& painter) const {
  const std::vector<document::TourSample>& samples = plan_.samples();
  if (situation_.airspaces == nullptr) {
    return;
  }
  painter.save();
  painter.setFont(small_);
  const QFontMetricsF metrics(small_);
  for (const document::ShownAirspace& shown : *situation_.airspaces) {
    const QColor edge = style::ChartColors::airspace(style_.theme, shown.airspace.kind);
    QColor fill = edge;
    fill.setAlpha(shown.use == mission::AirspaceUse::Forbid ? 70 : 35);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      QPolygonF upper;
      QPolygonF lower;
      for (; i < samples.size() && document::isInside(shown, samples[i].state.pose.point()); ++i) {
        const double x = scale_.xOf(samples[i].state.distance);
        upper << QPointF(x, scale_.yOf(document::airspaceTop(shown.airspace, samples[i].state.ground, scale_.window().high)));
        lower << QPointF(x, scale_.yOf(document::airspaceBottom(shown.airspace, samples[i].state.ground, scale_.window().low)));
      }
      if (upper.size() < 2) {
        continue;
      }
      std::reverse(lower.begin(), lower.end());
      painter.setPen(QPen(edge, shown.use == mission::AirspaceUse::Show ? 0.8 : 1.6, Qt::DashLine));
      painter.setBrush(fill);
      painter.drawPolygon(upper + lower);
      const QString name = QString::fromStdString(shown.airspace.kind + " " + shown.airspace.name);
      if (metrics.horizontalAdvance(name) + 8.0 < upper.back().x() - upper.front().x()) {
        painter.drawText(QPointF(upper.front().x() + 4.0, std::max(upper.front().y(), scale_.area().top()) + metrics.ascent() + 2.0), name);
      }
    }
  }
  painter.restore();
}

void ProfileRenderer::paintTerrain(QPainter& painter, double column) const {
  const style::ChartColors& colors = style_.colors();
  painter.fillPath(areaBelow(upperEdgeOf(plan_.samples(), corridorOf, scale_, column), scale_), colors.corridor);
  const std::vector<QPolygonF> ground = upperEdgeOf(plan_.samples(), groundOf, scale_, column);
  painter.fillPath(areaBelow(ground, scale_), colors.ground);
  painter.setPen(QPen(colors.ground.darker(135), 1.0));
  drawLines(painter, ground);
  for (const Stretch& stretch : unknown_) {
    const double left = scale_.xOf(stretch.from);
    const double right = std::max(scale_.xOf(stretch.to), left + 2.0);
    hatchUnknown(painter, QRectF(QPointF(left, scale_.area().top()), QPointF(right, scale_.area().bottom())), colors);
  }
}

void ProfileRenderer::paintAxes(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  const style::Units& units = style_.units;
  const QFontMetricsF metrics(small_);
  painter.setFont(small_);
  QColor grid = colors.text;
  grid.setAlpha(style_.theme == style::Theme::Light ? 28 : 34);
  for (const double tick : altitudeTicks_) {
    const double y = scale_.yOf(units.heightToSi(tick));
    if (y < scale_.area().top() - 0.5 || y > scale_.area().bottom() + 0.5) {
      continue;
    }
    painter.setPen(QPen(grid, 1.0));
    painter.drawLine(QPointF(frame_.left(), y), QPointF(frame_.right(), y));
    const QString number = groupedNumber(tick, tickDecimals(altitudeTicks_));
    painter.setPen(colors.mutedText);
    painter.drawText(QPointF(frame_.left() - 6.0 - metrics.horizontalAdvance(number), y + 0.36 * metrics.ascent()), number);
  }
  const QString datum = units.heightUnit() + Words::tr(" MSL");
  painter.drawText(QPointF(kPad, frame_.top() - metrics.descent() - 2.0), datum);

  const double base = frame_.bottom() + metrics.ascent() + 3.0;
  const QString unit = units.distanceUnit();
  const double unitLeft = frame_.right() - metrics.horizontalAdvance(unit);
  painter.drawText(QPointF(unitLeft, base), unit);
  for (const double tick : distanceTicks_) {
    const double x = scale_.xOf(units.distanceToSi(tick));
    painter.setPen(QPen(grid, 1.0));
    painter.drawLine(QPointF(x, scale_.area().top()), QPointF(x, frame_.bottom()));
    const QString number = groupedNumber(tick, tickDecimals(distanceTicks_));
    const double half = 0.5 * metrics.horizontalAdvance(number);
    if (x + half < unitLeft - 6.0) {
      painter.setPen(colors.mutedText);
      painter.drawText(QPointF(x - half, base), number);
    }
  }
}

void ProfileRenderer::paintCurves(QPainter& painter, double column) const {
  const style::ChartColors& colors = style_.colors();
  painter.setBrush(Qt::NoBrush);
  if (!style_.onPaper) {
    painter.setPen(pitchOnlyPen(colors));
    drawLines(painter, curveOf(plan_.samples(), pitchOnlyOf, scale_, column));
  }
  painter.setPen(safePen(style_));
  drawLines(painter, curveOf(plan_.samples(), safeOf, scale_, column));
  paintViolations(painter);
  const std::vector<QPolygonF> tour = curveOf(plan_.samples(), altitudeOf, scale_, column);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.routeCasing, 5.0, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
  drawLines(painter, tour);
  painter.setPen(QPen(isDimmed() ? colors.routeOutdated : colors.route, 2.6, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
  drawLines(painter, tour);
  paintSpirals(painter);
  if (showsDecisionPoints()) {
    paintDecisionPoints(painter);
  }
}

void ProfileRenderer::paintViolations(QPainter& painter) const {
  const QPainterPath path = violatedArea(plan_, scale_);
  if (path.isEmpty()) {
    return;
  }
  fillViolation(painter, path, style_.colors().violation);
  // a bar along the axis: seen also where the area is thinner than a pixel
  painter.setPen(Qt::NoPen);
  painter.setBrush(style_.colors().violation);
  for (const Stretch& stretch : violations_) {
    const double left = scale_.xOf(stretch.from);
    painter.drawRect(QRectF(left - 1.0, scale_.area().bottom() - 5.0, std::max(3.0, scale_.xOf(stretch.to) - left + 2.0), 5.0));
  }
}

void ProfileRenderer::paintDecisionPoints(QPainter& painter) const {
  painter.setPen(QPen(style_.colors().cursor, 1.0));
  for (std::size_t i = 0; i < plan_.plan().tour.size(); ++i) {
    const double distance = plan_.distanceOf(i);
    if (distance >= scale_.window().from && distance <= scale_.window().to) {
      const QPointF p(scale_.xOf(distance), scale_.yOf(plan_.plan().tour[i].altitude));
      painter.drawLine(p + QPointF(0.0, -4.0), p + QPointF(0.0, 4.0));
    }
  }
}

void ProfileRenderer::paintSpirals(QPainter& painter) const {
  constexpr double kHalf = 5.0;
  constexpr double kWave = 6.0;
  for (const mission::SpiralVisit& spiral : plan_.plan().spirals) {
    const std::optional<double> distance = plan_.distanceOfTarget(spiral.target);
    if (!distance) {
      continue;
    }
    const double x = scale_.xOf(*distance);
    QPolygonF zigzag;
    const double top = scale_.yOf(spiral.top);
    const int waves = static_cast<int>((scale_.yOf(spiral.bottom) - top) / kWave);
    for (int i = 0; i <= waves; ++i) {
      zigzag << QPointF(x + (i % 2 == 0 ? kHalf : -kHalf), top + i * kWave);
    }
    zigzag << QPointF(x, scale_.yOf(spiral.bottom));
    painter.setPen(QPen(isDimmed() ? style_.colors().routeOutdated : style_.colors().route, 1.6));
    painter.drawPolyline(zigzag);
  }
}

void ProfileRenderer::paintTargets(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  const QFontMetricsF metrics(small_);
  painter.setFont(small_);
  for (const TargetLabel& label : labels_) {
    const mission::TargetInFrame& target = plan_.plan().targets[static_cast<std::size_t>(label.target)];
    const double x = scale_.xOf(label.distance);
    const QPointF top(x, scale_.yOf(target.altitude));
    const double ground = plan_.at(label.distance).ground;
    painter.save();
    painter.setClipRect(scale_.area().adjusted(-8.0, -8.0, 8.0, 0.0));
    painter.setPen(QPen(colors.target, 2.0));
    painter.drawLine(QPointF(x, scale_.yOf(std::isfinite(ground) ? ground : scale_.window().low)), top);
    painter.setPen(QPen(colors.routeCasing, 1.2));
    painter.setBrush(colors.target);
    painter.drawRect(QRectF(top - QPointF(3.5, 3.5), QSizeF(7.0, 7.0)));
    painter.restore();
    if (label.lane >= 0) {
      const double base = frame_.top() + 2.0 + label.lane * metrics.height() + metrics.ascent();
      QColor leader = colors.target;
      leader.setAlpha(110);
      painter.setPen(QPen(leader, 1.0, Qt::DotLine));
      painter.drawLine(QPointF(x, base + metrics.descent()), QPointF(x, std::max(scale_.area().top(), top.y() - 4.0)));
      painter.setPen(colors.target);
      const double half = 0.5 * metrics.horizontalAdvance(label.name);
      painter.drawText(QPointF(label.x - half, base), label.name);
    }
  }
}

void ProfileRenderer::paintMarks(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  for (const ProfileFact& fact : facts_) {
    const document::TourState state = plan_.at(fact.distance);
    const double x = scale_.xOf(fact.distance);
    const QColor color = fact.isViolated ? colors.violation : colors.text;
    // the clearance is marked below the tour, the margin above it, so that both can stand at one place
    const bool onGround = fact.mark == Mark::HighestGround && std::isfinite(state.ground);
    const double offset = fact.mark == Mark::LeastClearance ? 13.0 : -13.0;
    const double y = std::clamp(onGround ? scale_.yOf(state.ground) + 11.0 : scale_.yOf(state.altitude) + offset, scale_.area().top() + 6.0,
                                scale_.area().bottom() - 6.0);
    drawMark(painter, QPointF(x, y), 10.0, fact.mark, color, colors.textHalo);
  }
}

void ProfileRenderer::paintWind(QPainter& painter) const {
  const QRectF area = scale_.area();
  paintWindLane(painter, QRectF(area.left(), area.top() - kWindLane, area.width(), kWindLane), scale_, plan_, style_);
}

void ProfileRenderer::paintStrip(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  const QFontMetricsF metrics(font_);
  painter.setFont(font_);
  for (const ProfileFact& fact : facts_) {
    const QColor color = fact.isViolated ? colors.violation : colors.text;
    const double middle = fact.rect.center().y();
    const Mark mark = fact.isViolated ? Mark::Warning : fact.mark;
    drawMark(painter, QPointF(fact.rect.left() + 8.0, middle), 11.0, mark, color, colors.panel);
    painter.setPen(color);
    painter.drawText(QPointF(fact.rect.left() + 20.0, middle + 0.5 * (metrics.ascent() - metrics.descent())),
                     metrics.elidedText(fact.text, Qt::ElideRight, fact.rect.width() - 20.0));
  }
  for (const Badge& badge : badges_) {
    painter.setPen(QPen(colors.glideTight, 1.4));
    painter.setBrush(colors.panel);
    painter.drawRoundedRect(badge.rect, 3.0, 3.0);
    drawMark(painter, QPointF(badge.rect.left() + 13.0, badge.rect.center().y()), 11.0, Mark::Warning, colors.glideTight, colors.panel);
    painter.setPen(colors.text);
    painter.drawText(badge.rect.adjusted(24.0, 0.0, 0.0, 0.0), static_cast<int>(Qt::AlignVCenter) | static_cast<int>(Qt::AlignLeft), badge.text);
  }
}

std::vector<ProfileRenderer::LegendEntry> ProfileRenderer::legend() const {
  using Kind = LegendEntry::Kind;
  const style::ChartColors& colors = style_.colors();
  std::vector<LegendEntry> entries{
      {Kind::Line, Words::tr("Tour"), QPen(isDimmed() ? colors.routeOutdated : colors.route, 2.6)},
      {Kind::Line, Words::tr("Lowest safe altitude"), safePen(style_)},
      {Kind::Fill, Words::tr("Terrain below"), QPen(colors.ground.darker(135), 1.0), colors.ground},
      {Kind::Fill, Words::tr("Highest within %1 m").arg(document::PlanView::kCorridor, 0, 'f', 0), QPen(Qt::NoPen), colors.corridor},
  };
  if (!style_.onPaper) {
    entries.insert(entries.begin() + 2, {Kind::Line, Words::tr("Pitch limits only"), pitchOnlyPen(colors)});
  }
  if (showsDecisionPoints() || !style_.onPaper) {
    entries.push_back(
        {Kind::Tick, showsDecisionPoints() ? Words::tr("Decision points") : Words::tr("Decision points: zoom in"), QPen(colors.cursor, 1.0)});
  }
  if (hasWind_) {
    entries.push_back({Kind::Wind, Words::tr("Wind on course, tail to the right"), QPen(colors.mutedText)});
  }
  if (!violations_.empty()) {
    entries.push_back({Kind::Violation, Words::tr("Too low"), QPen(colors.violation), colors.violation});
  }
  if (!unknown_.empty()) {
    entries.push_back({Kind::Hatch, Words::tr("Unknown terrain"), QPen(Qt::NoPen)});
  }
  return entries;
}

double ProfileRenderer::legendHeight(double width) const {
  const QFontMetricsF metrics(small_);
  double x = 0.0;
  int rows = 1;
  for (const LegendEntry& entry : legend()) {
    const double needed = 24.0 + metrics.horizontalAdvance(entry.name) + 14.0;
    if (x > 0.0 && x + needed > width) {
      ++rows;
      x = 0.0;
    }
    x += needed;
  }
  return rows * (metrics.height() + 2.0);
}

void ProfileRenderer::paintLegend(QPainter& painter) const {
  const style::ChartColors& colors = style_.colors();
  const QFontMetricsF metrics(small_);
  painter.setFont(small_);
  double x = kPad;
  double y = legendTop_;
  for (const LegendEntry& entry : legend()) {
    const double needed = 24.0 + metrics.horizontalAdvance(entry.name) + 14.0;
    if (x > kPad && x + needed > size_.width() - kPad) {
      x = kPad;
      y += metrics.height() + 2.0;
    }
    const QRectF sample(x, y + 0.5 * metrics.height() - 5.0, 18.0, 10.0);
    painter.setPen(entry.pen);
    painter.setBrush(Qt::NoBrush);
    switch (entry.kind) {
      case LegendEntry::Kind::Line:
        painter.drawLine(QPointF(sample.left(), sample.center().y()), QPointF(sample.right(), sample.center().y()));
        break;
      case LegendEntry::Kind::Fill:
        painter.setBrush(entry.fill);
        painter.drawRect(sample);
        break;
      case LegendEntry::Kind::Hatch:
        hatchUnknown(painter, sample, colors);
        break;
      case LegendEntry::Kind::Violation: {
        QPainterPath path;
        path.addRect(sample);
        fillViolation(painter, path, entry.fill);
        break;
      }
      case LegendEntry::Kind::Wind:
        paintWindArrow(painter, sample.center(), {1.0, 0.0}, entry.pen.color());
        break;
      case LegendEntry::Kind::Tick:
        for (const double at : {3.0, 9.0, 15.0}) {
          painter.drawLine(QPointF(sample.left() + at, sample.top() + 1.0), QPointF(sample.left() + at, sample.bottom() - 1.0));
        }
        break;
    }
    painter.setPen(colors.mutedText);
    painter.drawText(QPointF(sample.right() + 6.0, y + metrics.ascent()), entry.name);
    x += needed;
  }
}

}  // namespace vp::profile
