#include "core/safety/layered_glide.h"

#include "core/safety/cell_walk.h"
#include "core/safety/descent.h"
#include "core/safety/ground_path.h"
#include "core/safety/limits.h"

#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSpansPerPoll = 4096;  // about 0.5 ms

/** Height asked for at a place of a piece: ground + asked [m MSL]. */
struct Demand {
  double at = 0.0;  // m along the piece
  double ground = 0.0;
  double asked = 0.0;
};

/** One piece of a glide, with all places on it that may decide, in order. */
struct Stage {
  geo::Pose start;
  flight::Piece piece;
  Descent descent;
  const LastPart* part = nullptr;
  double rollCost = 0.0;  // m
  std::vector<Demand> demands;
};

/** Walks over the ground first, then flies down from the altitude given and back up from what is asked for. */
class LayeredGlide {
public:
  LayeredGlide(const GlideQuery& query, GlideRates& rates, CellWalk& walk, const Job& job) : query_(query), rates_(rates), walk_(walk), job_(job) {
    glide_.end = query.start;
    glide_.clearanceAt = glide_.afterRollingAt = query.start.point();
    glide_.clearanceStart = -kInfinity;
  }

  GlideExamination fly(const SplitGlide& pieces);

private:
  void addStage(const flight::Piece& piece, Descent descent, const LastPart* part, double rollCost = 0.0);
  void collectDemands(Stage& stage);
  void addDecidingPlaces(Stage& stage, const Span& span);
  void flyDown();
  void noteRolling(const Stage& stage, double at, double above);
  void flyUp();

  const GlideQuery& query_;
  GlideRates& rates_;
  CellWalk& walk_;
  const Job& job_;
  std::vector<Stage> stages_;
  GlideExamination glide_;
};

/// Where the clearance asked for falls along the way, a stretch of constant ground may also be decided at its start, at a break of the loss, at a
/// kink of the clearance, or where the height asked for passes an altitude at which the loss changes.
void LayeredGlide::addDecidingPlaces(Stage& stage, const Span& span) {
  std::vector<double> places{span.from};
  double next = stage.descent.nextBreak(span.from);
  while (next < span.to) {
    places.push_back(next);
    next = stage.descent.nextBreak(next);
  }
  const double slope = *stage.part->surfaceSlope;
  const double begins = stage.piece.length - stage.part->surfaceStart;
  const auto addWhere = [&](double asked) {  // the sloping part of the surface is so high there
    const double at = begins - asked / slope;
    if (asked >= 0.0 && asked <= query_.clearance && at > span.from && at < span.to) {
      places.push_back(at);
    }
  };
  addWhere(0.0);
  addWhere(query_.clearance);
  for (const double edge : rates_.edges()) {
    addWhere(edge - span.ground);
  }
  std::sort(places.begin(), places.end());
  for (const double at : places) {
    stage.demands.push_back({at, span.ground, stage.part->clearanceAt(stage.piece.length - at, query_.clearance)});
  }
}

void LayeredGlide::collectDemands(Stage& stage) {
  walk_.start(stage.start, stage.piece);
  Span span;
  for (int count = 0; walk_.next(span); ++count) {
    if (count % kSpansPerPoll == kSpansPerPoll - 1 && job_.stopRequested()) {
      return;
    }
    if (!span.isKnown()) {
      glide_.unknownAt = poseOn(stage.start, stage.piece, span.from).point();
      return;
    }
    if (stage.part != nullptr && stage.part->surfaceSlope) {
      addDecidingPlaces(stage, span);
    }
    const double asked = stage.part != nullptr ? stage.part->clearanceAt(stage.piece.length - span.to, query_.clearance) : query_.clearance;
    stage.demands.push_back({span.to, span.ground, asked});
  }
}

void LayeredGlide::addStage(const flight::Piece& piece, Descent descent, const LastPart* part, double rollCost) {
  Stage stage{glide_.end, piece, std::move(descent), part, rollCost, {}};
  const bool isStart = stages_.empty();  // the start itself, also of a glide without pieces
  if (!glide_.unknownAt && (isStart || piece.length > 0.0)) {
    collectDemands(stage);
  }
  glide_.end = endOfPiece(glide_.end, piece);
  glide_.length += piece.length;
  stages_.push_back(std::move(stage));
}

