#pragma once

#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QFont>
#include <QPointF>
#include <QString>

class QPainter;
class QRectF;

namespace vp::profile {

/** How a profile is dressed: colours by theme, numbers by units, one font for all of its text. */
struct ProfileStyle {
  style::Theme theme = style::Theme::Light;
  style::Units units;
  QFont font = {};
  bool onPaper = false;  ///< without what only helps on a screen; the lines differ in their dashes, for printers without colour
  [[nodiscard]] const style::ChartColors& colors() const { return style::ChartColors::of(theme); }
};

/** The font, or one like it whose digits all have the same width, so that changing numbers do not dance. */
QFont tabularFont(const QFont& font);

/** The font at a fraction of its size, at least 8 pixels high. */
QFont scaledFont(const QFont& font, double factor);

/** Text with an outline, readable over any ground. @param baseline  left end of the text's base line */
void drawHaloText(QPainter& painter, QPointF baseline, const QString& text, const QColor& color, const QColor& halo);

/** Hatches a rectangle as unknown terrain: base colour and diagonal lines at fixed places of the device. */
void hatchUnknown(QPainter& painter, const QRectF& area, const style::ChartColors& colors);

/** Digits grouped by thin spaces, a true minus sign. */
QString groupedNumber(double value, int decimals);

/// Small shapes with a meaning of their own, so that colour is never needed to tell them apart.
enum class Mark { LeastClearance, LeastMargin, HighestGround, Warning };

/** One of the shapes around a centre, `size` logical pixels high. */
void drawMark(QPainter& painter, QPointF centre, double size, Mark mark, const QColor& color, const QColor& casing);

}  // namespace vp::profile
