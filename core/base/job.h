#pragma once

#include <functional>
#include <stop_token>
#include <string_view>
#include <utility>

namespace vp {

/** How long work is watched and stopped: a stop token and a progress sink, without any user interface.
 *  Copy it freely. Work polls stopRequested() at least every 20 ms and then returns Errc::Cancelled.
 *  part() maps the progress of a sub-step into a range of the whole.
 *  @threads the sink is called from the working thread(s) and must be safe for that. */
class Job {
public:
  /// fraction done in [0, 1] and a short text, for example "roadmap: 2500 of 7500 samples"
  using Sink = std::function<void(double fraction, std::string_view text)>;

  Job() = default;
  explicit Job(std::stop_token stop, Sink sink = {}) : stop_(std::move(stop)), sink_(std::move(sink)) {}

  [[nodiscard]] bool stopRequested() const { return stop_.stop_requested(); }
  [[nodiscard]] const std::stop_token& stopToken() const { return stop_; }

  void progress(double fraction, std::string_view text) const {
    if (sink_) {
      sink_(from_ + (to_ - from_) * fraction, text);
    }
  }

  [[nodiscard]] Job part(double from, double to) const {
    Job sub = *this;
    sub.from_ = from_ + (to_ - from_) * from;
    sub.to_ = from_ + (to_ - from_) * to;
    return sub;
  }

private:
  std::stop_token stop_;
  Sink sink_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace vp
