#pragma once

#include "core/air/atmosphere.h"
#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/base/quantity.h"
#include "core/geo/local_frame.h"
#include "core/mission/airspace.h"
#include "core/mission/landing_site.h"
#include "core/mission/weather.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

enum class HeightReference { AboveGround, Msl };

/** A place to be visited: at its height, or directly above where the safe altitude is higher. */
struct Target {
  std::string name;  ///< unique in a mission, not empty
  geo::LatLon position;
  double height_m = 100.0;
  HeightReference reference = HeightReference::AboveGround;
  bool operator==(const Target&) const = default;
};

/** A file (or pair of files) of airfields, paths as written in the mission: relative to the mission file. */
struct AirfieldSource {
  std::string airports;  ///< OurAirports airports.csv, X-Plane apt.dat, SeeYou .cup, or a CSV or GeoJSON of one's own fields
  std::string runways;   ///< OurAirports runways.csv; empty for all others
  bool operator==(const AirfieldSource&) const = default;
};

/** What an operator has to say about a site: why it is excluded, what to mind there. */
struct SiteNote {
  std::string site;  ///< site id ("LSZS/21") or airport ident ("LSZS")
  std::string text;
  bool operator==(const SiteNote&) const = default;
};

/** Which landing sites count. Closed runways, helipads and water never do unless asked for. */
struct SiteFilter {
  bool approximate = true;  ///< keep sites whose geometry was derived
  bool water = false;
  bool closed = false;
  std::optional<Length> minLength;    ///< sites of unknown length pass, with an approximation noted
  std::vector<std::string> exclude;   ///< site ids ("LSZS/21") or airport idents ("LSZS")
  std::vector<std::string> oneWay;    ///< site ids whose opposite end must not be used
  std::optional<Length> minWidth;     ///< sites of unknown width pass, with an approximation noted
  std::vector<Surface> surfaces;      ///< what may be landed on, Unknown included; empty = everything (water has its own flag)
  bool lighted = false;               ///< only those known to be lighted
  std::optional<Length> maxDistance;  ///< touchdown from distanceFrom, or from the nearest target; counts for nothing while there are neither
  std::optional<geo::LatLon> distanceFrom;
  std::vector<SiteNote> notes;
  bool operator==(const SiteFilter&) const = default;
};

/** What "safe" is measured against. */
struct SafetySettings {
  Length clearance = Length::fromSi(100.0);  ///< above terrain everywhere, on tour and glides, dynamics allowance included ([1] section 8)
  Length arrivalMargin;                      ///< above the site's elevation on arrival
  Duration reactionTime = {};                ///< after the engine stops, nothing changes for so long: the glide flies straight on
  Length reactionLoss = {};                  ///< height lost until the glide is established, beyond what gliding loses
  double dragFactor = 1.0;                   ///< of the whole polar, >= 1: what this pilot's glide costs more than the profile says
  bool operator==(const SafetySettings&) const = default;
};

/** How a glide ends at its runway. */
enum class ApproachKind {
  Threshold,  ///< at the touchdown point on the landing course, by whatever curve leads there: the setting of [1]
  Straight,   ///< after a straight of a given length
  Overhead,   ///< above the touchdown point on the landing course (high key), then one full circle down to it by the abeam point (low key)
};

/** The last part of every glide, and how close to the ground it may come there. */
struct ApproachSettings {
  ApproachKind kind = ApproachKind::Threshold;
  Length finalLength = Length::fromSi(1000.0);  ///< Straight: over ground, > 0
  std::optional<Angle> slope;                   ///< Straight: descent over ground, chosen; none: that of the best glide
  /** Straight and Overhead: on that last part the clearance is only the height of an obstacle surface that begins `surfaceStart` before the
   *  touchdown point (path length to go) and rises by this slope away from it, where that is lower than the clearance. None: the whole
   *  clearance everywhere.  @source ICAO Annex 14 volume I, table 4-1: approach surfaces begin 60 m before the threshold (30 m: code number 1) and
   *  rise by 1 : 20 (code number 1), 1 : 25 (2), 1 : 30 (3) or 1 : 40 (4) on non-instrument runways */
  std::optional<double> surfaceSlope;  ///< [-], for example 0.05
  Length surfaceStart = Length::fromSi(60.0);
  std::optional<Length> keyHeight;  ///< Overhead: least height over the touchdown point's elevation at high key; none: what the circle loses
  bool hold = false;                ///< every site used needs a circle over the beginning of its approach that surplus height can be lost in
  bool operator==(const ApproachSettings&) const = default;
};

