#include "app/gui/suggested_folder.h"

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

}  // namespace vp::gui
