// volplane-cli verify PLAN: lets the independent checker judge a plan file.
#include "app/cli/commands.h"
#include "app/cli/verification.h"
#include "core/formats/plan_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace vp::cli {
namespace {

int runVerify(const std::string& path, const Common& common) {
  Console console(!common.quiet && !common.json);
  const Result<mission::Plan> plan = formats::readPlan(path);
  if (!plan) {
    return report(plan.error(), common.json);
  }
  const Result<safety::SafetyReport> verdict = verify(*plan, folderOf(path), console.job());
  console.finishProgress();
  if (!verdict) {
    return report(verdict.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", reportToJson(*plan, *verdict));
  } else if (!common.quiet || !verdict->isSafe()) {
    fmt::print("{}: ", path);
    printReport(*plan, *verdict);
  }
  return verdict->isSafe() ? kDone : kVerificationFailed;
}

}  // namespace

void addVerifyCommand(CLI::App& app, Common& common, int& status) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("verify", "Check a plan from its file and the terrain alone; exit 3 if it is not safe");
  command->add_option("plan", *path, "Plan file (*.vpp)")->required();
  command->callback([path, &common, &status] { status = runVerify(*path, common); });
}

}  // namespace vp::cli
