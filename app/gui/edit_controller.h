#pragma once

#include "core/geo/local_frame.h"
#include "core/mission/mission.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>

class QWidget;

namespace vp::gui {

/** Turns what the views ask for into edits of the document, each one undo step with a name. Asks by a dialog where a name
 *  or a number is needed. */
class EditController : public QObject {
  Q_OBJECT

public:
  EditController(jobs::Workspace& workspace, QWidget* window);

  void addTarget(geo::LatLon place, int insertBefore);
  void moveTarget(int target, geo::LatLon place);
  void removeTarget(int target);
  void renameTarget(int target);
  void editTarget(int target);
  void replaceTarget(int target, const mission::Target& value);
  void reorderTarget(int from, int to);
  void excludeSite(const QString& siteId, bool exclude);
  void setHome(const QString& takeoff, const QString& landing);  ///< both empty: the tour alone
  /// Of all airspaces of a kind, or of those of a name where that is given.
  void setAirspaceUse(const QString& kind, const QString& name, mission::AirspaceUse use);
  void editAirspaces();
  void setFilter(const mission::SiteFilter& filter);
  /// Only this end of its runway may be landed on, or both again.
  void setOneWay(const QString& siteId, bool oneWay);
  void setSiteNote(const QString& siteId, const QString& text);
  void includeAllSites();
  void allowPassingAbove();
  void raiseCeiling(double byMetres);
  void removeCeiling();
  void editMissionSettings();
  void editAircraft();
  void editWind();
  /** Takes one terrain file out of the mission, by its place in the list. */
  void removeTerrain(int index);
  /** Takes one source of airfields out; with the last one go the filter's entries for runways that nothing names any more. */
  void removeAirfields(int index);
  /// @param index  into AirspaceSettings::files
  void removeAirspaces(int index);
  /// @param index  into Mission::populationFiles
  void removePopulation(int index);

signals:
  /// Asked for from the airspace dialog.
  void airspaceFilesRequested();

private:
  [[nodiscard]] bool hasTarget(int target) const;
  [[nodiscard]] QString nameOf(int target) const;

  jobs::Workspace& workspace_;
  QWidget* window_;
};

/** The next free name of a new target: T01, T02, ... */
std::string freshTargetName(const mission::Mission& mission);

}  // namespace vp::gui
