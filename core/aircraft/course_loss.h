#pragma once

#include "core/air/wind_layer.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace vp::aircraft {

/** The polar as the loss over ground needs it: sin(gamma) = parasite + induced * n^2 at load factor n. */
struct GlidePolar {
  double airspeed = 0.0;  ///< true airspeed of the glide, m/s
  double parasite = 0.0;  ///< q S C_D0 / W [-]
  double induced = 0.0;   ///< L W / (q S) [-]
  double shear = 0.0;     ///< airspeed times the greatest change of the wind with height / g [-]: sinking costs 1 / (1 - shear) as much
};

/** Height that a glide along a given ground track loses at most, whichever wind of a set blows, by the course of the track.
 *
 *  The aircraft keeps the track: it crabs into the wind, and in a turn over ground of radius R it changes its bank with its
 *  ground speed. With t and c the parts of the wind along and across the course, and the crab angle eta = asin(c / v),
 *    ground speed   u = v cos(eta) + t
 *    bank           tan(phi) = u^2 / (g R cos(eta))          (WHY.md, "Turns over ground")
 *    loss           v sin(gamma) / (sqrt(v^2 cos^2(gamma) - c^2) + t)  per metre of track, n = 1 / cos(phi)
 *  Where the wind changes with height, sin(gamma) is that over 1 - shear (WHY.md, "Shear").
 *  The wind need not be steady: any that stays within the set, however it changes, is covered (accelerations by gusts are not).
 *  Loss in turns is bounded per half degree of course, so a turn's loss is an upper bound, dearer by 0.1 % at most.
 *  @threads const members are pure
 *  @source mechanics of a point mass; every bound is proved in WHY.md */
class CourseLoss {
public:
  /** @param winds   the sectors of all layers; several stand for everything between them too
   *  @param radius  of turns over ground, m
   *  @param within  losses in turns of this radius that these may not fall below: bounds of parts of these winds can come out a little higher
   *  @pre winds not empty, radius > 0 */
  CourseLoss(const GlidePolar& polar, std::vector<air::WindSector> winds, double radius, const std::vector<const CourseLoss*>& within = {});

  /** Height lost per metre on a straight course given as a unit vector; infinite where the wind holds the aircraft up. */
  [[nodiscard]] double straightRate(double east, double north) const;

  /** Height lost over a straight displacement [m]. It is a norm that is not symmetric: no other way between two points loses less. */
  [[nodiscard]] double straight(double east, double north) const {
    const double length = std::sqrt(east * east + north * north);
    return length > 0.0 ? length * straightRate(east / length, north / length) : 0.0;
  }

  /** Height lost in a turn [m]; infinite where a course of it, or one before it in the table, leaves no way against the wind.
   *  @param from    course at its beginning, rad
   *  @param turned  rad, positive to the left */
  [[nodiscard]] double turn(double from, double turned) const {
    const double loss = turned >= 0.0 ? cumulative(from + turned) - cumulative(from) : cumulative(from) - cumulative(from + turned);
    if (loss > 0.0) {
      return loss;
    }
    return loss <= 0.0 ? 0.0 : std::numeric_limits<double>::infinity();  // rounding; no number where some course holds the aircraft up
  }

  /** Greatest loss per metre anywhere in that turn. */
  [[nodiscard]] double mostInTurn(double from, double turned) const;

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double leastStraight() const { return leastStraight_; }  ///< per metre, over all courses
  [[nodiscard]] double mostStraight() const { return mostStraight_; }
  [[nodiscard]] double leastTurn() const { return leastTurn_; }  ///< per metre, over all courses
  [[nodiscard]] double mostTurn() const { return mostTurn_; }    ///< infinite: no such turn on some course
  /** Least that a metre in a turn costs beyond a straight metre on the same course, >= 0. */
  [[nodiscard]] double leastExcess() const { return leastExcess_; }

private:
  static constexpr int kCells = 720;

  [[nodiscard]] double cumulative(double course) const {
    const double cells = course * cellsPerRadian_;
    const double whole = std::floor(cells);
    const double turns = std::floor(whole / kCells);
    const auto cell = static_cast<std::size_t>(whole - turns * kCells);
    return turns * total_ + cumulative_[cell] + (cells - whole) * perCell_[cell];
  }
  [[nodiscard]] double worstRate(std::span<const air::WindSector> winds, double course, double halfRange, bool inTurn) const;
  [[nodiscard]] double sinGammaAt(double bank) const;
  [[nodiscard]] double worstTurn(const std::vector<air::WindSector>& parts, double course, double halfRange) const;
  void findCorners();
  void tabulate(const std::vector<const CourseLoss*>& within);

  /// A wind at the edge of a sector, m/s.
  struct Corner {
    double east = 0.0;
    double north = 0.0;
  };
  /// What a sector holds against some courses: the middle of its directions, how far they reach, and its greatest speed.
  struct Opposed {
    double east = 1.0;
    double north = 0.0;
    double cosSpread = 1.0;
    double speed = 0.0;
  };

  GlidePolar polar_;
  std::vector<air::WindSector> winds_;
  double radius_;
  double cellsPerRadian_;
  std::vector<Corner> corners_;
  std::vector<Opposed> opposed_;
  double shearLoad_ = 0.0;          ///< tangent of bank per sin(gamma) that shear asks for at most
  double straightSink_ = 0.0;       ///< m/s
  double straightSquare_ = 0.0;     ///< of the horizontal airspeed, m^2/s^2
  std::vector<double> rate_;        ///< by cell of course: greatest loss per metre in a turn
  std::vector<double> perCell_;     ///< loss of turning through the cell, m
  std::vector<double> cumulative_;  ///< loss of turning left from East to the cell's beginning, m
  double total_ = 0.0;              ///< of a full circle, m
  double leastStraight_ = 0.0;
  double mostStraight_ = 0.0;
  double leastTurn_ = 0.0;
  double mostTurn_ = 0.0;
  double leastExcess_ = 0.0;
};

}  // namespace vp::aircraft
