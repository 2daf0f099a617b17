// The ways from and to a home runway as waypoints that lead into and out of those of the closed tour.
#include "core/route/home_ways.h"

#include "core/aircraft/glide_model.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/dubins.h"
#include "core/mission/glide_conditions.h"
#include "core/route/keep_out.h"
#include "core/route/way_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vp::route {
namespace {

constexpr std::size_t kShared = 100;   // corners within which the paths must have become one
constexpr double kSamePlace = 1e-4;    // m, a tenth of what the checker allows for a gap
constexpr double kSameHeading = 1e-7;  // rad, the same
constexpr double kMetresPerDegree = 111200.0;
constexpr double kLineUp = 150.0;                                    // m before the threshold, at least, where lining up with the centre line begins
constexpr double kLineUpRadii = 1.5;                                 // of the turn, the same: room for an S-turn that makes up for half a radius
constexpr double kLineUpFactors[] = {1.0, 1.5, 2.0, 3.0, 4.0, 6.0};  // from farther away where that is too near
constexpr double kMostExtra = 30.0;                                  // m that lining up may add or save; more is a circle
constexpr double kLeastMargin = 0.5;                                 // m that the last turn ends before the threshold, plus
constexpr double kMarginSteps = 4.0;                                 // steps of the file's places
constexpr double kRoomSteps = 1.5;                                   // steps of the file's places, for circles
constexpr double kMostBefore = 0.6;                                  // rad before the landing course
constexpr double kMarginFactors[] = {1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0};

bool isOnePath(const geo::Pose& a, const geo::Pose& b) {
  return geo::distance(a.point(), b.point()) <= kSamePlace && std::abs(std::remainder(a.heading - b.heading, 2.0 * Angle::kPi)) <= kSameHeading;
}

std::optional<std::size_t> meetsAt(const Layout& loop, const FlownPath& path, const std::vector<std::size_t>& shared, std::size_t firstPassed,
                                   std::size_t i) {
  const std::size_t corner = shared[i];
  const bool isOne = isOnePath(poseOn(path, path.passed[firstPassed + i]), poseOn(loop.path, loop.path.passed[corner]));
  return isOne ? std::optional(i) : std::nullopt;
}

tl::unexpected<Error> tooClose(const char* way) {
  return fail(Errc::OutOfRange, std::string("the turns where the way ") + way +
                                    " home meets the tour follow each other too closely to be flown from waypoint to waypoint");
}

void ascend(std::vector<HomeKnot>& knots) {
  for (std::size_t i = 1; i < knots.size(); ++i) {
    knots[i].distance = std::max(knots[i].distance, knots[i - 1].distance + 1e-3);
  }
}

void measure(HomeWay& way) {
  way.track = trackOf(way.path.start, way.path.pieces);
  way.track.isClosed = false;
  std::vector<double> marks;
  for (const HomeKnot& knot : way.knots) {
    marks.push_back(knot.distance);
  }
  way.comparison = compareWays(trackOfWay(way.certified), way.track, marks);
}

/// Own corners between the ends of a stretch of certified way, rounded.
void makeCorners(const std::vector<mission::DecisionPoint>& stretch, const CornerLimits& limits, HomeWay& way) {
  way.corners.clear();
  way.places.clear();
  if (stretch.size() >= 2) {
    way.corners = openCorners(stretch, limits);
    way.corners.erase(way.corners.begin());
    way.corners.pop_back();
  }
}

class DepartureMaker {
public:
  DepartureMaker(const mission::Plan& plan, const Layout& loop, double steps, int moreCircles) : plan_(plan), loop_(loop), steps_(steps) {
    const mission::HomePath& path = *plan.departure;
    const Ruler ruler(plan);
    const double join = ruler.at(path.join);
    const std::size_t count = loop.corners.size();
    const std::size_t first = nearestCorner(loop, ruler, join, true);
    for (std::size_t i = 0; i <= std::min(kShared, count - 1); ++i) {
      shared_.push_back((first + i) % count);
    }
    way_.assign(path.points.begin(), path.points.end() - 1);
    for (int i = 0; i < path.guaranteed; ++i) {
      guarantee_ += path.points[static_cast<std::size_t>(i)].onward.length;
    }
    for (int i = 0; i < moreCircles; ++i) {
      const double before = lengthOf(way_);
      addCircle(way_);
      guarantee_ += lengthOf(way_) - before;
    }
    for (const mission::DecisionPoint& point : way_) {
      base_ += point.onward.length;
    }
    entry_ = base_ + ruler.onward(join, entryOf(loop.corners[first]));
    for (const std::size_t corner : shared_) {
      middle_.push_back(entry_ + ruler.onward(entryOf(loop.corners[first]), loop.corners[corner].tourDistance));
    }
    appendTour(plan, static_cast<std::size_t>(path.join), middle_.back() - base_, way_);
  }

