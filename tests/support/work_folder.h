#pragma once
// A small mission with its terrain in a folder of its own, which plans within a second.

#include <QDir>
#include <QFile>
#include <QString>

namespace vp::test {

/** Copies mountain-n5.vpm, with settings that plan fast, and its terrain. @return the mission's path; empty if that failed */
inline QString makeWorkFolder(const QString& folder, const QString& name = QStringLiteral("job.vpm")) {
  const QString maps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");
  const QString mission = QDir(folder).filePath(name);
  const QString terrain = QDir(folder).filePath(QStringLiteral("mountain.tif"));
  QFile source(maps + QStringLiteral("mountain-n5.vpm"));
  QFile target(mission);
  if (!QDir().mkpath(folder) || !(QFile::exists(terrain) || QFile::copy(maps + QStringLiteral("mountain.tif"), terrain)) ||
      !source.open(QIODevice::ReadOnly) || !target.open(QIODevice::WriteOnly)) {
    return {};
  }
  QByteArray text = source.readAll();
  text.replace("\"headings\": 8", "\"headings\": 4").replace("\"step_m\": 50.0", "\"step_m\": 100.0");
  text.replace("\"roadmapSamples\": 7500", "\"roadmapSamples\": 800");
  return target.write(text) == text.size() ? mission : QString();
}

}  // namespace vp::test
