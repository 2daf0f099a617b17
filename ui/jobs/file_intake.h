#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/formats/targets/target_import.h"
#include "core/formats/weather_file.h"
#include "ui/jobs/file_kind.h"
#include "ui/jobs/job_runner.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <deque>
#include <functional>
#include <optional>

namespace vp::jobs {

class Workspace;

/** A file of targets as it was read, and how to read it again with other options, on any thread. */
struct TargetsOfFile {
  using Found = Result<formats::ImportedTargets>;
  using Reader = std::function<Found(const formats::TargetImportOptions& options, const Job& job)>;

  QString path;
  Found found;  ///< read with the usual options; an error is one that other options may help
  Reader read;
};

/** Files that an operator drops or names, on their way into the mission: sorted and read by a worker, one after the other in the order in which they
 *  came, while the window goes on turning. What was read goes into the mission as it is by then, so edits made meanwhile stay and names are unique
 * among all. When another document takes the mission's place, what was on its way is dropped. A request that fails adds nothing of it.
 *  @threads GUI thread; workers get and give values */
class FileIntake : public QObject {
  Q_OBJECT

public:
  enum class Purpose {
    Any,         ///< terrain, airfields, airspaces, population, weather and targets by what they are
    Map,         ///< no targets: what can be airfields is
    Targets,     ///< targets only
    Weather,     ///< polygons of bad weather, whatever their fields
    Population,  ///< polygons with people
  };
  enum class Holds { Airfields, Targets, Neither };

  /** What only the operator can say. Called on the GUI thread, may run dialogs. */
  struct Operator {
    std::function<Holds(const QString& path)> which;  ///< of a file that can be taken for both; Neither: leave it out
    /// The targets to add with the notes of their reading; nothing: called off.
    std::function<std::optional<formats::ImportedTargets>(const TargetsOfFile& file)> choose;
  };

  FileIntake(Workspace& workspace, Operator operatorSays, QObject* parent = nullptr);

  /** Begins, or waits until what came before is done. */
  void take(const QStringList& paths, Purpose purpose);
  /** Drops what is being read and what waits. */
  void cancel();
  /** Something is read, asked about or waits. */
  [[nodiscard]] bool isBusy() const { return runner_.isRunning() || isAsking_ || !targets_.isEmpty() || !weather_.isEmpty() || !requests_.empty(); }

signals:
  /// What is being read, for the status bar; empty when nothing is.
  void working(const QString& text);
  /// Nothing of a request was added.
  void refused(const vp::Error& error);
  /// The targets that were added, which may be none, and what was left out.
  void targetsAdded(const QString& path, const vp::formats::ImportedTargets& added);
  /// How many cells were added, and what could not be used as it is, a sentence each.
  void weatherAdded(const QString& path, int count, const QStringList& notes);

private:
  struct Request {
    QStringList paths;
    Purpose purpose = Purpose::Any;
  };

  void next();
  void sort(const Request& request);
  void sorted(Result<SortedFiles> files);
  [[nodiscard]] bool askAbout(SortedFiles& files);
  void read(const QString& path);
  void readWeather(const QString& path);
  void addWeather(const QString& path, const formats::WeatherReport& report);
  void targetsRead(const TargetsOfFile& file);
  void addTargets(const QString& path, const formats::ImportedTargets& chosen);
  void refuse(const Error& error);

  Workspace& workspace_;
  Operator operator_;
  JobRunner runner_;
  std::deque<Request> requests_;  ///< that wait
  QStringList targets_;           ///< of the request in hand, to be read yet
  QStringList weather_;           ///< likewise
  unsigned generation_ = 0;       ///< of what was cancelled, for what comes back from a dialog
  bool isAsking_ = false;
};

}  // namespace vp::jobs
