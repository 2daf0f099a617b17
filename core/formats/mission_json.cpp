// Mission to JSON and back. The limits here are also in resources/schema/mission.schema.json.
#include "core/formats/mission_json.h"

#include "core/formats/aircraft_file.h"
#include "core/formats/aircraft_json.h"
#include "core/formats/airspace/airspace_json.h"
#include "core/formats/limits.h"
#include "core/formats/settings_json.h"
#include "core/formats/weather_json.h"
#include "core/formats/wind_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::formats {
namespace {

using mission::Mission;

const std::vector<std::string> kReferences{"agl", "msl"};
const std::vector<std::string> kSurfaces{"unknown", "hard", "gravel", "grass", "dirt", "water", "snow"};
const std::vector<std::string> kMethods{"lazy", "base"};
const std::vector<std::string> kLowTargets{"passAbove", "descend"};
const std::vector<std::string> kTourSolvers{"builtin", "lkh"};
const std::vector<std::string> kRoadmaps{"lattice", "rrtstar"};
const std::vector<std::string> kRefines{"none", "full"};

constexpr Range kLatitude{-90.0, 90.0, "degrees"};
constexpr Range kLongitude{-180.0, 180.0, "degrees"};
constexpr Range kHeight{-500.0, 20000.0, "m"};  // lowest land is -430 m, the Dead Sea's shore
constexpr Range kCourse{0.0, 360.0, "degrees"};
constexpr Range kRunway{0.0, 30000.0, "m", true};

template <typename Enum>
std::string wordOf(Enum value, const std::vector<std::string>& words) {
  return words.at(static_cast<std::size_t>(value));
}

JsonValue filterToJson(const mission::SiteFilter& filter) {
  JsonValue json = JsonValue::object();
  json.set("approximate", filter.approximate);
  json.set("water", filter.water);
  json.set("closed", filter.closed);
  if (filter.minLength) {
    json.set("minLength_m", filter.minLength->si());
  }
  json.set("exclude", JsonValue::strings(filter.exclude));
  json.set("oneWay", JsonValue::strings(filter.oneWay));
  if (filter.minWidth) {
    json.set("minWidth_m", filter.minWidth->si());
  }
  if (!filter.surfaces.empty()) {
    JsonValue surfaces = JsonValue::array();
    for (const mission::Surface surface : filter.surfaces) {
      surfaces.push(wordOf(surface, kSurfaces));
    }
    json.set("surfaces", std::move(surfaces));
  }
  if (filter.lighted) {
    json.set("lighted", true);
  }
  if (filter.maxDistance) {
    json.set("maxDistance_m", filter.maxDistance->si());
  }
  if (filter.distanceFrom) {
    JsonValue from = JsonValue::object();
    from.set("latitude_deg", filter.distanceFrom->latitude_deg);
    from.set("longitude_deg", filter.distanceFrom->longitude_deg);
    json.set("distanceFrom", std::move(from));
  }
  if (!filter.notes.empty()) {
    JsonValue notes = JsonValue::array();
    for (const mission::SiteNote& note : filter.notes) {
      JsonValue item = JsonValue::object();
      item.set("site", note.site);
      item.set("text", note.text);
      notes.push(std::move(item));
    }
    json.set("notes", std::move(notes));
  }
  return json;
}

JsonValue plannerToJson(const mission::PlannerSettings& planner) {
  JsonValue json = JsonValue::object();
  json.set("headings", planner.headings);
  json.set("step_m", planner.step.si());
  json.set("method", wordOf(planner.method, kMethods));
  json.set("seed", planner.seed);
  json.set("roadmap", wordOf(planner.roadmap, kRoadmaps));
  if (planner.roadmapSamples) {
    json.set("roadmapSamples", *planner.roadmapSamples);
  }
  if (planner.roadmapTime) {
    json.set("roadmapTime_s", planner.roadmapTime->si());
  }
  json.set("beta", planner.beta);
  json.set("lowTargets", wordOf(planner.lowTargets, kLowTargets));
  json.set("tourSolver", wordOf(planner.tourSolver, kTourSolvers));
  json.set("refine", wordOf(planner.refine, kRefines));
  return json;
}

void readSurfaces(ObjectReader& reader, mission::SiteFilter& filter) {
  for (const std::string& word : reader.names("surfaces")) {
    const auto known = std::find(kSurfaces.begin(), kSurfaces.end(), word);
    if (known == kSurfaces.end()) {
      reader.report(Errc::OutOfRange, "surfaces", fmt::format("{} is no surface; use one of {}", quoteJson(word), fmt::join(kSurfaces, ", ")));
      return;
    }
    filter.surfaces.push_back(static_cast<mission::Surface>(known - kSurfaces.begin()));
  }
}

mission::SiteFilter readFilter(ObjectReader reader) {
  mission::SiteFilter filter;
  filter.approximate = reader.flag("approximate", filter.approximate);
  filter.water = reader.flag("water", filter.water);
  filter.closed = reader.flag("closed", filter.closed);
  if (const auto length = reader.maybeNumber("minLength_m", {0.0, 30000.0, "m"})) {
    filter.minLength = Length::fromSi(*length);
  }
  filter.exclude = reader.names("exclude");
  filter.oneWay = reader.names("oneWay");
  if (const auto width = reader.maybeNumber("minWidth_m", {0.0, 1000.0, "m"})) {
    filter.minWidth = Length::fromSi(*width);
  }
  readSurfaces(reader, filter);
  filter.lighted = reader.flag("lighted", filter.lighted);
  if (const auto distance = reader.maybeNumber("maxDistance_m", {0.0, 1e7, "m", true})) {
    filter.maxDistance = Length::fromSi(*distance);
  }
  if (const JsonValue* from = reader.find("distanceFrom")) {
    ObjectReader place(*from, reader.pointerTo("distanceFrom"), reader.context());
    filter.distanceFrom = geo::LatLon{place.number("latitude_deg", kLatitude), place.number("longitude_deg", kLongitude)};
    place.finish();
  }
  for (const auto& [note, path] : reader.elements("notes")) {
    ObjectReader noteReader(*note, path, reader.context());
    filter.notes.push_back({noteReader.text("site"), noteReader.text("text", std::string())});
    noteReader.finish();
  }
  reader.finish();
  return filter;
}

std::optional<mission::HomeBase> readHome(ObjectReader& reader) {
  const JsonValue* value = reader.find("home");
  if (value == nullptr) {
    return std::nullopt;
  }
  ObjectReader inner(*value, reader.pointerTo("home"), reader.context());
  mission::HomeBase home;
  home.takeoff = inner.text("takeoff");
  home.landing = inner.has("landing") ? inner.text("landing") : home.takeoff;
  inner.finish();
  return home;
}

mission::PlannerSettings readPlanner(ObjectReader reader) {
  mission::PlannerSettings planner;
  planner.headings = static_cast<int>(reader.integer("headings", 1, 64, planner.headings));
  planner.step = Length::fromSi(reader.number("step_m", {1.0, 1000.0, "m"}, planner.step.si()));
  planner.method = static_cast<mission::Method>(reader.word("method", kMethods, static_cast<int>(planner.method)));
  planner.seed = reader.natural("seed", planner.seed);
  if (reader.has("roadmapSamples")) {
    planner.roadmapSamples = static_cast<int>(reader.integer("roadmapSamples", 1, 100'000'000));
  }
  if (const auto time = reader.maybeNumber("roadmapTime_s", {0.0, 86400.0, "s", true})) {
    planner.roadmapTime = Duration::fromSi(*time);
  }
  // Files without the word are older than the lattice: those that say how long to sample mean RRT*. The same in missions and
  // plans, so that a plan and the mission that it was made from go on to agree.
  planner.roadmap = planner.roadmapSamples || planner.roadmapTime ? mission::RoadmapKind::RrtStar : planner.roadmap;
  planner.roadmap = static_cast<mission::RoadmapKind>(reader.word("roadmap", kRoadmaps, static_cast<int>(planner.roadmap)));
  planner.beta = reader.number("beta", {2.0, 1000.0}, planner.beta);
  planner.lowTargets = static_cast<mission::LowTargets>(reader.word("lowTargets", kLowTargets, static_cast<int>(planner.lowTargets)));
  planner.tourSolver = static_cast<mission::TourSolver>(reader.word("tourSolver", kTourSolvers, static_cast<int>(planner.tourSolver)));
  planner.refine = static_cast<mission::Refine>(reader.word("refine", kRefines, static_cast<int>(planner.refine)));
  reader.finish();
  return planner;
}

mission::AirfieldSource readSource(const JsonValue& value, const std::string& pointer, ReadContext& context) {
  ObjectReader reader(value, pointer, context);
  mission::AirfieldSource source{reader.path("airports"), reader.path("runways", std::string())};
  reader.finish();
  return source;
}

void readAircraftField(Mission& mission, ObjectReader& reader, MissionPlace place, const std::string& folder) {
  const JsonValue* value = reader.require("aircraft");
  if (place == MissionPlace::Plan) {
    mission.aircraftReference = reader.path("aircraftReference", std::string());
  }
  if (value == nullptr || reader.context().error()) {
    return;
  }
  const auto* reference = value->as<std::string>();
  if (reference == nullptr || place == MissionPlace::Plan) {
    if (value->as<JsonValue::Object>() == nullptr) {
      reader.report(Errc::BadFormat, "aircraft",
                    fmt::format("must be {}a profile in braces {{...}}, not {}", place != MissionPlace::Plan ? "the name of an aircraft or " : "",
                                value->describe()));
      return;
    }
    mission.aircraft = readAircraftObject(*value, reader.pointerTo("aircraft"), reader.context(), false);
    return;
  }
  mission.aircraftReference = *reference;
  Result<aircraft::AircraftProfile> found = findAircraft(*reference, folder);
  if (found) {
    mission.aircraft = std::move(*found);
  } else {
    reader.report(found.error().code, "aircraft", found.error().message());  // names both: who asks for the profile, and what is wrong with it
  }
}

void refuseTooMany(std::size_t count, std::size_t most, const char* list, ObjectReader& reader) {
  if (count > most) {
    reader.report(Errc::OutOfRange, list, fmt::format("{} are too many; a mission has {} at most", count, most));
  }
}

template <typename Item>
void refuseTwice(const std::vector<Item>& items, std::string Item::*name, const std::string& list, const char* field, ObjectReader& reader) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!seen.insert(items[i].*name).second) {
      reader.report(Errc::OutOfRange, fmt::format("{}/{}/{}", list, i, field),
                    fmt::format("{} is given twice; names must differ", quoteJson(items[i].*name)));
      return;
    }
  }
}

}  // namespace

