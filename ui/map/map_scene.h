#pragma once

#include "ui/document/landing_case.h"
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
  int selectedTarget = -1;                               ///< index into the mission's targets
  int selectedWeather = -1;                              ///< index into the mission's weather
  std::optional<double> cursor;                          ///< m along the tour
  std::shared_ptr<const document::LandingCase> landing;  ///< an engine failure somewhere, and the ways down from it; null: none

  [[nodiscard]] const style::ChartColors& colors() const { return style::ChartColors::of(theme); }
};

}  // namespace vp::map
