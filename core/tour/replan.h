#pragma once

#include "core/tour/planner.h"

namespace vp::tour {

/** What the last call of a Planner took over from the one before. */
struct PlanReuse {
  bool roadmap = false;  ///< glides and terrain pyramid
  bool tour = false;     ///< order and headings; only changed targets were placed anew
};

/** Plans like planTour, again and again while a mission is edited, and keeps what stays valid between calls:
 *  - terrain pyramid: while the terrain is the same object;
 *  - roadmap: while terrain, sites, aircraft, wind, clearances and roadmap settings are the same and its area holds what is needed.
 *    A closed or added runway builds it anew, so no plan ever uses a glide to a runway that is not in its input;
 *  - order and headings: with Refine::Full, while the roadmap stays, most targets are where they were and what legs are measured
 *    by is the same. Missing targets are taken out, new and moved ones go where they cost least, and the tour is refined.
 *    Where that finds no tour the search starts afresh, and so it does when no target has changed: planning again without an
 *    edit is how to get a whole search and its lower bound after plans over reused tours.
 *  Every plan is built and judged as one from planTour: what is reused is a proposal. A plan over a reused tour has no lower
 *  bound. The same calls in the same order give the same plans.
 *  @threads one call at a time; inputs are value snapshots, so the object may live beside a worker and outlast its jobs */
class Planner {
public:
  /** @errors as planTour; after an error, Cancelled included, the object keeps what it had */
  Result<mission::Plan> plan(const PlanInput& input, const Job& job, PlanTimes* times = nullptr, const PlanObserver& observer = {},
                             PlanFailure* failure = nullptr);

  [[nodiscard]] const PlanReuse& reused() const { return reused_; }

private:
  [[nodiscard]] PlanBasis usable(const PlanInput& input) const;

  std::optional<PlanInput> last_;
  PlanBasis basis_;
  PlanReuse reused_;
};

}  // namespace vp::tour
