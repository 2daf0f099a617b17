#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/tour/gtsp.h"

#include <memory>

namespace vp::tour {

/** A tour problem that is solved again and again while its costs change, as in the lazy rounds and in re-planning.
 *  Between two solutions only what changed is worked on: `set` and `raise` take constant time, and every solution starts
 *  from `GtspOptions::warmStart` or else from the best of the tours found before, at the costs of now.
 *
 *  With `aroundChanges` a solution is a short search around the arcs that changed since the last one; if no arc of the
 *  last tour changed and none became cheaper, the last tour comes back at once. It has no bound and no proof. Without it,
 *  the search is the same as solveGtsp's. Either way the result depends on the seed and on the calls before, and on
 *  nothing else when `seconds` is absent. For lazy rounds:
 *
 *      GtspSolver solver(problem);                              // once
 *      options.aroundChanges = true, options.wantBound = false; // rounds that only say what to look at next
 *      solver.solve(options, job); solver.raise(from, to, cost); ...
 *      options.aroundChanges = false, options.effort = 0.1;     // when they replace nothing: finds most that they missed
 *      options.effort = 1.0, options.wantBound = true;          // at the end, with another seed
 *
 *  @threads one at a time      @pre of set and raise: the problem is valid, nodes exist and are in different sets */
class GtspSolver {
public:
  /** Takes any problem; a wrong one is reported by solve(). */
  explicit GtspSolver(GtspProblem problem);
  ~GtspSolver();
  GtspSolver(GtspSolver&&) noexcept;
  GtspSolver& operator=(GtspSolver&&) noexcept;

  [[nodiscard]] const GtspProblem& problem() const;

  /** Changes the cost of an arc; kForbidden takes it away. @pre cost >= 0 */
  void set(int from, int to, double cost);

  /** The arc costs at least this from now on. @pre cost >= 0 */
  void raise(int from, int to, double cost);

  /** @errors OutOfRange for a wrong problem or options; NoSolution, Cancelled as solveGtsp */
  Result<GtspSolution> solve(const GtspOptions& options, const Job& job);

private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace vp::tour
