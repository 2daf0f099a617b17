#pragma once

#include "core/safety/glide_rates.h"

#include <optional>
#include <vector>

namespace vp::safety {

/** Heights along one piece of a glide that loses the most everywhere: z' = -F(distance, z), F the greatest loss per metre in the band of altitudes
 *  that z is in (WHY.md section 12). Glides that begin higher stay higher. Valid as long as the rates.  @threads one GlideRates per thread */
class Descent {
public:
  /** @param course  that the piece begins on [rad] */
  Descent(GlideRates& rates, double course, const flight::Piece& piece)
      : rates_(&rates), course_(course), piece_(piece), losses_(rates.bandCount()) {}
  /** The same loss per metre at every altitude. */
  explicit Descent(double slope) : losses_{LossAlong(slope)} {}

  /** True where what is lost depends on the altitude. */
  [[nodiscard]] bool isLayered() const { return losses_.size() > 1; }
  /** What is lost in a band of altitudes. */
  [[nodiscard]] const LossAlong& lossIn(std::size_t band);
  /** What is lost, whatever the altitude. @pre !isLayered() */
  [[nodiscard]] const LossAlong& everywhere() { return lossIn(0); }
  /** Height [m MSL] at the distance `to` of the glide that is at `height` at `from` <= to [m]; -infinity where no glide exists. */
  [[nodiscard]] double down(double from, double height, double to);
  /** Height at `from` of the glide that is at `height` at `to` >= from; infinity where no glide exists. */
  [[nodiscard]] double up(double to, double height, double from);
  /** First distance beyond this one at which the loss of some altitude may change; infinity if there is none. */
  [[nodiscard]] double nextBreak(double distance);
  /** Altitudes at which the loss changes, ascending [m MSL]. */
  [[nodiscard]] const std::vector<double>& edges() const;

private:
  GlideRates* rates_ = nullptr;
  double course_ = 0.0;
  flight::Piece piece_;
  std::vector<std::optional<LossAlong>> losses_;  // by band, as far as they were asked for
};

}  // namespace vp::safety
