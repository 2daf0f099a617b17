#include "core/tour/home_path.h"

#include "core/tour/climb_out.h"
#include "core/tour/home_airspace.h"
#include "core/tour/home_joins.h"
#include "core/tour/home_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kSameAltitude = 1e-6;  // m, rounding of the pitch passes
constexpr double kMostCircles = 40.0;   // of a climb-out; a runway that needs more lies in a hole

/// Distances and altitudes of a segment whose one end lies on the tour.
struct Profile {
  std::vector<double> distance;
  std::vector<double> altitude;
};

class HomePlanner {
public:
  HomePlanner(const landing::World& world, const landing::Roadmap& roadmap, const SegmentSettings& settings, mission::Plan& plan, const Job& job)
      : world_(world), roadmap_(roadmap), settings_(settings), plan_(plan), job_(job), joins_(plan) {}

  Result<void> run();

private:
  /// With the circles of a climb-out. @return false if it comes too near to the ground, or into forbidden airspace
  Result<bool> attempt(SegmentBuilder& builder, const ClimbOut& climb);
  Result<Detours> findDetours() const;
  [[nodiscard]] std::optional<Error> runwayInside() const;
  [[nodiscard]] std::optional<Profile> profileOf(SegmentBuilder& builder, const VisitPose& from, const VisitPose& to, bool isDeparture) const;
  [[nodiscard]] VisitPose departureStart(const ClimbOut& climb) const { return {kHomeFrom, end_, climb.leastAltitude()}; }
  [[nodiscard]] VisitPose arrivalEnd() const;
  mission::HomePath makeDeparture(SegmentBuilder& builder, const ClimbOut& climb, const Join& join);
  mission::HomePath makeArrival(SegmentBuilder& builder, const Join& join);
  [[nodiscard]] double elevation() const { return plan_.sites[static_cast<std::size_t>(takeoff_)].site.elevation.metres(); }
  tl::unexpected<Error> noWay(bool isDeparture) const;

  const landing::World& world_;
  const landing::Roadmap& roadmap_;
  const SegmentSettings& settings_;
  mission::Plan& plan_;
  const Job& job_;
  HomeJoins joins_;
  int takeoff_ = -1;
  int landing_ = -1;
  geo::Pose end_;  ///< of the departure's runway
};

tl::unexpected<Error> cancelled() {
  return fail(Errc::Cancelled, "stopped while planning the ways from and to the home runway");
}

VisitPose HomePlanner::arrivalEnd() const {
  const mission::SiteInFrame& site = plan_.sites[static_cast<std::size_t>(landing_)];
  return {kHomeTo, site.pose, site.site.elevation.metres() + world_.arrivalMargin};
}

/// Lowest altitudes along the segment that meet the tour at its altitude there; nothing if that cannot be.
std::optional<Profile> HomePlanner::profileOf(SegmentBuilder& builder, const VisitPose& from, const VisitPose& to, bool isDeparture) const {
  const std::optional<SegmentBuilder::Floor> floor = builder.safeFloorOf(from, to);
  if (!floor) {
    return std::nullopt;
  }
  Profile profile{{floor->distance.begin(), floor->distance.end()}, {floor->lowest.begin(), floor->lowest.end()}};
  const double tourAltitude = isDeparture ? to.altitude : from.altitude;
  double& joined = isDeparture ? profile.altitude.back() : profile.altitude.front();
  std::vector<std::size_t> scratch;
  for (bool again = true; again;) {
    again = false;
    raiseForPitch(profile.distance, profile.altitude, settings_.pitch);
    if (joined > tourAltitude + kSameAltitude) {
      return std::nullopt;
    }
    joined = tourAltitude;
    concaveMajorant(profile.distance, profile.altitude, scratch);
    for (const auto& [point, gate] : floor->gates) {
      double& a = profile.altitude[point];
      double& b = profile.altitude[point + 1];
      if (gate.isPassed(std::min(a, b), std::max(a, b))) {
        continue;
      }
      if (gate.ceiling > settings_.ceiling) {
        return std::nullopt;
      }
      a = std::max(a, gate.ceiling);
      b = std::max(b, gate.ceiling);
      again = true;
    }
  }
  const bool isUnderCeiling = *std::max_element(profile.altitude.begin(), profile.altitude.end()) <= settings_.ceiling;
  return isUnderCeiling ? std::optional(std::move(profile)) : std::nullopt;
}

tl::unexpected<Error> HomePlanner::noWay(bool isDeparture) const {
  const std::string& id = plan_.sites[static_cast<std::size_t>(isDeparture ? takeoff_ : landing_)].site.id;
  return fail(Errc::NoSolution,
              fmt::format("home {}: no way {} it keeps a glide to a runway within the limits of climb, descent and ceiling{}; choose another "
                          "runway, raise the ceiling, or plan without a home",
                          id, isDeparture ? "from the circles over" : "from the tour to",
                          settings_.forbidden != nullptr ? " and out of the airspaces that the mission forbids to the tour" : ""));
}

std::vector<mission::DecisionPoint> toDecisionPoints(std::vector<SegmentPoint> points, const std::vector<double>& altitude) {
  std::vector<mission::DecisionPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    SegmentPoint& point = points[i];
    result.push_back({point.pose, altitude[i], point.safeAltitude, point.onward, {point.site, std::move(point.witness)}, -1});
  }
  return result;
}

