#pragma once

#include "ui/document/situation.h"
#include "ui/scene3d/camera_controller.h"
#include "ui/scene3d/scene_options.h"
#include "ui/scene3d/terrain_model.h"

#include <memory>
#include <optional>

namespace vp::scene3d {

/** The ground of a terrain for the camera; level zero everywhere without one. */
CameraGround cameraGround(const std::shared_ptr<const TerrainModel>& terrain, double exaggeration);

/** The tour for the camera; length 0 without a plan. Flown at the best glide speed of the aircraft. */
FlightPath flightPath(std::shared_ptr<const document::PlanView> plan, double exaggeration);

/** Where a preset stands for a situation. Top, North: all of the tour, else of the terrain. AlongTour: behind the aircraft at
 *  `cursor`, else at the start of the tour; without a plan as North. FromRunway: above the runway that the glide from the
 *  cursor leads to, else the first usable one, looking out against the landing direction to where the glide comes from;
 *  without runways as North.
 *  @param controller  for the shape of the picture */
CameraOrbit presetOrbit(Preset preset, const document::Situation& situation, const TerrainModel* terrain, double exaggeration,
                        std::optional<double> cursor, const CameraController& controller);

}  // namespace vp::scene3d