JsonValue siteToJson(const mission::LandingSite& site) {
  JsonValue json = JsonValue::object();
  json.set("id", site.id);
  json.set("airport", site.airportIdent);
  json.set("name", site.airportName);
  json.set("runway", site.runwayIdent);
  json.set("latitude_deg", site.touchdown.latitude_deg);
  json.set("longitude_deg", site.touchdown.longitude_deg);
  json.set("elevation_m", site.elevation.metres());
  writeAngle(json, "landingCourse", site.landingCourse);
  if (site.length) {
    json.set("length_m", site.length->si());
  }
  if (site.width) {
    json.set("width_m", site.width->si());
  }
  json.set("surface", wordOf(site.surface, kSurfaces));
  json.set("lighted", site.lighted);
  if (!site.approximations.empty()) {
    json.set("approximations", JsonValue::strings(site.approximations));
  }
  if (!site.source.empty()) {
    json.set("source", site.source);
  }
  return json;
}

JsonValue targetToJson(const mission::Target& target) {
  JsonValue json = JsonValue::object();
  json.set("name", target.name);
  json.set("latitude_deg", target.position.latitude_deg);
  json.set("longitude_deg", target.position.longitude_deg);
  json.set("height_m", target.height_m);
  json.set("reference", wordOf(target.reference, kReferences));
  return json;
}

