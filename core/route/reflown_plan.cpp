#include "core/route/reflown_plan.h"

#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/approach.h"
#include "core/landing/glide_straightener.h"
#include "core/landing/required_height.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::route {
namespace {

constexpr double kSame = 1e-6;  // m along the path: one place
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Cuts the path at the marks and into steps. Poses follow from the start of each piece, so errors do not add up within it.
FlownPoints cut(const FlownPath& path, std::vector<double> marks, double step) {
  std::sort(marks.begin(), marks.end());
  FlownPoints flown;
  geo::Pose pose = path.start;
  double begin = 0.0;
  auto mark = marks.begin();
  for (const flight::Piece& piece : path.pieces) {
    std::vector<double> cuts{0.0};
    for (; mark != marks.end() && *mark < begin + piece.length - kSame; ++mark) {
      if (*mark - begin > cuts.back() + kSame) {
        cuts.push_back(*mark - begin);
      }
    }
    cuts.push_back(piece.length);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double length = cuts[i + 1] - cuts[i];
      const int parts = std::max(1, static_cast<int>(std::ceil(length / step)));
      for (int k = 0; k < parts; ++k) {
        const double at = cuts[i] + length * k / parts;
        mission::DecisionPoint point;
        point.pose = flight::poseAfter(pose, piece, at);
        point.onward = {piece.turn, piece.radius, length / parts};
        flown.points.push_back(point);
        flown.distance.push_back(begin + at);
      }
    }
    pose = flight::endOf(pose, piece);
    begin += piece.length;
  }
  return flown;
}

/// What the glides of points need, and the way on from each.
class Needs {
public:
  Needs(const landing::World& world, const landing::Roadmap& roadmap, FlownPoints& flown)
      : world_(world),
        roadmap_(roadmap),
        flown_(flown),
        clear_(flown.points.size(), -kInfinite),
        loss_(flown.points.size(), 0.0),
        turning_(flown.points.size()) {}

  /// @return false if stopped
  bool ask(std::size_t count, const Job& job) {
    landing::QueryScratch scratch;
    int hint = -1;
    for (std::size_t i = count; i-- > 0;) {
      if (job.stopRequested()) {
        return false;
      }
      mission::DecisionPoint& point = flown_.points[i];
      clear_[i] = landing::maxTerrainAlong(world_.terrain, point.pose, point.onward) + world_.clearance;
      loss_[i] = flight::mostLossOver(world_.glide, point.pose, point.onward);
      const std::optional<landing::SafeAltitude> answer = roadmap_.query(world_, point.pose, scratch, hint);
      point.safeAltitude = kInfinite;
      if (answer) {
        hint = answer->node;
        point.safeAltitude = answer->altitude;
        point.witness = {answer->site, roadmap_.witnessPieces(*answer)};
      }
      if (world_.reactionLength > 0.0) {
        turning_[i] = roadmap_.queryTurning(world_, point.pose, scratch, hint);
      }
    }
    return true;
  }

  /// Following the path while the pilot reacts, and turning where that is over. @param isClosed  whether the path goes on at its start
  void turnLater(std::size_t i, bool isClosed) {
    std::vector<flight::Piece> way;
    double flown = 0.0;
    double lost = 0.0;
    double needed = -kInfinite;
    std::vector<std::size_t> passed;
    std::size_t at = i;
    while (flown < world_.reactionLength && way.size() < clear_.size()) {
      lost += loss_[at];
      needed = std::max(needed, clear_[at] + lost);
      passed.push_back(at);
      way.push_back(flown_.points[at].onward);
      flown += way.back().length;
      at = isClosed ? (at + 1) % clear_.size() : at + 1;
      if (at == clear_.size()) {
        return;
      }
    }
    mission::DecisionPoint& point = flown_.points[i];
    if (const std::optional<landing::SafeAltitude>& turning = turning_[at]; turning && flown >= world_.reactionLength) {
      double altitude = turning->altitude;
      if (world_.glide.bands() == nullptr) {
        altitude = std::max(needed, altitude + lost);
      } else {
        for (std::size_t back = passed.size(); back-- > 0;) {
          altitude = heightBefore(passed[back], std::max(altitude, clear_[passed[back]]), 0.0);
        }
      }
      altitude += world_.reactionLoss;
      if (altitude < point.safeAltitude) {
        way = landing::joinedGlide(world_, {}, way);
        point.safeAltitude = altitude;
        point.witness = {turning->site, landing::joinedGlide(world_, std::move(way), roadmap_.witnessPieces(*turning))};
      }
    }
  }

  /// Gliding on along the path to the next point and from there.
  void glideOn(std::size_t i, std::size_t nextIndex) {
    mission::DecisionPoint& point = flown_.points[i];
    const mission::DecisionPoint& next = flown_.points[nextIndex];
    const double onward = heightBefore(i, std::max(next.safeAltitude, clear_[i] + world_.reactionLoss), world_.reactionLoss);
    if (onward < point.safeAltitude && next.witness.site >= 0) {
      point.safeAltitude = onward;
      point.witness = {next.witness.site, landing::joinedGlide(world_, {point.onward}, next.witness.pieces)};
    }
  }

  /// Fewer turns, and what rolling asks for.
  void straighten(const landing::GlideStraightener& straightener, std::size_t i, const flight::Piece& before) {
    mission::DecisionPoint& point = flown_.points[i];
    if (point.witness.site >= 0 && point.safeAltitude < kInfinite) {
      auto [pieces, safeAltitude] =
          straightener.improved(point.pose, before, {std::move(point.witness.pieces), point.safeAltitude}, point.witness.site, point.safeAltitude);
      point.witness.pieces = std::move(pieces);
      point.safeAltitude = safeAltitude;
    }
  }

