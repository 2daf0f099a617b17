#pragma once

#include <QDateTime>
#include <QFileInfo>
#include <QString>

#include <string>
#include <vector>

namespace vp::jobs {

/** What tells, without reading it, that a file has been written anew or another one put in its place, even one of the same
 *  size that was made to look as old. */
struct FileStamp {
  qint64 size = -1;  ///< bytes; -1: not there
  QDateTime changed;
  QDateTime replaced;  ///< when its entry in the file system changed last; nobody can set this
  bool operator==(const FileStamp&) const = default;
};

inline std::vector<FileStamp> stampsOf(const std::vector<std::string>& files) {
  std::vector<FileStamp> stamps;
  for (const std::string& file : files) {
    const QFileInfo info(QString::fromStdString(file));
    stamps.push_back(info.exists() ? FileStamp{info.size(), info.lastModified(), info.metadataChangeTime()} : FileStamp{});
  }
  return stamps;
}

}  // namespace vp::jobs
