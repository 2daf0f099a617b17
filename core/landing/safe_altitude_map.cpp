#include "core/landing/safe_altitude_map.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace vp::landing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A turn before the S-curve, and what the whole way costs at most.
struct Detour {
  double turn = 0.0;        ///< rad, positive to the left
  double lossOfTurn = 0.0;  ///< m, with the turn onto the course
  double loss = 0.0;        ///< m, of all
};

/// How every place of a cell comes to one pose, with one radius.
struct Funnel {
  double radius = 0.0;
  double half = 0.0;      ///< m, half a cell
  double spread = 0.0;    ///< m, how far from the centre's path the path of another place may run beside or behind
  double distance = 0.0;  ///< m, length of the S-curve of the centre: straight
  double lossOnto = 0.0;  ///< m, of the turn onto the course
  double straight = 0.0;  ///< m flown straight before all that, until the pilot has reacted
  double lost = 0.0;      ///< m, until then
  std::array<Detour, 5> detours;
};

/// An S-curve with two equal turns from the x axis to a parallel of it.
struct SCurve {
  double turn = 0.0;    ///< rad, of each of the two
  double length = 0.0;  ///< m
};

SCurve sCurve(double distance, double offset, double radius) {
  const double straight = std::sqrt(std::max(0.0, distance * distance + offset * offset - 4.0 * radius * offset));
  const double turn = std::atan2(2.0 * radius, straight) + std::atan2(offset - 2.0 * radius, distance);
  return {turn, 2.0 * radius * turn + straight};
}

Funnel makeFunnel(const World& world, double cell, double courseRange) {
  const std::vector<double>& radii = world.glide.glideRadii();
  Funnel funnel;
  funnel.radius = *std::min_element(radii.begin(), radii.end(),
                                    [&](double a, double b) { return a * world.glide.mostTurnLoss(a) < b * world.glide.mostTurnLoss(b); });
  const double r = funnel.radius;
  funnel.half = 0.5 * cell;
  const double onto = 2.0 * r * std::sin(0.5 * courseRange);  // how far the turn onto the course leads away
  funnel.straight = world.reactionLength;
  funnel.lost = world.reactionLoss + world.glide.mostStraightLoss() * funnel.straight;
  const double beside = 2.0 * funnel.straight * std::sin(0.5 * courseRange);  // how far the straights on all courses end from the middle one's end
  funnel.spread = std::sqrt(0.5) * cell + onto + beside;
  const double w = funnel.spread;
  const double least = w < 2.0 * r ? std::sqrt(4.0 * r * w - w * w) : 2.0 * r;  // below, no S-curve is possible
  funnel.distance = w + 1.25 * least;                                           // a little more room than needed: less turning, hardly longer
  const double turning = world.glide.mostTurnLoss(r);
  const double straight = world.glide.mostStraightLoss();
  const double longest = sCurve(funnel.distance + w, w, r).length;
  const double turned = 2.0 * sCurve(funnel.distance - w, w, r).turn;
  funnel.lossOnto = turning * r * courseRange;
  const double lossOfS = straight * longest + (turning - straight) * r * turned;
  constexpr double kQuarter = 0.5 * Angle::kPi;
  constexpr std::array<double, 5> kTurns{0.0, kQuarter, -kQuarter, 2.0 * kQuarter, -2.0 * kQuarter};
  for (std::size_t i = 0; i < kTurns.size(); ++i) {
    const double lossOfTurn = funnel.lossOnto + turning * r * std::abs(kTurns[i]);
    funnel.detours[i] = {kTurns[i], lossOfTurn, lossOfTurn + lossOfS};
  }
  return funnel;
}

geo::Point ahead(const geo::Pose& from, double distance) {
  return {from.x + distance * std::cos(from.heading), from.y + distance * std::sin(from.heading)};
}

/// Where a turn of the funnel's radius leads.
geo::Pose turned(const geo::Pose& from, double turn, double radius) {
  const double side = turn < 0.0 ? -1.0 : 1.0;
  const double heading = from.heading + turn;
  return {from.x + side * radius * (std::sin(heading) - std::sin(from.heading)),
          from.y - side * radius * (std::cos(heading) - std::cos(from.heading)), heading};
}

/// Altitude above the ground that the straight needs, along which nothing is done yet.
double needOfStraight(const World& world, const Funnel& funnel, const geo::Pose& centre) {
  constexpr int kParts = 4;
  double need = 0.0;
  for (int i = 0; i < kParts && funnel.straight > 0.0; ++i) {
    geo::Box box;
    box.add(ahead(centre, funnel.straight * i / kParts));
    box.add(ahead(centre, funnel.straight * (i + 1) / kParts));
    const double toGo = funnel.straight * (kParts - i - 1) / kParts;
    need = std::max(need, world.terrain.upperIn(box.grown(funnel.spread)) + funnel.lost - world.glide.mostStraightLoss() * toGo);
  }
  return need + world.clearance;
}

/// Altitude above the ground that the turn needs, cut into parts so that far ground counts with the loss up to there only.
double needOfTurn(const World& world, const Funnel& funnel, const geo::Pose& centre, const Detour& detour) {
  constexpr int kParts = 6;  // 30 degrees of the longest turn, each of two chords: the arc bulges 1 - cos 7.5 deg = 0.9 % of its radius over them
  const double grown = funnel.spread + 0.01 * funnel.radius;
  const double beyond = detour.lossOfTurn - funnel.lossOnto;
  double need = 0.0;
  for (int i = 0; i < kParts; ++i) {
    geo::Box box;
    for (const double part : {i + 0.0, i + 0.5, i + 1.0}) {
      box.add(turned(centre, detour.turn * part / kParts, funnel.radius).point());
    }
    need = std::max(need, world.terrain.upperIn(box.grown(grown)) + funnel.lossOnto + beyond * (i + 1) / kParts);
  }
  return need + world.clearance + funnel.lost;
}

