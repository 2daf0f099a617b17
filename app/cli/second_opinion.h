#pragma once

#include "core/audit/audit.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vp::cli {

/** A file that a plan rests on, as it is now. */
struct InputFile {
  std::string path;
  std::string sha256;      ///< empty: it is not there any more
  std::string planSha256;  ///< that the plan names; empty: it names none
};

/** What core/audit found for a plan, and of what exactly. */
struct SecondOpinion {
  audit::AuditReport report;
  InputFile plan;
  std::vector<InputFile> terrain;
  std::vector<InputFile> airfields;

  [[nodiscard]] bool isTerrainThePlans() const;
  /** No sample failed, over the very terrain that the plan was made with. */
  [[nodiscard]] bool isSafe() const { return report.isSafe() && isTerrainThePlans(); }
};

struct SecondOpinionRequest {
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;
  int threads = 1;
};

/** Reads the plan's terrain as raw posts and lets the engine stop at random places. @param path  of the plan
 *  @errors those of audit::RawGround and audit::audit */
Result<SecondOpinion> secondOpinion(const mission::Plan& plan, const std::string& path, const SecondOpinionRequest& request, const Job& job);

/** What was found, in a sentence. */
std::string sentenceOf(const SecondOpinion& opinion);

/** For a person: the sentence, what is least, and the first unsafe places. */
void printSecondOpinion(const mission::Plan& plan, const SecondOpinion& opinion);

/** The report file (resources/schema/second-opinion.schema.json): text that depends on the inputs, the seed and the program alone. */
std::string secondOpinionToJson(const mission::Plan& plan, const SecondOpinion& opinion);

}  // namespace vp::cli