enum class Method { Lazy, Base };
enum class TourSolver { Builtin, Lkh };

/** How the roadmap of landing glides is built. */
enum class RoadmapKind {
  Lattice,  ///< least-altitude search over a lattice of poses
  RrtStar,  ///< random samples, [1] Algorithm 1
};

/** What happens to the tour over the sampled headings. */
enum class Refine {
  None,  ///< nothing: the tour of [1]
  Full,  ///< headings become continuous and the order is tried around the tour, on the cost of the closed loop
};

/** What to do with a target below the safe altitude. */
enum class LowTargets {
  PassAbove,  ///< visit directly above, at the safe altitude, at a cost of beta per metre
  Descend,    ///< leave the safe altitude by a spiral down to the target and back ([1] Fig. 7); the guarantee is suspended there and the plan says so
};

/** How the plan is searched; none of it can make an unsafe plan. */
struct PlannerSettings {
  int headings = 8;                    ///< k, heading samples per target
  Length step = Length::fromSi(50.0);  ///< d_step, longest distance between decision points
  Method method = Method::Lazy;
  std::uint64_t seed = 1;
  RoadmapKind roadmap = RoadmapKind::Lattice;
  std::optional<int> roadmapSamples;    ///< RRT* expansions; chosen from the mission area if absent
  std::optional<Duration> roadmapTime;  ///< RRT*: stop building after this; gives up reproducibility
  double beta = 2.0;                    ///< penalty per metre above a target, >= 2 ([1] section 7)
  LowTargets lowTargets = LowTargets::PassAbove;
  TourSolver tourSolver = TourSolver::Builtin;
  Refine refine = Refine::Full;
  bool operator==(const PlannerSettings&) const = default;
};

/** Where the flight begins and ends. The tour itself stays closed and guaranteed whole; the ways to it and from it join it. */
struct HomeBase {
  std::string takeoff;  ///< landing site whose direction is taken off in, for example "LSZS/21"
  std::string landing;  ///< landing site to end at
  bool operator==(const HomeBase&) const = default;
};

/** A mission as written in a *.vpm file. Values without behaviour; paths are relative to the mission file. */
struct Mission {
  std::string name;
  std::vector<std::string> terrain;  ///< raster files, one mosaic
  std::vector<AirfieldSource> airfields;
  std::vector<LandingSite> sites;  ///< given in the mission itself
  SiteFilter siteFilter;
  aircraft::AircraftProfile aircraft;
  std::string aircraftReference;  ///< name of a bundled profile or a file; empty = profile given inline
  std::vector<Target> targets;
  std::optional<HomeBase> home;           ///< none: the plan is the tour alone
  std::optional<geo::HeightMsl> ceiling;  ///< of the tour; together with the aircraft's, the lower counts
  SafetySettings safety;
  PlannerSettings planner;
  AirspaceSettings airspace;
  std::vector<air::WindLayer> wind;           ///< that the guarantee holds for, ascending; none: still air
  std::optional<air::Atmosphere> atmosphere;  ///< none: the density of the aircraft's polar at every height, as in the source papers
  ApproachSettings approach;
  aircraft::Propeller propeller = aircraft::Propeller::AsInPolar;
  std::string powerSetting;  ///< of the aircraft, by name; empty: the tour is flown at best glide speed
  /** For landing now alone: neither tour nor certificate know of them. */
  std::vector<WeatherCell> weather;
  std::vector<std::string> populationFiles;  ///< polygons with how many people live in them; for landing now alone, as the weather
};

}  // namespace vp::mission
