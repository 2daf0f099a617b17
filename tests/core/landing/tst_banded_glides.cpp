// Glides whose losses differ by altitude: flown in winds of each height, and held against those by the winds of all heights at once.
#include "core/aircraft/glide_bands.h"
#include "core/landing/altitude_floor.h"
#include "core/landing/lattice_roadmap.h"
#include "core/landing/rrt_star.h"
#include "tests/support/band_flight.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <memory>
#include <random>

using namespace vp;

namespace {

constexpr double kHalf = 2300.0;

air::WindLayer layer(double altitude, double from, double spread, double least, double most) {
  return {geo::HeightMsl::fromMetres(altitude), {from, spread, least * test::kKnot, most * test::kKnot}};
}

/// 5 kt at 0 m, 15 kt at 1000 m, 30 kt at 2000 m.
std::vector<air::WindLayer> threeLayers() {
  return {layer(0.0, 270.0, 0.0, 5.0, 5.0), layer(1000.0, 270.0, 0.0, 15.0, 15.0), layer(2000.0, 270.0, 0.0, 30.0, 30.0)};
}

landing::World worldIn(const aircraft::GlideConditions& conditions) {
  landing::World world = test::mountainWorld();
  world.glide = aircraft::GlideModel(test::paperCessna(), conditions);
  return world;
}

/// The same world with the radii of another one, and losses that hold at all altitudes at once or in one band alone.
landing::World with(landing::World world, const aircraft::GlideModel& glide) {
  world.glide = glide;
  return world;
}

landing::LatticeRoadmap latticeOf(const landing::World& world) {
  return *landing::buildLatticeRoadmap(world, {world.terrain.grid().extent(), 100.0}, Job{});
}

landing::TreeRoadmap treeOf(const landing::World& world) {
  landing::RrtStarOptions options;
  options.area = world.terrain.grid().extent();
  options.samples = 400;
  return *landing::buildRrtStarRoadmap(world, options, Job{});
}

geo::Pose poseOf(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double x = kHalf * (2.0 * unit(random) - 1.0);
  const double y = kHalf * (2.0 * unit(random) - 1.0);
  return {x, y, 2.0 * Angle::kPi * unit(random)};
}

/// Glides of random poses, half of them against winds that cost most at each height, half on days of it.
void flyAll(const landing::World& world, const aircraft::GlideConditions& conditions, const landing::Roadmap& roadmap, int glides) {
  std::mt19937_64 random(11);
  landing::QueryScratch scratch;
  const test::WorstWinds worst(conditions.winds);
  const aircraft::GlidePolar polar = test::polarOf(test::paperCessna());
  int crossed = 0;
  int flown = 0;
  for (int i = 0; flown < glides; ++i) {
    QVERIFY(i < 3 * glides);
    const geo::Pose from = poseOf(random);
    const std::optional<landing::SafeAltitude> answer = roadmap.query(world, from, scratch);
    if (!answer) {
      continue;
    }
    ++flown;
    const std::vector<flight::Piece> pieces = roadmap.witnessPieces(*answer);
    const test::DayWinds day = test::dayWinds(conditions.winds, random);
    const bool isWorst = i % 2 == 0;
    const auto lossAt = [&](double z, double course, double radius) {
      const auto onDay = [&](double side) { return test::lossInWind(polar, day.at(z), day.changeAt(z), course, side, radius); };
      return isWorst ? worst.lossAt(z, polar, course, radius) : std::max(onDay(-1.0), onDay(1.0));
    };
    const auto edgeBelow = [&](double z) { return worst.edgeBelow(z); };
    const double begin = answer->altitude - world.reactionLoss;
    const test::Outcome outcome = test::flyByAltitude(from, begin, pieces, world.terrain.grid(), world.clearance, lossAt, edgeBelow);
    const mission::SiteInFrame& site = world.sites[static_cast<std::size_t>(answer->site)];
    const double arrival = outcome.endAltitude - site.site.elevation.metres() - world.arrivalMargin;
    QVERIFY2(outcome.leastSpare > -1e-3 && arrival > -1e-3,
             qPrintable(QString("glide %1 from %2: spare %3, arrival %4").arg(i).arg(begin).arg(outcome.leastSpare).arg(arrival)));
    QVERIFY(geo::distance(outcome.end.point(), site.pose.point()) < 0.1);
    crossed += worst.edgeBelow(begin) > outcome.endAltitude ? 1 : 0;
  }
  QVERIFY2(crossed > flown / 20, qPrintable(QString("only %1 of %2 come through a layer").arg(crossed).arg(flown)));
}

double meanOf(const landing::World& world, const landing::Roadmap& roadmap, std::vector<double>* all = nullptr) {
  std::mt19937_64 random(5);
  landing::QueryScratch scratch;
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::optional<landing::SafeAltitude> answer = roadmap.query(world, poseOf(random), scratch);
    if (all != nullptr) {
      all->push_back(answer ? answer->altitude : std::numeric_limits<double>::infinity());
    }
    sum += answer ? answer->altitude : 0.0;
    count += answer ? 1 : 0;
  }
  return sum / count;
}

}  // namespace

