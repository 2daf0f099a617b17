// The second engine: an external LKH program (Helsgaun 2017, LKH-3) on the Noon-Bean form of the problem.

#include "core/tour/gtsp.h"
#include "core/tour/gtsp_bound.h"
#include "core/tour/gtsp_check.h"
#include "core/tour/gtsp_graph.h"
#include "core/tour/gtsp_node_choice.h"
#include "core/tour/lkh_files.h"
#include "core/tour/lkh_process.h"
#include "core/tour/noon_bean.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vp::tour {

namespace {

constexpr double kGraceSeconds = 5.0;  // for start and end, beyond the time that LKH is given
constexpr std::uint64_t kSeedRange = 2'000'000'000;

std::string parameters(const GtspOptions& options, const std::filesystem::path& folder) {
  std::string text = fmt::format("PROBLEM_FILE = {}\nOUTPUT_TOUR_FILE = {}\nRUNS = {}\nSEED = {}\nTRACE_LEVEL = 0\n",
                                 (folder / "problem.atsp").string(), (folder / "best.tour").string(),
                                 std::max(1, static_cast<int>(std::min(10.0 * options.effort, 1e6))), 1 + options.seed % kSeedRange);
  if (options.seconds) {
    text += fmt::format("TOTAL_TIME_LIMIT = {}\n", std::max(1L, std::lround(*options.seconds)));
  }
  if (options.warmStart) {
    text += fmt::format("INITIAL_TOUR_FILE = {}\n", (folder / "start.tour").string());
  }
  return text;
}

/** The nodes of the transformed problem in the order that decodes to `tour`: each set run through from its visited node. */
std::vector<int> encode(const GtspProblem& problem, const std::vector<int>& tour) {
  const std::vector<int> setOf = setOfNodes(problem);
  std::vector<int> order;
  for (const int node : tour) {
    std::vector<int> members = problem.sets[static_cast<std::size_t>(setOf[static_cast<std::size_t>(node)])];
    std::rotate(members.begin(), std::find(members.begin(), members.end(), node), members.end());
    order.insert(order.end(), members.begin(), members.end());
  }
  return order;
}

Result<std::vector<int>> runLkh(const GtspProblem& problem, const GtspOptions& options, const std::string& program, const Job& job) {
  const std::optional<NoonBean> atsp = transformNoonBean(problem);
  if (!atsp) {
    return fail(Errc::Unsupported, "the problem is too large for the whole numbers that LKH works with; use the built-in solver");
  }
  const Result<TemporaryFolder> folder = TemporaryFolder::make();
  if (!folder) {
    return forward(folder);
  }
  const std::filesystem::path& path = folder->path();
  Result<void> written = writeText(path / "problem.atsp", toTsplib(*atsp));
  if (written) {
    written = writeText(path / "run.par", parameters(options, path));
  }
  if (written && options.warmStart) {
    written = writeText(path / "start.tour", toTourFile(encode(problem, *options.warmStart)));
  }
  if (!written) {
    return forward(written);
  }
  std::optional<std::chrono::duration<double>> limit;
  if (options.seconds) {
    limit = std::chrono::duration<double>(*options.seconds + kGraceSeconds);
  }
  const Result<std::optional<int>> status = runProgram(program, {(path / "run.par").string()}, path / "log.txt", limit, job);
  if (!status) {
    return forward(status);
  }
  const Result<std::string> text = readText(path / "best.tour");
  if (!text) {
    return forward(text);
  }
  const Result<std::vector<int>> order = parseTourFile(*text, problem.nodes, program);
  if (!order) {
    return forward(order);
  }
  return decodeNoonBean(problem, *order);
}

}  // namespace

Result<GtspSolution> solveGtspWithLkh(const GtspProblem& problem, const GtspOptions& options, const std::string& program, const Job& job) {
  if (Result<void> valid = checkProblem(problem); !valid) {
    return forward(valid);
  }
  if (Result<void> valid = checkOptions(problem, options); !valid) {
    return forward(valid);
  }
  if (problem.sets.size() <= 3) {  // nothing for a heuristic to do, and LKH refuses so few nodes
    return solveGtsp(problem, options, job);
  }
  const Result<std::vector<int>> found = runLkh(problem, options, program, job);
  if (!found) {
    return forward(found);
  }
  GtspSolution solution;
  solution.tour = fromSetZero(problem, bestNodesForOrder(problem, setOfNodes(problem), *found));
  solution.cost = tourCost(problem, solution.tour);
  if (options.warmStart && tourCost(problem, fromSetZero(problem, *options.warmStart)) < solution.cost) {
    solution.tour = fromSetZero(problem, *options.warmStart);
    solution.cost = tourCost(problem, solution.tour);
  }
  if (std::isinf(solution.cost)) {
    return fail(Errc::NoSolution,
                "the external solver found no tour that avoids forbidden connections; allow more of them or use the built-in solver");
  }
  solution.rounds = 1;
  if (options.wantBound) {
    const Result<double> bound = lowerBound(problem, solution.cost, {}, job);
    if (!bound) {
      return forward(bound);
    }
    solution.lowerBound = std::min(*bound, solution.cost);
    solution.optimal = solution.lowerBound >= solution.cost * (1.0 - 1e-9);
  }
  return solution;
}

}  // namespace vp::tour
