// What the planner is doing, as snapshots for drawing, and that watching changes no plan.
#include "core/formats/plan_file.h"
#include "core/landing/rrt_star.h"
#include "tests/support/quick_plan.h"
#include "ui/jobs/sketch_builder.h"

#include <QElapsedTimer>
#include <QTest>

using namespace vp;
using document::PlanningSketch;
using jobs::SketchBuilder;
using Sketches = std::vector<std::shared_ptr<const PlanningSketch>>;

class TestSketchBuilder : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    const formats::LoadedMission loaded = *formats::loadMission(test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm"), "", Job{});
    input_ = {loaded.mission, loaded.frame, loaded.terrain, loaded.terrainFiles, loaded.sites, loaded.targets, "test", "LKH", 1};
  }

  void planning_isSeenGrowing() {
    Sketches seen;
    QElapsedTimer clock;
    clock.start();
    const mission::Plan plan = watched(seen);
    QVERIFY(seen.size() >= 2 && static_cast<qint64>(seen.size()) <= 4 + 2 * clock.elapsed() / 100);
    QVERIFY(seen.front()->roadmap && !seen.front()->roadmap->empty() && !seen.front()->tour);
    for (const auto& sketch : seen) {
      QVERIFY(!sketch->stage.empty());
      if (sketch->tour) {
        QCOMPARE(sketch->tour->size(), std::size_t(5));
        QVERIFY(sketch->round >= 1 && *sketch->bestCost > 1000.0);
        QVERIFY(sketch->roadmap == seen.front()->roadmap || sketch->roadmap);  // stays beside the tour
      }
    }
    QVERIFY(seen.back()->tour != nullptr);
    QVERIFY(plan.metrics.tourSolutions >= seen.back()->round);
  }

  void legs_joinTheTargets() {
    Sketches seen;
    watched(seen);
    const std::vector<PlanningSketch::Leg>& legs = *seen.back()->tour;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      QVERIFY(geo::distance(legs[i].path.back(), legs[(i + 1) % legs.size()].path.front()) < 0.01);
      const bool atATarget = std::any_of(input_.targets.begin(), input_.targets.end(), [&](const mission::TargetInFrame& target) {
        return geo::distance(target.point, legs[i].path.front()) < 0.01;
      });
      QVERIFY(atATarget);
    }
  }

  void roadmap_isThinnedForTheScreen() {
    Sketches seen;
    input_.mission.planner.roadmap = mission::RoadmapKind::RrtStar;
    input_.mission.planner.roadmapSamples = 9000;
    SketchBuilder builder(200.0, [&seen](const auto& sketch) { seen.push_back(sketch); });
    landing::RrtStarOptions options;
    options.area = tour::roadmapArea(input_);
    options.samples = 9000;
    std::size_t most = 0;
    options.grew = [&](const landing::Roadmap& roadmap) {
      builder.observer().roadmapGrew(roadmap);
      most = std::max(most, roadmap.size());
    };
    QVERIFY(landing::buildRrtStarRoadmap(tour::makeWorld(input_), options, Job{}));
    input_.mission.planner.roadmap = mission::RoadmapKind::RrtStar;
    input_.mission.planner.roadmapSamples = 800;
    QVERIFY(most > 4000);
    for (const auto& sketch : seen) {
      QVERIFY(sketch->roadmap->size() <= 4000);
    }
  }

  void watching_changesNothing() {
    Sketches seen;
    const mission::Plan alone = *tour::planTour(input_, Job{});
    QCOMPARE(formats::planToJson(watched(seen)), formats::planToJson(alone));
  }

private:
  mission::Plan watched(Sketches& seen) {
    SketchBuilder builder(aircraft::GlideModel(input_.mission.aircraft).tourRadius(), [&seen](const auto& sketch) { seen.push_back(sketch); });
    return *tour::planTour(input_, Job{}, nullptr, builder.observer());
  }

  tour::PlanInput input_;
};

QTEST_APPLESS_MAIN(TestSketchBuilder)
#include "tst_sketch_builder.moc"
