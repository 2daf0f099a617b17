// volplane-cli verify PLAN: lets the independent checker judge a plan file, and core/audit fly samples of it as a second opinion.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/second_opinion.h"
#include "app/cli/verification.h"
#include "core/formats/atomic_file.h"
#include "core/formats/plan_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace vp::cli {
namespace {

struct VerifyArguments {
  std::string plan;
  SecondOpinionRequest second;
  std::string report;
};

/// Both verdicts in one object.
std::string withSecondOpinion(const std::string& report, const mission::Plan& plan, const SecondOpinion& opinion) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(report);
  json["secondOpinion"] = nlohmann::ordered_json::parse(secondOpinionToJson(plan, opinion));
  return jsonText(json);
}

int runVerify(const VerifyArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  const Result<mission::Plan> plan = formats::readPlan(arguments.plan);
  if (!plan) {
    return report(plan.error(), common.json);
  }
  const bool isSampled = arguments.second.samples > 0;
  const Result<safety::SafetyReport> verdict = verify(*plan, folderOf(arguments.plan), isSampled ? console.job().part(0.0, 0.2) : console.job());
  if (!verdict) {
    console.finishProgress();
    return report(verdict.error(), common.json);
  }
  std::optional<SecondOpinion> opinion;
  if (isSampled) {
    Result<SecondOpinion> flown = secondOpinion(*plan, arguments.plan, arguments.second, console.job().part(0.2, 1.0));
    if (!flown) {
      console.finishProgress();
      return report(flown.error(), common.json);
    }
    opinion = std::move(*flown);
    if (const std::string text = secondOpinionToJson(*plan, *opinion); !arguments.report.empty()) {
      if (const Result<void> written = formats::writeFileAtomically(arguments.report, text); !written) {
        console.finishProgress();
        return report(written.error(), common.json);
      }
    }
  }
  console.finishProgress();
  const bool isSafe = verdict->isSafe() && (!opinion || opinion->isSafe());
  if (common.json) {
    const std::string text = reportToJson(*plan, *verdict);
    fmt::print("{}", opinion ? withSecondOpinion(text, *plan, *opinion) : text);
  } else if (!common.quiet || !isSafe) {
    fmt::print("{}: ", arguments.plan);
    printReport(*plan, *verdict);
    if (opinion) {
      printSecondOpinion(*plan, *opinion);
    }
  }
  return isSafe ? kDone : kVerificationFailed;
}

}  // namespace

void addVerifyCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* command = app.add_subcommand("verify", "Check a plan from its file and the terrain alone; exit 3 if it is not safe");
  command->add_option("plan", arguments->plan, "Plan file (*.vpp)")->required();
  CLI::Option* samples = command
                             ->add_option("--independent-samples", arguments->second.samples,
                                          "Let the engine stop at so many random places of the plan and fly each glide in steps of 1 m over the raw "
                                          "terrain, in random winds of the forecast: a second opinion that shares no code with the checker")
                             ->check(CLI::Range(1, 10'000'000));
  command->add_option("--seed", arguments->second.seed, "Seed of the random places and winds; the same seed gives the same report")->needs(samples);
  command->add_option("--report", arguments->report, "Write the second opinion into this file (JSON), to be kept with the plan")->needs(samples);
  command->add_option("--threads", arguments->second.threads, "Threads for the second opinion")->check(CLI::Range(1, 256))->needs(samples);
  command->callback([arguments, &common, &status] { status = runVerify(*arguments, common); });
}

}  // namespace vp::cli
