#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"
#include "core/tour/tour_search.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::tour {

/** A mission with everything that its files name: a value snapshot, safe to plan on another thread. */
struct PlanInput {
  mission::Mission mission;
  geo::LocalFrame frame;
  std::shared_ptr<const terrain::ElevationGrid> terrain;
  std::vector<mission::TerrainReference> terrainFiles;
  std::vector<mission::SiteInFrame> sites;
  std::vector<mission::TargetInFrame> targets;
  std::string createdBy;                          ///< program and version, written into the plan
  std::string lkhProgram = "LKH";                 ///< for TourSolver::Lkh
  int threads = 1;                                ///< more threads give the same plan sooner
  terrain::TerrainPyramid pyramid = {};           ///< over `terrain`, where it is there already; built otherwise
  std::vector<mission::Airspace> airspaces = {};  ///< go into the plan; the tour avoids those that the mission forbids
};

/** Seconds of each step, as [1] Table 2. Not part of the plan, which is the same on every machine. */
struct PlanTimes {
  double roadmap = 0.0;
  double terrainSegments = 0.0;
  double safeSegments = 0.0;
  double tourSolver = 0.0;
  double refinement = 0.0;
  double assembly = 0.0;
};

/** Why there is no tour, in numbers, beside the sentence of the error. */
struct PlanFailure {
  int target = -1;                      ///< index into PlanInput::targets that the plan fails at; -1: none in particular
  std::optional<double> missingHeight;  ///< m that the ceiling is too low by, if that is the reason
};

/** Watches planning, for a user interface. Called from the working thread; the plan does not depend on it. */
struct PlanObserver {
  std::function<void(const landing::Roadmap&)> roadmapGrew;  ///< [1] Fig. 4
  std::function<void(const SearchRound&)> roundDone;
};

/** What planning one mission leaves for the next (replan.h decides what of it is still valid). */
struct PlanBasis {
  terrain::TerrainPyramid pyramid = {};
  std::shared_ptr<const landing::Roadmap> roadmap;  ///< none: is built
  geo::Box area;                                    ///< of the roadmap
  std::int64_t expansions = 0;                      ///< of the roadmap
  std::shared_ptr<const landing::AltitudeFloor> floor;
  std::vector<VisitPose> visits;  ///< a tour over some of the targets; if not empty it is completed and refined, without a search
};

/** The world that glides are planned in. */
landing::World makeWorld(const PlanInput& input);

/** Plans the shortest closed tour over all targets from every point of which a glide to a landing site exists.
 *  Roadmap ([1] Algorithm 1), then BASE or LAZY (Algorithms 3 and 4), then the closed loop (AssurePitchLimits).
 *  The plan comes without a certificate: core/safety judges it.
 *  @param basis  if not null: what is there already; afterwards, if a plan was made, what this one leaves
 *  @errors MissingTerrain (a target over unknown ground), NoLandingSite, NoSolution (which target, which limit, how much
 *  height is missing), OutOfRange (no targets, a wind as strong as the aircraft glides, a setting that is none or that the aircraft cannot fly), Cancelled   @threads pure */
Result<mission::Plan> planTour(const PlanInput& input, const Job& job, PlanTimes* times = nullptr, const PlanObserver& observer = {},
                               PlanFailure* failure = nullptr, PlanBasis* basis = nullptr);

/** Where roadmap samples are drawn: around the targets and the sites nearest to each, inside the terrain [m]. */
geo::Box roadmapArea(const PlanInput& input);

}  // namespace vp::tour
