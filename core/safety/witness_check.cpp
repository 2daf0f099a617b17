#include "core/safety/witness_check.h"

#include "core/safety/cell_walk.h"
#include "core/safety/ground_path.h"
#include "core/safety/layered_glide.h"
#include "core/safety/limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSpansPerPoll = 4096;  // about 0.5 ms

bool canBeFlown(const geo::Pose& start, const std::vector<flight::Piece>& pieces) {
  const bool inFrame = std::abs(start.x) <= kFarthest && std::abs(start.y) <= kFarthest && std::abs(start.heading) <= kLargestHeading;
  return inFrame && std::all_of(pieces.begin(), pieces.end(), isIntegrable);
}

/** One piece of a glide, what is lost along it, and the last part if it is that. */
struct FlownPiece {
  const flight::Piece& piece;
  const LossAlong& loss;
  const LastPart* part = nullptr;
  double rollCost = 0.0;  // m
};

/// Visits the places of a span at which the height asked for may be greatest. Ground is constant on it and height is lost along it, so
/// its far end decides where the clearance is constant. On the last part loss plus clearance is linear between these places.
template <typename Visit>
void forEachDecidingPlace(const Span& span, const FlownPiece& flown, double clearance, const Visit& visit) {
  if (flown.part != nullptr && flown.part->surfaceSlope) {
    visit(span.from);
    double at = flown.loss.nextBreak(span.from);
    while (at < span.to) {
      visit(at);
      at = flown.loss.nextBreak(at);
    }
    const double begins = flown.piece.length - flown.part->surfaceStart;
    for (const double kink : {begins, begins - clearance / *flown.part->surfaceSlope}) {
      if (kink > span.from && kink < span.to) {
        visit(kink);
      }
    }
  }
  visit(span.to);
}

/** A glide on which a metre costs the same at every altitude, so that losses add up from its start. */
class LevelledGlide {
public:
  LevelledGlide(const GlideQuery& query, CellWalk& walk, const Job& job) : query_(query), walk_(walk), job_(job) {
    glide_.end = query.start;
    glide_.clearanceAt = query.start.point();
    glide_.clearanceStart = -kInfinity;
  }

  GlideExamination fly(const SplitGlide& pieces, GlideRates& rates);

private:
  void flyPiece(const FlownPiece& flown);
  void goAlong(const FlownPiece& flown);
  void noteRolling(const FlownPiece& flown, double at, double reaching);
  void fromAltitude(double lossToGate);

  const GlideQuery& query_;
  CellWalk& walk_;
  const Job& job_;
  GlideExamination glide_;
  double loss_ = 0.0;
  double gateStart_ = -kInfinity;    // lowest at the gate that keeps the clearance on the last part
  double groundStart_ = -kInfinity;  // lowest start that reaches no ground where the whole clearance is asked for
};

void LevelledGlide::flyPiece(const FlownPiece& flown) {
  walk_.start(glide_.end, flown.piece);
  Span span;
  for (int count = 0; walk_.next(span); ++count) {
    if (count % kSpansPerPoll == kSpansPerPoll - 1 && job_.stopRequested()) {
      return;
    }
    if (!span.isKnown()) {
      glide_.clearanceStart = kInfinity;
      glide_.unknownAt = poseOn(glide_.end, flown.piece, span.from).point();
      return;
    }
    forEachDecidingPlace(span, flown, query_.clearance, [&](double at) {
      const double asked = flown.part != nullptr ? flown.part->clearanceAt(flown.piece.length - at, query_.clearance) : query_.clearance;
      const double needed = span.ground + asked + loss_ + flown.loss.upTo(at);
      if (flown.part != nullptr) {
        gateStart_ = std::max(gateStart_, needed - loss_);
      }
      if (!(asked < query_.clearance)) {
        groundStart_ = std::max(groundStart_, needed - asked);
        noteRolling(flown, at, needed - asked);
      }
      if (needed > glide_.clearanceStart) {
        glide_.clearanceStart = needed;
        glide_.clearanceGround = span.ground;
        glide_.clearanceAsked = asked;
        glide_.clearanceAt = poseOn(glide_.end, flown.piece, at).point();
      }
    });
  }
}

/// @param reaching  lowest start that reaches the ground there
void LevelledGlide::noteRolling(const FlownPiece& flown, double at, double reaching) {
  if (query_.rollCosts.empty()) {
    return;
  }
  if (reaching + flown.rollCost > glide_.rollingStart) {
    glide_.rollingStart = reaching + flown.rollCost;
    glide_.rollCostThere = flown.rollCost;
    glide_.afterRollingAt = poseOn(glide_.end, flown.piece, at).point();
  }
}

