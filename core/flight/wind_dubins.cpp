#include "core/flight/wind_dubins.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/wind_words.h"

#include <cmath>

namespace vp::flight {
namespace {

/// Winds above this share of the airspeed are as strong as it: what is left against them is rounding.
constexpr double kStrongest = 1.0 - 1e-6;

/// Radii between two places; squares of more are of no use to rounding.
constexpr double kFarthest = 1e9;

bool isFinite(const geo::Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

bool beginsLeft(Word word) {
  return word == Word::LSL || word == Word::LSR || word == Word::LRL;
}

/// What all paths of one connection share.
struct Connection {
  geo::Pose from;
  geo::Pose to;
  double radius = 0.0;
  double airspeed = 0.0;
  air::Wind wind;

  [[nodiscard]] WindFrame frame() const { return {from, to, radius, airspeed, wind}; }
  [[nodiscard]] WindPath path(const WindSearch::Found& found) const {
    return {from, radius, found.word, {radius * found.parts[0], radius * found.parts[1], radius * found.parts[2]}, wind, airspeed};
  }
};

Result<void> checked(const Connection& connection) {
  if (!std::isfinite(connection.airspeed) || !std::isfinite(connection.wind.east) || !std::isfinite(connection.wind.north)) {
    return fail(Errc::OutOfRange, "The wind or the airspeed is not a number.");
  }
  if (!canConnect(connection.airspeed, connection.wind)) {
    return fail(Errc::OutOfRange, "The wind is as strong as the airspeed or stronger, so the aircraft cannot fly against it.");
  }
  if (!isFinite(connection.from) || !isFinite(connection.to)) {
    return fail(Errc::OutOfRange, "A place or heading is not a number.");
  }
  if (!std::isfinite(connection.radius) || connection.radius <= 0.0) {
    return fail(Errc::OutOfRange, "The turn radius is not above zero.");
  }
  if (!(geo::distance(connection.from.point(), connection.to.point()) <= kFarthest * connection.radius)) {
    return fail(Errc::OutOfRange, "The two places are too far apart for so small a turn radius.");
  }
  return {};
}

Result<WindPath> least(const Connection& connection, TurnLoss loss) {
  if (const Result<void> check = checked(connection); !check) {
    return forward(check);
  }
  const WindFrame frame = connection.frame();
  const WindFrame mirrored = frame.mirrored();
  WindSearch search(loss);
  for (const Word word : kWords) {
    search.search(word, beginsLeft(word) ? frame : mirrored);
  }
  if (search.size() == 0) {
    return fail(Errc::NoSolution, "No path of three parts connects the two places in this wind.");
  }
  return connection.path(search[0]);
}

}  // namespace

void WindPaths::push(const WindPath& path) {
  VP_EXPECT(size_ < kCapacity);
  paths_[size_++] = path;
}

bool canConnect(double airspeed, air::Wind wind) {
  return std::isfinite(airspeed) && airspeed > 0.0 && std::hypot(wind.east, wind.north) <= kStrongest * airspeed;
}

WindPaths windWord(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind, Word word) {
  const Connection connection{from, to, radius, airspeed, wind};
  VP_EXPECT(checked(connection).has_value());
  const WindFrame frame = connection.frame();
  WindSearch search;
  search.search(word, beginsLeft(word) ? frame : frame.mirrored());
  WindPaths paths;
  for (std::size_t i = 0; i < search.size(); ++i) {
    paths.push(connection.path(search[i]));
  }
  return paths;
}

Result<WindPath> shortestTime(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind) {
  return least({from, to, radius, airspeed, wind}, {1.0, 1.0});
}

Result<WindPath> leastLoss(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind, TurnLoss loss) {
  VP_EXPECT(loss.turn >= loss.straight && loss.straight >= 0.0);
  return least({from, to, radius, airspeed, wind}, loss);
}

Curve toCurve(const WindPath& path) {
  Curve curve{path.start, {}, path.wind};
  appendPieces(DubinsPath{path.start, path.radius, path.word, path.lengths}, curve.pieces);
  return curve;
}

std::optional<double> airHeadingFor(double course, double airspeed, air::Wind wind) {
  const double c = std::cos(course);
  const double s = std::sin(course);
  const double along = c * wind.east + s * wind.north;
  const double across = c * wind.north - s * wind.east;  // towards the left
  if (!(airspeed > 0.0) || !(std::abs(across) <= airspeed) || !(along + std::sqrt(airspeed * airspeed - across * across) > 0.0)) {
    return std::nullopt;
  }
  return wrapTwoPi(course - std::asin(across / airspeed));
}

std::optional<double> courseFor(double airHeading, double airspeed, air::Wind wind) {
  const double east = airspeed * std::cos(airHeading) + wind.east;
  const double north = airspeed * std::sin(airHeading) + wind.north;
  if (!std::isfinite(east) || !std::isfinite(north) || (east == 0.0 && north == 0.0)) {
    return std::nullopt;
  }
  return wrapTwoPi(std::atan2(north, east));
}

}  // namespace vp::flight
