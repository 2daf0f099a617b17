#pragma once

#include "core/geo/pose.h"
#include "core/mission/mission.h"

#include <cstdint>
#include <vector>

namespace vp::audit {

/** Numbers that depend on a seed and an index alone, so that samples may be flown in any order by any number of threads.
 *  @source Steele, Lea, Flood 2014, Fast splittable pseudorandom number generators (SplitMix64) */
class Draws {
public:
  Draws(std::uint64_t seed, std::uint64_t index);
  /** Uniform in [0, 1). */
  double unit();

private:
  std::uint64_t next();
  std::uint64_t state_ = 0;
};

/** The wind at one height: velocity of the air over ground, towards [m/s]. */
struct LevelWind {
  double altitude = 0.0;  ///< m MSL
  double east = 0.0;
  double north = 0.0;
};

/** The one wind and the one mass that a sample is flown with. */
struct SampleAir {
  std::vector<LevelWind> levels;  ///< ascending; linear in height between them, steady above and below; empty: calm
  double mass_kg = 0.0;

  [[nodiscard]] LevelWind at(double altitude) const;
};

/** Draws a wind out of the sectors of the mission, one for each layer, and a mass out of the profile's.
 *  Four in ten winds are uniform in speed and direction, three in ten are at the ends of both ranges, three in ten are the wind of each sector
 *  that is most against the way from `from` to `to`. Half of the masses are uniform, a quarter each the least and the greatest. */
SampleAir drawAir(const mission::Mission& mission, geo::Point from, geo::Point to, Draws& draws);

/** Density of the day's air [kg/m^3].  @source ICAO Doc 7488/3: standard atmosphere, its temperature moved by a constant, its pressure in
 *  the proportion of the QNH */
double airDensity(const air::Atmosphere& day, double altitude);

/** How much faster than at the density of the polar the aircraft is at altitudes, at one indicated airspeed: sqrt(rho_ref / rho), every 10 m. */
class AirTable {
public:
  explicit AirTable(const mission::Mission& mission);
  [[nodiscard]] double speedFactor(double altitude) const;
  [[nodiscard]] bool isConstant() const { return factors_.empty(); }

private:
  std::vector<double> factors_;  ///< empty: 1 everywhere
};

}  // namespace vp::audit
