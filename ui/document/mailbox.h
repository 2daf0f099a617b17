#pragma once

#include <QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace vp::document {

/** Brings what other threads have for the window to the window's thread. A letter is a function that is called there, later, in the
 *  order of posting; letters that are still there when the box is destroyed are never called.
 *  QMetaObject::invokeMethod with a queued connection does the same, but through locks inside Qt that the thread sanitizer does not
 *  see: these letters pass through a lock of ours, so what is found between two threads is a race and nothing else
 *  (packaging/sanitize-threads).
 *  @threads post() from any thread while the box lives; all else in the thread in which it was made */
class Mailbox : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  void post(std::function<void()> letter);

private:
  Q_INVOKABLE void openOne();

  std::mutex mutex_;
  std::deque<std::function<void()>> letters_;
};

}  // namespace vp::document
