#include "ui/document/autosave.h"

#include "core/formats/atomic_file.h"
#include "core/formats/text_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>

namespace vp::document {
namespace {

const QString kEnding = QStringLiteral(".recovery");

QString lockOf(const QString& file) {
  return file + QStringLiteral(".lock");
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

bool Autosave::write(const std::string& data, std::optional<unsigned> ticket) const {
  const std::lock_guard lock(mutex_);
  return (!ticket || *ticket == ticket_) && formats::writeFileAtomically(file_.toStdString(), data).has_value();
}

void Autosave::remove() {
  const std::lock_guard lock(mutex_);
  ++ticket_;
  QFile::remove(file_);
}

std::optional<Autosave::Found> Autosave::takeOrphan(const QString& folder) {
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

void Autosave::discard(const Found& found) {
  QFile::remove(found.file);
}

}  // namespace vp::document
