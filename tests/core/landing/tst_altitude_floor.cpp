// The altitude floor never lies above a safe altitude, by the roadmap's glides and by glides that the checker measures.
#include "core/base/quantity.h"
#include "core/landing/altitude_floor.h"
#include "core/landing/rrt_star.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <chrono>
#include <cmath>
#include <random>

using namespace vp;
using namespace vp::landing;

namespace {

constexpr unsigned kSeed = 61;

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

AltitudeFloor floorOf(const World& world, std::size_t vertices, std::optional<geo::Box> detail = std::nullopt) {
  return *AltitudeFloor::build(world, {vertices, detail}, Job{});
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
if(!keepsLimit&&!keepsSlope) qInfo("%d %d of %d %d: %f %f %f %f limit %f most %f", i,j,grid.columns,grid.rows,a,b,c,d,limit,most);
    }
  }
  return broken;
}

}  // namespace

class TestAltitudeFloor : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void floor_underRandomQueries_isALowerBound_data() {
    QTest::addColumn<int>("vertices");
    QTest::addColumn<double>("leastMean");  // of the floor above the highest of ground and straight glide without ground
    for (const char* world : {"mountain", "walls", "unknown ground", "rough", "one site"}) {
      for (const int vertices : {100'000, 5'000}) {
        QTest::addRow("%s, %d vertices", world, vertices) << vertices << 0.0;
      }
    }
  }

  void floor_underRandomQueries_isALowerBound() {
    QFETCH(int, vertices);
    const World world = worldNamed(QString(QTest::currentDataTag()).section(',', 0, 0));
    const auto start = std::chrono::steady_clock::now();
    const AltitudeFloor floor = floorOf(world, static_cast<std::size_t>(vertices));
    const double milliseconds = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    QCOMPARE(brokenSquares(world, floor.whole()), 0);
    const TreeRoadmap roadmap = roadmapOf(world, 3000);
    QueryScratch scratch;
    RandomPose random;
    double gap = 0.0;
    double above = 0.0;
    int answered = 0;
    std::vector<flight::Piece> pieces;
    for (int i = 0; i < 3000; ++i) {
      const geo::Pose pose = random();
      const double bound = floor.at(pose.point());
      const std::optional<SafeAltitude> answer = roadmap.query(world, pose, scratch);
      if (!answer) {
        continue;
      }
      QVERIFY2(bound <= answer->altitude, qPrintable(QString("%1 %2: %3 above %4").arg(pose.x).arg(pose.y).arg(bound).arg(answer->altitude)));
      double plain = world.terrain.grid().upperAt(pose.point()) + world.clearance;
      double direct = INFINITY;
      for (const mission::SiteInFrame& site : world.sites) {
        direct = std::min(direct, site.site.elevation.metres() + world.glide.straightLoss() * geo::distance(site.pose.point(), pose.point()));
      }
      plain = std::max(plain, direct);
      gap += answer->altitude - std::max(plain, bound);
      above += std::max(plain, bound) - plain;
      ++answered;
    }
    QVERIFY(answered > 1000);
    qInfo("built in %.1f ms; mean gap %.1f m; mean above ground and straight glide %.1f m", milliseconds, gap / answered, above / answered);
  }
};

QTEST_APPLESS_MAIN(TestAltitudeFloor)
#include "tst_altitude_floor.moc"