JsonValue missionToJson(const Mission& mission, MissionPlace place) {
  JsonValue json = JsonValue::object();
  if (place != MissionPlace::Plan) {
    json.set("format", kMissionFormat);
    json.set("version", 1);
  }
  json.set("name", mission.name);
  json.set("terrain", JsonValue::strings(mission.terrain));
  JsonValue airfields = JsonValue::array();
  for (const mission::AirfieldSource& source : mission.airfields) {
    JsonValue files = JsonValue::object();
    files.set("airports", source.airports);
    if (!source.runways.empty()) {
      files.set("runways", source.runways);
    }
    airfields.push(std::move(files));
  }
  json.set("airfields", std::move(airfields));
  JsonValue sites = JsonValue::array();
  for (const mission::LandingSite& site : mission.sites) {
    sites.push(siteToJson(site));
  }
  json.set("landingSites", std::move(sites));
  json.set("siteFilter", filterToJson(mission.siteFilter));
  if (place != MissionPlace::Plan && !mission.aircraftReference.empty()) {
    json.set("aircraft", mission.aircraftReference);
  } else {
    if (place == MissionPlace::Plan) {
      json.set("aircraftReference", mission.aircraftReference);
    }
    json.set("aircraft", aircraftToJson(mission.aircraft));
  }
  JsonValue targets = JsonValue::array();
  for (const mission::Target& target : mission.targets) {
    targets.push(targetToJson(target));
  }
  json.set("targets", std::move(targets));
  if (mission.home) {
    JsonValue home = JsonValue::object();
    home.set("takeoff", mission.home->takeoff);
    home.set("landing", mission.home->landing);
    json.set("home", std::move(home));
  }
  if (mission.ceiling) {
    json.set("ceiling_m", mission.ceiling->metres());
  }
  json.set("safety", safetyToJson(mission.safety));
  json.set("planner", plannerToJson(mission.planner));
  if (!(mission.airspace == mission::AirspaceSettings())) {
    json.set("airspace", airspaceSettingsToJson(mission.airspace));
  }
  if (!mission.wind.empty()) {
    json.set("wind", windToJson(mission.wind));
  }
  writeSettings(json, mission);
  if (!mission.weather.empty()) {
    json.set("weather", weatherToJson(mission.weather));
  }
  if (!mission.populationFiles.empty()) {
    json.set("population", JsonValue::strings(mission.populationFiles));
  }
  return json;
}

