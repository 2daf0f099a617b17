#include "core/tour/gtsp_search.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

namespace {

using Clock = std::chrono::steady_clock;

// Measured on the instances named in README.md; temperatures are in mean arcs of the tour a round starts from.
constexpr double kHot = 0.5;
constexpr double kHotWarm = 0.8;  // a warm start must be left far enough to find what changed costs open up
constexpr double kCold = 0.04;
constexpr double kRewarmed = 0.12;  // every other round of a cold search goes on from the best tour
constexpr int kMostRemoved = 12;
constexpr int kStretchPercent = 60;      // moves that turn or move a stretch, where these help
constexpr int kFewStretchPercent = 15;   // elsewhere (asymmetric costs without geometry)
constexpr double kUsefulGainRate = 0.1;  // of the gains per move of ruin and recreate
constexpr int kMovePercent = 20;         // of these, that move it
constexpr double kStepsPerCube = 0.1;
constexpr double kLeastSteps = 1000.0;
constexpr double kMostSteps = 500'000.0;
constexpr double kStepsAround = 40.0;      // for each set where an arc changed
constexpr double kSetsOfHotAround = 20.0;  // the more sets, the smaller the part of the tour that should change
constexpr double kLeastHotAround = 0.4;
constexpr double kMostHotAround = 1.0;
constexpr int kMostRemovedAround = 8;

}  // namespace

TourSearch::TourSearch(const GtspProblem& problem, const SetGraph& graph)
    : problem_(problem), setOfNode_(setOfNodes(problem)), graph_(graph), moves_(graph_, random_) {
  begin(1, 1.0);
}

void TourSearch::begin(std::uint64_t seed, double effort) {
  random_ = Random(seed);
  moves_.restart();
  effort_ = effort;
  stretchPercent_ = kStretchPercent;
  mostRemoved_ = kMostRemoved;
  stretch_ = {};
  ruin_ = {};
  best_.clear();
  bestCost_ = kForbidden;
  scaledBest_ = kForbidden;
  warm_ = false;
  roundsWithoutGain_ = 0;
  rounds_ = 0;
}

void TourSearch::startFrom(const std::vector<int>& tour) {
  offer(tour);
  warm_ = true;
}

bool TourSearch::runRound(const Deadline& deadline, const Job& job) {
  const double before = bestCost_;
  const double cube = std::pow(graph_.sets(), 3.0);
  const double usual = std::clamp(kStepsPerCube * cube, kLeastSteps, kMostSteps);
  const auto steps = static_cast<std::int64_t>(std::max(effort_ * usual, 100.0));
  const bool goOn = !best_.empty() && (rounds_ % 2 == (warm_ ? 0 : 1));
  if (goOn) {
    goOnFromBest();
  } else {
    moves_.buildRandomly();
  }
  roundBest_ = moves_.currentCost();
  offerCurrent();
  const double meanArc = typicalArc();
  const bool done = anneal(steps, (warm_ ? kHotWarm : goOn ? kRewarmed : kHot) * meanArc, kCold * meanArc, deadline, job);
  adaptShares();
  ++rounds_;
  roundsWithoutGain_ = bestCost_ < before ? 0 : roundsWithoutGain_ + 1;
  return done;
}

void TourSearch::goOnFromBest() {
  std::vector<int> slots;
  for (const int node : best_) {
    slots.push_back(graph_.slotOf(node));
  }
  moves_.setCurrent(slots);
}

bool TourSearch::searchAround(const std::vector<int>& sets, const Deadline& deadline, const Job& job) {
  goOnFromBest();
  roundBest_ = moves_.currentCost();
  const double meanArc = typicalArc();
  moves_.focusOn(sets);
  mostRemoved_ = kMostRemovedAround;
  const auto steps = static_cast<std::int64_t>(kStepsAround * static_cast<double>(sets.size()));
  const double hot = std::clamp(kSetsOfHotAround / graph_.sets(), kLeastHotAround, kMostHotAround);
  const bool done = anneal(steps, hot * meanArc, kCold * meanArc, deadline, job);
  moves_.focusOn({});
  mostRemoved_ = kMostRemoved;
  ++rounds_;
  return done;
}

