// Work on another thread: results, progress, stopping, exceptions, and nothing that comes late.
#include "core/base/expect.h"
#include "ui/jobs/job_runner.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

using namespace vp;
using jobs::JobRunner;

namespace {

/// Lets a test decide when work goes on.
class Gate {
public:
  void open() {
    const std::lock_guard lock(mutex_);
    isOpen_ = true;
    changed_.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return isOpen_; });
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isOpen_ = false;
};

Result<int> untilStopped(const Job& job) {
  while (!job.stopRequested()) {
    std::this_thread::yield();
  }
  return fail(Errc::Cancelled, "stopped");
}

}  // namespace

class TestJobRunner : public QObject {
  Q_OBJECT

private slots:
  void result_arrivesOnTheThreadOfTheRunner() {
    JobRunner runner;
    std::optional<int> answer;
    std::thread::id worker;
    std::thread::id receiver;
    runner.start<int>(
        [&worker](const Job&) -> Result<int> {
          worker = std::this_thread::get_id();
          return 42;
        },
        [&](Result<int> result) {
          receiver = std::this_thread::get_id();
          QVERIFY(!runner.isRunning());
          answer = *result;
        });
    QVERIFY(runner.isRunning());
    QVERIFY(!answer);  // never within start()
    QTRY_VERIFY(answer.has_value());
    QCOMPARE(*answer, 42);
    QVERIFY(receiver == std::this_thread::get_id());
    QVERIFY(worker != receiver);
  }

