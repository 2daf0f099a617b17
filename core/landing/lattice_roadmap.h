#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/lattice_glides.h"
#include "core/landing/roadmap.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace vp::landing {

struct LatticeOptions {
  geo::Box area;               ///< where glides are wanted [m]; the part of it on terrain counts
  std::optional<double> step;  ///< side of the lattice [m]; chosen from the area if absent
  bool isPlain = false;        ///< only glides from pose to neighbouring pose, to compare with
};

/** How a lattice roadmap was built: counts that do not depend on the machine. */
struct LatticeStatistics {
  double step = 0.0;             ///< m
  std::int64_t states = 0;       ///< poses of the lattice
  std::int64_t reached = 0;      ///< poses with a glide
  std::int64_t settled = 0;      ///< poses taken from the queue, again ones included
  std::int64_t groundTests = 0;  ///< primitives tested against the ground
  std::int64_t connections = 0;  ///< pairs of poses tried past intermediate ones
  std::int64_t legs = 0;         ///< Dubins paths of these that met the ground
};

/** Roadmap of landing glides by a least-altitude search over a state lattice.
 *
 *  From the landing sites backwards, lowest altitude first: the lowest height from which a primitive clears the ground and
 *  arrives is never below that of its end, so each pose is settled once (Dijkstra; buckets as in Dial 1969). The ground
 *  under a primitive is a list of cells that is the same everywhere, as the step is a whole number of terrain cells; each
 *  cell counts with the loss up to where the glide leaves it. A settled pose then tries to glide straight to where its
 *  successor glides, past intermediate poses, as in Theta* (Nash et al. 2007); so glides have few legs, and lattice
 *  headings count only where the ground forces turns.
 *  @threads const members are pure; each thread brings its own QueryScratch */
class LatticeRoadmap final : public Roadmap {
public:
  LatticeRoadmap() = default;
  LatticeRoadmap(LatticeGlides glides, const std::vector<Approach>& approaches) : Roadmap(approaches), glides_(std::move(glides)) {}

  /** Candidates are what the glides of the eight lattice poses around the queried one lead to, the lowest pose first, until
   *  an answer is as low as their altitudes, interpolated, let expect. If it stays far above, what lies farther ahead on
   *  their glides is tried; if nothing can be reached, poses of a wider surrounding and the sites. The answer then tries to glide past the pose
   *  that it leads to, as the settled poses do. As soon as there is an answer, a dozen glides are enough. */
  [[nodiscard]] std::optional<SafeAltitude> queryTurning(const World& world, const geo::Pose& from, QueryScratch& scratch,
                                                         int hint = -1) const override;
  [[nodiscard]] std::size_t size() const override;
  void draw(std::size_t most, const DrawGlide& draw) const override;

  [[nodiscard]] const LatticeGlides& glides() const { return glides_; }

protected:
  void appendGlide(const SafeAltitude& answer, std::vector<flight::Piece>& pieces) const override;

private:
  double gatherAround(const geo::Pose& from, QueryScratch& scratch) const;
  void gatherWide(const geo::Pose& from, std::vector<int>& nodes) const;
  void tryNode(const World& world, const geo::Pose& from, flight::Direction direction, int node, QueryScratch& scratch, SafeAltitude& best) const;
  void tryNearest(const World& world, const geo::Pose& from, flight::Direction direction, std::size_t most, std::int64_t mostGlides,
                  QueryScratch& scratch, SafeAltitude& best) const;
  void tryPastAnswer(const World& world, const geo::Pose& from, flight::Direction direction, std::int64_t mostGlides, QueryScratch& scratch,
                     SafeAltitude& best) const;

  LatticeGlides glides_;
};

/** Builds the lattice roadmap over all sites at once. Deterministic.
 *  @errors NoLandingSite (no site on known ground), OutOfRange (empty area), Cancelled   @threads pure
 *  @cost some microseconds per state */
Result<LatticeRoadmap> buildLatticeRoadmap(const World& world, const LatticeOptions& options, const Job& job,
                                           LatticeStatistics* statistics = nullptr);

/** Side of the lattice for an area [m]: 60 m on 5 x 5 km, growing with the power 0.33 of the area (294 m on 46 x 67 km). */
double defaultLatticeStep(const geo::Box& area);

}  // namespace vp::landing
