#include "core/landing/glide_primitives.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/piece_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace vp::landing {
namespace {

/// Largest column or row of the steps that define the headings: 16 headings, 18 to 27 degrees apart.
constexpr int kHeadingSteps = 2;
/// A glide is left out if others replace it at most this much dearer. Settled poses glide past intermediate ones anyway: 1.02
/// keeps 227 glides per heading instead of 64, takes twice as long and finds altitudes 0.06 m lower (mountain, 5,000 queries).
constexpr double kReplaceable = 1.4;
/// Glides this much longer than the way between their ends are detours, made of other glides.
constexpr double kLongest = 2.0;
constexpr int kLeastReach = 3;
constexpr int kMostReach = 6;

/// Directions with coprime steps, by ascending angle from East.
std::vector<double> latticeHeadings() {
  std::vector<double> headings;
  for (int rows = -kHeadingSteps; rows <= kHeadingSteps; ++rows) {
    for (int columns = -kHeadingSteps; columns <= kHeadingSteps; ++columns) {
      if (std::gcd(columns, rows) == 1) {
        headings.push_back(wrapTwoPi(std::atan2(rows, columns)));
      }
    }
  }
  std::sort(headings.begin(), headings.end());
  return headings;
}

/** Finds the control set: candidates in the order of their loss, kept if no kept one followed by the best way found so far
 *  does as well. */
class ControlSet {
public:
  ControlSet(GlidePrimitives& set, const std::vector<RadiusLoss>& radii)
      : set_(set),
        radii_(radii),
        isCalm_(radii.front().loss.byCourse == nullptr),
        headings_(static_cast<int>(set.headings.size())),
        side_(2 * set.reach + 1) {
    const std::size_t states = set.headings.size() * static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
    best_.assign(states * set.headings.size(), std::numeric_limits<double>::infinity());
    kept_.resize(static_cast<std::size_t>(headings_));
  }

  void build() {
    std::vector<GlidePrimitive> candidates = makeCandidates();
    std::stable_sort(candidates.begin(), candidates.end(), [](const GlidePrimitive& a, const GlidePrimitive& b) { return a.loss < b.loss; });
    set_.arrivals.resize(static_cast<std::size_t>(headings_));
    for (const GlidePrimitive& candidate : candidates) {
      const double replaced = replacement(candidate);
      double& best = best_[index(candidate.from, candidate.columns, candidate.rows, candidate.to)];
      if (replaced <= kReplaceable * candidate.loss) {
        best = replaced;
        continue;
      }
      best = candidate.loss;
      kept_[static_cast<std::size_t>(candidate.from)].push_back(candidate);
      set_.arrivals[static_cast<std::size_t>(candidate.to)].push_back(candidate);
    }
  }

private:
  [[nodiscard]] std::size_t index(int from, int columns, int rows, int to) const {
    const int place = (from * side_ + rows + set_.reach) * side_ + columns + set_.reach;
    return static_cast<std::size_t>(place) * static_cast<std::size_t>(headings_) + static_cast<std::size_t>(to);
  }

  /// Least loss of a kept glide followed by what is known about the rest.
  [[nodiscard]] double replacement(const GlidePrimitive& wanted) const {
    double least = std::numeric_limits<double>::infinity();
    for (const GlidePrimitive& first : kept_[static_cast<std::size_t>(wanted.from)]) {
      const int columns = wanted.columns - first.columns;
      const int rows = wanted.rows - first.rows;
      if (std::max(std::abs(columns), std::abs(rows)) <= set_.reach) {
        least = std::min(least, first.loss + best_[index(first.to, columns, rows, wanted.to)]);
      }
    }
    return least;
  }

