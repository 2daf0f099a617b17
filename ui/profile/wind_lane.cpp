#include "ui/profile/wind_lane.h"

#include "core/air/wind_at.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>
#include <QRectF>

#include <algorithm>
#include <cmath>

namespace vp::profile {
namespace {

constexpr double kApart = 46.0;   // px between arrows
constexpr double kLength = 15.0;  // px of an arrow
constexpr double kHead = 6.0;     // px
constexpr double kFelt = 0.26;    // m/s, half a knot: less is no wind to speak of

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ProfileRenderer)
};

bool isForecastSure(const document::PlanView& plan) {
  const auto& winds = plan.plan().mission.wind;
  return std::all_of(winds.begin(), winds.end(),
                     [](const air::WindLayer& layer) { return layer.wind.leastSpeed == layer.wind.mostSpeed && layer.wind.spread_deg == 0.0; });
}

}  // namespace

std::optional<CourseWind> courseWind(const document::PlanView& plan, const document::TourState& state) {
  const auto& winds = plan.plan().mission.wind;
  if (std::all_of(winds.begin(), winds.end(), [](const air::WindLayer& layer) { return layer.wind.isCalm(); })) {
    return std::nullopt;
  }
  const air::Wind wind = air::middleWind(winds, geo::HeightMsl::fromMetres(state.altitude));
  const double east = std::cos(state.pose.heading);
  const double north = std::sin(state.pose.heading);
  return CourseWind{wind.east * east + wind.north * north, wind.north * east - wind.east * north};
}

QString courseWindText(const document::PlanView& plan, const CourseWind& wind, const style::Units& units) {
  QStringList parts;
  if (std::abs(wind.tail) >= kFelt) {
    parts << (wind.tail > 0.0 ? Words::tr("%1 tail") : Words::tr("%1 head")).arg(units.speed(std::abs(wind.tail)));
  }
  if (std::abs(wind.left) >= kFelt) {
    parts << (wind.left < 0.0 ? Words::tr("%1 from the left") : Words::tr("%1 from the right")).arg(units.speed(std::abs(wind.left)));
  }
  if (parts.isEmpty()) {
    return Words::tr("calm");
  }
  const QString all = parts.join(QStringLiteral(", "));
  return isForecastSure(plan) ? all : Words::tr("about %1").arg(all);
}

void paintWindArrow(QPainter& painter, QPointF centre, const CourseWind& wind, const QColor& color) {
  const double speed = std::hypot(wind.tail, wind.left);
  painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  if (speed < kFelt) {
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, 0.2 * kLength, 0.2 * kLength);
    return;
  }
  const QPointF along(wind.tail / speed, -wind.left / speed);
  const QPointF across(-along.y(), along.x());
  const QPointF tip = centre + 0.5 * kLength * along;
  painter.drawLine(centre - 0.5 * kLength * along, tip - 0.5 * kHead * along);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF{tip, tip - kHead * along + 0.5 * kHead * across, tip - kHead * along - 0.5 * kHead * across});
}

void paintWindLane(QPainter& painter, const QRectF& lane, const PlotScale& scale, const document::PlanView& plan, const ProfileStyle& style) {
  const int count = std::max(1, static_cast<int>(lane.width() / kApart));
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (int i = 0; i < count; ++i) {
    const double x = lane.left() + (i + 0.5) * lane.width() / count;
    const double distance = std::clamp(scale.distanceAt(x), 0.0, plan.length());
    if (const std::optional<CourseWind> wind = courseWind(plan, plan.at(distance))) {
      paintWindArrow(painter, {x, lane.center().y()}, *wind, style.colors().mutedText);
    }
  }
  painter.restore();
}

}  // namespace vp::profile
