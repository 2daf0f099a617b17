#pragma once

#include "ui/map/map_camera.h"

#include <optional>
#include <vector>

namespace vp::map {

/** The views that were looked at, as in a browser. */
class ViewHistory {
public:
  /** The view is about to leave `camera` for a new one. */
  void leave(const MapCamera& camera) {
    back_.push_back(camera);
    forward_.clear();
    if (back_.size() > kLongest) {
      back_.erase(back_.begin());
    }
  }
  [[nodiscard]] bool canGoBack() const { return !back_.empty(); }
  [[nodiscard]] bool canGoForward() const { return !forward_.empty(); }
  std::optional<MapCamera> back(const MapCamera& now) { return step(back_, forward_, now); }
  std::optional<MapCamera> forward(const MapCamera& now) { return step(forward_, back_, now); }
  void clear() {
    back_.clear();
    forward_.clear();
  }

private:
  static constexpr std::size_t kLongest = 100;

  static std::optional<MapCamera> step(std::vector<MapCamera>& from, std::vector<MapCamera>& to, const MapCamera& now) {
    if (from.empty()) {
      return std::nullopt;
    }
    const MapCamera camera = from.back();
    from.pop_back();
    to.push_back(now);
    return camera.resized(now.size());
  }

  std::vector<MapCamera> back_;
  std::vector<MapCamera> forward_;
};

}  // namespace vp::map
