#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/altitude_floor.h"
#include "core/tour/segment.h"

#include <memory>
#include <vector>

namespace vp::tour {

/** Lower bounds of the cost of safe segments that ask no roadmap and walk no terrain: what the lazy search begins with.
 *  Both never exceed what SegmentBuilder::safeSegment gives for the same visits, infinity included; proof: WHY.md.
 *  The ends count with VisitPose::safe where that is known, else with the altitude floor.
 *  @threads one object per thread: it keeps working memory */
class SegmentBound {
public:
  SegmentBound(const landing::World& world, const landing::AltitudeFloor& floor, const Detours& detours, const SegmentSettings& settings);

  /** Straight from end to end, no higher than the ends ask for. @cost some 10 ns */
  [[nodiscard]] double plain(const VisitPose& from, const VisitPose& to) const;

  /** The Dubins leg as safeSegment cuts it, with the ground and the altitude floor at its decision points only, pitch
   *  limits, concave profile. For pairs with a detour the same as plain with the leg's length. @cost some 1.5 us for 2 km */
  [[nodiscard]] SegmentCost leg(const VisitPose& from, const VisitPose& to);

private:
  /// The bands' losses are met again in covers, summed in another order.
  [[nodiscard]] double bandRounding() const { return losses_.size() > 1 ? 1.0 - 1e-12 : 1.0; }
  [[nodiscard]] double endFloor(const VisitPose& visit) const;
  [[nodiscard]] double penalty(const VisitPose& from, const VisitPose& to, double first, double last) const;
  bool sample(const VisitPose& from);
  bool addPoint(double x, double y, double distance, double loss);

  const landing::World& world_;
  const landing::AltitudeFloor& altitudeFloor_;
  const Detours& detours_;
  SegmentSettings settings_;
  std::vector<flight::TurnLoss> losses_;  ///< of each band, where they differ by altitude
  double leastTurn_ = 0.0;                ///< per metre, of all
  double originX_ = 0.0;
  double originY_ = 0.0;
  double perCell_ = 0.0;
  std::vector<flight::Piece> pieces_;
  std::vector<double> distance_;
  std::vector<double> floor_;
  std::vector<std::size_t> hull_;
  double lastGround_ = 0.0;  ///< clear of the ground at the point added last, m MSL
  double lastLoss_ = 0.0;    ///< of a glide along the interval before it, m
};

/** The altitude floor that a search over these visits uses, where none is given. @errors Cancelled */
Result<std::shared_ptr<const landing::AltitudeFloor>> buildFloor(const landing::World& world, const std::vector<VisitPose>& visits, const Job& job);

}  // namespace vp::tour
