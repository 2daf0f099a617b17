#include "app/cli/second_opinion.h"

#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "core/audit/raw_ground.h"
#include "core/geo/local_frame.h"
#include "core/terrain/terrain_reader.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vp::cli {
namespace {

constexpr double kRadian = 180.0 / 3.14159265358979323846;  // degrees
constexpr std::size_t kMostPrinted = 10;

const char* wordsOf(audit::MarginKind kind) {
  switch (kind) {
    case audit::MarginKind::TourClearance:
      return "tour above the clearance over the ground";
    case audit::MarginKind::GlideClearance:
      return "glide above the clearance over the ground";
    case audit::MarginKind::Rolling:
      return "glide above the ground after rolling";
    case audit::MarginKind::Key:
      return "glide above the high key";
    case audit::MarginKind::Arrival:
      return "glide above the least height on arrival";
  }
  return "";
}

/// Degrees true that the wind blows from, at the middle of the mission.
double fromDegrees(const audit::LevelWind& wind) {
  const double from = 270.0 - std::atan2(wind.north, wind.east) * kRadian;
  return std::fmod(from + 360.0, 360.0);
}

std::string windText(const audit::LevelWind& wind) {
  const double speed = std::hypot(wind.east, wind.north);
  return speed > 0.0 ? fmt::format("wind {:.0f}/{:.1f}kt", fromDegrees(wind), speed / kMpsPerKnot) : "still air";
}

std::string folderBeside(const std::string& file) {
  const std::filesystem::path parent = std::filesystem::path(file).parent_path();
  return parent.empty() ? "." : parent.string();
}

std::string resolved(const std::string& folder, const std::string& path) {
  return std::filesystem::path(path).is_absolute() ? path : (std::filesystem::path(folder) / path).string();
}

/// A file that may be gone has no checksum.
InputFile fileNow(const std::string& folder, const std::string& path, const std::string& planSha256 = {}) {
  const Result<std::string> sum = terrain::sha256OfFile(resolved(folder, path));
  return {path, sum ? *sum : std::string(), planSha256};
}

std::string siteName(const mission::Plan& plan, int site) {
  return site >= 0 && static_cast<std::size_t>(site) < plan.sites.size() ? plan.sites[static_cast<std::size_t>(site)].site.id : std::string();
}

nlohmann::ordered_json fileToJson(const InputFile& file) {
  nlohmann::ordered_json json{{"path", file.path}};
  if (!file.sha256.empty()) {
    json["sha256"] = file.sha256;
  }
  if (!file.planSha256.empty()) {
    json["sha256InPlan"] = file.planSha256;
  }
  return json;
}

nlohmann::ordered_json placeToJson(const geo::LocalFrame& frame, geo::Point where, double altitude) {
  const geo::LatLon place = frame.toLatLon(where);
  return {{"latitude_deg", place.latitude_deg}, {"longitude_deg", place.longitude_deg}, {"altitude_m", altitude}};
}

nlohmann::ordered_json stopToJson(const mission::Plan& plan, const geo::LocalFrame& frame, const audit::EngineStop& stop) {
  nlohmann::ordered_json json{{"sample", stop.sample}, {"track", stop.track}, {"afterPoint", stop.point}};
  json["where"] = placeToJson(frame, stop.where, stop.altitude);
  const double speed = std::hypot(stop.wind.east, stop.wind.north);
  json["wind"] = {{"from_deg", speed > 0.0 ? fromDegrees(stop.wind) : 0.0}, {"speed_mps", speed}};
  json["mass_kg"] = stop.mass_kg;
  json["site"] = siteName(plan, stop.site);
  return json;
}

}  // namespace

bool SecondOpinion::isTerrainThePlans() const {
  return std::all_of(terrain.begin(), terrain.end(), [](const InputFile& file) { return file.sha256 == file.planSha256; });
}

Result<SecondOpinion> secondOpinion(const mission::Plan& plan, const std::string& path, const SecondOpinionRequest& request, const Job& job) {
  const std::string folder = folderBeside(path);
  SecondOpinion opinion;
  opinion.plan = fileNow(".", path);
  std::vector<std::string> files;
  for (const mission::TerrainReference& reference : plan.terrain) {
    files.push_back(resolved(folder, reference.path));
    opinion.terrain.push_back(fileNow(folder, reference.path, reference.sha256));
  }
  for (const mission::AirfieldSource& source : plan.mission.airfields) {
    opinion.airfields.push_back(fileNow(folder, source.airports));
    if (!source.runways.empty()) {
      opinion.airfields.push_back(fileNow(folder, source.runways));
    }
  }
  const Result<audit::RawGround> ground = audit::RawGround::read(files, plan.frameOrigin, job.part(0.0, 0.05));
  if (!ground) {
    return forward(ground);
  }
  std::vector<geo::LatLon> sites;
  for (const mission::SiteInFrame& site : plan.sites) {
    sites.push_back(site.site.touchdown);
  }
  const Result<std::vector<geo::Point>> places = audit::RawGround::toFrame(plan.frameOrigin, sites);
  if (!places) {
    return forward(places);
  }
  Result<audit::AuditReport> report =
      audit::audit({plan, [&ground] { return ground->lookup(); }, *places, request.samples, request.seed, request.threads}, job.part(0.05, 1.0));
  if (!report) {
    return forward(report);
  }
  opinion.report = std::move(*report);
  return opinion;
}

