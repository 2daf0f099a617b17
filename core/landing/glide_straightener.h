#pragma once

#include "core/flight/pose_pair.h"
#include "core/landing/glide_needs.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vp::landing {

/** Gives glides fewer turns: what a roadmap finds is low, but not simple, for where the ground holds a glide up it may weave below at no cost.
 *
 *  From the first pose of the way on, the farthest joint that one Dubins glide reaches within the height at hand takes the place of all before it,
 *  if that rolls less (string pulling over the joints; Thorpe 1984, Path relaxation, does so with lines). What a glide so saves in height it has at
 *  hand further on. Reaction, approach, site and the course at the end stay.
 *  @threads const members are pure */
class GlideStraightener {
public:
  /** A glide as pieces, and the safe altitude that it proves [m MSL]. */
  struct Proof {
    std::vector<flight::Piece> pieces;
    double safeAltitude = 0.0;
  };

  /** @param world  outlives this   @param onlySite  as of GlideNeeds */
  explicit GlideStraightener(const World& world, std::optional<int> onlySite = {}) : world_(world), needs_(world, onlySite) {}

  /** The proof that goes into a plan: straightened within its safe altitude; where rolling then still costs more than the clearance, within the
   *  height that the tour has; and what it asks for after all, rolling counted.
   *  @param tour    the piece that the tour comes to the pose on
   *  @param proof   a glide of the roadmap to `site`
   *  @param atHand  m MSL: lowest altitude at which a failure on the tour leaves the aircraft at the pose; what the proof needs may still be more */
  [[nodiscard]] Proof improved(const geo::Pose& from, const flight::Piece& tour, Proof proof, int site, double atHand) const;

  /** A glide that needs no more than `height` and rolls less, or the one given.
   *  @param from    pose over ground at its beginning
   *  @param tour    the piece that the tour comes there on
   *  @param height  that it may need, m MSL, E included */
  [[nodiscard]] GlideParts straightened(const geo::Pose& from, const flight::Piece& tour, double height, const GlideParts& glide) const;

private:
  /// The way with the poses between its pieces.
  struct Joints {
    std::vector<flight::Piece> pieces;
    std::vector<geo::Pose> poses;  ///< one more than pieces
    std::vector<flight::Direction> directions;
    std::vector<double> heights;  ///< needed there, m MSL
    std::vector<double> rolled;   ///< by piece: what rolling costs between pieces up to its beginning, m
    flight::Piece after;          ///< flown behind the way
    double atHand = 0.0;          ///< height at the first, m MSL
  };
  /// A glide from one joint to another.
  struct Option {
    flight::DubinsPath path;
    std::size_t radius = 0;  ///< index into GlideModel::glideRadii()
    double rolling = 0.0;    ///< m
  };
  struct Pull {
    std::size_t to = 0;  ///< joint
    flight::DubinsPath path;
    double height = 0.0;  ///< left there, m MSL
  };

  [[nodiscard]] double rollingOf(const GlideParts& glide, const flight::Piece& tour) const;
  [[nodiscard]] std::optional<Joints> jointsOf(const geo::Pose& from, double height, const GlideParts& glide) const;
  [[nodiscard]] std::vector<flight::Piece> pulled(const Joints& joints, const flight::Piece& before) const;
  [[nodiscard]] std::optional<Pull> farthest(const Joints& joints, std::size_t from, const flight::Piece& before, double height) const;
  [[nodiscard]] std::vector<Option> optionsBetween(const Joints& joints, std::size_t from, std::size_t to, const flight::Piece& before,
                                                   const flight::Piece& after, double limit) const;

  const World& world_;
  GlideNeeds needs_;
};

}  // namespace vp::landing
