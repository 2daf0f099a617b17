#pragma once

#include "core/flight/curve.h"
#include "core/geo/pose.h"

#include <string>

namespace vp::risk {

/** What a part of a flight risks, whatever for: people under it, weather on it, or several of these together.
 *  @threads const members are pure */
class LegRisk {
public:
  virtual ~LegRisk() = default;

  /** Risk of one leg, additive over legs: that of two parts is that of the whole, but for rounding.
   *  @param from   pose over ground at its beginning, local frame
   *  @param piece  flown from there over ground
   *  @param startAltitude, endAltitude  m MSL, linear with distance between
   *  @return in unit(), >= 0, finite */
  [[nodiscard]] virtual double of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const = 0;

  /** What it is, for a pilot: "people under the path". */
  [[nodiscard]] virtual std::string name() const = 0;
  /** Of what of() answers, for example "person hours"; "" for a share. */
  [[nodiscard]] virtual std::string unit() const = 0;

protected:
  LegRisk() = default;
  LegRisk(const LegRisk&) = default;
  LegRisk(LegRisk&&) = default;
  LegRisk& operator=(const LegRisk&) = default;
  LegRisk& operator=(LegRisk&&) = default;
};

}  // namespace vp::risk
