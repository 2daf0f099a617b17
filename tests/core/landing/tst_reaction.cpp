// A pilot who reacts late: glides go straight on first, and what that costs is in every safe altitude.
#include "core/flight/curve_sampling.h"
#include "core/landing/altitude_floor.h"
#include "core/landing/lattice_roadmap.h"
#include "core/landing/rrt_star.h"
#include "core/landing/site_roadmaps.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <memory>
#include <random>

using namespace vp;
using namespace vp::landing;

namespace {

constexpr unsigned kSeed = 515;

struct RandomPoses {
  std::mt19937_64 engine{kSeed};
  geo::Pose operator()() {
    std::uniform_real_distribution<double> place(-2000.0, 2000.0);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    return {place(engine), place(engine), heading(engine)};
  }
};

World lateWorld(double length, double loss) {
  World world = test::mountainWorld();
  world.reactionLength = length;
  world.reactionLoss = loss;
  return world;
}

std::unique_ptr<Roadmap> roadmapOf(const World& world, const QString& kind) {
  const geo::Box area = world.terrain.grid().extent();
  if (kind == "lattice") {
    return std::make_unique<LatticeRoadmap>(*buildLatticeRoadmap(world, {area, std::nullopt}, Job{}));
  }
  return std::make_unique<TreeRoadmap>(*buildRrtStarRoadmap(world, {area, 800, {}, 1, {}}, Job{}));
}

void kinds() {
  QTest::addColumn<QString>("kind");
  QTest::newRow("lattice") << "lattice";
  QTest::newRow("RRT*") << "tree";
}

}  // namespace

