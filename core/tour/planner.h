#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <memory>
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
  std::string createdBy;           ///< program and version, written into the plan
  std::string lkhProgram = "LKH";  ///< for TourSolver::Lkh
  int threads = 1;                 ///< more threads give the same plan sooner
};

/** Seconds of each step, as [1] Table 2. Not part of the plan, which is the same on every machine. */
struct PlanTimes {
  double roadmap = 0.0;
  double terrainSegments = 0.0;
  double safeSegments = 0.0;
  double tourSolver = 0.0;
  double assembly = 0.0;
};

/** Plans the shortest closed tour over all targets from every point of which a glide to a landing site exists.
 *  Roadmap ([1] Algorithm 1), then BASE or LAZY (Algorithms 3 and 4), then the closed loop (AssurePitchLimits).
 *  The plan comes without a certificate: core/safety judges it.
 *  @errors MissingTerrain (a target over unknown ground), NoLandingSite, NoSolution (which target, which limit, how much
 *  height is missing), OutOfRange (no targets), Cancelled   @threads pure */
Result<mission::Plan> planTour(const PlanInput& input, const Job& job, PlanTimes* times = nullptr);

/** Where roadmap samples are drawn: around the targets and the sites nearest to each, inside the terrain [m]. */
geo::Box roadmapArea(const PlanInput& input);

}  // namespace vp::tour
