// The search of refine.h. Of refine.cpp and refine_order.cpp only.
#pragma once

#include "core/base/quantity.h"
#include "core/tour/gtsp_random.h"
#include "core/tour/leg_store.h"
#include "core/tour/refine.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vp::tour {

/** The search: a tour, what it costs, and the moves. @threads one object per job */
class TourRefiner {
public:
  TourRefiner(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits, const SegmentSettings& settings,
              const RefineOptions& options, const Job& job);
  Result<RefineResult> run(const std::vector<VisitPose>& missing);

private:
  using Tour = std::vector<int>;  // pose numbers in flying order

  static constexpr double kLeastGain = 0.1;  // m; smaller gains are not worth a change
  static constexpr int kFarHeadings = 8;     // headings tried where a target is put to another place
  static constexpr double kTwoPi = 2.0 * Angle::kPi;

  /// Long legs have more points to ask at: so many times more queries than legs of kUsualPoints.
  double legFactor(double step);
  void findNeighbours(const std::vector<VisitPose>& visits);
  [[nodiscard]] bool areNear(int a, int b) const;
  [[nodiscard]] bool isOver() const { return job_.stopRequested() || builder_.queries() - queriesAtStart_ >= mostQueries_; }

  /// Cost of the loop if it is below `below`; otherwise some number that is not. Finds no more about the legs than that needs.
  double costOf(const Tour& tour, double below);

  /// Takes a tour if it costs less than `below`.
  bool take(const Tour& candidate, double below);
  bool take(const Tour& candidate) { return take(candidate, cost_ - kLeastGain); }

  [[nodiscard]] int turned(int pose, double heading);
  [[nodiscard]] int withWord(int pose, std::optional<flight::Word> word);
  [[nodiscard]] int reversed(int pose) { return turned(withWord(pose, std::nullopt), store_.visit(pose).pose.heading + Angle::kPi); }

  bool tryHeading(std::size_t place, double heading);
  /// Turns headings by steps that are halved where neither side is better.
  void turnHeadings();
  /// Headings far from the present ones, and along the straight line to the next target.
  bool tryFarHeadings();
  bool tryWords();

  /// Words belong to legs: where the next target is another one, the shortest word counts again.
  void dropWords(Tour& candidate);
  /// The tour with the stretch [first, first + length) taken out.
  void takeOut(std::size_t first, std::size_t length, Tour& stretch, Tour& rest) const;
  /// Puts a stretch between rest[place] and the one behind it.
  [[nodiscard]] Tour joined(const Tour& rest, std::size_t place, const Tour& stretch);

  /// Moves stretches of up to three targets to another place, either way round, a single one with other headings.
  bool moveStretches(double below);
  bool tryHeadingsAt(const Tour& rest, std::size_t place, int pose, double below);
  /// Flies a stretch the other way round.
  bool turnStretches(double below);

  /// Puts a target to its cheapest place, by some headings.
  void insert(const VisitPose& visit);
  void resetTurns(double step) { turn_.assign(targets_, step); }

  /// Down to where no single move helps.
  void improve();
  std::size_t drawn(std::size_t n) { return static_cast<std::size_t>(random_.below(static_cast<int>(n))); }

  /// A random stretch put to a random place, or turned round; whatever it costs up to `below`.
  bool changeOrder(double below);
  /// Refines from changed orders and keeps the best, until the queries are used up or nothing new is found for long.
  void tryChangedOrders();

  SegmentBuilder& builder_;
  const Job& job_;
  LegStore store_;
  LoopCost loopCost_;
  Random random_;
  std::int64_t queriesAtStart_ = 0;
  std::int64_t mostQueries_ = 0;
  std::size_t targets_ = 0;
  int firstTarget_ = 0;
  std::vector<char> isNeighbour_;
  std::vector<double> turn_;  ///< step of the heading of each target, rad
  Tour tour_;
  double cost_ = 0.0;
  std::vector<LegStore::Leg*> legs_;
  std::vector<const LegShape*> shapes_;
  std::vector<LoopVisit> loopVisits_;
  RefineResult result_;
};

}  // namespace vp::tour
