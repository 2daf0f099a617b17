// The linear octree of free space against brute force over its obstacles and over all of its cells.
#include "core/emergency/linear_octree.h"
#include "core/emergency/octree_ground.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stop_token>

using namespace vp;
using namespace vp::emergency;

namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

struct Random {
  explicit Random(std::uint64_t seed) : engine(seed) {}
  double operator()(double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1.0p-53; }
  Point3 in(const Point3& low, const Point3& high) {
    const double x = (*this)(low.x, high.x);
    const double y = (*this)(low.y, high.y);
    return {x, y, (*this)(low.z, high.z)};
  }
  std::mt19937_64 engine;
};

/// Whether a segment comes within `grow` of a closed box along every axis at once.
bool meets(const Point3& a, const Point3& b, const Cuboid& box, double grow) {
  double from = 0.0;
  double to = 1.0;
  const auto clip = [&](double start, double end, double low, double high) {
    const double step = end - start;
    if (step == 0.0) {
      return start >= low - grow && start <= high + grow;
    }
    const double first = (low - grow - start) / step;
    const double second = (high + grow - start) / step;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
    return true;
  };
  return clip(a.x, b.x, box.low.x, box.high.x) && clip(a.y, b.y, box.low.y, box.high.y) && clip(a.z, b.z, box.low.z, box.high.z) && from <= to;
}

/// A box of cells with everything that blocks it, kept as it was given.
struct Scene {
  CellBox box;
  std::vector<float> ground;  ///< by column, or empty
  std::vector<Cuboid> obstacles;

  [[nodiscard]] LinearOctree tree() const { return *LinearOctree::build(box, ground, obstacles, Job()); }

  [[nodiscard]] Cuboid cell(int i, int j, int k) const {
    const Point3 low{box.low.x + i * box.cell.x, box.low.y + j * box.cell.y, box.low.z + k * box.cell.z};
    return {low, {low.x + box.cell.x, low.y + box.cell.y, low.z + box.cell.z}};
  }
  [[nodiscard]] Cuboid column(int i, int j) const {
    const float top = ground[static_cast<std::size_t>(j * box.count[0] + i)];
    const Cuboid lowest = cell(i, j, 0);
    return {{lowest.low.x, lowest.low.y, -1e9}, {lowest.high.x, lowest.high.y, static_cast<double>(top)}};
  }
  /// All that blocks, as closed boxes; columns of ground without their sides, as whoever gives them counts what touches a column.
  [[nodiscard]] std::vector<Cuboid> blocked() const {
    std::vector<Cuboid> all = obstacles;
    for (int j = 0; !ground.empty() && j < box.count[1]; ++j) {
      for (int i = 0; i < box.count[0]; ++i) {
        Cuboid open = column(i, j);
        open.low = {open.low.x + 1e-9, open.low.y + 1e-9, open.low.z};
        open.high = {open.high.x - 1e-9, open.high.y - 1e-9, open.high.z};
        all.push_back(open);
      }
    }
    return all;
  }
  [[nodiscard]] bool isBlockedCell(int i, int j, int k) const {
    const Cuboid one = cell(i, j, k);
    const auto touches = [&one](const Cuboid& other) {
      return other.low.x <= one.high.x && other.high.x >= one.low.x && other.low.y <= one.high.y && other.high.y >= one.low.y &&
             other.low.z <= one.high.z && other.high.z >= one.low.z;
    };
    if (std::any_of(obstacles.begin(), obstacles.end(), touches)) {
      return true;
    }
    return !ground.empty() && static_cast<double>(ground[static_cast<std::size_t>(j * box.count[0] + i)]) >= one.low.z;
  }
};

/// Cells of 7 x 5 x 3 metres; obstacles at random, some of them as thin as a sheet, and hills.
Scene randomScene(std::uint64_t seed, int obstacles, bool hills) {
  Random random(seed);
  Scene scene;
  scene.box = {{-100.0, 40.0, 10.0}, {7.0, 5.0, 3.0}, {37, 29, 21}};
  const Point3 high = scene.box.high();
  for (int i = 0; i < obstacles; ++i) {
    const Point3 at = random.in(scene.box.low, high);
    const double thin = i % 3 == 0 ? 0.0 : 1.0;
    scene.obstacles.push_back({at, {at.x + random(0.0, 50.0), at.y + random(0.0, 60.0) * thin, at.z + random(0.0, 30.0)}});
  }
  for (int j = 0; hills && j < scene.box.count[1]; ++j) {
    for (int i = 0; i < scene.box.count[0]; ++i) {
      scene.ground.push_back(static_cast<float>(10.0 + 25.0 * (1.0 + std::sin(0.3 * i) * std::cos(0.25 * j)) + random(-3.0, 3.0)));
    }
  }
  return scene;
}

}  // namespace

