#include "core/tour/home_path.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/required_height.h"
#include "core/tour/home_airspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kSameAltitude = 1e-6;  // m, rounding of the pitch passes
constexpr std::size_t kMostJoins = 48;  // evenly spaced points of the tour that are tried, beside the visits
constexpr double kMostCircles = 40.0;   // of a climb-out; a runway that needs more lies in a hole

/// Points of the tour where ways from and to home may meet it, with their number in the detours.
struct Join {
  std::size_t point = 0;
  VisitPose visit;
};

/// A way between home and one join: how it runs, as far as the choice needs it.
struct Way {
  double length = kInfinite;  ///< m, circles and surplus height included
};

/// Distances and altitudes of a segment whose one end lies on the tour.
struct Profile {
  std::vector<double> distance;
  std::vector<double> altitude;
};

/// Climbing circles over the end of the runway, without heights.
struct Circle {
  flight::Turn turn = flight::Turn::Left;
  double radius = 0.0;
  double length = 0.0;
  double ground = 0.0;  ///< m MSL, highest under it
};

class HomePlanner {
public:
  HomePlanner(const landing::World& world, const landing::Roadmap& roadmap, const SegmentSettings& settings, mission::Plan& plan, const Job& job)
      : world_(world), roadmap_(roadmap), settings_(settings), plan_(plan), job_(job) {}

  Result<void> run();

private:
  /// With the circles of circle_. @return false if the climb-out comes too near to the ground
  Result<bool> attempt(SegmentBuilder& builder);
  [[nodiscard]] bool climbsClear(const mission::HomePath& path) const;
  void chooseJoins();
  [[nodiscard]] std::optional<Profile> profileOf(SegmentBuilder& builder, const VisitPose& from, const VisitPose& to, bool isDeparture) const;
  [[nodiscard]] double circlesUpTo(double altitude) const;
  [[nodiscard]] VisitPose departureStart() const;
  [[nodiscard]] VisitPose arrivalEnd() const;
  Result<std::pair<std::size_t, std::size_t>> choosePair(const std::vector<Way>& departures, const std::vector<Way>& arrivals) const;
  [[nodiscard]] double flown(std::size_t joined, std::size_t left) const;
  mission::HomePath makeDeparture(SegmentBuilder& builder, const Join& join);
  mission::HomePath makeArrival(SegmentBuilder& builder, const Join& join);
  void appendClimb(double top, mission::HomePath& path);
  void findGuarantee(mission::HomePath& path, double runwayAltitude);
  tl::unexpected<Error> noWay(bool isDeparture) const;

  const landing::World& world_;
  const landing::Roadmap& roadmap_;
  const SegmentSettings& settings_;
  mission::Plan& plan_;
  const Job& job_;
  int takeoff_ = -1;
  int landing_ = -1;
  geo::Pose end_;  ///< of the departure's runway
  Circle circle_;
  std::vector<Join> joins_;
  std::vector<double> along_;  ///< m from the first point of the tour to each
  double loop_ = 0.0;
};

tl::unexpected<Error> cancelled() {
  return fail(Errc::Cancelled, "stopped while planning the ways from and to the home runway");
}

constexpr int kFrom = 0;  // places in the detours
constexpr int kTo = 1;
constexpr int kFirstJoin = 2;

void HomePlanner::chooseJoins() {
  const std::size_t count = plan_.tour.size();
  const std::size_t stride = std::max<std::size_t>(1, count / kMostJoins);
  for (std::size_t i = 0; i < count; ++i) {
    along_.push_back(loop_);
    loop_ += plan_.tour[i].onward.length;
    if (i % stride == 0 || plan_.tour[i].target >= 0) {
      const mission::DecisionPoint& point = plan_.tour[i];
      joins_.push_back({i, {kFirstJoin + static_cast<int>(joins_.size()), point.pose, point.altitude}});
    }
  }
}

/// Circles to both sides of the runway's end, the one over lower ground first.
std::array<Circle, 2> circlesAt(const landing::World& world, const geo::Pose& pose) {
  std::array<Circle, 2> circles;
  const double radius = world.glide.tourRadius();
  const double length = 2.0 * Angle::kPi * radius;
  for (std::size_t side = 0; side < circles.size(); ++side) {
    const flight::Turn turn = side == 0 ? flight::Turn::Left : flight::Turn::Right;
    circles[side] = {turn, radius, length, landing::maxTerrainAlong(world.terrain, pose, {turn, radius, length})};
  }
  if (circles[1].ground < circles[0].ground) {
    std::swap(circles[0], circles[1]);
  }
  return circles;
}

VisitPose HomePlanner::departureStart() const {
  const double elevation = plan_.sites[static_cast<std::size_t>(takeoff_)].site.elevation.metres();
  return {kFrom, end_, std::max(elevation, circle_.ground + world_.clearance)};
}

VisitPose HomePlanner::arrivalEnd() const {
  const mission::SiteInFrame& site = plan_.sites[static_cast<std::size_t>(landing_)];
  return {kTo, site.pose, site.site.elevation.metres() + world_.arrivalMargin};
}

