#pragma once

#include "core/geo/local_frame.h"
#include "core/mission/weather.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <vector>

class QWidget;

namespace vp::dialogs {
class MessageBanner;
class WeatherListDialog;
}  // namespace vp::dialogs

namespace vp::gui {

/** Weather of the mission: drawn and dragged on the map, edited in a dialog or a table, written to a file. Each change is one undo step; one that no
 *  planner could use is refused with its sentence. */
class WeatherController : public QObject {
  Q_OBJECT

public:
  WeatherController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QWidget* window);

  /** A new cell of this outline, after its altitudes and probability have been asked for. */
  void add(const std::vector<geo::LatLon>& outline);
  void edit(int cell);
  void replace(int cell, const mission::WeatherCell& value);
  void remove(int cell);
  void moveCorner(int cell, int corner, geo::LatLon place);
  void tell(const QString& problem);
  /** The list of all cells, beside the window. */
  void showList();
  void exportByDialog();
  /** Writes the mission's weather as GeoJSON. */
  void exportTo(const QString& path);

signals:
  void drawRequested();
  void addRequested();

private:
  [[nodiscard]] const mission::WeatherCell* at(int cell) const;
  [[nodiscard]] bool isUsable(const mission::WeatherCell& cell);
  void refreshList();

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QWidget* window_;
  QPointer<dialogs::WeatherListDialog> list_;
};

}  // namespace vp::gui
