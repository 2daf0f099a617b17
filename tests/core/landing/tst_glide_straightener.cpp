// Glides with fewer turns: they need no more height, by the checker's own integration too, and what rolling costs is charged no less than it asks for.
#include "core/aircraft/roll_loss.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/glide_straightener.h"
#include "core/landing/lattice_roadmap.h"
#include "core/landing/rrt_star.h"
#include "core/safety/cell_walk.h"
#include "core/safety/roll_cost.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <memory>
#include <random>

using namespace vp;
using namespace vp::landing;
using flight::Piece;
using flight::Turn;

namespace {

constexpr unsigned kSeed = 1130;
constexpr double kRollRate = 15.0;
constexpr double kRounding = 1e-6;  // m

class Random {
public:
  double between(double low, double high) { return low + (high - low) * std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(engine_); }
  geo::Pose pose() { return {between(-2000.0, 2000.0), between(-2000.0, 2000.0), between(0.0, 2.0 * Angle::kPi)}; }
  Piece piece(const std::vector<double>& radii, double longest) {
    const auto turn = static_cast<Turn>(below(3) - 1);
    return {turn, turn == Turn::Straight ? 0.0 : radii[static_cast<std::size_t>(below(static_cast<int>(radii.size())))], between(0.1, longest)};
  }

private:
  std::mt19937_64 engine_{kSeed};
};

aircraft::AircraftProfile rolling() {
  aircraft::AircraftProfile profile = test::paperCessna();
  profile.rollRate_dps = kRollRate;
  return profile;
}

std::unique_ptr<Roadmap> roadmapOf(const World& world, const QString& kind) {
  const geo::Box area = world.terrain.grid().extent();
  if (kind == "lattice") {
    return std::make_unique<LatticeRoadmap>(*buildLatticeRoadmap(world, {area, std::nullopt}, Job{}));
  }
  return std::make_unique<TreeRoadmap>(*buildRrtStarRoadmap(world, {area, 800, {}, 1, {}}, Job{}));
}

/// Changes of bank of a glide.
int changes(const std::vector<Piece>& pieces) {
  int count = 0;
  Piece before;
  for (const Piece& piece : pieces) {
    count += piece.turn != before.turn || (piece.turn != Turn::Straight && piece.radius != before.radius) ? 1 : 0;
    before = piece;
  }
  return count;
}

struct Flown {
  double lowest = 0.0;       ///< m MSL, start that keeps the clearance and arrives
  double afterLosing = 0.0;  ///< m MSL, start that is above the ground in spite of rolling
  geo::Pose end;
};

/// The whole glide by the checker.
Flown flown(const World& world, const aircraft::AircraftProfile& profile, const geo::Pose& from, const Piece& tour,
            const GlideStraightener::Proof& proof, int site) {
  const safety::PlanConditions conditions = safety::conditionsOf(profile, {});
  safety::GlideRates rates(conditions, profile);
  const safety::RollCost cost(conditions, profile, rates);
  safety::CellWalk walk(world.terrain.grid());
  const mission::LandingSite& runway = world.sites[static_cast<std::size_t>(site)].site;
  safety::GlideQuery query{from, {}, world.clearance, runway.elevation.metres() + world.arrivalMargin, {}, cost.along(tour, proof.pieces)};
  const safety::GlideExamination glide = safety::examineGlide(query, {proof.pieces, {}, {}}, rates, walk, Job());
  return {glide.lowestStart() + world.reactionLoss, glide.rollingStart + world.reactionLoss, glide.end};
}

}  // namespace