class TestLinearOctree : public QObject {
  Q_OBJECT

private slots:
  void mortonCode_alternatesTheBits() {
    QCOMPARE(LinearOctree::mortonOf(0, 0, 0), std::uint64_t{0});
    QCOMPARE(LinearOctree::mortonOf(1, 0, 0), std::uint64_t{1});
    QCOMPARE(LinearOctree::mortonOf(0, 1, 0), std::uint64_t{2});
    QCOMPARE(LinearOctree::mortonOf(0, 0, 1), std::uint64_t{4});
    QCOMPARE(LinearOctree::mortonOf(3, 5, 6), std::uint64_t{0b110'101'011});  // x = 011, y = 101, z = 110
    std::set<std::uint64_t> codes;
    for (std::uint32_t i = 0; i < 16 * 16 * 16; ++i) {
      codes.insert(LinearOctree::mortonOf(i % 16, i / 16 % 16, i / 256));
    }
    QVERIFY(codes.size() == 4096 && *codes.rbegin() == 4095);
    QCOMPARE(LinearOctree::mortonOf(0x1FFFFF, 0x1FFFFF, 0x1FFFFF), (std::uint64_t{1} << 63U) - 1);
  }

  void leaves_areTheLargestFreeCubes() {
    // 8 x 8 x 8 with one cell blocked: 7 cubes of 4, 7 of 2 and 7 of 1
    const Scene scene{{{}, {1.0, 1.0, 1.0}, {8, 8, 8}}, {}, {{{5.5, 2.5, 7.5}, {5.6, 2.6, 7.6}}}};
    const LinearOctree tree = scene.tree();
    QCOMPARE(tree.leaves(), std::size_t{21});
    QCOMPARE(tree.freeCells(), std::int64_t{511});
    QVERIFY(!tree.isFree({5.5, 2.5, 7.5}) && tree.isFree({4.5, 2.5, 7.5}));
    QCOMPARE((Scene{{{}, {1.0, 1.0, 1.0}, {8, 8, 8}}, {}, {}}.tree().leaves()), std::size_t{1});
    QCOMPARE((Scene{{{}, {1.0, 1.0, 1.0}, {8, 8, 8}}, {}, {{{-1.0, -1.0, -1.0}, {9.0, 9.0, 9.0}}}}.tree().leaves()), std::size_t{0});
  }

