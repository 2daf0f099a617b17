// volplane-cli export PLAN --format F -o FILE: the plan in the form of another program.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/verification.h"
#include "core/formats/atomic_file.h"
#include "core/formats/export_formats.h"
#include "core/formats/plan_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace vp::cli {
namespace {

struct ExportArguments {
  std::string plan;
  std::string format;
  std::string output;
  bool unverified = false;
};

int runExport(const ExportArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  Result<mission::Plan> plan = formats::readPlan(arguments.plan);
  if (!plan) {
    return report(plan.error(), common.json);
  }
  // The certificate in the file is a claim; what is handed on to a cockpit is checked again.
  const Result<safety::SafetyReport> verdict = verify(*plan, folderOf(arguments.plan), console.job());
  console.finishProgress();
  if (!verdict && !arguments.unverified) {
    return report(verdict.error(), common.json);
  }
  plan->certificate = verdict ? verdict->certificate : std::nullopt;
  if (!plan->certificate) {
    if (!arguments.unverified) {
      printReport(*plan, *verdict);
      fmt::print(
          stderr,
          "volplane-cli: {}: not exported, because the plan is not safe; plan the mission again (or add --unverified to export it all the same)\n",
          arguments.plan);
      return kVerificationFailed;
    }
    fmt::print(stderr, "volplane-cli: warning: {} is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it\n",
               arguments.plan);
  }
  const std::vector<formats::ExportFormat>& list = formats::exportFormats();
  const auto format = std::find_if(list.begin(), list.end(), [&](const formats::ExportFormat& f) { return f.name == arguments.format; });
  const Result<std::string> text = format->write(*plan);
  if (!text) {
    return report(text.error(), common.json);
  }
  if (const Result<void> written = formats::writeFileAtomically(arguments.output, *text); !written) {
    return report(written.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", jsonText(nlohmann::ordered_json{{"file", arguments.output},
                                                     {"format", format->name},
                                                     {"bytes", text->size()},
                                                     {"verified", plan->certificate.has_value()},
                                                     {"loses", format->loses}}));
  } else if (!common.quiet) {
    fmt::print("{} written to {}{}\n", format->what, arguments.output, format->loses.empty() ? "" : "; " + format->loses);
  }
  return kDone;
}

}  // namespace

void addExportCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Write a plan for another program, after verifying it again");
  std::vector<std::string> names;
  std::string help;
  for (const formats::ExportFormat& format : formats::exportFormats()) {
    names.push_back(format.name);
    help += (help.empty() ? "" : "; ") + format.name + ": " + format.what;
  }
  command->add_option("plan", arguments->plan, "Plan file (*.vpp)")->required();
  command->add_option("--format,-f", arguments->format, help)->required()->check(CLI::IsMember(names));
  command->add_option("-o,--output", arguments->output, "File to write")->required();
  command->add_flag("--unverified", arguments->unverified, "Export even if the plan cannot be verified");
  command->callback([arguments, &common, &status] { status = runExport(*arguments, common); });
}

}  // namespace vp::cli
