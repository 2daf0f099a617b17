#include "core/base/job.h"

#include <QTest>

#include <string>
#include <vector>

using vp::Job;

class TestJob : public QObject {
  Q_OBJECT

private slots:
  void defaultJob_neverStopsAndSwallowsProgress() {
    const Job job;
    job.progress(0.5, "half");
    QVERIFY(!job.stopRequested());
    QVERIFY(!job.part(0.0, 0.5).stopRequested());
  }

  void stop_reachesCopiesAndParts() {
    std::stop_source source;
    const Job job(source.get_token());
    const Job part = job.part(0.2, 0.6).part(0.0, 0.5);
    QVERIFY(!part.stopRequested());
    source.request_stop();
    QVERIFY(job.stopRequested() && part.stopRequested());
    QVERIFY(part.stopToken().stop_requested());
  }

  void progress_ofNestedParts_isMappedIntoTheWhole() {
    std::vector<double> fractions;
    std::string last;
    const Job job({}, [&](double fraction, std::string_view text) {
      fractions.push_back(fraction);
      last = text;
    });
    job.progress(0.0, "start");
    const Job part = job.part(0.2, 0.6);
    part.progress(0.0, "a");
    part.progress(1.0, "b");
    part.part(0.5, 1.0).progress(0.5, "inner");
    job.progress(1.0, "done");
    const std::vector<double> expected{0.0, 0.2, 0.6, 0.5, 1.0};
    QCOMPARE(fractions.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      QVERIFY(std::abs(fractions[i] - expected[i]) < 1e-12);
    }
    QCOMPARE(last, std::string("done"));
  }
};

QTEST_APPLESS_MAIN(TestJob)
#include "tst_job.moc"
