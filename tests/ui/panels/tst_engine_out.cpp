// The engine-out panel: what it says is what the plan and the roadmaps say, and other runways arrive from another thread.
#include "tests/support/planned_tour.h"
#include "ui/panels/alternatives_model.h"
#include "ui/panels/alternatives_worker.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/profile/tour_curves.h"

#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <atomic>
#include <cmath>

using namespace vp;

namespace {

std::shared_ptr<landing::SiteRoadmaps> roadmapsFor(const document::Situation& situation, int samples = 300) {
  auto world = std::make_shared<landing::World>();
  world->terrain = situation.terrain->pyramid;
  world->glide = aircraft::GlideModel(situation.plan->plan().mission.aircraft);
  world->clearance = situation.plan->plan().mission.safety.clearance.si();
  world->arrivalMargin = situation.plan->plan().mission.safety.arrivalMargin.si();
  for (const document::ShownSite& site : *situation.sites) {
    world->sites.push_back(site.site);
  }
  landing::RrtStarOptions options;
  options.area = situation.terrain->grid->extent();
  options.samples = samples;
  return std::make_shared<landing::SiteRoadmaps>(std::move(world), options);
}

bool shows(const QWidget& panel, const QString& text) {
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (label->text().contains(text)) {
      return true;
    }
  }
  return false;
}

}  // namespace

class TestEngineOut : public QObject {
  Q_OBJECT

  document::Situation situation_;
  std::unique_ptr<document::ViewState> state_;
  std::unique_ptr<panels::EngineOutPanel> panel_;

private slots:
  void initTestCase() { situation_ = test::plannedSituation(); }

  void init() {
    state_ = std::make_unique<document::ViewState>();
    panel_ = std::make_unique<panels::EngineOutPanel>(*state_);
    panel_->resize(460, 720);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  }

  void cleanup() { panel_.reset(); }

  void withoutPlanOrPoint_saysWhatToDo() {
    QVERIFY(shows(*panel_, QStringLiteral("Plan a tour")));
    panel_->setSituation(situation_);
    QVERIFY(shows(*panel_, QStringLiteral("No point chosen")));
  }

  void point_underTheCursor_isDescribed() {
    panel_->setSituation(situation_);
    const style::Units& units = state_->units();
    for (const double share : {0.1, 0.45, 0.8}) {
      state_->setHovered(share * situation_.plan->length());
      const document::EngineOut glide = situation_.plan->engineOutAt(share * situation_.plan->length());
      const mission::LandingSite& site = situation_.plan->plan().sites[static_cast<std::size_t>(glide.site)].site;
      QVERIFY(shows(*panel_, profile::runwayNameLong(site)));
      QVERIFY(shows(*panel_, units.margin(glide.margin)));
      QVERIFY(shows(*panel_, units.distance(glide.length)));
      QVERIFY(shows(*panel_, style::Units::duration(glide.seconds)));
      QVERIFY(shows(*panel_, units.heightAboveGround(glide.leastClearance)));
    }
    state_->setUnits(style::Units(style::UnitSystem::Metric));
    QVERIFY(shows(*panel_, QStringLiteral(" m AGL")));
  }

  void alternatives_arriveAndMatchTheRoadmaps() {
    panel_->setSituation(situation_);
    const auto source = roadmapsFor(situation_);
    panel_->setAlternativesSource(source);
    const double distance = situation_.plan->leastGlideMargin().state.distance;
    state_->setPinned(distance);
    auto* table = panel_->findChild<QTableView*>();
    QTRY_VERIFY_WITH_TIMEOUT(table->isEnabled() && table->model()->rowCount() > 0, 20000);
    test::keepPicture(panel_->grab().toImage(), QStringLiteral("engine-out"));
    const document::EngineOut glide = situation_.plan->engineOutAt(distance);
    const auto answers = source->alternatives(glide.from.pose, glide.from.altitude, 100, Job{});
    const std::string& ownId = situation_.plan->plan().sites[static_cast<std::size_t>(glide.site)].site.id;
    int own = -1;
    for (std::size_t i = 0; i < source->world().sites.size(); ++i) {
      own = source->world().sites[i].site.id == ownId ? static_cast<int>(i) : own;
    }
    QVERIFY(own >= 0);
    const auto best = std::find_if(answers->begin(), answers->end(),
                                   [&](const landing::SiteAnswer& a) { return source->runwayOf(a.site) != source->runwayOf(own); });
    QVERIFY(best != answers->end());
    const QString sentence = panel_->closedSentence();
    QVERIFY2(sentence.contains(panels::physicalRunwayName(*source, own)), qPrintable(sentence));
    QVERIFY2(sentence.contains(profile::runwayName(source->world().sites[static_cast<std::size_t>(best->site)].site)), qPrintable(sentence));
    const QString height = best->isReachable() ? state_->units().margin(best->margin) : state_->units().margin(best->margin).mid(1);
    QVERIFY2(sentence.contains(height), qPrintable(sentence + " / " + height));
    QCOMPARE(sentence.contains(QStringLiteral("missing")), !best->isReachable());
    // the first row is that runway, and no row is an end of the runway that is taken to be closed
    for (int row = 0; row < table->model()->rowCount(); ++row) {
      const QString name = table->model()->index(row, panels::AlternativesModel::Runway).data().toString();
      const QString reach = table->model()->index(row, panels::AlternativesModel::Reach).data().toString();
      QVERIFY(!name.startsWith(profile::runwayName(source->world().sites[static_cast<std::size_t>(own)].site)));
      const bool missing = table->model()->index(row, panels::AlternativesModel::Margin).data().toString().startsWith(QChar(0x2212));
      QCOMPARE(reach == QStringLiteral("not reachable"), missing);
    }
  }

