#include "core/landing/safe_altitude_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::landing {

float SafeAltitudeField::at(int column, int row, int heading) const {
  const auto cellIndex = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  return altitude[cellIndex * static_cast<std::size_t>(headings) + static_cast<std::size_t>(heading)];
}

float SafeAltitudeField::worst(int column, int row) const {
  float value = at(column, row, 0);
  for (int h = 1; h < headings; ++h) {
    value = std::max(value, at(column, row, h));
  }
  return value;
}

float SafeAltitudeField::best(int column, int row) const {
  float value = at(column, row, 0);
  for (int h = 1; h < headings; ++h) {
    value = std::min(value, at(column, row, h));
  }
  return value;
}

Result<SafeAltitudeField> safeAltitudeField(const World& world, const Roadmap& roadmap, const geo::Box& area, int cells, int headings,
                                            const Job& job) {
  SafeAltitudeField field;
  const double width = area.maxX - area.minX;
  const double height = area.maxY - area.minY;
  field.originX = area.minX;
  field.originY = area.minY;
  field.cell = std::max(std::max(width, height) / std::max(cells, 1), world.terrain.grid().cellSize());
  field.columns = std::max(1, static_cast<int>(std::ceil(width / field.cell)));
  field.rows = std::max(1, static_cast<int>(std::ceil(height / field.cell)));
  field.headings = std::max(1, headings);
  field.altitude.reserve(static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows) * static_cast<std::size_t>(field.headings));
  QueryScratch scratch;
  int hint = -1;  // the answer of the neighbouring cell and heading
  for (int row = 0; row < field.rows; ++row) {
    job.progress(static_cast<double>(row) / field.rows, "lowest safe altitudes");
    for (int column = 0; column < field.columns; ++column) {
      if (job.stopRequested()) {
        return fail(Errc::Cancelled, "stopped");
      }
      const geo::Point centre{field.originX + (column + 0.5) * field.cell, field.originY + (row + 0.5) * field.cell};
      const bool known = world.terrain.grid().isKnownAt(centre);
      for (int h = 0; h < field.headings; ++h) {
        const geo::Pose pose{centre.x, centre.y, 2.0 * Angle::kPi * h / field.headings};
        const std::optional<SafeAltitude> answer = known ? roadmap.query(world, pose, scratch, hint) : std::nullopt;
        field.altitude.push_back(answer ? static_cast<float>(answer->altitude) : std::numeric_limits<float>::infinity());
        hint = answer ? answer->node : hint;
      }
    }
  }
  return field;
}

}  // namespace vp::landing