std::string sentenceOf(const SecondOpinion& opinion) {
  const audit::AuditReport& report = opinion.report;
  if (!opinion.isTerrainThePlans()) {
    return fmt::format(
        "NOT SAFE: the terrain is not the one that the plan was made with, and {} of {} engine failures over it did not come down as promised.",
        report.unsafe, report.samples);
  }
  if (!report.isSafe()) {
    return fmt::format("NOT SAFE: after {} of {} engine failures at random places the aircraft did not come down as the plan promises.",
                       report.unsafe, report.samples);
  }
  return fmt::format("After each of {} engine failures at random places the aircraft came down as the plan promises.", report.samples);
}

void printSecondOpinion(const mission::Plan& plan, const SecondOpinion& opinion) {
  const geo::LocalFrame frame(plan.frameOrigin);
  const audit::AuditReport& report = opinion.report;
  fmt::print("SECOND OPINION (seed {})\n{}\n", report.seed, sentenceOf(opinion));
  fmt::print("  {:.0f} km of tour, {} glides, {:.0f} km flown in steps of 1 m, the longest {:.0f} s, bank up to {:.1f} degrees\n",
             report.tourLength / 1000.0, report.glides, report.metresFlown / 1000.0, report.longest_s, report.steepestBank_deg);
  for (std::size_t kind = 0; kind < audit::kMarginKinds; ++kind) {
    if (!report.least[kind]) {
      continue;
    }
    const audit::LeastMargin& margin = *report.least[kind];
    const geo::LatLon where = frame.toLatLon(margin.place.where);
    fmt::print("    {:<44} {:9.2f} m at {:.5f}, {:.5f}, {:.0f} s after the engine stopped, {}, {:.0f} kg\n",
               wordsOf(static_cast<audit::MarginKind>(kind)), margin.place.left, where.latitude_deg, where.longitude_deg, margin.place.seconds,
               windText(margin.stop.wind), margin.stop.mass_kg);
  }
  for (std::size_t i = 0; i < std::min(kMostPrinted, report.unsafePoints.size()); ++i) {
    const audit::UnsafePoint& point = report.unsafePoints[i];
    const geo::LatLon where = frame.toLatLon(point.stop.where);
    fmt::print("  unsafe: {} point {}, engine stops at {:.5f}, {:.5f}, {:.0f} m MSL, {}, {:.0f} kg: {}\n", point.stop.track, point.stop.point + 1,
               where.latitude_deg, where.longitude_deg, point.stop.altitude, windText(point.stop.wind), point.stop.mass_kg, point.text);
  }
}

std::string secondOpinionToJson(const mission::Plan& plan, const SecondOpinion& opinion) {
  const geo::LocalFrame frame(plan.frameOrigin);
  const audit::AuditReport& report = opinion.report;
  nlohmann::ordered_json json{{"format", "volplane-second-opinion"}, {"version", 1}, {"safe", opinion.isSafe()}, {"sentence", sentenceOf(opinion)}};
  json["createdBy"] = programVersion();
  json["planCreatedBy"] = plan.createdBy;
  json["mission"] = plan.mission.name;
  json["inputs"] = {{"plan", fileToJson(opinion.plan)}, {"terrain", nlohmann::ordered_json::array()}, {"airfields", nlohmann::ordered_json::array()}};
  for (const InputFile& file : opinion.terrain) {
    json["inputs"]["terrain"].push_back(fileToJson(file));
  }
  for (const InputFile& file : opinion.airfields) {
    json["inputs"]["airfields"].push_back(fileToJson(file));
  }
  json["seed"] = report.seed;
  json["samples"] = report.samples;
  json["unsafe"] = report.unsafe;
  json["margins"] = nlohmann::ordered_json::array();
  for (std::size_t kind = 0; kind < audit::kMarginKinds; ++kind) {
    if (const std::optional<audit::LeastMargin>& margin = report.least[kind]) {
      nlohmann::ordered_json item{{"kind", audit::nameOf(static_cast<audit::MarginKind>(kind))}, {"least_m", margin->place.left}};
      item["where"] = placeToJson(frame, margin->place.where, margin->place.altitude);
      item["afterStop_s"] = margin->place.seconds;
      item["stop"] = stopToJson(plan, frame, margin->stop);
      json["margins"].push_back(std::move(item));
    }
  }
  json["unsafePoints"] = nlohmann::ordered_json::array();
  for (const audit::UnsafePoint& point : report.unsafePoints) {
    nlohmann::ordered_json item{{"text", point.text}, {"missing_m", point.place.left < 0.0 ? -point.place.left : 0.0}};
    item["where"] = placeToJson(frame, point.place.where, point.place.altitude);
    item["afterStop_s"] = point.place.seconds;
    item["stop"] = stopToJson(plan, frame, point.stop);
    json["unsafePoints"].push_back(std::move(item));
  }
  json["work"] = {{"tourLength_m", report.tourLength},           {"glides", report.glides},
                  {"metresFlown", report.metresFlown},           {"metresOfGround", report.metresOfGround},
                  {"steepestBank_deg", report.steepestBank_deg}, {"longest_s", report.longest_s}};
  json["reused"] =
      "The path over ground and the posts under it are the same in every wind: they are found once for each glide and each way to it. "
      "Motion, height, time, bank and rolling are worked out anew for every sample.";
  return jsonText(json);
}

}  // namespace vp::cli
