#pragma once

// Four floats at a time, with the vector extension of g++ and clang: SSE2 on x86-64, NEON on ARM. The operations are
// sums and minima only, so every machine gives the same results.

namespace vp::tour {

using Lanes = float __attribute__((vector_size(16)));
using LanesInMemory = float __attribute__((vector_size(16), aligned(4), may_alias));

inline Lanes load(const float* from) {
  return *reinterpret_cast<const LanesInMemory*>(from);
}

inline void store(float* to, Lanes value) {
  *reinterpret_cast<LanesInMemory*>(to) = value;
}

inline Lanes all(float value) {
  return Lanes{value, value, value, value};
}

inline Lanes least(Lanes a, Lanes b) {
  return a < b ? a : b;
}

inline float leastLane(Lanes a) {
  a = least(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
  a = least(a, __builtin_shufflevector(a, a, 1, 0, 3, 2));
  return a[0];
}

/** to[j] = min over i < rows of from[i] + block[i * width + j]: one step of a layered shortest path; width is a multiple of 8. */
inline void minPlus(const float* from, const float* block, int rows, int width, float* to) {
  for (int j = 0; j < width; j += 8) {
    const float* row = block + j;
    Lanes weight = all(from[0]);
    Lanes low = load(row) + weight;
    Lanes high = load(row + 4) + weight;
    for (int i = 1; i < rows; ++i) {
      row += width;
      weight = all(from[i]);
      low = least(low, load(row) + weight);
      high = least(high, load(row + 4) + weight);
    }
    store(to + j, low);
    store(to + j + 4, high);
  }
}

/** Least a[i] + b[i] and the first i that gives it. */
struct LeastSum {
  float value;
  int index;
};

inline LeastSum leastSum(const float* a, const float* b, int count) {
  LeastSum best{a[0] + b[0], 0};
  for (int i = 1; i < count; ++i) {
    const float sum = a[i] + b[i];
    best.index = sum < best.value ? i : best.index;
    best.value = sum < best.value ? sum : best.value;
  }
  return best;
}

}  // namespace vp::tour
