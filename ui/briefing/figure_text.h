#pragma once

#include "ui/briefing/tour_figures.h"
#include "ui/style/units.h"

#include <QString>

namespace vp::briefing {

/** Numbers for the columns of a table, whose head names the unit. Rounding as in style::Units: margins and clearances down,
 *  altitudes that are needed up, the rest to the nearest. */
class FigureText {
public:
  /** @param length  of the tour, m: short tours get distances of two decimals, others of one */
  FigureText(const style::Units& units, double length);

  [[nodiscard]] const style::Units& units() const { return units_; }
  [[nodiscard]] QString altitude(double metres) const;
  [[nodiscard]] QString needed(double metres) const;     ///< rounded up
  [[nodiscard]] QString clearance(double metres) const;  ///< rounded down
  [[nodiscard]] QString margin(double metres) const;     ///< rounded down; what the checker takes for rounding is 0
  [[nodiscard]] QString distance(double metres) const;
  [[nodiscard]] QString distanceWithUnit(double metres) const;    ///< "1.10 NM", not broken into lines
  [[nodiscard]] QString distances(double from, double to) const;  ///< "0.42–1.10"
  [[nodiscard]] QString stretch(double from, double to) const;    ///< the same, two decimals always
  [[nodiscard]] static QString time(double seconds);              ///< "4:05"
  [[nodiscard]] static QString times(double from, double to);
  [[nodiscard]] static QString trueCourse(const Track& track);      ///< "043"
  [[nodiscard]] static QString magneticCourse(const Track& track);  ///< "041", a dash where a compass is of no use
  [[nodiscard]] static QString variation(const Track& track);       ///< "3° E"
  /** "A" to "Z", "AA": how runways are called on the map. */
  [[nodiscard]] static QString letter(int index);

private:
  style::Units units_;
  int decimals_ = 1;
};

}  // namespace vp::briefing
