#pragma once

#include "core/aircraft/glide_model.h"
#include "core/mission/plan.h"
#include "ui/document/terrain_data.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::document {

/** Where the aircraft is at one point of the tour. Altitudes m MSL. */
struct TourState {
  double distance = 0.0;  ///< m over ground from the first decision point
  geo::Pose pose;
  double altitude = 0.0;
  double ground = 0.0;        ///< upper bound of the terrain here; infinity where unknown
  double safeAltitude = 0.0;  ///< lowest height from which the plan's glide from here arrives
  int point = 0;              ///< the decision point here or last passed
  [[nodiscard]] double glideMargin() const { return altitude - safeAltitude; }
  [[nodiscard]] double clearance() const { return altitude - ground; }
};

/** A sample of the tour for drawing: a TourState and the terrain around it. */
struct TourSample {
  TourState state;
  double corridor = 0.0;   ///< highest known ground within kCorridor of the point
  double pitchOnly = 0.0;  ///< altitude that terrain clearance, targets and pitch limits alone would ask for ([1] Fig. 10)
};

/** A point of a flown glide. */
struct GlidePoint {
  double distance = 0.0;  ///< m over ground from the engine failure
  geo::Pose pose;
  double altitude = 0.0;  ///< m MSL
  double ground = 0.0;    ///< m MSL, upper bound; infinity where unknown
};

/** The glide that would be flown if the engine stopped at one point of the tour: on along the tour to the next decision
 *  point where the failure is between two, then that point's witness. */
struct EngineOut {
  TourState from;
  int site = -1;  ///< index into Plan::sites
  std::vector<GlidePoint> path;
  double length = 0.0;          ///< m over ground
  double seconds = 0.0;         ///< to the touchdown point, surplus height not counted
  double margin = 0.0;          ///< m that the aircraft is above the lowest height from which this glide arrives
  double surplus = 0.0;         ///< m above the site's elevation on arrival, lost in a spiral there
  double leastClearance = 0.0;  ///< m above the ground, and where on the path
  std::size_t leastClearanceAt = 0;
};

/** Appends a point to a glide at its length so far, and keeps the least clearance.  @param ground  m MSL, upper bound; infinity where unknown */
void addGlidePoint(EngineOut& glide, const geo::Pose& pose, double altitude, double ground);

/** A plan made ready for looking at: distances, samples, glides. Derived from the plan and the terrain alone; immutable,
 *  shared between views. Proves nothing: core/safety does.
 *  @threads const members are pure   @cost building: some 10 ms per 1000 decision points; build it on a worker */
class PlanView {
public:
  static constexpr double kCorridor = 500.0;     ///< m to each side, ours; named in the legend
  static constexpr double kSampleStep = 30.0;    ///< m between samples at most
  static constexpr double kGlideSpacing = 30.0;  ///< m between points of a glide at most

  /** @pre plan has a tour, terrain is not null and in the plan's frame (or at least covers it) */
  PlanView(std::shared_ptr<const mission::Plan> plan, std::shared_ptr<const TerrainData> terrain);

  [[nodiscard]] const mission::Plan& plan() const { return *plan_; }
  [[nodiscard]] const TerrainData& terrain() const { return *terrain_; }
  [[nodiscard]] double length() const { return length_; }  ///< m over ground, once around
  [[nodiscard]] bool isVerified() const { return plan_->certificate.has_value(); }

  /** Samples in flying order, all decision points included; the last closes the loop at length(). */
  [[nodiscard]] const std::vector<TourSample>& samples() const { return samples_; }

  /** State at a distance, wrapped around the loop. */
  [[nodiscard]] TourState at(double distance) const;
  /** Distance at which decision point i lies. */
  [[nodiscard]] double distanceOf(std::size_t decisionPoint) const { return distances_[decisionPoint]; }
  /** Distance at which a target is visited; nothing if the tour does not visit it. */
  [[nodiscard]] std::optional<double> distanceOfTarget(int target) const;
  /** Distance of the tour point nearest to a place, if one is within `within` metres. */
  [[nodiscard]] std::optional<double> nearest(geo::Point place, double within) const;

  [[nodiscard]] EngineOut engineOutAt(double distance) const;

  /** Samples with the least glide margin and the least height above the ground. */
  [[nodiscard]] const TourSample& leastGlideMargin() const { return samples_[leastMargin_]; }
  [[nodiscard]] const TourSample& leastClearance() const { return samples_[leastClearance_]; }
  [[nodiscard]] const TourSample& highestGround() const { return samples_[highestGround_]; }

  [[nodiscard]] double lowestAltitude() const { return lowestAltitude_; }  ///< of the tour
  [[nodiscard]] double highestAltitude() const { return highestAltitude_; }

private:
  [[nodiscard]] TourState stateAt(std::size_t point, double beyond) const;
  void sampleTour();
  void addPitchOnly();
  [[nodiscard]] double corridorAt(geo::Point p) const;

  std::shared_ptr<const mission::Plan> plan_;
  std::shared_ptr<const TerrainData> terrain_;
  aircraft::GlideModel glide_;
  std::vector<double> distances_;  ///< of the decision points, and the length at the end
  std::vector<TourSample> samples_;
  double length_ = 0.0;
  std::size_t leastMargin_ = 0;
  std::size_t leastClearance_ = 0;
  std::size_t highestGround_ = 0;
  double lowestAltitude_ = 0.0;
  double highestAltitude_ = 0.0;
};

}  // namespace vp::document
