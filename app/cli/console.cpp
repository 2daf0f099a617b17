#include "app/cli/console.h"

#include "core/base/plain_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <pthread.h>
#include <stop_token>
#include <thread>
#include <unistd.h>

namespace vp::cli {

int statusOf(const Error& error) {
  switch (error.code) {
    case Errc::NoSolution:
      return kNoSolution;
    case Errc::Cancelled:
      return kStopped;
    default:
      return kBadInput;
  }
}

int report(const Error& error, bool json) {
  if (json) {
    const nlohmann::json object{{"error", error.what}, {"where", error.where}, {"exit", statusOf(error)}};
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  fmt::print(stderr, "volplane-cli: {}\n", plainText(error.message()));
  return statusOf(error);
}

struct Console::Impl {
  bool show = false;
  std::stop_source stop;
  std::mutex mutex;
  std::chrono::steady_clock::time_point last;
  bool open = false;
  sigset_t signals{};
  std::jthread watcher;
};

Console::Console(bool showProgress) : impl_(new Impl) {
  impl_->show = showProgress && isatty(STDERR_FILENO) == 1;
  sigemptyset(&impl_->signals);
  sigaddset(&impl_->signals, SIGINT);
  sigaddset(&impl_->signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &impl_->signals, nullptr);
  impl_->watcher = std::jthread([impl = impl_](const std::stop_token& end) {
    const timespec patience{0, 100'000'000};
    while (!end.stop_requested()) {
      if (sigtimedwait(&impl->signals, nullptr, &patience) > 0) {
        impl->stop.request_stop();
      }
    }
  });
}

Console::~Console() {
  finishProgress();
  impl_->watcher.request_stop();
  impl_->watcher.join();
  delete impl_;
}

Job Console::job() {
  return Job(impl_->stop.get_token(), [impl = impl_](double fraction, std::string_view text) {
    if (!impl->show) {
      return;
    }
    const std::lock_guard lock(impl->mutex);
    const auto now = std::chrono::steady_clock::now();
    if (now - impl->last < std::chrono::milliseconds(100)) {
      return;
    }
    impl->last = now;
    impl->open = true;
    fmt::print(stderr, "\r\033[K{:3.0f} %  {}", 100.0 * fraction, text);
    std::fflush(stderr);
  });
}

void Console::finishProgress() {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->open) {
    fmt::print(stderr, "\r\033[K");
    impl_->open = false;
  }
}

std::string folderOf(const std::string& path) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

}  // namespace vp::cli
