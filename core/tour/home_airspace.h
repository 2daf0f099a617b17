// Ways from and to home beside forbidden airspace. Of home_path.cpp only.
#pragma once

#include "core/base/result.h"
#include "core/landing/world.h"
#include "core/mission/plan.h"
#include "core/tour/forbidden_airspace.h"

#include <optional>
#include <string>

namespace vp::tour {

/** A runway in airspace that its departure or arrival must not fly in; nothing if it is outside. @param altitude  of the way there, m MSL */
std::optional<Error> insideAirspace(const landing::World& world, const ForbiddenAirspace* forbidden, const std::string& runway, geo::Point place,
                                    double altitude);

/** Whether a way stays out of forbidden airspace; the circles of a climb-out are laid out without asking. */
bool staysOutside(const landing::World& world, const ForbiddenAirspace* forbidden, const mission::HomePath& path);

}  // namespace vp::tour
