#include "core/route/reflown_plan.h"

#include "core/flight/curve_sampling.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::route {
namespace {

constexpr double kSame = 1e-6;  // m along the path: one place
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Cuts the path at the marks and into steps. Poses follow from the start of each piece, so errors do not add up within it.
FlownPoints cut(const FlownPath& path, std::vector<double> marks, double step) {
  std::sort(marks.begin(), marks.end());
  FlownPoints flown;
  geo::Pose pose = path.start;
  double begin = 0.0;
  auto mark = marks.begin();
  for (const flight::Piece& piece : path.pieces) {
    std::vector<double> cuts{0.0};
    for (; mark != marks.end() && *mark < begin + piece.length - kSame; ++mark) {
      if (*mark - begin > cuts.back() + kSame) {
        cuts.push_back(*mark - begin);
      }
    }
    cuts.push_back(piece.length);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double length = cuts[i + 1] - cuts[i];
      const int parts = std::max(1, static_cast<int>(std::ceil(length / step)));
      for (int k = 0; k < parts; ++k) {
        const double at = cuts[i] + length * k / parts;
        mission::DecisionPoint point;
        point.pose = flight::poseAfter(pose, piece, at);
        point.onward = {piece.turn, piece.radius, length / parts};
        flown.points.push_back(point);
        flown.distance.push_back(begin + at);
      }
    }
    pose = flight::endOf(pose, piece);
    begin += piece.length;
  }
  return flown;
}

void appendPiece(std::vector<flight::Piece>& pieces, const flight::Piece& piece) {
  if (!pieces.empty() && pieces.back().turn == piece.turn && pieces.back().radius == piece.radius) {
    pieces.back().length += piece.length;
  } else {
    pieces.push_back(piece);
  }
}

}  // namespace

Result<FlownPoints> flownPoints(const landing::World* world, const landing::Roadmap* roadmap, const FlownPath& path, std::vector<double> marks,
                                double step, const Job& job) {
  FlownPoints flown = cut(path, std::move(marks), step);
  const std::size_t count = flown.points.size();
  if (world == nullptr || roadmap == nullptr) {
    flown.lowest.assign(count, -kInfinite);
    return flown;
  }
  std::vector<double> clear(count);  // ground under the way on, and the clearance
  std::vector<double> loss(count);
  landing::QueryScratch scratch;
  int hint = -1;
  for (std::size_t i = count; i-- > 0;) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while checking the waypoints");
    }
    mission::DecisionPoint& point = flown.points[i];
    clear[i] = landing::maxTerrainAlong(world->terrain, point.pose, point.onward) + world->clearance;
    loss[i] = world->glide.lossAt(point.onward.turn == flight::Turn::Straight ? 0.0 : point.onward.radius) * point.onward.length;
    const std::optional<landing::SafeAltitude> answer = roadmap->query(*world, point.pose, scratch, hint);
    point.safeAltitude = kInfinite;
    if (answer) {
      hint = answer->node;
      point.safeAltitude = answer->altitude;
      point.witness = {answer->site, roadmap->witnessPieces(*answer)};
    }
  }
  // Gliding on along the path to the next point and from there: twice around, for the chain goes over the start.
  for (std::size_t k = 2 * count; k-- > 0;) {
    mission::DecisionPoint& point = flown.points[k % count];
    const mission::DecisionPoint& next = flown.points[(k + 1) % count];
    const double onward = std::max(next.safeAltitude, clear[k % count]) + loss[k % count];
    if (onward < point.safeAltitude && next.witness.site >= 0) {
      mission::Witness witness{next.witness.site, {point.onward}};
      for (const flight::Piece& piece : next.witness.pieces) {
        appendPiece(witness.pieces, piece);
      }
      point.safeAltitude = onward;
      point.witness = std::move(witness);
    }
  }
  flown.lowest.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double glide = std::max(flown.points[next].safeAltitude, clear[i]) + loss[i];
    flown.lowest[i] = std::max({flown.points[i].safeAltitude, glide, clear[(i + count - 1) % count]});
    if (!(flown.lowest[i] < kInfinite)) {
      return fail(Errc::NoSolution, "flown from waypoint to waypoint the tour has a point from which no glide reaches a landing site");
    }
  }
  return flown;
}

}  // namespace vp::route
