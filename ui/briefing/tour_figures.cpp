#include "ui/briefing/tour_figures.h"

#include "core/aircraft/glide_model.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/geo/magnetic_field.h"
#include "core/mission/glide_conditions.h"
#include "core/route/flight_totals.h"
#include "core/safety/cell_walk.h"
#include "core/safety/failures.h"
#include "core/safety/ground_path.h"
#include "core/safety/witness_check.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace vp::briefing {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnreliable = 6000.0;   // nT, caution zone of the World Magnetic Model's report
constexpr double kSamplesPerCell = 4.0;  // along the tour, for heights above ground
constexpr double kSameHeight = 1.0;      // m: heights in the same metre rank as equal
constexpr double kRounding = 1e-3;       // m, as the checker's
constexpr double kSameCourse = 1e-6;     // rad: straight pieces that go on in one line
constexpr double kJustBehind = 0.01;     // m: where the glide of a point no longer counts
constexpr double kNearest = 500.0;       // m along the tour between two of the worst places, at least
constexpr double kNearestShare = 0.03;   // of the tour, the same

class Worker {
public:
  Worker(const mission::Plan& plan, const terrain::ElevationGrid& terrain, double year, const Job& job)
      : plan_(plan),
        terrain_(terrain),
        frame_(plan.frameOrigin),
        model_(plan.mission.aircraft, mission::glideConditionsOf(plan.mission, plan.sites)),
        rates_(safety::conditionsOf(plan), plan.mission.aircraft),
        walk_(terrain),
        year_(year),
        job_(job),
        points_(plan.tour) {}

  Result<TourFigures> run();

private:
  struct Interval {
    GlideFigures begin;  // failure just behind the point: on to the next one, then its glide
    GlideFigures end;    // failure at the next point
    double leastMargin = 0.0;
    double leastMarginAt = 0.0;  // m from the point
    double groundClearance = 0.0;
  };
  [[nodiscard]] const mission::DecisionPoint& point(std::size_t i) const { return points_[i % points_.size()]; }
  [[nodiscard]] GlideFigures fly(const mission::DecisionPoint& from, const std::vector<flight::Piece>& first, const mission::Witness& witness);
  Interval examine(std::size_t i);
  void searchGroundBetween(const mission::DecisionPoint& a, const mission::DecisionPoint& b, Interval& interval);
  void collectVisits();
  void addLeg(int from, int to, std::size_t first, std::size_t intervals);
  void addInterval(Leg& leg, std::size_t i, const Interval& interval, std::vector<Divert>& diverts);
  Leg makeLeg(std::size_t first, std::size_t intervals) const;
  [[nodiscard]] WayFigures wayFigures(const mission::HomePath& way);
  void addWays();
  [[nodiscard]] Track trackAt(const geo::Pose& pose, double altitude);
  void findTrack(Leg& leg);

  const mission::Plan& plan_;
  const terrain::ElevationGrid& terrain_;
  geo::LocalFrame frame_;
  aircraft::GlideModel model_;
  safety::GlideRates rates_;  ///< what the checker counts with
  safety::CellWalk walk_;
  double year_;
  const Job& job_;
  std::span<const mission::DecisionPoint> points_;  ///< of the tour, or of a way from or to home
  TourFigures figures_;
  std::vector<double> distances_;  ///< m along them
};

Track Worker::trackAt(const geo::Pose& pose, double altitude) {
  Track track;
  track.trueCourse = frame_.trueCourseOf(pose.heading, pose.point());
  const geo::MagneticField field = geo::magneticField(frame_.toLatLon(pose.point()), geo::HeightMsl::fromMetres(altitude), year_);
  figures_.compassIsUnreliable = figures_.compassIsUnreliable || field.horizontal() < kUnreliable;
  if (field.movesACompass()) {
    track.variation = field.variation();
  }
  return track;
}