void LayeredGlide::flyDown() {
  double height = *query_.altitude;
  glide_.clearanceLeft = glide_.aboveGround = glide_.afterRolling = kInfinity;
  for (Stage& stage : stages_) {
    double at = 0.0;
    if (stage.part != nullptr) {
      glide_.atGate = height;
    }
    for (const Demand& demand : stage.demands) {
      height = stage.descent.down(at, height, demand.at);
      at = demand.at;
      const double above = height - demand.ground;
      if (!(demand.asked < query_.clearance)) {
        glide_.aboveGround = std::min(glide_.aboveGround, above);
        noteRolling(stage, at, above);
      }
      if (above - demand.asked < glide_.clearanceLeft) {
        glide_.clearanceLeft = above - demand.asked;
        glide_.clearanceGround = demand.ground;
        glide_.clearanceAsked = demand.asked;
        glide_.clearanceAt = poseOn(stage.start, stage.piece, at).point();
      }
    }
    height = stage.descent.down(at, height, stage.piece.length);
  }
  glide_.arrival = height;
  if (stages_.back().part == nullptr) {
    glide_.atGate = height;
  }
  // What is missing at the start within the tolerance is not missing further on, where it may have become more.
  const double started = *query_.altitude + kAltitudeTolerance;
  glide_.arrival = started >= glide_.arrivalStart ? std::max(glide_.arrival, query_.arrival) : glide_.arrival;
  glide_.clearanceLeft = started >= glide_.clearanceStart ? std::max(glide_.clearanceLeft, 0.0) : glide_.clearanceLeft;
  glide_.afterRolling = started >= glide_.rollingStart ? std::max(glide_.afterRolling, 0.0) : glide_.afterRolling;
  glide_.atGate = started >= glide_.keyStart && query_.key ? std::max(glide_.atGate, *query_.key) : glide_.atGate;
}

void LayeredGlide::noteRolling(const Stage& stage, double at, double above) {
  if (!query_.rollCosts.empty() && above - stage.rollCost < glide_.afterRolling) {
    glide_.afterRolling = above - stage.rollCost;
    glide_.rollCostThere = stage.rollCost;
    glide_.afterRollingAt = poseOn(stage.start, stage.piece, at).point();
  }
}

void LayeredGlide::flyUp() {
  double arrival = query_.arrival;
  double clear = -kInfinity;
  double rolled = -kInfinity;
  double key = query_.key.value_or(-kInfinity);
  glide_.gateLowest = arrival;
  for (std::size_t i = stages_.size(); i-- > 0;) {
    Stage& stage = stages_[i];
    Descent& descent = stage.descent;
    const double length = stage.piece.length;
    double at = length;
    for (std::size_t k = stage.demands.size(); k-- > 0;) {
      const Demand& demand = stage.demands[k];
      clear = std::max(descent.up(at, clear, demand.at), demand.ground + demand.asked);
      rolled = descent.up(at, rolled, demand.at);
      if (!query_.rollCosts.empty() && !(demand.asked < query_.clearance)) {
        rolled = std::max(rolled, demand.ground + stage.rollCost);
      }
      at = demand.at;
    }
    clear = descent.up(at, clear, 0.0);
    rolled = descent.up(at, rolled, 0.0);
    arrival = descent.up(length, arrival, 0.0);
    if (stage.part != nullptr) {
      glide_.gateLowest = std::max(arrival, clear);
    } else {
      key = descent.up(length, key, 0.0);
    }
  }
  glide_.gateLowest = std::max(glide_.gateLowest, query_.key.value_or(-kInfinity));
  glide_.rollingStart = rolled;
  glide_.arrivalStart = arrival;
  glide_.keyStart = key;
  glide_.clearanceStart = glide_.unknownAt ? kInfinity : clear;
}

GlideExamination LayeredGlide::fly(const SplitGlide& pieces) {
  addStage({}, Descent(0.0), nullptr);
  for (std::size_t i = 0; i < pieces.before.size(); ++i) {
    const flight::Piece& piece = pieces.before[i];
    addStage(piece, Descent(rates_, glide_.end.heading, piece), nullptr, rollCostOf(query_, i));
    if (job_.stopRequested()) {
      return glide_;
    }
  }
  if (pieces.last.length > 0.0) {
    addStage(pieces.last, pieces.part.slope ? Descent(*pieces.part.slope) : Descent(rates_, glide_.end.heading, pieces.last), &pieces.part,
             query_.rollCosts.empty() ? 0.0 : query_.rollCosts.back());
  }
  flyUp();
  if (query_.altitude) {
    flyDown();
  }
  return glide_;
}

}  // namespace

GlideExamination examineLayered(const GlideQuery& query, const SplitGlide& pieces, GlideRates& rates, CellWalk& walk, const Job& job) {
  return LayeredGlide(query, rates, walk, job).fly(pieces);
}

}  // namespace vp::safety
