#pragma once

#include "core/base/result.h"
#include "core/flight/dubins.h"

#include <array>
#include <cstddef>
#include <optional>

namespace vp::flight {

/** A Dubins path in an air mass that moves with a steady wind: over the ground its turns are trochoids.
 *  The start is a place over the ground with the heading through the air [rad, from East, counter-clockwise];
 *  airHeadingFor() makes that of a course. */
struct WindPath {
  geo::Pose start;
  double radius = 0.0;  ///< through the air [m]
  Word word = Word::LSL;
  std::array<double, 3> lengths{};  ///< of the parts along the air path [m]; the middle part of RLR and LRL may be of any length
  air::Wind wind;
  double airspeed = 0.0;  ///< [m/s]

  /** Along the air path [m]. */
  [[nodiscard]] double length() const { return lengths[0] + lengths[1] + lengths[2]; }
  /** [s] */
  [[nodiscard]] double duration() const { return length() / airspeed; }
  /** Metres of air path flown in turns. */
  [[nodiscard]] double turned() const { return length() - straight(); }
  /** Metres of air path flown straight. */
  [[nodiscard]] double straight() const { return word == Word::RLR || word == Word::LRL ? 0.0 : lengths[1]; }
};

/** Few paths, kept without allocation. */
class WindPaths {
public:
  static constexpr std::size_t kCapacity = 18;

  void push(const WindPath& path);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const WindPath& operator[](std::size_t i) const { return paths_[i]; }
  [[nodiscard]] const WindPath* begin() const { return paths_.data(); }
  [[nodiscard]] const WindPath* end() const { return paths_.data() + size_; }

private:
  std::array<WindPath, kCapacity> paths_{};
  std::size_t size_ = 0;
};

/** Whether the functions below accept this wind: all finite, and slower than the airspeed (by a millionth at least), so that
 *  every course can be held.
 *  @param airspeed  [m/s]   @param wind  towards [m/s] */
bool canConnect(double airspeed, air::Wind wind);

/** All ways to fly one word between two poses, each turn at most a full circle. There may be none, and several: a longer way
 *  lets the goal drift further. Touching solutions (two that have become one) may be listed twice.
 *  @param from, to  places over the ground, air headings   @param radius  [m]
 *  @pre radius > 0, canConnect(airspeed, wind), |to - from| <= 1e9 radius
 *  @accuracy end within 1e-9 radius and 1e-9 rad up to 50 radii and winds of 0.9 airspeed (tst_wind_dubins); rounding
 *            grows with 1 / (1 - wind / airspeed)
 *  @threads pure   @cost no allocation
 *  @source equations and proof that none is missed: WHY.md; McGee, Hedrick 2007, J. Guidance 30 (goal carried by the air);
 *          Techy, Woolsey 2009, J. Guidance 32 (LSL and RSR in closed form) */
WindPaths windWord(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind, Word word);

/** The quickest of all ways by all six words. In calm air that of shortestDubins(). Parameters as windWord().
 *  @errors OutOfRange - not canConnect(), radius not positive, something not finite, or places more than 1e9 radii apart;
 *          NoSolution - no word with turns of at most a full circle (not proved impossible, WHY.md; never met) */
Result<WindPath> shortestTime(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind);

/** The way of least height loss of all ways by all six words; `loss` is per metre of air path. In calm air no dearer than
 *  leastLossDubins().  @pre loss.turn >= loss.straight >= 0  @errors as shortestTime() */
Result<WindPath> leastLoss(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind, TurnLoss loss);

/** Height lost along a path through still air that moves with the wind. */
inline double lossOf(const WindPath& path, TurnLoss loss) {
  return loss.straight * path.straight() + loss.turn * path.turned();
}

/** The path as a curve that carries its wind; parts of no length are left out. Its end over the ground: endOf(curve, airspeed). */
Curve toCurve(const WindPath& path);

/** Air heading [rad, in [0, 2 pi)] that makes good a course over the ground; none if the wind does not let it be held:
 *  the wind across is stronger than the airspeed, or the aircraft would not move forward. Wind triangle. */
std::optional<double> airHeadingFor(double course, double airspeed, air::Wind wind);

/** Course over the ground [rad, in [0, 2 pi)] made good with an air heading; none if the aircraft does not move. */
std::optional<double> courseFor(double airHeading, double airspeed, air::Wind wind);

}  // namespace vp::flight
