#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace vp::briefing {

/** A true direction with the magnetic variation of its place; no variation where a compass is of no use. */
struct Track {
  Angle trueCourse;
  std::optional<Angle> variation;  ///< east positive; magnetic = true - variation
};

/** A visit of a target, in the order flown. */
struct Visit {
  int target = -1;         ///< index into Plan::targets
  std::size_t point = 0;   ///< index into Plan::tour
  double distance = 0.0;   ///< m over ground from the tour's first point
  double altitude = 0.0;   ///< m MSL, of the tour
  double clearance = 0.0;  ///< m above the highest ground of the cell
  int spiral = -1;         ///< index into Plan::spirals, -1: none
};

/** The tour from one visit to the next. Altitudes m MSL. */
struct Leg {
  int from = -1;  ///< index into TourFigures::visits; -1 if the tour visits nothing
  int to = -1;
  std::size_t firstPoint = 0;
  std::size_t intervals = 0;  ///< between decision points
  double start = 0.0;         ///< m over ground along the tour
  double length = 0.0;        ///< m over ground
  double seconds = 0.0;       ///< at the tour's airspeed, in the middle of the forecast, climbs included
  Track track;                ///< of the longest straight part, else the first heading
  bool isStraightPart = false;
  double startAltitude = 0.0;
  double highestAltitude = 0.0;
  double endAltitude = 0.0;
  double leastClearance = 0.0;  ///< m above the highest ground of the cells below
  double safeAltitude = 0.0;    ///< highest of the lowest safe altitudes on the leg
  double leastMargin = 0.0;     ///< m above the lowest safe altitude
  double leastMarginAt = 0.0;   ///< m along the leg
};

/** What a glide from one place of the tour does, engine stopped there. */
struct GlideFigures {
  int site = -1;           ///< index into Plan::sites
  double length = 0.0;     ///< m over ground to the touchdown point
  double seconds = 0.0;    ///< the same, at best-glide speed
  double required = 0.0;   ///< m MSL, lowest altitude there from which it works
  double margin = 0.0;     ///< m above that
  double clearance = 0.0;  ///< m above ground, least on the way wherever the mission asks for the whole clearance
  double arrival = 0.0;    ///< m above the runway on arrival
};

/** A stretch of a leg from all of which the glides lead to the same runway end. */
struct Divert {
  int leg = 0;
  double from = 0.0;  ///< m along the leg
  double to = 0.0;
  int site = -1;  ///< index into Plan::sites
  double leastGlide = 0.0;
  double greatestGlide = 0.0;  ///< m over ground from the failure to the touchdown point
  double leastSeconds = 0.0;
  double greatestSeconds = 0.0;
  double margin = 0.0;          ///< m, least, above the lowest altitude from which the glide works
  double marginAt = 0.0;        ///< m along the tour; a centimetre behind a decision point where the glide goes on to the next
  GlideFigures worst;           ///< the glide from there
  double leastClearance = 0.0;  ///< m above ground, least along all of its glides
  double leastArrival = 0.0;    ///< m above the runway on arrival, least
};

/** The way from the home runway to the tour, or from the tour to it. */
struct WayFigures {
  Leg unguarded;  ///< before the gliding guarantee begins: lengths, times, altitudes and clearance alone; no intervals if it begins at once
  Leg leg;        ///< the rest; leg.start is that on the way
  std::vector<Divert> diverts;  ///< of the rest; `leg` means nothing
  int joinLeg = 0;              ///< index into TourFigures::legs where the way meets the tour
};

/** The numbers of a briefing, SI, without words. */
struct TourFigures {
  std::vector<Visit> visits;
  std::vector<Leg> legs;
  std::vector<Divert> diverts;  ///< in the order flown
  std::optional<WayFigures> departure;
  std::optional<WayFigures> arrival;
  std::vector<Track> siteTracks;     ///< landing directions, by site
  double length = 0.0;               ///< m over ground, once around
  double seconds = 0.0;              ///< once around, spirals included
  bool fieldIsCovered = true;        ///< the magnetic model is made for the date
  bool compassIsUnreliable = false;  ///< somewhere the horizontal field is below 6000 nT
};

/** Works out legs and diversions. Glides are flown by the checker's integration (core/safety), over the cells themselves, in the plan's winds
 *  and air, after its reaction loss and with its approach: margins and clearances are not the planner's.
 *  @pre the checker found no fault in the structure of the plan (rules plan.*, aircraft.profile, settings, wind.data)
 *  @errors Cancelled   @threads pure   @cost about 0.1 ms per decision point */
Result<TourFigures> tourFigures(const mission::Plan& plan, const terrain::ElevationGrid& terrain, std::chrono::year_month_day date, const Job& job);

/** The diversions with the least margin, worst first, no two at the same place: where margins are equal (within a metre) the
 *  lower clearance, then the longer glide counts as worse. @return indices into TourFigures::diverts, at most `count` */
std::vector<std::size_t> worstDiverts(const TourFigures& figures, std::size_t count);

}  // namespace vp::briefing
