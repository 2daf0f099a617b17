#pragma once

#include "core/tour/planner.h"
#include "ui/document/planning_sketch.h"

#include <chrono>
#include <functional>
#include <memory>

namespace vp::jobs {

/** Turns what the planner is doing into snapshots for drawing: the first of each kind, then at most ten a second.
 *  @threads observer() is called by the planner on its thread; `publish` is called there and has to pass the snapshot on */
class SketchBuilder {
public:
  using Publish = std::function<void(std::shared_ptr<const document::PlanningSketch>)>;

  /** @param tourRadius  of turns on the tour, m */
  SketchBuilder(double tourRadius, Publish publish) : tourRadius_(tourRadius), publish_(std::move(publish)) {}
  SketchBuilder(const SketchBuilder&) = delete;
  SketchBuilder& operator=(const SketchBuilder&) = delete;

  /** Refers to this object, which must outlive planning. */
  tour::PlanObserver observer();

private:
  using Clock = std::chrono::steady_clock;
  static bool isTime(Clock::time_point& last);
  void roadmapGrew(const landing::Roadmap& roadmap);
  void roundDone(const tour::SearchRound& round);

  double tourRadius_;
  Publish publish_;
  document::PlanningSketch sketch_;
  Clock::time_point lastRoadmap_;
  Clock::time_point lastRound_;
};

}  // namespace vp::jobs
