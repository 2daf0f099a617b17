#pragma once
// Landing requests among weather whose best way is known: walls of weather with one gap, layers, thin places.

#include "core/emergency/landing_request.h"
#include "core/risk/weather.h"
#include "tests/support/landing_cases.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::test {

inline mission::WeatherCell weatherCell(const std::vector<geo::Point>& ring, double successPerKm, std::optional<double> floor = std::nullopt,
                                        std::optional<double> top = std::nullopt) {
  const geo::LocalFrame frame(kLandingOrigin);
  mission::WeatherCell cell;
  for (const geo::Point& point : ring) {
    cell.outline.push_back(frame.toLatLon(point));
  }
  cell.floor = floor;
  cell.top = top;
  cell.success = successPerKm;
  cell.perDistance = 1000.0;
  return cell;
}

inline std::vector<geo::Point> rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

inline std::shared_ptr<const risk::Weather> weatherOf(const std::vector<mission::WeatherCell>& cells) {
  return *risk::Weather::from(cells, geo::LocalFrame(kLandingOrigin));
}

/// Flat ground at sea level, 40 x 40 km.
inline std::shared_ptr<const terrain::ElevationGrid> wideGrid() {
  return makeGrid(40000.0, 200.0, [](double, double) { return 0.0; });
}

/// From west to east over flat ground: one runway at (6000, -1000), landing eastwards, the aircraft at (-6000, 0) on an eastern course.
inline emergency::LandingRequest eastward(const mission::Mission& mission, double altitude, const std::vector<mission::WeatherCell>& cells,
                                          double course = 0.0) {
  emergency::LandingRequest request =
      landingRequest(mission, {placedSite("A/09", {6000.0, -1000.0, 0.0}, 0.0)}, wideGrid(), {-6000.0, 0.0, course}, altitude);
  request.weather = weatherOf(cells);
  return request;
}

/// A wall of weather from north to south, whatever the altitude, with a gap.
inline std::vector<mission::WeatherCell> weatherWall(double west, double east, double south, double north, double successPerKm = 0.5) {
  return {weatherCell(rectangle(west, -19000.0, east, south), successPerKm), weatherCell(rectangle(west, north, east, 19000.0), successPerKm)};
}

/// An aircraft that may come down at up to 12 degrees.
inline mission::Mission steepMission() {
  mission::Mission mission = landingMission(oneBankCessna());
  mission.aircraft.steepestDescent = Angle::degrees(12.0);
  return mission;
}

}  // namespace vp::test
