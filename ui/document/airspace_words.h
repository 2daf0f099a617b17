#pragma once

#include "core/mission/airspace.h"
#include "ui/style/units.h"

#include <QString>
#include <QStringList>

#include <array>

namespace vp::document {

/** All that can be done about an airspace, the least first. */
inline constexpr std::array kAirspaceUses{mission::AirspaceUse::Hide, mission::AirspaceUse::Show, mission::AirspaceUse::Warn,
                                          mission::AirspaceUse::Forbid};

/** "Keep the tour out", as menus and lists say it. */
QString airspaceUseText(mission::AirspaceUse use);

/** "C BERN TMA 1" and "FL 100 / FL 65": kind and name, ceiling and floor. */
QStringList airspaceText(const mission::Airspace& airspace, const style::Units& units);

}  // namespace vp::document
