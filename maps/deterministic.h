// Noise and random numbers that are the same on every machine: integer hashing and only + - * / on doubles.
#pragma once

#include <cstdint>

namespace vp::maps {

/** splitmix64: a generator of 64-bit numbers whose sequence is fixed by its seed.
 *  @source Steele, Lea, Flood 2014, Fast splittable pseudorandom number generators */
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /** Uniform in [0, 1). */
  double uniform();
  /** Uniform in [from, to). */
  double uniform(double from, double to) { return from + (to - from) * uniform(); }

private:
  std::uint64_t state_;
};

/** Smooth noise in [-1, 1] over the plane with one lattice cell per unit. */
double valueNoise(double x, double y, std::uint64_t seed);

/** Sum of octaves of valueNoise, each of twice the frequency and half the amplitude; within [-1, 1]. */
double fractalNoise(double x, double y, std::uint64_t seed, int octaves);

/** 0 below from, 1 above to, smooth between (3 t^2 - 2 t^3). */
double smoothStep(double from, double to, double value);

/** Rounds to a multiple of `unit` (half away from zero), so that the last bits of a computation do not matter. */
double roundTo(double value, double unit);

}  // namespace vp::maps
