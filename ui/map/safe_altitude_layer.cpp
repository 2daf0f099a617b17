#include "ui/map/safe_altitude_layer.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr double kContours = 10.0;  // about as many lines over the range

/// Highest needed around one course: headings are evenly spread, so the two next to it.
float alongCourse(const landing::SafeAltitudeField& field, int column, int row, double trueCourse_deg) {
  const double at = wrapTwoPi(Angle::degrees(90.0 - trueCourse_deg).radians()) / (2.0 * Angle::kPi) * field.headings;
  const int below = static_cast<int>(std::floor(at + 1e-9)) % field.headings;
  const int above = static_cast<int>(std::ceil(at - 1e-9)) % field.headings;
  return std::max(field.at(column, row, below), field.at(column, row, above));
}

}  // namespace

SafeAltitudeLayer::SafeAltitudeLayer(const landing::SafeAltitudeField& field, std::optional<double> trueCourse_deg)
    : originX_(field.originX - field.cell), originY_(field.originY - field.cell), cell_(field.cell) {
  if (field.columns <= 0 || field.rows <= 0) {
    return;
  }
  columns_ = field.columns + 2;
  rows_ = field.rows + 2;
  values_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int r = 0; r < rows_; ++r) {
    const int row = std::clamp(r - 1, 0, field.rows - 1);
    for (int c = 0; c < columns_; ++c) {
      const int column = std::clamp(c - 1, 0, field.columns - 1);
      const float value = trueCourse_deg ? alongCourse(field, column, row, *trueCourse_deg) : field.worst(column, row);
      values_.push_back(value);
      if (std::isfinite(value)) {
        lowest_ = known_ ? std::min(lowest_, static_cast<double>(value)) : static_cast<double>(value);
        highest_ = known_ ? std::max(highest_, static_cast<double>(value)) : static_cast<double>(value);
        known_ = true;
      }
    }
  }
}

geo::Box SafeAltitudeLayer::box() const {
  if (columns_ == 0) {
    return {};
  }
  return {originX_ + cell_, originY_ + cell_, originX_ + (columns_ - 1) * cell_, originY_ + (rows_ - 1) * cell_};
}

double SafeAltitudeLayer::fractionOf(double altitude) const {
  return highest_ > lowest_ ? std::clamp((altitude - lowest_) / (highest_ - lowest_), 0.0, 1.0) : 0.5;
}

double SafeAltitudeLayer::interval(style::UnitSystem units) const {
  const double unit = units == style::UnitSystem::Aviation ? kMetresPerFoot : 1.0;
  for (const double round : {10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    if (round * unit * kContours >= highest_ - lowest_) {
      return round * unit;
    }
  }
  return 2000.0 * unit;
}

float SafeAltitudeLayer::cellAt(int column, int row) const {
  return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
}

std::optional<double> SafeAltitudeLayer::at(geo::Point place) const {
  if (columns_ == 0 || !box().contains(place)) {
    return std::nullopt;
  }
  const double u = (place.x - originX_) / cell_ - 0.5;
  const double v = (place.y - originY_) / cell_ - 0.5;
  const int column = std::clamp(static_cast<int>(std::floor(u)), 0, columns_ - 2);
  const int row = std::clamp(static_cast<int>(std::floor(v)), 0, rows_ - 2);
  const double s = u - column;
  const double t = v - row;
  const double value = (1.0 - t) * ((1.0 - s) * static_cast<double>(cellAt(column, row)) + s * static_cast<double>(cellAt(column + 1, row))) +
                       t * ((1.0 - s) * static_cast<double>(cellAt(column, row + 1)) + s * static_cast<double>(cellAt(column + 1, row + 1)));
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace vp::map
