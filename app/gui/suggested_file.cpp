#include "app/gui/suggested_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace vp::gui {

QString suggestedFolder(const document::MissionDocument& mission) {
  if (!mission.path().isEmpty()) {
    return QFileInfo(mission.path()).absolutePath();
  }
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

QString suggestedName(const document::MissionDocument& mission) {
  QString name = mission.path().isEmpty() ? mission.title() : QFileInfo(mission.path()).completeBaseName();
  return name.replace(QLatin1Char('/'), QLatin1Char('-'));
}

}  // namespace vp::gui