double HomePlanner::circlesUpTo(double altitude) const {
  const double elevation = plan_.sites[static_cast<std::size_t>(takeoff_)].site.elevation.metres();
  return std::ceil((altitude - elevation) / (settings_.pitch.climb * circle_.length));
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

/// Metres of the tour that are flown when it is joined at one point and left at another, all targets visited.
double HomePlanner::flown(std::size_t joined, std::size_t left) const {
  const auto distance = [&](std::size_t a, std::size_t b) { return along_[b] - along_[a] + (b < a ? loop_ : 0.0); };
  const std::size_t count = plan_.tour.size();
  if (joined == left) {
    return loop_;
  }
  for (std::size_t i = (left + 1) % count; i != joined; i = (i + 1) % count) {
    if (plan_.tour[i].target >= 0) {
      return loop_ + distance(joined, left);
    }
  }
  return loop_ - distance(left, joined);
}

tl::unexpected<Error> HomePlanner::noWay(bool isDeparture) const {
  const std::string& id = plan_.sites[static_cast<std::size_t>(isDeparture ? takeoff_ : landing_)].site.id;
  return fail(Errc::NoSolution,
              fmt::format("home {}: no way {} it keeps a glide to a runway within the limits of climb, descent and ceiling{}; choose another "
                          "runway, raise the ceiling, or plan without a home",
                          id, isDeparture ? "from the circles over" : "from the tour to",
                          settings_.forbidden != nullptr ? " and out of the airspaces that the mission forbids to the tour" : ""));
}

Result<std::pair<std::size_t, std::size_t>> HomePlanner::choosePair(const std::vector<Way>& departures, const std::vector<Way>& arrivals) const {
  double best = kInfinite;
  std::pair<std::size_t, std::size_t> pair;
  for (std::size_t d = 0; d < joins_.size(); ++d) {
    for (std::size_t a = 0; a < joins_.size() && departures[d].length < kInfinite; ++a) {
      if (arrivals[a].length < kInfinite) {
        const double all = departures[d].length + arrivals[a].length + flown(joins_[d].point, joins_[a].point);
        if (all < best) {
          best = all;
          pair = {d, a};
        }
      }
    }
  }
  if (best == kInfinite) {
    const bool canDepart = std::any_of(departures.begin(), departures.end(), [](const Way& way) { return way.length < kInfinite; });
    return noWay(!canDepart);
  }
  return pair;
}

std::vector<mission::DecisionPoint> toDecisionPoints(std::vector<SegmentPoint> points, const std::vector<double>& altitude) {
  std::vector<mission::DecisionPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    SegmentPoint& point = points[i];
    result.push_back({point.pose, altitude[i], point.safeAltitude, point.onward, {point.site, std::move(point.witness)}, -1});
  }
  return result;
}

/// Circles from the runway up to `top`, as steep as the aircraft climbs until it is there.
void HomePlanner::appendClimb(double top, mission::HomePath& path) {
  const double elevation = plan_.sites[static_cast<std::size_t>(takeoff_)].site.elevation.metres();
  const int circles = static_cast<int>(circlesUpTo(top));
  const int parts = std::max(3, static_cast<int>(std::ceil(circle_.length / settings_.step)));
  const flight::Piece part{circle_.turn, circle_.radius, circle_.length / parts};
  for (int i = 0; i < circles * parts; ++i) {
    const geo::Pose pose = flight::poseAfter(end_, {part.turn, part.radius, circle_.length}, part.length * (i % parts));
    mission::DecisionPoint point;
    point.pose = pose;
    point.altitude = std::min(top, elevation + settings_.pitch.climb * part.length * i);
    point.onward = part;
    path.points.push_back(std::move(point));
  }
}

/// Asks for the glides of the circles, from the last one back, until one is higher than the aircraft.
void HomePlanner::findGuarantee(mission::HomePath& path, double runwayAltitude) {
  landing::QueryScratch scratch;
  auto first = static_cast<std::size_t>(path.guaranteed);
  const double turnLoss = world_.glide.lossAt(circle_.radius);
  while (first > 0) {
    const mission::DecisionPoint& next = path.points[first];
    mission::DecisionPoint& point = path.points[first - 1];
    const auto answer = roadmap_.query(world_, point.pose, scratch);
    const double ground = landing::maxTerrainAlong(world_.terrain, point.pose, point.onward) + world_.clearance;
    const double needed = std::max(next.safeAltitude, ground) + turnLoss * point.onward.length;
    const bool isSafe = answer && point.altitude > runwayAltitude && point.altitude >= std::max({answer->altitude, needed, ground});
    if (!isSafe) {
      break;
    }
    point.safeAltitude = answer->altitude;
    point.witness = {answer->site, roadmap_.witnessPieces(*answer)};
    --first;
  }
  path.guaranteed = static_cast<int>(first);
}

