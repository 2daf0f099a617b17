#pragma once

#include "ui/map/hit_test.h"
#include "ui/map/map_scene.h"

#include <QMenu>

#include <functional>
#include <memory>
#include <optional>

namespace vp::map {

/** What the context menu can do; the map connects it. */
struct MenuActions {
  std::function<void(geo::Point, int insertBefore)> addTarget;
  std::function<void(int)> moveTarget;
  std::function<void(int)> renameTarget;
  std::function<void(int)> editTarget;
  std::function<void(int)> removeTarget;
  std::function<void(const QString& site, bool exclude)> excludeSite;
  std::function<void(const QString& takeoff, const QString& landing)> setHome;  ///< empty: the tour alone
  /// Of all airspaces of a kind, or of those of a name where that is given.
  std::function<void(const QString& kind, const QString& name, mission::AirspaceUse use)> setAirspaceUse;
  std::function<void()> editAirspaceRules;
  std::function<void(int)> editWeather;
  std::function<void(int)> removeWeather;
  std::function<void(double distance)> pin;
  std::function<void(geo::Point, std::optional<double> distance)> engineOut;  ///< distance: along the tour, where that was clicked
  std::function<void(const MapObject&, geo::Point)> zoomTo;
  std::function<void(geo::Point)> measureFrom;
  std::function<void(geo::Point)> toggleRings;
  bool hasRings = false;  ///< range rings have their middle there
  std::function<void(geo::Point)> centreOn;
  std::function<void()> showAll;
};

/** A context menu whose entries name the object under the mouse. */
std::unique_ptr<QMenu> mapMenu(const MapScene& scene, const MapObject& object, geo::Point place, const MenuActions& actions);

}  // namespace vp::map
