#include "core/tour/refine.h"

#include "core/base/quantity.h"
#include "core/tour/gtsp_random.h"
#include "core/tour/leg_store.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vp::tour {
namespace {

constexpr double kLeastGain = 0.1;          // m; smaller gains are not worth a change
constexpr double kLeastTurn = 0.01;         // rad, the smallest step of a heading
constexpr std::size_t kLongestStretch = 3;  // targets that are moved together
constexpr std::size_t kNeighbours = 8;      // targets that a target may be put beside
constexpr int kFarHeadings = 8;             // headings tried where a target is put to another place
constexpr double kWorseStart = 1.03;        // a changed order may cost so much more than the best before it is refined
constexpr double kTwoPi = 2.0 * Angle::kPi;

using Tour = std::vector<int>;  // pose numbers in flying order

/** The search: a tour, what it costs, and the moves. */
class Refiner {
public:
  Refiner(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits, const SegmentSettings& settings,
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

  Result<RefineResult> run(const std::vector<VisitPose>& missing) {
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

private:
  /// Long legs have more points to ask at: so many times more queries than legs of kUsualPoints.
  double legFactor(double step) {
    constexpr double kUsualPoints = 20.0;
    constexpr double kMostFactor = 4.0;
    double length = 0.0;
    for (std::size_t i = 0; i < tour_.size(); ++i) {
      length += store_.leg(tour_[i], tour_[(i + 1) % tour_.size()]).shape.length;
    }
    return std::clamp(length / (step * kUsualPoints * static_cast<double>(tour_.size())), 1.0, kMostFactor);
  }

  void findNeighbours(const std::vector<VisitPose>& visits) {
    isNeighbour_.assign(targets_ * targets_, 0);
    std::vector<std::pair<double, int>> order;
    for (const VisitPose& from : visits) {
      order.clear();
      for (const VisitPose& to : visits) {
        if (to.target != from.target) {
          order.emplace_back(geo::distance(from.pose.point(), to.pose.point()), to.target);
        }
      }
      std::sort(order.begin(), order.end());
      for (std::size_t i = 0; i < std::min(kNeighbours, order.size()); ++i) {
        const auto a = static_cast<std::size_t>(from.target);
        const auto b = static_cast<std::size_t>(order[i].second);
        isNeighbour_[a * targets_ + b] = isNeighbour_[b * targets_ + a] = 1;
      }
    }
  }

  [[nodiscard]] bool areNear(int a, int b) const {
    return isNeighbour_[static_cast<std::size_t>(store_.visit(a).target) * targets_ + static_cast<std::size_t>(store_.visit(b).target)] != 0;
  }

  [[nodiscard]] bool isOver() const { return job_.stopRequested() || builder_.queries() - queriesAtStart_ >= mostQueries_; }

  /// Cost of the loop if it is below `below`; otherwise some number that is not. Finds no more about the legs than that needs.
  double costOf(const Tour& tour, double below) {
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

  /// Takes a tour if it costs less than `below`.
  bool take(const Tour& candidate, double below) {
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
  bool take(const Tour& candidate) { return take(candidate, cost_ - kLeastGain); }

  [[nodiscard]] int turned(int pose, double heading) {
    VisitPose visit = store_.visit(pose);
    visit.pose.heading = std::remainder(heading, kTwoPi);
    visit.pose.heading += visit.pose.heading < 0.0 ? kTwoPi : 0.0;
    return store_.add({visit.target, visit.pose, visit.altitude, visit.onward});
  }
  [[nodiscard]] int withWord(int pose, std::optional<flight::Word> word) {
    const VisitPose& visit = store_.visit(pose);
    return store_.add({visit.target, visit.pose, visit.altitude, word});
  }
  [[nodiscard]] int reversed(int pose) { return turned(withWord(pose, std::nullopt), store_.visit(pose).pose.heading + Angle::kPi); }

  bool tryHeading(std::size_t place, double heading) {
    Tour candidate = tour_;
    candidate[place] = turned(candidate[place], heading);
    return candidate[place] != tour_[place] && take(candidate);
  }

  /// Turns headings by steps that are halved where neither side is better.
  void turnHeadings() {
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

  /// Headings far from the present ones, and along the straight line to the next target.
  bool tryFarHeadings() {
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

  bool tryWords() {
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

  /// Words belong to legs: where the next target is another one, the shortest word counts again.
  void dropWords(Tour& candidate) {
    for (std::size_t i = 0; i < candidate.size(); ++i) {
      const auto old = store_.visit(candidate[i]).onward ? std::find(tour_.begin(), tour_.end(), candidate[i]) : tour_.end();
      if (old != tour_.end()) {
        const auto next = static_cast<std::size_t>(old - tour_.begin() + 1) % tour_.size();
        if (tour_[next] != candidate[(i + 1) % candidate.size()]) {
          candidate[i] = withWord(candidate[i], std::nullopt);
        }
      }
    }
  }

  /// The tour with the stretch [first, first + length) taken out.
  void takeOut(std::size_t first, std::size_t length, Tour& stretch, Tour& rest) const {
    stretch.clear();
    rest.clear();
    for (std::size_t k = 0; k < tour_.size(); ++k) {
      (k < length ? stretch : rest).push_back(tour_[(first + k) % tour_.size()]);
    }
  }

  /// Puts a stretch between rest[place] and the one behind it.
  [[nodiscard]] Tour joined(const Tour& rest, std::size_t place, const Tour& stretch) {
    Tour candidate(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(place) + 1);
    candidate.insert(candidate.end(), stretch.begin(), stretch.end());
    candidate.insert(candidate.end(), rest.begin() + static_cast<std::ptrdiff_t>(place) + 1, rest.end());
    dropWords(candidate);
    return candidate;
  }

  /// Moves stretches of up to three targets to another place, either way round, a single one with other headings.
  bool moveStretches(double below) {
    Tour stretch;
    Tour rest;
    for (std::size_t length = 1; length <= kLongestStretch && length + 2 <= tour_.size(); ++length) {
      for (std::size_t first = 0; first < tour_.size(); ++first) {
        takeOut(first, length, stretch, rest);
        Tour back(stretch.rbegin(), stretch.rend());
        std::transform(back.begin(), back.end(), back.begin(), [this](int pose) { return reversed(pose); });
        for (std::size_t place = 0; place + 1 < rest.size(); ++place) {
          if (isOver()) {
            return false;
          }
          if (!areNear(rest[place], stretch.front()) && !areNear(rest[place + 1], stretch.back()) && !areNear(rest[place], stretch.back()) &&
              !areNear(rest[place + 1], stretch.front())) {
            continue;
          }
          if (take(joined(rest, place, stretch), below) || take(joined(rest, place, back), below) ||
              (length == 1 && tryHeadingsAt(rest, place, stretch.front(), below))) {
            return true;
          }
        }
      }
    }
    return false;
  }

  bool tryHeadingsAt(const Tour& rest, std::size_t place, int pose, double below) {
    for (int h = 1; h < kFarHeadings; ++h) {
      const Tour single{turned(pose, store_.visit(pose).pose.heading + h * kTwoPi / kFarHeadings)};
      if (2 * h != kFarHeadings && take(joined(rest, place, single), below)) {
        return true;
      }
    }
    return false;
  }

  /// Flies a stretch the other way round.
  bool turnStretches(double below) {
    Tour stretch;
    Tour rest;
    for (std::size_t length = 2; length <= tour_.size(); ++length) {
      for (std::size_t first = 0; first < (length < tour_.size() ? tour_.size() : 1); ++first) {
        if (isOver()) {
          return false;
        }
        takeOut(first, length, stretch, rest);
        if (!rest.empty() && !areNear(rest.back(), stretch.back()) && !areNear(rest.front(), stretch.front())) {
          continue;
        }
        std::reverse(stretch.begin(), stretch.end());
        std::transform(stretch.begin(), stretch.end(), stretch.begin(), [this](int pose) { return reversed(pose); });
        Tour candidate = stretch;
        candidate.insert(candidate.end(), rest.begin(), rest.end());
        dropWords(candidate);
        if (take(candidate, below)) {
          return true;
        }
      }
    }
    return false;
  }

  /// Puts a target to its cheapest place, by some headings.
  void insert(const VisitPose& visit) {
    Tour best;
    double bestCost = std::numeric_limits<double>::infinity();
    const int pose = store_.add(visit);
    for (std::size_t place = 0; place < tour_.size() && !job_.stopRequested(); ++place) {
      for (int h = 0; h < kFarHeadings; ++h) {
        const Tour candidate = joined(tour_, place, {turned(pose, visit.pose.heading + h * kTwoPi / kFarHeadings)});
        ++result_.movesTried;
        if (const double cost = costOf(candidate, bestCost); cost < bestCost) {
          bestCost = cost;
          best = candidate;
        }
      }
    }
    cost_ = bestCost;
    tour_ = std::isfinite(bestCost) ? best : joined(tour_, tour_.size() - 1, {pose});
  }

  void resetTurns(double step) { turn_.assign(targets_, step); }

  /// Down to where no single move helps.
  void improve() {
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

  std::size_t drawn(std::size_t n) { return static_cast<std::size_t>(random_.below(static_cast<int>(n))); }

  /// A random stretch put to a random place, or turned round; whatever it costs up to `below`.
  bool changeOrder(double below) {
    Tour stretch;
    Tour rest;
    const std::size_t count = tour_.size();
    for (int attempt = 0; attempt < 50 && !isOver(); ++attempt) {
      const std::size_t length = 1 + drawn(std::min(kLongestStretch, count - 2));
      takeOut(drawn(count), length, stretch, rest);
      if (drawn(2) == 1) {
        std::reverse(stretch.begin(), stretch.end());
        std::transform(stretch.begin(), stretch.end(), stretch.begin(), [this](int pose) { return reversed(pose); });
      }
      const std::size_t place = drawn(rest.size());
      if ((areNear(rest[place], stretch.front()) || areNear(rest[(place + 1) % rest.size()], stretch.back())) &&
          take(joined(rest, place, stretch), below)) {
        return true;
      }
    }
    return false;
  }

  /// Refines from changed orders and keeps the best, until the queries are used up or nothing new is found for long.
  void tryChangedOrders() {
    if (tour_.size() < 4) {
      return;
    }
    const int patience = static_cast<int>(2 * tour_.size());
    for (int failures = 0; failures < patience && !isOver();) {
      const Tour best = tour_;
      const double bestCost = cost_;
      if (changeOrder(bestCost * kWorseStart)) {
        improve();
      }
      if (cost_ < bestCost - kLeastGain) {
        failures = 0;
      } else {
        ++failures;
        tour_ = best;
        cost_ = bestCost;
      }
    }
  }

  SegmentBuilder& builder_;
  const Job& job_;
  LegStore store_;
  LoopCost loopCost_;
  Random random_;
  std::int64_t queriesAtStart_ = 0;
  std::int64_t mostQueries_ = 0;
  std::size_t targets_ = 0;
  int firstTarget_ = 0;
  std::vector<char> isNeighbour_;
  std::vector<double> turn_;  ///< step of the heading of each target, rad
  Tour tour_;
  double cost_ = 0.0;
  std::vector<LegStore::Leg*> legs_;
  std::vector<const LegShape*> shapes_;
  std::vector<LoopVisit> loopVisits_;
  RefineResult result_;
};

}  // namespace

Result<RefineResult> refineTour(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits,
                                const SegmentSettings& settings, const RefineOptions& options, const Job& job) {
  return Refiner(world, builder, visits, settings, options, job).run(options.insert);
}

}  // namespace vp::tour
