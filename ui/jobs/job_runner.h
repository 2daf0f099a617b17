#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "ui/document/mailbox.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace vp::jobs {

/** Runs one long piece of core's work at a time on a thread of its own and brings the result back to the thread of this
 *  object. A new start() or cancel() asks the running one to stop and forgets it: its result never arrives. Progress comes
 *  at most ten times a second, the latest always, none after the result. Exceptions of the work become errors
 *  (Errc::Internal): a defect must not end the editor.
 *  @threads all members on the thread of the object; destroying it stops and waits */
class JobRunner : public QObject {
  Q_OBJECT

public:
  explicit JobRunner(QObject* parent = nullptr);
  ~JobRunner() override;

  /** @param work  called on the worker   @param done  called here with the result, unless the work was forgotten */
  template <typename T>
  void start(std::function<Result<T>(const Job&)> work, std::function<void(Result<T>)> done) {
    auto result =
        std::make_shared<Result<T>>(fail(Errc::Internal, tr("no further thread could be started; close other programs and try again").toStdString()));
    run([work = std::move(work), result](const Job& job) { *result = guarded<T>(work, job); },
        [done = std::move(done), result] { done(std::move(*result)); });
  }

  /** Asks the running work to stop and forgets it. */
  void cancel();
  /** Asks the running work to stop; its result (most likely Errc::Cancelled) still arrives. */
  void requestStop();
  /** Forgets the running work and waits until no thread is left. For closing. */
  void stopAndWait();
  [[nodiscard]] bool isRunning() const { return isRunning_; }

signals:
  void progressed(double fraction, const QString& text);

private:
  template <typename T>
  static Result<T> guarded(const std::function<Result<T>(const Job&)>& work, const Job& job) {
    try {
      return work(job);
    } catch (const std::bad_alloc&) {
      return fail(Errc::Internal, tr("there is not enough memory for this; close other programs or use a smaller terrain").toStdString());
    } catch (const std::exception& defect) {
      return fail(Errc::Internal,
                  tr("a defect in the program stopped this work, nothing was changed: %1").arg(QString::fromUtf8(defect.what())).toStdString());
    } catch (...) {
      return fail(Errc::Internal, tr("a defect in the program stopped this work, nothing was changed").toStdString());
    }
  }
  void run(std::function<void(const Job&)> work, const std::function<void()>& done);
  void finished(unsigned generation, const std::function<void()>& done);
  void showProgress();

  document::Mailbox mailbox_;  ///< of the workers, which end before it does
  struct Worker {
    unsigned generation = 0;
    std::jthread thread;
  };
  std::vector<Worker> workers_;  ///< the running one last; before it those that were forgotten and have not ended yet
  struct Progress;
  std::shared_ptr<Progress> progress_;  ///< of the running work
  QTimer pace_;                         ///< runs while no progress may be shown yet
  unsigned generation_ = 0;
  bool isRunning_ = false;
};

}  // namespace vp::jobs
