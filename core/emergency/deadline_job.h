#pragma once

#include "core/emergency/landing_request.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace vp::emergency {

/** A job for work that knows of stopping but of no deadlines: it is asked to stop when the countdown ends, or with the request. */
class DeadlineJob {
public:
  DeadlineJob(const LandingRequest& request, const Countdown& countdown);
  DeadlineJob(const DeadlineJob&) = delete;
  DeadlineJob& operator=(const DeadlineJob&) = delete;
  DeadlineJob(DeadlineJob&&) = delete;
  DeadlineJob& operator=(DeadlineJob&&) = delete;
  ~DeadlineJob() = default;

  [[nodiscard]] Job job() const { return Job(stop_.get_token()); }
  /** Asks to stop before the deadline. */
  void stop() { stop_.request_stop(); }

private:
  std::stop_source stop_;
  std::stop_callback<std::function<void()>> asked_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread timer_;  ///< last: it ends first
};

}  // namespace vp::emergency
