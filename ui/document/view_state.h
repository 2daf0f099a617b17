#pragma once

#include "core/geo/pose.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QObject>

#include <memory>
#include <optional>

namespace vp::document {

struct LandingCase;

/** What the views share beside the document: the point of the tour that is looked at, the selected target, units and
 *  theme. Each view shows the cursor of all others. Distances are metres over ground along the tour from its first decision
 *  point, as PlanView counts them. */
class ViewState : public QObject {
  Q_OBJECT

public:
  explicit ViewState(QObject* parent = nullptr) : QObject(parent) {}

  /// Under the mouse in some view, now.
  [[nodiscard]] std::optional<double> hovered() const { return hovered_; }
  /// Chosen by click, slider, arrow keys or a table; stays.
  [[nodiscard]] std::optional<double> pinned() const { return pinned_; }
  /// What is shown: the hovered point, else the pinned one.
  [[nodiscard]] std::optional<double> position() const { return hovered_ ? hovered_ : pinned_; }
  [[nodiscard]] int selectedTarget() const { return selectedTarget_; }    ///< index into the mission's targets, -1: none
  [[nodiscard]] int selectedWeather() const { return selectedWeather_; }  ///< index into the mission's weather, -1: none
  /// What is asked about an engine failure at a place of the map; null: nothing.
  [[nodiscard]] const std::shared_ptr<const LandingCase>& landing() const { return landing_; }
  [[nodiscard]] const style::Units& units() const { return units_; }
  [[nodiscard]] style::Theme theme() const { return theme_; }

  void setHovered(std::optional<double> distance);
  void setPinned(std::optional<double> distance);
  /** Only one thing is selected: selecting one takes the mark from the other. */
  void selectTarget(int target);
  void selectWeather(int cell);
  void setLanding(std::shared_ptr<const LandingCase> landing);
  void setUnits(const style::Units& units);
  void setTheme(style::Theme theme);
  /** Asks map and 3D view to bring a place into view. */
  void showPlace(geo::Point place) { emit placeRequested(place); }

signals:
  void cursorChanged();
  void selectionChanged();
  void landingChanged();
  void unitsChanged();
  void themeChanged();
  void placeRequested(vp::geo::Point place);

private:
  std::optional<double> hovered_;
  std::optional<double> pinned_;
  int selectedTarget_ = -1;
  int selectedWeather_ = -1;
  std::shared_ptr<const LandingCase> landing_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

}  // namespace vp::document
