// Whether a plan can be checked at all: its numbers, its indices, and the terrain it means.

#include "core/safety/check_context.h"
#include "core/safety/ground_path.h"
#include "core/safety/limits.h"
#include "core/safety/number_check.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace vp::safety {
namespace {

/// Every decision point of a plan with its name: of the tour and of the ways from and to home.
template <typename Visit>
void forEachPoint(const mission::Plan& plan, const Visit& visit) {
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    visit(plan.tour[i], fmt::format("tour point {}", i), static_cast<int>(i), true);
  }
  const auto visitPath = [&](const std::optional<mission::HomePath>& path, const char* name) {
    for (std::size_t i = 0; path && i < path->points.size(); ++i) {
      visit(path->points[i], fmt::format("{} point {}", name, i), -1, static_cast<int>(i) >= path->guaranteed);
    }
  };
  visitPath(plan.departure, "departure");
  visitPath(plan.arrival, "arrival");
}

/// What a reader calls the place of an index in a list: indices count from 0, their numbers from 1. The index may be any number.
std::int64_t numberOf(int index) {
  return std::int64_t{index} + 1;
}

void checkTourNumbers(CheckContext& context) {
  forEachPoint(context.plan, [&](const mission::DecisionPoint& point, const std::string& name, int tourPoint, bool) {
    NumberCheck numbers(context, name, tourPoint);
    numbers.pose(point.pose);
    numbers.altitude("altitude", point.altitude);
    numbers.altitude("safe altitude", point.safeAltitude);
    numbers.piece(point.onward);
    numbers.within("number of pieces of the glide", static_cast<double>(point.witness.pieces.size()), 0.0, kMostPieces);
    double length = 0.0;
    for (const flight::Piece& piece : point.witness.pieces) {
      numbers.piece(piece);
      length += piece.length;
    }
    numbers.within("length of the glide", length, 0.0, kLongestPath);
  });
}

void checkLandingSiteNumbers(CheckContext& context, const mission::LandingSite& site, const char* list) {
  NumberCheck numbers(context, fmt::format("{} {}", list, site.id));
  numbers.place(site.touchdown);
  numbers.altitude("elevation", site.elevation.metres());
  numbers.within("landing course", site.landingCourse.degrees(), -360.0, 360.0);
  if (site.length) {
    numbers.within("length", site.length->si(), 0.0, kLongestPath);
  }
}

void checkTargetNumbers(CheckContext& context, const mission::Target& target, const char* list) {
  NumberCheck numbers(context, fmt::format("{} {}", list, target.name));
  numbers.place(target.position);
  numbers.altitude("height", target.height_m);
}

void checkNumbers(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  checkTourNumbers(context);
  checkSiteNumbers(context);
  for (const mission::TargetInFrame& target : plan.targets) {
    checkTargetNumbers(context, target.target, "target");
    NumberCheck numbers(context, "target " + target.target.name);
    numbers.point(target.point);
    numbers.altitude("altitude", target.altitude);
  }
  for (const mission::Target& target : plan.mission.targets) {
    checkTargetNumbers(context, target, "target of the mission");
  }
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    NumberCheck numbers(context, "spiral");
    numbers.altitude("top", spiral.top);
    numbers.altitude("bottom", spiral.bottom);
    numbers.within("radius", spiral.radius, 0.0, kLargestRadius);
    numbers.within("circles down", spiral.turnsDown, 0.0, kMostTurns);
    numbers.within("circles up", spiral.turnsUp, 0.0, kMostTurns);
  }
  for (const mission::Hold& hold : plan.holds) {
    NumberCheck numbers(context, "hold");
    numbers.altitude("lowest altitude", hold.lowest);
    numbers.within("radius", hold.radius, 0.0, kLargestRadius);
  }
  NumberCheck metrics(context, "metrics");
  metrics.within("cost", plan.metrics.cost, 0.0, 1e12);
  metrics.within("length", plan.metrics.length, 0.0, 1e12);
  metrics.within("penalty", plan.metrics.penalty, 0.0, 1e12);
  metrics.within("lower bound", plan.metrics.lowerBound, 0.0, 1e12);
  metrics.within("lower bound of any tour", plan.metrics.freeLowerBound, 0.0, 1e12);
}

void checkPieces(CheckContext& context) {
  forEachPoint(context.plan, [&](const mission::DecisionPoint& point, const std::string& name, int tourPoint, bool) {
    const auto& glide = point.witness.pieces;
    if (!isSelfConsistent(point.onward) || !std::all_of(glide.begin(), glide.end(), isSelfConsistent)) {
      context.findings.violated(
          rule::kPlanPiece,
          fmt::format("{}: a piece of the tour or of its glide is neither a straight of radius 0 nor a turn of at most {} full circles, so it "
                      "cannot be flown",
                      name, kMostCircles),
          {tourPoint, point.pose.point()});
    }
  });
}

