#pragma once

#include "core/flight/dubins.h"
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
   *  @param world  the one that the roadmap was built in
   *  @param hint   node of the answer of a neighbouring query, or -1; saves time, and may lower the answer
   *  @return nothing if no glide exists */
  [[nodiscard]] virtual std::optional<SafeAltitude> query(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint = -1) const = 0;

  /** The glide of an answer as pieces from the queried pose to the site. */
  [[nodiscard]] virtual std::vector<flight::Piece> witnessPieces(const SafeAltitude& answer) const = 0;

  /** Number of poses from which a glide is known. */
  [[nodiscard]] virtual std::size_t size() const = 0;

  /** Passes at most `most` glides, evenly chosen, to `draw`. */
  virtual void draw(std::size_t most, const DrawGlide& draw) const = 0;

protected:
  Roadmap() = default;
  Roadmap(const Roadmap&) = default;
  Roadmap(Roadmap&&) = default;
  Roadmap& operator=(const Roadmap&) = default;
  Roadmap& operator=(Roadmap&&) = default;
};

}  // namespace vp::landing