  Result<HomeWay> make(const CornerLimits& limits, double leastLeg) const {
    const geo::LocalFrame frame(plan_.frameOrigin);
    HomeWay made;
    made.certifiedGuarantee = guarantee_;
    const Circles circles = circlesOf(way_);
    makeCorners(cutWay(way_, circles.count * circles.length, entry_), limits, made);
    addCircles(circles, made.corners);
    roundPlaces(frame, steps_, leastLeg, made.corners, made.places);
    if (!made.corners.empty() && made.corners.back().target < 0 &&
        geo::distance(made.corners.back().point, loop_.corners[shared_.front()].point) < leastLeg) {
      made.corners.pop_back();
      made.places.pop_back();
    }
    std::vector<Corner> corners = made.corners;
    for (const std::size_t corner : shared_) {
      corners.push_back(loop_.corners[corner]);
    }
    const std::size_t own = made.corners.size();
    const FlownPath path = flyOpen(way_.front().pose, corners);
    std::optional<std::size_t> join;
    for (std::size_t i = 1; i + 1 < shared_.size() && !join; ++i) {
      join = meetsAt(loop_, path, shared_, own, i);
    }
    if (!join) {
      return tooClose("from");
    }
    made.join = shared_[*join];
    made.path = partOf(path, 0.0, path.passed[own + *join]);
    for (std::size_t i = 0; i < own; ++i) {
      made.knots.push_back({static_cast<int>(i), -1, path.passed[i], path.turned[i]});
    }
    for (std::size_t i = 0; i <= *join; ++i) {
      made.knots.push_back({-1, static_cast<int>(shared_[i]), path.passed[own + i], path.turned[own + i]});
    }
    ascend(made.knots);
    made.certified = cutWay(way_, 0.0, middle_[*join]);
    measure(made);
    return made;
  }

private:
  /// Three corners a circle, of a circle that is wider by some steps of the file's places: else turn would follow turn without a straight
  /// part, and what rounding moves could not be made up for.
  void addCircles(const Circles& circles, std::vector<Corner>& corners) const {
    const mission::DecisionPoint& start = way_.front();
    const double wider = start.onward.radius + kLeastMargin + kRoomSteps * kMetresPerDegree / steps_;
    const double side = static_cast<double>(static_cast<int>(start.onward.turn));
    const double lead = wider * std::tan(Angle::kPi / 3.0);
    std::vector<Corner> all;
    geo::Pose pose = start.pose;
    for (int i = 0; i < 3 * circles.count; ++i) {
      Corner corner;
      corner.point = {pose.x + lead * std::cos(pose.heading), pose.y + lead * std::sin(pose.heading)};
      corner.radius = start.onward.radius;
      corner.angle = side * 2.0 * Angle::kPi / 3.0;
      corner.tourDistance = (i + 0.5) * circles.length / 3.0;
      corner.entry = pose;
      all.push_back(corner);
      pose = flight::poseAfter(pose, {start.onward.turn, wider, wider * 2.0 * Angle::kPi / 3.0}, wider * 2.0 * Angle::kPi / 3.0);
    }
    corners.insert(corners.begin(), all.begin(), all.end());
  }

  const mission::Plan& plan_;
  const Layout& loop_;
  double steps_;
  std::vector<mission::DecisionPoint> way_;
  std::vector<std::size_t> shared_;
  double guarantee_ = 0.0;
  double base_ = 0.0;           ///< m along the way at which it joins the tour
  double entry_ = 0.0;          ///< m along the way to the turn of the first shared corner
  std::vector<double> middle_;  ///< m along the way to the middle of the turn of each shared corner
};

class ArrivalMaker {
public:
  ArrivalMaker(const mission::Plan& plan, const Layout& loop, double steps) : plan_(plan), loop_(loop), steps_(steps) {
    const mission::HomePath& path = *plan.arrival;
    const Ruler ruler(plan);
    const double leave = ruler.at(path.join);
    const std::size_t count = loop.corners.size();
    const std::size_t last = nearestCorner(loop, ruler, leave, false);
    for (const std::size_t back : {2U, 1U, 0U}) {
      shared_.push_back((last + count - back) % count);
    }
    const double behind = ruler.onward(exitOf(loop.corners[last]), leave);
    double back = 0.0;
    for (const std::size_t corner : shared_) {
      back = std::max(back, behind + ruler.onward(loop.corners[corner].tourDistance, exitOf(loop.corners[last])));
    }
    auto begin = static_cast<std::size_t>(path.join);
    double done = 0.0;
    while (done < back + kOnePlace) {
      begin = (begin + plan.tour.size() - 1) % plan.tour.size();
      done += plan.tour[begin].onward.length;
    }
    for (std::size_t i = begin; i != static_cast<std::size_t>(path.join) || way_.empty(); i = (i + 1) % plan.tour.size()) {
      way_.push_back(plan.tour[i]);
    }
    way_.insert(way_.end(), path.points.begin(), path.points.end());
    exit_ = done - behind;
    for (const std::size_t corner : shared_) {
      middle_.push_back(exit_ - ruler.onward(loop.corners[corner].tourDistance, exitOf(loop.corners[last])));
    }
    length_ = lengthOf(way_);
    end_ = plan.sites[static_cast<std::size_t>(path.site)].pose;
  }

