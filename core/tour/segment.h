#pragma once

#include "core/landing/altitude_floor.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"
#include "core/tour/detour.h"
#include "core/tour/forbidden_airspace.h"
#include "core/tour/profile.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace vp::tour {

/** A target with one of its sampled headings: a node of the tour problem. */
struct VisitPose {
  int target = -1;
  geo::Pose pose;
  double altitude = 0.0;  ///< of the target, m MSL

  std::optional<flight::Word> onward = {};  ///< of the Dubins path that leads on from here; the shortest word if none

  /// A(pose) and its glide, asked without a hint; altitude infinity and site -1 if there is no glide. Legs ask it where it is
  /// not known yet, so it saves time and changes nothing (SegmentBuilder::ask).
  std::optional<landing::SafeAltitude> safe = {};
};

/** What segments are measured by. */
struct SegmentSettings {
  double step = 50.0;  ///< d_step, m
  double beta = 2.0;   ///< penalty per metre above a target
  PitchLimits pitch;
  double ceiling = std::numeric_limits<double>::max();  ///< m MSL, finite: ground of infinite height is always above it
  const ForbiddenAirspace* forbidden = nullptr;         ///< none: the tour may go everywhere; outlives all that has these settings
};

/** Cost of a segment and how high it goes. */
struct SegmentCost {
  double cost = 0.0;  ///< m: length in space + half the penalty at each end, [1] (15), (17); infinite if it cannot be flown
  double peak = 0.0;  ///< m MSL, highest altitude; infinite over unknown ground, where no glide exists, and for a safe segment above the ceiling
};

/** A decision point of a safe segment. */
struct SegmentPoint {
  geo::Pose pose;
  flight::Piece onward;       ///< to the next point; no length at the last
  double distance = 0.0;      ///< from the start of the segment, m
  double lowest = 0.0;        ///< lowest altitude that is safe here and on the way to the next point, m MSL
  double safeAltitude = 0.0;  ///< A(q), m MSL
  std::vector<flight::Piece> witness;
  int site = -1;
};

/** A stretch of a segment beside a forbidden airspace. */
struct SegmentGate {
  std::size_t point = 0;  ///< between this decision point and the next
  HeightGate gate;
};

/** Builds tour segments between two visit poses: the shortest Dubins path at the tour's radius (or a chain of them
 *  around barred ground, see detour.h), cut into decision points, and the altitude profile over it.
 *
 *  Where it meets forbidden airspace the profile is the lowest that passes under or over it; if that has to go over, the ways around
 *  are tried too and the cheapest counts.
 *
 *  Lowest altitude S_j at decision point j:
 *    terrain segment  S_j = max of ground + clearance over both adjoining intervals, and the targets at the ends;
 *    safe segment     S_j = max( the same with ground + clearance + E, A(q_j), max(A(q_j+1), ground_j + clearance + E) + loss(q_j to q_j+1) ),
 *                     E what the height falls by at once when the engine stops (World::reactionLoss, in A already),
 *  then pitch limits, then the least concave majorant. Altitude is linear between points and every interval has one
 *  curvature, so both ends being safe makes all points between safe (proof: core/safety/WHY.md).
 *  Losses are those at the altitudes between the two heights, before and after E is lost (aircraft/glide_bands.h).
 *  A of the two ends is the roadmap's answer for that pose alone, so that all legs at a visit count with the same; A in
 *  between is the lowest of the roadmap's answer, the glide on along the leg to the next point and its glide, and, where the pilot has
 *  to react first, the glide along the leg until he has, from where it may turn at once. A leg's cost depends on the leg only, not on
 *  what was asked before.
 *  Few points need a query: a profile that the segment surely reaches is known from the ground, the altitude floor and the
 *  answers so far, and where the glide on to the next point fits under it, and does so for the point before, no lower A could
 *  lower the segment.
 *  The terrain segment never costs more than the safe one: its S_j is never higher, and for concave profiles over the
 *  same base the length grows by at most the rise of the two ends, each charged beta / 2 >= 1 ([1] (19), (20)).
 *  @threads one object per thread: it keeps working memory; world, roadmap and floor are shared */
class SegmentBuilder {
public:
  /** @param stop   when it is requested, safe segments cost infinitely much and have no points: the caller asks it too
   *  @param floor  saves queries where given */
  SegmentBuilder(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours, SegmentSettings settings,
                 std::stop_token stop = {}, const landing::AltitudeFloor* floor = nullptr);

  /** Answers VisitPose::safe if that is not done yet. */
  void ask(VisitPose& visit);

