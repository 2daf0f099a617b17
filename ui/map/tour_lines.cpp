#include "ui/map/tour_lines.h"

#include "core/flight/curve_sampling.h"
#include "ui/map/margin_pattern.h"
#include "ui/map/screen_lines.h"
#include "ui/map/site_marks.h"
#include "ui/map/words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::map {
namespace {

constexpr double kBorder = 40.0;          // px around the view
constexpr double kArrowSpacing = 110.0;   // px
constexpr double kAvoided = 8.0;          // px, side of the boxes along the tour that labels keep off
constexpr double kMarkSpacing = 520.0;    // px
constexpr double kMarginShade = 25.0;     // m of margin drawn in one colour
constexpr double kHomeWidth = 2.6;        // px
constexpr double kHomeStep = 15.0;        // m between points of the ways from and to home
constexpr double kWhileSketching = 0.35;  // opacity of the plan that is being replaced

void drawLines(QPainter& painter, const std::vector<ScreenLine>& lines, QPen pen) {
  for (const ScreenLine& line : lines) {
    pen.setDashOffset(pen.style() == Qt::SolidLine ? 0.0 : line.start / pen.widthF());
    painter.setPen(pen);
    painter.drawPolyline(line.points);
  }
}

void drawCased(QPainter& painter, const std::vector<ScreenLine>& lines, const QPen& pen, const QColor& casing) {
  drawLines(painter, lines, QPen(casing, pen.widthF() + 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  drawLines(painter, lines, pen);
}

/// An aircraft seen from above. @param angle  radians, clockwise from pointing right
void drawAircraft(QPainter& painter, QPointF at, double angle, const style::ChartColors& colors) {
  static const QPolygonF kHalf{{15.0, 0.0},  {13.0, -1.6}, {5.0, -2.2},  {3.0, -14.0},  {-1.2, -14.0},
                               {-1.6, -2.0}, {-8.6, -1.3}, {-9.6, -5.6}, {-12.2, -5.6}, {-12.0, 0.0}};
  QPolygonF other = kHalf;
  std::reverse(other.begin(), other.end());
  QPolygonF shape = kHalf;
  for (const QPointF& point : other) {
    shape.push_back({point.x(), -point.y()});
  }
  painter.save();
  painter.translate(at);
  painter.rotate(angle * 57.29577951308232);
  painter.setBrush(colors.cursor);
  painter.setPen(QPen(colors.textHalo, 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(shape);
  painter.setPen(QPen(colors.cursor, 0.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(shape);
  painter.restore();
}

std::vector<ScreenLine> glideLines(const document::EngineOut& glide, const MapCamera& camera) {
  std::vector<geo::Point> path;
  path.reserve(glide.path.size());
  for (const document::GlidePoint& point : glide.path) {
    path.push_back(point.pose.point());
  }
  return screenLines(path, camera, kBorder);
}

/// From point `first` on, arcs in chords.
std::vector<geo::Point> homeLine(const mission::HomePath& path, std::size_t first) {
  std::vector<geo::Point> points;
  for (std::size_t i = first; i < path.points.size(); ++i) {
    const mission::DecisionPoint& point = path.points[i];
    for (const geo::Pose& pose : flight::sample({point.pose, {point.onward}, {}}, kHomeStep, 1.0)) {
      points.push_back(pose.point());
    }
  }
  return points;
}

}  // namespace

std::vector<geo::Point> TourLines::line() const {
  std::vector<geo::Point> points;
  for (const document::TourSample& sample : scene_.situation.plan->samples()) {
    points.push_back(sample.state.pose.point());
  }
  return points;
}

void TourLines::draw(QPainter& painter) const {
  if (scene_.situation.plan == nullptr) {
    return;
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  if (scene_.situation.sketch != nullptr && scene_.situation.sketch->tour != nullptr) {
    painter.setOpacity(kWhileSketching);
  }
  drawHomePaths(painter);
  if (scene_.options.tourMargin && scene_.situation.planIsCurrent) {
    drawByMargin(painter);
  } else {
    drawPlain(painter);
  }
  drawSpirals(painter);
  drawArrows(painter);
  if (scene_.options.decisionPoints) {
    drawDecisionPoints(painter);
  }
  painter.restore();
}

void TourLines::avoidLabels(LabelPlacer& labels) const {
  if (scene_.situation.plan == nullptr) {
    return;
  }
  for (const ScreenLine& part : screenLines(line(), camera_, 0.0)) {
    for (const LineMark& mark : marksAlong(part, kAvoided)) {
      labels.avoid(QRectF(mark.at.x() - 0.5 * kAvoided, mark.at.y() - 0.5 * kAvoided, kAvoided, kAvoided));
    }
  }
}

void TourLines::drawPlain(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  QPen pen(colors.route, kTourWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (!scene_.situation.planIsCurrent) {
    pen = QPen(colors.routeOutdated, kTourWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({3.0, 2.0});
  }
  drawCased(painter, screenLines(line(), camera_, kBorder), pen, colors.routeCasing);
}

void TourLines::drawByMargin(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  const std::vector<document::TourSample>& samples = scene_.situation.plan->samples();
  drawLines(painter, screenLines(line(), camera_, kBorder), QPen(colors.routeCasing, kTourWidth + 5.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  drawLines(painter, screenLines(line(), camera_, kBorder), QPen(colors.route, 1.2));
  const auto shadeOf = [&](std::size_t i) {
    const double margin = shownMargin(samples[i].state.glideMargin());
    return marginClass(margin) == MarginClass::Ample || margin < 0.0 ? static_cast<double>(marginClass(margin)) * 1e4
                                                                     : std::floor(margin / kMarginShade);
  };
  for (std::size_t i = 0; i + 1 < samples.size();) {
    std::vector<geo::Point> stretch{samples[i].state.pose.point()};
    double least = samples[i].state.glideMargin();
    const double shade = shadeOf(i);
    std::size_t k = i;
    while (k + 1 < samples.size() && shadeOf(k) == shade) {
      least = std::min(least, samples[k].state.glideMargin());
      stretch.push_back(samples[++k].state.pose.point());
    }
    drawLines(painter, screenLines(stretch, camera_, kBorder), marginPen(least, colors, kTourWidth + 2.0));
    i = k;
  }
}

/// The ways from and to the home runway: thinner than the tour, dotted where no glide is guaranteed yet.
void TourLines::drawHomePaths(QPainter& painter) const {
  const mission::Plan& plan = scene_.situation.plan->plan();
  const style::ChartColors& colors = scene_.colors();
  const QColor ink = scene_.situation.planIsCurrent ? colors.route : colors.routeOutdated;
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    if (!*path) {
      continue;
    }
    const auto guaranteed = static_cast<std::size_t>((*path)->guaranteed);
    const std::vector<geo::Point> whole = homeLine(**path, 0);
    QPen dotted(ink, kHomeWidth, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    dotted.setDashPattern({1.0, 1.2});
    drawLines(painter, screenLines(whole, camera_, kBorder), QPen(colors.routeCasing, kHomeWidth + 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    drawLines(painter, screenLines(whole, camera_, kBorder), dotted);
    drawLines(painter, screenLines(homeLine(**path, guaranteed), camera_, kBorder),
              QPen(ink, kHomeWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(colors.textHalo);
    painter.setPen(QPen(ink, 2.0));
    painter.drawEllipse(camera_.toScreen((*path)->points[guaranteed > 0 ? guaranteed : (*path)->points.size() - 1].pose.point()), 5.0, 5.0);
    painter.setBrush(Qt::NoBrush);
  }
}

void TourLines::drawArrows(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  painter.setPen(QPen(colors.routeCasing, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  painter.setBrush(scene_.situation.planIsCurrent ? colors.route : colors.routeOutdated);
  const std::array shape{QPointF(8.0, 0.0), QPointF(-5.0, -6.0), QPointF(-2.0, 0.0), QPointF(-5.0, 6.0)};
  for (const ScreenLine& part : screenLines(line(), camera_, kBorder)) {
    for (const LineMark& mark : marksAlong(part, kArrowSpacing)) {
      const double c = std::cos(mark.angle);
      const double s = std::sin(mark.angle);
      QPolygonF arrow;
      for (const QPointF& p : shape) {
        arrow.push_back(mark.at + QPointF(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
      }
      painter.drawPolygon(arrow);
    }
  }
  painter.setBrush(Qt::NoBrush);
}

void TourLines::drawDecisionPoints(QPainter& painter) const {
  const style::ChartColors& colors = scene_.colors();
  painter.setPen(QPen(colors.textHalo, 1.2));
  painter.setBrush(colors.cursor);
  QPointF last(-1e9, -1e9);
  for (const mission::DecisionPoint& point : scene_.situation.plan->plan().tour) {
    const QPointF at = camera_.toScreen(point.pose.point());
    if (camera_.screen().adjusted(-kBorder, -kBorder, kBorder, kBorder).contains(at) && (at - last).manhattanLength() >= kDotSpacing) {
      painter.drawEllipse(at, 2.4, 2.4);
      last = at;
    }
  }
  painter.setBrush(Qt::NoBrush);
}

void TourLines::drawSpirals(QPainter& painter) const {
  const mission::Plan& plan = scene_.situation.plan->plan();
  const style::ChartColors& colors = scene_.colors();
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    const std::optional<double> at = scene_.situation.plan->distanceOfTarget(spiral.target);
    if (!at) {
      continue;
    }
    const geo::Pose pose = scene_.situation.plan->at(*at).pose;
    const double side = spiral.turn == flight::Turn::Right ? -1.0 : 1.0;
    const geo::Point centre{pose.x - side * spiral.radius * std::sin(pose.heading), pose.y + side * spiral.radius * std::cos(pose.heading)};
    const double radius = std::max(5.0, spiral.radius / camera_.metresPerPixel());
    painter.setPen(QPen(colors.routeCasing, 5.5));
    painter.drawEllipse(camera_.toScreen(centre), radius, radius);
    QPen pen(scene_.situation.planIsCurrent ? colors.route : colors.routeOutdated, 2.5, Qt::SolidLine, Qt::FlatCap);
    pen.setDashPattern({2.0, 1.0});
    painter.setPen(pen);
    painter.drawEllipse(camera_.toScreen(centre), radius, radius);
  }
}

void TourLines::drawMarks(QPainter& painter, LabelPlacer& labels) const {
  const document::Situation& now = scene_.situation;
  if (now.plan == nullptr || (now.planIsCurrent && now.plan->isVerified())) {
    return;
  }
  const style::ChartColors& colors = scene_.colors();
  const QString text = now.planIsCurrent ? Words::tr("NOT VERIFIED") : Words::tr("OUT OF DATE");
  const QFont font = chartFont(TextSize::Small, true);
  const QSizeF size = textSize({text}, font) + QSizeF(14.0, 6.0);
  bool isFirst = true;
  for (const ScreenLine& part : screenLines(line(), camera_, 0.0)) {
    for (const LineMark& mark : marksAlong(part, isFirst ? kMarkSpacing / 4.0 : kMarkSpacing)) {
      QRectF box(QPointF(), size);
      box.moveCenter(mark.at);
      if (labels.placeAt(box)) {
        drawPlate(painter, mark.at, text, font, colors.text, colors.panel, colors.routeOutdated);
        isFirst = false;
        break;
      }
    }
  }
}

void TourLines::drawSketch(QPainter& painter) const {
  const document::Situation& now = scene_.situation;
  if (now.sketch == nullptr || now.sketch->tour == nullptr) {
    return;
  }
  const style::ChartColors& colors = scene_.colors();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const document::PlanningSketch::Leg& leg : *now.sketch->tour) {
    QPen pen(colors.route, leg.safe ? 3.0 : 2.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (!leg.safe) {
      pen.setDashPattern({4.0, 3.0});
    }
    drawCased(painter, screenLines(leg.path, camera_, kBorder), pen, colors.routeCasing);
  }
  painter.restore();
}

void drawOtherGlide(QPainter& painter, const style::ChartColors& colors, const MapCamera& camera, const document::EngineOut& glide) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  drawCased(painter, glideLines(glide, camera), QPen(colors.mutedText, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin), colors.textHalo);
  painter.restore();
}

void drawEngineOut(QPainter& painter, const style::ChartColors& colors, const MapCamera& camera, const document::EngineOut& glide,
                   std::optional<geo::Point> touchdown) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const std::vector<ScreenLine> lines = glideLines(glide, camera);
  drawLines(painter, lines, QPen(colors.text, 7.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  drawLines(painter, lines, QPen(colors.textHalo, 5.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  drawLines(painter, lines, touchdown ? marginPen(glide.margin, colors, 4.0) : QPen(colors.violation, 4.0, Qt::DotLine, Qt::FlatCap));

  if (touchdown) {
    const QPointF end = camera.toScreen(*touchdown);
    painter.setPen(QPen(colors.text, 5.0));
    painter.drawEllipse(end, kRingRadius, kRingRadius);
    painter.setPen(QPen(colors.glide(glide.margin), 3.0));
    painter.drawEllipse(end, kRingRadius, kRingRadius);
  }
  drawAircraft(painter, camera.toScreen(glide.from.pose.point()), -glide.from.pose.heading, colors);
  painter.restore();
}

}  // namespace vp::map
