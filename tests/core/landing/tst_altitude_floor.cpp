// The altitude floor never lies above a safe altitude, by the roadmap's glides and by glides that the checker measures.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/altitude_floor.h"
#include "core/landing/rrt_star.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::landing;

namespace {

constexpr unsigned kSeed = 61;
constexpr geo::Box kDetail{-900.0, -1100.0, 1200.0, 700.0};  // over the mountain

double wallHeight(double x, double y) {
  const bool isWall = std::abs(x + 0.3 * y) < 30.0 && y < 1500.0;
  return isWall ? 700.0 : 20.0 + 0.01 * y;
}

World worldOver(std::shared_ptr<const terrain::ElevationGrid> grid) {
  World world = test::mountainWorld();
  world.terrain = terrain::TerrainPyramid(std::move(grid));
  for (mission::SiteInFrame& site : world.sites) {
    site.site.elevation = geo::HeightMsl::fromMetres(world.terrain.grid().upperAt(site.pose.point()));
  }
  return world;
}

/// The mountain with square holes of unknown ground.
std::shared_ptr<const terrain::ElevationGrid> holedGrid() {
  const auto full = test::makeGrid(5000.0, 20.0, test::mountainHeight);
  std::vector<float> values = full->values();
  for (int row = 0; row < full->rows(); ++row) {
    for (int column = 0; column < full->columns(); ++column) {
      if (column % 60 > 40 && row % 50 > 25 && row % 50 < 48) {
        values[static_cast<std::size_t>(row * full->columns() + column)] = terrain::kUnknownUpper;
      }
    }
  }
  return std::make_shared<const terrain::ElevationGrid>(full->originX(), full->originY(), 20.0, full->columns(), full->rows(), std::move(values));
}

World worldNamed(const QString& name) {
  if (name == "walls") {
    return worldOver(test::makeGrid(5000.0, 20.0, wallHeight));
  }
  if (name == "unknown ground") {
    return worldOver(holedGrid());
  }
  if (name == "rough") {
    return worldOver(test::makeGrid(5000.0, 20.0, [](double x, double y) { return 300.0 + 280.0 * std::sin(x / 90.0) * std::cos(y / 130.0); }));
  }
  if (name == "one site") {
    World world = test::mountainWorld();
    world.sites.resize(1);
    return world;
  }
  return test::mountainWorld();
}

AltitudeFloor floorOf(const World& world, int vertices, std::optional<geo::Box> detail = std::nullopt) {
  AltitudeFloorOptions options;
  options.mostVertices = static_cast<std::size_t>(vertices);
  options.detail = detail;
  return *AltitudeFloor::build(world, options, Job{});
}

TreeRoadmap roadmapOf(const World& world, int samples) {
  RrtStarOptions options;
  options.area = world.terrain.grid().extent();
  options.samples = samples;
  return *buildRrtStarRoadmap(world, options, Job{});
}

struct RandomPose {
  std::mt19937_64 engine{kSeed};
  double half = 2499.0;
  geo::Pose operator()() {
    std::uniform_real_distribution<double> place(-half, half);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    const double x = place(engine);
    const double y = place(engine);
    return {x, y, heading(engine)};
  }
};

/// Squares that keep neither rule of the floor.
int brokenSquares(const World& world, const AltitudeFloor::Grid& grid) {
  constexpr double kRounding = 1e-3;  // of two values in float, in metres
  const double most = world.glide.straightLoss() * grid.spacing;
  int broken = 0;
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      double limit = INFINITY;
      for (double y = grid.originY + j * grid.spacing + 0.5; y < grid.originY + (j + 1) * grid.spacing; y += world.terrain.grid().cellSize()) {
        for (double x = grid.originX + i * grid.spacing + 0.5; x < grid.originX + (i + 1) * grid.spacing; x += world.terrain.grid().cellSize()) {
          limit = std::min(limit, world.terrain.grid().upperAt({x, y}) + world.clearance);
        }
      }
      const double a = grid.value[grid.vertex(i, j)];
      const double b = grid.value[grid.vertex(i + 1, j)];
      const double c = grid.value[grid.vertex(i, j + 1)];
      const double d = grid.value[grid.vertex(i + 1, j + 1)];
      const double x = std::max(std::abs(b - a), std::abs(d - c));
      const double y = std::max(std::abs(c - a), std::abs(d - b));
      const bool keepsLimit = std::max({a, b, c, d}) <= limit + kRounding;
      const bool keepsSlope = std::hypot(x, y) <= most + 2.0 * kRounding;
      broken += keepsLimit || keepsSlope ? 0 : 1;
    }
  }
  return broken;
}

}  // namespace

