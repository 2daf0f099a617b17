#include "core/emergency/combined_planner.h"

#include "core/emergency/deadline_job.h"
#include "core/emergency/landing_judge.h"
#include "core/emergency/landing_outcome.h"
#include "core/emergency/verified_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace vp::emergency {
namespace {

/// Time that is kept for judging the last path, beside what judging took so far [s].
constexpr double kReserve = 0.002;
/// Risks closer than this are the same [relative].
constexpr double kSameRisk = 1e-9;
/// Steps of -log success in weather: one flight in a thousand more or less decides nothing before people on the ground and height do.
constexpr double kSameWeather = 1e-3;

bool isBetter(const LandingRequest& request, const LandingAnswer& a, const LandingAnswer& b) {
  if (!a.path || !b.path) {
    return a.path.has_value();
  }
  if (a.reachesRunway() != b.reachesRunway()) {
    return a.reachesRunway();
  }
  if (!a.reachesRunway()) {
    return reachOf(*a.path) > reachOf(*b.path);
  }
  const auto weatherStep = [&](const LandingAnswer& one) { return std::round(weatherOf(request, *one.path) / kSameWeather); };
  if (request.weather != nullptr && weatherStep(a) != weatherStep(b)) {
    return weatherStep(a) < weatherStep(b);
  }
  const double riskA = riskOf(request, *a.path);
  const double riskB = riskOf(request, *b.path);
  if (std::abs(riskA - riskB) > kSameRisk * riskB) {
    return riskA < riskB;
  }
  const auto worth = [](const LandingAnswer& one) { return one.heightInHand - kPerManoeuvre * manoeuvresOf(*one.path); };
  return worth(a) > worth(b);
}

/// What planners have found and nobody has judged yet, and who is still at work.
class Desk {
public:
  explicit Desk(std::size_t planners) : newest_(planners), working_(planners) {}

  void put(std::size_t planner, LandingAnswer answer) {
    {
      const std::lock_guard lock(mutex_);
      newest_[planner] = std::move(answer);
    }
    news_.notify_one();
  }
  void finish() {
    {
      const std::lock_guard lock(mutex_);
      --working_;
    }
    news_.notify_one();
  }
  /** The next to be judged, waiting for one; none when the time is over or all have finished.
   *  @param over  set when nothing is to come any more */
  std::optional<LandingAnswer> take(double seconds, bool& over) {
    std::unique_lock lock(mutex_);
    const auto isReady = [this](const std::optional<LandingAnswer>& one) { return one.has_value(); };
    news_.wait_for(lock, std::chrono::duration<double>(std::max(0.0, seconds)),
                   [&] { return working_ == 0 || std::any_of(newest_.begin(), newest_.end(), isReady); });
    const auto found = std::find_if(newest_.begin(), newest_.end(), isReady);
    if (found != newest_.end()) {
      return std::exchange(*found, std::nullopt);
    }
    over = working_ == 0;
    return std::nullopt;
  }

private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::optional<LandingAnswer>> newest_;  ///< by planner
  std::size_t working_;
};

/** One combined run. */
class Run {
public:
  Run(const LandingRequest& request, const std::vector<const LandingPlanner*>& planners)
      : request_(request), planners_(planners), countdown_(request), timed_(request, countdown_), desk_(planners.size()), last_(planners.size()) {}

