#pragma once

#include "core/flight/curve.h"

#include <array>
#include <limits>
#include <optional>

namespace vp::flight {

/** The six words of Dubins: three parts, each a turn (L, R) or straight (S). */
enum class Word : unsigned char { LSL, RSR, LSR, RSL, RLR, LRL };

inline constexpr std::array<Word, 6> kWords{Word::LSL, Word::RSR, Word::LSR, Word::RSL, Word::RLR, Word::LRL};

/** Turns of the three parts of a word. */
std::array<Turn, 3> turnsOf(Word word);

/** A Dubins path between two poses with one turn radius. Lengths of the three parts in metres; the middle part of
 *  RLR and LRL is longer than half a circle. */
struct DubinsPath {
  geo::Pose start;
  double radius = 0.0;
  Word word = Word::LSL;
  std::array<double, 3> lengths{};

  [[nodiscard]] double length() const { return lengths[0] + lengths[1] + lengths[2]; }
  /** Metres flown in turns. */
  [[nodiscard]] double turned() const;
  /** Metres flown straight. */
  [[nodiscard]] double straight() const;
  [[nodiscard]] Piece piece(std::size_t part) const;
};

/** One word between two poses, if that word connects them. @source Shkel, Lumelsky 2001, Robotics and Autonomous
 *  Systems 34, section 3 (lengths of the words); Dubins 1957. @pre radius > 0  @accuracy end pose < 1e-9 radius */
std::optional<DubinsPath> dubinsWord(const geo::Pose& from, const geo::Pose& to, double radius, Word word);

/** The shortest of the six words. RLR and LRL are skipped where they cannot win: centres at least 4 radii apart have
 *  no such word, and poses at least 4 radii apart always have a shorter CSC word. Always exists. */
DubinsPath shortestDubins(const geo::Pose& from, const geo::Pose& to, double radius);

/** Cost of a glide that flies `turned` metres in turns and `straight` metres straight, by loss per metre of each. */
struct TurnLoss {
  double straight = 0.0;  ///< height lost per metre straight [-]
  double turn = 0.0;      ///< height lost per metre in the turn [-]
};

/** The word of least height loss: minimises loss.straight * straight + loss.turn * turned over the six words.
 *  With loss.turn > loss.straight this prefers longer straight parts to longer turns, so it may differ from the shortest. */
DubinsPath leastLossDubins(const geo::Pose& from, const geo::Pose& to, double radius, TurnLoss loss);

/** Height lost along a path. */
inline double lossOf(const DubinsPath& path, TurnLoss loss) {
  return loss.straight * path.straight() + loss.turn * path.turned();
}

/** The path as a curve; parts of no length are left out. */
Curve toCurve(const DubinsPath& path);

/** Appends the parts of the path to pieces; parts of no length are left out. */
void appendPieces(const DubinsPath& path, std::vector<Piece>& pieces);

}  // namespace vp::flight
