#pragma once

#include "core/landing/safe_altitude_field.h"
#include "core/mission/plan.h"
#include "ui/document/plan_view.h"
#include "ui/document/planning_sketch.h"
#include "ui/document/terrain_data.h"
#include "ui/document/weather_view.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::risk {
class Population;
class Weather;
}  // namespace vp::risk

namespace vp::document {

/** A target as shown: placed if there is terrain under it, else with the reason why it cannot be planned. */
struct ShownTarget {
  mission::Target target;
  geo::Point point;
  std::optional<double> altitude;  ///< m MSL
  std::string problem;             ///< one sentence; empty if all is well
};

/** A runway end as shown; those that the filter leaves out are shown too, weaker. */
struct ShownSite {
  mission::SiteInFrame site;
  bool usable = true;
};

/** An airspace as shown, its outline in the frame. */
struct ShownAirspace {
  mission::Airspace airspace;
  mission::AirspaceUse use = mission::AirspaceUse::Show;
  std::vector<geo::Point> outline;
};

/** What the airspace files of the mission hold, shown or not. */
struct FoundAirspaces {
  std::vector<mission::Airspace> hidden;  ///< near the terrain, but hidden by the mission; without their outlines
  std::vector<std::string> kinds;         ///< all classes of the files, sorted
};

ShownAirspace shownAirspace(mission::Airspace airspace, const mission::AirspaceSettings& settings, const geo::LocalFrame& frame);
bool isInside(const ShownAirspace& shown, geo::Point point);
/** Ceiling over ground of a height [m MSL], not above `highest`. */
double airspaceTop(const mission::Airspace& airspace, double ground, double highest);
/** Floor over ground of a height [m MSL], not below `lowest`. */
double airspaceBottom(const mission::Airspace& airspace, double ground, double lowest);

/** Everything that the views draw, as one immutable value whose parts are shared. A view compares pointers to see what has
 *  changed. Positions are in the frame of the terrain. */
struct Situation {
  std::shared_ptr<const TerrainData> terrain;                       ///< null: none loaded
  std::shared_ptr<const std::vector<ShownSite>> sites;              ///< null: none
  std::shared_ptr<const std::vector<ShownAirspace>> airspaces;      ///< null: none
  std::shared_ptr<const FoundAirspaces> foundAirspaces;             ///< null: none; with `airspaces` all that a rule can be about
  std::shared_ptr<const std::vector<ShownTarget>> targets;          ///< null: none; order of the mission
  std::optional<mission::HomeBase> home;                            ///< none: the tour alone
  std::vector<air::WindLayer> wind;                                 ///< of the mission; none: still air
  std::shared_ptr<const std::vector<ShownWeather>> weather;         ///< null: none; order of the mission
  std::shared_ptr<const risk::Weather> weatherRisk;                 ///< the same for planners; null: none, or it cannot be used
  std::string weatherProblem;                                       ///< why it cannot be used, a sentence; empty: it can
  std::shared_ptr<const risk::Population> population;               ///< null: none, or not read (yet)
  std::shared_ptr<const PlanView> plan;                             ///< null: none
  bool planIsCurrent = true;                                        ///< false: an input has changed since; draw it greyed
  std::shared_ptr<const PlanningSketch> sketch;                     ///< only while planning
  std::shared_ptr<const landing::SafeAltitudeField> safeAltitudes;  ///< null: not computed (yet)
};

}  // namespace vp::document
