#pragma once

#include "core/formats/targets/target_import.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/document_files.h"
#include "ui/document/document_lock.h"
#include "ui/jobs/file_intake.h"
#include "ui/jobs/file_stamp.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QWidget;

namespace vp::gui {

struct OpenedFile;
struct WrittenFile;

/** New, open, save, drop, close: never loses work without asking, and says in plain words why a file was refused.
 *  Files are read, judged and written by workers; the window goes on turning meanwhile, and what is edited in that time is
 *  not lost: before a document that was read replaces it the operator is asked again, and after saving it counts as unsaved.
 *  A mission that another window has open is opened only after a question that names the other one, and one that has been
 *  changed on disk since it was opened is not overwritten without one. */
class FileController : public QObject {
  Q_OBJECT

public:
  using Next = std::function<void()>;

  FileController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QWidget* window);

  void startNew();
  void openByDialog();
  /** Opens a mission or plan after asking about unsaved work. @param done  called when it was opened or refused, not when
   *  the operator called it off */
  void open(const QString& path, std::function<void(bool opened)> done = {});
  /** @param next  called when the document has been saved; not if it was called off or could not be written */
  void save(const Next& next = {});
  void saveAs(const Next& next = {});
  /** Saves there without asking. */
  void saveTo(const QString& path, const Next& next = {}) { write(path, next); }
  void addTerrainByDialog();
  void addAirfieldsByDialog();
  void addAirspacesByDialog();
  void addWeatherByDialog();
  void addPopulationByDialog();
  void importTargetsByDialog();
  /** Shows the targets of a file, adds those that are chosen in one undo step and says what was left out. */
  void importTargets(const QString& path);
  /** Dropped or named files: one mission or plan is opened, terrain, airfields, population and weather are added to the mission,
   *  targets are imported; what may be airfields or targets is asked about. */
  void take(const QStringList& paths);
  /** Asks about a running plan and unsaved work. @return true if the window may close now; else `later` is called as soon
   *  as what has to be written first is written, unless the operator called it off */
  bool mayClose(Next later);
  /** A file is being read, asked about or written. */
  [[nodiscard]] bool isBusy() const { return reader_.isRunning() || writer_.isRunning() || intake_.isBusy(); }

signals:
  void opened(const QString& path);
  void saved(const QString& path);
  /// What is being read or written, for the status bar; empty when that is over.
  void working(const QString& text);

private:
  enum class Answer { Save, Discard, Cancel };

  // file_controller_intake.cpp
  void connectIntake();
  [[nodiscard]] jobs::FileIntake::Holds askWhich(const QString& path);
  [[nodiscard]] std::optional<formats::ImportedTargets> askTargets(const jobs::TargetsOfFile& file);
  void showReading(const QString& text);
  void offerStop();
  void tellWeather(const QString& path, int count, const QStringList& notes);
  void tellTargets(const QString& path, const formats::ImportedTargets& added);

  // file_controller.cpp
  void whenDiscardable(const Next& next);
  [[nodiscard]] Answer askAboutChanges();
  void read(const QString& path, const std::function<void(bool)>& done);
  void adopt(const OpenedFile& read, const QString& path, const std::function<void(bool)>& done);
  void write(const QString& path, const Next& next, bool force = false);
  void written(const Result<WrittenFile>& result, const document::DocumentContents& snapshot, const QString& path, const Next& next);

  // file_controller_lock.cpp
  enum class WhileOpen { Copy, Anyway, Cancel };
  [[nodiscard]] WhileOpen askAboutOther(const QString& path, const document::LockOwner& owner);
  void askAboutOverwriting(const QString& path, const WrittenFile& written, const Next& next);
  void followPath();
  [[nodiscard]] QString folder() const;

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QWidget* window_;
  jobs::JobRunner reader_;
  jobs::JobRunner writer_;
  jobs::FileIntake intake_;
  QTimer stopDelay_;                              ///< until a long reading can be stopped at a click
  QString reading_;                               ///< what the intake reads
  QString offeredStop_;                           ///< the message that offers it; empty: none
  std::vector<Next> afterWriting_;                ///< what had to wait for the file that is being written
  std::shared_ptr<document::DocumentLock> lock_;  ///< of the document shown; null: it has no file
  QString sharedPath_;                            ///< a mission that is open elsewhere and here, as the operator wished
  QString stampedPath_;                           ///< the mission file that `stamps_` are of
  std::vector<jobs::FileStamp> stamps_;           ///< of it and its plan, as they were read or written here
  bool isReplaced_ = false;                       ///< the document that is being written is another one by now
};

}  // namespace vp::gui