mission::LandingSite readSite(ObjectReader& reader) {
  mission::LandingSite site;
  site.id = reader.text("id");
  site.airportIdent = reader.text("airport", std::string());
  site.airportName = reader.text("name", std::string());
  site.runwayIdent = reader.text("runway", std::string());
  site.touchdown = {reader.number("latitude_deg", kLatitude), reader.number("longitude_deg", kLongitude)};
  site.elevation = geo::HeightMsl::fromMetres(reader.number("elevation_m", {-500.0, 9000.0, "m"}));
  site.landingCourse = reader.angle("landingCourse", kCourse);
  if (const auto length = reader.maybeNumber("length_m", kRunway)) {
    site.length = Length::fromSi(*length);
  }
  if (const auto width = reader.maybeNumber("width_m", kRunway)) {
    site.width = Length::fromSi(*width);
  }
  site.surface = static_cast<mission::Surface>(reader.word("surface", kSurfaces, 0));
  site.lighted = reader.flag("lighted", false);
  site.approximations = reader.texts("approximations");
  site.source = reader.text("source", std::string());
  reader.finish();
  return site;
}

mission::Target readTarget(ObjectReader& reader) {
  mission::Target target;
  target.name = reader.text("name");
  target.position = {reader.number("latitude_deg", kLatitude), reader.number("longitude_deg", kLongitude)};
  target.height_m = reader.number("height_m", kHeight, target.height_m);
  target.reference = static_cast<mission::HeightReference>(reader.word("reference", kReferences, static_cast<int>(target.reference)));
  reader.finish();
  return target;
}

Mission readMissionObject(const JsonValue& value, const std::string& pointer, ReadContext& context, MissionPlace place, const std::string& folder) {
  Mission mission;
  ObjectReader reader(value, pointer, context);
  if (place != MissionPlace::Plan && !checkHeader(reader, kMissionFormat, 1)) {
    return mission;
  }
  mission.name = reader.text("name", std::string());
  reader.require("terrain");
  mission.terrain = reader.paths("terrain");
  if (mission.terrain.empty() && place == MissionPlace::File) {
    reader.report(Errc::OutOfRange, "terrain", "at least one terrain file is needed");
  }
  for (const auto& [source, path] : reader.elements("airfields")) {
    mission.airfields.push_back(readSource(*source, path, context));
  }
  for (const auto& [site, path] : reader.elements("landingSites")) {
    ObjectReader siteReader(*site, path, context);
    mission.sites.push_back(readSite(siteReader));
  }
  if (const JsonValue* filter = reader.find("siteFilter")) {
    mission.siteFilter = readFilter(ObjectReader(*filter, reader.pointerTo("siteFilter"), context));
  }
  for (const auto& [target, path] : reader.elements("targets")) {
    ObjectReader targetReader(*target, path, context);
    mission.targets.push_back(readTarget(targetReader));
  }
  mission.home = readHome(reader);
  if (const auto ceiling = reader.maybeNumber("ceiling_m", kHeight)) {
    mission.ceiling = geo::HeightMsl::fromMetres(*ceiling);
  }
  if (const JsonValue* safety = reader.find("safety")) {
    mission.safety = readSafety(ObjectReader(*safety, reader.pointerTo("safety"), context));
  }
  if (const JsonValue* planner = reader.find("planner")) {
    mission.planner = readPlanner(ObjectReader(*planner, reader.pointerTo("planner"), context));
  }
  if (const JsonValue* airspace = reader.find("airspace")) {
    mission.airspace = readAirspaceSettings(ObjectReader(*airspace, reader.pointerTo("airspace"), context));
  }
  readAircraftField(mission, reader, place, folder);
  mission.wind = readWindMember(reader);
  readSettings(reader, mission);
  mission.weather = readWeatherMember(reader);
  mission.populationFiles = reader.paths("population");
  if (place == MissionPlace::File) {
    checkWindAgainstAircraft(mission, pointer, context);
    checkSettingsAgainstAircraft(mission, pointer, context);
  }
  refuseTooMany(mission.targets.size(), kMostMissionTargets, "targets", reader);
  refuseTooMany(mission.sites.size(), kMostMissionSites, "landingSites", reader);
  refuseTwice(mission.targets, &mission::Target::name, "targets", "name", reader);
  refuseTwice(mission.sites, &mission::LandingSite::id, "landingSites", "id", reader);
  reader.finish();
  return mission;
}

}  // namespace vp::formats
