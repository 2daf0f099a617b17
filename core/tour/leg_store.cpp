#include "core/tour/leg_store.h"

#include "core/base/quantity.h"
#include "core/flight/dubins.h"
#include "core/tour/assembly.h"

#include <bit>

namespace vp::tour {
namespace {

constexpr std::size_t kMostLegs = 100'000;  // some 300 bytes each

std::uint64_t mixed(std::uint64_t value) {  // finaliser of SplitMix64 (Steele, Lea, Flood 2014)
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

}  // namespace

std::size_t LegStore::Hash::operator()(const PoseKey& key) const noexcept {
  return mixed(key.heading + mixed(static_cast<std::uint64_t>(key.target) * 8 + static_cast<std::uint64_t>(key.word)));
}

std::size_t LegStore::Hash::operator()(std::uint64_t key) const noexcept {
  return mixed(key);
}

LegStore::LegStore(const landing::World& world, SegmentBuilder& builder, const SegmentSettings& settings, mission::LowTargets lowTargets)
    : world_(world),
      builder_(builder),
      limits_(settings.pitch),
      forbidden_(settings.forbidden),
      spirals_(lowTargets == mission::LowTargets::Descend) {}

int LegStore::add(const VisitPose& visit) {
  const PoseKey key{visit.target, visit.onward ? 1 + static_cast<int>(*visit.onward) : 0, std::bit_cast<std::uint64_t>(visit.pose.heading)};
  const auto [place, isNew] = numbers_.try_emplace(key, static_cast<int>(visits_.size()));
  if (isNew) {
    visits_.push_back(visit);
    loopVisits_.push_back({visit.altitude, spirals_ ? spiralGround(world_, forbidden_, visit.pose, visit.altitude) : SpiralGround{}});
  }
  return place->second;
}

LegStore::Leg& LegStore::leg(int from, int to) {
  const std::uint64_t key = (static_cast<std::uint64_t>(from) << 32) | static_cast<std::uint64_t>(to);
  const auto [place, isNew] = legs_.try_emplace(key);
  if (isNew) {
    const VisitPose& a = visit(from);
    const VisitPose& b = visit(to);
    const double radius = world_.glide.tourRadius();
    LegShape& shape = place->second.shape;
    if (a.target == b.target) {
      shape.length = 2.0 * Angle::kPi * radius;
    } else if (a.onward) {
      const auto path = flight::dubinsWord(a.pose, b.pose, radius, *a.onward);
      shape.length = path ? path->length() : shape.length;
    } else {
      shape.length = flight::shortestDubins(a.pose, b.pose, radius).length();
    }
    shape.startNeed = a.altitude;
    shape.endNeed = b.altitude;
    shape.peak = std::max(a.altitude, b.altitude);
  }
  return place->second;
}

void LegStore::find(int from, int to, Leg& leg, Known known) {
  if (leg.known >= known) {
    return;
  }
  for (const int pose : {from, to}) {
    builder_.ask(visits_[static_cast<std::size_t>(pose)]);
  }
  const auto floor = known == Known::Safe ? builder_.safeFloorOf(visit(from), visit(to)) : builder_.boundFloorOf(visit(from), visit(to));
  leg.known = floor ? known : Known::Safe;  // no leg at all
  leg.shape = LegShape{};
  if (floor) {
    std::vector<LegShape::Gate> gates;
    for (const SegmentGate& gate : floor->gates) {
      gates.push_back({floor->distance[gate.point], floor->distance[gate.point + 1], gate.gate});
    }
    leg.shape = shapeOf(floor->distance, floor->lowest, limits_, gates);
  }
}

void LegStore::trim() {
  if (legs_.size() > kMostLegs) {
    legs_.clear();
  }
}

}  // namespace vp::tour
