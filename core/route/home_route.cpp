// The ways from and to home around the closed tour: altitudes, where the guarantee begins, names, and the plan that the checker is given.
#include "core/route/home_route.h"

#include "core/aircraft/glide_model.h"
#include "core/landing/required_height.h"
#include "core/mission/glide_conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::route {
namespace {

constexpr double kEnough = 1e-6;  // m, altitudes that are alike

const mission::SiteInFrame& siteOf(const mission::Plan& plan, const std::optional<mission::HomePath>& path) {
  return plan.sites[static_cast<std::size_t>(path->site)];
}

/// Whether an aircraft whose engine stops above the threshold on the landing course has arrived.
bool endsAtThreshold(const landing::World& world) {
  return world.approach.kind == mission::ApproachKind::Threshold && !world.approach.hold && world.reactionLength <= 0.0 && world.reactionLoss <= 0.0;
}

/// The decision point of the closed tour's path in the middle of a corner's turn.
std::size_t pointAt(const FlownPoints& flown, double distance) {
  const auto nearest = std::min_element(flown.distance.begin(), flown.distance.end(),
                                        [&](double a, double b) { return std::abs(a - distance) < std::abs(b - distance); });
  return static_cast<std::size_t>(nearest - flown.distance.begin());
}

}  // namespace

double HomeRoute::loopDistance(std::size_t corner) const {
  const auto at = std::find(loop_->knots.corner.begin(), loop_->knots.corner.end(), corner);
  return loop_->knots.distance[static_cast<std::size_t>(at - loop_->knots.corner.begin())];
}

Result<HomeRoute> HomeRoute::layOut(const mission::Plan& plan, const Ground* ground, const Layout& loop, const FlownPoints& flown,
                                    const RouteOptions& options, int moreCircles, const Job& job) {
  HomeRoute home(plan, loop);
  home.pitch_ = pitchOf(plan);
  home.isGroundKnown_ = ground != nullptr;
  Result<HomeWay> departure = flyDeparture(plan, loop, options, moreCircles);
  Result<HomeWay> arrival = flyArrival(plan, loop, options);
  if (!departure || !arrival) {
    return forward(!departure ? departure : arrival);
  }
  home.departure_.flown = std::move(*departure);
  home.arrival_.flown = std::move(*arrival);
  home.corners_ = loopCornersFlown(plan, loop, home.departure_.flown, home.arrival_.flown);
  const mission::SiteInFrame& landing = siteOf(plan, plan.arrival);
  mission::DecisionPoint threshold;
  threshold.pose = landing.pose;
  threshold.safeAltitude = landing.site.elevation.metres() + plan.mission.safety.arrivalMargin.si();
  threshold.witness.site = plan.arrival->site;
  if (ground != nullptr && !endsAtThreshold(ground->world)) {
    landing::QueryScratch scratch;
    const auto answer = ground->roadmap->query(ground->world, threshold.pose, scratch);
    threshold.safeAltitude = answer ? answer->altitude : std::numeric_limits<double>::infinity();
    threshold.witness = answer ? mission::Witness{answer->site, ground->roadmap->witnessPieces(*answer)} : mission::Witness{};
  } else if (ground != nullptr) {
    const double clear = landing::maxTerrainAlong(ground->world.terrain, threshold.pose, threshold.onward) + ground->world.clearance;
    threshold.safeAltitude = std::max(threshold.safeAltitude, clear);
  }
  const mission::DecisionPoint& joined = flown.points[pointAt(flown, home.loopDistance(home.departure_.flown.join))];
  for (Way* way : {&home.departure_, &home.arrival_}) {
    std::vector<double> marks;
    for (const HomeKnot& knot : way->flown.knots) {
      marks.push_back(knot.distance);
    }
    Result<FlownPoints> points =
        openPoints(ground != nullptr ? &ground->world : nullptr, ground != nullptr ? ground->roadmap.get() : nullptr, way->flown.path,
                   std::move(marks), plan.mission.planner.step.si(), way == &home.departure_ ? joined : threshold, job);
    if (!points) {
      return forward(points);
    }
    way->points = std::move(*points);
  }
  return home;
}

void HomeRoute::setKnots(Way& way, bool isDeparture, const std::vector<double>& loopAltitudes) const {
  way.knots.clear();
  if (isDeparture) {
    way.knots.push_back({0.0, siteOf(*plan_, plan_->departure).site.elevation.metres()});
  }
  way.ends = way.knots.size();
  for (const HomeKnot& knot : way.flown.knots) {
    const bool isShared = knot.loop >= 0;
    way.knots.push_back({knot.distance, isShared ? std::optional(loopAltitudes[static_cast<std::size_t>(knot.loop)]) : std::nullopt});
  }
}

void HomeRoute::setAltitudes(Way& way, bool isDeparture) const {
  std::vector<Required> wanted = way.flown.comparison.required;
  for (std::size_t i = 0; i < way.points.points.size(); ++i) {
    const double lowest = way.points.lowest[i];
    if (std::isfinite(lowest) && (!isDeparture || way.points.distance[i] >= way.flown.certifiedGuarantee)) {
      wanted.push_back({way.points.distance[i], lowest});
    }
  }
  way.altitudes = wayAltitudes(way.knots, wanted, pitch_);
  for (std::size_t i = 0; i < way.points.points.size(); ++i) {
    way.points.points[i].altitude = altitudeBetween(way.knots, way.altitudes, way.points.distance[i]);
  }
}

