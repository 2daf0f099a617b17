#include "maps/mission_text.h"

#include "maps/deterministic.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace vp::maps {
namespace {

using Json = nlohmann::ordered_json;

/// Decimal places that a file carries: 1e-9 degree is 0.1 mm. Division by a power of ten gives the double nearest to the
/// decimal, so it prints short.
double places(double value, double perUnit) {
  return std::round(value * perUnit) / perUnit;
}

double degrees(double value) {
  return places(value, 1e9);
}

Json toJson(const SiteText& site) {
  return {{"id", site.airport + "/" + site.runway},
          {"airport", site.airport},
          {"name", site.airportName},
          {"runway", site.runway},
          {"latitude_deg", degrees(site.touchdown.latitude_deg)},
          {"longitude_deg", degrees(site.touchdown.longitude_deg)},
          {"elevation_m", places(site.elevation, 100.0)},
          {"landingCourse_deg", places(site.course_deg, 1e6)},
          {"length_m", places(site.length, 10.0)},
          {"width_m", places(site.width, 10.0)},
          {"surface", site.surface},
          {"lighted", false}};
}

Json toJson(const TargetText& target) {
  return {{"name", target.name},
          {"latitude_deg", degrees(target.position.latitude_deg)},
          {"longitude_deg", degrees(target.position.longitude_deg)},
          {"height_m", places(target.height, 10.0)},
          {"reference", "agl"}};
}

}  // namespace

SiteText siteOf(const geo::LocalFrame& frame, const Airstrip& strip, geo::Point from, geo::Point to) {
  SiteText site;
  site.airport = strip.ident;
  site.airportName = strip.name;
  site.course_deg = landingCourse(frame, from, to);
  site.runway = runwayNumber(site.course_deg);
  site.touchdown = frame.toLatLon(from);
  site.elevation = strip.elevation;
  site.length = strip.length();
  site.width = strip.width;
  site.surface = strip.surface;
  return site;
}

Result<void> writeText(const std::string& text, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) {
    return fail(Errc::OutputFailed, "cannot be written; check that the folder exists and has space", path);
  }
  return {};
}

Result<void> writeMission(const MissionText& mission, const std::string& path) {
  Json json{{"format", "volplane-mission"}, {"version", 1}, {"name", mission.name}, {"terrain", Json::array({mission.terrain})}};
  if (!mission.airports.empty()) {
    json["airfields"] = Json::array({Json{{"airports", mission.airports}, {"runways", mission.runways}}});
  }
  if (!mission.sites.empty()) {
    json["landingSites"] = Json::array();
    for (const SiteText& site : mission.sites) {
      json["landingSites"].push_back(toJson(site));
    }
  }
  json["aircraft"] = mission.aircraft;
  json["targets"] = Json::array();
  for (const TargetText& target : mission.targets) {
    json["targets"].push_back(toJson(target));
  }
  json["safety"] = {{"clearance_m", mission.clearance}, {"arrivalMargin_m", 0.0}};
  json["planner"] = {{"headings", 8}, {"step_m", mission.step}, {"seed", 1}};
  if (!mission.roadmap.empty()) {
    json["planner"]["roadmap"] = mission.roadmap;
  }
  if (mission.roadmapSamples > 0) {
    json["planner"]["roadmapSamples"] = mission.roadmapSamples;
  }
  return writeText(json.dump(2) + "\n", path);
}

}  // namespace vp::maps
