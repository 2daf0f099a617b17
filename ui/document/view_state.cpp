#include "ui/document/view_state.h"

#include <utility>

namespace vp::document {

void ViewState::setHovered(std::optional<double> distance) {
  if (distance != hovered_) {
    hovered_ = distance;
    emit cursorChanged();
  }
}

void ViewState::setPinned(std::optional<double> distance) {
  if (distance != pinned_) {
    pinned_ = distance;
    emit cursorChanged();
  }
}

void ViewState::selectTarget(int target) {
  if (target != selectedTarget_) {
    selectedTarget_ = target;
    selectedWeather_ = target >= 0 ? -1 : selectedWeather_;
    emit selectionChanged();
  }
}

void ViewState::selectWeather(int cell) {
  if (cell != selectedWeather_) {
    selectedWeather_ = cell;
    selectedTarget_ = cell >= 0 ? -1 : selectedTarget_;
    emit selectionChanged();
  }
}

void ViewState::setLanding(std::shared_ptr<const LandingCase> landing) {
  if (landing != landing_) {
    landing_ = std::move(landing);
    emit landingChanged();
  }
}

void ViewState::setUnits(const style::Units& units) {
  if (!(units == units_)) {
    units_ = units;
    emit unitsChanged();
  }
}

void ViewState::setTheme(style::Theme theme) {
  if (theme != theme_) {
    theme_ = theme;
    emit themeChanged();
  }
}

}  // namespace vp::document
