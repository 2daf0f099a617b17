#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vp::tour {

/** Runs a program (found along PATH unless it names a folder) without a shell, its input empty, its output into `log`,
 *  and waits. When the job is stopped or the time is over the program is killed.
 *  @return its exit status, or nothing if it was killed for time
 *  @errors Unsupported - the program cannot be run; Cancelled */
Result<std::optional<int>> runProgram(const std::string& program, const std::vector<std::string>& arguments, const std::filesystem::path& log,
                                      std::optional<std::chrono::duration<double>> limit, const Job& job);

}  // namespace vp::tour
