#pragma once

#include "ui/dialogs/message_banner.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vp::gui {

class EditController;

/** Starts and stops planning and says how it ended: success with the figures that matter, or the reason (which target, how much
 *  altitude is missing) with its remedies as buttons: "Raise ceiling by 340 ft", "Include excluded runways", "Allow passing
 *  above". A remedy is one edit that can be undone, and plans again. Only remedies that can help are offered. A plan that was opened is judged again:
 *  what the file says of its own safety is a claim. */
class PlanningController : public QObject {
  Q_OBJECT

public:
  PlanningController(jobs::Workspace& workspace, EditController& edits, dialogs::MessageBanner& banner, QObject* parent);

  void plan();
  void cancel();

signals:
  /// The checker's findings are worth a look.
  void reportReady(const vp::safety::SafetyReport& report);

private:
  using Actions = std::vector<dialogs::MessageBanner::Action>;

  void ended(const jobs::PlanningOutcome& outcome);
  void showSuccess(const jobs::PlanningOutcome& outcome);
  void showRefusal(const jobs::PlanningOutcome& outcome);
  void showFailure(const jobs::PlanningOutcome& outcome);
  void recheck();
  void rechecked(const Result<safety::SafetyReport>& result, const std::shared_ptr<const mission::Plan>& plan);
  [[nodiscard]] bool isFilterStrict() const;
  /// Whose ceiling is the lower one; nobody's where the air is reckoned up to mission::kCeilingWithoutOne.
  enum class Whose { Mission, Aircraft, Nobody };
  struct Limit {
    Whose whose = Whose::Nobody;
    double metres = 0.0;
  };
  /// The altitude that the tour cannot leave; nothing if there is none.
  [[nodiscard]] std::optional<Limit> limit() const;
  [[nodiscard]] QString failureText(const jobs::PlanningOutcome& outcome) const;
  void addCeilingRemedies(const jobs::PlanningOutcome& outcome, Actions& remedies);
  dialogs::MessageBanner::Action passAbove();
  dialogs::MessageBanner::Action includeRunways();
  void editAndPlan(const std::function<void()>& edit);

  jobs::Workspace& workspace_;
  EditController& edits_;
  dialogs::MessageBanner& banner_;
  bool planAfterLoading_ = false;
  bool recheckWanted_ = false;  ///< a document was opened; its certificate is a claim until the checker has seen the plan
  jobs::JobRunner checker_;
};

}  // namespace vp::gui
