#include "core/tour/gtsp_moves.h"

#include "core/tour/gtsp_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vp::tour {

namespace {

// Measured on the Dubins and GTSPLIB instances named in README.md.
constexpr int kInsertionNeighbours = 15;  // near sets whose two gaps are tried
constexpr std::size_t kPlaces = 4;        // best gaps in which the neighbours choose again
constexpr int kLongestString = 8;
constexpr double kSkipChance = 0.01;  // a gap is overlooked now and then ("blinks")
constexpr int kMoveNeighbours = 10;
constexpr int kReach = 3;  // sets on each side of a change that choose again
constexpr float kHuge = std::numeric_limits<float>::max();

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace

TourMoves::TourMoves(const SetGraph& graph, Random& random) : graph_(graph), random_(random), chooser_(graph), sets_(graph.sets()) {
  const std::size_t n = at(sets_);
  position_.resize(n);
  arc_.resize(n);
  link_.resize(n);
  seen_.resize(n);
  next_.resize(n);
  previous_.resize(n);
  slot_.resize(n);
  inTour_.resize(n);
  touched_.resize(n);
  fresh_.resize(n);
  int widest = 0;
  for (int set = 0; set < sets_; ++set) {
    widest = std::max(widest, graph.width(set));
  }
  arrive_.resize(at(widest));
  leave_.resize(at(widest));
  restart();
}

void TourMoves::restart() {
  focus_.clear();
  sampleSkip();
}

void TourMoves::setCurrent(const std::vector<int>& slots) {
  candidate_ = slots;
  candidateCost_ = 0.0F;
  accept();
}

void TourMoves::accept() {
  current_.swap(candidate_);
  currentCost_ = 0.0F;
  for (int i = 0; i < sets_; ++i) {
    const int slot = current_[at(i)];
    const int set = graph_.setOf(slot);
    position_[at(set)] = i;
    arc_[at(set)] = graph_.cost(slot, current_[at(i + 1 < sets_ ? i + 1 : 0)]);
    currentCost_ += arc_[at(set)];
  }
}

void TourMoves::polishCurrent() {
  candidate_ = current_;
  chooser_.choose(candidate_, random_.below(sets_), sets_ - 1);
  accept();
}

void TourMoves::buildRandomly() {
  std::vector<int> order(at(sets_));
  std::iota(order.begin(), order.end(), 0);
  for (int k = sets_ - 1; k > 0; --k) {
    std::swap(order[at(k)], order[at(random_.below(k + 1))]);
  }
  std::fill(inTour_.begin(), inTour_.end(), 0);
  const int first = order[0];
  next_[at(first)] = previous_[at(first)] = first;
  slot_[at(first)] = graph_.first(first);
  inTour_[at(first)] = 1;
  link_[at(first)] = 0.0F;
  count_ = 1;
  for (int k = 1; k < sets_; ++k) {
    putBack(order[at(k)]);
  }
  readLists(first);
  accept();
  polishCurrent();
}

float TourMoves::ruinAndRecreate(int mostRemoved) {
  openLists();
  removeStrings(1 + random_.below(std::clamp(mostRemoved, 1, sets_ - 2)));
  for (int k = static_cast<int>(removed_.size()) - 1; k > 0; --k) {
    std::swap(removed_[at(k)], removed_[at(random_.below(k + 1))]);
  }
  for (const int set : removed_) {
    putBack(set);
  }
  readLists(removed_.front());
  return finishCandidate();
}

void TourMoves::openLists() {
  int previous = graph_.setOf(current_.back());
  for (const int slot : current_) {
    const int set = graph_.setOf(slot);
    slot_[at(set)] = slot;
    previous_[at(set)] = previous;
    next_[at(previous)] = set;
    previous = set;
  }
  std::fill(inTour_.begin(), inTour_.end(), 1);
  std::fill(touched_.begin(), touched_.end(), 0);
  link_ = arc_;
  count_ = sets_;
}

void TourMoves::removeStrings(int count) {
  removed_.clear();
  const int seed = pickSet();
  const int* nearest = graph_.nearSets(seed);
  for (int rank = -1; static_cast<int>(removed_.size()) < count; ++rank) {
    const int set = rank < 0 ? seed : rank < graph_.neighbours() ? nearest[rank] : random_.below(sets_);
    if (inTour_[at(set)] == 0 || (rank > 0 && random_.below(4) == 0)) {
      continue;
    }
    const int length = 1 + random_.below(std::min(kLongestString, count - static_cast<int>(removed_.size())));
    const int from = position_[at(set)] - random_.below(length);
    for (int k = 0; k < length; ++k) {
      const int member = graph_.setOf(current_[at((from + k + sets_) % sets_)]);
      if (inTour_[at(member)] != 0) {
        takeOut(member);
      }
    }
  }
}

void TourMoves::takeOut(int set) {
  const int before = previous_[at(set)];
  const int behind = next_[at(set)];
  next_[at(before)] = behind;
  previous_[at(behind)] = before;
  inTour_[at(set)] = 0;
  --count_;
  measureLink(before);
  touch(before);
  touch(behind);
  removed_.push_back(set);
}

void TourMoves::measureLink(int set) {
  link_[at(set)] = graph_.cost(slot_[at(set)], slot_[at(next_[at(set)])]);
}

void TourMoves::putBack(int set) {
  findPlaces(set);
  if (count_ >= 4 && insertWithNeighbours(set)) {
    return;
  }
  const int after = places_[0].after;
  const float* arrive = graph_.out(slot_[at(after)], set);
  const float* leave = graph_.in(slot_[at(next_[at(after)])], set);
  insert(set, graph_.first(set) + leastSum(arrive, leave, graph_.size(set)).index, after);
}

void TourMoves::findPlaces(int set) {
  places_.clear();
  ++search_;
  const int* nearest = graph_.nearSets(set);
  int tried = 0;
  for (int rank = 0; rank < graph_.neighbours() && tried < kInsertionNeighbours; ++rank) {
    const int other = nearest[rank];
    if (inTour_[at(other)] == 0) {
      continue;
    }
    ++tried;
    considerPlace(set, other);
    considerPlace(set, previous_[at(other)]);
  }
  if (places_.empty()) {
    int other = random_.below(sets_);
    while (inTour_[at(other)] == 0) {
      other = other + 1 < sets_ ? other + 1 : 0;
    }
    places_.push_back({0.0F, other});
  }
}

void TourMoves::considerPlace(int set, int after) {
  if (seen_[at(after)] == search_) {
    return;
  }
  seen_[at(after)] = search_;
  if (--untilSkip_ < 0) {
    sampleSkip();
    return;
  }
  const int tail = slot_[at(after)];
  const int head = slot_[at(next_[at(after)])];
  const float* arrive = graph_.out(tail, set);
  const float* leave = graph_.in(head, set);
  Lanes best = least(load(arrive) + load(leave), load(arrive + 4) + load(leave + 4));
  for (int i = 8; i < graph_.width(set); i += 4) {
    best = least(best, load(arrive + i) + load(leave + i));
  }
  const float added = leastLane(best) - link_[at(after)];
  if (places_.size() == kPlaces && added >= places_.back().added) {
    return;
  }
  if (places_.size() < kPlaces) {
    places_.push_back({});
  }
  std::size_t i = places_.size() - 1;
  for (; i > 0 && places_[i - 1].added > added; --i) {
    places_[i] = places_[i - 1];
  }
  places_[i] = {added, after};
}

bool TourMoves::insertWithNeighbours(int set) {
  float bestAdded = kHuge;
  int bestAfter = -1;
  int bestSlot = -1;
  for (const Place& place : places_) {
    const int before = place.after;
    const int behind = next_[at(before)];
    const int outerTail = slot_[at(previous_[at(before)])];
    const int outerHead = slot_[at(next_[at(behind)])];
    minPlus(graph_.out(outerTail, before), graph_.out(graph_.first(before), set), graph_.size(before), graph_.width(set), arrive_.data());
    minPlus(graph_.in(outerHead, behind), graph_.in(graph_.first(behind), set), graph_.size(behind), graph_.width(set), leave_.data());
    const LeastSum best = leastSum(arrive_.data(), leave_.data(), graph_.size(set));
    const float added = best.value - (link_[at(previous_[at(before)])] + link_[at(before)] + link_[at(behind)]);
    if (added < bestAdded) {
      bestAdded = added;
      bestAfter = before;
      bestSlot = graph_.first(set) + best.index;
    }
  }
  if (bestAfter < 0) {
    return false;
  }
  const int behind = next_[at(bestAfter)];
  const int outerTail = slot_[at(previous_[at(bestAfter)])];
  const int outerHead = slot_[at(next_[at(behind)])];
  slot_[at(bestAfter)] =
      graph_.first(bestAfter) + leastSum(graph_.out(outerTail, bestAfter), graph_.in(bestSlot, bestAfter), graph_.size(bestAfter)).index;
  slot_[at(behind)] = graph_.first(behind) + leastSum(graph_.out(bestSlot, behind), graph_.in(outerHead, behind), graph_.size(behind)).index;
  insert(set, bestSlot, bestAfter);
  return true;
}

void TourMoves::insert(int set, int slot, int after) {
  const int behind = next_[at(after)];
  next_[at(after)] = set;
  previous_[at(set)] = after;
  next_[at(set)] = behind;
  previous_[at(behind)] = set;
  slot_[at(set)] = slot;
  inTour_[at(set)] = 1;
  ++count_;
  for (const int changed : {previous_[at(after)], after, set, behind}) {
    measureLink(changed);
  }
  touch(after);
  touch(set);
  touch(behind);
}

void TourMoves::readLists(int start) {
  candidate_.resize(at(sets_));
  int set = start;
  for (int& slot : candidate_) {
    slot = slot_[at(set)];
    set = next_[at(set)];
  }
}

float TourMoves::reverseStretch() {
  const int set = pickSet();
  const int other = near(set, kMoveNeighbours);
  int from = position_[at(set)] + 1;
  int to = position_[at(other)];
  if (from > to) {  // the other lies before: turn the stretch in front of the set, so that the other is followed by it
    from = position_[at(other)] + 1;
    to = position_[at(set)];
  }
  candidate_ = current_;
  std::reverse(candidate_.begin() + from, candidate_.begin() + to + 1);
  std::fill(touched_.begin(), touched_.end(), 0);
  touch(graph_.setOf(candidate_[at(from == 0 ? sets_ - 1 : from - 1)]));
  for (int i = from; i <= to; ++i) {
    touch(graph_.setOf(candidate_[at(i)]));
  }
  touch(graph_.setOf(candidate_[at(to + 1 < sets_ ? to + 1 : 0)]));
  return finishCandidate();
}

float TourMoves::moveStretch() {
  const int set = pickSet();
  const int other = near(set, kMoveNeighbours);
  const int length = 1 + random_.below(std::min(30, sets_ / 2));
  const int from = random_.below(2) == 0 ? position_[at(other)] : (position_[at(other)] - length + 1 + sets_) % sets_;
  const int ahead = (position_[at(set)] - from + sets_) % sets_;
  if (ahead < length) {  // the goal lies in the stretch itself
    return reverseStretch();
  }
  candidate_.clear();
  const auto append = [&](int first, int last) {
    for (int i = first; i <= last; ++i) {
      candidate_.push_back(current_[at((from + i) % sets_)]);
    }
  };
  append(length, ahead);
  const std::ptrdiff_t start = std::ssize(candidate_);
  append(0, length - 1);
  std::fill(touched_.begin(), touched_.end(), 0);
  if (random_.below(3) == 0) {
    std::reverse(candidate_.begin() + start, candidate_.end());
    for (std::ptrdiff_t i = start; i < std::ssize(candidate_); ++i) {
      touch(graph_.setOf(candidate_[static_cast<std::size_t>(i)]));
    }
  }
  append(ahead + 1, sets_ - 1);
  for (const int i : {-1, 0, length - 1, length, ahead, ahead + 1}) {
    touch(graph_.setOf(current_[at((from + i + sets_) % sets_)]));
  }
  return finishCandidate();
}

int TourMoves::pickSet() {
  return focus_.empty() ? random_.below(sets_) : focus_[at(random_.below(static_cast<int>(focus_.size())))];
}

int TourMoves::near(int set, int closest) {
  return graph_.nearSets(set)[random_.below(std::min(closest, graph_.neighbours()))];
}

/** Chooses nodes anew around what was touched and sums up the cost. */
float TourMoves::finishCandidate() {
  // fresh_: positions at most kReach - 1 away from a touched one
  int sinceTouched = kReach;
  for (int i = -kReach; i < sets_; ++i) {
    const int position = i < 0 ? i + sets_ : i;
    sinceTouched = touched_[at(graph_.setOf(candidate_[at(std::max(position, 0))]))] != 0 ? 0 : sinceTouched + 1;
    fresh_[at(std::max(position, 0))] = sinceTouched < kReach ? 1 : 0;
  }
  sinceTouched = kReach;
  for (int i = sets_ - 1 + kReach; i >= 0; --i) {
    const int position = i < sets_ ? i : std::min(i - sets_, sets_ - 1);
    sinceTouched = touched_[at(graph_.setOf(candidate_[at(position)]))] != 0 ? 0 : sinceTouched + 1;
    fresh_[at(position)] = static_cast<char>(fresh_[at(position)] | (sinceTouched < kReach ? 1 : 0));
  }
  candidateCost_ = costOfStretches();
  return candidateCost_;
}

float TourMoves::costOfStretches() {
  int start = 0;
  while (start < sets_ && fresh_[at(start)] != 0) {
    ++start;
  }
  if (start == sets_) {
    return chooser_.choose(candidate_, random_.below(sets_), sets_ - 1);
  }
  float sum = 0.0F;
  for (int i = 0; i < sets_;) {
    // here the node at i stays
    const int position = start + i < sets_ ? start + i : start + i - sets_;
    int count = 0;
    const auto freshAt = [&](int k) { return fresh_[at(start + k < sets_ ? start + k : start + k - sets_)] != 0; };
    while (i + 1 + count < sets_ && freshAt(i + 1 + count)) {
      ++count;
    }
    if (count == 0) {
      sum += arc_[at(graph_.setOf(candidate_[at(position)]))];
    } else {
      sum += chooser_.choose(candidate_, position + 1 < sets_ ? position + 1 : 0, count);
    }
    i += count + 1;
  }
  return sum;
}

void TourMoves::sampleSkip() {
  untilSkip_ = static_cast<int>(std::log(random_.unit()) / std::log(1.0 - kSkipChance));
}

}  // namespace vp::tour
