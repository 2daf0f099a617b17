#pragma once

#include "ui/document/plan_view.h"
#include "ui/profile/plot_scale.h"
#include "ui/profile/plot_text.h"

#include <QString>

#include <optional>

class QPainter;
class QRectF;

namespace vp::profile {

/// Height of the lane of wind arrows [px].
inline constexpr double kWindLane = 18.0;

/** The middle of the forecast as somebody on the tour feels it [m/s]. */
struct CourseWind {
  double tail = 0.0;  ///< from behind; below zero from ahead
  double left = 0.0;  ///< towards the left of the course; below zero towards the right
};

/** At a point of the tour; nothing in still air. */
std::optional<CourseWind> courseWind(const document::PlanView& plan, const document::TourState& state);

/** "12 kt head, 5 kt from the left", "about" before it where the forecast is a range. */
QString courseWindText(const document::PlanView& plan, const CourseWind& wind, const style::Units& units);

/** An arrow as the wind blows over an aircraft that flies to the right on the picture. @param centre  of it */
void paintWindArrow(QPainter& painter, QPointF centre, const CourseWind& wind, const QColor& color);

/** Such arrows along the tour, a little apart from one another. */
void paintWindLane(QPainter& painter, const QRectF& lane, const PlotScale& scale, const document::PlanView& plan, const ProfileStyle& style);

}  // namespace vp::profile
