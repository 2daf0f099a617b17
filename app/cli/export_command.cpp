// volplane-cli export PLAN --format F[,F...] -o FILE | --folder DIR: the plan in the form of other programs.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/verification.h"
#include "core/formats/plan_file.h"
#include "ui/exports/export_files.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace vp::cli {
namespace {

struct ExportArguments {
  std::string plan;
  std::vector<std::string> formats;
  std::string output;
  std::string folder;
  std::string pattern = exports::kNamePattern;
  bool unverified = false;
};

/// The plan with the certificate that it deserves now: the one in the file is a claim, and what is handed on to a cockpit is
/// checked again. @return an exit status other than kDone to stop with
int certify(mission::Plan& plan, const Result<PlanTerrain>& terrain, const ExportArguments& arguments, Console& console, const Common& common) {
  Result<safety::SafetyReport> verdict = terrain ? safety::check({plan, *terrain->grid, terrain->checksums}, console.job().part(0.2, 0.4))
                                                 : Result<safety::SafetyReport>(forward(terrain));
  console.finishProgress();
  if (!verdict && (!arguments.unverified || verdict.error().code == Errc::Cancelled)) {
    return report(verdict.error(), common.json);
  }
  plan.certificate = verdict ? verdict->certificate : std::nullopt;
  if (plan.certificate) {
    return kDone;
  }
  if (!arguments.unverified) {
    if (common.json) {
      fmt::print("{}", reportToJson(plan, *verdict));
    } else {
      printReport(plan, *verdict);
    }
    fmt::print(
        stderr,
        "volplane-cli: {}: not exported, because the plan is not safe; plan the mission again (or add --unverified to export it all the same)\n",
        arguments.plan);
    return kVerificationFailed;
  }
  fmt::print(stderr, "volplane-cli: warning: {} is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it\n",
             arguments.plan);
  return kDone;
}

nlohmann::ordered_json routesToJson(const exports::PreparedExport& prepared) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const exports::CheckedRoute& checked : prepared.routes) {
    nlohmann::ordered_json item{{"waypoints", checked.route.waypoints.size()},
                                {"stepsPerDegree", checked.route.stepsPerDegree},
                                {"verified", checked.isVerified},
                                {"length_m", checked.route.length},
                                {"lateral_m", checked.route.lateral},
                                {"above_m", checked.route.above},
                                {"visit_m", checked.route.visit}};
    item["findings"] = nlohmann::ordered_json::array();
    for (const safety::Finding& finding : checked.findings) {
      item["findings"].push_back({{"rule", finding.rule}, {"text", finding.text}});
    }
    item["margins"] = nlohmann::ordered_json::array();
    for (const exports::MarginChange& margin : checked.margins) {
      item["margins"].push_back({{"kind", margin.kind}, {"unit", margin.unit}, {"tour", margin.tour}, {"route", margin.route}});
    }
    list.push_back(std::move(item));
  }
  return list;
}

/// @param refusal  why nothing was written; "": it was
void printJson(const exports::PreparedExport& prepared, const std::vector<std::string>& paths, const std::vector<std::string>& backups,
               const std::string& refusal) {
  nlohmann::ordered_json json{{"verified", prepared.isVerified}};
  if (!refusal.empty()) {
    json["error"] = refusal;
    json["exit"] = static_cast<int>(kVerificationFailed);
  }
  json["files"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const exports::ExportFile& file = prepared.files[i];
    json["files"].push_back({{"file", paths[i]},
                             {"format", file.format->name},
                             {"bytes", file.bytes.size()},
                             {"part", file.part},
                             {"parts", file.parts},
                             {"loses", file.format->loses},
                             {"backup", backups[i]}});
  }
  json["routes"] = routesToJson(prepared);
  json["remarks"] = nlohmann::ordered_json::array();
  for (const exports::Remark& remark : prepared.remarks) {
    json["remarks"].push_back({{"warning", remark.isWarning}, {"text", remark.text}});
  }
  fmt::print("{}", jsonText(json));
}

