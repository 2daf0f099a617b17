#include "ui/document/document_lock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QLockFile>
#include <QSysInfo>

namespace vp::document {
namespace {

constexpr qint64 kHalfMade = 60;  // s; far longer than making a lock file takes

QString translate(const char* text) {
  return QCoreApplication::translate("vp::document::DocumentLock", text);
}

}  // namespace

QString LockOwner::text() const {
  const QLocale locale;
  const QString time =
      since.date() == QDate::currentDate() ? locale.toString(since.time(), QLocale::ShortFormat) : locale.toString(since, QLocale::ShortFormat);
  return translate("%1 on %2 (%3, process %4) since %5")
      .arg(user.isEmpty() ? translate("somebody") : user, host.isEmpty() ? translate("an unknown computer") : host,
           program.isEmpty() ? QStringLiteral("volplane") : program)
      .arg(process)
      .arg(time);
}

DocumentLock::DocumentLock() = default;

DocumentLock::~DocumentLock() = default;

QString DocumentLock::lockFileOf(const QString& missionPath) {
  const QFileInfo file(missionPath);
  return file.dir().absoluteFilePath(QLatin1Char('.') + file.fileName() + QStringLiteral(".lock"));
}

DocumentLock::Outcome DocumentLock::take(const QString& missionPath) {
  release();
  path_ = missionPath;
  outcome_ = missionPath.isEmpty() ? Outcome::Without : attempt(missionPath);
  return outcome_;
}

DocumentLock::Outcome DocumentLock::pass(const QString& missionPath) {
  release();
  path_ = missionPath;
  return outcome_;
}

DocumentLock::Outcome DocumentLock::attempt(const QString& missionPath) {
  const QString file = lockFileOf(missionPath);
  auto lock = std::make_unique<QLockFile>(file);
  lock->setStaleLockTime(0);  // only the death of its process makes it stale
  if (lock->tryLock(0)) {
    lock_ = std::move(lock);
    return Outcome::Held;
  }
  if (lock->error() != QLockFile::LockFailedError) {
    return Outcome::Without;
  }
  owner_ = {};
  const QFileInfo info(file);
  const auto age = [&info] { return info.lastModified().secsTo(QDateTime::currentDateTime()); };
  if (info.exists() && info.size() == 0 && age() > kHalfMade && QFile::remove(file) && lock->tryLock(0)) {  // its process died while making it
    lock_ = std::move(lock);
    return Outcome::Held;
  }
  if (!lock->getLockInfo(&owner_.process, &owner_.host, &owner_.program)) {
    return Outcome::Without;  // gone again, or nothing that says who
  }
  if (owner_.process == QCoreApplication::applicationPid() && owner_.host == QSysInfo::machineHostName()) {
    return Outcome::Held;
  }
  owner_.user = info.owner();
  owner_.since = info.lastModified();
  return Outcome::Busy;
}

void DocumentLock::release() {
  lock_.reset();  // unlocks
  path_.clear();
  outcome_ = Outcome::Without;
}

}  // namespace vp::document
