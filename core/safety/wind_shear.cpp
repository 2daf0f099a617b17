#include "core/safety/wind_shear.h"

#include "core/safety/wind_glide.h"
#include "core/safety/wind_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Parts of the range of banks that shortOf looks at, each by its ends.
constexpr int kParts = 400;

/// More than this above the factor of a straight flight is taken for no glide.
constexpr double kMostInTurn = 2.0;
constexpr int kMostRounds = 50;

/** One aircraft in the strongest shear and the strongest wind at once, letters as in WHY.md section 12. */
struct ShearedGlide {
  double s0 = 0.0;         // sin(gamma) without shear, wings level
  double induced = 0.0;    // B
  double kappa = 0.0;      // airspeed x shear / gravity
  double windShare = 0.0;  // strongest wind / least airspeed

  [[nodiscard]] double sineAt(double tangent) const { return s0 + induced * tangent * tangent; }

  /// By how much the factor k is too small at tangents of bank from t0 to t1, relative; at most 0 if it is enough; infinity where nothing is.
  [[nodiscard]] double shortOf(double k, double t0, double t1) const {
    const double q0 = k * sineAt(t0);
    const double q1 = k * sineAt(t1);
    const double most = 1.0 - q1 * q1 - windShare * windShare;
    if (!(q1 < 1.0 && most > 0.0)) {
      return kInfinity;
    }
    const double c0 = std::sqrt(1.0 - q0 * q0);
    const double tau = windShare / std::sqrt(most);
    const double e = 2.0 / (1.0 + std::min(1.0, windShare / std::sqrt(1.0 - q1 * q1)));
    const double upright = 1.0 - 2.0 * kappa * c0 - kappa * kappa * q1 * q1;
    const double spared = (upright > 0.0 ? q0 * q0 : q1 * q1) * upright + t0 * t0 * (1.0 - std::pow(c0, 2.0 * e));
    const double aside = kappa * q1 * tau;
    const double added = aside * (2.0 * t1 * std::pow(c0, e) + aside);
    return 1.0 - k * (1.0 - kappa * c0) - induced * (spared - added) / sineAt(spared > added ? t1 : t0);
  }

  /// The least factor that is found to be enough up to this tangent of bank, from that of the energy alone on.
  [[nodiscard]] double enough(double mostTangent) const {
    const double energy = 1.0 / (1.0 - kappa);
    double k = energy;
    for (int round = 0; round < kMostRounds && k < kMostInTurn * energy; ++round) {
      double missing = shortOf(k, 0.0, 0.0);
      for (int i = 0; i < kParts && mostTangent > 0.0; ++i) {
        missing = std::max(missing, shortOf(k, mostTangent * i / kParts, mostTangent * (i + 1) / kParts));
      }
      if (!(missing > 0.0)) {
        return k;
      }
      k += 1.01 * missing * energy;
    }
    return kInfinity;
  }
};

}  // namespace

double greatestDifference(const air::WindSector& a, const air::WindSector& b) {
  const WindSet one({{geo::HeightMsl::fromMetres(0.0), a}});
  const WindSet other({{geo::HeightMsl::fromMetres(0.0), b}});
  double most = 0.0;
  for (const WindSet::Arc& p : one.extremes()) {
    for (const WindSet::Arc& q : other.extremes()) {
      const double apart = folded({p.towards.from - q.towards.to, p.towards.to - q.towards.from}).to;
      const double along = p.speed - q.speed * std::cos(apart);
      most = std::max(most, std::hypot(along, q.speed * std::sin(apart)));
    }
  }
  return most;
}

double shearBetween(const air::WindLayer& a, const air::WindLayer& b) {
  return greatestDifference(a.wind, b.wind) / std::abs(b.altitude.metres() - a.altitude.metres());
}

ShearCost ShearCost::with(const ShearCost& other) const {
  return {std::max(straight, other.straight), std::max(turn, other.turn), std::min(least, other.least)};
}

bool ShearCost::isGlide() const {
  return straight < kInfinity && turn < kInfinity;
}

ShearCost shearCost(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, const Airspeeds& speeds, double strongest,
                    double shear) {
  if (shear == 0.0) {
    return {};
  }
  const double kappa = speeds.most * shear / kGravity.si();
  if (!(kappa < 1.0)) {
    return {kInfinity, kInfinity, 1.0 / (1.0 + kappa)};
  }
  double steepest = tan(profile.tourBank);
  for (const Angle bank : profile.glideBanks) {
    steepest = std::max(steepest, tan(bank));
  }
  const WindGlide still(profile, conditions, speeds.least);
  const ShearedGlide glide{still.straightSine(), still.inducedSine(), kappa, strongest / speeds.least};
  return {glide.enough(0.0), glide.enough(steepest), 1.0 / (1.0 + kappa)};
}

}  // namespace vp::safety
