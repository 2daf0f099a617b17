// A race between the window's thread and the work of a JobRunner, planted so that packaging/sanitize-threads shows that the thread sanitizer finds
// one here, suppressions and all. With the argument "locked" the same two hold a lock, and nothing may be found.
#include "ui/jobs/job_runner.h"

#include <QCoreApplication>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <string_view>
#include <thread>

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const bool isLocked = argc > 1 && std::string_view(argv[1]) == "locked";
  constexpr int kTimes = 1000;
  std::mutex mutex;
  int count = 0;
  std::atomic<int> ready = 0;  // relaxed: brings the two together and orders nothing
  const auto countUp = [&] {
    ready.fetch_add(1, std::memory_order_relaxed);
    while (ready.load(std::memory_order_relaxed) < 2) {
      std::this_thread::yield();
    }
    for (int i = 0; i < kTimes; ++i) {
      const std::unique_lock lock = isLocked ? std::unique_lock(mutex) : std::unique_lock<std::mutex>();
      ++count;
    }
  };
  vp::jobs::JobRunner runner;
  bool isFine = false;
  runner.start<int>(
      [&](const vp::Job&) -> vp::Result<int> {
        countUp();
        return kTimes;
      },
      [&](const vp::Result<int>& result) {
        isFine = result.has_value();
        QCoreApplication::quit();
      });
  countUp();
  QCoreApplication::exec();
  std::printf("counted to %d of %d\n", count, 2 * kTimes);
  return isFine ? 0 : 1;
}
