// The table of decision points: numbers sort as numbers, the selection and the cursor are one, thousands of rows stay quick.
#include "tests/support/planned_tour.h"
#include "ui/panels/decision_model.h"
#include "ui/panels/decision_table.h"

#include <QElapsedTimer>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <cmath>

using namespace vp;
using panels::DecisionModel;

class TestDecisionTable : public QObject {
  Q_OBJECT

  document::Situation situation_;
  std::unique_ptr<document::ViewState> state_;
  std::unique_ptr<panels::DecisionTable> table_;

private slots:
  void initTestCase() { situation_ = test::plannedSituation(); }

  void init() {
    state_ = std::make_unique<document::ViewState>();
    table_ = std::make_unique<panels::DecisionTable>(*state_);
    table_->resize(900, 400);
    table_->setSituation(situation_);
    table_->show();
    QVERIFY(QTest::qWaitForWindowExposed(table_.get()));
  }

  void rows_areThePlansDecisionPoints() {
    test::keepPicture(table_->grab().toImage(), QStringLiteral("decision-table"));
    const auto& tour = situation_.plan->plan().tour;
    DecisionModel& model = table_->model();
    QCOMPARE(model.rowCount(), static_cast<int>(tour.size()));
    for (const std::size_t point : {std::size_t(0), tour.size() / 3, tour.size() - 1}) {
      const int row = model.rowOf(static_cast<int>(point));
      QCOMPARE(model.index(row, DecisionModel::Altitude).data().toString(), state_->units().altitudeMsl(tour[point].altitude));
      QCOMPARE(model.index(row, DecisionModel::Margin).data().toString(), state_->units().margin(tour[point].altitude - tour[point].safeAltitude));
      const document::EngineOut glide = situation_.plan->engineOutAt(situation_.plan->distanceOf(point));
      QCOMPARE(model.index(row, DecisionModel::GlideLength).data().toString(), state_->units().distance(glide.length));
      QCOMPARE(model.index(row, DecisionModel::GlideTime).data().toString(), style::Units::duration(glide.seconds));
    }
  }

  void everyColumn_sortsByItsNumber() {
    DecisionModel& model = table_->model();
    for (int column = 0; column < DecisionModel::ColumnCount; ++column) {
      for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
        table_->table().sortByColumn(column, order);
        for (int row = 1; row < model.rowCount(); ++row) {
          const double a = model.valueOf(model.pointOf(row - 1), column);
          const double b = model.valueOf(model.pointOf(row), column);
          QVERIFY(order == Qt::AscendingOrder ? a <= b : a >= b);
        }
      }
    }
    // margins of +99 ft and +1 000 ft: as text the longer one would come first
    table_->table().sortByColumn(DecisionModel::Margin, Qt::AscendingOrder);
    const auto& tour = situation_.plan->plan().tour;
    const auto margin = [&](int row) {
      const mission::DecisionPoint& point = tour[static_cast<std::size_t>(model.pointOf(row))];
      return point.altitude - point.safeAltitude;
    };
    QVERIFY(margin(0) < margin(model.rowCount() - 1));
  }

  void filter_keepsMatchingPoints() {
    const QString target = QString::fromStdString(situation_.plan->plan().targets[2].target.name);
    table_->findChild<QLineEdit*>()->setText(target);
    DecisionModel& model = table_->model();
    QVERIFY(model.rowCount() >= 1 && model.rowCount() < static_cast<int>(situation_.plan->plan().tour.size()));
    for (int row = 0; row < model.rowCount(); ++row) {
      QCOMPARE(model.index(row, DecisionModel::Target).data().toString(), target);
    }
    table_->findChild<QLineEdit*>()->setText(QStringLiteral("7"));
    QVERIFY(model.rowOf(6) >= 0);
    table_->findChild<QLineEdit*>()->setText(QStringLiteral("no such runway"));
    QCOMPARE(model.rowCount(), 0);
    QVERIFY(!state_->pinned());
    table_->findChild<QLineEdit*>()->clear();
    QCOMPARE(model.rowCount(), static_cast<int>(situation_.plan->plan().tour.size()));
  }

  void selection_pinsAndFollowsTheCursor() {
    table_->table().sortByColumn(DecisionModel::Margin, Qt::AscendingOrder);
    table_->table().setFocus();
    table_->table().selectRow(3);
    const int point = table_->model().pointOf(3);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(static_cast<std::size_t>(point)));
    QTest::keyClick(&table_->table(), Qt::Key_Down);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(static_cast<std::size_t>(table_->model().pointOf(4))));
    // the cursor of another view, between two points: the one passed last is selected, and nothing is pinned by that
    const double before = *state_->pinned();
    state_->setHovered(situation_.plan->distanceOf(9) + 1.0);
    QCOMPARE(table_->model().pointOf(table_->table().currentIndex().row()), 9);
    QCOMPARE(*state_->pinned(), before);
    // sorting anew keeps the point selected
    table_->table().sortByColumn(DecisionModel::Altitude, Qt::DescendingOrder);
    QCOMPARE(table_->model().pointOf(table_->table().currentIndex().row()), 9);
  }

  void activation_showsThePlace() {
    QSignalSpy shown(state_.get(), &document::ViewState::placeRequested);
    table_->table().selectRow(5);
    table_->table().setFocus();
    QTest::keyClick(&table_->table(), Qt::Key_Return);
    QCOMPARE(shown.count(), 1);
    const auto place = shown.at(0).at(0).value<geo::Point>();
    QCOMPARE(place, situation_.plan->plan().tour[static_cast<std::size_t>(table_->model().pointOf(5))].pose.point());
  }

  void tenThousandRows_areSortedAndFiltered() {
    const auto& small = situation_.plan->plan().tour;
    const document::Situation large = test::withChangedPlan(situation_, [&](mission::Plan& plan) {
      plan.tour.clear();
      while (plan.tour.size() < 10000) {
        plan.tour.insert(plan.tour.end(), small.begin(), small.end());
      }
    });
    QElapsedTimer timer;
    timer.start();
    table_->setSituation(large);
    qInfo("set %lld us", static_cast<long long>(timer.nsecsElapsed() / 1000));
    for (const int column : {static_cast<int>(DecisionModel::Margin), static_cast<int>(DecisionModel::Runway)}) {
      timer.restart();
      table_->table().sortByColumn(column, Qt::DescendingOrder);
      qInfo("sort by column %d: %lld us", column, static_cast<long long>(timer.nsecsElapsed() / 1000));
    }
    QVERIFY(table_->model().rowCount() >= 10000);
    timer.restart();
    state_->setHovered(large.plan->distanceOf(7000));
    qInfo("follow %lld us", static_cast<long long>(timer.nsecsElapsed() / 1000));
    QCOMPARE(table_->model().pointOf(table_->table().currentIndex().row()), 7000);
    for (int row = 1; row < table_->model().rowCount(); ++row) {
      QVERIFY(table_->model().valueOf(table_->model().pointOf(row - 1), DecisionModel::Runway) >=
              table_->model().valueOf(table_->model().pointOf(row), DecisionModel::Runway));
    }
  }

  void withoutPlan_isEmpty() {
    table_->setSituation({});
    QCOMPARE(table_->model().rowCount(), 0);
    state_->setHovered(100.0);
    QVERIFY(!state_->pinned());
  }
};

QTEST_MAIN(TestDecisionTable)
#include "tst_decision_table.moc"
