#include "ui/panels/alternatives_worker.h"

#include "ui/style/core_text.h"

#include <exception>
#include <utility>

namespace vp::panels {

AlternativesWorker::AlternativesWorker(QObject* parent) : QObject(parent) {
  thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
}

AlternativesWorker::~AlternativesWorker() {
  cancel();
  thread_.request_stop();
  thread_.join();
}

void AlternativesWorker::ask(Question question) {
  {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
    ++number_;
    next_ = std::move(question);
  }
  wake_.notify_one();
}

void AlternativesWorker::cancel() {
  const std::lock_guard lock(mutex_);
  running_.request_stop();
  ++number_;
  next_.reset();
}

void AlternativesWorker::run(const std::stop_token& end) {
  while (true) {
    Question question;
    std::uint64_t number = 0;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, end, [this] { return next_.has_value(); })) {
        return;
      }
      question = std::move(*next_);
      next_.reset();
      number = number_;
      running_ = std::stop_source();
      stop = running_.get_token();
    }
    Answer result;
    try {
      result = question.source->alternatives(question.pose, question.altitude, question.most, Job(stop));
    } catch (const std::exception& bug) {  // a bug in one answer must not end the program
      result = fail(Errc::Unsupported, bug.what());
    }
    mailbox_.post([this, number, result = std::move(result)] { deliver(number, result); });
  }
}

void AlternativesWorker::deliver(std::uint64_t number, const Answer& result) {
  {
    const std::lock_guard lock(mutex_);
    if (number != number_) {
      return;
    }
  }
  if (result) {
    emit answered(*result);
  } else if (result.error().code != Errc::Cancelled) {
    emit failed(style::coreText(result.error()));
  }
}

}  // namespace vp::panels
