#pragma once

#include "core/mission/plan.h"

#include <string>

namespace vp::formats {

/** Turns the paths of a mission (terrain, airfields, airspaces, population, aircraft file) that are relative to `folder` into absolute ones, so that
 * it can be kept and moved in memory. Names of bundled aircraft stay. */
void makePathsAbsolute(mission::Mission& mission, const std::string& folder);

/** The reverse, for writing into `folder`; a path that shares no folder with `folder` but the root stays absolute. */
void makePathsRelative(mission::Mission& mission, const std::string& folder);

/** The same for a plan: its mission and its terrain references. */
void makePathsAbsolute(mission::Plan& plan, const std::string& folder);
void makePathsRelative(mission::Plan& plan, const std::string& folder);

}  // namespace vp::formats