  void exceptions_becomeErrors_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("word");
    QTest::newRow("defect") << 0 << "expected";
    QTest::newRow("memory") << 1 << "memory";
    QTest::newRow("standard") << 2 << "out of luck";
    QTest::newRow("anything") << 3 << "defect";
  }

  void exceptions_becomeErrors() {
    QFETCH(int, kind);
    QFETCH(QString, word);
    JobRunner runner;
    std::optional<Result<int>> answer;
    runner.start<int>(
        [kind](const Job&) -> Result<int> {
          switch (kind) {
            case 0:
              VP_EXPECT(kind == 1);
              break;
            case 1:
              throw std::bad_alloc();
            case 2:
              throw std::runtime_error("out of luck");
            default:
              throw 7;
          }
          return 0;
        },
        [&answer](Result<int> result) { answer = std::move(result); });
    QTRY_VERIFY(answer.has_value());
    QVERIFY(!*answer);
    QVERIFY(answer->error().code == Errc::Internal);
    QVERIFY2(QString::fromStdString(answer->error().what).contains(word), answer->error().what.c_str());
  }

  void requestStop_stillBringsTheResult() {
    JobRunner runner;
    std::optional<Result<int>> answer;
    runner.start<int>(untilStopped, [&answer](Result<int> result) { answer = std::move(result); });
    runner.requestStop();
    QVERIFY(runner.isRunning());
    QTRY_VERIFY(answer.has_value());
    QVERIFY(answer->error().code == Errc::Cancelled);
    QVERIFY(!runner.isRunning());
  }

  void cancel_forgetsTheResult() {
    JobRunner runner;
    Gate gate;
    std::atomic<bool> ended = false;
    bool told = false;
    runner.start<int>(
        [&](const Job&) -> Result<int> {
          gate.pass();
          ended = true;
          return 1;  // as if it had not noticed
        },
        [&told](const Result<int>&) { told = true; });
    runner.cancel();
    QVERIFY(!runner.isRunning());
    gate.open();
    QTRY_VERIFY(ended);
    bool next = false;
    runner.start<int>([](const Job&) -> Result<int> { return 2; }, [&next](const Result<int>&) { next = true; });
    QTRY_VERIFY(next);
    QVERIFY(!told);
  }

  /// The first work ends after the second: its answer would be the newer one by arrival.
  void staleResult_neverArrives() {
    JobRunner runner;
    Gate gate;
    auto ended = std::make_shared<std::atomic<bool>>(false);
    std::vector<int> answers;
    const auto keep = [&answers](const Result<int>& result) { answers.push_back(*result); };
    runner.start<int>(
        [&gate, ended](const Job&) -> Result<int> {
          gate.pass();
          *ended = true;
          return 1;
        },
        keep);
    runner.start<int>([](const Job&) -> Result<int> { return 2; }, keep);
    QTRY_COMPARE(answers.size(), std::size_t(1));
    gate.open();
    QTRY_VERIFY(ended->load());
    QCoreApplication::processEvents();
    QCOMPARE(answers, std::vector<int>{2});
  }

  void progress_isGatheredAndTheLatestAlwaysComes() {
    JobRunner runner;
    Gate shown;
    QSignalSpy progress(&runner, &JobRunner::progressed);
    bool done = false;
    QElapsedTimer clock;
    clock.start();
    runner.start<int>(
        [&shown](const Job& job) -> Result<int> {
          for (int i = 1; i <= 100'000; ++i) {
            job.progress(i * 1e-5, "step " + std::to_string(i));
          }
          shown.pass();
          return 0;
        },
        [&done](const Result<int>&) { done = true; });
    QTRY_VERIFY(!progress.isEmpty() && progress.last().at(1).toString() == QStringLiteral("step 100000"));
    QVERIFY(progress.count() <= 2 + clock.elapsed() / 100);
    QCOMPARE(progress.last().at(0).toDouble(), 1.0);
    const auto told = progress.count();
    shown.open();
    QTRY_VERIFY(done);
    QCOMPARE(progress.count(), told);
  }

  void progress_fromManyThreads_isWhole() {
    JobRunner runner;
    QSignalSpy progress(&runner, &JobRunner::progressed);
    bool done = false;
    runner.start<int>(
        [](const Job& job) -> Result<int> {
          std::vector<std::jthread> threads;
          for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&job] {
              for (int i = 0; i < 5000; ++i) {
                job.progress(0.5, "half of a rather long text that fits no small string");
              }
            });
          }
          return 0;
        },
        [&done](const Result<int>&) { done = true; });
    QTRY_VERIFY(done);
    for (const QList<QVariant>& told : progress) {
      QCOMPARE(told.at(1).toString(), QStringLiteral("half of a rather long text that fits no small string"));
    }
  }

  void progress_ofForgottenWork_isNotShown() {
    JobRunner runner;
    Gate gate;
    std::atomic<bool> ended = false;
    QSignalSpy progress(&runner, &JobRunner::progressed);
    runner.start<int>(
        [&](const Job& job) -> Result<int> {
          gate.pass();
          job.progress(0.5, "stale");
          ended = true;
          return 0;
        },
        [](const Result<int>&) {});
    runner.cancel();
    gate.open();
    QTRY_VERIFY(ended);
    bool done = false;
    runner.start<int>([](const Job&) -> Result<int> { return 0; }, [&done](const Result<int>&) { done = true; });
    QTRY_VERIFY(done);
    QCOMPARE(progress.count(), 0);
  }

  void start_fromTheResult_works() {
    JobRunner runner;
    int rounds = 0;
    std::function<void()> again = [&] {
      runner.start<int>([](const Job&) -> Result<int> { return 0; },
                        [&](const Result<int>&) {
                          if (++rounds < 50) {
                            again();
                          }
                        });
    };
    again();
    QTRY_COMPARE(rounds, 50);
  }

  void destruction_stopsAndWaits() {
    std::atomic<int> ended = 0;
    bool told = false;
    {
      JobRunner runner;
      for (int i = 0; i < 5; ++i) {  // four of them forgotten, all still there
        runner.start<int>(
            [&ended](const Job& job) {
              Result<int> result = untilStopped(job);
              ++ended;
              return result;
            },
            [&told](const Result<int>&) { told = true; });
      }
    }
    QCOMPARE(ended.load(), 5);
    QCoreApplication::processEvents();
    QVERIFY(!told);
  }

  void stopAndWait_leavesARunnerThatStartsAgain() {
    JobRunner runner;
    std::atomic<bool> ended = false;
    runner.start<int>(
        [&ended](const Job& job) {
          Result<int> result = untilStopped(job);
          ended = true;
          return result;
        },
        [](const Result<int>&) { QFAIL("forgotten work was told of"); });
    runner.stopAndWait();
    QVERIFY(ended);
    QVERIFY(!runner.isRunning());
    bool done = false;
    runner.start<int>([](const Job&) -> Result<int> { return 0; }, [&done](const Result<int>&) { done = true; });
    QTRY_VERIFY(done);
  }
};

QTEST_GUILESS_MAIN(TestJobRunner)
#include "tst_job_runner.moc"
