#include "core/safety/standard_air.h"

#include <algorithm>
#include <cmath>

namespace vp::safety {
namespace {

// ICAO Doc 7488/3: tables A and B, and section 2.
constexpr double kSeaLevel_K = 288.15;
constexpr double kGradient = 0.0065;     // K per m, up to kIsothermal
constexpr double kIsothermal = 11000.0;  // m
constexpr double kGas = 287.05287;       // J/(kg K)
constexpr double kG = 9.80665;           // m/s^2

}  // namespace

/// dp = -rho g dh with T falling by kGradient, then constant: ln p is known in closed form for both.
double densityAt(const air::Atmosphere& air, double altitude) {
  const double standard_K = kSeaLevel_K - kGradient * std::min(altitude, kIsothermal);
  double logPressure = std::log(100.0 * air.qnh_hPa) + kG / (kGas * kGradient) * std::log(standard_K / kSeaLevel_K);
  if (altitude > kIsothermal) {
    logPressure -= kG / (kGas * standard_K) * (altitude - kIsothermal);
  }
  return std::exp(logPressure) / (kGas * (standard_K + air.temperatureOffset_K));
}

/// In the standard atmosphere density goes with a power of the temperature up to kIsothermal, and falls exponentially above.
double densityAltitudeOf(const air::Atmosphere& air, double altitude) {
  const double density = densityAt(air, altitude);
  const double seaLevel = densityAt({}, 0.0);
  const double coldest = densityAt({}, kIsothermal);
  if (density >= coldest) {
    return kSeaLevel_K / kGradient * (1.0 - std::pow(density / seaLevel, 1.0 / (kG / (kGas * kGradient) - 1.0)));
  }
  return kIsothermal + kGas * (kSeaLevel_K - kGradient * kIsothermal) / kG * std::log(coldest / density);
}

double altimeterShowsTooMuch(const air::Atmosphere& air, double altitude, double station) {
  const double above = altitude - station;
  const double seaLevel_C = 15.0 + air.temperatureOffset_K;
  return above * (15.0 - seaLevel_C) / (273.0 + seaLevel_C - 0.5 * kGradient * (above + station));
}

}  // namespace vp::safety
