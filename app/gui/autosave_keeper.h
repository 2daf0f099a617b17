#pragma once

#include "ui/dialogs/message_banner.h"
#include "ui/document/autosave.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>

namespace vp::gui {

/** Keeps the unsaved work on disk while it is edited and offers it back after a crash. Written in the background, at most
 *  every two seconds; if it cannot be written the banner says so once, and it is tried again. Paced by a monotonic clock. */
class AutosaveKeeper : public QObject {
  Q_OBJECT

public:
  /** @param folder  empty: the user's own */
  AutosaveKeeper(jobs::Workspace& workspace, dialogs::MessageBanner& banner, const QString& folder, QObject* parent);

  /** Restores work of a process that did not end properly; the banner says so. Read in the background.
   *  @param otherwise  called if there is none (empty text), or none that can be read, with a sentence that says so */
  void offerRecovery(const std::function<void(const QString& problem)>& otherwise);
  /** Nothing is unsaved any more. */
  void discard();
  [[nodiscard]] QString file() const { return autosave_.file(); }

private:
  void write();
  void recovered(const document::Autosave::Found& found, const document::DocumentContents& contents);
  void written(const Result<bool>& result);

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QString folder_;
  document::Autosave autosave_;
  jobs::JobRunner reader_;
  jobs::JobRunner writer_;
  QTimer delay_;
  bool isFailing_ = false;  ///< and that has been said
};

}  // namespace vp::gui
