#include "core/tour/assembly.h"

#include "core/base/quantity.h"
#include "core/flight/piece_loss.h"
#include "core/landing/glide_straightener.h"
#include "core/landing/required_height.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::tour {
namespace {

/** The closed loop as arrays: one entry per decision point, targets at the starts of segments. */
struct Loop {
  std::vector<SegmentPoint> points;
  std::vector<double> altitude;
  std::vector<double> step;  ///< to the next point
  std::vector<std::size_t> segmentStart;
  std::vector<SegmentGate> gates;
};

Result<Loop> joinSegments(SegmentBuilder& builder, const std::vector<VisitPose>& visits, const Job& job) {
  Loop loop;
  std::vector<SegmentPoint> ends;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    std::vector<SegmentPoint> points = builder.safePoints(visits[i], visits[(i + 1) % visits.size()]);
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while joining the tour");
    }
    for (const SegmentGate& gate : builder.gates()) {
      loop.gates.push_back({loop.points.size() + gate.point, gate.gate});
    }
    loop.segmentStart.push_back(loop.points.size());
    ends.push_back(std::move(points.back()));
    points.pop_back();
    for (SegmentPoint& point : points) {
      loop.altitude.push_back(point.lowest);
      loop.step.push_back(point.onward.length);
      loop.points.push_back(std::move(point));
    }
  }
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const std::size_t at = loop.segmentStart[(i + 1) % visits.size()];
    loop.altitude[at] = std::max(loop.altitude[at], ends[i].lowest);
    // The two segments asked for the safe altitude of this pose with different hints. The leg before counts on its own
    // answer, so the lower of the two goes into the plan.
    if (ends[i].safeAltitude < loop.points[at].safeAltitude) {
      loop.points[at].safeAltitude = ends[i].safeAltitude;
      loop.points[at].witness = std::move(ends[i].witness);
      loop.points[at].site = ends[i].site;
    }
  }
  return loop;
}

