#include "core/tour/refine.h"

#include "core/tour/tour_refiner.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kLeastTurn = 0.01;  // rad, the smallest step of a heading

}  // namespace

TourRefiner::TourRefiner(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits, const SegmentSettings& settings,
                         const RefineOptions& options, const Job& job)
    : builder_(builder),
      job_(job),
      store_(world, builder, settings, options.lowTargets),
      loopCost_(settings.pitch, settings.beta, settings.ceiling),
      random_(options.seed),
      queriesAtStart_(builder.queries()) {
  for (const VisitPose& visit : visits) {
    tour_.push_back(store_.add(visit));
    targets_ = std::max(targets_, static_cast<std::size_t>(visit.target) + 1);
  }
  firstTarget_ = visits.front().target;
  for (const VisitPose& visit : options.insert) {
    targets_ = std::max(targets_, static_cast<std::size_t>(visit.target) + 1);
  }
  turn_.assign(targets_, 0.0);
  std::vector<VisitPose> all = visits;
  all.insert(all.end(), options.insert.begin(), options.insert.end());
  findNeighbours(all);
  mostQueries_ =
      static_cast<std::int64_t>(static_cast<double>(options.queriesPerTarget) * static_cast<double>(all.size()) * legFactor(settings.step));
}

Result<RefineResult> TourRefiner::run(const std::vector<VisitPose>& missing) {
  cost_ = costOf(tour_, std::numeric_limits<double>::infinity());
  for (const VisitPose& visit : missing) {
    insert(visit);
  }
  result_.costBefore = cost_;
  if (std::isfinite(cost_)) {
    improve();
    tryChangedOrders();
  }
  if (job_.stopRequested()) {
    return fail(Errc::Cancelled, "stopped while refining the tour");
  }
  result_.cost = cost_;
  std::rotate(tour_.begin(), std::find_if(tour_.begin(), tour_.end(), [this](int pose) { return store_.visit(pose).target == firstTarget_; }),
              tour_.end());
  for (const int pose : tour_) {
    result_.visits.push_back(store_.visit(pose));
  }
  return result_;
}

double TourRefiner::legFactor(double step) {
  constexpr double kUsualPoints = 20.0;
  constexpr double kMostFactor = 4.0;
  double length = 0.0;
  for (std::size_t i = 0; i < tour_.size(); ++i) {
    length += store_.leg(tour_[i], tour_[(i + 1) % tour_.size()]).shape.length;
  }
  return std::clamp(length / (step * kUsualPoints * static_cast<double>(tour_.size())), 1.0, kMostFactor);
}

bool TourRefiner::areNear(int a, int b) const {
  return isNeighbour_[static_cast<std::size_t>(store_.visit(a).target) * targets_ + static_cast<std::size_t>(store_.visit(b).target)] != 0;
}

double TourRefiner::costOf(const Tour& tour, double below) {
  const std::size_t count = tour.size();
  legs_.resize(count);
  shapes_.resize(count);
  loopVisits_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    legs_[i] = &store_.leg(tour[i], tour[(i + 1) % count]);
    shapes_[i] = &legs_[i]->shape;
    loopVisits_[i] = store_.loopVisit(tour[i]);
  }
  double cost = loopCost_(shapes_, loopVisits_);
  for (const LegStore::Known known : {LegStore::Known::Bounded, LegStore::Known::Safe}) {
    for (std::size_t i = 0; i < count && cost < below; ++i) {
      if (legs_[i]->known < known) {
        if (job_.stopRequested()) {
          return std::numeric_limits<double>::infinity();
        }
        store_.find(tour[i], tour[(i + 1) % count], *legs_[i], known);
        cost = loopCost_(shapes_, loopVisits_);
      }
    }
  }
  return cost;
}

bool TourRefiner::take(const Tour& candidate, double below) {
  ++result_.movesTried;
  const double cost = costOf(candidate, below);
  if (!(cost < below) || job_.stopRequested()) {
    return false;
  }
  ++result_.movesAccepted;
  tour_ = candidate;
  cost_ = cost;
  return true;
}

int TourRefiner::turned(int pose, double heading) {
  VisitPose visit = store_.visit(pose);
  visit.pose.heading = std::remainder(heading, kTwoPi);
  visit.pose.heading += visit.pose.heading < 0.0 ? kTwoPi : 0.0;
  return store_.add({visit.target, visit.pose, visit.altitude, visit.onward});
}

int TourRefiner::withWord(int pose, std::optional<flight::Word> word) {
  const VisitPose& visit = store_.visit(pose);
  return store_.add({visit.target, visit.pose, visit.altitude, word});
}

bool TourRefiner::tryHeading(std::size_t place, double heading) {
  Tour candidate = tour_;
  candidate[place] = turned(candidate[place], heading);
  return candidate[place] != tour_[place] && take(candidate);
}

void TourRefiner::turnHeadings() {
  for (bool any = true; any && !isOver();) {
    any = false;
    for (std::size_t i = 0; i < tour_.size() && !isOver(); ++i) {
      double& step = turn_[static_cast<std::size_t>(store_.visit(tour_[i]).target)];
      if (step < kLeastTurn) {
        continue;
      }
      any = true;
      const double heading = store_.visit(tour_[i]).pose.heading;
      if (!tryHeading(i, heading + step) && !tryHeading(i, heading - step)) {
        step *= 0.5;
      }
    }
  }
}

bool TourRefiner::tryFarHeadings() {
  const double before = cost_;
  for (std::size_t i = 0; i < tour_.size() && !isOver(); ++i) {
    for (int h = 1; h < kFarHeadings; ++h) {
      tryHeading(i, store_.visit(tour_[i]).pose.heading + h * kTwoPi / kFarHeadings);
    }
    const std::size_t next = (i + 1) % tour_.size();
    const geo::Pose& a = store_.visit(tour_[i]).pose;
    const geo::Pose& b = store_.visit(tour_[next]).pose;
    if (next != i) {
      const double along = std::atan2(b.y - a.y, b.x - a.x);
      tryHeading(i, along);
      tryHeading(next, along);
      Tour candidate = tour_;
      candidate[i] = turned(candidate[i], along);
      candidate[next] = turned(candidate[next], along);
      take(candidate);
    }
  }
  return cost_ < before;
}

bool TourRefiner::tryWords() {
  const double before = cost_;
  for (std::size_t i = 0; i < tour_.size() && !isOver(); ++i) {
    for (const flight::Word word : flight::kWords) {
      Tour candidate = tour_;
      candidate[i] = withWord(candidate[i], word);
      take(candidate);
    }
  }
  return cost_ < before;
}

void TourRefiner::improve() {
  constexpr double kFirstTurn = Angle::kPi / 8.0;
  constexpr double kLaterTurn = Angle::kPi / 32.0;
  double step = kFirstTurn;
  for (bool again = true; again && !isOver();) {
    resetTurns(step);
    turnHeadings();
    again = tryFarHeadings();
    again = tryWords() || again;
    while (moveStretches(cost_ - kLeastGain)) {
      again = true;
    }
    while (turnStretches(cost_ - kLeastGain)) {
      again = true;
    }
    step = kLaterTurn;
    job_.progress(static_cast<double>(builder_.queries() - queriesAtStart_) / static_cast<double>(mostQueries_),
                  fmt::format("refined to {:.0f} m", cost_));
    store_.trim();
  }
}

Result<RefineResult> refineTour(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits,
                                const SegmentSettings& settings, const RefineOptions& options, const Job& job) {
  return TourRefiner(world, builder, visits, settings, options, job).run(options.insert);
}

}  // namespace vp::tour
