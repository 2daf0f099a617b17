#include "core/emergency/verified_answer.h"

#include "core/emergency/landing_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace vp::emergency {

LandingAnswer verifiedAnswer(const LandingRequest& request, LandingAnswer answer) {
  if (!answer.path) {
    return answer;
  }
  const std::shared_ptr<const LandingJudge> judge = withJudge(request).judge;
  const safety::LandingReport report = judge->check(*answer.path);
  answer.verified = answer.path->site >= 0 ? report.isSafe() : report.isFlyable();
  if (answer.verified) {
    const double clearance = request.world->clearance;
    if (const std::optional<double> rolling = judge->rollingOf(*answer.path); rolling && *rolling > clearance) {
      answer.notes.push_back(
          fmt::format("Rolling into its turns and out of them may cost this way up to {:.0f} m, more than the clearance of {:.0f} m.",
                      std::ceil(*rolling), clearance));
    }
    return answer;
  }
  const auto bad = std::find_if(report.findings.begin(), report.findings.end(), [](const safety::Finding& finding) {
    return finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown;
  });
  const std::string reason = bad == report.findings.end() ? "no reason given" : fmt::format("{} ({})", bad->text, bad->rule);
  const std::string refused = fmt::format("A path was found, but the checker did not accept it: {}.", reason);
  answer.whyNot = answer.whyNot.empty() ? refused : answer.whyNot;
  answer.notes = {};
  answer.terms = {};
  answer.path.reset();
  return answer;
}

}  // namespace vp::emergency
