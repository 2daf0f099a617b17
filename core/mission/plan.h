#pragma once

#include "core/flight/curve.h"
#include "core/geo/local_frame.h"
#include "core/mission/mission.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

/** A landing site placed in the local frame. */
struct SiteInFrame {
  LandingSite site;
  geo::Pose pose;  ///< touchdown point, landing heading
  bool operator==(const SiteInFrame&) const = default;
};

/** A target placed in the local frame, its height resolved to MSL over the terrain of the plan. */
struct TargetInFrame {
  Target target;
  geo::Point point;
  double altitude = 0.0;  ///< m MSL
  bool operator==(const TargetInFrame&) const = default;
};

/** The glide that proves a safe altitude: pieces flown from a decision point's pose at best glide speed, to a site. */
struct Witness {
  int site = -1;  ///< index into Plan::sites
  std::vector<flight::Piece> pieces;
  bool operator==(const Witness&) const = default;
};

/** A point of the tour, the way on from it, and the glide from it. Between this point and the next the tour flies
 *  `onward` (one piece, so curvature is constant) and altitude changes linearly with distance. */
struct DecisionPoint {
  geo::Pose pose;
  double altitude = 0.0;      ///< of the tour, m MSL
  double safeAltitude = 0.0;  ///< A(q), m MSL: lowest height from which the witness arrives
  flight::Piece onward;
  Witness witness;
  int target = -1;  ///< index into Plan::targets if this is the visit of a target
  bool operator==(const DecisionPoint&) const = default;
};

/** A spiral at a target below the safe altitude ([1] Fig. 7): down from the tour to the target's height and up again.
 *  The gliding guarantee is suspended inside it, so a plan with spirals is certified with that exception named. */
struct SpiralVisit {
  int target = -1;
  double top = 0.0;     ///< m MSL, altitude of the tour at the visit
  double bottom = 0.0;  ///< m MSL, the target
  flight::Turn turn = flight::Turn::Left;
  double radius = 0.0;  ///< m
  int turnsDown = 0;    ///< whole circles, so that the tour goes on as before
  int turnsUp = 0;
  bool operator==(const SpiralVisit&) const = default;
};

/** Where surplus height is lost before an approach: circles over the point at which the approach of a site begins, on its course. */
struct Hold {
  int site = -1;  ///< index into Plan::sites
  flight::Turn turn = flight::Turn::Left;
  double radius = 0.0;  ///< m
  double lowest = 0.0;  ///< m MSL: lowest altitude of the circles
  bool operator==(const Hold&) const = default;
};

/** The way from the home runway to the tour, or from the tour to it: an open path of decision points whose last has no
 *  `onward`. A departure begins at the far end of its runway (landing course = takeoff course) at the runway's elevation and
 *  climbs over it in circles first; the gliding guarantee holds from points[guaranteed] on. An arrival keeps the guarantee to its last
 *  point, above the threshold on the landing course; from there the pilot flies his own circuit. */
struct HomePath {
  int site = -1;       ///< index into Plan::sites
  int join = -1;       ///< index into Plan::tour of the point where it meets the tour, same pose and altitude
  int guaranteed = 0;  ///< index into points; those before it have no witness (site -1)
  std::vector<DecisionPoint> points;
  bool operator==(const HomePath&) const = default;
};

/** A terrain file as it was when the plan was made. */
struct TerrainReference {
  std::string path;    ///< relative to the plan file where possible
  std::string sha256;  ///< of the file's bytes, lower-case hex
  bool operator==(const TerrainReference&) const = default;
};

/** How the planner came to the plan; no proof of anything. Counts as in [1] Table 3. */
struct PlanMetrics {
  double cost = 0.0;        ///< m, length + penalty, [1] (5)
  double length = 0.0;      ///< m along the tour in 3D
  double penalty = 0.0;     ///< m, beta times metres above targets
  double lowerBound = 0.0;  ///< m: no tour over the sampled headings and this roadmap costs less; 0 if none is known. A refined tour may.
  bool optimal = false;     ///< the tour over the sampled headings, before refinement, is proved to cost the bound
  std::int64_t roadmapExpansions = 0;
  std::int64_t safeQueries = 0;
  std::int64_t tourSolutions = 0;
  std::int64_t safeSegments = 0;
  double sampledCost = 0.0;        ///< m, of the closed loop over the sampled headings, before refinement; 0 if there was none
  std::int64_t movesTried = 0;     ///< by refinement: loops that were costed
  std::int64_t movesAccepted = 0;  ///< by refinement: loops that were cheaper and safe
  double freeLowerBound =
      0.0;  ///< m: no safe tour at all over these targets, sites and terrain costs less, whatever its headings; 0 if none is known
  bool operator==(const PlanMetrics&) const = default;
};

/** Least margin of one kind over the whole plan and where it is. */
struct Margin {
  std::string kind;    ///< rule id of core/safety, for example "glide.clearance"
  double value = 0.0;  ///< in `unit`, >= 0 for a certified plan
  std::string unit;    ///< "m", "deg"
  geo::LatLon where;
  bool operator==(const Margin&) const = default;
};

/** What the independent checker found for exactly this plan. Exists only if nothing was violated or unknown. */
struct Certificate {
  std::string statement;              ///< what is guaranteed, in a sentence, with exceptions
  std::vector<std::string> warnings;  ///< what a pilot should know
  std::vector<Margin> margins;
  std::int64_t pointsChecked = 0;
  std::int64_t glidesChecked = 0;
  bool operator==(const Certificate&) const = default;
};

/** A plan as written in a *.vpp file: self-contained but for the terrain, which it names with its checksum. */
struct Plan {
  std::string createdBy;  ///< program and version
  Mission mission;
  geo::LatLon frameOrigin;
  double terrainCell = 0.0;  ///< m, cell size that the terrain was used at
  std::vector<TerrainReference> terrain;
  std::vector<SiteInFrame> sites;
  std::vector<TargetInFrame> targets;
  std::vector<DecisionPoint> tour;  ///< closed: the last goes on to the first
  std::vector<SpiralVisit> spirals;
  std::vector<Hold> holds;            ///< as Mission::approach asks, one for each site that a glide ends at
  std::optional<HomePath> departure;  ///< both or none, as Mission::home asks
  std::optional<HomePath> arrival;
  std::vector<Airspace> airspaces;  ///< those near the terrain that the mission warns of or forbids
  PlanMetrics metrics;
  std::optional<Certificate> certificate;
};

}  // namespace vp::mission
