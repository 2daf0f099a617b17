#include "core/aircraft/glide_model.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/formats/exports/writers.h"
#include "core/formats/json_value.h"
#include "core/formats/tour_path.h"
#include "core/geo/local_frame.h"
#include "core/mission/glide_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vp::formats::exports {
namespace {

constexpr double kChordError = 0.5;  // m
constexpr const char* kHeightNote =
    "The third coordinate is metres above mean sea level, the datum of the terrain; RFC 7946 means metres above the WGS 84 ellipsoid. Use alt_msl_m.";

/// Collects features as text; a document of values would take many times the memory for the glides of a long tour.
class Features {
public:
  explicit Features(geo::LatLon origin) : frame_(origin) {}

  void point(geo::Point place, double altitude, const std::string& properties) {
    std::string coordinates;
    append(coordinates, place, altitude);
    feature("Point", coordinates, properties);
  }

  void line(const std::vector<PathPoint>& path, const std::string& properties) {
    std::string coordinates = "[";
    for (const PathPoint& place : path) {
      coordinates += coordinates.size() > 1 ? ", " : "";
      append(coordinates, place.point, place.altitude);
    }
    feature("LineString", coordinates + "]", properties);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

private:
  void append(std::string& out, geo::Point place, double altitude) const {
    const geo::LatLon where = frame_.toLatLon(place);
    fmt::format_to(std::back_inserter(out), "[{:.7f}, {:.7f}, {:.2f}]", where.longitude_deg, where.latitude_deg, altitude);
  }
  void feature(const char* type, const std::string& coordinates, const std::string& properties) {
    text_ += text_.empty() ? "\n" : ",\n";
    text_ += fmt::format(R"(    {{"type": "Feature", "properties": {{{}}}, "geometry": {{"type": "{}", "coordinates": {}}}}})", properties, type,
                         coordinates);
  }

  geo::LocalFrame frame_;
  std::string text_;
};

std::string heights(double altitude) {
  return fmt::format(R"("alt_msl_m": {:.2f}, "alt_msl_ft": {:.1f})", altitude, altitude / kMetresPerFoot);
}

/// Heights of a line, point by point, as RFC 7946 gives its third coordinate another meaning.
std::string heightLists(const std::vector<PathPoint>& path) {
  std::string metres;
  std::string feet;
  for (const PathPoint& place : path) {
    const char* separator = metres.empty() ? "" : ", ";
    fmt::format_to(std::back_inserter(metres), "{}{:.2f}", separator, place.altitude);
    fmt::format_to(std::back_inserter(feet), "{}{:.1f}", separator, place.altitude / kMetresPerFoot);
  }
  return fmt::format(R"("alt_msl_m": [{}], "alt_msl_ft": [{}])", metres, feet);
}

void addTour(const mission::Plan& plan, Features& features) {
  if (plan.tour.empty()) {
    return;
  }
  const std::vector<PathPoint> path = tourPath(plan, 0, kChordError);
  features.line(path, fmt::format(R"("kind": "tour", "length_m": {:.1f}, "certified": {}, {})", plan.metrics.length, plan.certificate.has_value(),
                                  heightLists(path)));
}

void addWaypoints(const ExportInput& input, Features& features) {
  if (input.route == nullptr) {
    return;
  }
  const geo::LocalFrame frame(input.plan.frameOrigin);
  int number = 0;
  for (const mission::RouteWaypoint* point : placesOf(input)) {
    std::string properties =
        fmt::format(R"("kind": "waypoint", "number": {}, "name": {}, {})", ++number, quoteJson(point->name), heights(point->altitude));
    properties += point->note.empty() ? "" : fmt::format(R"(, "note": {})", quoteJson(point->note));
    if (point->site >= 0) {
      properties += fmt::format(R"(, "site": {})", quoteJson(input.plan.sites.at(static_cast<std::size_t>(point->site)).site.id));
    }
    features.point(frame.toPoint(point->place), point->altitude, properties);
  }
}

/// The way from or to home as a line for each of its parts: without and with a gliding guarantee.
void addHomePath(const mission::Plan& plan, const mission::HomePath& way, const char* kind, Features& features) {
  const auto begin = static_cast<std::size_t>(std::clamp(way.guaranteed, 0, static_cast<int>(way.points.size())));
  const auto addPart = [&](std::size_t from, std::size_t end, bool isGuaranteed) {
    std::vector<PathPoint> path;
    for (std::size_t i = from; i < end && i < way.points.size(); ++i) {
      const mission::DecisionPoint& point = way.points[i];
      path.push_back({point.pose.point(), point.altitude, -1});
      if (i + 1 < end && i + 1 < way.points.size()) {
        const std::vector<geo::Point> chords = chordPoints(point.pose, point.onward, kChordError);
        for (std::size_t k = 0; k + 1 < chords.size(); ++k) {
          const double done = static_cast<double>(k + 1) / static_cast<double>(chords.size());
          path.push_back({chords[k], point.altitude + done * (way.points[i + 1].altitude - point.altitude), -1});
        }
      }
    }
    if (path.size() > 1) {
      features.line(path, fmt::format(R"("kind": "{}", "site": {}, "guaranteed": {}, {})", kind,
                                      quoteJson(plan.sites.at(static_cast<std::size_t>(way.site)).site.id), isGuaranteed, heightLists(path)));
    }
  };
  if (begin > 0) {
    addPart(0, begin + 1, false);
  }
  addPart(begin, way.points.size(), true);
}

/// A spiral: down and up again on one circle, altitude linear along each way.
void addSpirals(const mission::Plan& plan, Features& features) {
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    const auto isVisit = [&](const mission::DecisionPoint& point) { return point.target == spiral.target; };
    const auto visit = std::find_if(plan.tour.begin(), plan.tour.end(), isVisit);
    if (visit == plan.tour.end() || spiral.target < 0) {
      continue;
    }
    std::vector<PathPoint> path{{visit->pose.point(), spiral.top, -1}};
    const flight::Piece circle{spiral.turn, spiral.radius, 2.0 * Angle::kPi * spiral.radius};
    for (int turn = 0; turn < spiral.turnsDown + spiral.turnsUp; ++turn) {
      const bool down = turn < spiral.turnsDown;
      const double step = (spiral.bottom - spiral.top) / (down ? spiral.turnsDown : -spiral.turnsUp);
      const double from = path.back().altitude;
      const std::vector<geo::Point> points = chordPoints(visit->pose, circle, kChordError);
      for (std::size_t i = 0; i < points.size(); ++i) {
        path.push_back({points[i], from + step * static_cast<double>(i + 1) / static_cast<double>(points.size()), -1});
      }
    }
    features.line(path, fmt::format(R"("kind": "spiral", "target": {}, "note": "no glide is guaranteed inside the spiral", {})",
                                    quoteJson(plan.targets.at(static_cast<std::size_t>(spiral.target)).target.name), heightLists(path)));
  }
}

/// The glide from one decision point, descending as the aircraft does at best glide speed.
void addGlide(const mission::Plan& plan, const aircraft::GlideModel& model, std::size_t index, Features& features) {
  const mission::DecisionPoint& from = plan.tour[index];
  if (from.witness.site < 0) {
    return;
  }
  std::vector<PathPoint> path{{from.pose.point(), from.altitude, -1}};
  geo::Pose pose = from.pose;
  double altitude = from.altitude;
  double distance = 0.0;
  for (const flight::Piece& piece : from.witness.pieces) {
    const double loss = altitude - flight::heightAlong(model, pose, piece, altitude, piece.length);
    const std::vector<geo::Point> points = chordPoints(pose, piece, kChordError);
    for (std::size_t i = 0; i < points.size(); ++i) {
      path.push_back({points[i], altitude - loss * static_cast<double>(i + 1) / static_cast<double>(points.size()), -1});
    }
    pose = flight::endOf(pose, piece);
    altitude -= loss;
    distance += piece.length;
  }
  if (!std::isfinite(altitude)) {
    return;  // a turn in which no glide exists: an unsafe plan, and nothing to draw
  }
  const mission::LandingSite& site = plan.sites.at(static_cast<std::size_t>(from.witness.site)).site;
  features.line(
      path, fmt::format(R"("kind": "glide", "decisionPoint": {}, "site": {}, "margin_m": {:.2f}, "distance_m": {:.1f}, "arrival_msl_m": {:.2f}, {})",
                        index, quoteJson(site.id), from.altitude - from.safeAltitude, distance, altitude, heightLists(path)));
}

void addDecisionPoint(const mission::Plan& plan, std::size_t index, Features& features) {
  const mission::DecisionPoint& point = plan.tour[index];
  std::string properties = fmt::format(R"("kind": "decisionPoint", "index": {}, {}, "safe_msl_m": {:.2f}, "margin_m": {:.2f})", index,
                                       heights(point.altitude), point.safeAltitude, point.altitude - point.safeAltitude);
  if (point.target >= 0) {
    properties += fmt::format(R"(, "target": {})", quoteJson(plan.targets.at(static_cast<std::size_t>(point.target)).target.name));
  }
  features.point(point.pose.point(), point.altitude, properties);
}

}  // namespace

