#include "app/cli/verification.h"

#include "app/cli/json_text.h"
#include "core/formats/mission_loader.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace vp::cli {
namespace {

/// What a margin's rule means to a pilot; the rule itself if it has no words yet.
std::string inWords(const std::string& rule) {
  static const std::map<std::string, std::string> words{
      {"tour.clearance", "tour above terrain and clearance"},
      {"tour.glide", "tour above what the glide needs"},
      {"tour.climb", "climb angle below the steepest allowed"},
      {"tour.descent", "descent angle below the steepest allowed"},
      {"tour.ceiling", "tour below the ceiling"},
      {"glide.clearance", "engine-out glides above terrain and clearance"},
      {"glide.arrival", "engine-out glides above the runway on arrival"},
      {"target.height", "height at which a target is passed above it"},
      {"spiral.clearance", "spirals above terrain and clearance"},
  };
  const auto found = words.find(rule);
  return found == words.end() ? rule : found->second;
}

const char* nameOf(safety::Severity severity) {
  switch (severity) {
    case safety::Severity::Note:
      return "note";
    case safety::Severity::Warning:
      return "warning";
    case safety::Severity::Violated:
      return "violated";
    case safety::Severity::Unknown:
      return "unknown";
  }
  return "";
}

nlohmann::ordered_json placeToJson(geo::LatLon place) {
  return {{"latitude_deg", place.latitude_deg}, {"longitude_deg", place.longitude_deg}};
}

}  // namespace

Result<safety::SafetyReport> verify(const mission::Plan& plan, const std::string& planFolder, const Job& job) {
  std::vector<std::string> checksums;
  const Result<terrain::ElevationGrid> terrain = formats::readPlanTerrain(plan, planFolder, checksums, job.part(0.0, 0.5));
  if (!terrain) {
    return forward(terrain);
  }
  return safety::check({plan, *terrain, checksums}, job.part(0.5, 1.0));
}

void printReport(const mission::Plan& plan, const safety::SafetyReport& report) {
  if (report.isSafe()) {
    fmt::print("VERIFIED SAFE\n{}\n", report.certificate->statement);
    fmt::print("  least margins:\n");
    for (const mission::Margin& margin : report.margins) {
      fmt::print("    {:<52} {:9.1f} {:<4} at {:.5f}, {:.5f}\n", inWords(margin.kind), margin.value, margin.unit, margin.where.latitude_deg,
                 margin.where.longitude_deg);
    }
    for (const std::string& warning : report.certificate->warnings) {
      fmt::print("  warning: {}\n", warning);
    }
  } else {
    fmt::print("NOT SAFE: do not fly this plan\n");
  }
  for (const safety::Finding& finding : report.findings) {
    if (report.isSafe() && finding.severity != safety::Severity::Violated && finding.severity != safety::Severity::Unknown) {
      continue;  // already among the certificate's warnings
    }
    fmt::print("  {} [{}]{}: {}\n", nameOf(finding.severity), finding.rule,
               finding.tourPoint >= 0 ? fmt::format(" point {} of {}", finding.tourPoint + 1, plan.tour.size()) : "", finding.text);
  }
}

std::string reportToJson(const mission::Plan& plan, const safety::SafetyReport& report) {
  nlohmann::ordered_json json;
  json["safe"] = report.isSafe();
  json["points"] = plan.tour.size();
  if (report.certificate) {
    json["statement"] = report.certificate->statement;
    json["warnings"] = report.certificate->warnings;
  }
  json["margins"] = nlohmann::ordered_json::array();
  for (const mission::Margin& margin : report.margins) {
    json["margins"].push_back({{"kind", margin.kind}, {"value", margin.value}, {"unit", margin.unit}, {"where", placeToJson(margin.where)}});
  }
  json["findings"] = nlohmann::ordered_json::array();
  for (const safety::Finding& finding : report.findings) {
    nlohmann::ordered_json item{
        {"severity", nameOf(finding.severity)}, {"rule", finding.rule}, {"text", finding.text}, {"tourPoint", finding.tourPoint}};
    if (finding.where) {
      item["where"] = placeToJson(*finding.where);
    }
    if (finding.margin) {
      item["margin"] = *finding.margin;
    }
    json["findings"].push_back(std::move(item));
  }
  return jsonText(json);
}

}  // namespace vp::cli
