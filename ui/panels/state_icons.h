#pragma once

#include "ui/style/chart_colors.h"

#include <QIcon>

namespace vp::panels {

/// Signs that panels put beside words; each has a shape of its own, so none is told apart by colour alone.
enum class Sign {
  Reachable,      ///< tick in a disc
  AroundTerrain,  ///< arrow that goes around a peak
  NotReachable,   ///< cross in a ring
  Verified,       ///< shield with a tick
  Unverified,     ///< shield with a question mark
  OutOfDate,      ///< clock
  Warning,        ///< triangle
  Violation,      ///< octagon with a stroke
  Note,           ///< i in a ring
  Previous,
  Next,
  Play,
  Pause,
};

/** The sign in the colours of a theme, sharp at any pixel ratio. @threads GUI */
QIcon signIcon(Sign sign, style::Theme theme);

}  // namespace vp::panels
