#pragma once

#include "core/base/job.h"
#include "core/tour/gtsp_reduced.h"

#include <chrono>
#include <cstdint>
#include <optional>

namespace vp::tour {

/** Raises the constant by cuts: a group of nodes that holds a whole set and no node of the root set is left by every
 *  tour, so the cheapest arc that leaves it may be taken off all that do. Groups cut through other sets, which prices of
 *  1-arborescences between whole sets cannot do: on symmetric costs there and back between two nodes would be two sides of
 *  a cheap "tour" that visits a set with halves of different nodes.
 *  Goes on until every set reaches the root set by arcs that cost nothing, or until `budget` arcs were looked at or it is
 *  too late.
 *  @pre no cost is negative      @return false if stopped by the job
 *  @source Wong 1984, "A dual ascent approach for Steiner tree problems on a directed graph" (here a set is a terminal) */
bool raiseCuts(ReducedCosts& costs, int root, std::int64_t& budget, const std::optional<std::chrono::steady_clock::time_point>& deadline,
               const Job& job);

}  // namespace vp::tour
