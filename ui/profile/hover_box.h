#pragma once

#include "ui/profile/plot_text.h"

#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace vp::profile {

/** A small table beside the cursor: names left, values right, drawn by the view itself so that it follows the mouse
 *  without a window of its own. */
struct HoverRow {
  QString name;
  QString value;
  bool isViolated = false;
};

/** Draws the table beside `x`, on the side with room, inside `area`. @return the rectangle that it covers */
QRectF paintHoverBox(QPainter& painter, const std::vector<HoverRow>& rows, double x, const QRectF& area, const ProfileStyle& style);

}  // namespace vp::profile