class TestAltitudeFloor : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void floor_underRandomQueries_isALowerBound_data() { worlds(); }

  void floor_underRandomQueries_isALowerBound() {
    QFETCH(QString, name);
    QFETCH(int, vertices);
    QFETCH(bool, hasDetail);
    const World world = worldNamed(name);
    const AltitudeFloor floor = floorOf(world, vertices, hasDetail ? std::optional(kDetail) : std::nullopt);
    const TreeRoadmap roadmap = roadmapOf(world, 1500);
    QueryScratch scratch;
    RandomPose random;
    double gap = 0.0;
    double gain = 0.0;
    int answered = 0;
    for (int i = 0; i < 1000; ++i) {
      const geo::Pose pose = random();
      const double bound = floor.at(pose.point());
      const std::optional<SafeAltitude> answer = roadmap.query(world, pose, scratch);
      if (!answer) {
        continue;
      }
      QVERIFY2(bound <= answer->altitude, qPrintable(QString("%1 %2: %3 above %4").arg(pose.x).arg(pose.y).arg(bound).arg(answer->altitude)));
      double direct = INFINITY;  // what is known without the floor: the straight glide, and the ground here
      for (const mission::SiteInFrame& site : world.sites) {
        direct = std::min(direct, site.site.elevation.metres() + world.glide.straightLoss() * geo::distance(site.pose.point(), pose.point()));
      }
      const double plain = std::max(world.terrain.grid().upperAt(pose.point()) + world.clearance, direct);
      gap += answer->altitude - std::max(plain, bound);
      gain += std::max(plain, bound) - plain;
      ++answered;
    }
    QVERIFY(answered > 400);
    qInfo("safe altitudes lie %.1f m above the floor, which lies %.1f m above ground and straight glides (means)", gap / answered, gain / answered);
    QVERIFY(gain / answered > 10.0);
  }

  void floor_underRandomGlides_isBelowTheCheckersHeight_data() { worlds(); }

  void floor_underRandomGlides_isBelowTheCheckersHeight() {
    QFETCH(QString, name);
    QFETCH(int, vertices);
    QFETCH(bool, hasDetail);
    const World world = worldNamed(name);
    const AltitudeFloor floor = floorOf(world, vertices, hasDetail ? std::optional(kDetail) : std::nullopt);
    RandomPose random;
    int finite = 0;
    for (int i = 0; i < 1000; ++i) {
      const geo::Pose start = random();
      const mission::SiteInFrame& site = world.sites[random.engine() % world.sites.size()];
      const double radius = world.glide.glideRadii()[random.engine() % world.glide.glideRadii().size()];
      std::vector<flight::Piece> pieces;
      const geo::Pose via = i % 3 == 0 ? random() : start;
      flight::appendPieces(flight::shortestDubins(start, via, radius), pieces);
      flight::appendPieces(flight::shortestDubins(via, site.pose, radius), pieces);
      const double needed = safety::requiredStartHeight(start, pieces, site.site.elevation.metres() + world.arrivalMargin, world.terrain.grid(),
                                                        world.clearance, world.glide);
      if (!std::isfinite(needed)) {
        continue;
      }
      ++finite;
      double height = needed;
      geo::Pose pose = start;
      for (const flight::Piece& piece : pieces) {
        for (double along = 0.0; along < piece.length; along += 37.0) {
          const double z = height - world.glide.lossAt(piece.radius) * along;
          QVERIFY(floor.at(flight::poseAfter(pose, piece, along).point()) <= z);
        }
        height -= world.glide.lossAt(piece.radius) * piece.length;
        pose = flight::endOf(pose, piece);
      }
    }
    QVERIFY(finite > 100);
  }

  void squares_underAnyWorld_keepOneOfTheRules_data() { worlds(); }

  void squares_underAnyWorld_keepOneOfTheRules() {
    QFETCH(QString, name);
    QFETCH(int, vertices);
    QFETCH(bool, hasDetail);
    const World world = worldNamed(name);
    const AltitudeFloor floor = floorOf(world, vertices, hasDetail ? std::optional(kDetail) : std::nullopt);
    QCOMPARE(brokenSquares(world, floor.whole()), 0);
    QCOMPARE(floor.detail().value.empty(), !hasDetail);
    if (hasDetail) {
      QVERIFY(floor.detail().spacing < floor.whole().spacing);
      QCOMPARE(brokenSquares(world, floor.detail()), 0);
    }
    for (const mission::SiteInFrame& site : world.sites) {
      const double ground = world.terrain.grid().upperAt(site.pose.point());
      QVERIFY(!std::isfinite(ground) || floor.at(site.pose.point()) <= std::max(site.site.elevation.metres(), ground + world.clearance));
    }
  }

  void flatGround_underOneSite_givesAlmostTheStraightGlide() {
    World world = test::mountainWorld();
    world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double, double) { return 0.0; }));
    world.sites = {test::site("E", 13.0, -7.0, 0.0, 0.0)};
    const AltitudeFloor floor = floorOf(world, 100'000);
    RandomPose random;
    for (int i = 0; i < 10'000; ++i) {
      const geo::Pose pose = random();
      const double straight = world.clearance + world.glide.straightLoss() * geo::distance(pose.point(), world.sites[0].pose.point());
      QVERIFY(floor.at(pose.point()) <= straight);
      QVERIFY(floor.at(pose.point()) >= straight - 6.0);  // what a grid misses around its source, some three squares' worth of glide
    }
  }

  void site_underUnknownGround_givesNothing() {
    World world = worldNamed("unknown ground");
    world.sites = {test::site("U", -1500.0, -1900.0, 0.0, 0.0)};
    QVERIFY(!world.terrain.grid().isKnownAt(world.sites[0].pose.point()));
    QVERIFY(std::isinf(floorOf(world, 100'000).at({0.0, 0.0})));
  }

  void emptyFloor_claimsNothing() { QCOMPARE(AltitudeFloor().at({1.0, 2.0}), -std::numeric_limits<double>::infinity()); }

  void cancel_returnsWithoutAResult() {
    std::stop_source stop;
    stop.request_stop();
    const Result<AltitudeFloor> floor = AltitudeFloor::build(test::mountainWorld(), {}, Job(stop.get_token()));
    QVERIFY(!floor && floor.error().code == Errc::Cancelled);
  }

private:
  static void worlds() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("vertices");
    QTest::addColumn<bool>("hasDetail");
    for (const char* name : {"mountain", "walls", "unknown ground", "rough", "one site"}) {
      QTest::addRow("%s, fine", name) << name << 100'000 << false;
      QTest::addRow("%s, coarse", name) << name << 5'000 << false;
      QTest::addRow("%s, coarse with detail", name) << name << 3'000 << true;
    }
  }
};

QTEST_APPLESS_MAIN(TestAltitudeFloor)
#include "tst_altitude_floor.moc"
