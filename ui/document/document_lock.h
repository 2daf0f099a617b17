#pragma once

#include <QDateTime>
#include <QString>

#include <memory>

class QLockFile;

namespace vp::document {

/** Who has a mission open, as its lock file tells. */
struct LockOwner {
  qint64 process = 0;
  QString program;
  QString host;
  QString user;     ///< empty: not known
  QDateTime since;  ///< local time of the computer that holds the file

  /** "anna on kestrel (volplane, process 4711) since 14:03", the day before it if that is not today. */
  [[nodiscard]] QString text() const;
};

/** Says to other windows, on this and on other computers, that a mission is open: a file `.NAME.vpm.lock` beside it, made when
 *  the mission is opened and removed with this object. The lock of a process of this computer that has died counts for
 *  nothing, and neither does one from before the last start of the computer; of another computer that cannot be told, so its
 *  owner is shown and the operator decides. Where the file cannot be made (read-only folder, full disk) the mission is open
 *  without one.
 *  @threads from any thread, one object on one at a time */
class DocumentLock {
public:
  enum class Outcome {
    Held,    ///< ours, or another window of this process has it
    Busy,    ///< somebody else has it: owner() says who
    Without  ///< no lock file can be made there
  };

  DocumentLock();
  ~DocumentLock();
  DocumentLock(const DocumentLock&) = delete;
  DocumentLock& operator=(const DocumentLock&) = delete;

  /** Lets go of what it holds and locks another. @param missionPath  absolute; empty: nothing */
  Outcome take(const QString& missionPath);
  /** Lets go of what it holds; `missionPath` is one that needs no lock. @return Without */
  Outcome pass(const QString& missionPath);
  void release();

  [[nodiscard]] const QString& missionPath() const { return path_; }  ///< of the last take(); empty after release()
  [[nodiscard]] Outcome outcome() const { return outcome_; }          ///< of the last take()
  [[nodiscard]] const LockOwner& owner() const { return owner_; }     ///< after Busy

  static QString lockFileOf(const QString& missionPath);

private:
  Outcome attempt(const QString& missionPath);

  QString path_;
  Outcome outcome_ = Outcome::Without;
  LockOwner owner_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace vp::document
