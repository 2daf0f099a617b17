#pragma once

#include "core/base/job.h"
#include "core/geo/local_frame.h"
#include "core/landing/world.h"
#include "core/mission/mission.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace vp::landing {
class Roadmap;
}

namespace vp::risk {
class LegRisk;
class Weather;
}  // namespace vp::risk

namespace vp::emergency {

struct LandingAnswer;
class LandingJudge;

/** The engine has stopped here: where to, and how? Values and shared constants, so it may be copied between threads.
 *  Local frame, metres, radians, seconds; heights m MSL. */
struct LandingRequest {
  geo::Pose pose;         ///< over ground; heading is that of the track
  double altitude = 0.0;  ///< of the aircraft, m MSL. It may turn at once: the pilot has reacted

  std::shared_ptr<const landing::World> world;      ///< ground, glide model, sites, clearance; never null
  std::shared_ptr<const mission::Mission> mission;  ///< that the world is of, for the checker; never null
  geo::LatLon frameOrigin;                          ///< of the local frame
  std::shared_ptr<const landing::Roadmap> roadmap;  ///< of this world, if there is one already; null: who needs one builds it in time
  std::shared_ptr<const risk::LegRisk> risk;        ///< to be kept low; null: height counts alone
  std::shared_ptr<const risk::Weather> weather;  ///< in the local frame; null: none. Told of every path, kept low by the planners of [4] (weather/)
  std::optional<int> onlySite;                   ///< land there and nowhere else, by its index in World::sites; none: wherever is best

  std::shared_ptr<const LandingJudge> judge;        ///< the checker for this world and mission, if there is one already; null: made when asked

  double deadline = 1.0;  ///< s from the beginning of plan(), > 0: the answer is there by then
  std::uint64_t seed = 1;
  int threads = 1;  ///< that may run at once, >= 1
  Job job;          ///< asks to stop: the best so far is returned

  /** Told each better answer as it is found, on the thread that found it; may be empty. The answer is not verified. */
  std::function<void(const LandingAnswer&)> better;
};

/** What makes a request senseless, before any planner is asked: a deadline of zero, no place within the terrain or none with known ground, a start
 *  below the terrain, above the ceiling that the mission's glides hold for, no landing site at all.
 *  @return one sentence that names the thing, the place and the remedy, with its stop; none if there is nothing to say
 *  @pre world and mission are not null   @threads pure */
std::optional<std::string> requestFault(const LandingRequest& request);

/** Whether a request has to end: its deadline has passed, or it was asked to stop. */
class Countdown {
public:
  explicit Countdown(const LandingRequest& request) : stop_(request.job.stopToken()), deadline_(request.deadline) {}

  [[nodiscard]] double elapsed() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  [[nodiscard]] double left() const { return deadline_ - elapsed(); }
  [[nodiscard]] bool isOver() const { return stop_.stop_requested() || left() <= 0.0; }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::stop_token stop_;
  double deadline_;
};

}  // namespace vp::emergency
