#pragma once

#include <cstdint>

namespace vp::tour {

/** Small fast random numbers, the same on every machine for a seed (splitmix64, Steele, Lea, Flood 2014). */
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  /** Uniform in [0, n), n > 0. */
  int below(int n) { return static_cast<int>(((next() >> 32) * static_cast<std::uint64_t>(n)) >> 32); }

  /** Uniform in (0, 1]. */
  double unit() { return static_cast<double>((next() >> 11) + 1) * 0x1.0p-53; }

private:
  std::uint64_t state_;
};

}  // namespace vp::tour
