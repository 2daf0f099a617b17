#pragma once

#include "core/aircraft/course_loss.h"
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

/** What a glide with one radius loses. In calm air every metre straight costs the same, and every metre in a turn; in wind it is the
 *  course that decides, and the two numbers are the least over all courses: what bounds need. */
struct TurnLoss {
  double straight = 0.0;                           ///< height lost per metre straight [-]
  double turn = 0.0;                               ///< height lost per metre in the turn [-]
  const aircraft::CourseLoss* byCourse = nullptr;  ///< in wind; outlives all that has these losses

  /** Height lost straight over a displacement [m]. @param length  of it */
  [[nodiscard]] double straightOver(double east, double north, double length) const {
    return byCourse == nullptr ? straight * length : byCourse->straight(east, north);
  }
};

/** The word of least height loss (lossOf) over the six words.
 *  With loss.turn > loss.straight this prefers longer straight parts to longer turns, so it may differ from the shortest. */
DubinsPath leastLossDubins(const geo::Pose& from, const geo::Pose& to, double radius, TurnLoss loss);

/** Height lost along a path in wind. @pre loss.byCourse is not null and for the path's radius */
double lossInWind(const DubinsPath& path, TurnLoss loss);

/** Height lost along a path. */
inline double lossOf(const DubinsPath& path, TurnLoss loss) {
  return loss.byCourse == nullptr ? loss.straight * path.straight() + loss.turn * path.turned() : lossInWind(path, loss);
}

/** The path as a curve; parts of no length are left out. */
Curve toCurve(const DubinsPath& path);

/** Appends the parts of the path to pieces; parts of no length are left out. */
void appendPieces(const DubinsPath& path, std::vector<Piece>& pieces);

}  // namespace vp::flight