  Result<HomeWay> make(const CornerLimits& limits, double leastLeg, double margin) const {
    const geo::LocalFrame frame(plan_.frameOrigin);
    HomeWay made;
    makeCorners(cutWay(way_, exit_, length_), limits, made);
    endEarlier(margin, made.corners);
    roundPlaces(frame, steps_, leastLeg, made.corners, made.places);
    std::vector<Corner> corners;
    for (const std::size_t corner : shared_) {
      corners.push_back(loop_.corners[corner]);
    }
    const std::size_t firstOwn = corners.size();
    corners.insert(corners.end(), made.corners.begin(), made.corners.end());
    Corner threshold = corners.back();
    threshold.point = end_.point();
    threshold.target = -1;
    corners.push_back(threshold);
    // From the loop's own path behind the first shared corner's turn, so the second is flown as the loop flies it.
    const double behind = loop_.path.passed[shared_[0]] + std::abs(loop_.path.turned[shared_[0]]) * corners.front().radius / 2.0;
    const FlownPath path = flyOn(poseOn(loop_.path, std::fmod(behind, loop_.path.length)), corners);
    if (!meetsAt(loop_, path, shared_, 0, 1)) {
      return tooClose("to");
    }
    const double from = path.passed[1];
    made.join = shared_[1];
    made.path = partOf(path, from, path.length);
    for (std::size_t i = 1; i < shared_.size(); ++i) {
      made.knots.push_back({-1, static_cast<int>(shared_[i]), path.passed[i] - from, path.turned[i]});
    }
    for (std::size_t i = 0; i <= made.corners.size(); ++i) {
      made.knots.push_back({static_cast<int>(i), -1, path.passed[firstOwn + i] - from, path.turned[firstOwn + i]});
    }
    if (!lineUp(made)) {
      return tooClose("to");
    }
    made.corners.push_back(threshold);
    const geo::LatLon exact = frame.toLatLon(threshold.point);
    made.places.push_back({std::round(exact.latitude_deg * steps_) / steps_, std::round(exact.longitude_deg * steps_) / steps_});
    ascend(made.knots);
    made.certified = cutWay(way_, middle_[1], length_);
    measure(made);
    return made;
  }

private:
  /// A way that ends in a turn leaves no room for rounded places; so its last circle is moved back by some metres, along a course within the
  /// turn: from it to that of the threshold leads turn, straight part, turn, whatever rounding adds.
  void endEarlier(double margin, std::vector<Corner>& corners) const {
    double arc = 0.0;
    double radius = 0.0;
    auto turn = flight::Turn::Straight;
    for (std::size_t i = way_.size() - 1; i-- > 0 && way_[i].onward.turn != flight::Turn::Straight;) {
      if (arc > 0.0 && way_[i].onward.turn != turn) {
        break;
      }
      turn = way_[i].onward.turn;
      radius = way_[i].onward.radius;
      arc += way_[i].onward.length;
    }
    if (arc <= 0.0) {
      return;
    }
    const double before = std::min(kMostBefore, 0.5 * arc / radius) * static_cast<double>(static_cast<int>(turn));
    const double begin = length_ - exit_ - arc;
    for (Corner& corner : corners) {
      if (corner.tourDistance > begin) {
        corner.point.x -= margin * std::cos(end_.heading - before);
        corner.point.y -= margin * std::sin(end_.heading - before);
      }
    }
  }

  /// Replaces the end of the path by the shortest one onto the threshold on the landing course.
  bool lineUp(HomeWay& made) const {
    const double radius = aircraft::GlideModel(plan_.mission.aircraft, mission::glideConditionsOf(plan_.mission, plan_.sites)).tourRadius();
    const double old = made.path.length;
    double at = 0.0;
    flight::DubinsPath end;
    for (const double factor : kLineUpFactors) {
      at = std::max(0.0, old - factor * std::max(kLineUp, kLineUpRadii * radius));
      end = flight::shortestDubins(poseOn(made.path, at), end_, radius);
      if (std::abs(end.length() - (old - at)) <= kMostExtra) {
        break;
      }
    }
    if (std::abs(end.length() - (old - at)) > kMostExtra) {
      return false;
    }
    FlownPath path = partOf(made.path, 0.0, at);
    flight::appendPieces(end, path.pieces);
    path.length = at + end.length();
    for (HomeKnot& knot : made.knots) {
      if (knot.distance > at) {
        knot.distance = at + (knot.distance - at) * end.length() / (old - at);
      }
    }
    made.path = std::move(path);
    return true;
  }