  /// @param before  clearance over the way to the point
  [[nodiscard]] double lowestAt(std::size_t i, std::size_t next, double before) const {
    const double glide = heightBefore(i, std::max(flown_.points[next].safeAltitude, clear_[i] + world_.reactionLoss), world_.reactionLoss);
    return std::max({flown_.points[i].safeAltitude, glide, before});
  }
  /// Above the ground of the way on, so that an engine failure at its end leaves the clearance.
  [[nodiscard]] double clearAt(std::size_t i) const { return clear_[i] + world_.reactionLoss; }

private:
  /// Height at a point from which a glide along the way on ends at `end` or higher; both before `lostAtOnce` is lost.
  [[nodiscard]] double heightBefore(std::size_t i, double end, double lostAtOnce) const {
    const mission::DecisionPoint& point = flown_.points[i];
    return world_.glide.bands() == nullptr ? end + loss_[i] : flight::mostHeightBefore(world_.glide, point.pose, point.onward, end, lostAtOnce);
  }

  const landing::World& world_;
  const landing::Roadmap& roadmap_;
  FlownPoints& flown_;
  std::vector<double> clear_;                                  // ground under the way on, and the clearance
  std::vector<double> loss_;                                   // on the way on, at any altitude
  std::vector<std::optional<landing::SafeAltitude>> turning_;  // of a pilot who has reacted; none where that takes no time
};

/// "0.3 km from Aletsch (46.35012, 8.05201)"
std::string placeInWords(const mission::Plan& plan, const FlownPoints& flown, std::size_t i) {
  const geo::Point at = flown.points[i].pose.point();
  const geo::LatLon place = geo::LocalFrame(plan.frameOrigin).toLatLon(at);
  const auto target = std::min_element(plan.targets.begin(), plan.targets.end(),
                                       [&](const auto& a, const auto& b) { return geo::distance(a.point, at) < geo::distance(b.point, at); });
  const std::string position = fmt::format("{:.5f}, {:.5f}", place.latitude_deg, place.longitude_deg);
  if (target == plan.targets.end()) {
    return "at " + position;
  }
  const std::string& name = target->target.name;
  return fmt::format("{:.1f} km from {} ({})", geo::distance(target->point, at) / 1000.0, name.empty() ? "a target" : name, position);
}

tl::unexpected<Error> stopped() {
  return fail(Errc::Cancelled, "stopped while checking the waypoints");
}

}  // namespace

Result<FlownPoints> flownPoints(const mission::Plan& plan, const landing::World* world, const landing::Roadmap* roadmap, const FlownPath& path,
                                std::vector<double> marks, const Job& job) {
  FlownPoints flown = cut(path, std::move(marks), plan.mission.planner.step.si());
  const std::size_t count = flown.points.size();
  if (world == nullptr || roadmap == nullptr) {
    flown.lowest.assign(count, -kInfinite);
    return flown;
  }
  Needs needs(*world, *roadmap, flown);
  if (!needs.ask(count, job)) {
    return stopped();
  }
  for (std::size_t i = 0; world->reactionLength > 0.0 && i < count; ++i) {
    needs.turnLater(i, true);
  }
  for (std::size_t k = 2 * count; k-- > 0;) {  // twice around, for the chain of glides goes over the start
    needs.glideOn(k % count, (k + 1) % count);
  }
  const landing::GlideStraightener straightener(*world);
  for (std::size_t i = 0; i < count; ++i) {
    needs.straighten(straightener, i, flown.points[(i + count - 1) % count].onward);
  }
  flown.lowest.resize(count);
  for (std::size_t i = 0; i < count; ++i) {  // first, for unknown ground takes the glides of others too
    if (!(needs.clearAt(i) < kInfinite)) {
      return fail(Errc::NoSolution, "flown from waypoint to waypoint the path comes over ground of unknown height " + placeInWords(plan, flown, i));
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    flown.lowest[i] = needs.lowestAt(i, (i + 1) % count, needs.clearAt((i + count - 1) % count));
    if (!(flown.lowest[i] < kInfinite)) {
      return fail(Errc::NoSolution, "flown from waypoint to waypoint no glide reaches a landing site from the place " + placeInWords(plan, flown, i));
    }
  }
  return flown;
}

Result<FlownPoints> openPoints(const landing::World* world, const landing::Roadmap* roadmap, const FlownPath& path, std::vector<double> marks,
                               double step, mission::DecisionPoint end, const Job& job) {
  FlownPoints flown = cut(path, std::move(marks), step);
  end.onward = {};
  end.target = -1;
  flown.points.push_back(std::move(end));
  flown.distance.push_back(path.length);
  const std::size_t last = flown.points.size() - 1;
  if (world == nullptr || roadmap == nullptr) {
    flown.lowest.assign(last + 1, -kInfinite);
    return flown;
  }
  Needs needs(*world, *roadmap, flown);
  if (!needs.ask(last, job)) {
    return stopped();
  }
  const landing::GlideStraightener straightener(*world);
  flown.lowest.assign(last + 1, kInfinite);
  needs.straighten(straightener, last, last > 0 ? flown.points[last - 1].onward : flight::Piece());
  flown.lowest[last] = std::max(flown.points[last].safeAltitude, last > 0 ? needs.clearAt(last - 1) : -kInfinite);
  for (std::size_t i = last; i-- > 0;) {
    if (world->reactionLength > 0.0) {
      needs.turnLater(i, false);
    }
    needs.glideOn(i, i + 1);
    needs.straighten(straightener, i, i > 0 ? flown.points[i - 1].onward : flight::Piece());
    flown.lowest[i] = needs.lowestAt(i, i + 1, i > 0 ? needs.clearAt(i - 1) : -kInfinite);
  }
  return flown;
}

}  // namespace vp::route
