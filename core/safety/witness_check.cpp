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

void flyPiece(GlideExamination& glide, const flight::Piece& piece, const LossAlong& loss, double clearance, CellWalk& walk, const Job& job) {
  walk.start(glide.end, piece);
  Span span;
  for (int count = 0; walk.next(span); ++count) {
    if (count % kSpansPerPoll == kSpansPerPoll - 1 && job.stopRequested()) {
      return;
    }
    if (!span.isKnown()) {
      glide.clearanceStart = kInfinity;
      glide.unknownAt = poseOn(glide.end, piece, span.from).point();
      return;
    }
    // Ground is constant on the span and height is lost along it, so its far end decides.
    const double needed = span.ground + clearance + glide.loss + loss.upTo(span.to);
    if (needed > glide.clearanceStart) {
      glide.clearanceStart = needed;
      glide.clearanceGround = span.ground;
      glide.clearanceAt = poseOn(glide.end, piece, span.to).point();
    }
  }
}

}  // namespace

GlideExamination examineGlide(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double clearance, GlideRates& rates, CellWalk& walk,
                              const Job& job) {
  GlideExamination glide;
  glide.end = start;
  glide.clearanceAt = start.point();
  glide.clearanceStart = -kInfinity;
  flyPiece(glide, flight::Piece{}, LossAlong(0.0), clearance, walk, job);  // the start itself, also of a glide without pieces
  for (const flight::Piece& piece : pieces) {
    const LossAlong loss = rates.along(glide.end.heading, piece);
    if (!glide.unknownAt && piece.length > 0.0) {
      flyPiece(glide, piece, loss, clearance, walk, job);
    }
    glide.end = endOfPiece(glide.end, piece);
    glide.length += piece.length;
    glide.loss += piece.length > 0.0 ? loss.upTo(piece.length) : 0.0;
    if (job.stopRequested()) {
      break;
    }
  }
  return glide;
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, GlideRates& rates) {
  const bool integrable = std::all_of(pieces.begin(), pieces.end(), isIntegrable);
  const bool inFrame = std::abs(start.x) <= kFarthest && std::abs(start.y) <= kFarthest && std::abs(start.heading) <= kLargestHeading;
  if (!integrable || !inFrame) {
    return kInfinity;
  }
  CellWalk walk(terrain);
  const GlideExamination glide = examineGlide(start, pieces, clearance, rates, walk, Job());
  return std::max(arrivalHeight + glide.loss, glide.clearanceStart);
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, const mission::LandingSite& site,
                           const mission::Mission& mission, const terrain::ElevationGrid& terrain, GlideRates& rates) {
  const mission::SafetySettings& safety = mission.safety;
  const double arrivalHeight = site.elevation.metres() + safety.arrivalMargin.si();
  return requiredStartHeight(start, pieces, arrivalHeight, terrain, safety.clearance.si(), rates) + safety.reactionLoss.si();
}

double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, const aircraft::GlideModel& model) {
  GlideRates rates(model);
  return requiredStartHeight(start, pieces, arrivalHeight, terrain, clearance, rates);
}

}  // namespace vp::safety
