#include "core/emergency/glide_smoothing.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/quantity.h"
#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

namespace vp::emergency {
namespace {

/// Courses at a point beside those of the legs and the one between them [rad].
constexpr double kOff = 0.35;
/// Points closer to one another than this are one [m].
constexpr double kSame = 1.0;

double courseTo(geo::Point from, geo::Point to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

/// Courses at a point of the way: as it comes, as it leaves, and around the middle of the two.
std::array<double, 5> coursesAt(geo::Point before, geo::Point at, geo::Point after) {
  const double in = courseTo(before, at);
  const double out = courseTo(at, after);
  const double middle = in + 0.5 * wrapPi(out - in);
  return {middle, in, out, middle - kOff, middle + kOff};
}

}  // namespace

/// The curve that arrives highest, over all radii; if it is higher than `atLeast`.
GlideSmoothing::Curve GlideSmoothing::curve(const geo::Pose& from, double altitude, const geo::Pose& to, double atLeast) const {
  const aircraft::GlideBands* const bands = world_.glide.bands();
  const std::size_t band = bands == nullptr ? 0 : bands->below(altitude);
  const aircraft::GlideModel& model = bands == nullptr ? world_.glide : bands->between(band, band);
  const flight::PosePair pair(from, to);
  Curve best;
  best.altitude = atLeast;
  bool exists = false;
  for (std::size_t radius = 0; radius < world_.glide.glideRadii().size(); ++radius) {
    const flight::TurnLoss loss = flight::turnLossAt(model, radius);
    const flight::DubinsPath path = pair.leastLoss(world_.glide.glideRadii()[radius], loss);
    if (bands == nullptr && altitude - flight::lossOf(path, loss) <= best.altitude) {
      continue;
    }
    const double end = flight_.endOf(path, radius, altitude);
    if (end > best.altitude) {
      best = {path, end};
      exists = true;
    }
  }
  if (!exists) {
    best.altitude = GlideFlight::kTouches;
  }
  return best;
}

std::optional<SmoothGlide> GlideSmoothing::smooth(const geo::Pose& start, double altitude, const std::vector<geo::Point>& points,
                                                  const geo::Pose& gate, double atLeast) const {
  struct State {
    geo::Pose pose;
    Curve curve;  ///< from `parent`
    int parent = -1;
  };
  struct Candidate {
    double altitude = 0.0;  ///< bound
    std::size_t from = 0;
  };
  std::vector<State> states{{start, {{}, altitude}, -1}};
  std::vector<std::size_t> behind{0};  // first state of each point
  std::vector<geo::Point> way{start.point()};
  for (const geo::Point& point : points) {
    if (geo::distance(way.back(), point) > kSame && geo::distance(point, gate.point()) > kSame) {
      way.push_back(point);
    }
  }
  way.push_back(gate.point());
  std::vector<Candidate> candidates;
  for (std::size_t at = 1; at < way.size(); ++at) {
    const bool isGate = at + 1 == way.size();
    const std::size_t first = states.size();
    if (isGate) {
      states.push_back({gate, {}, -1});
    } else {
      for (const double course : coursesAt(way[at - 1], way[at], way[at + 1])) {
        states.push_back({{way[at].x, way[at].y, course}, {}, -1});
      }
    }
    for (std::size_t to = first; to < states.size(); ++to) {
      State& state = states[to];
      double highest = isGate ? atLeast : GlideFlight::kTouches;
      candidates.clear();
      for (std::size_t from = 0; from < first; ++from) {
        const double start0 = states[from].curve.altitude;
        if (start0 > GlideFlight::kTouches) {
          candidates.push_back({start0 - goals_.leastLoss(states[from].pose, state.pose), from});
        }
      }
      std::sort(candidates.begin(), candidates.end(),
                [](const Candidate& a, const Candidate& b) { return a.altitude != b.altitude ? a.altitude > b.altitude : a.from < b.from; });
      for (const Candidate& candidate : candidates) {
        if (candidate.altitude <= highest) {
          break;
        }
        const State& from = states[candidate.from];
        const Curve found = curve(from.pose, from.curve.altitude, state.pose, highest);
        if (found.altitude > highest) {
          highest = found.altitude;
          state.curve = found;
          state.parent = static_cast<int>(candidate.from);
        }
      }
    }
  }
  if (states.back().parent < 0) {
    return std::nullopt;
  }
  std::vector<const State*> chain;
  for (const State* state = &states.back(); state->parent >= 0; state = &states[static_cast<std::size_t>(state->parent)]) {
    chain.push_back(state);
  }
  SmoothGlide glide;
  glide.altitude = states.back().curve.altitude;
  for (auto state = chain.rbegin(); state != chain.rend(); ++state) {
    flight::appendPieces((*state)->curve.path, glide.pieces);
    if (*state != &states.back()) {
      glide.poses.push_back((*state)->pose);
    }
  }
  return glide;
}

void GlideSmoothing::polish(const geo::Pose& start, double altitude, const geo::Pose& gate, SmoothGlide& glide, double reach, int tries,
                            std::uint64_t seed, const std::function<bool()>& isOver) const {
  if (glide.poses.empty()) {
    return;
  }
  std::mt19937_64 engine(seed);
  const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  constexpr double kLeastReach = 5.0;    // m: a second's flight is not 10 cm of height here
  constexpr double kTurnReach = 1000.0;  // m: from here on courses are turned by up to half a circle
  for (int i = 0; i < tries && !isOver(); ++i) {
    const double far = std::max(kLeastReach, reach) * std::pow(kLeastReach / std::max(kLeastReach, reach), unit());
    std::vector<geo::Pose> poses = glide.poses;
    geo::Pose& moved = poses[static_cast<std::size_t>(i) % poses.size()];
    moved.x += far * (2.0 * unit() - 1.0);
    moved.y += far * (2.0 * unit() - 1.0);
    moved.heading += Angle::kPi * std::min(1.0, far / kTurnReach) * (2.0 * unit() - 1.0);
    SmoothGlide better;
    better.altitude = altitude;
    geo::Pose from = start;
    poses.push_back(gate);
    for (std::size_t at = 0; at < poses.size() && better.altitude > GlideFlight::kTouches; ++at) {
      // who is no higher here than the glide will be at the gate is out
      const Curve next = curve(from, better.altitude, poses[at], glide.altitude);
      better.altitude = next.altitude;
      flight::appendPieces(next.path, better.pieces);
      from = poses[at];
    }
    poses.pop_back();
    if (better.altitude > glide.altitude) {
      better.poses = std::move(poses);
      glide = std::move(better);
    }
  }
}

}  // namespace vp::emergency
