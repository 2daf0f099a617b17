#pragma once

#include "core/emergency/descent_flight.h"
#include "core/emergency/landing_request.h"
#include "core/emergency/weather/altitude_intervals.h"
#include "core/flight/dubins.h"
#include "core/risk/weather.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::emergency {

/** What a metre costs in clear weather [1/m]: one flight in a hundred thousand for a nautical mile. A choice; [4] section 3.2 says only that it is
 *  "negligible compared to the cost of traversing obstacles". It keeps ways short where weather does not decide. */
inline constexpr double kClearAir = 1e-5 / 1852.0;

/** Descents in weather: what their legs meet, and the altitudes at which they meet least.
 *  @threads as DescentFlight. Request and flight outlive it */
class WeatherFlight {
public:
  WeatherFlight(const LandingRequest& request, DescentFlight& flight, std::shared_ptr<const risk::Weather> weather);

  /** -log of the probability of coming through along legs flown from a pose. */
  [[nodiscard]] double weatherAlong(const geo::Pose& pose, double altitude, const std::vector<mission::LandingLeg>& legs) const;
  [[nodiscard]] double weatherAlong(const geo::Pose& pose, const flight::Piece& piece, double altitude, double end) const {
    return risk_.of(pose, piece, altitude, end);
  }

  /** Appends the slices of a piece: cut where weather begins or ends, and every two nautical miles.
   *  @param pieces  gets the piece of each; null: not wanted */
  void slicesOf(const geo::Pose& pose, const flight::Piece& piece, const DescentRange& range, std::vector<AltitudeSlice>& slices,
                std::vector<flight::Piece>* pieces) const;

  /** The same track as given legs, at the altitudes that meet least weather, not lower than `end` at its end; HA* of [4] along one track. Ground
   * counts by the highest under each slice.
   *  @param legs  the best glide along the track   @return none: no such altitudes, or slopes leave no choice */
  [[nodiscard]] std::optional<std::vector<mission::LandingLeg>> leastWeather(const geo::Pose& pose, double altitude,
                                                                             const std::vector<mission::LandingLeg>& legs, double end);

  /** The Dubins curve between two poses, of all radii of the glide, that loses least height. */
  [[nodiscard]] flight::DubinsPath curve(const geo::Pose& from, const geo::Pose& to, double altitude) const;

  /** Whether slopes leave a choice worth a word: the steepest descent is steeper than the best glide. */
  [[nodiscard]] bool hasRoom() const { return hasRoom_; }
  [[nodiscard]] DescentFlight& descents() { return flight_; }
  [[nodiscard]] const risk::Weather& weather() const { return *risk_.weather(); }
  [[nodiscard]] const landing::World& world() const { return world_; }

private:
  const landing::World& world_;
  DescentFlight& flight_;
  risk::WeatherRisk risk_;
  bool hasRoom_ = false;
};

}  // namespace vp::emergency
