#include "core/terrain/terrain_pyramid.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace vp::terrain {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr unsigned kSeed = 20240611;

std::shared_ptr<const ElevationGrid> randomGrid(int columns, int rows, double unknownShare, std::mt19937_64& random) {
  std::uniform_real_distribution<float> height(-50.0F, 3000.0F);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (float& value : values) {
    value = unit(random) < unknownShare ? kUnknownUpper : height(random);
  }
  return std::make_shared<const ElevationGrid>(-300.0, 120.0, 30.0, columns, rows, std::move(values));
}

/// All cells that a closed box touches, by comparing their edges; counted and summed up plainly.
struct Touched {
  double highest = -kInf;
  double lowestKnown = kInf;
  int columns = 0;
  int rows = 0;

  Touched(const ElevationGrid& grid, const geo::Box& box) {
    const double cell = grid.cellSize();
    const geo::Box all = grid.extent();
    if (box.minX <= all.minX || box.minY <= all.minY || box.maxX >= all.maxX || box.maxY >= all.maxY) {
      highest = kInf;  // touches the outside, however far
    }
    for (int column = -1; column <= grid.columns(); ++column) {
      columns += touches(grid.originX() + column * cell, cell, box.minX, box.maxX) ? 1 : 0;
    }
    for (int row = -1; row <= grid.rows(); ++row) {
      if (!touches(grid.originY() + row * cell, cell, box.minY, box.maxY)) {
        continue;
      }
      ++rows;
      for (int column = -1; column <= grid.columns(); ++column) {
        if (touches(grid.originX() + column * cell, cell, box.minX, box.maxX)) {
          const double value = static_cast<double>(grid.upperInCell(column, row));
          highest = std::max(highest, value);
          lowestKnown = std::min(lowestKnown, value);
        }
      }
    }
  }
  static bool touches(double from, double cell, double low, double high) { return from <= high && from + cell >= low; }
};

}  // namespace

class TestTerrainPyramid : public QObject {
  Q_OBJECT

private:
  /// Boxes inside, across the border and outside; half of them with edges exactly on the edges of cells.
  static geo::Box randomBox(const ElevationGrid& grid, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const geo::Box all = grid.extent().grown(2.0 * grid.cellSize());
    const double largest = unit(random) < 0.5 ? 1.9 * grid.cellSize() : unit(random) * (all.maxX - all.minX);
    geo::Box box;
    box.minX = all.minX + unit(random) * (all.maxX - all.minX);
    box.minY = all.minY + unit(random) * (all.maxY - all.minY);
    box.maxX = box.minX + unit(random) * largest;
    box.maxY = box.minY + unit(random) * largest;
    if (unit(random) < 0.5) {
      for (double* side : {&box.minX, &box.minY, &box.maxX, &box.maxY}) {
        *side = std::round(*side / grid.cellSize()) * grid.cellSize();
      }
    }
    return box;
  }

private slots:
  void upperIn_randomBoxes_boundsTheTouchedCells() {
    std::mt19937_64 random(kSeed);
    qInfo("seed %u", kSeed);
    int exact = 0;
    int known = 0;
    for (const auto& [columns, rows] : {std::pair{37, 53}, {64, 64}, {1, 17}, {65, 2}, {1, 1}, {128, 31}}) {
      for (const double unknownShare : {0.0, 0.01}) {
        const auto grid = randomGrid(columns, rows, unknownShare, random);
        const TerrainPyramid pyramid(grid);
        for (int i = 0; i < 2000; ++i) {
          const geo::Box box = randomBox(*grid, random);
          const Touched touched(*grid, box);
          const double upper = pyramid.upperIn(box);
          QVERIFY(upper >= touched.highest);
          if (touched.columns <= 2 && touched.rows <= 2) {
            QCOMPARE(upper, touched.highest);
            ++exact;
          }
          const geo::Box around = box.grown(2.0 * std::max(box.maxX - box.minX, box.maxY - box.minY));
          if (touched.highest < kInf && upper < kInf) {
            QVERIFY(upper <= std::max(touched.highest, highestKnownIn(*grid, around)));
            ++known;
          }
          // infinite only for a reason: an unknown or outside cell touched, or an unknown one nearby
          if (std::isinf(upper) && touched.highest < kInf) {
            QVERIFY(std::isinf(Touched(*grid, around).highest));
          }
        }
      }
    }
    QVERIFY(exact > 3000);
    QVERIFY(known > 5000);
  }

  void upperIn_wideBoxInsideAKnownGrid_isFiniteUpToTheBorder() {
    std::mt19937_64 random(kSeed);
    const auto grid = randomGrid(37, 53, 0.0, random);
    const TerrainPyramid pyramid(grid);
    const double highest = static_cast<double>(*std::max_element(grid->values().begin(), grid->values().end()));
    QCOMPARE(pyramid.upperIn(grid->extent().grown(-1.0)), highest);
    QVERIFY(std::isinf(pyramid.upperIn(grid->extent())));  // its edge touches the outside
  }

