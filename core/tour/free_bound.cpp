#include "core/tour/free_bound.h"

#include "core/tour/gtsp.h"

#include <algorithm>

namespace vp::tour {

Result<double> freeLowerBound(const landing::AltitudeFloor& floor, const std::vector<VisitPose>& visits, double beta, const Job& job) {
  GtspProblem problem;
  std::vector<geo::Point> places;
  double penalty = 0.0;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (i > 0 && visits[i].target == visits[i - 1].target) {
      continue;
    }
    problem.sets.push_back({problem.nodes++});
    places.push_back(visits[i].pose.point());
    penalty += beta * std::max(0.0, floor.at(places.back()) - visits[i].altitude);
  }
  if (problem.nodes < 2) {
    return penalty;
  }
  for (const geo::Point& from : places) {
    for (const geo::Point& to : places) {
      problem.cost.push_back(geo::distance(from, to));
    }
  }
  GtspOptions options;
  options.effort = 0.1;  // the bound counts, not the tour
  const Result<GtspSolution> solution = solveGtsp(problem, options, job);
  return solution ? Result<double>(penalty + solution->lowerBound) : forward(solution);
}

}  // namespace vp::tour
