#pragma once

#include "core/geo/geo_box.h"
#include "ui/dialogs/message_banner.h"
#include "ui/jobs/file_kind.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>

#include <optional>

class QWidget;

namespace vp::gui {

/** Brings terrain and airfields from public servers into the mission, and writes the map of lowest safe altitudes. Only these
 *  actions use the network, and only when the operator starts them. What was fetched is one undo step. */
class FetchController : public QObject {
  Q_OBJECT

public:
  /** @param iniFile  where settings live; empty: the user's own */
  FetchController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QString iniFile, QWidget* window);

  /** @param mapArea  what the map shows, if there is terrain */
  void fetchTerrainByDialog(const std::optional<geo::GeoBox>& mapArea);
  /** Asks first, telling the date of the files that are here. */
  void updateAirfields();
  void writeSafeAltitudesByDialog();

signals:
  /// What is being done, for the status bar; empty when that is over.
  void working(const QString& text);
  /// An update or a map has ended, well or not.
  void finished(bool good);

private:
  [[nodiscard]] QString outputFor(const QString& ending) const;
  void startUpdate();
  void addToMission(const jobs::NewFiles& files, const QString& told, const QStringList& notes);
  void offerStop(const QString& text);

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QString iniFile_;
  QWidget* window_;
  jobs::JobRunner terrainRunner_;
  jobs::JobRunner runner_;
};

}  // namespace vp::gui