mission::HomePath HomePlanner::makeDeparture(SegmentBuilder& builder, const ClimbOut& climb, const Join& join) {
  const VisitPose start = departureStart(climb);
  const std::optional<Profile> profile = profileOf(builder, start, join.visit, true);
  mission::HomePath path;
  path.site = takeoff_;
  path.join = static_cast<int>(join.point);
  climb.append(profile->altitude.front(), path);
  path.guaranteed = static_cast<int>(path.points.size());
  for (mission::DecisionPoint& point : toDecisionPoints(builder.safePoints(start, join.visit), profile->altitude)) {
    path.points.push_back(std::move(point));
  }
  if (!job_.stopRequested()) {
    climb.findGuarantee(roadmap_, path);
  }
  return path;
}

mission::HomePath HomePlanner::makeArrival(SegmentBuilder& builder, const Join& join) {
  const std::optional<Profile> profile = profileOf(builder, join.visit, arrivalEnd(), false);
  mission::HomePath path;
  path.site = landing_;
  path.join = static_cast<int>(join.point);
  path.points = toDecisionPoints(builder.safePoints(join.visit, arrivalEnd()), profile->altitude);
  return path;
}

Result<bool> HomePlanner::attempt(SegmentBuilder& builder, const ClimbOut& climb) {
  const std::vector<Join>& joins = joins_.all();
  std::vector<double> departures(joins.size(), kInfinite);
  std::vector<double> arrivals(joins.size(), kInfinite);
  for (std::size_t i = 0; i < joins.size(); ++i) {
    if (job_.stopRequested()) {
      return cancelled();
    }
    if (const auto way = profileOf(builder, departureStart(climb), joins[i].visit, true);
        way && climb.circlesUpTo(way->altitude.front()) <= kMostCircles) {
      departures[i] = way->distance.back() + climb.metresUpTo(way->altitude.front());
    }
    if (const auto way = profileOf(builder, joins[i].visit, arrivalEnd(), false)) {
      const double surplus = way->altitude.back() - arrivalEnd().altitude;
      arrivals[i] = way->distance.back() + surplus / settings_.pitch.descent;
    }
  }
  const auto pair = joins_.bestPair(departures, arrivals);
  if (!pair) {
    return noWay(std::all_of(departures.begin(), departures.end(), [](double length) { return length == kInfinite; }));
  }
  mission::HomePath departure = makeDeparture(builder, climb, joins[pair->first]);
  mission::HomePath arrival = makeArrival(builder, joins[pair->second]);
  if (job_.stopRequested()) {
    return cancelled();
  }
  const bool isClear = climb.isClear(departure) && staysOutside(world_, settings_.forbidden, departure);
  if (isClear) {
    plan_.departure = std::move(departure);
    plan_.arrival = std::move(arrival);
  }
  return isClear;
}

std::optional<Error> HomePlanner::runwayInside() const {
  const mission::HomeBase& home = *plan_.mission.home;
  const VisitPose end = arrivalEnd();
  std::optional<Error> error = insideAirspace(world_, settings_.forbidden, home.takeoff, end_.point(), elevation());
  return error ? error : insideAirspace(world_, settings_.forbidden, home.landing, end.pose.point(), end.altitude);
}

/// Around what no Dubins path can pass, between the runways and all joins.
Result<Detours> HomePlanner::findDetours() const {
  std::vector<geo::Point> places{end_.point(), arrivalEnd().pose.point()};
  for (const Join& join : joins_.all()) {
    places.push_back(join.visit.pose.point());
  }
  Result<Detours> detours = Detours::find(world_, places, settings_.ceiling, job_);
  if (detours && settings_.forbidden != nullptr) {
    if (const Result<void> found = detours->findAround(*settings_.forbidden, {}, world_, places, settings_.ceiling, job_); !found) {
      return forward(found);
    }
  }
  return detours;
}

Result<void> HomePlanner::run() {
  const Result<int> takeoff = findHomeSite(plan_.sites, plan_.mission.home->takeoff);
  const Result<int> landing = findHomeSite(plan_.sites, plan_.mission.home->landing);
  if (!takeoff || !landing) {
    return forward(!takeoff ? takeoff : landing);
  }
  takeoff_ = *takeoff;
  landing_ = *landing;
  end_ = departureEnd(plan_.sites[static_cast<std::size_t>(takeoff_)]);
  if (const std::optional<Error> error = runwayInside()) {
    return tl::unexpected(*error);
  }
  const Result<Detours> detours = findDetours();
  if (!detours) {
    return forward(detours);
  }
  SegmentBuilder builder(world_, roadmap_, *detours, settings_, job_.stopToken());
  for (const Circle& circle : circlesAt(world_, end_)) {
    const Result<bool> done = attempt(builder, ClimbOut(world_, settings_, end_, elevation(), circle));
    if (!done) {
      return forward(done);
    }
    if (*done) {
      return {};
    }
  }
  return noWay(true);
}

}  // namespace

Result<void> addHomePaths(const landing::World& world, const landing::Roadmap& roadmap, const SegmentSettings& settings, mission::Plan& plan,
                          const Job& job) {
  return HomePlanner(world, roadmap, settings, plan, job).run();
}

}  // namespace vp::tour
