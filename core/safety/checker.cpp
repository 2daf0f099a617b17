#include "core/safety/checker.h"

#include "core/safety/check_context.h"

namespace vp::safety {
namespace {

tl::unexpected<Error> cancelled() {
  return fail(Errc::Cancelled, "the check was stopped before it was done; nothing is known about the plan");
}

}  // namespace

Result<SafetyReport> check(const SafetyInput& input, const Job& job) {
  SafetyReport report;
  if (job.stopRequested()) {
    return cancelled();
  }
  CheckContext context(input);
  if (checkStructure(context)) {
    checkSites(context);
    checkTargets(context);
    checkGlides(context, job.part(0.0, 0.8));
    if (job.stopRequested()) {
      return cancelled();
    }
    checkTour(context, job.part(0.8, 0.95));
    checkAirspaces(context, job);
    if (job.stopRequested()) {
      return cancelled();
    }
    checkVisits(context);
    checkMetrics(context);
    checkHome(context, job.part(0.95, 1.0));
    if (job.stopRequested()) {
      return cancelled();
    }
    checkApproaches(context);
    checkHolds(context);
    addWarnings(context);
    report.margins = context.margins.finish(context.frame);
    report.findings = context.findings.finish();
    if (context.findings.isClean()) {
      report.certificate = issueCertificate(context, report.findings, report.margins);
    }
  } else {
    report.findings = context.findings.finish();
  }
  return report;
}

}  // namespace vp::safety