void makeConcave(Loop& loop) {
  std::vector<double> distance;
  std::vector<double> altitude;
  std::vector<std::size_t> scratch;
  for (std::size_t s = 0; s < loop.segmentStart.size(); ++s) {
    const std::size_t first = loop.segmentStart[s];
    const std::size_t end = s + 1 < loop.segmentStart.size() ? loop.segmentStart[s + 1] : loop.points.size();
    distance.assign(1, 0.0);
    altitude.assign(1, loop.altitude[first]);
    for (std::size_t i = first; i < end; ++i) {
      distance.push_back(distance.back() + loop.step[i]);
      altitude.push_back(loop.altitude[(i + 1) % loop.points.size()]);
    }
    concaveMajorant(distance, altitude, scratch);
    std::copy(altitude.begin(), altitude.end() - 1, loop.altitude.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

/// Pitch limits and concave segments, over the forbidden airspaces that the loop would enter from below.
Result<void> findAltitudes(Loop& loop, const SegmentSettings& settings) {
  for (bool again = true; again;) {
    again = false;
    raiseForPitchAround(loop.step, loop.altitude, settings.pitch);
    makeConcave(loop);
    for (const auto& [point, gate] : loop.gates) {
      double& from = loop.altitude[point];
      double& to = loop.altitude[(point + 1) % loop.altitude.size()];
      if (gate.isPassed(std::min(from, to), std::max(from, to))) {
        continue;
      }
      if (gate.ceiling > settings.ceiling) {
        return fail(Errc::NoSolution, fmt::format("joined into one loop within the pitch limits the tour is too high to pass below {}, which the "
                                                  "mission forbids to the tour, and there is no way over it; allow that airspace, raise the "
                                                  "ceiling, or move the targets beside it",
                                                  settings.forbidden->nameOf(gate.volume)));
      }
      from = std::max(from, gate.ceiling);
      to = std::max(to, gate.ceiling);
      again = true;
    }
  }
  return {};
}

/** Gives the glides of the loop fewer turns, within the height that each has from the tour, and raises the tour where rolling costs a glide more than
 *  the clearance.
 *  @return whether altitudes were raised: pitch limits are to be kept again. Nothing if stopped */
std::optional<bool> straightenGlides(const landing::World& world, Loop& loop, const Job& job) {
  const landing::GlideStraightener straightener(world);
  const std::size_t count = loop.points.size();
  std::vector<double> raised = loop.altitude;
  for (std::size_t i = 0; i < count; ++i) {
    if (job.stopRequested()) {
      return std::nullopt;
    }
    SegmentPoint& point = loop.points[i];
    const std::size_t last = (i + count - 1) % count;
    const SegmentPoint& before = loop.points[last];
    const double atHand = std::min(loop.altitude[i], loop.altitude[last] - flight::mostLossOver(world.glide, before.pose, before.onward));
    auto [pieces, safeAltitude] =
        straightener.improved(point.pose, before.onward, {std::move(point.witness), point.safeAltitude}, point.site, atHand);
    point.witness = std::move(pieces);
    point.safeAltitude = safeAltitude;
    raised[i] = std::max(raised[i], safeAltitude);
    raised[last] = std::max(raised[last], flight::mostHeightBefore(world.glide, before.pose, before.onward, safeAltitude, world.reactionLoss));
  }
  const bool isRaised = raised != loop.altitude;
  loop.altitude = std::move(raised);
  return isRaised;
}

/// The spiral of [1] Fig. 7 at a decision point; nothing if it gains less than a metre.
std::optional<mission::SpiralVisit> spiralAt(const landing::World& world, const geo::Pose& pose, double top, const VisitPose& visit,
                                             const SegmentSettings& settings) {
  const SpiralGround ground = spiralGround(world, settings.forbidden, pose, visit.altitude);
  const SpiralTurns turns = spiralTurns(ground, top, settings.pitch);
  if (turns.down == 0) {
    return std::nullopt;
  }
  return mission::SpiralVisit{visit.target, top, ground.bottomFrom(top), ground.turn, world.glide.tourRadius(), turns.down, turns.up};
}

}  // namespace

SpiralGround spiralGround(const landing::World& world, const ForbiddenAirspace* forbidden, const geo::Pose& pose, double targetAltitude) {
  SpiralGround best;
  std::vector<HeightGate> gates;
  best.circle = 2.0 * Angle::kPi * world.glide.tourRadius();
  for (const flight::Turn turn : {flight::Turn::Left, flight::Turn::Right}) {
    const flight::Piece circle{turn, world.glide.tourRadius(), best.circle};
    const double ground = landing::maxTerrainAlong(world.terrain, pose, circle);
    const double bottom = std::max(targetAltitude, ground + world.clearance);
    gates.clear();
    if (forbidden != nullptr) {
      forbidden->addGates(world.terrain, pose, circle, ground, gates);
    }
    // the side without airspace, then the one over lower ground
    if (std::isinf(best.bottom) || std::pair(gates.size(), bottom) < std::pair(best.gates.size(), best.bottom)) {
      best.bottom = bottom;
      best.turn = turn;
      best.gates = gates;
    }
  }
  return best;
}

Result<double> assembleTour(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits,
                            const SegmentSettings& settings, mission::LowTargets lowTargets, mission::Plan& plan, const Job& job) {
  Result<Loop> joined = joinSegments(builder, visits, job);
  if (!joined) {
    return forward(joined);
  }
  Loop& loop = *joined;
  if (const Result<void> found = findAltitudes(loop, settings); !found) {
    return forward(found);
  }
  const std::optional<bool> isRaised = straightenGlides(world, loop, job);
  if (!isRaised) {
    return fail(Errc::Cancelled, "stopped while joining the tour");
  }
  if (*isRaised) {
    if (const Result<void> found = findAltitudes(loop, settings); !found) {
      return forward(found);
    }
  }

  plan.tour.clear();
  plan.spirals.clear();
  double length = 0.0;
  double penalty = 0.0;
  double peak = -1e9;
  std::size_t visit = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    SegmentPoint& from = loop.points[i];
    mission::DecisionPoint point{from.pose, loop.altitude[i], from.safeAltitude, from.onward, {from.site, std::move(from.witness)}, -1};
    if (visit < visits.size() && loop.segmentStart[visit] == i) {
      point.target = visits[visit].target;
      double above = point.altitude - visits[visit].altitude;
      if (lowTargets == mission::LowTargets::Descend) {
        if (const auto spiral = spiralAt(world, point.pose, point.altitude, visits[visit], settings)) {
          plan.spirals.push_back(*spiral);
          const SpiralGround ground{spiral->bottom, 2.0 * Angle::kPi * spiral->radius, spiral->turn};
          length += spiralLength(ground, spiral->top, {spiral->turnsDown, spiral->turnsUp});
          above = spiral->bottom - visits[visit].altitude;
        }
      }
      penalty += settings.beta * above;
      ++visit;
    }
    length += std::hypot(loop.step[i], loop.altitude[(i + 1) % loop.altitude.size()] - loop.altitude[i]);
    peak = std::max(peak, point.altitude);
    plan.tour.push_back(std::move(point));
  }
  plan.metrics.length = length;
  plan.metrics.penalty = penalty;
  plan.metrics.cost = length + penalty;
  return peak;
}

}  // namespace vp::tour
