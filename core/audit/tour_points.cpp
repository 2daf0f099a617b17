#include "core/audit/tour_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::audit {
namespace {

constexpr double kSameRadius = 1e-6;  // relative
constexpr double kNoLength = 1e-6;    // m

/** Runs along pieces one after the other. */
struct Cursor {
  const std::vector<flight::Piece>& pieces;
  std::size_t at = 0;
  double flown = 0.0;

  bool skip() {
    while (at < pieces.size() && pieces[at].length - flown <= kNoLength) {
      ++at;
      flown = 0.0;
    }
    return at < pieces.size();
  }
  [[nodiscard]] double left() const { return pieces[at].length - flown; }
};

bool bendsAlike(const flight::Piece& a, const flight::Piece& b) {
  return a.turn == b.turn && (a.turn == flight::Turn::Straight || std::abs(a.radius - b.radius) <= kSameRadius * a.radius);
}

void add(std::vector<Interval>& all, double& length, const char* track, const std::vector<mission::DecisionPoint>& points, std::size_t first,
         bool isClosed) {
  const std::size_t count = isClosed ? points.size() : points.size() - std::min<std::size_t>(points.size(), 1);
  for (std::size_t i = first; i < count; ++i) {
    if (points[i].onward.length > 0.0) {
      all.push_back({track, i, &points, isClosed, length});
      length += points[i].onward.length;
    }
  }
}

}  // namespace

std::vector<Interval> intervalsOf(const mission::Plan& plan) {
  std::vector<Interval> all;
  double length = 0.0;
  add(all, length, "tour", plan.tour, 0, true);
  if (plan.departure) {
    add(all, length, "departure", plan.departure->points, static_cast<std::size_t>(std::max(0, plan.departure->guaranteed)), false);
  }
  if (plan.arrival) {
    add(all, length, "arrival", plan.arrival->points, static_cast<std::size_t>(std::max(0, plan.arrival->guaranteed)), false);
  }
  return all;
}

double firstOwnTurn(const Interval& interval) {
  const mission::Witness& glide = interval.to().witness;
  std::vector<flight::Piece> tour;
  const std::size_t count = interval.points->size();
  double glideLength = 0.0;
  for (const flight::Piece& piece : glide.pieces) {
    glideLength += piece.length;
  }
  double tourLength = 0.0;
  for (std::size_t k = 0, i = interval.next(); k < count && tourLength < glideLength; ++k, i = i + 1 < count ? i + 1 : 0) {
    if (!interval.isClosed && i + 1 == count) {
      break;  // the way ends here
    }
    tour.push_back((*interval.points)[i].onward);
    tourLength += tour.back().length;
  }
  Cursor flown{glide.pieces};
  Cursor along{tour};
  bool follows = true;
  double distance = 0.0;
  while (flown.skip()) {
    follows = follows && along.skip() && bendsAlike(flown.pieces[flown.at], along.pieces[along.at]);
    if (!follows && flown.pieces[flown.at].turn != flight::Turn::Straight) {
      return distance;
    }
    const double together = follows ? std::min(flown.left(), along.left()) : flown.left();
    flown.flown += together;
    along.flown += follows ? together : 0.0;
    distance += together;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace vp::audit
