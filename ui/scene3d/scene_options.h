#pragma once

#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

namespace vp::scene3d {

/** What the 3D view shows. */
struct SceneOptions {
  double verticalExaggeration = 1.0;  ///< 1 .. 5; shown in the picture when it is not 1
  bool curtain = true;                ///< from the tour down to the ground
  bool allGlides = false;             ///< the glide of every decision point
  bool runways = true;
  bool excludedRunways = true;  ///< those that the filter leaves out, drawn weaker
  bool labels = true;
  bool operator==(const SceneOptions&) const = default;
};

/** How texts and colours of a scene are made. */
struct SceneStyle {
  style::Theme theme = style::Theme::Light;
  style::Units units;
  bool operator==(const SceneStyle&) const = default;
};

/// Ready-made places of the camera; keys 1 to 4.
enum class Preset { Top, North, AlongTour, FromRunway };

}  // namespace vp::scene3d
