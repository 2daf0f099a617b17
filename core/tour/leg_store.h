#pragma once

#include "core/landing/world.h"
#include "core/tour/loop_cost.h"
#include "core/tour/segment.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

namespace vp::tour {

/** Visit poses by number and the legs between them, each as well known as was asked for so far.
 *  @threads one object per thread */
class LegStore {
public:
  /** How a leg is known: over no ground, by a bound that asks at its ends only, or safe. Each is a lower bound of the next. */
  enum class Known : unsigned char { Bare, Bounded, Safe };

  struct Leg {
    Known known = Known::Bare;
    LegShape shape;
  };

  LegStore(const landing::World& world, SegmentBuilder& builder, const SegmentSettings& settings, mission::LowTargets lowTargets);

  /** Number of a pose; the same pose has one number. */
  int add(const VisitPose& visit);
  [[nodiscard]] const VisitPose& visit(int pose) const { return visits_[static_cast<std::size_t>(pose)]; }
  [[nodiscard]] const LoopVisit& loopVisit(int pose) const { return loopVisits_[static_cast<std::size_t>(pose)]; }

  /** The leg, at least as a bare one. Shapes change only by find(). */
  Leg& leg(int from, int to);

  /** Finds a leg out as far as `known`. */
  void find(int from, int to, Leg& leg, Known known);

  /** Drops all legs if there are very many: memory stays bounded and answers the same. Do not keep legs over this call. */
  void trim();

private:
  struct PoseKey {
    int target = 0;
    int word = 0;
    std::uint64_t heading = 0;
    bool operator==(const PoseKey&) const = default;
  };
  struct Hash {
    std::size_t operator()(const PoseKey& key) const noexcept;
    std::size_t operator()(std::uint64_t key) const noexcept;
  };

  const landing::World& world_;
  SegmentBuilder& builder_;
  PitchLimits limits_;
  const ForbiddenAirspace* forbidden_ = nullptr;
  bool spirals_ = false;
  std::deque<VisitPose> visits_;
  std::deque<LoopVisit> loopVisits_;
  std::unordered_map<PoseKey, int, Hash> numbers_;
  std::unordered_map<std::uint64_t, Leg, Hash> legs_;
};

}  // namespace vp::tour