class TestBandedGlides : public QObject {
  Q_OBJECT

private slots:
  void tenThousandGlides_inWindsOfEachHeight_arriveAndClear() {
    // layers where the glides are, the strongest in the middle, so that both edges are crossed into more wind and into less
    const aircraft::GlideConditions conditions{
        .winds = {layer(250.0, 200.0, 20.0, 2.0, 8.0), layer(450.0, 270.0, 10.0, 15.0, 22.0), layer(700.0, 320.0, 0.0, 6.0, 6.0)}};
    const landing::World world = worldIn(conditions);
    flyAll(world, conditions, latticeOf(world), 8000);
    flyAll(world, conditions, treeOf(world), 2000);
  }

  void reactionAndApproach_inWindsOfEachHeight_arriveAndClear_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("straight") << static_cast<int>(mission::ApproachKind::Straight);
    QTest::newRow("overhead") << static_cast<int>(mission::ApproachKind::Overhead);
  }
  void reactionAndApproach_inWindsOfEachHeight_arriveAndClear() {
    QFETCH(int, kind);
    const aircraft::GlideConditions conditions{
        .winds = {layer(60.0, 200.0, 20.0, 10.0, 15.0), layer(160.0, 270.0, 10.0, 2.0, 5.0), layer(500.0, 320.0, 0.0, 20.0, 20.0)}};
    landing::World world = worldIn(conditions);
    world.reactionLength = 200.0;
    world.reactionLoss = 20.0;
    world.approach.kind = static_cast<mission::ApproachKind>(kind);
    world.approach.finalLength = Length::fromSi(400.0);
    // the glides of these tests keep the clearance down to the ground, so the runways lie on pads
    const landing::LatticeRoadmap roadmap = latticeOf(world);
    flyAll(world, conditions, roadmap, 1000);
  }

  void oneLayer_isTheWindOfAllAltitudes() {
    const aircraft::GlideModel one(test::paperCessna(), {.winds = {layer(700.0, 270.0, 10.0, 5.0, 15.0)}});
    QVERIFY(one.bands() == nullptr);
    QVERIFY(aircraft::GlideModel(test::paperCessna()).bands() == nullptr);
    QVERIFY(aircraft::GlideModel(test::paperCessna(), {.winds = threeLayers()}).bands() != nullptr);
  }

  /// All altitudes at once: never lower; the lowest band alone: with no more wind above it, never higher.
  void safeAltitudes_lieBetweenThoseOfTheLowestBandAndOfAllAtOnce() {
    const landing::World banded = worldIn({.winds = threeLayers()});
    const aircraft::GlideBands& bands = *banded.glide.bands();
    const landing::World all = with(banded, banded.glide.everywhere());
    const landing::World lowest = with(banded, bands.between(1, 1).everywhere());  // all ground lies above the layer at 0 m
    std::vector<double> byBands;
    std::vector<double> byAll;
    std::vector<double> byLowest;
    const double mean = meanOf(banded, latticeOf(banded), &byBands);
    const double meanOfAll = meanOf(all, latticeOf(all), &byAll);
    const double meanOfLowest = meanOf(lowest, latticeOf(lowest), &byLowest);
    qInfo("mean safe altitude: %.2f m by bands, %.2f m by the winds of all layers, %.2f m by those of the lowest band", mean, meanOfAll,
          meanOfLowest);
    QVERIFY(mean < meanOfAll - 5.0);
    QVERIFY(mean >= meanOfLowest - 0.1);
    int higher = 0;
    int lower = 0;
    for (std::size_t i = 0; i < byBands.size(); ++i) {
      // each search takes what is good enough, so single answers may differ by what it calls worthwhile
      higher += byBands[i] > byAll[i] + 5.0 ? 1 : 0;
      lower += byBands[i] < byLowest[i] - 5.0 ? 1 : 0;
    }
    QVERIFY2(higher <= 10 && lower <= 10, qPrintable(QString("%1 higher than by all, %2 lower than by the lowest").arg(higher).arg(lower)));
  }

  void floor_isBelowAllAnswers() {
    for (const aircraft::GlideConditions& conditions :
         {aircraft::GlideConditions{.winds = threeLayers()},
          aircraft::GlideConditions{.winds = {layer(300.0, 90.0, 30.0, 15.0, 20.0), layer(600.0, 0.0, 0.0, 0.0, 0.0)}}}) {
      const landing::World world = worldIn(conditions);
      const landing::AltitudeFloor floor = *landing::AltitudeFloor::build(world, {}, Job{});
      const landing::LatticeRoadmap lattice = latticeOf(world);
      const landing::TreeRoadmap tree = treeOf(world);
      std::mt19937_64 random(3);
      landing::QueryScratch scratch;
      for (int i = 0; i < 3000; ++i) {
        const geo::Pose pose = poseOf(random);
        for (const landing::Roadmap* roadmap : {static_cast<const landing::Roadmap*>(&lattice), static_cast<const landing::Roadmap*>(&tree)}) {
          const std::optional<landing::SafeAltitude> answer = roadmap->query(world, pose, scratch);
          QVERIFY(!answer || floor.at(pose.point()) <= answer->altitude);
        }
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestBandedGlides)
#include "tst_banded_glides.moc"
