#include "core/flight/dubins.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/pose_pair.h"
#include "core/flight/turn_angle.h"

#include <cmath>

namespace vp::flight {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;

/** A pair of poses in the normal form of Shkel and Lumelsky: unit radius, goal on the x axis at distance d. */
struct Normal {
  double d = 0.0;
  double alpha = 0.0;
  double beta = 0.0;
  double sinA = 0.0;
  double cosA = 0.0;
  double sinB = 0.0;
  double cosB = 0.0;
  double cosAB = 0.0;
};

Normal unscaled(const geo::Pose& from, const geo::Pose& to) {
  Normal n;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  n.d = std::sqrt(dx * dx + dy * dy);
  const double direction = n.d > 0.0 ? std::atan2(dy, dx) : 0.0;
  n.alpha = std::remainder(from.heading - direction, kTwoPi);  // headings may have been wound up by the caller
  n.beta = std::remainder(to.heading - direction, kTwoPi);
  n.sinA = std::sin(n.alpha);
  n.cosA = std::cos(n.alpha);
  n.sinB = std::sin(n.beta);
  n.cosB = std::cos(n.beta);
  n.cosAB = n.cosA * n.cosB + n.sinA * n.sinB;
  return n;
}

Normal scaled(Normal normal, double radius) {
  normal.d /= radius;
  return normal;
}

/// Parts of a word in radians and, for the straight part, in radii.
struct Parts {
  double t = 0.0;
  double p = 0.0;
  double q = 0.0;
};

std::optional<Parts> lsl(const Normal& n) {
  const double square = 2.0 + n.d * n.d - 2.0 * n.cosAB + 2.0 * n.d * (n.sinA - n.sinB);
  const double direction = std::atan2(n.cosB - n.cosA, n.d + n.sinA - n.sinB);
  return Parts{turnAngle(direction - n.alpha), std::sqrt(std::max(0.0, square)), turnAngle(n.beta - direction)};
}

std::optional<Parts> rsr(const Normal& n) {
  const double square = 2.0 + n.d * n.d - 2.0 * n.cosAB + 2.0 * n.d * (n.sinB - n.sinA);
  const double direction = std::atan2(n.cosA - n.cosB, n.d - n.sinA + n.sinB);
  return Parts{turnAngle(n.alpha - direction), std::sqrt(std::max(0.0, square)), turnAngle(direction - n.beta)};
}

std::optional<Parts> lsr(const Normal& n) {
  const double square = -2.0 + n.d * n.d + 2.0 * n.cosAB + 2.0 * n.d * (n.sinA + n.sinB);
  if (square < 0.0) {
    return std::nullopt;
  }
  const double p = std::sqrt(square);
  const double direction = std::atan2(-n.cosA - n.cosB, n.d + n.sinA + n.sinB) - std::atan2(-2.0, p);
  return Parts{turnAngle(direction - n.alpha), p, turnAngle(direction - n.beta)};
}

std::optional<Parts> rsl(const Normal& n) {
  const double square = -2.0 + n.d * n.d + 2.0 * n.cosAB - 2.0 * n.d * (n.sinA + n.sinB);
  if (square < 0.0) {
    return std::nullopt;
  }
  const double p = std::sqrt(square);
  const double direction = std::atan2(n.cosA + n.cosB, n.d - n.sinA - n.sinB) - std::atan2(2.0, p);
  return Parts{turnAngle(n.alpha - direction), p, turnAngle(n.beta - direction)};
}

std::optional<Parts> rlr(const Normal& n) {
  const double c = (6.0 - n.d * n.d + 2.0 * n.cosAB + 2.0 * n.d * (n.sinA - n.sinB)) / 8.0;
  if (std::abs(c) > 1.0) {
    return std::nullopt;
  }
  const double p = kTwoPi - std::acos(c);
  const double t = turnAngle(n.alpha - std::atan2(n.cosA - n.cosB, n.d - n.sinA + n.sinB) + p / 2.0);
  return Parts{t, p, turnAngle(n.alpha - n.beta - t + p)};
}

std::optional<Parts> lrl(const Normal& n) {
  const double c = (6.0 - n.d * n.d + 2.0 * n.cosAB + 2.0 * n.d * (n.sinB - n.sinA)) / 8.0;
  if (std::abs(c) > 1.0) {
    return std::nullopt;
  }
  const double p = kTwoPi - std::acos(c);
  const double t = turnAngle(-n.alpha + std::atan2(n.cosB - n.cosA, n.d + n.sinA - n.sinB) + p / 2.0);
  return Parts{t, p, turnAngle(n.beta - n.alpha - t + p)};
}

std::optional<Parts> solve(const Normal& normal, Word word) {
  switch (word) {
    case Word::LSL:
      return lsl(normal);
    case Word::RSR:
      return rsr(normal);
    case Word::LSR:
      return lsr(normal);
    case Word::RSL:
      return rsl(normal);
    case Word::RLR:
      return rlr(normal);
    case Word::LRL:
      return lrl(normal);
  }
  return std::nullopt;
}

bool hasStraight(Word word) {
  return word != Word::RLR && word != Word::LRL;
}

}  // namespace

