// The moves of the refinement that change the order of the targets.
#include "core/tour/tour_refiner.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vp::tour {
namespace {

constexpr std::size_t kLongestStretch = 3;  // targets that are moved together
constexpr std::size_t kNeighbours = 8;      // targets that a target may be put beside
constexpr double kWorseStart = 1.03;        // a changed order may cost so much more than the best before it is refined

}  // namespace

void TourRefiner::findNeighbours(const std::vector<VisitPose>& visits) {
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

void TourRefiner::dropWords(Tour& candidate) {
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

void TourRefiner::takeOut(std::size_t first, std::size_t length, Tour& stretch, Tour& rest) const {
  stretch.clear();
  rest.clear();
  for (std::size_t k = 0; k < tour_.size(); ++k) {
    (k < length ? stretch : rest).push_back(tour_[(first + k) % tour_.size()]);
  }
}

TourRefiner::Tour TourRefiner::joined(const Tour& rest, std::size_t place, const Tour& stretch) {
  Tour candidate(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(place) + 1);
  candidate.insert(candidate.end(), stretch.begin(), stretch.end());
  candidate.insert(candidate.end(), rest.begin() + static_cast<std::ptrdiff_t>(place) + 1, rest.end());
  dropWords(candidate);
  return candidate;
}

bool TourRefiner::moveStretches(double below) {
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

bool TourRefiner::tryHeadingsAt(const Tour& rest, std::size_t place, int pose, double below) {
  for (int h = 1; h < kFarHeadings; ++h) {
    const Tour single{turned(pose, store_.visit(pose).pose.heading + h * kTwoPi / kFarHeadings)};
    if (2 * h != kFarHeadings && take(joined(rest, place, single), below)) {
      return true;
    }
  }
  return false;
}

bool TourRefiner::turnStretches(double below) {
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

void TourRefiner::insert(const VisitPose& visit) {
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

bool TourRefiner::changeOrder(double below) {
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

void TourRefiner::tryChangedOrders() {
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

}  // namespace vp::tour
