#pragma once

#include "core/emergency/descent_flight.h"
#include "core/emergency/dubins_ways.h"
#include "core/emergency/landing_request.h"
#include "core/landing/approach.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace vp::emergency {

/** Of the ways to one runway that planners offer the one of least risk that can be flown: altitudes by one share of the range of slopes, clear of the
 *  ground, the approach behind it. Without a risk, of two ways that whose descent is nearer to the optimal one.
 *  @threads as DescentFlight; request, flight and approach outlive it */
class BestDescent {
public:
  BestDescent(const LandingRequest& request, DescentFlight& flight, const landing::Approach& approach)
      : request_(&request), flight_(&flight), approach_(&approach) {}

  /** A way from the request's pose to the gate. @return whether it is the best so far */
  bool offer(const Pieces& pieces);

  /** Risk of pieces flown from a pose with a share of the range of slopes; 0 without a risk. @param pose, altitude  become the end */
  double riskAlong(geo::Pose& pose, double& altitude, const Pieces& pieces, double share);
  /** Whether a way that risks so much, or a little less with another share, could be the best: else there is no need to offer it. */
  [[nodiscard]] bool isWorthOffering(double risk) const { return request_->risk == nullptr || surplus_ > 0.0 || risk < kEstimate * risk_; }

  [[nodiscard]] const std::optional<mission::LandingPath>& path() const { return path_; }
  /** As LandingRequest::risk has it [its unit]; infinity without a path. */
  [[nodiscard]] double risk() const { return risk_; }
  /** Height over the lowest at the gate that could not be lost [m]. */
  [[nodiscard]] double surplus() const { return surplus_; }
  [[nodiscard]] std::int64_t offered() const { return offered_; }

private:
  /// By how much the risk at the optimal slope may be above that at another: heights differ by some hundredths where the range of slopes is narrow.
  static constexpr double kEstimate = 1.05;

  const LandingRequest* request_;
  DescentFlight* flight_;
  const landing::Approach* approach_;
  std::optional<mission::LandingPath> path_;
  double risk_ = std::numeric_limits<double>::infinity();
  double surplus_ = std::numeric_limits<double>::infinity();
  std::int64_t offered_ = 0;
};

}  // namespace vp::emergency