class TestGlideStraightener : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  /// Two derivations of one bound: what is charged is at least what is asked for, from piece to piece and from the tour.
  void rolling_isNeverChargedLessThanTheCheckerAsks_data() {
    QTest::addColumn<double>("wind");
    QTest::addColumn<double>("tourSpeed");
    QTest::addColumn<double>("aloft");
    QTest::newRow("still air") << 0.0 << 0.0 << 0.0;
    QTest::newRow("wind") << 12.0 << 0.0 << 0.0;
    QTest::newRow("fast tour in wind") << 9.0 << 55.0 << 0.0;
    QTest::newRow("wind that grows with height") << 3.0 << 0.0 << 14.0;
  }
  void rolling_isNeverChargedLessThanTheCheckerAsks() {
    QFETCH(double, wind);
    QFETCH(double, tourSpeed);
    QFETCH(double, aloft);
    World world = test::mountainWorld();
    mission::Mission mission;
    mission.aircraft = rolling();
    if (wind > 0.0) {
      mission.wind = {{geo::HeightMsl(), {270.0, 30.0, 0.0, wind}}};
    }
    if (aloft > 0.0) {
      mission.wind.push_back({geo::HeightMsl::fromMetres(600.0), {300.0, 20.0, 0.0, aloft}});
    }
    if (tourSpeed > 0.0) {
      mission.aircraft.powerSettings = {{"fast", Speed::fromSi(tourSpeed), 30.0, aircraft::PowerSetting::Unit::Litres}};
      mission.powerSetting = "fast";
    }
    world = worldOf(mission, world.sites, world.terrain);
    const GlideNeeds needs(world);
    mission::Plan plan;
    plan.mission = mission;
    plan.sites = world.sites;
    const safety::PlanConditions conditions = safety::conditionsOf(plan);
    const safety::GlideRates rates(conditions, mission.aircraft);
    const safety::RollCost cost(conditions, mission.aircraft, rates);
    std::vector<double> radii = world.glide.glideRadii();
    radii.push_back(world.glide.tourRadius());
    Random random;
    double nearest = 1e9;
    for (int i = 0; i < 20'000; ++i) {
      const Piece tour = random.piece(radii, 300.0);
      std::vector<Piece> pieces;
      for (int count = 1 + random.below(8); count > 0; --count) {
        pieces.push_back(random.piece(radii, 300.0));
      }
      const std::vector<double> charged = needs.rollingAlong(tour, pieces);
      const std::vector<double> asked = cost.along(tour, pieces);
      QCOMPARE(charged.size(), asked.size());
      for (std::size_t k = 0; k < asked.size(); ++k) {
        QString flown = QString("%1/%2/%3").arg(static_cast<int>(tour.turn)).arg(tour.radius).arg(tour.length);
        for (const Piece& piece : pieces) {
          flown += QString(" %1/%2/%3").arg(static_cast<int>(piece.turn)).arg(piece.radius).arg(piece.length);
        }
        QVERIFY2(charged[k] >= asked[k] - 1e-9,
                 qPrintable(QString("%1 charged, %2 asked for up to piece %3 of %4").arg(charged[k]).arg(asked[k]).arg(k).arg(flown)));
        nearest = asked[k] > 0.0 ? std::min(nearest, charged[k] / asked[k]) : nearest;
      }
    }
    qInfo() << "nearest" << nearest;
    QVERIFY(nearest < (aloft > 0.0 ? 1.5 : 1.1));  // not just any large number
  }

  void glides_withFewerTurns_needNoMore_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<double>("reaction");
    QTest::addColumn<bool>("rolls");
    QTest::newRow("lattice") << "lattice" << 0.0 << false;
    QTest::newRow("lattice, rolling counted") << "lattice" << 0.0 << true;
    QTest::newRow("lattice, late pilot") << "lattice" << 150.0 << true;
    QTest::newRow("RRT*, rolling counted") << "tree" << 0.0 << true;
  }
  void glides_withFewerTurns_needNoMore() {
    QFETCH(QString, kind);
    QFETCH(double, reaction);
    QFETCH(bool, rolls);
    World world = test::mountainWorld();
    world.reactionLength = reaction;
    world.reactionLoss = reaction > 0.0 ? 20.0 : 0.0;
    const aircraft::AircraftProfile profile = rolling();
    if (rolls) {
      world.rollRate_dps = kRollRate;
    }
    const std::unique_ptr<Roadmap> roadmap = roadmapOf(world, kind);
    const GlideStraightener straightener(world);
    Random random;
    QueryScratch scratch;
    long before = 0;
    long after = 0;
    int higher = 0;
    int count = 0;
    for (int i = 0; i < 3000; ++i) {
      const geo::Pose pose = random.pose();
      const auto answer = roadmap->query(world, pose, scratch);
      if (!answer) {
        continue;
      }
      ++count;
      const Piece tour{static_cast<Turn>(random.below(3) - 1), world.glide.tourRadius(), 50.0};
      const GlideStraightener::Proof given{roadmap->witnessPieces(*answer), answer->altitude};
      const double atHand = answer->altitude + (random.below(2) == 0 ? 0.0 : random.between(0.0, 300.0));
      const GlideStraightener::Proof proof = straightener.improved(pose, tour, given, answer->site, atHand);
      const Flown glide = flown(world, profile, pose, tour, proof, answer->site);
      QVERIFY2(glide.lowest <= proof.safeAltitude + kRounding, qPrintable(QString("%1 needed").arg(glide.lowest - proof.safeAltitude)));
      QVERIFY(proof.safeAltitude >= answer->altitude);
      QVERIFY(geo::distance(glide.end.point(), world.sites[static_cast<std::size_t>(answer->site)].pose.point()) < 1e-3);
      QVERIFY(std::abs(wrapPi(glide.end.heading - world.sites[static_cast<std::size_t>(answer->site)].pose.heading)) < 1e-6);
      QVERIFY(reaction == 0.0 || (proof.pieces.front().turn == Turn::Straight && proof.pieces.front().length >= reaction - 1e-6));
      if (rolls) {
        QVERIFY2(glide.afterLosing <= proof.safeAltitude + kRounding, qPrintable(QString("%1 too low").arg(glide.afterLosing - proof.safeAltitude)));
        higher += proof.safeAltitude > answer->altitude + 1.0 ? 1 : 0;
        if (proof.safeAltitude > atHand + 1.0) {  // it had to be: the glide as it was asks for more than was there too
          QVERIFY(flown(world, profile, pose, tour, given, answer->site).afterLosing > answer->altitude);
        }
      } else {
        QCOMPARE(proof.safeAltitude, answer->altitude);
      }
      before += changes(given.pieces);
      after += changes(proof.pieces);
    }
    qInfo() << count << "glides, changes of bank" << static_cast<double>(before) / count << "before," << static_cast<double>(after) / count
            << "after;" << higher << "higher";
    QVERIFY(count > 1000);
    QVERIFY(after < before);
    if (kind == "lattice") {
      QVERIFY(static_cast<double>(after) < 0.75 * static_cast<double>(before));
    }
  }

  /// Over flat ground a glide that was made to weave becomes the one Dubins path that it is.
  void weaving_overFlatGround_becomesOneGlide() {
    World world = test::mountainWorld();
    world.terrain = terrain::TerrainPyramid(test::makeGrid(20'000.0, 20.0, [](double, double) { return 0.0; }));
    world.sites = {test::site("A/09", 6000.0, 0.0, 0.0, 0.0)};
    const double radius = world.glide.glideRadii().front();
    std::vector<Piece> weaving;
    for (int i = 0; i < 10; ++i) {  // each pair of turns there and back
      for (const Turn turn : {Turn::Left, Turn::Right, Turn::Right, Turn::Left}) {
        weaving.push_back({turn, radius, 0.3 * radius});
      }
      weaving.push_back({Turn::Straight, 0.0, 100.0});
    }
    geo::Pose start{0.0, 0.0, 0.0};
    geo::Pose end = start;
    for (const Piece& piece : weaving) {
      end = flight::endOf(end, piece);
    }
    start.x = 6000.0 - end.x;
    start.y = -end.y;
    const GlideNeeds needs(world);
    const auto parts = needs.partsOf(weaving, 0);
    QVERIFY(parts.has_value());
    const double needed = needs.of(start, *parts, {}).altitude;
    const auto proof = GlideStraightener(world).improved(start, {}, {weaving, needed}, 0, needed);
    QCOMPARE(proof.pieces.size(), std::size_t{1});
    QVERIFY(proof.pieces.front().turn == Turn::Straight);
    QVERIFY(std::abs(proof.pieces.front().length - end.x) < 1e-6);
    QCOMPARE(proof.safeAltitude, needed);
  }

  /// What is no glide of the world stays as it is: a radius that nobody flies, a glide shorter than its approach.
  void strangeGlides_stayAsTheyAre() {
    World world = test::mountainWorld();
    const std::vector<Piece> strange{{Turn::Left, 77.0, 50.0}, {Turn::Straight, 0.0, 400.0}};
    const auto proof = GlideStraightener(world).improved({0.0, 0.0, 0.0}, {}, {strange, 900.0}, 0, 950.0);
    QCOMPARE(proof.pieces, strange);
    world.approach.kind = mission::ApproachKind::Straight;
    QVERIFY(!GlideNeeds(world).partsOf({{Turn::Straight, 0.0, 400.0}}, 0).has_value());
    QVERIFY(!GlideNeeds(world).partsOf({{Turn::Straight, 0.0, 4000.0}}, 99).has_value());
  }
};

QTEST_GUILESS_MAIN(TestGlideStraightener)
#include "tst_glide_straightener.moc"
