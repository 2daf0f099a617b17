#include "core/tour/home_joins.h"

#include <algorithm>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostJoins = 48;  // evenly spaced points of the tour that are tried, beside the visits

}  // namespace

HomeJoins::HomeJoins(const mission::Plan& plan) : plan_(plan) {
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

double HomeJoins::flown(std::size_t joined, std::size_t left) const {
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

std::optional<std::pair<std::size_t, std::size_t>> HomeJoins::bestPair(const std::vector<double>& departures,
                                                                       const std::vector<double>& arrivals) const {
  double best = kInfinite;
  std::optional<std::pair<std::size_t, std::size_t>> pair;
  for (std::size_t d = 0; d < joins_.size(); ++d) {
    for (std::size_t a = 0; a < joins_.size() && departures[d] < kInfinite; ++a) {
      if (arrivals[a] < kInfinite) {
        const double all = departures[d] + arrivals[a] + flown(joins_[d].point, joins_[a].point);
        if (all < best) {
          best = all;
          pair = {d, a};
        }
      }
    }
  }
  return pair;
}

}  // namespace vp::tour
