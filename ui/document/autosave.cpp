#include "ui/document/autosave.h"

#include "core/formats/atomic_file.h"
#include "core/formats/temporary_file.h"
#include "core/formats/text_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

#include <cstdio>

namespace vp::document {
namespace {

const QString kEnding = QStringLiteral(".recovery");

QString lockOf(const QString& file) {
  return file + QStringLiteral(".lock");
}

/// What killed processes leave besides their work: locks of those that had none, and files that were half written.
void removeRemains(const QString& folder) {
  formats::removeAbandonedFiles(QFile::encodeName(folder).toStdString());
  for (const QFileInfo& file : QDir(folder).entryInfoList({QLatin1Char('*') + lockOf(kEnding)}, QDir::Files)) {
    const QString path = file.absoluteFilePath();
    QLockFile lock(path);
    lock.setStaleLockTime(0);
    if (!QFile::exists(path.chopped(lockOf({}).size()))) {
      lock.tryLock(0);  // removed again in the end; refused while its process lives
    }
  }
}

}  // namespace

Autosave::Autosave(const QString& folder) {
  QDir().mkpath(folder);
  const QString name = QStringLiteral("%1-%2").arg(QCoreApplication::applicationPid()).arg(QUuid::createUuid().toString(QUuid::Id128).left(8));
  file_ = QDir(folder).filePath(name + kEnding);
  lock_ = std::make_unique<QLockFile>(lockOf(file_));
  lock_->setStaleLockTime(0);  // only the death of its process makes it stale
  lock_->tryLock(0);
}

Autosave::~Autosave() = default;

QString Autosave::defaultFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
}

unsigned Autosave::ticket() const {
  const std::lock_guard lock(mutex_);
  return ticket_;
}

Result<void> Autosave::write(const std::string& data, std::optional<unsigned> ticket) const {
  const std::lock_guard lock(mutex_);
  if (ticket && *ticket != ticket_) {
    return fail(Errc::Cancelled, "this work has been saved or given up meanwhile");
  }
  makeSureOfLock();
  return formats::writeFileAtomically(file_.toStdString(), data);
}

void Autosave::remove() {
  const std::lock_guard lock(mutex_);
  ++ticket_;
  QFile::remove(file_);
}

std::optional<Autosave::Found> Autosave::takeOrphan(const QString& folder) {
  removeRemains(folder);
  const QFileInfoList files = QDir(folder).entryInfoList({QLatin1Char('*') + kEnding}, QDir::Files, QDir::Time);
  for (const QFileInfo& file : files) {
    const QString path = file.absoluteFilePath();
    auto lock = std::make_shared<QLockFile>(lockOf(path));
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0) || !QFile::exists(path)) {
      continue;  // its process lives, or another window has just dealt with it
    }
    if (const Result<std::string> data = formats::readFile(path.toStdString()); data && !data->empty()) {
      return Found{path, *data, std::move(lock)};
    }
  }
  return std::nullopt;
}

/// The folder may not have been there at the start, or the disk was full.
void Autosave::makeSureOfLock() const {
  if (!lock_->isLocked()) {
    QDir().mkpath(QFileInfo(file_).absolutePath());
    lock_->tryLock(0);
  }
}

bool Autosave::takeOver(const Found& found) const {
  const std::lock_guard lock(mutex_);
  makeSureOfLock();
  return lock_->isLocked() && std::rename(QFile::encodeName(found.file), QFile::encodeName(file_)) == 0;
}

void Autosave::discard(const Found& found) {
  QFile::remove(found.file);
}

}  // namespace vp::document
