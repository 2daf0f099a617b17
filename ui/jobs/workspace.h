#pragma once

#include "core/base/result.h"
#include "ui/document/mission_document.h"
#include "ui/document/situation.h"
#include "ui/document/view_state.h"
#include "ui/jobs/planning_outcome.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>

namespace vp::jobs {

struct NewFiles;

/** The working desk without any widget: the document, what its files hold, and the jobs that run for it.
 *
 *  Follows the document: terrain, sites and safe altitudes are loaded in the background as the mission names them, and
 *  situation() is what the views draw. Nothing here waits for a job; what a job was started for and has changed since is
 *  thrown away. @threads GUI thread; results of jobs arrive by queued signals */
class Workspace : public QObject {
  Q_OBJECT

public:
  enum class Activity { Idle, Loading, Planning };

  explicit Workspace(QObject* parent = nullptr);
  ~Workspace() override;

  [[nodiscard]] document::MissionDocument& document();
  [[nodiscard]] document::ViewState& view();
  [[nodiscard]] const document::Situation& situation() const;
  [[nodiscard]] Activity activity() const;
  [[nodiscard]] QStringList notes() const;  ///< what loading left out or derived; for the operator

  /** Starts planning from what is loaded; the plan is verified by the checker and put into the document.
   *  Refused with a sentence while nothing can be planned: no terrain, no sites, no targets, a target without terrain. */
  Result<void> startPlanning();
  /** Asks planning to stop. planningEnded follows within 100 ms; the document stays as it was. */
  void cancelPlanning();

  /** Adds sorted files (file_kind.h) to the mission, one undo step; those that it names already are passed over.
   *  @errors BadFile - it names all of them */
  Result<void> add(const NewFiles& given);

  /** Computes (or drops) the safe-altitude field of the overlay in the background. */
  void setSafeAltitudesWanted(bool wanted);

  /** Lowest safe altitude for the worst heading at a place [m MSL]; nothing while there is no roadmap or glide. */
  [[nodiscard]] std::optional<double> safeAltitudeAt(geo::Point place) const;

  /** Where glides matter: around targets and the runways nearest to them [m]. */
  [[nodiscard]] geo::Box glideArea() const;

  /** World and roadmap over all usable sites, for engine-out alternatives; null while not built. */
  [[nodiscard]] std::shared_ptr<const landing::World> world() const;
  [[nodiscard]] std::shared_ptr<const landing::Roadmap> roadmap() const;

  /** Stops everything and waits; for closing. */
  void stopAll();

signals:
  void situationChanged();
  void activityChanged();
  void progressed(double fraction, const QString& text);
  void notesChanged();
  void loadingFailed(const vp::Error& error);
  /// Verified, refused by the checker (findings say why), failed or cancelled.
  void planningEnded(const vp::jobs::PlanningOutcome& outcome);

private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace vp::jobs