class TestReaction : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void mission_givesLengthAndLoss() {
    mission::Mission mission;
    mission.aircraft = test::paperCessna();
    mission.safety.reactionTime = Duration::fromSi(4.0);
    mission.safety.reactionLoss = Length::fromSi(12.0);
    mission.wind = {{geo::HeightMsl(), {270.0, 10.0, 0.0, 7.0}}};
    const World world = worldOf(mission, {}, {});
    QVERIFY(std::abs(world.reactionLength - 4.0 * 40.4) < 1e-9);
    QCOMPARE(world.reactionLoss, 12.0);
    mission.aircraft.powerSettings = {{"fast", Speed::fromSi(60.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
    mission.powerSetting = "fast";
    QVERIFY(std::abs(worldOf(mission, {}, {}).reactionLength - 4.0 * 67.0) < 1e-9);
  }

  void noReaction_changesNothing_data() { kinds(); }
  void noReaction_changesNothing() {
    QFETCH(QString, kind);
    const World world = test::mountainWorld();
    const std::unique_ptr<Roadmap> roadmap = roadmapOf(world, kind);
    RandomPoses poses;
    QueryScratch scratch;
    for (int i = 0; i < 2000; ++i) {
      const geo::Pose pose = poses();
      const auto late = roadmap->query(world, pose, scratch);
      const auto turning = roadmap->queryTurning(world, pose, scratch);
      QCOMPARE(late.has_value(), turning.has_value());
      QVERIFY(!late ||
              (late->altitude == turning->altitude && late->straight == 0.0 && roadmap->witnessPieces(*late) == roadmap->witnessPieces(*turning)));
    }
  }

  /// The checker's own integration of the whole glide, its straight beginning included, and E on top.
  void answers_underTheChecker_holdWithTheStraight_data() { kinds(); }
  void answers_underTheChecker_holdWithTheStraight() {
    QFETCH(QString, kind);
    const World world = lateWorld(170.0, 25.0);
    const std::unique_ptr<Roadmap> roadmap = roadmapOf(world, kind);
    const AltitudeFloor floor = *AltitudeFloor::build(world, {}, Job{});
    RandomPoses poses;
    QueryScratch scratch;
    int answered = 0;
    for (int i = 0; i < 10'000; ++i) {
      const geo::Pose pose = poses();
      const auto answer = roadmap->query(world, pose, scratch);
      if (!answer) {
        continue;
      }
      ++answered;
      const std::vector<flight::Piece> pieces = roadmap->witnessPieces(*answer);
      QVERIFY(pieces.front().turn == flight::Turn::Straight && pieces.front().length >= 170.0);
      QVERIFY(pieces.size() < 2 || pieces[1].turn != flight::Turn::Straight);
      const mission::SiteInFrame& site = world.sites[static_cast<std::size_t>(answer->site)];
      const double checked =
          safety::requiredStartHeight(pose, pieces, site.site.elevation.metres(), world.terrain.grid(), world.clearance, world.glide);
      QVERIFY2(answer->altitude >= checked + 25.0 - 1e-6, qPrintable(QString("case %1: %2 below %3").arg(i).arg(answer->altitude).arg(checked)));
      QVERIFY(floor.at(pose.point()) <= answer->altitude);
      QVERIFY(geo::distance(flight::endOf(flight::Curve{pose, pieces, {}}, 1.0).point(), site.pose.point()) < 1e-3);
    }
    QVERIFY(answered > 8500);
  }

  void glideThatBeginsStraight_isOnePieceWithTheReaction() {
    const World world = lateWorld(100.0, 0.0);
    const TreeRoadmap roadmap(world, 100.0);
    SafeAltitude answer;
    answer.node = roadmap.roots().front();
    answer.site = 0;
    answer.straight = 100.0;
    answer.first = {{}, 80.0, flight::Word::LSL, {0.0, 50.0, 30.0}};
    QVERIFY(roadmap.witnessPieces(answer) == (std::vector<flight::Piece>{{flight::Turn::Straight, 0.0, 150.0}, {flight::Turn::Left, 80.0, 30.0}}));
    answer.first.lengths = {20.0, 50.0, 0.0};
    QVERIFY(
        roadmap.witnessPieces(answer) ==
        (std::vector<flight::Piece>{{flight::Turn::Straight, 0.0, 100.0}, {flight::Turn::Left, 80.0, 20.0}, {flight::Turn::Straight, 0.0, 50.0}}));
  }

  /// What reacting costs lifts the floor, too: by as much, everywhere.
  void floor_isHigherByTheLoss() {
    const World world = test::mountainWorld();
    const AltitudeFloor at = *AltitudeFloor::build(world, {}, Job{});
    const AltitudeFloor late = *AltitudeFloor::build(lateWorld(170.0, 25.0), {}, Job{});
    RandomPoses poses;
    for (int i = 0; i < 1000; ++i) {
      const geo::Pose pose = poses();
      QVERIFY(std::abs(late.at(pose.point()) - at.at(pose.point()) - 25.0) < 0.01);
    }
  }

  void unknownGroundAhead_leavesNoGlide() {
    const World world = lateWorld(170.0, 0.0);
    const std::unique_ptr<Roadmap> roadmap = roadmapOf(world, "lattice");
    QueryScratch scratch;
    QVERIFY(!roadmap->query(world, {2400.0, 0.0, 0.0}, scratch));  // 100 m before the eastern border
    QVERIFY(roadmap->query(world, {2400.0, 0.0, Angle::kPi}, scratch).has_value());
    QVERIFY(std::isinf(beforeReaction(world, {2400.0, 0.0, 0.0}, 500.0)));
  }

  void nextBestRunways_countWithTheReaction() {
    const auto world = std::make_shared<const World>(lateWorld(170.0, 25.0));
    RrtStarOptions options;
    options.area = world->terrain.grid().extent();
    options.samples = 400;
    SiteRoadmaps roadmaps(world, options);
    RandomPoses poses;
    for (int i = 0; i < 100; ++i) {
      const geo::Pose pose = poses();
      const auto answers = roadmaps.alternatives(pose, 2000.0, 3, Job{});
      QVERIFY(answers.has_value());
      for (const SiteAnswer& answer : *answers) {
        const double elevation = world->sites[static_cast<std::size_t>(answer.site)].site.elevation.metres();
        const double checked = safety::requiredStartHeight(pose, answer.pieces, elevation, world->terrain.grid(), world->clearance, world->glide);
        QVERIFY(answer.altitude >= checked + 25.0 - 1e-6);
        QVERIFY(answer.directAltitude >= answer.altitude - 1e-6 || !std::isfinite(answer.directAltitude));
        QVERIFY(answer.pieces.front().turn == flight::Turn::Straight && answer.pieces.front().length >= 170.0);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestReaction)
#include "tst_reaction.moc"
