#include "core/audit/sample_air.h"

#include <algorithm>
#include <cmath>

namespace vp::audit {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTableFrom = -1000.0;  // m MSL
constexpr double kTableTo = 20000.0;    // m MSL
constexpr double kTableStep = 10.0;     // m; between them the root of the density is off by less than 1e-7 of it

// ICAO Doc 7488/3, tables A to D
constexpr double kGasConstant = 287.05287;  // J/(kg K)
constexpr double kGravity = 9.80665;        // m/s^2
constexpr double kLapse = 6.5e-3;           // K/m
constexpr double kSeaLevel = 288.15;        // K
constexpr double kTropopause = 11000.0;     // m

/// How a sector is drawn from.
enum class Choice { Uniform, Ends, Adverse };

LevelWind drawFrom(const air::WindLayer& layer, Choice choice, double adverse, Draws& draws) {
  const air::WindSector& sector = layer.wind;
  double part = 2.0 * draws.unit() - 1.0;  // of the spread, to each side
  double fraction = draws.unit();          // of the range of speeds
  if (choice == Choice::Ends) {
    part = part < 0.0 ? -1.0 : 1.0;
    fraction = fraction < 0.5 ? 0.0 : 1.0;
  }
  const double middle = (270.0 - sector.from_deg) * kPi / 180.0;
  const double spread = sector.spread_deg * kPi / 180.0;
  double towards = middle + part * spread;
  if (choice == Choice::Adverse) {
    towards = middle + std::clamp(std::remainder(adverse - middle, 2.0 * kPi), -spread, spread);
    fraction = std::cos(towards - adverse) >= 0.0 ? 1.0 : 0.0;
  }
  const double speed = sector.leastSpeed + fraction * (sector.mostSpeed - sector.leastSpeed);
  return {layer.altitude.metres(), speed * std::cos(towards), speed * std::sin(towards)};
}

}  // namespace

Draws::Draws(std::uint64_t seed, std::uint64_t index) : state_(seed) {
  state_ = next() ^ (index * 0xD1B54A32D192ED03ULL);
  next();
}

std::uint64_t Draws::next() {
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

double Draws::unit() {
  return static_cast<double>(next() >> 11U) * 0x1.0p-53;
}

LevelWind SampleAir::at(double altitude) const {
  if (levels.empty()) {
    return {altitude, 0.0, 0.0};
  }
  if (altitude <= levels.front().altitude) {
    return levels.front();
  }
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const LevelWind& low = levels[i - 1];
    const LevelWind& high = levels[i];
    if (altitude < high.altitude) {
      const double part = (altitude - low.altitude) / (high.altitude - low.altitude);
      return {altitude, low.east + part * (high.east - low.east), low.north + part * (high.north - low.north)};
    }
  }
  return levels.back();
}

SampleAir drawAir(const mission::Mission& mission, geo::Point from, geo::Point to, Draws& draws) {
  SampleAir air;
  const double kind = draws.unit();
  const Choice choice = kind < 0.4 ? Choice::Uniform : kind < 0.7 ? Choice::Ends : Choice::Adverse;
  const double adverse = std::atan2(from.y - to.y, from.x - to.x);  // the way that a wind blows which is against the aircraft
  for (const air::WindLayer& layer : mission.wind) {
    air.levels.push_back(drawFrom(layer, choice, adverse, draws));
  }
  std::sort(air.levels.begin(), air.levels.end(), [](const LevelWind& a, const LevelWind& b) { return a.altitude < b.altitude; });
  const aircraft::AircraftProfile& profile = mission.aircraft;
  const double least = std::min(profile.mass_kg, profile.leastMass_kg.value_or(profile.mass_kg));
  const double most = std::max(profile.mass_kg, profile.mostMass_kg.value_or(profile.mass_kg));
  const double part = std::clamp(2.0 * draws.unit() - 0.5, 0.0, 1.0);
  air.mass_kg = least + part * (most - least);
  return air;
}

double airDensity(const air::Atmosphere& day, double altitude) {
  const double exponent = kGravity / (kGasConstant * kLapse);
  const double height = std::min(altitude, kTropopause);
  double pressure = 100.0 * day.qnh_hPa * std::pow(1.0 - kLapse * height / kSeaLevel, exponent);  // Pa
  const double standard = kSeaLevel - kLapse * height;
  if (altitude > kTropopause) {
    pressure *= std::exp((kTropopause - altitude) * kGravity / (kGasConstant * standard));
  }
  return pressure / (kGasConstant * (standard + day.temperatureOffset_K));
}

AirTable::AirTable(const mission::Mission& mission) {
  for (double altitude = kTableFrom; mission.atmosphere && altitude <= kTableTo; altitude += kTableStep) {
    factors_.push_back(std::sqrt(mission.aircraft.airDensity_kgm3 / airDensity(*mission.atmosphere, altitude)));
  }
}

double AirTable::speedFactor(double altitude) const {
  if (factors_.empty()) {
    return 1.0;
  }
  const double place = std::clamp((altitude - kTableFrom) / kTableStep, 0.0, static_cast<double>(factors_.size() - 2));
  const auto index = static_cast<std::size_t>(place);
  return factors_[index] + (place - static_cast<double>(index)) * (factors_[index + 1] - factors_[index]);
}

}  // namespace vp::audit
