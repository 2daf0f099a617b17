// "The engine stops here: where to?" in the real window: from a place of the map, from a point of the tour, changed, stopped and cleared.
#include "app/gui/main_window.h"
#include "tests/gui/operator.h"
#include "ui/document/landing_case.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp;

namespace {

constexpr int kLong = 120'000;  // ms; patience, not a measurement

}  // namespace

class TestLandingNow : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  [[nodiscard]] std::shared_ptr<const document::LandingCase> shown() const { return window_->workspace().view().landing(); }
  template <typename Widget>
  [[nodiscard]] Widget* child(const char* name) const {
    return window_->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] bool isAnswered() const { return shown() != nullptr && !shown()->isRunning && !shown()->landings.empty(); }

  void chooseOnMap(geo::Point place) {
    const std::unique_ptr<QMenu> menu = window_->mapView().contextMenuAt(window_->mapView().camera().toScreen(place));
    for (QAction* entry : menu->actions()) {
      if (entry->text().startsWith("Engine out here")) {
        entry->trigger();
        return;
      }
    }
    QFAIL("the menu has no entry for an engine failure");
  }

private slots:
  void initTestCase() {
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath("settings.ini"));
    window_->resize(1400, 900);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QSignalSpy ready(&desk(), &jobs::Workspace::situationChanged);
    window_->take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().terrain && desk().situation().sites && desk().world(), kLong);
  }

  void highOverTheMap_everyPlannerReachesARunway() {
    chooseOnMap({300.0, -400.0});
    auto* altitude = child<QDoubleSpinBox>("landingAltitude");
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), kLong);
    QVERIFY(child<QDockWidget>("landingDock")->isVisible());
    altitude->setValue(6000.0);  // ft: far above the safe altitudes of this map
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && std::abs(shown()->altitude - 6000.0 * 0.3048) < 1.0, kLong);
    for (const document::ShownLanding& landing : shown()->landings) {
      QVERIFY2(landing.site && landing.answer.verified, landing.answer.planner.c_str());
      QVERIFY(landing.answer.heightInHand > 0.0);
      QVERIFY(landing.glide.leastClearance > shown()->clearance - 1e-3);
      QVERIFY(geo::distance(landing.glide.path.back().pose.point(), landing.site->pose.point()) < 0.1);
    }
    QCOMPARE(child<QTableView>("landingPlanners")->model()->rowCount(), static_cast<int>(shown()->landings.size()));
    QVERIFY(child<QLabel>("landingSentence")->text().contains("in hand"));
  }

  void anotherRow_isShownOnTheMap() {
    QVERIFY(shown()->landings.size() > 1);
    auto* table = child<QTableView>("landingPlanners");
    const int other = shown()->selected == 0 ? 1 : 0;
    const QImage before = window_->mapView().grab().toImage();
    table->selectRow(other);
    QCOMPARE(shown()->selected, other);
    QVERIFY(window_->mapView().grab().toImage() != before || shown()->landings[0].answer.path == shown()->landings[1].answer.path);
  }

  void lowInAValley_saysThatItIsNoRunway() {
    child<QDoubleSpinBox>("landingAltitude")->setValue(std::ceil((shown()->ground + 5.0) / 0.3048));
    const double asked = child<QDoubleSpinBox>("landingAltitude")->value() * 0.3048;
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && std::abs(shown()->altitude - asked) < 1.0, kLong);
    for (const document::ShownLanding& landing : shown()->landings) {
      QVERIFY(!landing.site);
      QVERIFY(!landing.answer.whyNot.empty());
    }
    QVERIFY(!child<QLabel>("landingSentence")->text().contains("in hand"));
  }

  void onePlanner_isAskedAlone() {
    auto* planner = child<QComboBox>("landingPlanner");
    planner->setCurrentIndex(planner->findData(QStringLiteral("combined")));
    emit planner->activated(planner->currentIndex());
    child<QDoubleSpinBox>("landingAltitude")->setValue(6000.0);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && shown()->altitude > 1800.0, kLong);
    QCOMPARE(shown()->landings.size(), 1U);
    QVERIFY(shown()->landings.front().answer.verified);
  }

  void pointOfTheTour_isAskedWithItsAltitudeAndCourse() {
    QVERIFY(desk().startPlanning());
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan && desk().activity() == jobs::Workspace::Activity::Idle, kLong);
    desk().view().setPinned(1000.0);
    const document::TourState there = desk().situation().plan->at(1000.0);
    window_->action(QStringLiteral("planLanding"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && shown()->altitude == there.altitude, kLong);
    QCOMPARE(shown()->pose.heading, there.pose.heading);
    QVERIFY(shown()->shown() != nullptr && shown()->shown()->site);  // the tour is within glide of a runway everywhere
  }

  void otherRunways_askAgain() {
    const document::ShownLanding before = *shown()->shown();
    desk().document().edit(QStringLiteral("exclude"), [&](mission::Mission& mission) { mission.siteFilter.exclude.push_back(before.site->site.id); });
    QTRY_VERIFY_WITH_TIMEOUT(
        isAnswered() && (shown()->shown() == nullptr || !shown()->shown()->site || shown()->shown()->site->site.id != before.site->site.id), kLong);
  }

  void clear_takesItOffTheMap() {
    QTest::mouseClick(child<QPushButton>("landingClear"), Qt::LeftButton);
    QVERIFY(shown() == nullptr);
  }
};

QTEST_MAIN(TestLandingNow)
#include "tst_landing_now.moc"