  const mission::Plan& plan_;
  const Layout& loop_;
  double steps_;
  std::vector<mission::DecisionPoint> way_;
  std::vector<std::size_t> shared_;
  double exit_ = 0.0;  ///< m along the way to the end of the turn of the last shared corner
  std::vector<double> middle_;
  double length_ = 0.0;
  geo::Pose end_;
};

/// Fewer liberties until the way stays within the limits and out of forbidden airspace, as for the tour.
template <typename Make>
Result<HomeWay> bestWay(const mission::Plan& plan, const RouteOptions& options, const Make& make) {
  std::optional<HomeWay> best;
  std::pair<bool, double> least;
  Error error;
  for (const double leastLeg : kLeastLegs) {
    for (const double liberty : kLiberties) {
      CornerLimits limits = options.limits;
      limits.lateral *= liberty;
      Result<HomeWay> way = make(limits, leastLeg);
      if (!way) {
        error = way.error();
        continue;
      }
      const std::pair worst(KeepOut(plan, trackOfWay(way->certified)).isEnteredBy(way->track), way->comparison.lateral);
      if (!best || worst < least) {
        best = std::move(*way);
        least = worst;
      }
      if (!least.first && least.second <= options.lateral) {
        return std::move(*best);
      }
    }
  }
  return best ? Result<HomeWay>(std::move(*best)) : tl::unexpected(error);
}

}  // namespace

Result<HomeWay> flyDeparture(const mission::Plan& plan, const Layout& loop, const RouteOptions& options, int moreCircles) {
  const DepartureMaker maker(plan, loop, options.stepsPerDegree, moreCircles);
  return bestWay(plan, options, [&](const CornerLimits& limits, double leastLeg) { return maker.make(limits, leastLeg); });
}

Result<HomeWay> flyArrival(const mission::Plan& plan, const Layout& loop, const RouteOptions& options) {
  const ArrivalMaker maker(plan, loop, options.stepsPerDegree);
  const double margin = kLeastMargin + kMarginSteps * kMetresPerDegree / options.stepsPerDegree;
  return bestWay(plan, options, [&](const CornerLimits& limits, double leastLeg) {
    Result<HomeWay> way = maker.make(limits, leastLeg, margin);
    for (std::size_t i = 1; i < std::size(kMarginFactors) && !way; ++i) {
      way = maker.make(limits, leastLeg, margin * kMarginFactors[i]);
    }
    return way;
  });
}

std::vector<std::size_t> loopCornersFlown(const mission::Plan& plan, const Layout& loop, const HomeWay& departure, const HomeWay& arrival) {
  const Ruler ruler(plan);
  const std::size_t count = loop.corners.size();
  const auto firstKnot = std::find_if(departure.knots.begin(), departure.knots.end(), [](const HomeKnot& k) { return k.loop >= 0; });
  const auto lastKnot = std::find_if(arrival.knots.rbegin(), arrival.knots.rend(), [](const HomeKnot& k) { return k.loop >= 0; });
  const auto first = static_cast<std::size_t>(firstKnot->loop);
  const auto last = static_cast<std::size_t>(lastKnot->loop);
  const double joined = ruler.at(plan.departure->join);
  const double left = ruler.at(plan.arrival->join);
  // Around once; without the part between arrival and departure if no target lies there, else with the part from the departure to the arrival twice.
  double flown = ruler.length();
  if (plan.departure->join != plan.arrival->join) {
    bool isFree = true;
    const auto tour = static_cast<int>(plan.tour.size());
    for (int i = (plan.arrival->join + 1) % tour; i != plan.departure->join; i = (i + 1) % tour) {
      isFree = isFree && plan.tour[static_cast<std::size_t>(i)].target < 0;
    }
    flown += isFree ? -ruler.onward(left, joined) : ruler.onward(joined, left);
  }
  const double ahead = ruler.onward(joined, entryOf(loop.corners[first]));
  const double behind = ruler.onward(exitOf(loop.corners[last]), left);
  const double once = ruler.onward(entryOf(loop.corners[first]), exitOf(loop.corners[last]));
  const double laps = std::max(0.0, std::round((flown - ahead - behind - once) / ruler.length()));
  const auto steps = [&](std::size_t a, std::size_t b) { return (b + count - a) % count; };
  std::size_t more = steps(first, last) + static_cast<std::size_t>(laps) * count;
  while (more < steps(first, departure.join) + steps(arrival.join, last)) {
    more += count;
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i <= more; ++i) {
    corners.push_back((first + i) % count);
  }
  return corners;
}

}  // namespace vp::route
