// Where an airspace lies, for drawing.
#include "ui/document/situation.h"

#include <algorithm>

namespace vp::document {
namespace {

double heightOf(const mission::AirspaceLimit& limit, double ground, double otherwise) {
  switch (limit.kind) {
    case mission::AirspaceLimit::Kind::Msl:
    case mission::AirspaceLimit::Kind::FlightLevel:
      return limit.metres;
    case mission::AirspaceLimit::Kind::AboveGround:
      return ground + limit.metres;
    default:
      return otherwise;
  }
}

}  // namespace

bool isInside(const ShownAirspace& shown, geo::Point point) {
  bool inside = false;
  for (std::size_t i = 0, k = shown.outline.size() - 1; i < shown.outline.size(); k = i++) {
    const geo::Point a = shown.outline[i];
    const geo::Point b = shown.outline[k];
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

double airspaceTop(const mission::Airspace& airspace, double ground, double highest) {
  return std::min(heightOf(airspace.ceiling, ground, highest), highest);
}

double airspaceBottom(const mission::Airspace& airspace, double ground, double lowest) {
  return std::max(heightOf(airspace.floor, ground, lowest), lowest);
}

ShownAirspace shownAirspace(mission::Airspace airspace, const mission::AirspaceSettings& settings, const geo::LocalFrame& frame) {
  ShownAirspace shown{std::move(airspace), {}, {}};
  shown.use = mission::useOf(shown.airspace, settings);
  std::transform(shown.airspace.outline.begin(), shown.airspace.outline.end(), std::back_inserter(shown.outline),
                 [&](const geo::LatLon& corner) { return frame.toPoint(corner); });
  return shown;
}

}  // namespace vp::document
