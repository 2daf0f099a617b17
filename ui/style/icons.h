#pragma once

#include "ui/style/chart_colors.h"

#include <QIcon>
#include <QString>

namespace vp::style {

/** An icon of our own set (resources/icons/NAME.svg), drawn in the text colour of the theme, sharp at any size and device
 *  pixel ratio; its disabled state is weaker. An unknown name gives a null icon. @threads GUI thread */
QIcon icon(const QString& name, Theme theme);

}  // namespace vp::style