  LandingAnswer run() {
    const std::size_t count = std::min(planners_.size(), static_cast<std::size_t>(std::max(1, request_.threads)));
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < count; ++i) {
      workers.emplace_back([this, count] { work(count); });
    }
    constexpr double kPatience = 1.0;  // s; who ends wakes the desk
    bool over = false;
    while (!over) {
      double left = countdown_.left() - reserve_;
      if (left <= 0.0) {
        timed_.stop();  // and wait for all: they end at once
        left = kPatience;
      }
      if (std::optional<LandingAnswer> found = desk_.take(left, over)) {
        judge(std::move(*found));
      }
    }
    workers.clear();
    return answer();
  }

private:
  /// Runs one planner after the other until none is left.
  void work(std::size_t workers) {
    for (std::size_t i = next(); i < planners_.size(); i = next()) {
      LandingRequest own = request_;
      own.job = timed_.job();
      const std::size_t waiting = planners_.size() - i;
      const std::size_t rounds = (waiting + workers - 1) / workers;
      own.deadline = std::max(1e-3, countdown_.left() / static_cast<double>(rounds));
      own.better = [this, i](const LandingAnswer& better) { desk_.put(i, better); };
      LandingAnswer found;
      try {
        found = planners_[i]->plan(own);
      } catch (const std::exception& bug) {
        found.planner = planners_[i]->name();
        found.whyNot = fmt::format("The planner {} ended with an error of its own: {}.", found.planner, bug.what());
      }
      last_[i] = found;
      if (found.path) {
        desk_.put(i, std::move(found));
      }
      desk_.finish();
    }
  }

  std::size_t next() {
    const std::lock_guard lock(mutex_);
    return next_++;
  }

  void judge(LandingAnswer found) {
    if (best_ && !isBetter(request_, found, *best_)) {
      return;
    }
    const double before = countdown_.elapsed();
    found = verifiedAnswer(request_, std::move(found));
    const double took = countdown_.elapsed() - before;
    reserve_ = std::max(reserve_, kReserve + took);
    ++judged_;
    if (!found.verified) {
      refused_ = found.whyNot;
      return;
    }
    best_ = std::move(found);
    best_->seconds = countdown_.elapsed();
    if (request_.better) {
      request_.better(*best_);
    }
  }

  LandingAnswer answer() {
    LandingAnswer answer = best_.value_or(LandingAnswer{});
    answer.seed = request_.seed;
    if (!answer.reachesRunway()) {
      const auto tells = [](const LandingAnswer& one) { return !one.whyNot.empty(); };
      const auto why = std::find_if(last_.begin(), last_.end(), tells);
      if (why != last_.end()) {
        answer.whyNot = why->whyNot;
        answer.missing = why->missing;
        answer.planner = why->planner;
      } else {
        answer.whyNot = refused_.empty() ? "There was not enough time to find and verify a glide: give a later deadline." : refused_;
      }
    }
    answer.tried.insert(answer.tried.begin(), {"paths judged by the checker", judged_});
    for (const LandingAnswer& one : last_) {
      if (one.planner.empty() || one.planner == answer.planner) {
        continue;
      }
      answer.notes.push_back(one.reachesRunway() ? fmt::format("{}: {:.0f} m in hand.", one.planner, one.heightInHand)
                                                 : fmt::format("{}: {}", one.planner, one.whyNot));
    }
    answer.seconds = countdown_.elapsed();
    return answer;
  }

  const LandingRequest& request_;
  const std::vector<const LandingPlanner*>& planners_;
  Countdown countdown_;
  DeadlineJob timed_;
  Desk desk_;
  std::mutex mutex_;
  std::size_t next_ = 0;             ///< guarded by mutex_
  std::vector<LandingAnswer> last_;  ///< by planner; each written by one thread, read after all have ended
  double reserve_ = kReserve;
  std::int64_t judged_ = 0;
  std::optional<LandingAnswer> best_;
  std::string refused_;  ///< why the checker refused the last it refused
};

}  // namespace

LandingAnswer CombinedPlanner::plan(const LandingRequest& request) const {
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name(), std::move(*fault));
  }
  const LandingRequest own = withJudge(request);
  std::vector<const LandingPlanner*> planners;
  if (request.weather != nullptr) {
    for (const auto& one : inWeather_) {
      planners.push_back(one.get());
    }
  }
  for (const auto& one : planners_) {
    planners.push_back(one.get());
  }
  return Run(own, planners).run();
}

}  // namespace vp::emergency
