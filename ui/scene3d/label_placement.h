#pragma once

#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/label_atlas.h"

#include <array>
#include <functional>
#include <vector>

namespace vp::scene3d {

/** A piece of the atlas as it stands on the picture: corners clockwise from the upper left, px from the upper left. */
struct PlacedLabel {
  int atlas = 0;
  const AtlasPiece* piece = nullptr;
  std::array<std::array<double, 2>, 4> corners{};
  double opacity = 1.0;
};

/** Puts labels and symbols on the picture, by priority and then by nearness: a text that would cover another gives up its
 *  second line, then its place. Symbols always stand.
 *  Texts are never cut off: near the sides of the picture they move inwards.
 *  @param reserved  parts of the picture that texts must leave free: legend, compass
 *  @param isClear   whether the line of sight to a point in scene space is free */
std::vector<PlacedLabel> placeLabels(const std::vector<const LabelAtlas*>& atlases, const CameraState& camera, double exaggeration,
                                     const std::vector<QRectF>& reserved, const std::function<bool(Vec3)>& isClear);

}  // namespace vp::scene3d
