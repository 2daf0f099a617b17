#include "core/landing/lattice_glides.h"

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
}  // namespace

LatticeLeg lowestLeg(const World& world, const LatticeGlides& glides, const geo::Pose& from, flight::Direction direction, int node, double below,
                     std::int64_t& tried) {
  LatticeLeg best;
  const double end = glides.altitudeOf(node);
  const geo::Pose pose = glides.poseOf(node);
  const double dx = pose.x - from.x;
  const double dy = pose.y - from.y;
  if (end + glides.radii.front().loss.straightOver(dx, dy, std::sqrt(dx * dx + dy * dy)) >= below) {
    return best;
  }
  const flight::PosePair pair(from, direction, pose, glides.directionOf(node));
  const auto tryRadius = [&](std::size_t i) {
    const RadiusLoss& radius = glides.radii[i];
    const flight::DubinsPath path = pair.leastLoss(radius.radius, radius.loss);
    const double lost = end + flight::lossOf(path, radius.loss);
    if (lost >= below) {
      return;
    }
    ++tried;
    if (const double altitude = requiredStartHeight(world, path, direction, radius.loss, end, below); altitude < below) {
      best = {path, i, altitude, altitude > lost + kHeldUp};
      below = altitude;
    }
  };
  const auto leastOf = [&](const RadiusLoss& radius) { return end + pair.leastLossBound(radius.radius, radius.loss); };
  std::size_t cheapest = glides.radii.size();
  std::size_t tightest = 0;
  double least = below;
  for (std::size_t i = 0; i < glides.radii.size(); ++i) {
    const RadiusLoss& radius = glides.radii[i];
    tightest = radius.radius <= glides.radii[tightest].radius ? i : tightest;
    if (leastOf(radius) < least) {
      const double bound = end + pair.lossBound(radius.radius, radius.loss);
      cheapest = bound < least ? i : cheapest;
      least = std::min(least, bound);
    }
  }
  if (cheapest < glides.radii.size()) {
    tryRadius(cheapest);
  }
  if (const RadiusLoss& tight = glides.radii[tightest];
      tightest != cheapest && leastOf(tight) < below && end + pair.lossBound(tight.radius, tight.loss) < below) {
    tryRadius(tightest);
  }
  return best;
}

}  // namespace vp::landing
