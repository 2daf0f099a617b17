#pragma once

#include "ui/briefing/briefing_options.h"
#include "ui/dialogs/message_banner.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>

#include <memory>

class QWidget;

namespace vp::gui {

/** Writes the briefing for the kneeboard in the background. The plan is checked anew, from its files; one that is not safe is
 *  briefed only after the operator was told so, and is then marked on every page. */
class BriefingController : public QObject {
  Q_OBJECT

public:
  BriefingController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QWidget* window);
  ~BriefingController() override;

  void openDialog();
  /** Starts writing; finished() follows. @param mayBeUnsafe  the operator knows  @pre the document has a plan */
  void write(const briefing::BriefingOptions& options, const QString& path, bool mayBeUnsafe);

signals:
  void finished(bool written, const QString& path);

private:
  [[nodiscard]] QString doubt() const;
  [[nodiscard]] QString suggestedPath() const;

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QWidget* window_;
  briefing::BriefingOptions options_;  ///< of the last one
  class Job;
  std::unique_ptr<Job> job_;
};

}  // namespace vp::gui
