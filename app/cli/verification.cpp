#include "app/cli/verification.h"

#include "app/cli/json_text.h"
#include "core/formats/mission_loader.h"
#include "ui/exports/prepare_export.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <string>

namespace vp::cli {
namespace {

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

Result<PlanTerrain> readTerrain(const mission::Plan& plan, const std::string& planFolder, const Job& job) {
  PlanTerrain result;
  Result<terrain::ElevationGrid> grid = formats::readPlanTerrain(plan, planFolder, result.checksums, job);
  if (!grid) {
    return forward(grid);
  }
  result.grid = std::make_shared<const terrain::ElevationGrid>(std::move(*grid));
  return result;
}

Result<safety::SafetyReport> verify(const mission::Plan& plan, const std::string& planFolder, const Job& job) {
  const Result<PlanTerrain> terrain = readTerrain(plan, planFolder, job.part(0.0, 0.5));
  if (!terrain) {
    return forward(terrain);
  }
  return safety::check({plan, *terrain->grid, terrain->checksums}, job.part(0.5, 1.0));
}

void printReport(const mission::Plan& plan, const safety::SafetyReport& report) {
  if (report.isSafe()) {
    fmt::print("VERIFIED SAFE\n{}\n", report.certificate->statement);
    fmt::print("  least margins:\n");
    for (const mission::Margin& margin : report.margins) {
      fmt::print("    {:<52} {:9.1f} {:<4} at {:.5f}, {:.5f}\n", exports::marginInWords(margin.kind), margin.value, margin.unit,
                 margin.where.latitude_deg, margin.where.longitude_deg);
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
