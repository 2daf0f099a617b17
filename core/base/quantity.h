#pragma once

#include <cmath>
#include <compare>

namespace vp {

/** A physical quantity in SI units whose dimension (metres^L * seconds^T) is checked by the compiler.
 *  Costs nothing: sizeof == 8, trivially copyable. Made only by fromSi() or the literals below, read by si().
 *  Geometry kernels (curves, roadmaps, terrain) work on plain doubles in SI and say so in their docstrings;
 *  values that people set or read use these types. */
template <int L, int T>
class Quantity {
public:
  constexpr Quantity() = default;
  static constexpr Quantity fromSi(double value) { return Quantity(value); }
  [[nodiscard]] constexpr double si() const { return value_; }

  constexpr auto operator<=>(const Quantity&) const = default;
  constexpr Quantity operator-() const { return Quantity(-value_); }
  constexpr Quantity operator+(Quantity o) const { return Quantity(value_ + o.value_); }
  constexpr Quantity operator-(Quantity o) const { return Quantity(value_ - o.value_); }
  constexpr Quantity operator*(double f) const { return Quantity(value_ * f); }
  constexpr Quantity operator/(double f) const { return Quantity(value_ / f); }
  friend constexpr Quantity operator*(double f, Quantity q) { return q * f; }

private:
  constexpr explicit Quantity(double value) : value_(value) {}
  double value_ = 0.0;
};

template <int L1, int T1, int L2, int T2>
constexpr auto operator*(Quantity<L1, T1> a, Quantity<L2, T2> b) {
  if constexpr (L1 + L2 == 0 && T1 + T2 == 0) {
    return a.si() * b.si();
  } else {
    return Quantity<L1 + L2, T1 + T2>::fromSi(a.si() * b.si());
  }
}

template <int L1, int T1, int L2, int T2>
constexpr auto operator/(Quantity<L1, T1> a, Quantity<L2, T2> b) {
  if constexpr (L1 == L2 && T1 == T2) {
    return a.si() / b.si();
  } else {
    return Quantity<L1 - L2, T1 - T2>::fromSi(a.si() / b.si());
  }
}

using Length = Quantity<1, 0>;
using Area = Quantity<2, 0>;
using Duration = Quantity<0, 1>;
using Speed = Quantity<1, -1>;
using Acceleration = Quantity<1, -2>;

inline constexpr double kMetresPerFoot = 0.3048;                         // international foot, exact (1959)
inline constexpr double kMetresPerNauticalMile = 1852.0;                 // exact (1929)
inline constexpr double kMpsPerKnot = 1852.0 / 3600.0;                   // one nautical mile per hour, exact
inline constexpr Acceleration kGravity = Acceleration::fromSi(9.80665);  // m/s^2, standard gravity, CGPM 1901

/** A plane angle. Made only by radians() or degrees(); wrapping is the caller's choice. */
class Angle {
public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * (kPi / 180.0)); }
  [[nodiscard]] constexpr double radians() const { return value_; }
  [[nodiscard]] constexpr double degrees() const { return value_ * (180.0 / kPi); }

  constexpr auto operator<=>(const Angle&) const = default;
  constexpr Angle operator-() const { return Angle(-value_); }
  constexpr Angle operator+(Angle o) const { return Angle(value_ + o.value_); }
  constexpr Angle operator-(Angle o) const { return Angle(value_ - o.value_); }
  constexpr Angle operator*(double f) const { return Angle(value_ * f); }

  static constexpr double kPi = 3.14159265358979323846;

private:
  constexpr explicit Angle(double radians) : value_(radians) {}
  double value_ = 0.0;
};

inline double sin(Angle a) {
  return std::sin(a.radians());
}
inline double cos(Angle a) {
  return std::cos(a.radians());
}
inline double tan(Angle a) {
  return std::tan(a.radians());
}

/** Wraps an angle in radians to [0, 2 pi). */
inline double wrapTwoPi(double radians) {
  constexpr double twoPi = 2.0 * Angle::kPi;
  double wrapped = std::fmod(radians, twoPi);
  if (wrapped < 0.0) {
    wrapped += twoPi;
  }
  return wrapped < twoPi ? wrapped : 0.0;
}

/** Wraps an angle in radians to [-pi, pi). */
inline double wrapPi(double radians) {
  return wrapTwoPi(radians + Angle::kPi) - Angle::kPi;
}

namespace literals {
constexpr Length operator""_m(long double v) {
  return Length::fromSi(static_cast<double>(v));
}
constexpr Length operator""_ft(long double v) {
  return Length::fromSi(static_cast<double>(v) * kMetresPerFoot);
}
constexpr Length operator""_nm(long double v) {
  return Length::fromSi(static_cast<double>(v) * kMetresPerNauticalMile);
}
constexpr Speed operator""_mps(long double v) {
  return Speed::fromSi(static_cast<double>(v));
}
constexpr Speed operator""_kt(long double v) {
  return Speed::fromSi(static_cast<double>(v) * kMpsPerKnot);
}
constexpr Duration operator""_s(long double v) {
  return Duration::fromSi(static_cast<double>(v));
}
constexpr Angle operator""_deg(long double v) {
  return Angle::degrees(static_cast<double>(v));
}
constexpr Angle operator""_rad(long double v) {
  return Angle::radians(static_cast<double>(v));
}
}  // namespace literals

}  // namespace vp
