#pragma once

#include "ui/document/situation.h"
#include "ui/map/map_options.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <optional>

namespace vp::map {

/** Everything that decides what a map looks like, but for where it looks. A value; its parts are shared. */
struct MapScene {
  document::Situation situation;
  MapOptions options;
  style::Theme theme = style::Theme::Light;
  style::Units units;
  int selectedTarget = -1;       ///< index into the mission's targets
  std::optional<double> cursor;  ///< m along the tour

  [[nodiscard]] const style::ChartColors& colors() const { return style::ChartColors::of(theme); }
};

}  // namespace vp::map
