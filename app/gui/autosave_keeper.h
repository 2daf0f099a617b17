#pragma once

#include "ui/dialogs/message_banner.h"
#include "ui/document/autosave.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>
#include <QTimer>

namespace vp::gui {

/** Keeps the unsaved work on disk while it is edited and offers it back after a crash. Written in the background, at most
 *  every two seconds. */
class AutosaveKeeper : public QObject {
public:
  /** @param folder  empty: the user's own */
  AutosaveKeeper(jobs::Workspace& workspace, const QString& folder, QObject* parent);

  /** Restores work of a process that did not end properly. @return true if there was some; the banner says so */
  bool offerRecovery(dialogs::MessageBanner& banner);
  /** Nothing is unsaved any more. */
  void discard();
  [[nodiscard]] QString file() const { return autosave_.file(); }

private:
  void write();

  jobs::Workspace& workspace_;
  QString folder_;
  document::Autosave autosave_;
  jobs::JobRunner writer_;
  QTimer delay_;
};

}  // namespace vp::gui
