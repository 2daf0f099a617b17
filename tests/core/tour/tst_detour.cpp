// Ways around unknown ground: found, used by the planner, and certified.
#include "core/tour/detour.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;
using namespace vp::tour;

namespace {

/// Flat ground with a wall of unknown ground from south to north that leaves a gap of 1 km in the north.
landing::World worldWithVoid(float inTheWall) {
  landing::World world = test::mountainWorld();
  std::vector<float> values(250 * 250, 0.0F);
  for (int j = 0; j < 200; ++j) {
    for (int i = 120; i < 130; ++i) {
      values[static_cast<std::size_t>(j * 250 + i)] = inTheWall;
    }
  }
  world.terrain = terrain::TerrainPyramid(std::make_shared<const terrain::ElevationGrid>(-2500.0, -2500.0, 20.0, 250, 250, std::move(values)));
  return world;
}

const std::vector<geo::Point> kTargets{{-1500.0, -1000.0}, {1500.0, -1000.0}, {-1500.0, 500.0}};

}  // namespace

class TestDetour : public QObject {
  Q_OBJECT

private slots:
  void pair_underAVoidBetween_goesThroughTheGap() {
    const landing::World world = worldWithVoid(terrain::kUnknownUpper);
    const auto detours = Detours::find(world, kTargets, 1e9, Job{});
    QVERIFY(detours.has_value());
    const std::vector<geo::Pose>& way = detours->between(0, 1);
    QVERIFY(!way.empty() && way.size() <= 6);
    bool north = false;
    for (const geo::Pose& pose : way) {
      QVERIFY(world.terrain.grid().isKnownAt(pose.point()));
      north = north || pose.y > 1500.0;
    }
    QVERIFY(north);
    // the way back passes the same places the other way round
    const std::vector<geo::Pose>& back = detours->between(1, 0);
    QCOMPARE(back.size(), way.size());
    for (std::size_t i = 0; i < way.size(); ++i) {
      const geo::Pose& there = way[way.size() - 1 - i];
      QVERIFY(geo::distance(there.point(), back[i].point()) < 1e-9);
      QVERIFY(std::abs(std::abs(wrapPi(there.heading - back[i].heading)) - Angle::kPi) < 1e-9);
    }
    QVERIFY(detours->between(0, 2).empty());  // both on one side
  }

  void highWall_isBarredOnlyUnderTheCeiling() {
    const landing::World world = worldWithVoid(800.0F);
    QVERIFY(Detours::find(world, kTargets, 1e9, Job{})->between(0, 1).empty());
    QVERIFY(!Detours::find(world, kTargets, 850.0, Job{})->between(0, 1).empty());
  }

  void cancel_stops() {
    std::stop_source stop;
    stop.request_stop();
    const auto result = Detours::find(worldWithVoid(terrain::kUnknownUpper), kTargets, 1e9, Job(stop.get_token()));
    QVERIFY(!result && result.error().code == Errc::Cancelled);
  }

  void forbiddenAirspace_isGoneAroundUnlessThereIsRoomBelow() {
    const landing::World world = worldWithVoid(0.0F);
    const geo::LocalFrame frame({47.0, 11.0});
    const auto wall = [&](double floor) {
      mission::Airspace airspace{"WALL", "R", {mission::AirspaceLimit::Kind::Msl, floor}, {mission::AirspaceLimit::Kind::Unlimited, 0.0}, {}};
      for (const geo::Point& corner : {geo::Point{-100.0, -3000.0}, {100.0, -3000.0}, {100.0, 1500.0}, {-100.0, 1500.0}}) {
        airspace.outline.push_back(frame.toLatLon(corner));
      }
      return ForbiddenAirspace({airspace}, {{}, {}, mission::AirspaceUse::Forbid}, frame);
    };
    auto detours = Detours::find(world, kTargets, 3000.0, Job{});
    QVERIFY(detours && !detours->hasAny(0, 1));
    QVERIFY(detours->findAround(wall(2500.0), {}, world, kTargets, 3000.0, Job{}));
    QVERIFY(!detours->hasAny(0, 1));
    QVERIFY(detours->findAround(wall(150.0), {}, world, kTargets, 3000.0, Job{}));
    QVERIFY(detours->between(0, 1).empty());
    const std::vector<geo::Pose>& way = detours->aroundAirspace(0, 1);
    QVERIFY(!way.empty() && way.size() <= 6);
    QVERIFY(std::any_of(way.begin(), way.end(), [](const geo::Pose& pose) { return pose.y > 1500.0; }));
    QVERIFY(detours->aroundAirspace(0, 2).empty());  // both on one side

    std::stop_source stop;
    stop.request_stop();
    const Result<void> stopped = detours->findAround(wall(150.0), {}, world, kTargets, 3000.0, Job(stop.get_token()));
    QVERIFY(!stopped && stopped.error().code == Errc::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestDetour)
#include "tst_detour.moc"
