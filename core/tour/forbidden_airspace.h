#pragma once

#include "core/flight/curve.h"
#include "core/geo/local_frame.h"
#include "core/mission/airspace.h"
#include "core/terrain/terrain_pyramid.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vp::tour {

/** What a forbidden airspace asks of a stretch of the tour: no higher than its floor, or no lower than its ceiling. */
struct HeightGate {
  double floor = 0.0;    ///< m MSL; -infinity where there is no way under it
  double ceiling = 0.0;  ///< m MSL; infinity where there is no way over it
  int volume = -1;       ///< number of the airspace

  /** @param low, high  lowest and highest altitude on the stretch [m MSL] */
  [[nodiscard]] bool isPassed(double low, double high) const {
    constexpr double kRounding = 1e-6;  // m, of profiles that were raised to the gate
    return high <= floor + kRounding || low >= ceiling - kRounding;
  }
};

/** The airspaces that a mission forbids to the tour, in the frame.
 *
 *  Outlines are taken kMargin wider than they are drawn, floors above ground over the lowest ground near a stretch, ceilings
 *  above ground over the highest: what passes all gates is outside every airspace (WHY.md, 7).
 *  @threads const members are pure */
class ForbiddenAirspace {
public:
  /** Arcs of a file are drawn by corners off the true line by at most 1 m (core/formats); as much again for chords of turns. */
  static constexpr double kMargin = 2.0;  // m

  ForbiddenAirspace() = default;
  ForbiddenAirspace(const std::vector<mission::Airspace>& airspaces, const mission::AirspaceSettings& settings, const geo::LocalFrame& frame);

  [[nodiscard]] bool isEmpty() const { return volumes_.empty(); }

  /** Appends the gates of a piece of the tour.
   *  @param ground  highest ground under it [m MSL]   @cost O(volumes), for those nearby O(corners beside the piece) */
  void addGates(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, double ground,
                std::vector<HeightGate>& gates) const;

  /** Appends the gates of everything within `radius` of a point. */
  void addGatesNear(const terrain::TerrainPyramid& terrain, geo::Point point, double radius, double ground, std::vector<HeightGate>& gates) const;

  /** The same airspaces without a way over or under them, but for those that one of the points lies in. */
  [[nodiscard]] ForbiddenAirspace walledBut(const std::vector<geo::Point>& points) const;

  /** "BERN TMA 1 (class C, 1500 m MSL to FL 100)" */
  [[nodiscard]] std::string nameOf(int volume) const;

private:
  struct Volume {
    mission::Airspace airspace;
    bool isWall = false;
    geo::Box box;  ///< of the outline, grown by kMargin
    std::vector<geo::Point> corners;
    std::vector<std::vector<std::size_t>> slabs;  ///< sides by the stripes of y that they touch, each widened by kMargin

    [[nodiscard]] std::size_t slabOf(double y) const;
    [[nodiscard]] bool contains(geo::Point point) const;
    [[nodiscard]] bool isNear(geo::Point a, geo::Point b, double margin) const;
    [[nodiscard]] bool isTouchedBy(const geo::Pose& start, const flight::Piece& piece) const;
    [[nodiscard]] HeightGate gate(int number, double lowestGround, double highestGround) const;
  };

  std::vector<Volume> volumes_;
};

}  // namespace vp::tour