/// Where a way cannot be high enough or is too steep between the altitudes of the closed tour, those are to be raised.
void HomeRoute::askFor(const Way& way, bool isDeparture, const std::vector<double>& loopAltitudes, std::vector<Required>& raised) const {
  const auto firstShared = std::find_if(way.flown.knots.begin(), way.flown.knots.end(), [](const HomeKnot& k) { return k.loop >= 0; })->distance;
  double lacking = 0.0;
  for (std::size_t i = 0; i < way.points.points.size(); ++i) {
    if (std::isfinite(way.points.lowest[i]) && (!isDeparture || way.points.distance[i] >= firstShared)) {
      lacking = std::max(lacking, way.points.lowest[i] - way.points.points[i].altitude);
    }
  }
  for (std::size_t i = 0; i < way.flown.knots.size(); ++i) {
    const int corner = way.flown.knots[i].loop;
    if (corner < 0) {
      continue;
    }
    const std::size_t k = i + way.ends;
    double least = loopAltitudes[static_cast<std::size_t>(corner)] + (lacking > kEnough ? lacking : 0.0);
    if (k + 1 < way.knots.size() && way.knots[k + 1].altitude) {
      least = std::max(least, way.altitudes[k + 1] - pitch_.climb * (way.knots[k + 1].distance - way.knots[k].distance));
    }
    if (k > 0 && (way.knots[k - 1].altitude || isDeparture)) {
      least = std::max(least, way.altitudes[k - 1] - pitch_.descent * (way.knots[k].distance - way.knots[k - 1].distance));
    }
    if (least > loopAltitudes[static_cast<std::size_t>(corner)] + kEnough) {
      raised.push_back({loopDistance(static_cast<std::size_t>(corner)), least});
    }
  }
}

void HomeRoute::findGuarantee() {
  const double runway = siteOf(*plan_, plan_->departure).site.elevation.metres();
  const FlownPoints& flown = departure_.points;
  guaranteed_ = flown.points.size() - 1;
  while (guaranteed_ > 0 && flown.points[guaranteed_ - 1].altitude >= flown.lowest[guaranteed_ - 1] - kEnough &&
         flown.points[guaranteed_ - 1].altitude > runway) {
    --guaranteed_;
  }
}

std::vector<Required> HomeRoute::fit(const std::vector<double>& loopAltitudes) {
  std::vector<Required> raised;
  for (Way* way : {&departure_, &arrival_}) {
    const bool isDeparture = way == &departure_;
    setKnots(*way, isDeparture, loopAltitudes);
    setAltitudes(*way, isDeparture);
    askFor(*way, isDeparture, loopAltitudes, raised);
  }
  findGuarantee();
  return raised;
}

bool HomeRoute::keepsItsPromise() const {
  for (std::size_t i = 0; i + 1 < departure_.knots.size(); ++i) {
    const double most = pitch_.climb * (departure_.knots[i + 1].distance - departure_.knots[i].distance);
    if (departure_.altitudes[i + 1] - departure_.altitudes[i] > most + kEnough) {
      return false;
    }
  }
  const double circle =
      2.0 * Angle::kPi * aircraft::GlideModel(plan_->mission.aircraft, mission::glideConditionsOf(plan_->mission, plan_->sites)).tourRadius();
  return departure_.points.distance[guaranteed_] <= departure_.flown.certifiedGuarantee + circle;
}

double HomeRoute::above(const Way& way) const {
  const Track certified = trackOfWay(way.flown.certified);
  Follower follower(certified, 0.0);
  double most = 0.0;
  for (const mission::DecisionPoint& point : way.points.points) {
    most = std::max(most, point.altitude - altitudeOn(certified, follower.next(point.pose.point()).distance));
  }
  return most;
}

mission::HomePath HomeRoute::pathOf(const Way& way, int site, int join, int guaranteed) const {
  mission::HomePath path{site, join, guaranteed, way.points.points};
  for (int i = 0; i < guaranteed; ++i) {
    mission::DecisionPoint& point = path.points[static_cast<std::size_t>(i)];
    point.safeAltitude = 0.0;
    point.witness = {};
  }
  return path;
}

void HomeRoute::addTo(const std::vector<double>& loopAltitudes, BuiltRoute& built) const {
  mission::Plan& plan = built.reflown;
  const auto joinOf = [&](const Way& way) {
    const geo::Pose pose = poseOn(loop_->path, loopDistance(way.flown.join));
    const auto nearest = std::min_element(plan.tour.begin(), plan.tour.end(), [&](const auto& a, const auto& b) {
      const auto off = [&](const mission::DecisionPoint& p) {
        return geo::distance(p.pose.point(), pose.point()) + std::abs(std::remainder(p.pose.heading - pose.heading, 2.0 * Angle::kPi));
      };
      return off(a) < off(b);
    });
    return static_cast<int>(nearest - plan.tour.begin());
  };
  plan.mission.home = plan_->mission.home;
  plan.departure = pathOf(departure_, plan_->departure->site, joinOf(departure_), static_cast<int>(guaranteed_));
  plan.arrival = pathOf(arrival_, plan_->arrival->site, joinOf(arrival_), 0);
  const mission::DecisionPoint& left = plan.tour[static_cast<std::size_t>(plan.arrival->join)];
  plan.arrival->points.front().pose = left.pose;
  mission::Route& route = built.route;
  route.isClosed = false;
  route.lateral = std::max({route.lateral, departure_.flown.comparison.lateral, arrival_.flown.comparison.lateral});
  route.above = std::max({route.above, above(departure_), above(arrival_)});
  addFlown(loopAltitudes, route);
  addWaypoints(route);
  route.guarantee = guaranteeText();
}

}  // namespace vp::route
