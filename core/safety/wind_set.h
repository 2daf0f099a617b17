#pragma once

#include "core/air/wind_layer.h"

#include <vector>

namespace vp::safety {

/** Directions that an angle may have, rad, from <= to. */
struct AngleRange {
  double from = 0.0;
  double to = 0.0;
};

/** Least and greatest |angle| of a range, each angle wrapped to [-pi, pi] first. The values between them all occur. */
AngleRange folded(AngleRange range);

/** Every wind that a mission's glides must hold for, as towards-velocities in the local frame [m/s, rad from East]: of one layer its
 *  sector, of several the convex hull of all sectors. Keeps the boundary, on which every greatest loss is found (WHY.md section 8).
 *  @threads const */
class WindSet {
public:
  /** Winds of one speed. */
  struct Arc {
    double speed = 0.0;
    AngleRange towards;
  };
  struct Velocity {
    double east = 0.0;
    double north = 0.0;
  };
  struct Segment {
    Velocity a;
    Velocity b;
  };

  /** Calm. */
  WindSet() = default;

  /** @pre the layers are sound (checkWind) */
  explicit WindSet(const std::vector<air::WindLayer>& layers);

  [[nodiscard]] bool isCalm() const { return strongest_ == 0.0; }
  /** Strongest wind [m/s]. */
  [[nodiscard]] double strongest() const { return strongest_; }
  /** Arcs and segments of winds of the set that contain its boundary. The ends of every segment lie on arcs. */
  [[nodiscard]] const std::vector<Arc>& arcs() const { return arcs_; }
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }
  /** Arcs that contain every extreme point of the convex hull of the set. */
  [[nodiscard]] const std::vector<Arc>& extremes() const { return extremes_; }
  /** Greatest component of any wind along any of these courses [m/s]; negative if all blow against them. */
  [[nodiscard]] double mostAlong(AngleRange courses) const;

private:
  struct Sector {
    AngleRange towards;
    double least = 0.0;
    double most = 0.0;
  };
  void addSides(const Sector& sector);
  void addHullSegments();

  std::vector<Sector> sectors_;
  std::vector<Arc> arcs_;
  std::vector<Arc> extremes_;
  std::vector<Segment> segments_;
  double strongest_ = 0.0;
};

}  // namespace vp::safety