/// As the checker flies it: after the reaction loss, and its last part as the approach has it.
GlideFigures Worker::fly(const mission::DecisionPoint& from, const std::vector<flight::Piece>& first, const mission::Witness& witness) {
  const mission::Mission& mission = plan_.mission;
  const bool isSound = std::all_of(witness.pieces.begin(), witness.pieces.end(), safety::isIntegrable);
  const safety::SplitGlide whole{witness.pieces, {}, {}};  // of a plan that breaks a rule of approaches
  safety::SplitGlide pieces = (isSound ? safety::splitAtGate(witness.pieces, mission.approach) : std::nullopt).value_or(whole);
  pieces.before.insert(pieces.before.begin(), first.begin(), first.end());
  const mission::LandingSite& site = plan_.sites[static_cast<std::size_t>(witness.site)].site;
  const double reaction = mission.safety.reactionLoss.si();
  const safety::GlideQuery query = safety::queryOf(from.pose, from.altitude - reaction, site, mission);
  const safety::GlideExamination flown = safety::examineGlide(query, pieces, rates_, walk_, job_);
  GlideFigures glide;
  glide.site = witness.site;
  glide.length = flown.length;
  glide.required = flown.lowestStart() + reaction;
  glide.margin = from.altitude - glide.required;
  glide.clearance = flown.aboveGround;
  glide.arrival = flown.arrival - site.elevation.metres();
  geo::Pose pose = from.pose;
  for (const std::vector<flight::Piece>* part : {&first, &witness.pieces}) {
    for (const flight::Piece& piece : *part) {
      glide.seconds += flight::glideSeconds(model_, pose, piece);
      pose = flight::endOf(pose, piece);
    }
  }
  return glide;
}

/// Between two points the need falls from the first to the second by what the glide loses. Where the tour descends less steeply
/// than that, the least margin is just behind the first point; where it descends more steeply it is at the second, or over the
/// ground in between. Where a metre costs less at other altitudes it may also be in between.
Worker::Interval Worker::examine(std::size_t i) {
  const mission::DecisionPoint& a = point(i);
  const mission::DecisionPoint& b = point(i + 1);
  Interval interval;
  interval.begin = fly(a, {a.onward}, b.witness);
  interval.end = fly(b, {}, b.witness);
  interval.leastMargin = interval.begin.margin;
  interval.leastMarginAt = std::min(kJustBehind, 0.5 * a.onward.length);
  if (rates_.isLayered()) {
    safety::Descent descent(rates_, a.pose.heading, a.onward);
    safety::Failures failures(a.altitude, b.altitude, a.onward.length, descent, plan_.mission.safety.reactionLoss.si());
    interval.leastMargin = std::min(interval.leastMargin, failures.lowestAt(a.onward.length) - interval.end.required);
  }
  if (interval.end.margin < interval.leastMargin) {
    interval.leastMargin = interval.end.margin;
    interval.leastMarginAt = a.onward.length;
  }
  searchGroundBetween(a, b, interval);
  return interval;
}

void Worker::searchGroundBetween(const mission::DecisionPoint& a, const mission::DecisionPoint& b, Interval& interval) {
  const double slope = a.onward.length > 0.0 ? (b.altitude - a.altitude) / a.onward.length : 0.0;
  const bool isSteep = b.altitude < safety::Descent(rates_, a.pose.heading, a.onward).down(0.0, a.altitude, a.onward.length);
  const double step = terrain_.cellSize() / kSamplesPerCell;
  const int parts = std::max(1, static_cast<int>(std::ceil(a.onward.length / step)));
  interval.groundClearance = kInfinity;
  for (int k = 0; k <= parts; ++k) {
    const double flown = a.onward.length * k / parts;
    const double altitude = a.altitude + slope * flown;
    const double clearance = altitude - terrain_.upperAt(flight::poseAfter(a.pose, a.onward, flown).point());
    interval.groundClearance = std::min(interval.groundClearance, clearance);
    const double margin = clearance - plan_.mission.safety.clearance.si() - plan_.mission.safety.reactionLoss.si();
    if (isSteep && margin < interval.leastMargin) {
      interval.leastMargin = margin;
      interval.leastMarginAt = flown;
    }
  }
}

void Worker::collectVisits() {
  figures_.seconds = route::tourTotals(plan_).seconds;
  for (std::size_t i = 0; i < plan_.tour.size(); ++i) {
    distances_.push_back(figures_.length);
    figures_.length += plan_.tour[i].onward.length;
    if (plan_.tour[i].target < 0) {
      continue;
    }
    const mission::DecisionPoint& here = plan_.tour[i];
    Visit visit{here.target, i, distances_[i], here.altitude, here.altitude - terrain_.upperAt(here.pose.point()), -1};
    for (std::size_t s = 0; s < plan_.spirals.size(); ++s) {
      const mission::SpiralVisit& spiral = plan_.spirals[s];
      if (spiral.target == here.target) {
        visit.spiral = static_cast<int>(s);
      }
    }
    figures_.visits.push_back(visit);
  }
}