/// The same for the S-curve. Whoever has x still to go along the middle line has lost all but leastLoss * x at most.
double needOfCurve(const World& world, const Funnel& funnel, const geo::Pose& begin, const Detour& detour) {
  constexpr int kParts = 8;
  double need = 0.0;
  for (int i = 0; i < kParts; ++i) {
    geo::Box box;
    box.add(ahead(begin, funnel.distance * i / kParts));
    box.add(ahead(begin, funnel.distance * (i + 1) / kParts));
    const double toGo = funnel.distance * (kParts - i - 1) / kParts;
    need = std::max(need, world.terrain.upperIn(box.grown(funnel.spread)) + detour.loss - world.glide.leastLoss() * toGo);
  }
  return need + world.clearance + funnel.lost;
}

/// Altitude that suffices from everywhere in the cell by one way of turning; infinity if that is no better than `beaten`.
double needBy(const World& world, const Roadmap& roadmap, const Funnel& funnel, const geo::Pose& centre, const Detour& detour, double beaten,
              QueryScratch& scratch) {
  const geo::Pose turning = afterReaction(world, centre);
  const geo::Pose begin = turned(turning, detour.turn, funnel.radius);
  double need = needOfTurn(world, funnel, turning, detour);
  if (funnel.straight > 0.0) {
    need = std::max(need, needOfStraight(world, funnel, centre));
  }
  need = need < beaten ? std::max(need, needOfCurve(world, funnel, begin, detour)) : kInfinity;
  if (!(need < beaten)) {
    return kInfinity;
  }
  const geo::Point end = ahead(begin, funnel.distance);
  const std::optional<SafeAltitude> answer = roadmap.queryTurning(world, {end.x, end.y, begin.heading}, scratch);
  return answer ? std::max(need, answer->altitude + detour.loss + funnel.lost) : kInfinity;
}

float roundedUp(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

/// All headings of one row of cells.
void fillRow(const World& world, const Roadmap& roadmap, const Funnel& funnel, int row, SafeAltitudeMap& map, QueryScratch& scratch) {
  for (int column = 0; column < map.columns; ++column) {
    const geo::Point centre{map.originX + (column + 0.5) * map.cell, map.originY + (row + 0.5) * map.cell};
    for (std::size_t h = 0; h < map.headings.size(); ++h) {
      double need = kInfinity;
      for (const Detour& detour : funnel.detours) {
        need = std::min(need, needBy(world, roadmap, funnel, {centre.x, centre.y, map.headings[h]}, detour, need, scratch));
      }
      map.need[h][static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column)] = roundedUp(need);
    }
  }
}

template <typename Choose>
std::vector<float> combined(const std::vector<std::vector<float>>& need, Choose choose) {
  std::vector<float> result = need.front();
  for (std::size_t h = 1; h < need.size(); ++h) {
    std::transform(result.begin(), result.end(), need[h].begin(), result.begin(), choose);
  }
  return result;
}

}  // namespace

std::vector<float> SafeAltitudeMap::worst() const {
  return combined(need, [](float a, float b) { return std::max(a, b); });
}

std::vector<float> SafeAltitudeMap::best() const {
  return combined(need, [](float a, float b) { return std::min(a, b); });
}

Result<SafeAltitudeMap> safeAltitudeMap(const World& world, const Roadmap& roadmap, const MapRequest& request, const Job& job) {
  SafeAltitudeMap map;
  const double width = request.area.maxX - request.area.minX;
  const double height = request.area.maxY - request.area.minY;
  constexpr double kMostValues = 4e6;
  const bool isSound = width > 0.0 && height > 0.0 && request.cell >= 10.0 && !request.headings.empty() && request.courseRange >= 0.0 &&
                       request.courseRange <= 0.5 * Angle::kPi;
  if (!isSound) {
    return fail(Errc::OutOfRange, "the map needs an area, cells of at least 10 m and a course");
  }
  if (std::ceil(width / request.cell) * std::ceil(height / request.cell) * static_cast<double>(request.headings.size()) > kMostValues) {
    return fail(Errc::OutOfRange, "the map would have more than four million values; choose wider cells or fewer courses");
  }
  map.originX = request.area.minX;
  map.originY = request.area.minY;
  map.cell = request.cell;
  map.columns = static_cast<int>(std::ceil(width / request.cell));
  map.rows = static_cast<int>(std::ceil(height / request.cell));
  map.courseRange = request.courseRange;
  map.headings = request.headings;
  map.need.assign(map.headings.size(), std::vector<float>(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows)));
  const Funnel funnel = makeFunnel(world, map.cell, map.courseRange);
  std::atomic<int> next{0};
  std::atomic<int> done{0};
  const auto work = [&] {
    QueryScratch scratch;
    for (int row = next++; row < map.rows && !job.stopRequested(); row = next++) {
      fillRow(world, roadmap, funnel, row, map, scratch);
      job.progress(static_cast<double>(++done) / map.rows, "lowest safe altitudes");
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 1; i < request.threads; ++i) {
      threads.emplace_back(work);
    }
    work();
  }
  if (job.stopRequested()) {
    return fail(Errc::Cancelled, "the map was stopped; nothing was written");
  }
  return map;
}

}  // namespace vp::landing
