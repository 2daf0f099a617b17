#include "core/emergency/dubins_ways.h"

#include "core/flight/dubins.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

constexpr std::array<flight::Word, kDubinsTypes> kTypes{flight::Word::LSL, flight::Word::RSR, flight::Word::LSR, flight::Word::RSL};
constexpr double kShortest = 1e-6;   // m: parts shorter than this are rounding
constexpr double kFits = 0.5;        // m of height: what the share of the slopes evens out anyway
constexpr double kTolerable = 15.0;  // m of height left over where there is no choice of slopes at all: the pilot's own way of losing it
constexpr double kNoRoom = 1e-6;     // m of height between the best glide and the steepest descent of a way
constexpr int kHalvings = 40;
constexpr int kSteps = 8;  // of a family between its shortest and its longest, where it may jump

void append(Pieces& pieces, const flight::Piece& piece) {
  if (piece.length <= kShortest) {
    return;
  }
  const bool isSame = !pieces.empty() && pieces.back().turn == piece.turn && pieces.back().radius == piece.radius;
  if (isSame) {
    pieces.back().length += piece.length;
  } else {
    pieces.push_back(piece);
  }
}

/// Whether the height left over by the best glide and by the steepest descent can be none.
bool isFitting(double mostLeft, double leastLeft) {
  return mostLeft >= 0.0 && (leastLeft <= 0.0 || (mostLeft - leastLeft < kNoRoom && leastLeft <= kTolerable));
}

double lengthOf(const Pieces& pieces) {
  double length = 0.0;
  for (const flight::Piece& piece : pieces) {
    length += piece.length;
  }
  return length;
}

}  // namespace

std::optional<Pieces> dubinsWay(const geo::Pose& from, const geo::Pose& to, double radius, std::size_t type) {
  const std::optional<flight::DubinsPath> path = flight::dubinsWord(from, to, radius, kTypes[type]);
  if (!path) {
    return std::nullopt;
  }
  Pieces pieces;
  for (std::size_t part = 0; part < 3; ++part) {
    append(pieces, path->piece(part));
  }
  return pieces;
}

double DubinsWays::left(const geo::Pose& from, double altitude, const Pieces& pieces, double share) {
  geo::Pose pose = from;
  return flight_->fly(pose, altitude, pieces, share, nullptr) - goalAltitude_;
}

void DubinsWays::direct(const geo::Pose& from, double altitude, std::vector<Pieces>& out) {
  for (std::size_t type = 0; type < kDubinsTypes; ++type) {
    std::optional<Pieces> way = dubinsWay(from, goal_, radius_, type);
    if (way && left(from, altitude, *way, 0.0) >= 0.0) {
      out.push_back(std::move(*way));
    }
  }
}

template <typename Family>
std::optional<Pieces> DubinsWays::fit(const geo::Pose& from, double altitude, double first, double most, const Family& family) {
  const auto excess = [&](double parameter, std::optional<Pieces>& way) {
    way = family(parameter);
    return way ? left(from, altitude, *way, 0.5) : std::numeric_limits<double>::quiet_NaN();
  };
  // the first step from "height left" to "too low" without a jump has the root
  double low = first;
  std::optional<Pieces> best;
  double atLow = excess(low, best);
  for (int step = 1; step <= kSteps; ++step) {
    double high = first + (most - first) * step / kSteps;
    std::optional<Pieces> way;
    double atHigh = excess(high, way);
    if (atLow >= 0.0 && atHigh < 0.0) {
      for (int i = 0; i < kHalvings && high - low > 1e-3; ++i) {
        const double middle = 0.5 * (low + high);
        const double there = excess(middle, way);
        (there >= 0.0 ? low : high) = middle;
        if (there >= 0.0) {
          best = way;
          atLow = there;
        }
        if (std::abs(there) < kFits) {
          break;
        }
      }
      if (best && isFitting(left(from, altitude, *best, 0.0), left(from, altitude, *best, 1.0))) {
        return best;
      }
      atLow = atHigh;  // a jump
    } else {
      atLow = atHigh;
      best = way;
    }
    low = first + (most - first) * step / kSteps;
  }
  return std::nullopt;
}

std::optional<Pieces> DubinsWays::fitted(const geo::Pose& from, double altitude, std::size_t type) {
  std::optional<Pieces> way = dubinsWay(from, goal_, radius_, type);
  const double most = way ? left(from, altitude, *way, 0.0) : -1.0;
  if (most < 0.0) {
    return std::nullopt;
  }
  const double surplus = left(from, altitude, *way, 1.0);
  if (isFitting(most, surplus)) {
    return way;
  }
  const double slope = (altitude - goalAltitude_ - surplus) / std::max(1.0, lengthOf(*way));
  const double longer = surplus / std::max(1e-3, slope);
  return fit(from, altitude, 0.0, longer + 4.0 * radius_, [&](double out) -> std::optional<Pieces> {
    const geo::Pose begin{goal_.x - out * std::cos(goal_.heading), goal_.y - out * std::sin(goal_.heading), goal_.heading};
    std::optional<Pieces> extended = dubinsWay(from, begin, radius_, type);
    if (extended) {
      append(*extended, {flight::Turn::Straight, 0.0, out});
    }
    return extended;
  });
}

void DubinsWays::sTurns(const geo::Pose& from, double altitude, std::vector<Pieces>& out) {
  const double course = std::atan2(goal_.y - from.y, goal_.x - from.x);
  const double slope = flight_->rangeOf(course, {flight::Turn::Straight, 0.0, 1.0}, altitude).least;
  const double most = altitude > goalAltitude_ ? (altitude - goalAltitude_) / std::max(1e-3, slope) : 0.0;
  for (const double side : {1.0, -1.0}) {
    std::optional<Pieces> best;
    for (std::size_t types = 0; types < kDubinsTypes * kDubinsTypes; ++types) {
      const std::optional<Pieces> found = fit(from, altitude, 0.0, 0.5 * most, [&](double aside) -> std::optional<Pieces> {
        const geo::Pose abeam{0.5 * (from.x + goal_.x) - side * aside * std::sin(course), 0.5 * (from.y + goal_.y) + side * aside * std::cos(course),
                              course};
        std::optional<Pieces> way = dubinsWay(from, abeam, radius_, types / kDubinsTypes);
        const std::optional<Pieces> second = dubinsWay(abeam, goal_, radius_, types % kDubinsTypes);
        if (!way || !second) {
          return std::nullopt;
        }
        for (const flight::Piece& piece : *second) {
          append(*way, piece);
        }
        return way;
      });
      if (found && (!best || found->size() < best->size())) {
        best = found;
      }
    }
    if (best) {
      out.push_back(std::move(*best));
    }
  }
}

}  // namespace vp::emergency