  void cells_areFreeExactlyWhereNothingTouchesThem() {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Scene scene = randomScene(seed, 12, seed % 2 == 0);
      const LinearOctree tree = scene.tree();
      std::int64_t free = 0;
      for (int i = 0; i < scene.box.count[0]; ++i) {
        for (int j = 0; j < scene.box.count[1]; ++j) {
          for (int k = 0; k < scene.box.count[2]; ++k) {
            const Cuboid cell = scene.cell(i, j, k);
            const Point3 middle{0.5 * (cell.low.x + cell.high.x), 0.5 * (cell.low.y + cell.high.y), 0.5 * (cell.low.z + cell.high.z)};
            const bool isBlocked = scene.isBlockedCell(i, j, k);
            QVERIFY(tree.isFree(middle) != isBlocked);
            free += isBlocked ? 0 : 1;
          }
        }
      }
      QCOMPARE(tree.freeCells(), free);
    }
  }

  void segments_areNeverFreeWhereBruteForceSaysBlocked() {
    Random random(180);
    int isFree = 0;
    int isBlocked = 0;
    for (std::uint64_t seed = 11; seed <= 20; ++seed) {
      const Scene scene = randomScene(seed, 8, seed % 2 == 0);
      const LinearOctree tree = scene.tree();
      const std::vector<Cuboid> blocked = scene.blocked();
      std::vector<Cuboid> blockedCells;
      for (int i = 0; i < scene.box.count[0]; ++i) {
        for (int j = 0; j < scene.box.count[1]; ++j) {
          for (int k = 0; k < scene.box.count[2]; ++k) {
            if (scene.isBlockedCell(i, j, k)) {
              blockedCells.push_back(scene.cell(i, j, k));
            }
          }
        }
      }
      for (int n = 0; n < 1000; ++n) {
        Point3 a = random.in(scene.box.low, scene.box.high());
        Point3 b = n % 2 == 0 ? random.in(scene.box.low, scene.box.high()) : Point3{a.x + random(-20.0, 20.0), a.y + random(-20.0, 20.0), a.z};
        if (n % 5 == 0) {  // along the edges and through the corners of cells
          a = {scene.box.low.x + 7.0 * std::floor(random(0.0, 37.0)), scene.box.low.y + 5.0 * std::floor(random(0.0, 29.0)), a.z};
          b = n % 2 == 0 ? Point3{a.x, a.y, b.z} : Point3{a.x + 21.0, a.y + 15.0, a.z};
        }
        const bool answer = tree.isFree(a, b);
        const auto meetsExactly = [&](const Cuboid& one) { return meets(a, b, one, 0.0); };
        if (answer) {
          ++isFree;
          QVERIFY2(std::none_of(blocked.begin(), blocked.end(), meetsExactly), qPrintable(QString("scene %1, segment %2").arg(seed).arg(n)));
          const Point3 high = scene.box.high();
          QVERIFY(b.x >= scene.box.low.x && b.x <= high.x && b.y >= scene.box.low.y && b.y <= high.y);
          QVERIFY(tree.isFree(b, a) || n % 5 == 0);  // both ways, but where it only touches
        } else {
          ++isBlocked;
          // and not blocked without a reason: it comes within a micrometre of a blocked cell, or leaves the box
          const auto meetsNearly = [&](const Cuboid& one) { return meets(a, b, one, 1e-6); };
          const bool leaves = !meets(b, b, {scene.box.low, scene.box.high()}, -1e-6);
          QVERIFY2(leaves || std::any_of(blockedCells.begin(), blockedCells.end(), meetsNearly),
                   qPrintable(QString("scene %1, segment %2").arg(seed).arg(n)));
        }
      }
    }
    QVERIFY2(isFree > 1500 && isBlocked > 1500, qPrintable(QString("%1 free, %2 blocked").arg(isFree).arg(isBlocked)));
  }

  void boxes_areFreeExactlyWhereAllTheirCellsAre() {
    Random random(181);
    int isFree = 0;
    for (std::uint64_t seed = 21; seed <= 24; ++seed) {
      const Scene scene = randomScene(seed, 8, seed % 2 == 0);
      const LinearOctree tree = scene.tree();
      for (int n = 0; n < 500; ++n) {
        const Point3 low = random.in(scene.box.low, scene.box.high());
        const Cuboid part{low, {low.x + random(0.0, 30.0), low.y + random(0.0, 30.0), low.z + random(0.0, 12.0)}};
        const Point3 high = scene.box.high();
        bool expected = part.high.x <= high.x && part.high.y <= high.y && part.high.z <= high.z;
        for (int i = 0; expected && i < scene.box.count[0]; ++i) {
          for (int j = 0; expected && j < scene.box.count[1]; ++j) {
            for (int k = 0; expected && k < scene.box.count[2]; ++k) {
              const Cuboid cell = scene.cell(i, j, k);
              const bool overlaps = cell.low.x <= part.high.x && cell.high.x >= part.low.x && cell.low.y <= part.high.y &&
                                    cell.high.y >= part.low.y && cell.low.z <= part.high.z && cell.high.z >= part.low.z;
              expected = !overlaps || !scene.isBlockedCell(i, j, k);
            }
          }
        }
        QCOMPARE(tree.isBoxFree(part), expected);
        isFree += expected ? 1 : 0;
      }
    }
    QVERIFY(isFree > 100);
  }

  void outside_isNeverFree() {
    const LinearOctree tree = Scene{{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {10, 10, 10}}, {}, {}}.tree();
    QVERIFY(tree.isFree({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0}) && tree.isBoxFree(Cuboid{{0.0, 0.0, 0.0}, {10.0, 10.0, 10.0}}));
    QVERIFY(!tree.isFree({5.0, 5.0, 5.0}, {5.0, 5.0, 10.001}) && !tree.isFree({-0.001, 5.0, 5.0}, {5.0, 5.0, 5.0}));
    QVERIFY(!tree.isFree({5.0, 5.0, NAN}) && !tree.isFree({5.0, 5.0, 5.0}, {INFINITY, 5.0, 5.0}));
    QVERIFY(!tree.isBoxFree(Cuboid{{1.0, 1.0, 1.0}, {2.0, 2.0, 10.5}}) && !LinearOctree().isFree({0.5, 0.5, 0.5}));
  }

  void ground_isRaisedEnlargedAndUnknownWhereTheTerrainIs() {
    // 40 x 40 cells of 10 m; one peak, one hole
    std::vector<float> values(1600, 100.0F);
    values[20 * 40 + 20] = 300.0F;
    values[5 * 40 + 5] = terrain::kUnknownUpper;
    const terrain::ElevationGrid grid(-200.0, -200.0, 10.0, 40, 40, values);
    const OctreeGround ground{grid.extent(), 0.0, 500.0, {40, 40, 50}, 0.0, 30.0, 25.0};
    const CellBox box = cellsOver(ground);
    QVERIFY(box.cell == (Point3{10.0, 10.0, 10.0}));
    const std::vector<float> heights = blockedHeights(grid, box, ground.clearance, ground.enlarge);
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 40; ++i) {
        // a column counts with what touches it, and so with the eight around it; then with what comes nearer than 25 m
        const auto nearPost = [&](int column, int row) {
          const int di = std::max(0, std::abs(i - column) - 2);
          const int dj = std::max(0, std::abs(j - row) - 2);
          return std::hypot(10.0 * di, 10.0 * dj) < 25.0;
        };
        const float found = heights[static_cast<std::size_t>(40 * j + i)];
        QCOMPARE(std::isinf(found), nearPost(5, 5));
        if (!nearPost(5, 5)) {
          QVERIFY(std::abs(found - (nearPost(20, 20) ? 330.0F : 130.0F)) < 1e-3F);
        }
      }
    }
    const LinearOctree tree = *octreeOver(grid, ground, Job());
    QVERIFY(tree.isFree({-180.0, 100.0, 145.0}, {180.0, 100.0, 145.0}));
    QVERIFY(!tree.isFree({-180.0, 0.0, 145.0}, {180.0, 0.0, 145.0}));
    QVERIFY(!tree.isFree({-145.0, -145.0, 499.0}));
  }

  void ground_coarserThanTheTerrain_isNeverBelowIt() {
    Random random(77);
    std::vector<float> values;
    for (int i = 0; i < 90 * 70; ++i) {
      values.push_back(static_cast<float>(random(0.0, 900.0)));
    }
    const terrain::ElevationGrid grid(1000.0, -500.0, 13.0, 90, 70, values);
    geo::Box area = grid.extent();
    area.minX -= 50.0;  // unknown there
    const OctreeGround ground{area, -100.0, 1500.0, {31, 17, 64}, 0.0, 0.0, 0.0};
    const LinearOctree tree = *octreeOver(grid, ground, Job());
    int isFree = 0;
    for (int n = 0; n < 10'000; ++n) {
      const Point3 p = random.in({area.minX, area.minY, -100.0}, {area.maxX, area.maxY, 1500.0});
      if (tree.isFree(p)) {
        ++isFree;
        QVERIFY(p.z > grid.upperAt({p.x, p.y}));
      }
    }
    QVERIFY(isFree > 3000);
    // segments, against the closed cells of the terrain; some along the borders of columns
    std::vector<Cuboid> cells;
    for (int j = 0; j < 70; ++j) {
      for (int i = 0; i < 90; ++i) {
        const double x = 1000.0 + 13.0 * i;
        const double y = -500.0 + 13.0 * j;
        cells.push_back({{x, y, -1e9}, {x + 13.0, y + 13.0, static_cast<double>(grid.upperInCell(i, j))}});
      }
    }
    isFree = 0;
    for (int n = 0; n < 4000; ++n) {
      Point3 a = random.in({area.minX, area.minY, 200.0}, {area.maxX, area.maxY, 1200.0});
      Point3 b{a.x + random(-100.0, 100.0), a.y + random(-100.0, 100.0), a.z + random(-50.0, 50.0)};
      if (n % 4 == 0) {
        const double cell = tree.box().cell.x;
        a.x = b.x = area.minX + cell * std::floor((a.x - area.minX) / cell);
      }
      if (tree.isFree(a, b)) {
        ++isFree;
        QVERIFY(std::none_of(cells.begin(), cells.end(), [&](const Cuboid& one) { return meets(a, b, one, 0.0); }));
      }
    }
    QVERIFY2(isFree > 500, qPrintable(QString::number(isFree)));
  }

  void emptyGround_blocksNothing() {
    const Scene scene{{{}, {1.0, 1.0, 1.0}, {4, 4, 4}}, std::vector<float>(16, kNothing), {}};
    QCOMPARE(scene.tree().freeCells(), std::int64_t{64});
  }

  void stopped_isSaid() {
    std::stop_source stop;
    stop.request_stop();
    const Result<LinearOctree> tree = LinearOctree::build({{}, {1.0, 1.0, 1.0}, {64, 64, 64}}, {}, {}, Job(stop.get_token()));
    QVERIFY(!tree && tree.error().code == Errc::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestLinearOctree)
#include "tst_linear_octree.moc"
