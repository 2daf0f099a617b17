#pragma once

#include "core/audit/glide_motion.h"
#include "core/audit/ground_track.h"
#include "core/audit/roll_account.h"
#include "core/mission/mission.h"

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace vp::audit {

/** What is left beyond what is promised [m], each looked at in every sample. */
enum class MarginKind { TourClearance, GlideClearance, Rolling, Key, Arrival };
inline constexpr std::size_t kMarginKinds = 5;

/** Where something is least on the way of one sample. */
struct LeastPlace {
  double left = std::numeric_limits<double>::infinity();
  geo::Point where;
  double altitude = 0.0;  ///< m MSL, of the aircraft
  double seconds = 0.0;   ///< since the engine stopped
};

/** A glide that a point of the plan brings, cut into metres over its ground: the same for all samples that fly it, as it is kept over ground. */
struct PromisedGlide {
  GroundTrack track;
  std::optional<std::size_t> gate;  ///< as askForClearance
  double elevation = 0.0;           ///< of its site [m MSL]
  std::string fault;                ///< that no height can make good; empty if there is none
};

/** One flight after an engine failure, in one wind, metre by metre. */
class SampleFlight {
public:
  SampleFlight(const mission::Mission& mission, const GlideMotion& motion);

  /** The engine stops at the start of `rest`, the way along the tour to the next point. @pre the ground is under it */
  void stop(const GroundTrack& rest, double altitude);
  /** Glides along the tour to its end. */
  void follow(const GroundTrack& rest);
  /** Flies the glide of the point there. @param tourBend  of the way to the point; side and radius */
  void glide(const PromisedGlide& glide, const Bend& tourBend);

  [[nodiscard]] const std::array<LeastPlace, kMarginKinds>& least() const { return least_; }
  /** Why the flight ended before its end; empty if it did not. */
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] const LeastPlace& now() const { return now_; }
  [[nodiscard]] double steepestBank() const;  ///< rad
  [[nodiscard]] double metres() const { return metres_; }

private:
  void fly(const GroundTrack& track, const PromisedGlide* glide, RollAccount* rolls, const Bend& tourBend);
  void note(MarginKind kind, double left);
  [[nodiscard]] bool isOver(double ground);

  const mission::Mission& mission_;
  const GlideMotion& motion_;
  std::array<LeastPlace, kMarginKinds> least_;
  std::string fault_;
  LeastPlace now_;
  double steepest_ = 0.0;  // tangent
  double metres_ = 0.0;
};

}  // namespace vp::audit
