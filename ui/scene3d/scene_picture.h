#pragma once

#include "core/base/result.h"
#include "ui/document/situation.h"
#include "ui/scene3d/camera_controller.h"
#include "ui/scene3d/scene_options.h"

#include <QImage>
#include <QSize>

#include <optional>

namespace vp::scene3d {

/** Where a picture is taken from. */
struct CameraSpec {
  Preset preset = Preset::North;
  std::optional<double> cursor;      ///< m along the tour: shown with its glide; AlongTour and FromRunway go there
  std::optional<CameraOrbit> orbit;  ///< instead of the preset; scene space
  double turn = 0.0;                 ///< rad added to the preset's direction of view, counter-clockwise
  double nearer = 1.0;               ///< factor by which the camera is nearer than the preset
};

/** A finished picture of a situation with legend, compass and labels, for the command line and the README. Needs no window and
 *  no display, but a QGuiApplication for its fonts. The same input gives the same picture.
 *  @param size  px at 96 dpi   @param pixelRatio  pixels for each of those
 *  @errors Unsupported (no OpenGL), MissingTerrain (no terrain in the situation)
 *  @threads any; some seconds for large terrain */
Result<QImage> renderScene(const document::Situation& situation, const SceneOptions& options, const CameraSpec& spec, QSize size, style::Theme theme,
                           const style::Units& units, double pixelRatio = 1.0);

}  // namespace vp::scene3d
