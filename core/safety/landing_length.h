#pragma once

#include "core/mission/plan.h"

#include <optional>

namespace vp::safety {

/** Runway that the aircraft of a plan needs to land on a site of it [m], by the checker's own arithmetic: its landing distance times 1.225 / density,
 * the wind's, the slope's and the surface's factor. @return nothing if the profile has no landing distance, or the site is on water, where none
 * counts
 *  @pre the profile and the settings are sound   @source UK CAA, Safety Sense Leaflet 7 (slope, surfaces); AC 23-8, part 23.75 (half of a headwind,
 * one and a half times a tailwind)   @threads pure */
std::optional<double> landingLength(const mission::Plan& plan, const mission::LandingSite& site);

/** "21L" -> "03R"; empty if it is no runway number. */
std::string oppositeEnd(const std::string& ident);

/** Greatest winds on a landing [m/s]. */
struct RunwayWinds {
  double tail = 0.0;   ///< from behind; below zero where every wind is a headwind
  double cross = 0.0;  ///< from either side
};

/** Over all winds of the mission at the site; between two layers the wind lies between theirs, and so do its parts. @threads pure */
RunwayWinds runwayWinds(const mission::Mission& mission, const mission::LandingSite& site);

}  // namespace vp::safety
