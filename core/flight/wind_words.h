#pragma once

#include "core/flight/dubins.h"

#include <array>
#include <cstddef>
#include <limits>

namespace vp::flight {

/** Two poses in the normal form of the words below: lengths in turn radii, speeds in airspeeds, the start at the origin with
 *  heading 0, and the first turn to the left. Words that begin to the right are those of the mirrored frame. */
struct WindFrame {
  double x = 0.0;  ///< end, over the ground
  double y = 0.0;
  double turn = 0.0;  ///< change of the air heading [rad], in [-pi, pi]
  double sinTurn = 0.0;
  double cosTurn = 1.0;
  double windX = 0.0;  ///< towards
  double windY = 0.0;

  /** @pre radius > 0, the wind is slower than the airspeed. Winds below 1e-14 airspeeds count as calm. */
  WindFrame(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind);
  [[nodiscard]] WindFrame mirrored() const;
  [[nodiscard]] double windSquare() const { return windX * windX + windY * windY; }
};

/** What the words are looked for with, and what they find: all of them, or only the one of least loss.
 *  Searching for the least skips what a lower bound shows to be no better than what is already found. */
class WindSearch {
public:
  /** A word's parts in radians and, for a straight part, in radii. */
  struct Found {
    Word word = Word::LSL;
    std::array<double, 3> parts{};
  };

  /** Keeps all. */
  WindSearch() = default;
  /** Keeps the least loss only. @pre loss.turn >= loss.straight >= 0 */
  explicit WindSearch(TurnLoss loss) : loss_(loss), keepsAll_(false) {}

  /** Searches all branches of one word. `frame` begins with a left turn; for words that begin to the right it is the mirrored one. */
  void search(Word word, const WindFrame& frame);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Found& operator[](std::size_t i) const { return found_[i]; }

  /** Two words of three circles: three branches, each of three parts with up to two roots; no word has more. */
  static constexpr std::size_t kCapacity = 18;

private:
  void sameSide(const WindFrame& frame);
  void otherSide(const WindFrame& frame);
  void threeCircles(const WindFrame& frame);
  struct Tangent;
  void tangentBranches(const Tangent& shape, double low, double high);
  struct Middle;
  void middleBranch(const Middle& middle);
  /// @param sign  +1 where the mismatch is convex between the two angles, -1 where it is concave
  void middlePart(const Middle& middle, double low, double high, double sign);
  void middleFound(const Middle& middle, double angle);

  /// Takes a word whose outer turns make up `total`, the first being `first` plus any number of circles, if both can be in [0, 2 pi].
  /// @param lever  how far the end moves by one radian of the first turn: decides what is rounding
  void take(double first, double total, double middle, double lever);
  /// Length up to which a word that turns by at least `turned` may still win [radii].
  [[nodiscard]] double longest(double turned) const;
  [[nodiscard]] bool isStraight() const { return word_ != Word::RLR && word_ != Word::LRL; }

  TurnLoss loss_{1.0, 1.0};
  bool keepsAll_ = true;
  double least_ = std::numeric_limits<double>::infinity();
  Word word_ = Word::LSL;
  std::size_t size_ = 0;
  std::array<Found, kCapacity> found_{};
};

}  // namespace vp::flight
