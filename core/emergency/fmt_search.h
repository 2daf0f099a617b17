#pragma once

#include "core/emergency/fmt_star.h"
#include "core/emergency/glide_flight.h"
#include "core/emergency/glide_smoothing.h"
#include "core/emergency/informed_samples.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_request.h"
#include "core/emergency/linear_octree.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vp::emergency {

/** How FMT* looks for a landing. */
struct FmtOptions {
  bool usesOctree = true;    ///< two samplings and an octree as in [5]; false: one sampling, legs tested by steps
  std::size_t first = 1500;  ///< samples wherever a landing may lead; twice as many in each further round
  std::size_t second = 300;  ///< samples near the best glide, with the octree
  int further = 3;           ///< samplings of that kind, each half as wide as the one before: [5] has one
  int rounds = 5;            ///< at most; the next begins only while no glide to a runway has been found
  int tries = 200;           ///< moves of a glide's poses at the end of a round
  /// Of free space over the request's ground, enlarged, if there is one already; it is not asked what it is of. Rounds without enlarged ground
  /// make their own.
  std::shared_ptr<const LinearOctree> octree;
};

/** How an FmtSearch went. */
struct FmtSearchCounts {
  std::int64_t samples = 0;
  std::int64_t visited = 0;   ///< samples that trees reached
  std::int64_t tested = 0;    ///< legs tested against the ground
  std::int64_t smoothed = 0;  ///< ways made flyable, the impossible ones included
  std::int64_t leaves = 0;    ///< of the octrees
  std::int64_t improved = 0;  ///< better glides, the first included
};

/** The search of one request of FmtPlanner, which says what it does. One thread. */
class FmtSearch {
public:
  /** @pre goals has one in range; all outlive this */
  FmtSearch(const LandingRequest& request, const LandingGoals& goals, const FmtOptions& options, const Countdown& countdown);

  /** A single curve to each runway in range, the most promising first. */
  void tryDirect();
  /** One round of samplings. @param round  from 0: more samples, and octrees without enlarged ground every other time */
  void run(int round);
  /** Nothing better by more than kWorthwhile exists. */
  [[nodiscard]] bool isFinished() const;

  [[nodiscard]] const std::optional<mission::LandingPath>& best() const { return bestPath_; }
  [[nodiscard]] const FmtSearchCounts& counts() const { return counts_; }

  static constexpr double kWorthwhile = 0.5;  ///< m of height

private:
  [[nodiscard]] double wanted() const { return bestPath_ ? inHand_ : 0.0; }
  [[nodiscard]] std::shared_ptr<const LinearOctree> makeOctree(bool enlarged);
  /// @param measure  becomes the area that they lie in, m^2
  [[nodiscard]] std::vector<geo::Point> firstSamples(std::size_t count, double& measure);
  [[nodiscard]] std::vector<geo::Point> samplesNearBest(double reach, std::size_t count);
  void grow(const std::vector<geo::Point>& samples, double radius, const LinearOctree* octree);
  void refine(double reach, const LinearOctree* octree);
  void consider(std::size_t goal, const std::vector<geo::Point>& points);
  bool accept(std::size_t goal, const SmoothGlide& glide);

  const LandingRequest& request_;
  const landing::World& world_;
  const LandingGoals& goals_;
  const FmtOptions& options_;
  const Countdown& countdown_;
  GlideFlight flight_;
  GlideSmoothing smoothing_;
  InformedSamples samples_;
  std::optional<mission::LandingPath> bestPath_;
  SmoothGlide best_;
  std::size_t bestGoal_ = 0;
  double inHand_ = 0.0;
  FmtSearchCounts counts_;
};

}  // namespace vp::emergency
