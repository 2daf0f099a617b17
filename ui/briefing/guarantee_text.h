#pragma once

#include "ui/briefing/briefing_source.h"
#include "ui/style/units.h"

#include <QString>

namespace vp::briefing {

/** What the certificate says, in the pilot's units: from where the aircraft reaches which runways, with what is kept clear and
 *  every exception. Heights that are promised are rounded down, distances and altitudes up to which nothing is promised up.
 *  @pre the plan is certified */
QString guaranteeStatement(const BriefingSource& source, const style::Units& units);

/** The ways from and to home as one of the facts; that there are none, where there are none. */
QString homeText(const BriefingSource& source, const style::Units& units);

/** What holds on the ways from and to home, in plain words.   @pre the plan has both */
QString homeGuarantee(const BriefingSource& source, const style::Units& units);

}  // namespace vp::briefing
