#pragma once

#include "core/base/result.h"
#include "core/mission/mission.h"
#include "core/mission/plan.h"
#include "ui/document/document_files.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <string>

namespace vp::document {

/** Mission and plan as one document: edited with undo, saved as NAME.vpm with the plan beside it as NAME.vpp.
 *
 *  Every edit replaces the mission value as a whole, so an undo step is two shared pointers and cannot be half undone.
 *  The plan is not part of the undo history: it belongs to the inputs that it was made from, so it is *current* exactly
 *  while the mission's inputs equal those in the plan, and undoing an edit makes it current again.
 *  File paths in mission() and plan() are absolute; save() writes them relative to the file where that is possible.
 *  @threads GUI thread only; mission() and plan() hand out immutable shared values for workers */
class MissionDocument : public QObject {
  Q_OBJECT

public:
  explicit MissionDocument(QObject* parent = nullptr);
  ~MissionDocument() override;

  [[nodiscard]] const mission::Mission& mission() const { return *mission_; }
  [[nodiscard]] std::shared_ptr<const mission::Mission> sharedMission() const { return mission_; }
  [[nodiscard]] std::shared_ptr<const mission::Plan> plan() const { return plan_; }
  [[nodiscard]] bool planIsCurrent() const { return planIsCurrent_; }  ///< false without a plan
  [[nodiscard]] QString path() const { return path_; }                 ///< of the .vpm file; empty: never saved
  [[nodiscard]] QString title() const;                                 ///< mission name, else file name, else "Untitled mission"
  [[nodiscard]] bool isModified() const;
  [[nodiscard]] QUndoStack& undoStack() { return undo_; }
  /** Why the plan beside the opened mission was not loaded, in a sentence; empty if it was or there is none. */
  [[nodiscard]] QString planProblem() const { return planProblem_; }

  /** One edit, one undo step; none if `change` changes nothing. @param name  as in the menu: "Move target 3"
   *  @param mergeKey  edits that follow each other with the same non-empty key become one step (a drag, a spin box); an
   *  edit that ends where it began leaves no step */
  void edit(const QString& name, const std::function<void(mission::Mission&)>& change, const QString& mergeKey = {});

  /** A plan made from sharedMission() (or an earlier one), terrain paths absolute; null drops the plan. The document
   *  becomes modified. */
  void setPlan(std::shared_ptr<const mission::Plan> plan);

  /** What startNew() starts with from now on; a document that nobody has touched or opened yet starts with it at once. */
  void setDefaults(const MissionDefaults& defaults);
  /** Replaces everything by an empty mission with the default aircraft and settings. */
  void startNew();
  /** Opens a .vpm (and the plan beside it, if it is over the same terrain; it may be out of date) or a .vpp (mission and
   *  plan; path() stays empty unless the same mission lies beside it, so that saving asks where to).
   *  @errors those of the readers; the document stays as it was */
  Result<void> open(const QString& path);
  /** The second half of open(), for contents that a worker has read with readDocument(). */
  void adopt(DocumentContents contents);
  /** Writes mission and plan; the plan's terrain paths relative to the file. Writes the plan first, so that a mission
   *  that was saved never loses its plan.
   *  @errors OutputFailed;  OutOfRange, BadFormat - a value that no mission may have, which could not be read again */
  Result<void> saveAs(const QString& path);
  /** The second half of saveAs(), for a snapshot of this document that a worker has written with writeDocument(). What was
   *  edited meanwhile stays unsaved. @param path  absolute */
  void markSaved(const DocumentContents& snapshot, const QString& path);
  /** Whether the plan has to be written as well when the document is saved there. @param path  absolute */
  [[nodiscard]] bool needsPlanWritten(const QString& path) const { return !planIsSaved_ || path != path_; }

  /** The document as immutable values, for writing it on another thread. */
  using Snapshot = DocumentContents;
  [[nodiscard]] Snapshot snapshot() const { return {mission_, plan_, path_, planProblem_, planIsSaved_}; }

  /** A snapshot as bytes, for autosave; restored with its original path and marked modified. */
  [[nodiscard]] static std::string recoveryData(const Snapshot& snapshot) { return recoveryText(snapshot); }
  Result<void> restore(const std::string& recoveryData);
  /** The second half of restore(), for contents that a worker has read with readRecoveryText(). */
  void adoptRecovered(DocumentContents contents);

signals:
  void missionChanged();  ///< any change of mission()
  void planChanged();     ///< plan() or planIsCurrent()
  void stateChanged();    ///< title(), path() or isModified()
  void replaced();        ///< everything is another document now: new, opened or restored. Before the other signals

private:
  class EditCommand;
  void comparePlan();
  void replaceMission(std::shared_ptr<const mission::Mission> mission);

  std::shared_ptr<const mission::Mission> mission_;
  std::shared_ptr<const mission::Plan> plan_;
  MissionDefaults defaults_;
  QUndoStack undo_;
  QString path_;
  QString planProblem_;
  bool planIsSaved_ = true;
  bool planIsCurrent_ = false;
};

}  // namespace vp::document