/** The mean arc of the current tour, without forbidden arcs and others far out of the ordinary. */
double TourSearch::typicalArc() const {
  std::vector<float> arcs;
  const std::vector<int>& tour = moves_.current();
  for (std::size_t i = 0; i < tour.size(); ++i) {
    arcs.push_back(graph_.cost(tour[i], tour[(i + 1) % tour.size()]));
  }
  std::sort(arcs.begin(), arcs.end());
  const float median = arcs[arcs.size() / 2];
  const float most = median > 0.0F ? 20.0F * median : graph_.forbidden() * 0.99F;
  double sum = 0.0;
  int count = 0;
  for (const float arc : arcs) {
    sum += arc <= most ? arc : 0.0F;
    count += arc <= most ? 1 : 0;
  }
  return std::max(sum / std::max(count, 1), 1e-6);
}

bool TourSearch::anneal(std::int64_t steps, double hot, double cold, const Deadline& deadline, const Job& job) {
  constexpr std::int64_t kCheckEvery = 64;
  const Clock::time_point start = Clock::now();
  double temperature = hot;
  for (std::int64_t i = 0; i < steps; ++i) {
    if (i % kCheckEvery == 0) {
      if (job.stopRequested()) {
        return false;
      }
      double done = static_cast<double>(i) / static_cast<double>(steps);
      if (deadline) {  // cools in time for it
        done = std::max(done, std::chrono::duration<double>(Clock::now() - start) / std::chrono::duration<double>(*deadline - start));
      }
      if (!(done < 1.0)) {
        break;
      }
      temperature = hot * std::pow(cold / hot, done);
    }
    const float before = moves_.currentCost();
    if (tryMove() >= before - temperature * std::log(random_.unit())) {
      continue;
    }
    moves_.accept();
    if (moves_.currentCost() < before) {
      ++(stretchMove_ ? stretch_ : ruin_).gains;
      moves_.polishCurrent();
    }
    if (moves_.currentCost() < roundBest_) {
      roundBest_ = moves_.currentCost();
      offerCurrent();
    }
  }
  return true;
}

float TourSearch::tryMove() {
  stretchMove_ = random_.below(100) < stretchPercent_;
  ++(stretchMove_ ? stretch_ : ruin_).tries;
  if (!stretchMove_) {
    return moves_.ruinAndRecreate(mostRemoved_);
  }
  return random_.below(100) < kMovePercent ? moves_.moveStretch() : moves_.reverseStretch();
}

/** Moves that seldom gain are tried less in the next round. */
void TourSearch::adaptShares() {
  const auto rate = [](const MoveRecord& record) { return static_cast<double>(record.gains + 1) / static_cast<double>(record.tries + 1); };
  stretchPercent_ = rate(stretch_) >= kUsefulGainRate * rate(ruin_) ? kStretchPercent : kFewStretchPercent;
}

void TourSearch::offerCurrent() {
  if (!best_.empty() && std::isfinite(bestCost_) && roundBest_ * (1.0 - 1e-5) > scaledBest_) {
    return;
  }
  std::vector<int> tour;
  for (const int slot : moves_.current()) {
    tour.push_back(graph_.nodeOf(slot));
  }
  offer(tour);
}

void TourSearch::offer(const std::vector<int>& tour) {
  std::vector<int> chosen = bestNodesForOrder(problem_, setOfNode_, tour);
  const double cost = tourCost(problem_, chosen);
  if (best_.empty() || cost < bestCost_) {
    best_ = std::move(chosen);
    bestCost_ = cost;
    scaledBest_ = cost * graph_.scale();
  }
}

}  // namespace vp::tour
