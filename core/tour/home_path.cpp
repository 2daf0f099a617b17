#include "core/tour/home_path.h"

#include "core/flight/piece_loss.h"
#include "core/landing/glide_straightener.h"
#include "core/tour/climb_out.h"
#include "core/tour/home_airspace.h"
#include "core/tour/home_joins.h"
#include "core/tour/home_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>

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
  bool fit(Profile& profile, std::span<const SegmentGate> gates, double tourAltitude, bool isDeparture) const;
  [[nodiscard]] std::optional<std::vector<mission::DecisionPoint>> pointsOf(SegmentBuilder& builder, const VisitPose& from, const VisitPose& to,
                                                                            bool isDeparture, const flight::Piece& before) const;
  [[nodiscard]] VisitPose departureStart(const ClimbOut& climb) const { return {kHomeFrom, end_, climb.leastAltitude()}; }
  [[nodiscard]] VisitPose arrivalEnd() const;
  std::optional<mission::HomePath> makeDeparture(SegmentBuilder& builder, const ClimbOut& climb, const Join& join);
  std::optional<mission::HomePath> makeArrival(SegmentBuilder& builder, const Join& join);
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
  return fit(profile, floor->gates, isDeparture ? to.altitude : from.altitude, isDeparture) ? std::optional(std::move(profile)) : std::nullopt;
}

/// Raises altitudes to what pitch limits and gates ask for. @return false if they cannot meet the tour at its altitude, or are above the ceiling
bool HomePlanner::fit(Profile& profile, std::span<const SegmentGate> gates, double tourAltitude, bool isDeparture) const {
  double& joined = isDeparture ? profile.altitude.back() : profile.altitude.front();
  std::vector<std::size_t> scratch;
  for (bool again = true; again;) {
    again = false;
    raiseForPitch(profile.distance, profile.altitude, settings_.pitch);
    if (joined > tourAltitude + kSameAltitude) {
      return false;
    }
    joined = tourAltitude;
    concaveMajorant(profile.distance, profile.altitude, scratch);
    for (const auto& [point, gate] : gates) {
      double& a = profile.altitude[point];
      double& b = profile.altitude[point + 1];
      if (gate.isPassed(std::min(a, b), std::max(a, b))) {
        continue;
      }
      if (gate.ceiling > settings_.ceiling) {
        return false;
      }
      a = std::max(a, gate.ceiling);
      b = std::max(b, gate.ceiling);
      again = true;
    }
  }
  return *std::max_element(profile.altitude.begin(), profile.altitude.end()) <= settings_.ceiling;
}

tl::unexpected<Error> HomePlanner::noWay(bool isDeparture) const {
  const std::string& id = plan_.sites[static_cast<std::size_t>(isDeparture ? takeoff_ : landing_)].site.id;
  return fail(Errc::NoSolution,
              fmt::format("home {}: no way {} it keeps a glide to a runway within the limits of climb, descent and ceiling{}; choose another "
                          "runway, raise the ceiling, or plan without a home",
                          id, isDeparture ? "from the circles over" : "from the tour to",
                          settings_.forbidden != nullptr ? " and out of the airspaces that the mission forbids to the tour" : ""));
}

/// The points of a way with their altitudes and glides, these with few turns; higher where rolling asks for that. Nothing if that cannot be.
/// @param before  the piece that the way is come to on
std::optional<std::vector<mission::DecisionPoint>> HomePlanner::pointsOf(SegmentBuilder& builder, const VisitPose& from, const VisitPose& to,
                                                                         bool isDeparture, const flight::Piece& before) const {
  std::optional<Profile> profile = profileOf(builder, from, to, isDeparture);
  if (!profile) {
    return std::nullopt;
  }
  const landing::GlideStraightener straightener(world_);
  std::vector<SegmentPoint> points = builder.safePoints(from, to);
  std::vector<double> raised = profile->altitude;
  for (std::size_t i = 0; i < points.size(); ++i) {
    SegmentPoint& point = points[i];
    const flight::Piece& last = i > 0 ? points[i - 1].onward : before;
    double atHand = profile->altitude[i];
    if (i > 0) {
      atHand = std::min(atHand, profile->altitude[i - 1] - flight::mostLossOver(world_.glide, points[i - 1].pose, last));
    }
    auto [pieces, safeAltitude] = straightener.improved(point.pose, last, {std::move(point.witness), point.safeAltitude}, point.site, atHand);
    point.witness = std::move(pieces);
    point.safeAltitude = safeAltitude;
    raised[i] = std::max(raised[i], safeAltitude);
    if (i > 0) {
      raised[i - 1] = std::max(raised[i - 1], flight::mostHeightBefore(world_.glide, points[i - 1].pose, last, safeAltitude, world_.reactionLoss));
    }
  }
  if (raised != profile->altitude) {
    profile->altitude = std::move(raised);
    if (!fit(*profile, builder.gates(), isDeparture ? to.altitude : from.altitude, isDeparture)) {
      return std::nullopt;
    }
  }
  std::vector<mission::DecisionPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    SegmentPoint& point = points[i];
    result.push_back({point.pose, profile->altitude[i], point.safeAltitude, point.onward, {point.site, std::move(point.witness)}, -1});
  }
  return result;
}

std::optional<mission::HomePath> HomePlanner::makeDeparture(SegmentBuilder& builder, const ClimbOut& climb, const Join& join) {
  std::optional<std::vector<mission::DecisionPoint>> points =
      pointsOf(builder, departureStart(climb), join.visit, true, climb.circlePiece());
  if (!points) {
    return std::nullopt;
  }
  mission::HomePath path;
  path.site = takeoff_;
  path.join = static_cast<int>(join.point);
  if (!points->empty()) {
    climb.append(points->front().altitude, path);
  }
  path.guaranteed = static_cast<int>(path.points.size());
  std::move(points->begin(), points->end(), std::back_inserter(path.points));
  if (!job_.stopRequested()) {
    climb.findGuarantee(roadmap_, path);
  }
  return path;
}

std::optional<mission::HomePath> HomePlanner::makeArrival(SegmentBuilder& builder, const Join& join) {
  const std::size_t count = plan_.tour.size();
  std::optional<std::vector<mission::DecisionPoint>> points =
      pointsOf(builder, join.visit, arrivalEnd(), false, plan_.tour[(join.point + count - 1) % count].onward);
  if (!points) {
    return std::nullopt;
  }
  mission::HomePath path;
  path.site = landing_;
  path.join = static_cast<int>(join.point);
  path.points = std::move(*points);
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
  std::optional<mission::HomePath> departure;
  std::optional<mission::HomePath> arrival;
  while (!departure || !arrival) {
    const auto pair = joins_.bestPair(departures, arrivals);
    if (!pair) {
      return noWay(std::all_of(departures.begin(), departures.end(), [](double length) { return length == kInfinite; }));
    }
    departure = makeDeparture(builder, climb, joins[pair->first]);
    arrival = makeArrival(builder, joins[pair->second]);
    if (job_.stopRequested()) {
      return cancelled();
    }
    departures[pair->first] = departure ? departures[pair->first] : kInfinite;  // what rolling asks for may be above the tour there
    arrivals[pair->second] = arrival ? arrivals[pair->second] : kInfinite;
  }
  if (job_.stopRequested()) {
    return cancelled();
  }
  const bool isClear = climb.isClear(*departure) && staysOutside(world_, settings_.forbidden, *departure);
  if (isClear) {
    plan_.departure = std::move(*departure);
    plan_.arrival = std::move(*arrival);
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