std::array<Turn, 3> turnsOf(Word word) {
  constexpr Turn L = Turn::Left;
  constexpr Turn R = Turn::Right;
  constexpr Turn S = Turn::Straight;
  switch (word) {
    case Word::LSL:
      return {L, S, L};
    case Word::RSR:
      return {R, S, R};
    case Word::LSR:
      return {L, S, R};
    case Word::RSL:
      return {R, S, L};
    case Word::RLR:
      return {R, L, R};
    case Word::LRL:
      return {L, R, L};
  }
  return {S, S, S};
}

double DubinsPath::turned() const {
  return hasStraight(word) ? lengths[0] + lengths[2] : length();
}

double DubinsPath::straight() const {
  return hasStraight(word) ? lengths[1] : 0.0;
}

Piece DubinsPath::piece(std::size_t part) const {
  const Turn turn = turnsOf(word)[part];
  return {turn, turn == Turn::Straight ? 0.0 : radius, lengths[part]};
}

double lossInWind(const DubinsPath& path, TurnLoss loss) {
  double course = path.start.heading;
  double lost = 0.0;
  for (std::size_t part = 0; part < 3; ++part) {
    const Turn turn = turnsOf(path.word)[part];
    if (turn == Turn::Straight) {
      lost += path.lengths[part] > 0.0 ? path.lengths[part] * loss.byCourse->straightRate(std::cos(course), std::sin(course)) : 0.0;
    } else {
      const double turned = static_cast<double>(static_cast<int>(turn)) * path.lengths[part] / path.radius;
      lost += loss.byCourse->turn(course, turned);
      course += turned;
    }
  }
  return lost;
}

std::optional<DubinsPath> dubinsWord(const geo::Pose& from, const geo::Pose& to, double radius, Word word) {
  VP_EXPECT(radius > 0.0);
  const std::optional<Parts> parts = solve(scaled(unscaled(from, to), radius), word);
  if (!parts) {
    return std::nullopt;
  }
  return DubinsPath{from, radius, word, {parts->t * radius, parts->p * radius, parts->q * radius}};
}

DubinsPath shortestDubins(const geo::Pose& from, const geo::Pose& to, double radius) {
  return PosePair(from, to).leastLoss(radius, {1.0, 1.0});
}

DubinsPath leastLossDubins(const geo::Pose& from, const geo::Pose& to, double radius, TurnLoss loss) {
  return PosePair(from, to).leastLoss(radius, loss);
}

void appendPieces(const DubinsPath& path, std::vector<Piece>& pieces) {
  for (std::size_t part = 0; part < 3; ++part) {
    const Piece piece = path.piece(part);
    if (piece.length <= 0.0) {
      continue;
    }
    if (!pieces.empty() && pieces.back().turn == piece.turn && pieces.back().radius == piece.radius) {
      pieces.back().length += piece.length;
    } else {
      pieces.push_back(piece);
    }
  }
}

Curve toCurve(const DubinsPath& path) {
  Curve curve{path.start, {}, {}};
  appendPieces(path, curve.pieces);
  return curve;
}

}  // namespace vp::flight