mission::HomePath HomePlanner::makeDeparture(SegmentBuilder& builder, const Join& join) {
  const std::optional<Profile> profile = profileOf(builder, departureStart(), join.visit, true);
  mission::HomePath path;
  path.site = takeoff_;
  path.join = static_cast<int>(join.point);
  appendClimb(profile->altitude.front(), path);
  path.guaranteed = static_cast<int>(path.points.size());
  for (mission::DecisionPoint& point : toDecisionPoints(builder.safePoints(departureStart(), join.visit), profile->altitude)) {
    path.points.push_back(std::move(point));
  }
  if (!job_.stopRequested()) {
    findGuarantee(path, plan_.sites[static_cast<std::size_t>(takeoff_)].site.elevation.metres());
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

/// The rule of kDepartureClearancePerMetre for the points before the guarantee.
bool HomePlanner::climbsClear(const mission::HomePath& path) const {
  double distance = 0.0;
  for (int i = 0; i < path.guaranteed; ++i) {
    const mission::DecisionPoint& point = path.points[static_cast<std::size_t>(i)];
    const double next = distance + point.onward.length;
    const double ground = landing::maxTerrainAlong(world_.terrain, point.pose, point.onward);
    if (next > kAirfieldEnvironment && !(point.altitude >= ground + std::min(world_.clearance, kDepartureClearancePerMetre * next))) {
      return false;
    }
    distance = next;
  }
  return true;
}

Result<bool> HomePlanner::attempt(SegmentBuilder& builder) {
  std::vector<Way> departures(joins_.size());
  std::vector<Way> arrivals(joins_.size());
  for (std::size_t i = 0; i < joins_.size(); ++i) {
    if (job_.stopRequested()) {
      return cancelled();
    }
    if (const auto way = profileOf(builder, departureStart(), joins_[i].visit, true); way && circlesUpTo(way->altitude.front()) <= kMostCircles) {
      departures[i].length = way->distance.back() + circlesUpTo(way->altitude.front()) * circle_.length;
    }
    if (const auto way = profileOf(builder, joins_[i].visit, arrivalEnd(), false)) {
      const double surplus = way->altitude.back() - arrivalEnd().altitude;
      arrivals[i].length = way->distance.back() + surplus / settings_.pitch.descent;
    }
  }
  const auto pair = choosePair(departures, arrivals);
  if (!pair) {
    return forward(pair);
  }
  mission::HomePath departure = makeDeparture(builder, joins_[pair->first]);
  mission::HomePath arrival = makeArrival(builder, joins_[pair->second]);
  if (job_.stopRequested()) {
    return cancelled();
  }
  const bool isClear = climbsClear(departure) && staysOutside(world_, settings_.forbidden, departure);
  if (isClear) {
    plan_.departure = std::move(departure);
    plan_.arrival = std::move(arrival);
  }
  return isClear;
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
  const double elevation = plan_.sites[static_cast<std::size_t>(takeoff_)].site.elevation.metres();
  for (const auto& error :
       {insideAirspace(world_, settings_.forbidden, plan_.mission.home->takeoff, end_.point(), elevation),
        insideAirspace(world_, settings_.forbidden, plan_.mission.home->landing, arrivalEnd().pose.point(), arrivalEnd().altitude)}) {
    if (error) {
      return tl::unexpected(*error);
    }
  }
  chooseJoins();
  std::vector<geo::Point> places{end_.point(), arrivalEnd().pose.point()};
  for (const Join& join : joins_) {
    places.push_back(join.visit.pose.point());
  }
  Result<Detours> detours = Detours::find(world_, places, settings_.ceiling, job_);
  if (!detours) {
    return forward(detours);
  }
  if (settings_.forbidden != nullptr) {
    if (const Result<void> found = detours->findAround(*settings_.forbidden, {}, world_, places, settings_.ceiling, job_); !found) {
      return forward(found);
    }
  }
  SegmentBuilder builder(world_, roadmap_, *detours, settings_, job_.stopToken());
  for (const Circle& circle : circlesAt(world_, end_)) {
    circle_ = circle;
    const Result<bool> done = attempt(builder);
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

geo::Pose departureEnd(const mission::SiteInFrame& site) {
  return flight::poseAfter(site.pose, {flight::Turn::Straight, 0.0, site.site.length ? site.site.length->si() : 0.0},
                           site.site.length ? site.site.length->si() : 0.0);
}

Result<int> findHomeSite(const std::vector<mission::SiteInFrame>& sites, const std::string& id) {
  constexpr std::size_t kMostNames = 12;
  std::string names;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites[i].site.id == id) {
      return static_cast<int>(i);
    }
    if (i < kMostNames) {
      names += (names.empty() ? "" : ", ") + sites[i].site.id;
    }
  }
  return fail(Errc::OutOfRange, fmt::format("home {}: there is no usable landing site of that name; there are {}{}", id, names,
                                            sites.size() > kMostNames ? ", ..." : ""));
}

Result<void> addHomePaths(const landing::World& world, const landing::Roadmap& roadmap, const SegmentSettings& settings, mission::Plan& plan,
                          const Job& job) {
  return HomePlanner(world, roadmap, settings, plan, job).run();
}

}  // namespace vp::tour