void printFiles(const exports::PreparedExport& prepared, const std::vector<std::string>& paths, const std::vector<std::string>& backups) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    fmt::print("{} written to {}{}\n", prepared.files[i].format->what, paths[i], backups[i].empty() ? "" : "; what was there is now " + backups[i]);
  }
}

int runExport(const ExportArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  Result<mission::Plan> plan = formats::readPlan(arguments.plan);
  if (!plan) {
    return report(plan.error(), common.json);
  }
  const Result<PlanTerrain> terrain = readTerrain(*plan, folderOf(arguments.plan), console.job().part(0.0, 0.2));
  if (const int status = certify(*plan, terrain, arguments, console, common); status != kDone) {
    return status;
  }
  const exports::ExportRequest request{*plan, terrain ? terrain->grid : nullptr, terrain ? terrain->checksums : std::vector<std::string>{},
                                       arguments.formats};
  const Result<exports::PreparedExport> prepared = exports::prepareExport(request, console.job().part(0.4, 1.0));
  console.finishProgress();
  if (!prepared) {
    return report(prepared.error(), common.json);
  }
  if (!common.json) {
    for (const exports::Remark& remark : prepared->remarks) {
      if (remark.isWarning || !common.quiet) {
        fmt::print(remark.isWarning ? stderr : stdout, "  {}: {}\n", remark.isWarning ? "warning" : "note", remark.text);
      }
    }
  }
  if (!prepared->isVerified && !arguments.unverified) {
    const std::string reason = "not exported: " + prepared->refusal;
    if (common.json) {
      printJson(*prepared, {}, {}, reason);
    }
    fmt::print(stderr, "volplane-cli: {}: {} (or add --unverified to export it all the same)\n", arguments.plan, reason);
    return kVerificationFailed;
  }
  const std::string mission = plan->mission.name.empty() ? std::filesystem::path(arguments.plan).stem().string() : plan->mission.name;
  const std::vector<std::string> paths = arguments.folder.empty() ? exports::pathsOf(*prepared, arguments.output)
                                                                  : exports::pathsOf(*prepared, arguments.folder, arguments.pattern, mission);
  const Result<std::vector<std::string>> backups = exports::writeExports(*prepared, paths, arguments.folder);
  if (!backups) {
    return report(backups.error(), common.json);
  }
  if (common.json) {
    printJson(*prepared, paths, *backups, "");
  } else if (!common.quiet) {
    printFiles(*prepared, paths, *backups);
  }
  return kDone;
}

}  // namespace

void addExportCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Write a plan for other programs, after verifying it and its waypoints again");
  std::vector<std::string> names;
  std::string help;
  for (const formats::ExportFormat& format : formats::exportFormats()) {
    names.push_back(format.name);
    help += (help.empty() ? "" : "; ") + format.name + ": " + format.what;
  }
  command->add_option("plan", arguments->plan, "Plan file (*.vpp)")->required();
  command->add_option("--format,-f", arguments->formats, "One or more, separated by commas. " + help)
      ->required()
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  CLI::Option* output = command->add_option("-o,--output", arguments->output, "File to write, for a single format");
  CLI::Option* folder = command->add_option("--folder", arguments->folder, "Folder to write to, for several formats; made if it is missing");
  output->excludes(folder);
  command->add_option("--pattern", arguments->pattern, "Names of the files in the folder, from {mission}, {format} and {part}")->needs(folder);
  command->add_flag("--unverified", arguments->unverified, "Export even if the plan or its waypoints cannot be verified");
  command->callback([arguments, output, folder, &common, &status] {
    if (output->count() == 0 && folder->count() == 0) {
      throw CLI::RequiredError("--output or --folder");
    }
    if (output->count() > 0 && arguments->formats.size() > 1) {
      throw CLI::ValidationError("--output", "takes a single format; name a folder with --folder for several");
    }
    status = runExport(*arguments, common);
  });
}

}  // namespace vp::cli
