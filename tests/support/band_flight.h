#pragma once
// Winds by altitude for flown glides: below the lowest layer its winds, above the highest its, between two evenly from the one to the other. The
// aircraft keeps its airspeed while the wind changes around it.

#include "core/mission/mission.h"
#include "tests/support/wind_flight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace vp::test {

/// Today's checker counts the winds of all layers at every altitude. Set when it counts by altitude, as the planner does.
inline constexpr bool kCheckerKnowsBands = true;

/** Whether the losses of a mission differ by altitude. */
inline bool hasBands(const mission::Mission& mission) {
  return mission.wind.size() > 1 || mission.atmosphere.has_value();
}

/** The winds of one day: one of each layer. */
struct DayWinds {
  std::vector<air::WindLayer> layers;  ///< ascending
  std::vector<SteadyWind> winds;       ///< of each layer

  /** @param z  m MSL */
  [[nodiscard]] SteadyWind at(double z) const {
    if (winds.empty()) {
      return {};
    }
    const std::size_t over = layersBelow(z);
    if (over == 0 || over == winds.size()) {
      return winds[over == 0 ? 0 : over - 1];
    }
    const SteadyWind& low = winds[over - 1];
    const SteadyWind& high = winds[over];
    const double bottom = layers[over - 1].altitude.metres();
    const double share = (z - bottom) / (layers[over].altitude.metres() - bottom);
    return {low.east + share * (high.east - low.east), low.north + share * (high.north - low.north)};
  }

  /** Its change per metre of height [1/s]; at a layer that of below it. */
  [[nodiscard]] SteadyWind changeAt(double z) const {
    const std::size_t over = layersBelow(z);
    if (over == 0 || over == winds.size()) {
      return {};
    }
    const double depth = layers[over].altitude.metres() - layers[over - 1].altitude.metres();
    return {(winds[over].east - winds[over - 1].east) / depth, (winds[over].north - winds[over - 1].north) / depth};
  }

  /** The next layer's altitude below z, that the glide must not step over; minus infinity if there is none. */
  [[nodiscard]] double edgeBelow(double z) const {
    const std::size_t below = layersBelow(z);
    return below > 0 ? layers[below - 1].altitude.metres() : -std::numeric_limits<double>::infinity();
  }

private:
  [[nodiscard]] std::size_t layersBelow(double z) const {
    return static_cast<std::size_t>(
        std::count_if(layers.begin(), layers.end(), [z](const air::WindLayer& layer) { return layer.altitude.metres() < z; }));
  }
};

template <typename Random>
DayWinds dayWinds(const std::vector<air::WindLayer>& layers, Random& random) {
  DayWinds day{layers, {}};
  std::sort(day.layers.begin(), day.layers.end(), [](const auto& a, const auto& b) { return a.altitude.metres() < b.altitude.metres(); });
  for (const air::WindLayer& layer : day.layers) {
    day.winds.push_back(windOf(layer.wind, random));
  }
  return day;
}

/** The winds of an altitude that cost a course most: an adversary who chooses anew on every metre, from the corners of the sectors there. */
class WorstWinds {
public:
  explicit WorstWinds(std::vector<air::WindLayer> layers) : day_{std::move(layers), {}} {
    std::sort(day_.layers.begin(), day_.layers.end(), [](const auto& a, const auto& b) { return a.altitude.metres() < b.altitude.metres(); });
  }
  [[nodiscard]] double edgeBelow(double z) const { return day_.edgeBelow(z); }

  [[nodiscard]] double lossAt(double z, const aircraft::GlidePolar& polar, double course, double radius) const {
    double worst = 0.0;
    const std::size_t count = day_.layers.size();
    for (std::size_t i = 0; i < count; ++i) {
      const bool isNextBelow = day_.layers[i].altitude.metres() < z && (i + 1 == count || day_.layers[i + 1].altitude.metres() >= z);
      const bool isNextAbove = day_.layers[i].altitude.metres() >= z && (i == 0 || day_.layers[i - 1].altitude.metres() < z);
      if (isNextBelow || isNextAbove) {
        worst = std::max(worst, worstOf(day_.layers[i].wind, polar, course, radius));
      }
    }
    return count > 0 ? worst : lossInWind(polar, {}, course, radius);
  }

private:
  static double worstOf(const air::WindSector& sector, const aircraft::GlidePolar& polar, double course, double radius) {
    double worst = 0.0;
    for (const double side : {-1.0, 0.0, 1.0}) {
      for (const double speed : {sector.leastSpeed, sector.mostSpeed}) {
        const double towards = sector.towards() + side * sector.spread();
        worst = std::max(worst, lossInWind(polar, {speed * std::cos(towards), speed * std::sin(towards)}, course, radius));
      }
    }
    return worst;
  }

  DayWinds day_;
};

/** Flies pieces in steps of two metres at most, each within one band of altitude.
 *  @param lossAt  (altitude, course, radius) -> height lost per metre   @param edgeBelow  (altitude) -> the next edge below it */
template <typename LossAt, typename EdgeBelow>
Outcome flyByAltitude(geo::Pose pose, double altitude, const std::vector<flight::Piece>& pieces, const terrain::ElevationGrid& terrain,
                      double clearance, LossAt lossAt, EdgeBelow edgeBelow) {
  Outcome outcome;
  const auto look = [&] { outcome.leastSpare = std::min(outcome.leastSpare, altitude - clearance - terrain.upperAt(pose.point())); };
  look();
  for (const flight::Piece& piece : pieces) {
    const double side = static_cast<double>(static_cast<int>(piece.turn));
    for (double left = piece.length; left > 1e-9;) {
      const double radius = side == 0.0 ? 0.0 : piece.radius;
      double length = std::min(2.0, left);
      const double ahead = side == 0.0 ? 0.0 : 0.5 * side * length / piece.radius;
      const double rate = lossAt(altitude, pose.heading + ahead, radius);
      length = std::min(length, std::max(1e-6, (altitude - edgeBelow(altitude)) / rate));
      const double turned = side == 0.0 ? 0.0 : side * length / piece.radius;
      const double middle = pose.heading + 0.5 * turned;
      const double chord = side == 0.0 ? length : 2.0 * piece.radius * std::sin(0.5 * length / piece.radius);
      altitude -= length * rate;
      pose = {pose.x + chord * std::cos(middle), pose.y + chord * std::sin(middle), pose.heading + turned};
      left -= length;
      look();
    }
  }
  outcome.endAltitude = altitude;
  outcome.end = pose;
  return outcome;
}

}  // namespace vp::test
