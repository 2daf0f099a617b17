#include "ui/scene3d/runway_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::scene3d {
namespace {

constexpr int kParts = 8;      // along the runway, to follow the ground
constexpr double kLift = 1.0;  // m above it

/// Lays shapes given along and across the runway on the ground.
class Draping {
public:
  Draping(const SceneRunway& runway, const TerrainModel* terrain, RunwayShape& shape) : runway_(runway), terrain_(terrain), shape_(shape) {}

  [[nodiscard]] ScenePoint at(double along, double across) const {
    const double c = std::cos(runway_.threshold.heading);
    const double s = std::sin(runway_.threshold.heading);
    const geo::Point middle{runway_.threshold.x + along * c, runway_.threshold.y + along * s};
    const double ground = terrain_ != nullptr ? terrain_->heightAt(middle).value_or(runway_.elevation) : runway_.elevation;
    return {middle.x - across * s, middle.y + across * c, std::max(ground, runway_.elevation) + kLift};
  }

  void strip(double from, double to, double halfWidth, const QColor& color) {
    for (int k = 0; k < kParts; ++k) {
      const double a = from + (to - from) * k / kParts;
      const double b = from + (to - from) * (k + 1) / kParts;
      triangle({at(a, -halfWidth), at(b, -halfWidth), at(b, halfWidth)}, color);
      triangle({at(a, -halfWidth), at(b, halfWidth), at(a, halfWidth)}, color);
    }
  }

  void triangle(const std::array<ScenePoint, 3>& corners, const QColor& color) {
    for (const ScenePoint& corner : corners) {
      shape_.triangles.push_back({corner, color});
    }
  }

private:
  const SceneRunway& runway_;
  const TerrainModel* terrain_;
  RunwayShape& shape_;
};

}  // namespace

RunwayShape runwayShape(const SceneRunway& runway, const TerrainModel* terrain, const style::ChartColors& colors) {
  RunwayShape shape;
  Draping draping(runway, terrain, shape);
  const double half = 0.5 * runway.width;
  const double edge = std::max(2.0, 0.3 * half);
  shape.width = 2.0 * (half + edge);
  shape.centre = draping.at(0.5 * runway.length, 0.0);
  QColor outline = colors.textHalo;
  outline.setAlpha(255);
  if (runway.isDestination) {
    draping.strip(-2.5 * edge, runway.length + 2.5 * edge, half + 2.5 * edge, colors.selection);
  }
  draping.strip(-edge, runway.length + edge, half + edge, outline);
  const bool isUsable = runway.usable || runway.usableBack || runway.isDestination;
  draping.strip(0.0, runway.length, half, isUsable ? colors.runway : colors.runwayExcluded);
  if (!isUsable) {
    draping.strip(edge, runway.length - edge, 0.5 * half, outline);
    return shape;
  }
  const double head = std::min(0.22 * runway.length, 6.0 * half);
  if (runway.usable || runway.isDestination) {
    draping.triangle({draping.at(0.3 * head, 0.7 * half), draping.at(0.3 * head, -0.7 * half), draping.at(1.3 * head, 0.0)}, outline);
  }
  if (runway.usableBack) {
    const double end = runway.length;
    draping.triangle({draping.at(end - 0.3 * head, 0.7 * half), draping.at(end - 0.3 * head, -0.7 * half), draping.at(end - 1.3 * head, 0.0)},
                     outline);
  }
  return shape;
}

}  // namespace vp::scene3d
