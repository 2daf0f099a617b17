#pragma once

#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/label_placement.h"
#include "ui/scene3d/osg_pointer.h"
#include "ui/style/chart_colors.h"

#include <memory>
#include <vector>

namespace vp::scene3d {

/** The sky behind the scene: from haze at the horizon to blue above, haze below. Follows the camera. */
class SkyNode {
public:
  SkyNode();
  ~SkyNode();
  SkyNode(const SkyNode&) = delete;
  SkyNode& operator=(const SkyNode&) = delete;
  SkyNode(SkyNode&&) = delete;
  SkyNode& operator=(SkyNode&&) = delete;

  [[nodiscard]] osg::Node& node();
  void update(const CameraState& camera, style::Theme theme);

private:
  class Private;
  std::unique_ptr<Private> d_;
};

/** Labels and symbols before the scene. */
class LabelNode {
public:
  LabelNode();
  ~LabelNode();
  LabelNode(const LabelNode&) = delete;
  LabelNode& operator=(const LabelNode&) = delete;
  LabelNode(LabelNode&&) = delete;
  LabelNode& operator=(LabelNode&&) = delete;

  [[nodiscard]] osg::Node& node();
  void update(const CameraState& camera, const std::vector<const LabelAtlas*>& atlases, const std::vector<PlacedLabel>& labels);

private:
  class Private;
  std::unique_ptr<Private> d_;
};

/** Colour that distant ground fades to. */
QColor hazeColor(style::Theme theme);
/** Colour of the sky straight up. */
QColor zenithColor(style::Theme theme);

}  // namespace vp::scene3d
