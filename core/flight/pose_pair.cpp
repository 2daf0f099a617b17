#include "core/flight/pose_pair.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/turn_angle.h"

#include <algorithm>
#include <array>

namespace vp::flight {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;

/// Centres closer than this have no tangent direction that could be computed [m]: the two circles are one.
constexpr double kSameCircle = 1e-7;

/// std::remainder(angle, 2 pi), without its price where one turn is enough: there the difference has no rounding.
double shortestTurn(double angle) {
  if (std::abs(angle) <= Angle::kPi) {
    return angle;
  }
  return std::abs(angle) < 3.0 * Angle::kPi ? angle - std::copysign(kTwoPi, angle) : std::remainder(angle, kTwoPi);
}

/// Lower bound of the length of a CCC word: its middle turn exceeds half a circle.
double leastOfThreeCircles(double radius, double distance) {
  return std::max(Angle::kPi * radius, distance);
}

/// The same for outer circles whose centres are `apart`, less than 4 radii. The three centres make a triangle of sides 2 r, 2 r and `apart`,
/// so the middle turn is pi + 2 acos(apart / 4 r); the outer turns go the other way, and all make up the change of heading.
/// @param turn  change of heading to the side of the middle turn
double leastOfThreeCircles(double radius, double apart, double turn) {
  const double middle = Angle::kPi + 2.0 * std::acos(0.25 * apart / radius);
  return radius * (middle + turnAngle(middle - turn));
}

}  // namespace

PosePair::PosePair(const geo::Pose& from, Direction fromDirection, const geo::Pose& to, Direction toDirection)
    : from_(from),
      to_(to),
      fromDirection_(fromDirection),
      toDirection_(toDirection),
      dx_(to.x - from.x),
      dy_(to.y - from.y),
      distance_(std::sqrt(dx_ * dx_ + dy_ * dy_)),
      turn_(shortestTurn(to.heading - from.heading)),  // headings may have been wound up by the caller
      turnLeft_(turnAngle(turn_)),
      turnRight_(turnAngle(-turn_)) {}

PosePair::Csc PosePair::csc(Word word, double startSide, double endSide, double radius) const {
  Csc csc;
  csc.word = word;
  csc.startSide = startSide;
  csc.endSide = endSide;
  // a circle's centre lies a radius to the side: left of a direction (e, n) is (-n, e)
  csc.east = dx_ - radius * (endSide * toDirection_.north - startSide * fromDirection_.north);
  csc.north = dy_ + radius * (endSide * toDirection_.east - startSide * fromDirection_.east);
  const double square = csc.east * csc.east + csc.north * csc.north;
  if (startSide == endSide) {
    csc.straight = std::sqrt(square);
    csc.turnedAtLeast = startSide > 0.0 ? turnLeft_ : turnRight_;
  } else {
    const double tangent = square - 4.0 * radius * radius;
    csc.straight = tangent < 0.0 ? -1.0 : std::sqrt(tangent);
    csc.turnedAtLeast = std::abs(turn_);
  }
  return csc;
}

DubinsPath PosePair::solve(const Csc& csc, double radius) const {
  if (csc.startSide == csc.endSide && csc.straight < kSameCircle) {
    return {from_, radius, csc.word, {csc.turnedAtLeast * radius, csc.straight, 0.0}};
  }
  const auto [east, north] = csc.along(radius);
  const double angle =
      std::atan2(fromDirection_.east * north - fromDirection_.north * east, fromDirection_.east * east + fromDirection_.north * north);
  const double first = turnAngle(csc.startSide * angle);
  const double last = turnAngle(csc.endSide * (turn_ - csc.startSide * first));
  return {from_, radius, csc.word, {first * radius, csc.straight, last * radius}};
}

/// Lower bound of what a word costs, infinite if there is none.
double PosePair::boundOf(const Csc& csc, double radius, TurnLoss loss) {
  if (csc.straight < 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  const double turned = loss.turn * radius * csc.turnedAtLeast;
  if (loss.byCourse == nullptr || csc.straight < kSameCircle) {
    return loss.straight * csc.straight + turned;
  }
  const Direction along = csc.along(radius);
  const double scale = 1.0 / std::sqrt(along.east * along.east + along.north * along.north);
  return loss.byCourse->straightRate(along.east * scale, along.north * scale) * csc.straight + turned;
}

DubinsPath PosePair::leastLoss(double radius, TurnLoss loss) const {
  VP_EXPECT(radius > 0.0);
  const std::array<Csc, 4> words{csc(Word::LSL, 1.0, 1.0, radius), csc(Word::RSR, -1.0, -1.0, radius), csc(Word::LSR, 1.0, -1.0, radius),
                                 csc(Word::RSL, -1.0, 1.0, radius)};
  std::array<double, 4> bounds{};
  std::size_t first = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    bounds[i] = boundOf(words[i], radius, loss);
    first = bounds[i] < bounds[first] ? i : first;
  }
  DubinsPath best = solve(words[first], radius);  // LSL and RSR always exist
  double least = lossOf(best, loss);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != first && bounds[i] < least) {
      const DubinsPath path = solve(words[i], radius);
      if (const double lost = lossOf(path, loss); lost < least) {
        best = path;
        least = lost;
      }
    }
  }
  // Turning never costs less than flying straight, so a CCC word, all turns, wins only where it is the shortest,
  // which it never is at four radii or more (tst_dubins: words_underDistance_needNoThreeCircles).
  if (distance_ < 4.0 * radius && loss.turn * leastOfThreeCircles(radius, distance_) < least) {
    for (const Word word : {Word::RLR, Word::LRL}) {
      const double apart = words[word == Word::LRL ? 0 : 1].straight;
      const double turn = word == Word::LRL ? turnRight_ : turnLeft_;
      if (apart >= 4.0 * radius || loss.turn * leastOfThreeCircles(radius, apart, turn) >= least) {
        continue;
      }
      if (const std::optional<DubinsPath> path = dubinsWord(from_, to_, radius, word); path && lossOf(*path, loss) < least) {
        best = *path;
        least = lossOf(best, loss);
      }
    }
  }
  return best;
}

double PosePair::lossBound(double radius, TurnLoss loss) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Csc& word :
       {csc(Word::LSL, 1.0, 1.0, radius), csc(Word::RSR, -1.0, -1.0, radius), csc(Word::LSR, 1.0, -1.0, radius), csc(Word::RSL, -1.0, 1.0, radius)}) {
    least = std::min(least, boundOf(word, radius, loss));
  }
  if (distance_ < 4.0 * radius) {
    least = std::min(least, loss.turn * leastOfThreeCircles(radius, distance_));
  }
  return least;
}

}  // namespace vp::flight
