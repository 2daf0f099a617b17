#pragma once

// Plans built by hand for tests of the checker: a racetrack tour over flat ground with a glide from every point. Uses none of
// the planner's geometry.

#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <string>
#include <vector>

namespace vp::test {

/** Left-straight-left or right-straight-right, whichever is shorter, all turns of one radius. Exists for every two poses. */
std::vector<flight::Piece> glideTo(const geo::Pose& from, const geo::Pose& to, double radius);

/** The Cessna 172 of the source papers with 60 degrees of bank, and pitch limits of 15 degrees. */
aircraft::AircraftProfile cessna();

/** Terrain of one height, with its value changed under some places. */
class TestTerrain {
public:
  static constexpr double kCell = 50.0;

  /** 12 x 12 km about the origin, cells of 50 m. */
  explicit TestTerrain(float height = 0.0F);
  /** Sets the cell that contains a point (not on a grid line). */
  TestTerrain& setCell(double x, double y, float height);
  [[nodiscard]] terrain::ElevationGrid grid() const;

private:
  static constexpr int kCount = 240;
  std::vector<float> values_;
};

/** A racetrack 2 km long and 600 m wide, flown to the left: straights y = 1000 m (eastbound) and y = 1600 m (westbound), half
 *  circles of 300 m; decision points every 200 m on the straights and every 188.5 m in the turns. One runway with its
 *  touchdown point at (0, -1000) m, landing to the east, elevation 0 m. Two targets. Certified over flat ground of 0 m. */
class PlanBuilder {
public:
  explicit PlanBuilder(double tourAltitude = 600.0);

  [[nodiscard]] mission::Plan& plan() { return plan_; }
  [[nodiscard]] const mission::Plan& plan() const { return plan_; }
  [[nodiscard]] std::vector<std::string> checksums() const;

  /** The glide of one point, anew, to a pose at the site, with its safe altitude over flat ground of 0 m. */
  void rebuildGlide(std::size_t point, const geo::Pose& to, double radius);
  /** Height lost by a glide of the plan, by the aircraft's glide model. */
  [[nodiscard]] double lossOf(const std::vector<flight::Piece>& pieces) const;
  /** Makes the metrics true again after the tour was changed. */
  void updateMetrics();
  /** Puts all decision points at one altitude, metrics included. */
  void flyAt(double altitude);
  [[nodiscard]] double highestSafeAltitude() const;

private:
  void addLeg(flight::Turn turn, double radius, double length, int parts, geo::Pose& pose, double altitude);
  void addTarget(const std::string& name, std::size_t point, double height, mission::HeightReference reference);

  mission::Plan plan_;
};

}  // namespace vp::test