  [[nodiscard]] std::vector<GlidePrimitive> makeCandidates() const {
    std::vector<GlidePrimitive> candidates;
    const int needed = isCalm_ ? headings_ / 4 : headings_;  // in calm air the others are these turned by quarter circles
    for (int from = 0; from < needed; ++from) {
      for (int rows = -set_.reach; rows <= set_.reach; ++rows) {
        for (int columns = -set_.reach; columns <= set_.reach; ++columns) {
          if (columns == 0 && rows == 0) {
            continue;
          }
          for (int to = 0; to < headings_; ++to) {
            addCandidate(from, columns, rows, to, candidates);
          }
        }
      }
    }
    return candidates;
  }

  [[nodiscard]] GlidePrimitive turnedLeft(GlidePrimitive primitive) const {
    const int quarter = headings_ / 4;
    primitive.from = (primitive.from + quarter) % headings_;
    primitive.to = (primitive.to + quarter) % headings_;
    std::swap(primitive.columns, primitive.rows);
    primitive.columns = -primitive.columns;
    return primitive;
  }

  void addCandidate(int from, int columns, int rows, int to, std::vector<GlidePrimitive>& candidates) const {
    const geo::Pose start{0.0, 0.0, set_.headings[static_cast<std::size_t>(from)]};
    const geo::Pose end{columns * set_.step, rows * set_.step, set_.headings[static_cast<std::size_t>(to)]};
    const flight::PosePair pair(start, set_.directions[static_cast<std::size_t>(from)], end, set_.directions[static_cast<std::size_t>(to)]);
    GlidePrimitive best{columns, rows, from, to, 0, flight::Word::LSL, std::numeric_limits<double>::infinity()};
    double length = 0.0;
    for (std::size_t i = 0; i < radii_.size(); ++i) {
      if (pair.lossBound(radii_[i].radius, radii_[i].loss) >= best.loss) {
        continue;
      }
      const flight::DubinsPath path = pair.leastLoss(radii_[i].radius, radii_[i].loss);
      if (const double loss = flight::lossOf(path, radii_[i].loss); loss < best.loss) {
        best.radius = i;
        best.word = path.word;
        best.loss = loss;
        length = path.length();
      }
    }
    if (length > kLongest * pair.distance()) {
      return;
    }
    for (int quarter = 0; quarter < (isCalm_ ? 4 : 1); ++quarter) {
      candidates.push_back(best);
      best = turnedLeft(best);
    }
  }

  GlidePrimitives& set_;
  const std::vector<RadiusLoss>& radii_;
  bool isCalm_;
  int headings_;
  int side_;
  std::vector<double> best_;  ///< least loss found between two poses, by index()
  std::vector<std::vector<GlidePrimitive>> kept_;
};

}  // namespace

std::vector<RadiusLoss> radiusLossesOf(const aircraft::GlideModel& glide) {
  std::vector<RadiusLoss> losses;
  for (const double radius : glide.glideRadii()) {
    losses.push_back({radius, flight::turnLossOf(glide, radius), losses.size()});
  }
  return losses;
}

std::size_t GlidePrimitives::headingBelow(double angle) const {
  const double wrapped = wrapTwoPi(angle);
  const auto above = std::upper_bound(headings.begin(), headings.end(), wrapped);
  return static_cast<std::size_t>(above - headings.begin()) - 1;  // the first heading is East, zero
}

GlidePrimitives makeGlidePrimitives(const std::vector<RadiusLoss>& radii, double step) {
  VP_EXPECT(!radii.empty() && step > 0.0);
  GlidePrimitives set;
  set.step = step;
  double smallest = radii.front().radius;
  for (const RadiusLoss& radius : radii) {
    smallest = std::min(smallest, radius.radius);
  }
  // a turn from one heading to the next but one must find room
  set.reach = std::clamp(static_cast<int>(std::ceil(2.0 * smallest / step)), kLeastReach, kMostReach);
  set.headings = latticeHeadings();
  for (const double heading : set.headings) {
    set.directions.emplace_back(heading);
  }
  ControlSet(set, radii).build();
  return set;
}

}  // namespace vp::landing
