#pragma once

#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/label_atlas.h"
#include "ui/scene3d/osg_pointer.h"
#include "ui/scene3d/scene_data.h"

#include <memory>
#include <vector>

namespace osg {
class LineWidth;        // NOLINT(cppcoreguidelines-virtual-class-destructor)
class MatrixTransform;  // NOLINT(cppcoreguidelines-virtual-class-destructor)
class Point;            // NOLINT(cppcoreguidelines-virtual-class-destructor)
}  // namespace osg

namespace vp::scene3d {

/** A runway in the graph, widened about its centre where it would be too small to see. */
struct RunwayNode {
  std::shared_ptr<osg::MatrixTransform> transform;
  ScenePoint centre;
  double heading = 0.0;
  double length = 0.0;  ///< m
  double width = 0.0;   ///< m
};

/** A scene as nodes of the graph. Built off the thread that renders, then handed over to it. Heights without exaggeration. */
struct SceneNodes {
  GroupPointer root;
  std::vector<RunwayNode> runways;
  std::vector<std::pair<std::shared_ptr<osg::LineWidth>, double>> lines;  ///< with their widths at 96 dpi
  std::vector<std::pair<std::shared_ptr<osg::Point>, double>> joints;     ///< round joints of lines, the same
  LabelAtlas labels;
};

/** @param labelRatio  resolution of the texts: pixels for each at 96 dpi */
std::shared_ptr<const SceneNodes> buildSceneNodes(const SceneData& scene, double labelRatio);

/** Makes runways large enough to see for a camera, at least kRunwayPixels long, and lines as wide as they should be.
 *  @param pixelRatio  pixels of the framebuffer for each of the camera's   @threads the one that renders */
void fitToPicture(const SceneNodes& nodes, const CameraState& camera, double exaggeration, double pixelRatio);

inline constexpr double kRunwayPixels = 22.0;     ///< least length of a runway on the picture
inline constexpr double kRunwayWidePixels = 5.0;  ///< least width of its outline

}  // namespace vp::scene3d