  [[nodiscard]] SegmentCost terrainSegment(const VisitPose& from, const VisitPose& to);
  [[nodiscard]] SegmentCost safeSegment(const VisitPose& from, const VisitPose& to);

  /** Points of a segment and their lowest altitudes S_j before pitch limits. Valid until the next call. */
  struct Floor {
    std::span<const double> distance;  ///< from the start, m
    std::span<const double> lowest;    ///< m MSL
    std::span<const SegmentGate> gates;
  };
  /** Of the safe segment; or at most that, known without a query but for the two ends. Nothing if it cannot be flown, or if
   *  stopped. */
  [[nodiscard]] std::optional<Floor> boundFloorOf(const VisitPose& from, const VisitPose& to);
  [[nodiscard]] std::optional<Floor> safeFloorOf(const VisitPose& from, const VisitPose& to);

  /** Decision points of the safe segment with their glides, end point included; none when stopped.
   *  @pre safeSegment gave a finite cost */
  [[nodiscard]] std::vector<SegmentPoint> safePoints(const VisitPose& from, const VisitPose& to);

  /** Gates of the segment that was built last. Valid until the next call. */
  [[nodiscard]] std::span<const SegmentGate> gates() const { return gates_; }

  /** Queries made so far. */
  [[nodiscard]] std::int64_t queries() const { return scratch_.queries; }

private:
  struct Interval {
    geo::Pose start;
    flight::Piece piece;
    double ground = 0.0;  ///< upper bound of the terrain, m MSL
    double loss = 0.0;    ///< upper bound of the height lost gliding along it, at the altitude where that is least, m
  };

  enum class Way { Direct, Detour, AroundAirspace };

  bool layOut(const VisitPose& from, const VisitPose& to, Way way);
  bool layOutSafe(const VisitPose& from, const VisitPose& to);
  template <typename FindFloor>
  bool layOutBest(const VisitPose& from, const VisitPose& to, bool triesAll, FindFloor findFloor);
  bool addGates(std::size_t interval);
  bool passGates(bool& isRaised);
  [[nodiscard]] double costOf(const std::vector<double>& profile, const VisitPose& from, const VisitPose& to) const;
  bool cutIntoIntervals(const geo::Pose& start);
  [[nodiscard]] bool findSafeAltitudes(const VisitPose& to, bool all);
  [[nodiscard]] bool findBestGlides(const VisitPose& from, const VisitPose& to);
  /// The glide of a point: `along` intervals along the leg, then a glide of the roadmap.
  struct Answer {
    landing::SafeAltitude safe;  ///< its altitude is that of the whole, at the point
    std::size_t along = 0;
  };
  void answerAt(std::size_t point, int& hint);
  [[nodiscard]] std::vector<flight::Piece> glideOf(std::size_t point) const;
  void answerAlong(std::size_t point, int hint);
  SegmentCost profileCost(const VisitPose& from, const VisitPose& to);
  void terrainFloor(const VisitPose& from, const VisitPose& to, double above);
  void knownFloor(const VisitPose& from, const VisitPose& to);
  void raiseFloor(std::size_t point);
  void updateProfile();
  bool appendDirect(const VisitPose& from, const VisitPose& to);
  [[nodiscard]] double leastLossOn(const geo::Pose& start, const flight::Piece& piece) const;
  [[nodiscard]] double heightBefore(std::size_t interval, double end, double lostAtOnce) const;
  [[nodiscard]] double glideFloor(std::size_t interval, double next) const;

  const landing::World& world_;
  const landing::Roadmap& roadmap_;
  const Detours& detours_;
  SegmentSettings settings_;
  std::stop_token stop_;
  const landing::AltitudeFloor* altitudeFloor_ = nullptr;
  std::vector<flight::TurnLoss> losses_;  ///< with the tour's radius; of each band, where they differ by altitude
  landing::QueryScratch scratch_;
  std::vector<flight::Piece> pieces_;
  std::vector<Interval> intervals_;
  std::vector<SegmentGate> gates_;
  std::vector<HeightGate> nearGates_;
  std::vector<double> distance_;
  std::vector<double> floor_;                   ///< S_j, as far as known
  std::vector<double> profile_;                 ///< that the segment surely reaches: pitch limits and majorant over floor_
  std::vector<double> safeAltitude_;            ///< A(q_j)
  std::vector<std::optional<Answer>> answers_;  ///< nothing: glides on to the next point and from there
  std::vector<std::size_t> hull_;
};

}  // namespace vp::tour
