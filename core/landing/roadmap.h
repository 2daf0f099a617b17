#pragma once

#include "core/flight/dubins.h"
#include "core/landing/approach.h"
#include "core/landing/world.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vp::landing {

/** The answer to a safe-altitude query: how low, and the glide that proves it. */
struct SafeAltitude {
  double altitude = 0.0;  ///< A(q), m MSL
  int node = -1;          ///< what the first leg leads to, in the numbering of the roadmap that answered
  int site = -1;          ///< index into World::sites that the glide ends at
  flight::DubinsPath first;
  double straight = 0.0;  ///< m flown straight before `first`, until the pilot has reacted
};

/** A glide over one radius towards a node, and the altitude it would need if there were no ground: a lower bound. */
struct GlideOption {
  flight::DubinsPath path;
  double altitude = 0.0;
  std::size_t radius = 0;  ///< index into the profile's radii
  int node = -1;
};

/** Working memory of queries, kept by the caller, one per thread, so that queries allocate nothing. */
struct QueryScratch {
  struct Candidate {
    double bound = 0.0;
    int node = -1;
    int option = -1;  ///< index into options; -1 while only the distance is known
    bool operator>(const Candidate& o) const { return bound != o.bound ? bound > o.bound : node != o.node ? node > o.node : option > o.option; }
  };
  std::vector<Candidate> candidates;
  std::vector<GlideOption> options;
  std::vector<int> near;
  std::int64_t queries = 0;  ///< made so far
  std::int64_t legs = 0;     ///< glides tried against the ground so far, where the roadmap counts them
};

/** Landing glides over an area: from where, and how low, a runway is in reach. How the glides were found is the business of
 *  the kinds of roadmap (lattice_roadmap.h, tree_roadmap.h); every answer is proved by a glide whatever found it.
 *  @threads const members are pure; each thread brings its own QueryScratch */
class Roadmap {
public:
  /// A glide of the roadmap for drawing: its first leg as a chord, and the altitude needed at its start [m MSL].
  using DrawGlide = std::function<void(geo::Point from, geo::Point to, double altitude)>;

  virtual ~Roadmap() = default;

  /** Lowest height from which some glide that the roadmap knows arrives, and that glide ([1] Algorithm 2, with the
   *  corrected height condition of DESIGN section 2). An upper bound of the true safe altitude, never below it.
   *  The glide flies World::reactionLength straight on before it turns, and World::reactionLoss is in the height.
   *  @param world  the one that the roadmap was built in
   *  @param hint   node of the answer of a neighbouring query, or -1; saves time, and may lower the answer
   *  @return nothing if no glide exists */
  [[nodiscard]] std::optional<SafeAltitude> query(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint = -1) const;

  /** The same for a pilot who has reacted already: the glide may turn at once, and no height is lost before it. */
  [[nodiscard]] virtual std::optional<SafeAltitude> queryTurning(const World& world, const geo::Pose& from, QueryScratch& scratch,
                                                                 int hint = -1) const = 0;

  /** The glide of an answer as pieces from the queried pose to the site, its approach included. */
  [[nodiscard]] std::vector<flight::Piece> witnessPieces(const SafeAltitude& answer) const;

  /** Number of poses from which a glide is known. */
  [[nodiscard]] virtual std::size_t size() const = 0;

  /** Passes at most `most` glides, evenly chosen, to `draw`. */
  virtual void draw(std::size_t most, const DrawGlide& draw) const = 0;

protected:
  Roadmap() = default;
  /** @param approaches  that its glides end with */
  explicit Roadmap(const std::vector<Approach>& approaches);
  Roadmap(const Roadmap&) = default;
  Roadmap(Roadmap&&) = default;
  Roadmap& operator=(const Roadmap&) = default;
  Roadmap& operator=(Roadmap&&) = default;

  /** Appends the glide of an answer from where it may turn to where the approach begins. */
  virtual void appendGlide(const SafeAltitude& answer, std::vector<flight::Piece>& pieces) const = 0;

private:
  std::vector<std::vector<flight::Piece>> approaches_;  ///< by site, from gate to touchdown
};

/** The pose from which a glide that begins at `from` may turn: World::reactionLength straight ahead. */
geo::Pose afterReaction(const World& world, const geo::Pose& from);

/** Height that the engine's failure at `from` asks for so that the glide is at `altitude` at afterReaction(from): the ground under the straight,
 *  what it loses, and World::reactionLoss [m MSL]. Infinite over unknown ground. */
double beforeReaction(const World& world, const geo::Pose& from, double altitude);

}  // namespace vp::landing
