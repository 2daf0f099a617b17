#include "core/formats/tour_path.h"

#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>

namespace vp::formats {

std::vector<geo::Point> chordPoints(const geo::Pose& start, const flight::Piece& piece, double error) {
  constexpr double kMostParts = 10000.0;
  double parts = 1.0;
  if (piece.turn != flight::Turn::Straight) {
    const double chord = std::sqrt(8.0 * piece.radius * error);  // sagitta = chord^2 / (8 radius), an over-estimate's inverse for short arcs
    parts = std::clamp(std::ceil(piece.length / std::min(chord, piece.radius)), 1.0, kMostParts);
  }
  std::vector<geo::Point> points;
  for (int i = 1; i <= static_cast<int>(parts); ++i) {
    points.push_back(flight::poseAfter(start, piece, piece.length * i / parts).point());
  }
  return points;
}

std::vector<PathPoint> tourPath(const mission::Plan& plan, std::size_t first, double error) {
  const std::size_t count = plan.tour.size();
  VP_EXPECT(first < count);
  std::vector<PathPoint> path;
  for (std::size_t i = 0; i < count; ++i) {
    const mission::DecisionPoint& from = plan.tour[(first + i) % count];
    const mission::DecisionPoint& to = plan.tour[(first + i + 1) % count];
    path.push_back({from.pose.point(), from.altitude, from.target});
    const std::vector<geo::Point> between = chordPoints(from.pose, from.onward, error);
    for (std::size_t k = 0; k + 1 < between.size(); ++k) {  // the end is the next decision point
      const double done = static_cast<double>(k + 1) / static_cast<double>(between.size());
      path.push_back({between[k], from.altitude + done * (to.altitude - from.altitude), -1});
    }
  }
  path.push_back(path.front());
  return path;
}

}  // namespace vp::formats
