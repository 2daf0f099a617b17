#pragma once

#include "core/base/result.h"

#include <QLockFile>
#include <QString>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace vp::document {

/** A file of unsaved work that belongs to one running process, so that several windows do not disturb each other. Written
 *  whole or not at all; a lock beside it tells whether its process still lives, so a kill -9 leaves it to be found.
 *  @threads write() and remove() from any thread; everything else on the thread that made the object */
class Autosave {
public:
  /** @param folder  made if it is not there */
  explicit Autosave(const QString& folder);
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /** Where the user's own lie. */
  static QString defaultFolder();

  [[nodiscard]] QString file() const { return file_; }
  /** Drawn before work is gathered for write(): a remove() in between makes the ticket invalid, so that a slow writer cannot
   *  bring back what has been saved or discarded meanwhile. */
  [[nodiscard]] unsigned ticket() const;
  /** The last one stays if this fails. @errors OutputFailed;  Cancelled - the ticket is invalid */
  Result<void> write(const std::string& data, std::optional<unsigned> ticket = std::nullopt) const;
  void remove();

  /** Work that a process left which no longer runs, latest first. While it is held no other window is offered it; it stays
   *  in the folder until discard(). */
  struct Found {
    QString file;
    std::string data;
    std::shared_ptr<QLockFile> lock;
  };
  [[nodiscard]] static std::optional<Found> takeOrphan(const QString& folder);
  static void discard(const Found& found);
  /** Makes found work this object's own, in one step: at every moment there is one copy of it. @return false if it stays found */
  bool takeOver(const Found& found) const;

private:
  QString file_;
  std::unique_ptr<QLockFile> lock_;
  void makeSureOfLock() const;

  mutable std::mutex mutex_;
  unsigned ticket_ = 0;
};

}  // namespace vp::document
