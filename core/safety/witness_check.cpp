#include "core/safety/witness_check.h"

#include "core/safety/cell_walk.h"
#include "core/safety/ground_path.h"
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

void flyPiece(GlideExamination& glide, const FlownPiece& flown, double clearance, CellWalk& walk, const Job& job) {
  walk.start(glide.end, flown.piece);
  Span span;
  for (int count = 0; walk.next(span); ++count) {
    if (count % kSpansPerPoll == kSpansPerPoll - 1 && job.stopRequested()) {
      return;
    }
    if (!span.isKnown()) {
      glide.clearanceStart = kInfinity;
      glide.unknownAt = poseOn(glide.end, flown.piece, span.from).point();
      return;
    }
    forEachDecidingPlace(span, flown, clearance, [&](double at) {
      const double asked = flown.part != nullptr ? flown.part->clearanceAt(flown.piece.length - at, clearance) : clearance;
      const double needed = span.ground + asked + glide.loss + flown.loss.upTo(at);
      if (flown.part != nullptr) {
        glide.gateStart = std::max(glide.gateStart, needed - glide.loss);
      }
      if (needed > glide.clearanceStart) {
        glide.clearanceStart = needed;
        glide.clearanceGround = span.ground;
        glide.clearanceAsked = asked;
        glide.clearanceAt = poseOn(glide.end, flown.piece, at).point();
      }
    });
  }
}

/// Flies a piece and goes to its end.
void goAlong(GlideExamination& glide, const FlownPiece& flown, double clearance, CellWalk& walk, const Job& job) {
  if (!glide.unknownAt && flown.piece.length > 0.0) {
    flyPiece(glide, flown, clearance, walk, job);
  }
  glide.end = endOfPiece(glide.end, flown.piece);
  glide.length += flown.piece.length;
  glide.loss += flown.piece.length > 0.0 ? flown.loss.upTo(flown.piece.length) : 0.0;
}

}  // namespace

GlideExamination examineGlide(const geo::Pose& start, const SplitGlide& pieces, double clearance, GlideRates& rates, CellWalk& walk, const Job& job) {
  GlideExamination glide;
  glide.end = start;
  glide.clearanceAt = start.point();
  glide.clearanceStart = -kInfinity;
  glide.gateStart = -kInfinity;
  const flight::Piece nothing;
  const LossAlong none(0.0);
  flyPiece(glide, {nothing, none}, clearance, walk, job);  // the start itself, also of a glide without pieces
  for (const flight::Piece& piece : pieces.before) {
    const LossAlong loss = rates.along(glide.end.heading, piece);
    goAlong(glide, {piece, loss}, clearance, walk, job);
    if (job.stopRequested()) {
      return glide;
    }
  }
  glide.lossToGate = glide.loss;
  if (pieces.last.length > 0.0) {
    const LossAlong loss = pieces.part.slope ? LossAlong(*pieces.part.slope) : rates.along(glide.end.heading, pieces.last);
    goAlong(glide, {pieces.last, loss, &pieces.part}, clearance, walk, job);
  }
  return glide;
}

GlideExamination examineGlide(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double clearance, GlideRates& rates, CellWalk& walk,
                              const Job& job) {
  return examineGlide(start, SplitGlide{pieces, {}, {}}, clearance, rates, walk, job);
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, GlideRates& rates) {
  if (!canBeFlown(start, pieces)) {
    return kInfinity;
  }
  CellWalk walk(terrain);
  const GlideExamination glide = examineGlide(start, pieces, clearance, rates, walk, Job());
  return std::max(arrivalHeight + glide.loss, glide.clearanceStart);
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, const mission::LandingSite& site,
                           const mission::Mission& mission, const terrain::ElevationGrid& terrain, GlideRates& rates) {
  const std::optional<SplitGlide> split = canBeFlown(start, pieces) ? splitAtGate(pieces, mission.approach) : std::nullopt;
  if (!split) {
    return kInfinity;
  }
  CellWalk walk(terrain);
  const GlideExamination glide = examineGlide(start, *split, mission.safety.clearance.si(), rates, walk, Job());
  const double elevation = site.elevation.metres();
  const double key = split->part.keyHeight ? elevation + *split->part.keyHeight + glide.lossToGate : -kInfinity;
  return std::max({elevation + mission.safety.arrivalMargin.si() + glide.loss, glide.clearanceStart, key}) + mission.safety.reactionLoss.si();
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, const aircraft::GlideModel& model) {
  GlideRates rates(model);
  return requiredStartHeight(start, pieces, arrivalHeight, terrain, clearance, rates);
}

}  // namespace vp::safety
