#pragma once

#include "ui/document/situation.h"
#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/terrain_model.h"

#include <optional>

namespace vp::scene3d {

/** What lies under a point of the picture. The terrain may be null. @threads pure   @cost below 1 ms */

/** Distance along the tour [m] of the point nearest to a pixel, if one within `radius` px is not hidden by the ground. */
std::optional<double> pickTour(const document::PlanView& plan, const TerrainModel* terrain, const CameraState& camera, double exaggeration, double x,
                               double y, double radius);

/** Index of the target whose head or foot is under a pixel; the nearest first. */
std::optional<int> pickTarget(const std::vector<document::ShownTarget>& targets, const TerrainModel* terrain, const CameraState& camera,
                              double exaggeration, double x, double y, double radius);

/** The ground under a pixel, in scene space; nothing for the sky. */
std::optional<Vec3> pickGround(const TerrainModel& terrain, const CameraState& camera, double exaggeration, double x, double y);

}  // namespace vp::scene3d
