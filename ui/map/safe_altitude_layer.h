#pragma once

#include "core/landing/safe_altitude_field.h"
#include "ui/map/raster_sampling.h"
#include "ui/style/units.h"

#include <optional>
#include <vector>

namespace vp::map {

/** The safe-altitude field for one course as a raster to draw: its border cells repeated once outwards, so that
 *  interpolation reaches the edge. */
class SafeAltitudeLayer {
public:
  /** @param trueCourse_deg  course flown; the higher of the two headings around it counts. Nothing: the highest of all */
  SafeAltitudeLayer(const landing::SafeAltitudeField& field, std::optional<double> trueCourse_deg);

  [[nodiscard]] Raster raster() const { return {originX_, originY_, cell_, columns_, rows_, values_.data()}; }
  [[nodiscard]] geo::Box box() const;                      ///< that the field covers
  [[nodiscard]] bool isEmpty() const { return !known_; }   ///< no glide anywhere
  [[nodiscard]] double lowest() const { return lowest_; }  ///< m MSL, of the cells with a glide
  [[nodiscard]] double highest() const { return highest_; }

  /** Position in the range, 0..1, for the colour scale. */
  [[nodiscard]] double fractionOf(double altitude) const;
  /** Contour interval [m]: a round height of the units that gives about ten lines. */
  [[nodiscard]] double interval(style::UnitSystem units) const;
  /** Interpolated altitude [m MSL]; nothing where there is no glide or no field. */
  [[nodiscard]] std::optional<double> at(geo::Point place) const;

private:
  [[nodiscard]] float cellAt(int column, int row) const;

  double originX_ = 0.0;
  double originY_ = 0.0;
  double cell_ = 1.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> values_;
  bool known_ = false;
  double lowest_ = 0.0;
  double highest_ = 0.0;
};

}  // namespace vp::map
