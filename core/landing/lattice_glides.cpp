#include "core/landing/lattice_glides.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/expect.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>

namespace vp::landing {

geo::Pose LatticeGlides::poseOf(int node) const {
  if (isRoot(node)) {
    return rootOf(node).pose;
  }
  const int heading = node % headings();
  const int point = node / headings();
  const int column = point % columns;
  const int row = point / columns;
  return {originX + column * primitives.step, originY + row * primitives.step, primitives.headings[static_cast<std::size_t>(heading)]};
}

flight::Direction LatticeGlides::directionOf(int node) const {
  return isRoot(node) ? rootOf(node).direction : primitives.directions[static_cast<std::size_t>(node % headings())];
}

int LatticeGlides::siteOf(int node) const {
  while (!isRoot(node)) {
    node = nextOf(node);
  }
  return rootOf(node).site;
}

flight::DubinsPath LatticeGlides::legOf(int state) const {
  const std::uint16_t code = leg[static_cast<std::size_t>(state)];
  const auto path = flight::dubinsWord(poseOf(state), poseOf(nextOf(state)), radii[code / 8U].radius, static_cast<flight::Word>(code % 8U));
  VP_EXPECT(path.has_value());
  return *path;
}

namespace {

/// Less than this above what a glide loses is rounding [m].
constexpr double kHeldUp = 1e-3;

/** The lowest glide between two poses by the losses of one cover. */
class LegSearch {
public:
  LegSearch(const World& world, const LatticeGlides& glides, const flight::PosePair& pair, flight::Direction direction, std::int64_t& tried)
      : world_(world), glides_(glides), pair_(pair), direction_(direction), tried_(tried) {}

  /// @param end  m MSL, of the glide
  LatticeLeg lowest(const aircraft::GlideModel& cover, double end, double below) const {
    LatticeLeg best;
    const auto tryRadius = [&](std::size_t i) {
      const RadiusLoss& radius = glides_.radii[i];
      const flight::TurnLoss loss = radius.lossBy(cover);
      const flight::DubinsPath path = pair_.leastLoss(radius.radius, loss);
      const double lost = end + flight::lossOf(path, loss);
      if (lost >= below) {
        return;
      }
      ++tried_;
      if (const double altitude = requiredStartHeight(world_, path, direction_, loss, end, below); altitude < below) {
        best = {path, i, altitude, altitude > lost + kHeldUp};
        below = altitude;
      }
    };
    const auto leastOf = [&](const RadiusLoss& radius) { return end + pair_.leastLossBound(radius.radius, radius.lossBy(cover)); };
    std::size_t cheapest = glides_.radii.size();
    std::size_t tightest = 0;
    double least = below;
    for (std::size_t i = 0; i < glides_.radii.size(); ++i) {
      const RadiusLoss& radius = glides_.radii[i];
      tightest = radius.radius <= glides_.radii[tightest].radius ? i : tightest;
      if (leastOf(radius) < least) {
        const double bound = end + pair_.lossBound(radius.radius, radius.lossBy(cover));
        cheapest = bound < least ? i : cheapest;
        least = std::min(least, bound);
      }
    }
    if (cheapest < glides_.radii.size()) {
      tryRadius(cheapest);
    }
    if (const RadiusLoss& tight = glides_.radii[tightest];
        tightest != cheapest && leastOf(tight) < below && end + pair_.lossBound(tight.radius, tight.lossBy(cover)) < below) {
      tryRadius(tightest);
    }
    return best;
  }

private:
  const World& world_;
  const LatticeGlides& glides_;
  const flight::PosePair& pair_;
  flight::Direction direction_;
  std::int64_t& tried_;
};

}  // namespace

LatticeLeg lowestLeg(const World& world, const LatticeGlides& glides, const geo::Pose& from, flight::Direction direction, int node, double below,
                     std::int64_t& tried) {
  LatticeLeg best;
  const double end = glides.altitudeOf(node);
  const geo::Pose pose = glides.poseOf(node);
  if (!(end + glides.glide.leastLossOver(pose.x - from.x, pose.y - from.y) < below)) {
    return best;
  }
  const flight::PosePair pair(from, direction, pose, glides.directionOf(node));
  const LegSearch search(world, glides, pair, direction, tried);
  const auto needed = [&](const aircraft::GlideModel& cover, double low, double limit) {
    if (std::isfinite(cover.holdsUpTo())) {
      const double least = low + cover.lossOver(pose.x - from.x, pose.y - from.y);
      if (least > cover.holdsUpTo()) {
        return least;  // this cover does not reach up to it, whatever the ground asks for
      }
    }
    const LatticeLeg leg = search.lowest(cover, low, std::min(below, limit));
    if (leg.altitude <= cover.holdsUpTo() && leg.altitude < best.altitude) {
      best = leg;
    }
    return leg.altitude;
  };
  aircraft::leastStart(glides.glide, end, needed, below);
  return best;
}

}  // namespace vp::landing
