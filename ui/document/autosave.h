#pragma once

#include <QLockFile>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::document {

/** A file of unsaved work that belongs to one running process, so that several windows do not disturb each other. Written
 *  whole or not at all; a lock beside it tells whether its process still lives, so a kill -9 leaves it to be found.
 *  @threads write() from any one thread at a time; everything else on the thread that made the object */
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
  /** @return false if it could not be written; the last one stays */
  bool write(const std::string& data) const;
  void remove() const;

  /** Work that a process left which no longer runs. Taken: it is deleted from the folder by discard(). */
  struct Found {
    QString file;
    std::string data;
  };
  [[nodiscard]] static std::optional<Found> takeOrphan(const QString& folder);
  static void discard(const Found& found);

private:
  QString file_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace vp::document
