#include "ui/jobs/job_runner.h"

#include "ui/style/core_text.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <system_error>

namespace vp::jobs {
namespace {

constexpr int kProgressInterval = 100;  // ms: ten times a second

}  // namespace

/// The latest progress of one piece of work, written by its threads.
struct JobRunner::Progress {
  std::mutex mutex;
  double fraction = 0.0;
  std::string text;
  bool isAnnounced = false;  ///< the runner knows that there is something to show
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) {
  pace_.setSingleShot(true);
  pace_.setInterval(kProgressInterval);
  connect(&pace_, &QTimer::timeout, this, &JobRunner::showProgress);
}

JobRunner::~JobRunner() {
  stopAndWait();
}

void JobRunner::requestStop() {
  if (isRunning_) {
    workers_.back().thread.request_stop();
  }
}

void JobRunner::cancel() {
  requestStop();
  ++generation_;
  isRunning_ = false;
  progress_.reset();
}

void JobRunner::stopAndWait() {
  cancel();
  for (Worker& worker : workers_) {
    worker.thread.request_stop();
  }
  workers_.clear();  // joins; what they have posted finds no generation to belong to
}

void JobRunner::showProgress() {
  if (!progress_ || pace_.isActive()) {
    return;  // the timer comes back to it
  }
  std::optional<std::pair<double, std::string>> latest;
  {
    const std::lock_guard lock(progress_->mutex);
    if (progress_->isAnnounced) {
      latest.emplace(progress_->fraction, progress_->text);
      progress_->isAnnounced = false;
    }
  }
  if (latest) {
    pace_.start();
    emit progressed(latest->first, style::coreText(latest->second));
  }
}

void JobRunner::run(std::function<void(const Job&)> work, const std::function<void()>& done) {
  cancel();
  const unsigned generation = generation_;
  isRunning_ = true;
  progress_ = std::make_shared<Progress>();
  pace_.stop();  // the first word of new work does not wait for the pace of the work before
  const Job::Sink sink = [this, progress = progress_](double fraction, std::string_view text) {
    const std::lock_guard lock(progress->mutex);
    progress->fraction = fraction;
    progress->text = text;
    if (!progress->isAnnounced) {
      progress->isAnnounced = true;
      mailbox_.post([this] { showProgress(); });
    }
  };
  const auto announceEnd = [this, generation, done] { mailbox_.post([this, generation, done] { finished(generation, done); }); };
  try {
    workers_.push_back({generation, std::jthread([sink, announceEnd, work = std::move(work)](const std::stop_token& stop) {
                          work(Job(stop, sink));
                          announceEnd();
                        })});
  } catch (const std::system_error&) {
    workers_.push_back({generation, {}});  // no thread to be had: the result is as it was made, a failure
    announceEnd();
  }
}

void JobRunner::finished(unsigned generation, const std::function<void()>& done) {
  workers_.erase(std::remove_if(workers_.begin(), workers_.end(), [generation](const Worker& w) { return w.generation == generation; }),
                 workers_.end());
  if (generation == generation_) {
    isRunning_ = false;
    progress_.reset();
    done();
  }
}

}  // namespace vp::jobs