  void movingOn_dropsTheOldAnswer() {
    panel_->setSituation(situation_);
    panel_->setAlternativesSource(roadmapsFor(situation_, 150));
    auto* table = panel_->findChild<QTableView*>();
    for (int i = 1; i <= 20; ++i) {
      state_->setPinned(situation_.plan->length() * i / 25.0);
      QVERIFY(!table->isEnabled());  // what stands there belongs to another point
    }
    QTRY_VERIFY_WITH_TIMEOUT(table->isEnabled() && table->model()->rowCount() > 0, 20000);
    state_->setPinned(std::nullopt);
    QCOMPARE(table->model()->rowCount(), 0);
    QVERIFY(panel_->closedSentence().isEmpty());
  }

  void worker_answersOnlyTheLastQuestion() {
    const auto source = roadmapsFor(situation_, 200);
    panels::AlternativesWorker worker;
    QSignalSpy answered(&worker, &panels::AlternativesWorker::answered);
    const document::TourState first = situation_.plan->at(0.0);
    const document::TourState last = situation_.plan->at(0.5 * situation_.plan->length());
    for (int i = 0; i < 10; ++i) {
      worker.ask({source, first.pose, first.altitude, 3});
    }
    worker.ask({source, last.pose, last.altitude, 3});
    QTRY_COMPARE_WITH_TIMEOUT(answered.count(), 1, 20000);
    const auto got = answered.at(0).at(0).value<std::vector<landing::SiteAnswer>>();
    const auto expected = source->alternatives(last.pose, last.altitude, 3, Job{});
    QCOMPARE(got.size(), expected->size());
    QCOMPARE(got.front().altitude, expected->front().altitude);
  }

  void closing_whileRoadmapsGrow_doesNotWaitForThem() {
    panel_->setSituation(situation_);
    auto endless = roadmapsFor(situation_, 1'000'000'000);
    std::weak_ptr<landing::SiteRoadmaps> watch = endless;
    panel_->setAlternativesSource(std::move(endless));
    state_->setPinned(100.0);
    // the last reference beside the panel's is the running question's
    QTRY_VERIFY_WITH_TIMEOUT(watch.use_count() > 1, 10000);
    panel_.reset();  // would never return if it waited for a roadmap of a thousand million glides
    QVERIFY(watch.expired());
  }

  void slider_buttonsAndWorstPoint_moveThePin() {
    panel_->setSituation(situation_);
    auto* slider = panel_->findChild<QSlider*>(QStringLiteral("tourSlider"));
    slider->setValue(slider->maximum() / 2);
    QVERIFY(state_->pinned() && std::abs(*state_->pinned() - 0.5 * situation_.plan->length()) < 20.0);
    panel_->findChild<QToolButton*>(QStringLiteral("worstPoint"))->click();
    QCOMPARE(*state_->pinned(), situation_.plan->leastGlideMargin().state.distance);
    state_->setPinned(situation_.plan->distanceOf(5));
    QTest::mouseClick(panel_->findChild<QToolButton*>(QStringLiteral("nextPoint")), Qt::LeftButton);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(6));
    QTest::mouseClick(panel_->findChild<QToolButton*>(QStringLiteral("previousPoint")), Qt::LeftButton);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(5));
    // the slider shows where the pin is
    state_->setPinned(0.25 * situation_.plan->length());
    QVERIFY(std::abs(slider->value() - slider->maximum() / 4) <= 1);
  }

  void play_movesThePin_untilStopped() {
    panel_->setSituation(situation_);
    auto* play = panel_->findChild<QToolButton*>(QStringLiteral("play"));
    state_->setPinned(100.0);
    play->click();
    QTRY_VERIFY(*state_->pinned() > 130.0);
    play->click();
    QVERIFY(!play->isChecked());
    QVERIFY(!panel_->findChild<QTimer*>(QStringLiteral("playTimer"))->isActive());
  }

  void glideBelowItsNeeds_isNamedAsViolation() {
    const std::size_t point = situation_.plan->plan().tour.size() / 2;
    const document::Situation low =
        test::withChangedPlan(situation_, [&](mission::Plan& plan) { plan.tour[point].altitude = plan.tour[point].safeAltitude - 100.0; });
    panel_->setSituation(low);
    state_->setPinned(low.plan->distanceOf(point));
    QVERIFY(shows(*panel_, QStringLiteral("⚠ ") + state_->units().margin(-100.0)));
  }
};

QTEST_MAIN(TestEngineOut)
#include "tst_engine_out.moc"
