#pragma once

#include "core/audit/ground.h"
#include "core/audit/sample_air.h"
#include "core/audit/sample_flight.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vp::audit {

/// What a height may be short of by the arithmetic of metre steps [m]: 1e-5 of what a glide loses, by halving the steps (tst_audit).
inline constexpr double kHeightTolerance = 0.01;
/// Most unsafe samples that a report lists; all are counted.
inline constexpr std::size_t kMostListed = 100;

struct AuditInput {
  const mission::Plan& plan;
  std::function<Result<GroundLookup>()> newLookup;  ///< called once by each thread
  std::vector<geo::Point> sitePlaces = {};          ///< of the plan's sites by their degrees, found anew; none: the plan's own
  std::uint64_t samples = 1000;
  std::uint64_t seed = 1;
  int threads = 1;
};

/** Where the engine of a sample stopped, and in what air. */
struct EngineStop {
  std::uint64_t sample = 0;  ///< its number, from 0
  std::string track;         ///< "tour", "departure" or "arrival"
  std::size_t point = 0;     ///< decision point before it on that track
  geo::Point where;
  double altitude = 0.0;  ///< m MSL
  LevelWind wind;         ///< at that altitude
  double mass_kg = 0.0;
  int site = -1;  ///< that the glide leads to
};

/** What is left where least is left. */
struct LeastMargin {
  EngineStop stop;
  LeastPlace place;
};

/** A sample that does not keep what the plan promises. */
struct UnsafePoint {
  EngineStop stop;
  LeastPlace place;  ///< where it fails; `left` is below zero by what is missing, or 0 where it is no height that is missing
  std::string text;
};

struct AuditReport {
  std::uint64_t samples = 0;  ///< flown
  std::uint64_t seed = 0;
  std::uint64_t unsafe = 0;
  std::vector<UnsafePoint> unsafePoints;  ///< the first kMostListed by number
  std::array<std::optional<LeastMargin>, kMarginKinds> least;
  double tourLength = 0.0;      ///< m, that the samples are spread over
  std::uint64_t glides = 0;     ///< different glides flown, each cut into metres and put on its ground once
  double metresFlown = 0.0;     ///< by all samples
  double metresOfGround = 0.0;  ///< of different path that ground was looked up under
  double steepestBank_deg = 0.0;
  double longest_s = 0.0;  ///< from the engine stop to the landing

  [[nodiscard]] bool isSafe() const { return unsafe == 0 && samples > 0; }
};

/** "tour.clearance" and so on. */
const char* nameOf(MarginKind kind);

/** Lets the engine stop at random places of a plan and flies what the plan promises from there, metre by metre.
 *
 *  The same seed gives the same report, whatever the number of threads.
 *  @errors Cancelled; OutOfRange where the plan has no way that a glide is promised on, or numbers that cannot be flown at all; those of newLookup
 *  @threads starts `threads` of its own   @cost 40 ns a metre and sample, 2 us a metre of different path
 *  @source README.md */
Result<AuditReport> audit(const AuditInput& input, const Job& job);

}  // namespace vp::audit
