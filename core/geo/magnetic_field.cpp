#include "core/geo/magnetic_field.h"

#include "core/base/expect.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/SphericalHarmonic.hpp>
#include <fmt/core.h>

#include <cmath>
#include <sstream>
#include <vector>

namespace vp::geo {

/// Text of resources/magnetic/WMM2025.COF, made part of the program by the build.
extern const char* const kMagneticCoefficients;

namespace {

constexpr int kDegree = 12;
constexpr double kReferenceRadius = 6371200.0;  // m, of the model's harmonics
constexpr double kYearsValid = 5.0;
constexpr double kBlackout = 2000.0;  // nT, blackout zone of the World Magnetic Model's report

/// Gauss coefficients in the order that GeographicLib wants: by order m, then by degree n >= m.
struct Coefficients {
  std::vector<double> cosine, sine;  ///< g and h: sine starts at m = 1
  explicit Coefficients() : cosine((kDegree + 1) * (kDegree + 2) / 2), sine(kDegree * (kDegree + 1) / 2) {}

  static std::size_t place(int n, int m) {
    const int before = m * kDegree - m * (m - 1) / 2;
    return static_cast<std::size_t>(before) + static_cast<std::size_t>(n);
  }

  void set(int n, int m, double g, double h) {
    cosine[place(n, m)] = g;
    if (m > 0) {
      sine[place(n, m) - (kDegree + 1)] = h;
    }
  }
};

struct Model {
  double epoch = 0.0;
  std::string name;
  Coefficients field;   ///< nT, at the epoch
  Coefficients change;  ///< nT per year

  Model() {
    std::istringstream text(kMagneticCoefficients);
    std::string released;
    text >> epoch >> name >> released;
    int n = 0;
    int m = 0;
    double g = 0.0;
    double h = 0.0;
    double gRate = 0.0;
    double hRate = 0.0;
    int rows = 0;
    for (; text >> n >> m >> g >> h >> gRate >> hRate; ++rows) {
      VP_EXPECT(n >= 1 && n <= kDegree && m >= 0 && m <= n);
      field.set(n, m, g, h);
      change.set(n, m, gRate, hRate);
    }
    VP_EXPECT(rows == kDegree * (kDegree + 3) / 2);
  }
};

const Model& model() {
  static const Model instance;
  return instance;
}

}  // namespace

double MagneticField::horizontal() const {
  return std::hypot(north, east);
}

bool MagneticField::movesACompass() const {
  return horizontal() >= kBlackout;
}

Angle MagneticField::variation() const {
  return Angle::radians(std::atan2(east, north));
}

MagneticField magneticField(LatLon place, HeightMsl height, double year) {
  const Model& wmm = model();
  Coefficients now = wmm.field;
  const double years = year - wmm.epoch;
  for (std::size_t i = 0; i < now.cosine.size(); ++i) {
    now.cosine[i] += years * wmm.change.cosine[i];
  }
  for (std::size_t i = 0; i < now.sine.size(); ++i) {
    now.sine[i] += years * wmm.change.sine[i];
  }
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  std::vector<double> toGeocentric(9);  // local east, north, up to geocentric; row by row
  GeographicLib::Geocentric::WGS84().Forward(place.latitude_deg, place.longitude_deg, height.metres(), x, y, z, toGeocentric);
  const GeographicLib::SphericalHarmonic potential(now.cosine, now.sine, kDegree, kReferenceRadius, GeographicLib::SphericalHarmonic::SCHMIDT);
  double gradient[3] = {};
  potential(x, y, z, gradient[0], gradient[1], gradient[2]);
  double local[3] = {};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      local[column] -= kReferenceRadius * toGeocentric[3 * row + column] * gradient[row];
    }
  }
  return {local[1], local[0], -local[2]};
}

bool isCoveredByMagneticModel(double year) {
  return year >= model().epoch && year < model().epoch + kYearsValid;
}

std::string magneticModelName() {
  return fmt::format("World Magnetic Model {} (NOAA NCEI, BGS), valid {:.0f} to {:.0f}", model().name, model().epoch,
                     model().epoch + kYearsValid - 1.0);
}

double decimalYear(std::chrono::year_month_day day) {
  using namespace std::chrono;
  const sys_days first = day.year() / January / 1;
  const sys_days next = (day.year() + years(1)) / January / 1;
  const double passed = static_cast<double>((sys_days(day) - first).count()) + 0.5;
  return static_cast<double>(static_cast<int>(day.year())) + passed / static_cast<double>((next - first).count());
}

std::chrono::year_month_day today() {
  return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
}

}  // namespace vp::geo
