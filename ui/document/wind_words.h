#pragma once

#include "core/air/wind_layer.h"
#include "core/formats/wind_text.h"
#include "ui/style/units.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace vp::document {

formats::WindUnits windUnits(const style::Units& units);

/** "every wind of 10 to 20 kt from 250 to 290 degrees true" or "calm air", as it follows the word "in". */
QString airPhrase(const std::vector<air::WindLayer>& winds, const style::Units& units);

/** One line for each layer. */
QStringList windLines(const std::vector<air::WindLayer>& winds, const style::Units& units);

}  // namespace vp::document
