// Every shared instance: the known optimum up to 20 sets, within 1 % of the best known tour beyond.

#include "core/tour/gtsp_lib.h"
#include "tests/core/tour/gtsp_cases.h"

#include <QTest>

#include <charconv>
#include <fstream>
#include <sstream>

using namespace gtsp_cases;

class TestGtspKnown : public QObject {
  Q_OBJECT

private slots:
  void solve_underSharedInstance_reachesKnownCost_data();
  void solve_underSharedInstance_reachesKnownCost();
};

void TestGtspKnown::solve_underSharedInstance_reachesKnownCost_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("sets");
  QTest::addColumn<double>("best");
  const std::filesystem::path folder = dataFolder() / "gtsp";
  if (dataFolder().empty() || !std::filesystem::exists(folder / "best_known.csv")) {
    QSKIP("the shared test data with gtsp/best_known.csv is not here; set VOLPLANE_DATA to its folder");
  }
  std::ifstream in(folder / "best_known.csv");
  std::string line;
  while (std::getline(in, line)) {
    // instance,kind,nodes,sets,best,...
    const QStringList cells = QString::fromStdString(line).split(',');
    const std::filesystem::path plain = folder / (cells[0].toStdString() + ".gtsp");
    const std::filesystem::path file = std::filesystem::exists(plain) ? plain : std::filesystem::path(plain.string() + ".gz");
    if (std::filesystem::exists(file)) {
      QTest::newRow(qPrintable(cells[0])) << QString::fromStdString(file.string()) << cells[3].toInt() << cells[4].toDouble();
    }
  }
}

void TestGtspKnown::solve_underSharedInstance_reachesKnownCost() {
  QFETCH(QString, file);
  QFETCH(int, sets);
  QFETCH(double, best);
  const auto instance = vp::tour::loadGtspLib(file.toStdString());
  QVERIFY2(instance.has_value(), instance ? "" : instance.error().message().c_str());
  vp::tour::GtspOptions options;
  options.effort = sets > 60 ? 0.3 : 1.0;
  const auto solution = vp::tour::solveGtsp(instance->problem, options, vp::Job());
  QVERIFY(solution.has_value());
  QVERIFY(isTour(instance->problem, solution->tour));
  QVERIFY(std::abs(costOf(instance->problem, solution->tour) - solution->cost) < 1e-6);
  QVERIFY(solution->lowerBound <= solution->cost);
  if (best == 0.0) {  // no value is known
    return;
  }
  QVERIFY2(solution->lowerBound <= best, "the bound is above a known tour");
  QVERIFY2(sets > 20 ? solution->cost <= 1.01 * best : solution->cost <= best, qPrintable(QString("%1 instead of %2").arg(solution->cost).arg(best)));
  QVERIFY(sets > 12 || solution->optimal);
}

QTEST_APPLESS_MAIN(TestGtspKnown)
#include "tst_gtsp_known.moc"
