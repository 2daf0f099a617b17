#pragma once
// Where the real terrain and airfields are that some tests use.

#include <QDir>
#include <QString>

namespace vp::test {

/// The folder beside the checkout, or VOLPLANE_DATA. Empty: there is none.
inline QString dataFolder() {
  const QString fromEnvironment = qEnvironmentVariable("VOLPLANE_DATA");
  for (const QString& folder :
       {fromEnvironment, QStringLiteral(VOLPLANE_SOURCE_DIR "/../shared/data"), QStringLiteral(VOLPLANE_SOURCE_DIR "/../../shared/data")}) {
    if (!folder.isEmpty() && QDir(folder + "/dem").exists()) {
      return QDir(folder).absolutePath();
    }
  }
  return {};
}

}  // namespace vp::test
