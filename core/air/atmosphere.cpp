#include "core/air/atmosphere.h"

#include <algorithm>
#include <cmath>

namespace vp::air {
namespace {

// ICAO Doc 7488/3, tables A and D.
constexpr double kSeaLevelTemperature = 288.15;  // K
constexpr double kLapse = 0.0065;                // K/m, up to the tropopause
constexpr double kTropopause = 11000.0;          // m
constexpr double kGasConstant = 287.05287;       // J/(kg K), dry air
constexpr double kStandardGravity = 9.80665;     // m/s^2
constexpr double kPascalPerHectopascal = 100.0;
constexpr double kKelvinOfCelsius = 273.15;

/// Of the standard atmosphere, K.
double standardTemperature(double altitude) {
  return kSeaLevelTemperature - kLapse * std::min(altitude, kTropopause);
}

}  // namespace

double temperature(const Atmosphere& air, geo::HeightMsl altitude) {
  return standardTemperature(altitude.metres()) + air.temperatureOffset_K;
}

double pressure(const Atmosphere& air, geo::HeightMsl altitude) {
  const double height = altitude.metres();
  const double ratio = standardTemperature(height) / kSeaLevelTemperature;
  const double below = air.qnh_hPa * std::pow(ratio, kStandardGravity / (kGasConstant * kLapse));
  const double above = std::max(0.0, height - kTropopause);
  return below * std::exp(-kStandardGravity * above / (kGasConstant * standardTemperature(kTropopause)));
}

double density(const Atmosphere& air, geo::HeightMsl altitude) {
  return kPascalPerHectopascal * pressure(air, altitude) / (kGasConstant * temperature(air, altitude));
}

geo::HeightMsl densityAltitude(const Atmosphere& air, geo::HeightMsl altitude) {
  const double wanted = density(air, altitude);
  double low = -5000.0;
  double high = 40000.0;
  constexpr double kFine = 1e-6;  // m
  while (high - low > kFine) {    // density falls with height
    const double middle = 0.5 * (low + high);
    (density({}, geo::HeightMsl::fromMetres(middle)) > wanted ? low : high) = middle;
  }
  return geo::HeightMsl::fromMetres(0.5 * (low + high));
}

double altimeterError(const Atmosphere& air, geo::HeightMsl altitude, geo::HeightMsl station) {
  const double height = altitude.metres() - station.metres();
  const double atSeaLevel = kSeaLevelTemperature + air.temperatureOffset_K - kKelvinOfCelsius;  // Celsius
  constexpr double kStandardCelsius = 15.0;
  constexpr double kKelvin = 273.0;  // as the document rounds it
  return height * (kStandardCelsius - atSeaLevel) / (kKelvin + atSeaLevel - 0.5 * kLapse * (height + station.metres()));
}

}  // namespace vp::air