/// The longest run of straight pieces in line.
void Worker::findTrack(Leg& leg) {
  double longest = 0.0;
  double run = 0.0;
  std::size_t runStart = leg.firstPoint;
  std::size_t best = leg.firstPoint;
  for (std::size_t k = 0; k < leg.intervals; ++k) {
    const mission::DecisionPoint& here = point(leg.firstPoint + k);
    if (here.onward.turn != flight::Turn::Straight) {
      run = 0.0;
      continue;
    }
    if (run <= 0.0 || std::abs(wrapPi(here.pose.heading - point(runStart).pose.heading)) > kSameCourse) {
      run = 0.0;
      runStart = leg.firstPoint + k;
    }
    run += here.onward.length;
    if (run > longest) {
      longest = run;
      best = runStart;
    }
  }
  leg.isStraightPart = longest > 0.0;
  leg.track = trackAt(point(best).pose, point(best).altitude);
}

void Worker::addInterval(Leg& leg, std::size_t i, const Interval& interval, std::vector<Divert>& diverts) {
  const mission::DecisionPoint& a = point(i);
  const mission::DecisionPoint& b = point(i + 1);
  leg.seconds += route::secondsBetween(plan_, a, b);
  leg.highestAltitude = std::max({leg.highestAltitude, a.altitude, b.altitude});
  leg.leastClearance = std::min(leg.leastClearance, interval.groundClearance);
  leg.safeAltitude = std::max({leg.safeAltitude, interval.begin.required, interval.end.required});
  if (interval.leastMargin < leg.leastMargin) {
    leg.leastMargin = interval.leastMargin;
    leg.leastMarginAt = leg.length + interval.leastMarginAt;
  }
  const int index = static_cast<int>(figures_.legs.size());
  if (diverts.empty() || diverts.back().leg != index || diverts.back().site != interval.begin.site) {
    Divert divert;
    divert.leg = index;
    divert.from = leg.length;
    divert.site = interval.begin.site;
    divert.leastGlide = divert.leastSeconds = divert.margin = divert.leastClearance = divert.leastArrival = kInfinity;
    diverts.push_back(divert);
  }
  Divert& divert = diverts.back();
  divert.to = leg.length + a.onward.length;
  for (const GlideFigures* glide : {&interval.begin, &interval.end}) {
    divert.leastGlide = std::min(divert.leastGlide, glide->length);
    divert.greatestGlide = std::max(divert.greatestGlide, glide->length);
    divert.leastSeconds = std::min(divert.leastSeconds, glide->seconds);
    divert.greatestSeconds = std::max(divert.greatestSeconds, glide->seconds);
    divert.leastClearance = std::min(divert.leastClearance, glide->clearance);
    divert.leastArrival = std::min(divert.leastArrival, glide->arrival);
  }
  divert.leastClearance = std::min(divert.leastClearance, interval.groundClearance);
  if (interval.leastMargin < divert.margin) {
    divert.margin = interval.leastMargin;
    divert.marginAt = distances_[i % points_.size()] + interval.leastMarginAt;
    divert.worst = interval.end.margin < interval.begin.margin ? interval.end : interval.begin;
  }
  leg.length += a.onward.length;
}

Leg Worker::makeLeg(std::size_t first, std::size_t intervals) const {
  Leg leg;
  leg.firstPoint = first;
  leg.intervals = intervals;
  leg.start = distances_[first];
  leg.startAltitude = point(first).altitude;
  leg.endAltitude = point(first + intervals).altitude;
  leg.highestAltitude = leg.startAltitude;
  leg.safeAltitude = -kInfinity;
  leg.leastClearance = leg.leastMargin = kInfinity;
  return leg;
}

void Worker::addLeg(int from, int to, std::size_t first, std::size_t intervals) {
  Leg leg = makeLeg(first, intervals);
  leg.from = from;
  leg.to = to;
  for (std::size_t k = 0; k < intervals && !job_.stopRequested(); ++k) {
    addInterval(leg, first + k, examine(first + k), figures_.diverts);
  }
  findTrack(leg);
  figures_.legs.push_back(leg);
}

