// QGroundControl plan. All three objects stand in it, as its reader asks for; frame 0 and AltitudeMode 2: metres above mean sea
// level; speeds are whole numbers, as Mission Planner reads them so. Rally points are the runways that glides of this tour lead to,
// at the height of the mission's clearance above them, for an autopilot circles there; their altitudes are above home. Home is the
// threshold that a route with a home runway takes off from; that and the one it lands on are no items, as an autopilot would dive for them.
#include "core/formats/exports/diversions.h"
#include "core/formats/exports/writers.h"
#include "core/formats/json_value.h"

#include <cmath>

namespace vp::formats::exports {
namespace {

constexpr int kWaypointCommand = 16;
constexpr int kGlobalFrame = 0;
constexpr int kAbsoluteAltitude = 2;
constexpr int kFixedWing = 1;
constexpr int kArduPilot = 3;

/// To a tenth of a millimetre, upwards, so that feet in metres stay a short number.
double short4(double metres) {
  return std::ceil(metres * 1e4 - 1e-3) / 1e4;
}

double short7(double degrees) {
  return std::round(degrees * 1e7) / 1e7;
}

JsonValue item(const mission::RouteWaypoint& point, int number) {
  JsonValue params = JsonValue::array();
  for (int i = 0; i < 3; ++i) {
    params.push(0);
  }
  params.push(JsonValue());
  params.push(short7(point.place.latitude_deg));
  params.push(short7(point.place.longitude_deg));
  params.push(short4(point.altitude));
  JsonValue value = JsonValue::object();
  value.set("AMSLAltAboveTerrain", JsonValue());
  value.set("Altitude", short4(point.altitude));
  value.set("AltitudeMode", kAbsoluteAltitude);
  value.set("autoContinue", true);
  value.set("command", kWaypointCommand);
  value.set("doJumpId", number);
  value.set("frame", kGlobalFrame);
  value.set("params", std::move(params));
  value.set("type", "SimpleItem");
  return value;
}

JsonValue numbers(std::initializer_list<double> values) {
  JsonValue list = JsonValue::array();
  for (const double value : values) {
    list.push(value);
  }
  return list;
}

JsonValue missionObject(const ExportInput& input, geo::LatLon home, double homeAltitude) {
  JsonValue items = JsonValue::array();
  int number = 0;
  for (const mission::RouteWaypoint* point : pointsOf(input)) {
    if (point->site < 0) {
      items.push(item(*point, ++number));
    }
  }
  JsonValue object = JsonValue::object();
  object.set("cruiseSpeed", static_cast<int>(std::lround(input.plan.mission.aircraft.bestGlideSpeed.si())));
  object.set("firmwareType", kArduPilot);
  object.set("globalPlanAltitudeMode", kAbsoluteAltitude);
  object.set("hoverSpeed", 5);
  object.set("items", std::move(items));
  object.set("plannedHomePosition", numbers({short7(home.latitude_deg), short7(home.longitude_deg), short4(homeAltitude)}));
  object.set("vehicleType", kFixedWing);
  object.set("version", 2);
  return object;
}

}  // namespace

Result<std::string> plan(const ExportInput& input) {
  const std::vector<const mission::SiteInFrame*> sites = diversionSites(input.plan);
  const mission::RouteWaypoint& first = *pointsOf(input).front();
  const bool isFirst = first.site >= 0 || sites.empty();
  const geo::LatLon home = isFirst ? first.place : sites.front()->site.touchdown;
  const double homeAltitude = isFirst ? first.altitude : sites.front()->site.elevation.metres();
  JsonValue points = JsonValue::array();
  for (const mission::SiteInFrame* site : sites) {
    const double above = site->site.elevation.metres() + input.plan.mission.safety.clearance.si() - homeAltitude;
    points.push(numbers({short7(site->site.touchdown.latitude_deg), short7(site->site.touchdown.longitude_deg), short4(above)}));
  }
  JsonValue rally = JsonValue::object();
  rally.set("points", std::move(points));
  rally.set("version", 2);
  JsonValue fence = JsonValue::object();
  fence.set("circles", JsonValue::array());
  fence.set("polygons", JsonValue::array());
  fence.set("version", 2);
  JsonValue root = JsonValue::object();
  root.set("fileType", "Plan");
  root.set("geoFence", std::move(fence));
  root.set("groundStation", "QGroundControl");
  root.set("mission", missionObject(input, home, homeAltitude));
  root.set("rallyPoints", std::move(rally));
  root.set("version", 1);
  return writeJson(root, {});
}

}  // namespace vp::formats::exports
