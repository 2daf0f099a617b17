#pragma once

#include "core/audit/glide_motion.h"
#include "core/audit/ground.h"
#include "core/flight/curve.h"
#include "core/geo/pose.h"
#include "core/mission/mission.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::audit {

/// Length of the steps that a path is flown in [m]; the last of a piece may be shorter.
inline constexpr double kStep = 1.0;

/** A part of a track that is flown in one bend: pieces of one turn and radius after each other. */
struct Bend {
  int side = 0;         ///< +1 left, -1 right, 0 straight on
  double radius = 0.0;  ///< m, over ground
  double turned = 0.0;  ///< rad
  double length = 0.0;  ///< m
};

/** A metre of a track: from the place before it to its own. */
struct TrackStep {
  Along middle;
  Along end;
  geo::Point place;  ///< its end
  double heading = 0.0;
  double length = 0.0;  ///< m
  double flown = 0.0;   ///< m of the track at its end
  std::size_t bend = 0;
};

/** A path over ground cut into metres, its places found by adding them up (Simpson's rule over each metre), not by circles' centres. */
struct GroundTrack {
  geo::Pose start;
  Along startAlong;
  std::vector<TrackStep> steps;
  std::vector<Bend> bends;
  double length = 0.0;
  std::vector<double> ground;  ///< m MSL under the start and the end of each step: one more than steps
  std::vector<double> asked;   ///< m, clearance promised there
  std::vector<char> isWhole;   ///< whether that is the whole clearance

  [[nodiscard]] geo::Pose end() const;
};

/** Cuts pieces from a pose on. @return nothing if they cannot be flown as written: a turn without a radius, or more than 1000 km of them */
std::optional<GroundTrack> cutIntoMetres(const geo::Pose& start, const std::vector<flight::Piece>& pieces);

/** Puts the ground under a track. */
void putGroundUnder(GroundTrack& track, const GroundLookup& lookup);

/** The clearance that the mission promises along a whole glide: all of it, but on the last part, where the mission has an obstacle surface,
 *  no more than that surface, which begins `surfaceStart` before the touchdown point.  @return where the last part begins, as an index of `asked`;
 *  nothing where there is none */
std::optional<std::size_t> askForClearance(GroundTrack& glide, const mission::Mission& mission);

/** Why a glide does not end as the mission's approach asks for; empty if it does. */
std::string faultOfLastPart(const GroundTrack& glide, const mission::ApproachSettings& approach);

}  // namespace vp::audit