WayFigures Worker::wayFigures(const mission::HomePath& way) {
  WayFigures figures;
  const auto join = static_cast<std::size_t>(way.join);
  const std::size_t tour = plan_.tour.size();
  for (std::size_t i = 0; i < figures_.legs.size(); ++i) {
    const Leg& leg = figures_.legs[i];
    if ((join + tour - leg.firstPoint) % tour < leg.intervals) {
      figures.joinLeg = static_cast<int>(i);
    }
  }
  points_ = way.points;
  distances_.assign(1, 0.0);
  for (const mission::DecisionPoint& here : way.points) {
    distances_.push_back(distances_.back() + here.onward.length);
  }
  const auto begin = static_cast<std::size_t>(way.guaranteed);
  figures.unguarded = makeLeg(0, begin);
  for (std::size_t i = 0; i < begin; ++i) {
    figures.unguarded.length += point(i).onward.length;
    figures.unguarded.seconds += route::secondsBetween(plan_, point(i), point(i + 1));
    figures.unguarded.highestAltitude = std::max(figures.unguarded.highestAltitude, point(i + 1).altitude);
  }
  findTrack(figures.unguarded);
  figures.leg = makeLeg(begin, way.points.size() - 1 - begin);
  for (std::size_t i = begin; i + 1 < way.points.size() && !job_.stopRequested(); ++i) {
    addInterval(figures.leg, i, examine(i), figures.diverts);
  }
  findTrack(figures.leg);
  return figures;
}

void Worker::addWays() {
  if (plan_.departure && plan_.arrival) {
    figures_.departure = wayFigures(*plan_.departure);
    figures_.arrival = wayFigures(*plan_.arrival);
  }
}

Result<TourFigures> Worker::run() {
  collectVisits();
  const std::size_t points = plan_.tour.size();
  const std::size_t count = figures_.visits.size();
  if (count == 0) {
    addLeg(-1, -1, 0, points);
  }
  for (std::size_t k = 0; k < count && !job_.stopRequested(); ++k) {
    const std::size_t from = figures_.visits[k].point;
    const std::size_t to = figures_.visits[(k + 1) % count].point;
    job_.progress(static_cast<double>(k) / static_cast<double>(count), Words::tr("briefing: glides").toStdString());
    addLeg(static_cast<int>(k), static_cast<int>((k + 1) % count), from, to > from ? to - from : to + points - from);
  }
  addWays();
  for (const mission::SiteInFrame& site : plan_.sites) {
    figures_.siteTracks.push_back(trackAt(site.pose, site.site.elevation.metres()));
    figures_.siteTracks.back().trueCourse = site.site.landingCourse;
  }
  if (job_.stopRequested()) {
    return fail(Errc::Cancelled, Words::tr("stopped").toStdString());
  }
  figures_.fieldIsCovered = geo::isCoveredByMagneticModel(year_);
  return std::move(figures_);
}

}  // namespace

Result<TourFigures> tourFigures(const mission::Plan& plan, const terrain::ElevationGrid& terrain, std::chrono::year_month_day date, const Job& job) {
  return Worker(plan, terrain, geo::decimalYear(date), job).run();
}

std::vector<std::size_t> worstDiverts(const TourFigures& figures, std::size_t count) {
  std::vector<std::size_t> order(figures.diverts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto classOf = [](double height) { return std::floor(height / kSameHeight + kRounding); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    const Divert& a = figures.diverts[x];
    const Divert& b = figures.diverts[y];
    if (classOf(a.margin) != classOf(b.margin)) {
      return classOf(a.margin) < classOf(b.margin);
    }
    const double clearanceA = classOf(a.worst.clearance);
    const double clearanceB = classOf(b.worst.clearance);
    return clearanceA != clearanceB ? clearanceA < clearanceB : a.worst.length > b.worst.length;
  });
  std::vector<std::size_t> worst;
  for (const std::size_t candidate : order) {
    const double at = figures.diverts[candidate].marginAt;
    const bool isNew = std::none_of(worst.begin(), worst.end(), [&](std::size_t taken) {
      const double apart = std::abs(figures.diverts[taken].marginAt - at);
      return std::min(apart, figures.length - apart) < std::max(kNearest, kNearestShare * figures.length);
    });
    if (isNew && worst.size() < count) {
      worst.push_back(candidate);
    }
  }
  return worst;
}

}  // namespace vp::briefing
