#pragma once

#include "ui/style/chart_colors.h"

#include <QPen>

namespace vp::map {

/** Classes of glide margin. Colour grades continuously (ChartColors::glide), the dashes by class, so that margins can be told
 *  apart without colour: the less margin, the more broken the line. */
enum class MarginClass { Violated, Tight, Modest, Ample };

inline constexpr double kTightMargin = 50.0;  ///< m; below it Tight, from it to ChartColors::kAmpleMargin Modest

/** A margin as it is drawn: what the checker accepts as rounding counts as none at all, not as a violation. [m] */
double shownMargin(double margin);

MarginClass marginClass(double margin);

/** Pen for a line with a margin [m]: colour and dashes; flat caps. */
QPen marginPen(double margin, const style::ChartColors& colors, double width);

}  // namespace vp::map
