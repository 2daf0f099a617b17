#pragma once

#include "ui/briefing/briefing_source.h"
#include "ui/style/units.h"

#include <QString>

namespace vp::briefing {

/** The ways from and to home as one of the facts; that there are none, where there are none. */
QString homeText(const BriefingSource& source, const style::Units& units);

/** What holds on the ways from and to home, in plain words.   @pre the plan has both */
QString homeGuarantee(const BriefingSource& source, const style::Units& units);

}  // namespace vp::briefing
