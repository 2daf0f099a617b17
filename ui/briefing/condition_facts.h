#pragma once

#include "core/mission/plan.h"
#include "ui/briefing/briefing_content.h"
#include "ui/style/units.h"

#include <QString>

#include <vector>

namespace vp::briefing {

/** Appends what a plan holds for beside the wind: masses, air, altimeter, reaction, drag, propeller, power, approach, holds. Nothing where it is as
 * in the source papers. */
void addConditions(std::vector<Fact>& facts, const mission::Plan& plan, const style::Units& units);

/** What is assumed of the moments after the engine has stopped. */
QString reactionAssumption(const mission::Plan& plan, const style::Units& units);

/** What is assumed of the end of a glide. */
QString approachAssumption(const mission::Plan& plan);

/** What altitudes are, and what an altimeter makes of them. */
QString altimeterAssumption(const mission::Plan& plan, const style::Units& units);

}  // namespace vp::briefing
