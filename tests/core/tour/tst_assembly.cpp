// Joining segments into a closed loop keeps every promise that the segments made.
#include "core/base/quantity.h"
#include "core/landing/rrt_star.h"
#include "core/tour/assembly.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

using namespace vp;
using namespace vp::tour;

class TestAssembly : public QObject {
  Q_OBJECT

private slots:
  // Found on Alpine terrain by the checker: two segments ask for the safe altitude of the target between them, each
  // with another hint, so the answers may differ by decimetres; the loop took the one, the leg before had paid for the other.
  void randomLoops_underTheirGlides_reachEveryNextPoint() {
    constexpr unsigned seed = 4;
    qInfo("seed %u", seed);
    const landing::World world = test::mountainWorld();
    landing::RrtStarOptions options;
    options.area = world.terrain.grid().extent();
    options.samples = 1500;
    const landing::TreeRoadmap roadmap = *landing::buildRrtStarRoadmap(world, options, Job{});
    const Detours detours;
    SegmentSettings settings;
    settings.step = 150.0;
    settings.pitch = {std::tan(0.52), std::tan(0.35)};
    SegmentBuilder builder(world, roadmap, detours, settings);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> place(-2200.0, 2200.0);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    int joins = 0;
    int different = 0;
    for (int i = 0; i < 400; ++i) {
      std::vector<VisitPose> visits;
      for (int t = 0; t < 3; ++t) {
        const geo::Pose pose{place(engine), place(engine), heading(engine)};
        visits.push_back({t, pose, world.terrain.grid().upperAt(pose.point()) + 100.0});
      }
      std::array<double, 3> promised{};  // by the leg that ends at each target
      for (int t = 0; t < 3; ++t) {
        const auto before = builder.safePoints(visits[static_cast<std::size_t>(t)], visits[static_cast<std::size_t>((t + 1) % 3)]);
        const auto after = builder.safePoints(visits[static_cast<std::size_t>((t + 1) % 3)], visits[static_cast<std::size_t>((t + 2) % 3)]);
        promised[static_cast<std::size_t>((t + 1) % 3)] = before.back().safeAltitude;
        ++joins;
        different += after.front().safeAltitude > before.back().safeAltitude + 1e-6 ? 1 : 0;
      }
      mission::Plan plan;
      QVERIFY(assembleTour(world, builder, visits, settings, mission::LowTargets::PassAbove, plan, Job{}));
      for (std::size_t j = 0; j < plan.tour.size(); ++j) {
        const mission::DecisionPoint& point = plan.tour[j];
        const mission::DecisionPoint& next = plan.tour[(j + 1) % plan.tour.size()];
        const double left = point.altitude - world.glide.lossAt(point.onward.radius) * point.onward.length;
        QVERIFY2(left >= next.safeAltitude - 1e-6, qPrintable(QString("loop %1 point %2: %3 m short").arg(i).arg(j).arg(next.safeAltitude - left)));
        QVERIFY(point.altitude >= point.safeAltitude - 1e-6);
        if (point.target >= 0) {
          QVERIFY(point.safeAltitude <= promised[static_cast<std::size_t>(point.target)] + 1e-9);
        }
      }
    }
    qInfo("%d of %d joins had a higher answer after the target than before it", different, joins);
  }
};

QTEST_APPLESS_MAIN(TestAssembly)
#include "tst_assembly.moc"
