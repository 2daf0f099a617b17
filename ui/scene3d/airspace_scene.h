#pragma once

#include "ui/scene3d/scene_data.h"

namespace vp::scene3d {

/** The airspaces that the mission warns of or forbids, as far as they lie over the terrain: translucent sides, floor and ceiling in
 *  the colours of the map with edges and a label; what is forbidden is denser. Where there is no ceiling they end above all else. */
void addAirspaces(SceneData& scene, const document::Situation& situation);

}  // namespace vp::scene3d
