#include "ui/jobs/job_runner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace vp::jobs {
namespace {

constexpr std::int64_t kProgressInterval = 100'000'000;  // ns: ten times a second

}  // namespace

JobRunner::~JobRunner() {
  for (Worker& worker : workers_) {
    worker.thread.request_stop();
  }
  workers_.clear();  // joins; what they still post to this object is dropped by Qt
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
}

Job::Sink JobRunner::sinkFor(unsigned generation) {
  auto last = std::make_shared<std::atomic<std::int64_t>>(0);
  return [this, generation, last](double fraction, std::string_view text) {
    const std::int64_t now = std::chrono::steady_clock::now().time_since_epoch().count();
    std::int64_t before = last->load(std::memory_order_relaxed);
    if (now - before < kProgressInterval || !last->compare_exchange_strong(before, now)) {
      return;
    }
    QMetaObject::invokeMethod(
        this,
        [this, generation, fraction, words = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))] {
          if (generation == generation_) {
            emit progressed(fraction, words);
          }
        },
        Qt::QueuedConnection);
  };
}

void JobRunner::run(std::function<void(const Job&)> work, std::function<void()> done) {
  cancel();
  const unsigned generation = generation_;
  isRunning_ = true;
  workers_.push_back({generation, std::jthread([this, generation, sink = sinkFor(generation), work = std::move(work),
                                                done = std::move(done)](const std::stop_token& stop) {
                        work(Job(stop, sink));
                        QMetaObject::invokeMethod(
                            this, [this, generation, done] { finished(generation, done); }, Qt::QueuedConnection);
                      })});
}

void JobRunner::finished(unsigned generation, const std::function<void()>& done) {
  workers_.erase(std::remove_if(workers_.begin(), workers_.end(), [generation](const Worker& w) { return w.generation == generation; }),
                 workers_.end());
  if (generation == generation_) {
    isRunning_ = false;
    done();
  }
}

}  // namespace vp::jobs
