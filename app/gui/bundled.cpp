#include "app/gui/bundled.h"

#include "core/formats/aircraft_file.h"

#include <QFileInfo>

namespace vp::gui {

QString bundledExample() {
  for (const std::string& folder : formats::resourceFolders()) {
    const QString base = QString::fromStdString(folder);
    for (const QString& relative : {QStringLiteral("/maps/alpine-n10.vpm"), QStringLiteral("/../maps/alpine-n10.vpm")}) {
      const QFileInfo file(base + relative);
      if (file.isFile()) {
        return file.canonicalFilePath();
      }
    }
  }
  return {};
}

bool isBundled(const QString& path) {
  const QString example = bundledExample();
  return !example.isEmpty() && QFileInfo(path).canonicalPath() == QFileInfo(example).canonicalPath();
}

}  // namespace vp::gui