  void upperIn_denseSampling_isNeverBelow() {
    std::mt19937_64 random(kSeed + 1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    qInfo("seed %u", kSeed + 1);
    const auto grid = randomGrid(200, 150, 0.002, random);
    const TerrainPyramid pyramid(grid);
    for (int i = 0; i < 10'000; ++i) {
      const geo::Box box = randomBox(*grid, random);
      const double upper = pyramid.upperIn(box);
      for (int k = 0; k < 25; ++k) {
        const geo::Point p{box.minX + unit(random) * (box.maxX - box.minX), box.minY + unit(random) * (box.maxY - box.minY)};
        QVERIFY(upper >= grid->upperAt({std::min(p.x, box.maxX), std::min(p.y, box.maxY)}));
      }
    }
  }

  void lowerIn_randomBoxes_isNotAboveAnyKnownCell() {
    std::mt19937_64 random(kSeed + 2);
    qInfo("seed %u", kSeed + 2);
    int exact = 0;
    for (const double unknownShare : {0.0, 0.3}) {
      const auto grid = randomGrid(45, 70, unknownShare, random);
      const TerrainPyramid pyramid(grid);
      for (int i = 0; i < 10'000; ++i) {
        const geo::Box box = randomBox(*grid, random);
        const Touched touched(*grid, box);
        const double lower = pyramid.lowerIn(box);
        QVERIFY(lower <= touched.lowestKnown);
        if (touched.columns <= 2 && touched.rows <= 2) {
          QCOMPARE(lower, touched.lowestKnown < kInf ? touched.lowestKnown : -kInf);
          ++exact;
        }
      }
    }
    QVERIFY(exact > 2000);
  }

  void bothBounds_oddBoxes_answerUnknown() {
    std::mt19937_64 random(kSeed);
    const TerrainPyramid pyramid(randomGrid(8, 8, 0.0, random));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const geo::Box inside = pyramid.grid().extent().grown(-50.0);
    QVERIFY(pyramid.upperIn(inside) < kInf);
    std::vector<geo::Box> odd{geo::Box(), {-1e300, -1e300, 1e300, 1e300}, {inside.maxX, inside.minY, inside.minX, inside.maxY}};
    for (const double value : {nan, kInf, -kInf}) {
      for (double geo::Box::*side : {&geo::Box::minX, &geo::Box::minY, &geo::Box::maxX, &geo::Box::maxY}) {
        odd.push_back(inside);
        odd.back().*side = value;
      }
    }
    for (const geo::Box& box : odd) {
      QCOMPARE(pyramid.upperIn(box), kInf);
    }
    QCOMPARE(pyramid.lowerIn(geo::Box()), -kInf);
    QCOMPARE(pyramid.lowerIn({nan, 0.0, 1.0, 1.0}), -kInf);
    QCOMPARE(pyramid.lowerIn({1e6, 1e6, 2e6, 2e6}), -kInf);
    QVERIFY(pyramid.lowerIn({-1e300, -1e300, 1e300, 1e300}) > -kInf);
  }

  void copies_outliveTheOriginal() {
    std::mt19937_64 random(kSeed);
    auto original = std::make_unique<TerrainPyramid>(randomGrid(40, 40, 0.0, random));
    const geo::Box box = original->grid().extent().grown(-100.0);
    const double upper = original->upperIn(box);
    const TerrainPyramid copy = *original;
    original.reset();
    QCOMPARE(copy.upperIn(box), upper);
    QCOMPARE(copy.levels(), 7);  // 40, 20, 10, 5, 3, 2, 1
    QCOMPARE(TerrainPyramid().upperIn(box), kInf);
    QCOMPARE(TerrainPyramid().lowerIn(box), -kInf);
  }

private:
  static double highestKnownIn(const ElevationGrid& grid, const geo::Box& box) {
    double value = -kInf;
    const double cell = grid.cellSize();
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const bool isTouched = Touched::touches(grid.originX() + column * cell, cell, box.minX, box.maxX) &&
                               Touched::touches(grid.originY() + row * cell, cell, box.minY, box.maxY);
        if (isTouched && grid.upperInCell(column, row) < kUnknownUpper) {
          value = std::max(value, static_cast<double>(grid.upperInCell(column, row)));
        }
      }
    }
    return value;
  }
};

}  // namespace vp::terrain

using vp::terrain::TestTerrainPyramid;
QTEST_APPLESS_MAIN(TestTerrainPyramid)
#include "tst_terrain_pyramid.moc"
