#include "core/formats/plan_file.h"

#include "core/formats/airspace/airspace_json.h"
#include "core/formats/atomic_file.h"
#include "core/formats/mission_json.h"
#include "core/formats/settings_json.h"
#include "core/formats/text_file.h"
#include "core/formats/wind_json.h"

#include <fmt/format.h>

#include <limits>

namespace vp::formats {
namespace {

using mission::Plan;

constexpr const char* kPlanFormat = "volplane-plan";

// What a number may be and still be worked with: no reader of a plan loops for ever or overflows on it.
constexpr Range kCoordinate{-1e7, 1e7, "m"};
constexpr Range kAltitude{-1e5, 1e5, "m"};
constexpr Range kLength{0.0, 1e7, "m"};
constexpr Range kRadius{0.0, 1e7, "m", true};
constexpr Range kHeading{-1e3, 1e3, "rad"};
constexpr Range kAny{};
constexpr std::int64_t kMaxCount = std::numeric_limits<std::int64_t>::max();

const std::vector<std::string> kTurns{"right", "straight", "left"};

JsonValue pieceToJson(const flight::Piece& piece) {
  JsonValue json = JsonValue::array();
  json.push(piece.turn == flight::Turn::Straight ? "S" : piece.turn == flight::Turn::Left ? "L" : "R");
  if (piece.turn != flight::Turn::Straight) {
    json.push(piece.radius);
  }
  json.push(piece.length);
  return json;
}

JsonValue poseToJson(const geo::Pose& pose) {
  return JsonValue::Array{pose.x, pose.y, pose.heading};
}

JsonValue decisionPointToJson(const mission::DecisionPoint& point) {
  JsonValue json = JsonValue::object();
  json.set("pose", poseToJson(point.pose));
  json.set("altitude_m", point.altitude);
  json.set("safeAltitude_m", point.safeAltitude);
  json.set("onward", pieceToJson(point.onward));
  JsonValue pieces = JsonValue::array();
  for (const flight::Piece& piece : point.witness.pieces) {
    pieces.push(pieceToJson(piece));
  }
  JsonValue witness = JsonValue::object();
  witness.set("site", point.witness.site);
  witness.set("pieces", std::move(pieces));
  json.set("witness", std::move(witness));
  if (point.target != -1) {
    json.set("target", point.target);
  }
  return json;
}

JsonValue spiralToJson(const mission::SpiralVisit& spiral) {
  JsonValue json = JsonValue::object();
  json.set("target", spiral.target);
  json.set("top_m", spiral.top);
  json.set("bottom_m", spiral.bottom);
  const int turn = static_cast<int>(spiral.turn) + 1;  // Right is -1
  json.set("turn", kTurns.at(static_cast<std::size_t>(turn)));
  json.set("radius_m", spiral.radius);
  json.set("turnsDown", spiral.turnsDown);
  json.set("turnsUp", spiral.turnsUp);
  return json;
}

JsonValue holdToJson(const mission::Hold& hold) {
  JsonValue json = JsonValue::object();
  json.set("site", hold.site);
  const int turn = static_cast<int>(hold.turn) + 1;  // Right is -1
  json.set("turn", kTurns.at(static_cast<std::size_t>(turn)));
  json.set("radius_m", hold.radius);
  json.set("lowest_m", hold.lowest);
  return json;
}

JsonValue homePathToJson(const mission::HomePath& path) {
  JsonValue json = JsonValue::object();
  json.set("site", path.site);
  json.set("join", path.join);
  json.set("guaranteed", path.guaranteed);
  JsonValue points = JsonValue::array();
  for (const mission::DecisionPoint& point : path.points) {
    points.push(decisionPointToJson(point));
  }
  json.set("points", std::move(points));
  return json;
}

JsonValue metricsToJson(const mission::PlanMetrics& metrics) {
  JsonValue json = JsonValue::object();
  json.set("cost_m", metrics.cost);
  json.set("length_m", metrics.length);
  json.set("penalty_m", metrics.penalty);
  json.set("lowerBound_m", metrics.lowerBound);
  json.set("optimal", metrics.optimal);
  json.set("roadmapExpansions", metrics.roadmapExpansions);
  json.set("safeQueries", metrics.safeQueries);
  json.set("tourSolutions", metrics.tourSolutions);
  json.set("safeSegments", metrics.safeSegments);
  json.set("sampledCost_m", metrics.sampledCost);
  json.set("movesTried", metrics.movesTried);
  json.set("movesAccepted", metrics.movesAccepted);
  json.set("freeLowerBound_m", metrics.freeLowerBound);
  return json;
}

JsonValue certificateToJson(const mission::Certificate& certificate) {
  JsonValue json = JsonValue::object();
  json.set("statement", certificate.statement);
  json.set("warnings", JsonValue::strings(certificate.warnings));
  JsonValue margins = JsonValue::array();
  for (const mission::Margin& margin : certificate.margins) {
    JsonValue one = JsonValue::object();
    one.set("kind", margin.kind);
    one.set("value", margin.value);
    one.set("unit", margin.unit);
    one.set("latitude_deg", margin.where.latitude_deg);
    one.set("longitude_deg", margin.where.longitude_deg);
    margins.push(std::move(one));
  }
  json.set("margins", std::move(margins));
  json.set("pointsChecked", certificate.pointsChecked);
  json.set("glidesChecked", certificate.glidesChecked);
  return json;
}

flight::Piece readPiece(const JsonValue& value, const std::string& pointer, ReadContext& context) {
  flight::Piece piece;
  const auto* parts = value.as<JsonValue::Array>();
  const auto* kind = parts != nullptr && !parts->empty() ? parts->front().as<std::string>() : nullptr;
  const bool straight = kind != nullptr && *kind == "S";
  const bool turn = kind != nullptr && (*kind == "L" || *kind == "R");
  if ((!straight && !turn) || parts->size() != (straight ? 2u : 3u)) {
    context.report(Errc::BadFormat, pointer, R"(must be ["S", length] or ["L" or "R", radius, length])");
    return piece;
  }
  if (turn) {
    piece.turn = *kind == "L" ? flight::Turn::Left : flight::Turn::Right;
    piece.radius = readNumber((*parts)[1], pointer + "/1", kRadius, context);
  }
  piece.length = readNumber(parts->back(), fmt::format("{}/{}", pointer, parts->size() - 1), kLength, context);
  return piece;
}

geo::Pose readPose(ObjectReader& reader, const std::string& name) {
  reader.require(name);
  const auto numbers = reader.elements(name);
  if (numbers.size() != 3) {
    reader.report(Errc::BadFormat, name, "must be [metres east, metres north, heading in radians]");
    return {};
  }
  ReadContext& context = reader.context();
  return {readNumber(*numbers[0].first, numbers[0].second, kCoordinate, context),
          readNumber(*numbers[1].first, numbers[1].second, kCoordinate, context),
          readNumber(*numbers[2].first, numbers[2].second, kHeading, context)};
}

/// Index into a list of `size` elements; -1 stands for none.
int readIndex(ObjectReader& reader, const std::string& name, std::size_t size, const char* list) {
  const std::int64_t index = reader.integer(name, -1, std::numeric_limits<int>::max(), -1);
  if (index >= static_cast<std::int64_t>(size)) {
    reader.report(Errc::OutOfRange, name, fmt::format("there is no element {} in {}, which has {}", index, list, size));
    return -1;
  }
  return static_cast<int>(index);
}

mission::DecisionPoint readDecisionPoint(const JsonValue& value, const std::string& pointer, ReadContext& context, const Plan& plan) {
  mission::DecisionPoint point;
  ObjectReader reader(value, pointer, context);
  point.pose = readPose(reader, "pose");
  point.altitude = reader.number("altitude_m", kAltitude);
  point.safeAltitude = reader.number("safeAltitude_m", kAltitude);
  if (const JsonValue* onward = reader.require("onward")) {
    point.onward = readPiece(*onward, reader.pointerTo("onward"), context);
  }
  if (const JsonValue* witness = reader.require("witness")) {
    ObjectReader inner(*witness, reader.pointerTo("witness"), context);
    inner.require("site");
    point.witness.site = readIndex(inner, "site", plan.sites.size(), "sites");
    inner.require("pieces");
    for (const auto& [piece, path] : inner.elements("pieces")) {
      point.witness.pieces.push_back(readPiece(*piece, path, context));
    }
    inner.finish();
  }
  point.target = readIndex(reader, "target", plan.targets.size(), "targets");
  reader.finish();
  return point;
}

mission::SpiralVisit readSpiral(const JsonValue& value, const std::string& pointer, ReadContext& context, const Plan& plan) {
  mission::SpiralVisit spiral;
  ObjectReader reader(value, pointer, context);
  reader.require("target");
  spiral.target = readIndex(reader, "target", plan.targets.size(), "targets");
  spiral.top = reader.number("top_m", kAltitude);
  spiral.bottom = reader.number("bottom_m", kAltitude);
  spiral.turn = static_cast<flight::Turn>(reader.word("turn", kTurns, -1) - 1);
  spiral.radius = reader.number("radius_m", kRadius);
  spiral.turnsDown = static_cast<int>(reader.integer("turnsDown", 0, 10000));
  spiral.turnsUp = static_cast<int>(reader.integer("turnsUp", 0, 10000));
  reader.finish();
  return spiral;
}

mission::Hold readHold(const JsonValue& value, const std::string& pointer, ReadContext& context, const Plan& plan) {
  mission::Hold hold;
  ObjectReader reader(value, pointer, context);
  reader.require("site");
  hold.site = readIndex(reader, "site", plan.sites.size(), "sites");
  hold.turn = static_cast<flight::Turn>(reader.word("turn", kTurns, -1) - 1);
  hold.radius = reader.number("radius_m", kRadius);
  hold.lowest = reader.number("lowest_m", kAltitude);
  reader.finish();
  return hold;
}

mission::HomePath readHomePath(ObjectReader reader, const Plan& plan) {
  mission::HomePath path;
  reader.require("site");
  path.site = readIndex(reader, "site", plan.sites.size(), "sites");
  reader.require("join");
  path.join = readIndex(reader, "join", plan.tour.size(), "tour");
  path.guaranteed = static_cast<int>(reader.integer("guaranteed", 0, std::numeric_limits<int>::max(), 0));
  reader.require("points");
  for (const auto& [value, pointer] : reader.elements("points")) {
    path.points.push_back(readDecisionPoint(*value, pointer, reader.context(), plan));
    if (reader.context().error()) {
      return path;
    }
  }
  reader.finish();
  return path;
}

mission::PlanMetrics readMetrics(ObjectReader reader) {
  mission::PlanMetrics metrics;
  metrics.cost = reader.number("cost_m", kAny, metrics.cost);
  metrics.length = reader.number("length_m", kAny, metrics.length);
  metrics.penalty = reader.number("penalty_m", kAny, metrics.penalty);
  metrics.lowerBound = reader.number("lowerBound_m", kAny, metrics.lowerBound);
  metrics.optimal = reader.flag("optimal", metrics.optimal);
  metrics.roadmapExpansions = reader.integer("roadmapExpansions", 0, kMaxCount, 0);
  metrics.safeQueries = reader.integer("safeQueries", 0, kMaxCount, 0);
  metrics.tourSolutions = reader.integer("tourSolutions", 0, kMaxCount, 0);
  metrics.safeSegments = reader.integer("safeSegments", 0, kMaxCount, 0);
  metrics.sampledCost = reader.number("sampledCost_m", kAny, metrics.sampledCost);
  metrics.movesTried = reader.integer("movesTried", 0, kMaxCount, 0);
  metrics.movesAccepted = reader.integer("movesAccepted", 0, kMaxCount, 0);
  metrics.freeLowerBound = reader.number("freeLowerBound_m", kAny, metrics.freeLowerBound);
  reader.finish();
  return metrics;
}

geo::LatLon readPlace(ObjectReader& reader) {
  return {reader.number("latitude_deg", {-90.0, 90.0, "degrees"}), reader.number("longitude_deg", {-180.0, 180.0, "degrees"})};
}

mission::Certificate readCertificate(ObjectReader reader) {
  mission::Certificate certificate;
  certificate.statement = reader.text("statement", std::string());
  certificate.warnings = reader.texts("warnings");
  for (const auto& [value, pointer] : reader.elements("margins")) {
    ObjectReader inner(*value, pointer, reader.context());
    mission::Margin margin;
    margin.kind = inner.text("kind", std::string());
    margin.value = inner.number("value", kAny);
    margin.unit = inner.text("unit", std::string());
    margin.where = readPlace(inner);
    inner.finish();
    certificate.margins.push_back(std::move(margin));
  }
  certificate.pointsChecked = reader.integer("pointsChecked", 0, kMaxCount, 0);
  certificate.glidesChecked = reader.integer("glidesChecked", 0, kMaxCount, 0);
  reader.finish();
  return certificate;
}

/// Frame, terrain, sites and targets: what the tour refers to.
void readGround(Plan& plan, ObjectReader& reader) {
  ReadContext& context = reader.context();
  if (const JsonValue* origin = reader.require("frameOrigin")) {
    ObjectReader inner(*origin, reader.pointerTo("frameOrigin"), context);
    plan.frameOrigin = readPlace(inner);
    inner.finish();
  }
  plan.terrainCell = reader.number("terrainCell_m", {0.0, 100000.0, "m"});
  reader.require("terrain");
  for (const auto& [value, pointer] : reader.elements("terrain")) {
    ObjectReader inner(*value, pointer, context);
    plan.terrain.push_back({inner.path("path"), inner.text("sha256", std::string())});
    inner.finish();
  }
  reader.require("sites");
  for (const auto& [value, pointer] : reader.elements("sites")) {
    ObjectReader inner(*value, pointer, context);
    mission::SiteInFrame site;
    site.pose = readPose(inner, "pose");
    site.site = readSite(inner);
    plan.sites.push_back(std::move(site));
  }
  reader.require("targets");
  for (const auto& [value, pointer] : reader.elements("targets")) {
    ObjectReader inner(*value, pointer, context);
    mission::TargetInFrame target;
    target.point = {inner.number("x_m", kCoordinate), inner.number("y_m", kCoordinate)};
    target.altitude = inner.number("altitude_m", kAltitude);
    target.target = readTarget(inner);
    plan.targets.push_back(std::move(target));
  }
}

Plan readPlanObject(const JsonValue& json, ReadContext& context, const std::string& path) {
  Plan plan;
  ObjectReader reader(json, "", context);
  if (!checkHeader(reader, kPlanFormat, 1)) {
    return plan;
  }
  plan.createdBy = reader.text("createdBy", std::string());
  if (const JsonValue* mission = reader.require("mission")) {
    plan.mission = readMissionObject(*mission, "/mission", context, MissionPlace::Plan, path);
    checkWindAgainstAircraft(plan.mission, "/mission", context);
    checkSettingsAgainstAircraft(plan.mission, "/mission", context);
  }
  readGround(plan, reader);
  reader.require("tour");
  for (const auto& [value, pointer] : reader.elements("tour")) {
    plan.tour.push_back(readDecisionPoint(*value, pointer, context, plan));
    if (context.error()) {
      return plan;
    }
  }
  for (const auto& [value, pointer] : reader.elements("spirals")) {
    plan.spirals.push_back(readSpiral(*value, pointer, context, plan));
  }
  for (const auto& [value, pointer] : reader.elements("holds")) {
    plan.holds.push_back(readHold(*value, pointer, context, plan));
  }
  if (const JsonValue* departure = reader.find("departure")) {
    plan.departure = readHomePath(ObjectReader(*departure, "/departure", context), plan);
  }
  if (const JsonValue* arrival = reader.find("arrival")) {
    plan.arrival = readHomePath(ObjectReader(*arrival, "/arrival", context), plan);
  }
  for (const auto& [value, pointer] : reader.elements("airspaces")) {
    plan.airspaces.push_back(readAirspace(ObjectReader(*value, pointer, context)));
  }
  if (const JsonValue* metrics = reader.find("metrics")) {
    plan.metrics = readMetrics(ObjectReader(*metrics, "/metrics", context));
  }
  if (const JsonValue* certificate = reader.find("certificate")) {
    plan.certificate = readCertificate(ObjectReader(*certificate, "/certificate", context));
  }
  reader.finish();
  return plan;
}

JsonValue groundToJson(const Plan& plan, JsonValue json) {
  JsonValue origin = JsonValue::object();
  origin.set("latitude_deg", plan.frameOrigin.latitude_deg);
  origin.set("longitude_deg", plan.frameOrigin.longitude_deg);
  json.set("frameOrigin", std::move(origin));
  json.set("terrainCell_m", plan.terrainCell);
  JsonValue terrain = JsonValue::array();
  for (const mission::TerrainReference& file : plan.terrain) {
    JsonValue one = JsonValue::object();
    one.set("path", file.path);
    one.set("sha256", file.sha256);
    terrain.push(std::move(one));
  }
  json.set("terrain", std::move(terrain));
  JsonValue sites = JsonValue::array();
  for (const mission::SiteInFrame& site : plan.sites) {
    JsonValue one = siteToJson(site.site);
    one.set("pose", poseToJson(site.pose));
    sites.push(std::move(one));
  }
  json.set("sites", std::move(sites));
  JsonValue targets = JsonValue::array();
  for (const mission::TargetInFrame& target : plan.targets) {
    JsonValue one = targetToJson(target.target);
    one.set("x_m", target.point.x);
    one.set("y_m", target.point.y);
    one.set("altitude_m", target.altitude);
    targets.push(std::move(one));
  }
  json.set("targets", std::move(targets));
  return json;
}

}  // namespace

std::string planToJson(const Plan& plan) {
  JsonValue json = JsonValue::object();
  json.set("format", kPlanFormat);
  json.set("version", 1);
  json.set("createdBy", plan.createdBy);
  json.set("mission", missionToJson(plan.mission, MissionPlace::Plan));
  json = groundToJson(plan, std::move(json));
  JsonValue tour = JsonValue::array();
  for (const mission::DecisionPoint& point : plan.tour) {
    tour.push(decisionPointToJson(point));
  }
  json.set("tour", std::move(tour));
  JsonValue spirals = JsonValue::array();
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    spirals.push(spiralToJson(spiral));
  }
  json.set("spirals", std::move(spirals));
  if (!plan.holds.empty()) {
    JsonValue holds = JsonValue::array();
    for (const mission::Hold& hold : plan.holds) {
      holds.push(holdToJson(hold));
    }
    json.set("holds", std::move(holds));
  }
  if (plan.departure) {
    json.set("departure", homePathToJson(*plan.departure));
  }
  if (plan.arrival) {
    json.set("arrival", homePathToJson(*plan.arrival));
  }
  if (!plan.airspaces.empty()) {
    JsonValue airspaces = JsonValue::array();
    for (const mission::Airspace& airspace : plan.airspaces) {
      airspaces.push(airspaceToJson(airspace));
    }
    json.set("airspaces", std::move(airspaces));
  }
  json.set("metrics", metricsToJson(plan.metrics));
  if (plan.certificate) {
    json.set("certificate", certificateToJson(*plan.certificate));
  }
  return writeJson(
      json,
      {120, {"terrain", "sites", "targets", "landingSites", "airfields", "tour", "points", "spirals", "holds", "airspaces", "margins", "warnings"}});
}

Result<Plan> readPlan(const std::string& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  return parsePlan(*text, path);
}

Result<Plan> parsePlan(const std::string& text, const std::string& file) {
  const Result<JsonValue> json = parseJson(text, file);
  if (!json) {
    return forward(json);
  }
  ReadContext context(file, text);
  Plan plan = readPlanObject(*json, context, file);
  if (context.error()) {
    return tl::unexpected<Error>(*context.error());
  }
  return plan;
}

Result<void> writePlan(const Plan& plan, const std::string& path) {
  return writeFileAtomically(path, planToJson(plan));
}

}  // namespace vp::formats
