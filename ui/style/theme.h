#pragma once

#include "ui/style/chart_colors.h"

#include <QPalette>
#include <QString>

namespace vp::style {

/** Widget palette of a theme, made from the chart colours so that docks and map belong together. */
QPalette palette(Theme theme);

/** The few things that a palette cannot say (dock titles, table headers, tool buttons), as a style sheet. */
QString styleSheet(Theme theme);

/** Puts palette and style sheet on the application, on top of Qt's "Fusion" style. */
void applyTheme(Theme theme);

/** The theme that the desktop had before applyTheme() was first called, as far as its palette tells. */
Theme systemTheme();

}  // namespace vp::style
