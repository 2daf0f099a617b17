#include "core/tour/gtsp_solver.h"

#include "core/base/expect.h"
#include "core/tour/gtsp_check.h"
#include "core/tour/gtsp_graph.h"
#include "core/tour/gtsp_run.h"
#include "core/tour/gtsp_search.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace vp::tour {

namespace {

constexpr std::size_t kRemembered = 16;  // tours that may become the best again when others become dearer

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace

class GtspSolver::State {
public:
  explicit State(GtspProblem problem) : problem_(std::move(problem)), valid_(checkProblem(problem_)) {
    if (valid_) {
      setOf_ = setOfNodes(problem_);
      next_.assign(at(problem_.nodes), -1);
      isChanged_.assign(problem_.sets.size(), 0);
    }
  }
  // the search points to the problem and the graph beside it
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[nodiscard]] const GtspProblem& problem() const { return problem_; }

  void set(int from, int to, double cost) {
    VP_EXPECT(valid_ && from >= 0 && to >= 0 && from < problem_.nodes && to < problem_.nodes && setOf_[at(from)] != setOf_[at(to)]);
    VP_EXPECT(cost >= 0.0);
    double& stored = problem_.cost[at(from) * at(problem_.nodes) + at(to)];
    const double before = std::exchange(stored, cost);
    if (before == cost) {
      return;
    }
    if (graph_ && !graph_->holds(cost)) {
      search_.reset();
      graph_.reset();
    }
    if (graph_) {
      graph_->setCost(from, to, cost);
    }
    if (cost < before || next_[at(from)] == to) {
      note(setOf_[at(from)]);
      note(setOf_[at(to)]);
    }
  }

  Result<GtspSolution> solve(const GtspOptions& options, const Job& job) {
    if (!valid_) {
      return forward(valid_);
    }
    if (Result<void> valid = checkOptions(problem_, options); !valid) {
      return forward(valid);
    }
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while searching the best tour");
    }
    prepare();
    const std::vector<int> warm = options.warmStart ? *options.warmStart : cheapestRemembered();
    GtspRun run(problem_, search_ ? &*search_ : nullptr, options, job);
    const bool around = options.aroundChanges && search_ && !last_.empty();
    Result<GtspSolution> solution = around ? run.around(warm, changed_) : run.whole(warm);
    if (solution) {
      remember(solution->tour);
    }
    return solution;
  }

private:
  void note(int set) {
    if (isChanged_[at(set)] == 0) {
      isChanged_[at(set)] = 1;
      changed_.push_back(set);
    }
  }

  void prepare() {
    if (static_cast<int>(problem_.sets.size()) <= kFewSets) {
      return;
    }
    if (graph_) {
      graph_->refreshNearSets();
    } else {
      graph_.emplace(problem_);
      search_.emplace(problem_, *graph_);
    }
  }

  [[nodiscard]] std::vector<int> cheapestRemembered() const {
    const std::vector<int>* best = nullptr;
    double least = kForbidden;
    for (const std::vector<int>& tour : remembered_) {
      const double cost = tourCost(problem_, tour);
      if (best == nullptr || cost < least) {
        best = &tour;
        least = cost;
      }
    }
    return best != nullptr ? *best : std::vector<int>{};
  }

  void remember(const std::vector<int>& tour) {
    for (const int set : changed_) {
      isChanged_[at(set)] = 0;
    }
    changed_.clear();
    for (const int node : last_) {
      next_[at(node)] = -1;
    }
    last_ = tour;
    for (std::size_t i = 0; i < last_.size(); ++i) {
      next_[at(last_[i])] = last_[i + 1 < last_.size() ? i + 1 : 0];
    }
    if (std::find(remembered_.begin(), remembered_.end(), tour) == remembered_.end()) {
      remembered_.push_front(tour);
      remembered_.resize(std::min(remembered_.size(), kRemembered));
    }
  }

  GtspProblem problem_;
  Result<void> valid_;
  std::vector<int> setOf_;
  std::optional<SetGraph> graph_;
  std::optional<TourSearch> search_;
  std::vector<int> last_;                    ///< the tour of the last solution
  std::vector<int> next_;                    ///< by node: the one behind it in that tour, -1 if it is not in it
  std::deque<std::vector<int>> remembered_;  ///< tours of solutions, newest first
  std::vector<int> changed_;                 ///< sets where an arc of the last tour changed or an arc became cheaper
  std::vector<char> isChanged_;              ///< by set
};

GtspSolver::GtspSolver(GtspProblem problem) : state_(std::make_unique<State>(std::move(problem))) {}
GtspSolver::~GtspSolver() = default;
GtspSolver::GtspSolver(GtspSolver&&) noexcept = default;
GtspSolver& GtspSolver::operator=(GtspSolver&&) noexcept = default;

const GtspProblem& GtspSolver::problem() const {
  return state_->problem();
}

void GtspSolver::set(int from, int to, double cost) {
  state_->set(from, to, cost);
}

void GtspSolver::raise(int from, int to, double cost) {
  state_->set(from, to, std::max(cost, problem().at(from, to)));
}

Result<GtspSolution> GtspSolver::solve(const GtspOptions& options, const Job& job) {
  return state_->solve(options, job);
}

Result<GtspSolution> solveGtsp(const GtspProblem& problem, const GtspOptions& options, const Job& job) {
  return GtspSolver(problem).solve(options, job);
}

}  // namespace vp::tour
