#pragma once

#include "ui/dialogs/message_banner.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>
#include <QStringList>

class QWidget;

namespace vp::gui {

/** New, open, save, drop, close: never loses work without asking, and says in plain words why a file was refused. */
class FileController : public QObject {
  Q_OBJECT

public:
  FileController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QWidget* window);

  void startNew();
  void openByDialog();
  /** Opens a mission or plan after asking about unsaved work. @return false if it was not opened */
  bool open(const QString& path);
  bool save();
  bool saveAs();
  void addTerrainByDialog();
  void addAirfieldsByDialog();
  /** Dropped or named files: one mission or plan is opened, everything else is added to the mission. */
  void take(const QStringList& paths);
  /** Asks about a running plan and unsaved work. @return true if the window may close */
  bool mayClose();

signals:
  void opened(const QString& path);

private:
  bool mayDiscard();
  bool write(const QString& path);
  [[nodiscard]] QString folder() const;

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QWidget* window_;
};

}  // namespace vp::gui
