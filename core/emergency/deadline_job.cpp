#include "core/emergency/deadline_job.h"

#include <chrono>

namespace vp::emergency {

DeadlineJob::DeadlineJob(const LandingRequest& request, const Countdown& countdown)
    : asked_(request.job.stopToken(), [this] { stop_.request_stop(); }), timer_([this, left = countdown.left()](const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, end, std::chrono::duration<double>(left), [] { return false; });
        if (!end.stop_requested()) {
          stop_.request_stop();
        }
      }) {}

}  // namespace vp::emergency
