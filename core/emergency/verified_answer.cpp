#include "core/emergency/verified_answer.h"

#include "core/safety/landing_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vp::emergency {

LandingAnswer verifiedAnswer(const LandingRequest& request, LandingAnswer answer) {
  if (!answer.path) {
    return answer;
  }
  const landing::World& world = *request.world;
  const safety::LandingReport report = safety::checkLanding({*request.mission, world.sites, request.frameOrigin, world.terrain.grid()}, *answer.path);
  answer.verified = answer.path->site >= 0 ? report.isSafe() : report.isFlyable();
  if (answer.verified) {
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
