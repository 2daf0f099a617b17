#pragma once

#include "core/aircraft/glide_model.h"
#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::landing {

/** A turn radius that glides may use, and what it costs. */
struct RadiusLoss {
  double radius = 0.0;    ///< m
  flight::TurnLoss loss;  ///< height lost per metre, at any altitude
  std::size_t index = 0;  ///< of the radius in GlideModel::glideRadii()

  /** What it costs by a model of the same radii. */
  [[nodiscard]] flight::TurnLoss lossBy(const aircraft::GlideModel& glide) const { return flight::turnLossAt(glide, index); }
};

/** The radii of an aircraft's glides with their losses, in the order of GlideModel::glideRadii(). */
std::vector<RadiusLoss> radiusLossesOf(const aircraft::GlideModel& glide);

/** A short glide between two poses of a lattice, the same wherever on the lattice it starts. */
struct GlidePrimitive {
  int columns = 0;  ///< from start to end, in steps of the lattice
  int rows = 0;
  int from = 0;  ///< indices into GlidePrimitives::headings
  int to = 0;
  std::size_t radius = 0;  ///< index into the radii
  flight::Word word = flight::Word::LSL;
  double loss = 0.0;  ///< height lost, m
};

/** The minimal control set of a state lattice of headings and square steps: every glide of least loss between two lattice
 *  poses within `reach` steps that no sequence of others replaces at hardly more loss.
 *
 *  Headings are the directions in which lattice points lie straight ahead (steps of at most two columns or rows: 16
 *  headings), so that long straight glides need no turns.
 *  @source Pivtoraiko, Knepper, Kelly 2009, Differentially constrained mobile robot motion planning in state lattices,
 *  J. Field Robotics 26, section 4 (control sets by decomposition); here with the least-loss Dubins glide over all radii */
struct GlidePrimitives {
  double step = 0.0;                                  ///< side of the lattice, m
  int reach = 0;                                      ///< largest |columns| or |rows| of a primitive
  std::vector<double> headings;                       ///< ascending from East, radians
  std::vector<flight::Direction> directions;          ///< of the headings
  std::vector<std::vector<GlidePrimitive>> arrivals;  ///< by heading of the end, by ascending loss

  /** Index of the heading at or below an angle; the next one, cyclically, lies above it. */
  [[nodiscard]] std::size_t headingBelow(double angle) const;
};

/** @param step  side of the lattice [m]  @pre radii not empty */
GlidePrimitives makeGlidePrimitives(const std::vector<RadiusLoss>& radii, double step);

}  // namespace vp::landing