Result<std::string> geojson(const ExportInput& input) {
  const mission::Plan& plan = input.plan;
  Features features(plan.frameOrigin);
  addTour(plan, features);
  if (plan.departure && plan.arrival) {
    addHomePath(plan, *plan.departure, "departure", features);
    addHomePath(plan, *plan.arrival, "arrival", features);
  }
  addWaypoints(input, features);
  addSpirals(plan, features);
  for (const mission::TargetInFrame& target : plan.targets) {
    features.point(target.point, target.altitude,
                   fmt::format(R"("kind": "target", "name": {}, {})", quoteJson(target.target.name), heights(target.altitude)));
  }
  const geo::LocalFrame frame(plan.frameOrigin);
  for (const mission::SiteInFrame& site : plan.sites) {
    const double course = frame.trueCourseOf(site.pose.heading, site.pose.point()).degrees();
    features.point(site.pose.point(), site.site.elevation.metres(),
                   fmt::format(R"("kind": "site", "id": {}, "name": {}, "landingCourse_deg": {:.1f}, "approximate": {}, {})", quoteJson(site.site.id),
                               quoteJson(site.site.airportName), course, site.site.isApproximate(), heights(site.site.elevation.metres())));
  }
  if (!plan.tour.empty()) {
    const aircraft::GlideModel model(plan.mission.aircraft, mission::glideConditionsOf(plan.mission, plan.sites));
    for (std::size_t i = 0; i < plan.tour.size(); ++i) {
      addDecisionPoint(plan, i, features);
      addGlide(plan, model, i, features);
    }
  }
  return fmt::format("{{\n  \"type\": \"FeatureCollection\",\n  \"name\": {},\n  \"heightNote\": {},\n  \"features\": [{}\n  ]\n}}\n",
                     quoteJson(plan.mission.name), quoteJson(kHeightNote), features.text());
}

}  // namespace vp::formats::exports
