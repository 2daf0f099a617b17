#include "core/risk/descent_risk.h"

#include "core/base/expect.h"
#include "core/risk/people_under.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vp::risk {

DescentRisk::DescentRisk(std::shared_ptr<const Population> population, const DescentWindow& window)
    : population_(std::move(population)), window_(window) {
  VP_EXPECT(population_ != nullptr && window.top > window.goal && window.goal >= window.ground && window.slope > 0.0 && window.airspeed > 0.0);
  const double weights = 4.0 / 27.0 * (window.top - window.goal) / (window.top - window.ground);
  const double density = population_->greatestDensity();
  scale_ = density > 0.0 ? 1.0 / (weights * density * length()) : 0.0;
}

double DescentRisk::weight(double altitude) const {
  const double left = (altitude - window_.goal) / (window_.top - window_.goal);
  return (window_.top - altitude) / (window_.top - window_.ground) * left * left;
}

double DescentRisk::of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const {
  const double high = std::max(startAltitude, endAltitude);
  const double low = std::min(startAltitude, endAltitude);
  if (!(piece.length > 0.0) || low >= window_.top || high <= window_.goal || scale_ == 0.0) {
    return 0.0;
  }
  const double slope = (endAltitude - startAltitude) / piece.length;
  // [begin, end]: where the altitude lies within the window; there the weight is of third degree along the leg
  double begin = 0.0;
  double end = piece.length;
  if (slope != 0.0) {
    const double atTop = (window_.top - startAltitude) / slope;
    const double atGoal = (window_.goal - startAltitude) / slope;
    begin = std::max(begin, std::min(atTop, atGoal));
    end = std::min(end, std::max(atTop, atGoal));
  }
  thread_local std::vector<Stretch> stretches;
  population_->along(from, piece, stretches);
  double sum = 0.0;
  for (const Stretch& stretch : stretches) {
    sum += weightedDensity(stretch, begin, end, [&](double s) { return weight(startAltitude + slope * s); });
  }
  return sum * scale_;
}

}  // namespace vp::risk