void checkIndices(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  const auto inside = [](int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; };
  forEachPoint(plan, [&](const mission::DecisionPoint& point, const std::string& name, int tourPoint, bool isGuaranteed) {
    const FindingPlace place{tourPoint, point.pose.point()};
    const bool needsNoGlide = !isGuaranteed && point.witness.site == -1;
    if (!needsNoGlide && !inside(point.witness.site, plan.sites.size())) {
      context.findings.violated(
          rule::kPlanIndex,
          fmt::format("{}: its glide leads to landing site no. {}, but the plan lists {}", name, numberOf(point.witness.site), plan.sites.size()),
          place);
    }
    if (point.target != -1 && !inside(point.target, plan.targets.size())) {
      context.findings.violated(rule::kPlanIndex,
                                fmt::format("{}: it visits target no. {}, but the plan lists {}", name, numberOf(point.target), plan.targets.size()),
                                place);
    }
  });
  for (const mission::Hold& hold : plan.holds) {
    if (!inside(hold.site, plan.sites.size())) {
      context.findings.violated(rule::kPlanIndex,
                                fmt::format("a hold is before landing site no. {}, but the plan lists {}", numberOf(hold.site), plan.sites.size()));
    }
  }
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    if (!inside(spiral.target, plan.targets.size())) {
      context.findings.violated(rule::kPlanIndex,
                                fmt::format("a spiral visits target no. {}, but the plan lists {}", numberOf(spiral.target), plan.targets.size()));
    }
  }
}

bool checkTerrainIdentity(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  if (plan.terrain.empty() || plan.terrain.size() != context.input.terrainSha256.size()) {
    context.findings.violated(rule::kTerrainChanged, fmt::format("the plan was made with {} terrain files, but {} were read", plan.terrain.size(),
                                                                 context.input.terrainSha256.size()));
  } else {
    for (std::size_t i = 0; i < plan.terrain.size(); ++i) {
      if (plan.terrain[i].sha256.empty() || plan.terrain[i].sha256 != context.input.terrainSha256[i]) {
        context.findings.violated(rule::kTerrainChanged,
                                  fmt::format("{} is not the terrain that the plan was made with (SHA-256 {} now, {} in the plan)",
                                              plan.terrain[i].path, context.input.terrainSha256[i], plan.terrain[i].sha256));
      }
    }
  }
  if (!checkGrid(context)) {
    return false;
  }
  const double cell = context.terrain.cellSize();
  if (!(std::abs(plan.terrainCell - cell) <= 1e-9 * cell)) {
    context.findings.violated(rule::kTerrainGrid,
                              fmt::format("the plan was made with terrain cells of {} m, but {} m were read", plan.terrainCell, cell));
  }
  return true;
}

}  // namespace

void checkSiteNumbers(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  NumberCheck(context, "origin of the frame").place(plan.frameOrigin);
  for (const mission::SiteInFrame& site : plan.sites) {
    checkLandingSiteNumbers(context, site.site, "landing site");
    NumberCheck(context, "landing site " + site.site.id).pose(site.pose);
  }
  for (const mission::LandingSite& site : plan.mission.sites) {
    checkLandingSiteNumbers(context, site, "landing site of the mission");
  }
}

bool checkGrid(CheckContext& context) {
  const terrain::ElevationGrid& grid = context.terrain;
  const double cell = grid.cellSize();
  const geo::Box box = grid.extent();
  const auto inFrame = [](double value) { return std::abs(value) <= 2.0 * kFarthest; };
  if (!(cell >= kSmallestCell && cell <= kLargestCell) || grid.values().empty() ||
      !(inFrame(box.minX) && inFrame(box.minY) && inFrame(box.maxX) && inFrame(box.maxY))) {
    context.findings.unknown(rule::kTerrainGrid,
                             fmt::format("the terrain grid ({} x {} cells of {} m) cannot be used", grid.columns(), grid.rows(), cell));
    return false;
  }
  return true;
}

bool checkStructure(CheckContext& context) {
  if (context.plan.tour.empty()) {
    context.findings.violated(rule::kPlanEmpty, "the plan has no tour");
    return false;
  }
  checkNumbers(context);
  if (!context.findings.isClean()) {
    return false;
  }
  checkPieces(context);
  const bool piecesSane = context.findings.isClean();
  checkIndices(context);
  const bool profileSane = checkProfile(context);
  const bool settingsSane = checkSettings(context);
  const bool windSane = profileSane && settingsSane && checkWind(context);
  const bool terrainUsable = checkTerrainIdentity(context);
  return piecesSane && windSane && terrainUsable;
}

}  // namespace vp::safety
