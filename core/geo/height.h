#pragma once

#include "core/base/quantity.h"

namespace vp::geo {

struct Msl {};          ///< above mean sea level, the datum of the terrain file
struct AboveGround {};  ///< above the terrain at the same place

/** A height over a named datum. Differences within one datum are lengths; across datums nothing compiles. */
template <typename Datum>
class Height {
public:
  constexpr Height() = default;
  static constexpr Height fromMetres(double metres) { return Height(metres); }
  [[nodiscard]] constexpr double metres() const { return metres_; }
  [[nodiscard]] constexpr double feet() const { return metres_ / kMetresPerFoot; }

  constexpr auto operator<=>(const Height&) const = default;
  constexpr Height operator+(Length d) const { return Height(metres_ + d.si()); }
  constexpr Height operator-(Length d) const { return Height(metres_ - d.si()); }
  constexpr Length operator-(Height o) const { return Length::fromSi(metres_ - o.metres_); }

private:
  constexpr explicit Height(double metres) : metres_(metres) {}
  double metres_ = 0.0;
};

using HeightMsl = Height<Msl>;
using HeightAgl = Height<AboveGround>;

}  // namespace vp::geo
