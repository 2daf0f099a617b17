#pragma once
// How long the event loop of the GUI thread was held up: between two ticks of a timer, the processor time that this thread used
// (which a busy machine does not change) and the time by the clock (which it does).

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <ctime>

namespace vp::test {

/// Processor time of the calling thread [ms].
inline double threadTime() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/** Watches the loop of the thread that made it, from then or from reset() on. */
class LoopWatch {
public:
  LoopWatch() {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(5);  // ms
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { tick(); });
    timer_.start();
    reset();
  }

  void reset() {
    worked_ = gap_ = 0.0;
    turns_ = 0;
    lastWork_ = threadTime();
    clock_.restart();
  }
  /// The current gap counts as if it ended now.
  void tick() {
    const double now = threadTime();
    worked_ = std::max(worked_, now - lastWork_);
    lastWork_ = now;
    gap_ = std::max(gap_, 1e-6 * static_cast<double>(clock_.nsecsElapsed()));
    clock_.restart();
    ++turns_;
  }

  [[nodiscard]] double longestWork() const { return worked_; }  ///< ms of processor time
  [[nodiscard]] double longestGap() const { return gap_; }      ///< ms by the clock
  [[nodiscard]] int turns() const { return turns_; }

private:
  QTimer timer_;
  QElapsedTimer clock_;
  double lastWork_ = 0.0;
  double worked_ = 0.0;
  double gap_ = 0.0;
  int turns_ = 0;
};

}  // namespace vp::test
