#include "core/risk/people_under.h"

#include "core/base/expect.h"

#include <algorithm>
#include <utility>

namespace vp::risk {

PeopleUnder::PeopleUnder(std::shared_ptr<const Population> population, double airspeed, double crossover)
    : population_(std::move(population)), airspeed_(airspeed), crossover_(crossover) {
  VP_EXPECT(population_ != nullptr && airspeed_ > 0.0 && crossover_ > 0.0);
}

double PeopleUnder::of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const {
  if (std::min(startAltitude, endAltitude) >= crossover_ || !(piece.length > 0.0)) {
    return 0.0;
  }
  std::vector<Stretch> stretches;
  population_->along(from, piece, stretches);
  const double slope = (endAltitude - startAltitude) / piece.length;
  const auto weight = [&](double s) { return 1.0 - (startAltitude + slope * s) / crossover_; };
  // only the part below the crossover altitude counts; on it the weight is linear
  double begin = 0.0;
  double end = piece.length;
  if (startAltitude > crossover_) {
    begin = (crossover_ - startAltitude) / slope;
  } else if (endAltitude > crossover_) {
    end = (crossover_ - startAltitude) / slope;
  }
  double sum = 0.0;
  for (const Stretch& stretch : stretches) {
    sum += weightedDensity(stretch, begin, end, weight);
  }
  return sum * kGroundAtRisk / airspeed_;
}

}  // namespace vp::risk
