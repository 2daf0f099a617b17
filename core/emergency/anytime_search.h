#pragma once

#include "core/emergency/glide_flight.h"
#include "core/emergency/informed_samples.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_outcome.h"
#include "core/flight/pose_pair.h"
#include "core/landing/spatial_index.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace vp::emergency {

/** How an AnytimeSearch went. */
struct AnytimeCounts {
  std::int64_t direct = 0;    ///< glides from the aircraft straight to a runway that were tried
  std::int64_t samples = 0;   ///< drawn
  std::int64_t poses = 0;     ///< in the tree
  std::int64_t glides = 0;    ///< tried against the ground
  std::int64_t rewired = 0;   ///< poses that got a better parent
  std::int64_t improved = 0;  ///< better answers, the first included
};

/** The tree of one request of AnytimePlanner, which says what it does. One thread. */
class AnytimeSearch {
public:
  /** @pre goals has one in range; both outlive this */
  AnytimeSearch(const LandingRequest& request, const LandingGoals& goals);

  /** Direct glides to all runways in range, the most promising first, until the countdown is over. */
  void tryDirect(const Countdown& countdown);
  /** One sample more. */
  void grow();
  /** Nothing better by more than kWorthwhile exists. */
  [[nodiscard]] bool isFinished() const;

  /** The best path so far, if there is one. */
  [[nodiscard]] const std::optional<mission::LandingPath>& best() const { return bestPath_; }
  [[nodiscard]] const AnytimeCounts& counts() const { return counts_; }

  static constexpr double kWorthwhile = 0.5;  ///< m of height

private:
  /// A glide from a node: the curve, the altitude at its end, and the risk of all up to there.
  struct Glide {
    flight::DubinsPath path;
    std::size_t radius = 0;
    double altitude = GlideFlight::kTouches;
    double risk = 0.0;
    [[nodiscard]] bool exists() const { return altitude > GlideFlight::kTouches; }
  };
  struct Node {
    geo::Pose pose;
    double altitude = 0.0;
    double risk = 0.0;
    double least = 0.0;  ///< m MSL: from lower no runway can be reached from this pose
    int parent = -1;
    Glide glide;  ///< from the parent
    std::vector<int> children;
  };
  struct Landing {
    int node = -1;
    std::size_t goal = 0;
    Glide glide;
    double inHand = -std::numeric_limits<double>::infinity();  ///< at the approach, what its manoeuvres cost taken off
    double risk = std::numeric_limits<double>::infinity();
  };
  struct Candidate {
    double altitude = 0.0;  ///< bound of the altitude at the end of the glide
    int node = -1;
  };

  [[nodiscard]] geo::Pose sample();
  [[nodiscard]] double wantedInHand() const;
  [[nodiscard]] bool mayHelp(double altitude, double risk, double least) const;
  [[nodiscard]] bool isBetter(double risk, double altitude, const Glide& than) const;
  Glide glideFrom(int node, const geo::Pose& to, const Glide& atLeast);
  [[nodiscard]] double riskAlong(const flight::DubinsPath& path, double altitude) const;
  void gatherParents(const geo::Pose& pose);
  bool chooseParent(const geo::Pose& pose, double least, Node& node);
  void tryAncestors(const geo::Pose& pose, Node& node);
  void rewire(int added);
  void passOn(int node);
  void tryGoals(int node);
  void tryGoal(int node, std::size_t goal);
  void renewLanding();
  bool accept(Landing landing);
  [[nodiscard]] bool isBetterLanding(const Landing& landing) const;
  [[nodiscard]] std::vector<Glide> glidesOf(const Landing& landing) const;
  [[nodiscard]] std::optional<mission::LandingPath> pathOf(const std::vector<Glide>& glides, Landing& landing) const;
  [[nodiscard]] std::vector<Glide> without(const std::vector<Glide>& glides, std::size_t number) const;
  [[nodiscard]] std::vector<int> chainOf(int node) const;

  const LandingRequest& request_;
  const landing::World& world_;
  const LandingGoals& goals_;
  GlideFlight flight_;
  InformedSamples samples_;
  landing::SpatialIndex index_;
  std::vector<Node> nodes_;
  Landing best_;
  std::optional<mission::LandingPath> bestPath_;
  AnytimeCounts counts_;
  std::vector<int> near_;
  std::vector<Candidate> candidates_;
};

}  // namespace vp::emergency
