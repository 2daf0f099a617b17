#include "ui/document/mailbox.h"

#include <utility>

namespace vp::document {

void Mailbox::post(std::function<void()> letter) {
  {
    const std::lock_guard lock(mutex_);
    letters_.push_back(std::move(letter));
  }
  QMetaObject::invokeMethod(this, "openOne", Qt::QueuedConnection);  // by name: then Qt makes the event, and nothing of ours is in it
}

void Mailbox::openOne() {
  std::function<void()> letter;
  {
    const std::lock_guard lock(mutex_);
    if (letters_.empty()) {
      return;
    }
    letter = std::move(letters_.front());
    letters_.pop_front();
  }
  letter();  // may destroy the box
}

}  // namespace vp::document
