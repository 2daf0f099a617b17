#pragma once
// Faults of the machine, made truly: a disk that is full, a folder that may not be written, a user without rights.

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QString>

#include <csignal>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::test {

/** A folder on a disk of its own that can be filled, made read-only and taken away. Only root may mount one; for others the
 *  same is done by a limit on the size of files and by permissions, and the sentences differ where the system's do. */
class SmallDisk {
public:
  explicit SmallDisk(QString folder, int kilobytes = 4096) : folder_(std::move(folder)) {
    QDir().mkpath(folder_);
    const QByteArray size = "size=" + QByteArray::number(kilobytes) + "k";
    isMounted_ = ::geteuid() == 0 && ::mount("tmpfs", folder_.toLocal8Bit(), "tmpfs", 0, size.constData()) == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    free();
    makeWritable();
    if (isMounted_) {
      ::umount2(folder_.toLocal8Bit(), MNT_DETACH);
    }
  }

  [[nodiscard]] QString path(const QString& name) const { return QDir(folder_).filePath(name); }
  [[nodiscard]] QString folder() const { return folder_; }

  /// Nothing more goes onto it.
  void fill() {
    if (isMounted_) {
      QFile ballast(path(QStringLiteral("ballast")));
      const bool isOpen = ballast.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
      const QByteArray block(4096, 'x');
      while (isOpen && ballast.write(block) == block.size()) {
      }
    } else {
      ::getrlimit(RLIMIT_FSIZE, &before_);
      handler_ = std::signal(SIGXFSZ, SIG_IGN);
      rlimit none = before_;
      none.rlim_cur = 0;
      ::setrlimit(RLIMIT_FSIZE, &none);
    }
    isFull_ = true;
  }
  void free() {
    if (isFull_ && isMounted_) {
      QFile::remove(path(QStringLiteral("ballast")));
    } else if (isFull_) {
      ::setrlimit(RLIMIT_FSIZE, &before_);
      std::signal(SIGXFSZ, handler_);
    }
    isFull_ = false;
  }
  /// What a message about it must hold.
  [[nodiscard]] QByteArray fullWords() const { return isMounted_ ? "the disk is full" : "larger than the system allows"; }

  void makeReadOnly() { isReadOnly_ = isMounted_ ? remount(MS_RDONLY) : ::chmod(folder_.toLocal8Bit(), 0555) == 0; }
  void makeWritable() {
    if (isReadOnly_) {
      isReadOnly_ = !(isMounted_ ? remount(0) : ::chmod(folder_.toLocal8Bit(), 0755) == 0);
    }
  }
  [[nodiscard]] QByteArray readOnlyWords() const { return isMounted_ ? "the file system is read-only" : "there is no permission"; }

private:
  bool remount(unsigned long flags) const { return ::mount("tmpfs", folder_.toLocal8Bit(), "tmpfs", MS_REMOUNT | flags, nullptr) == 0; }

  QString folder_;
  bool isMounted_ = false;
  bool isFull_ = false;
  bool isReadOnly_ = false;
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

/** What lies in a folder, hidden files too: names and contents. Two of them are equal if nothing was lost, added or changed. */
inline QMap<QString, QByteArray> contentsOf(const QString& folder) {
  QMap<QString, QByteArray> found;
  QDirIterator entry(folder, QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
  while (entry.hasNext()) {
    QFile file(entry.next());
    found.insert(QDir(folder).relativeFilePath(file.fileName()), file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable"));
  }
  return found;
}

/** While it lives the process has the rights of nobody, if it was root's; files of others can be read but not written. */
class AsNobody {
public:
  AsNobody() : wasRoot_(::geteuid() == 0) {
    if (wasRoot_) {
      isNobody_ = ::seteuid(65534) == 0;
    }
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;
  ~AsNobody() {
    if (isNobody_) {
      isNobody_ = ::seteuid(0) != 0;
    }
  }
  [[nodiscard]] bool isHeld() const { return isNobody_ || !wasRoot_; }

private:
  bool wasRoot_;
  bool isNobody_ = false;
};

}  // namespace vp::test