/// Flies a piece and goes to its end.
void LevelledGlide::goAlong(const FlownPiece& flown) {
  if (!glide_.unknownAt && flown.piece.length > 0.0) {
    flyPiece(flown);
  }
  glide_.end = endOfPiece(glide_.end, flown.piece);
  glide_.length += flown.piece.length;
  loss_ += flown.piece.length > 0.0 ? flown.loss.upTo(flown.piece.length) : 0.0;
}

GlideExamination LevelledGlide::fly(const SplitGlide& pieces, GlideRates& rates) {
  const flight::Piece nothing;
  const LossAlong none(0.0);
  glide_.afterRollingAt = query_.start.point();
  flyPiece({nothing, none});  // the start itself, also of a glide without pieces
  for (std::size_t i = 0; i < pieces.before.size(); ++i) {
    const flight::Piece& piece = pieces.before[i];
    const LossAlong loss = rates.along(glide_.end.heading, piece);
    goAlong({piece, loss, nullptr, rollCostOf(query_, i)});
    if (job_.stopRequested()) {
      return glide_;
    }
  }
  const double lossToGate = loss_;
  if (pieces.last.length > 0.0) {
    const LossAlong loss = pieces.part.slope ? LossAlong(*pieces.part.slope) : rates.along(glide_.end.heading, pieces.last);
    goAlong({pieces.last, loss, &pieces.part, query_.rollCosts.empty() ? 0.0 : query_.rollCosts.back()});
  }
  const double key = query_.key.value_or(-kInfinity);
  glide_.arrivalStart = query_.arrival + loss_;
  glide_.keyStart = query_.key ? key + lossToGate : -kInfinity;
  glide_.gateLowest = std::max({query_.arrival + loss_ - lossToGate, gateStart_, key});
  fromAltitude(lossToGate);
  return glide_;
}

void LevelledGlide::fromAltitude(double lossToGate) {
  if (query_.altitude) {
    glide_.arrival = *query_.altitude - loss_;
    glide_.atGate = *query_.altitude - lossToGate;
    glide_.clearanceLeft = *query_.altitude - glide_.clearanceStart;
    glide_.aboveGround = *query_.altitude - groundStart_;
    glide_.afterRolling = *query_.altitude - glide_.rollingStart;
  }
}

}  // namespace

double rollCostOf(const GlideQuery& query, std::size_t piece) {
  return piece < query.rollCosts.size() ? query.rollCosts[piece] : 0.0;
}

GlideQuery queryOf(const geo::Pose& start, std::optional<double> altitude, const mission::LandingSite& site, const mission::Mission& mission) {
  const double elevation = site.elevation.metres();
  GlideQuery query{start, altitude, mission.safety.clearance.si(), elevation + mission.safety.arrivalMargin.si(), {}, {}};
  if (mission.approach.kind == mission::ApproachKind::Overhead && mission.approach.keyHeight) {
    query.key = elevation + mission.approach.keyHeight->si();
  }
  return query;
}

GlideExamination examineGlide(const GlideQuery& query, const SplitGlide& pieces, GlideRates& rates, CellWalk& walk, const Job& job) {
  return rates.isLayered() ? examineLayered(query, pieces, rates, walk, job) : LevelledGlide(query, walk, job).fly(pieces, rates);
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, GlideRates& rates) {
  if (!canBeFlown(start, pieces)) {
    return kInfinity;
  }
  CellWalk walk(terrain);
  return examineGlide({start, {}, clearance, arrivalHeight, {}, {}}, SplitGlide{pieces, {}, {}}, rates, walk, Job()).lowestStart();
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, const mission::LandingSite& site,
                           const mission::Mission& mission, const terrain::ElevationGrid& terrain, GlideRates& rates) {
  const std::optional<SplitGlide> split = canBeFlown(start, pieces) ? splitAtGate(pieces, mission.approach) : std::nullopt;
  if (!split) {
    return kInfinity;
  }
  CellWalk walk(terrain);
  const GlideExamination glide = examineGlide(queryOf(start, {}, site, mission), *split, rates, walk, Job());
  return glide.lowestStart() + mission.safety.reactionLoss.si();
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, const aircraft::GlideModel& model) {
  GlideRates rates(model);
  return requiredStartHeight(start, pieces, arrivalHeight, terrain, clearance, rates);
}

}  // namespace vp::safety
