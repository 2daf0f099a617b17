#include "core/base/quantity.h"
#include "core/safety/cell_walk.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace vp;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kSeed = 20240601;
constexpr int kCases = 12000;

terrain::ElevationGrid randomGrid(std::mt19937_64& random, double unknownShare) {
  std::uniform_real_distribution<float> height(0.0F, 1000.0F);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<float> values(40 * 30);
  for (float& value : values) {
    value = share(random) < unknownShare ? terrain::kUnknownUpper : height(random);
  }
  return terrain::ElevationGrid(-1000.0, -700.0, 50.0, 40, 30, values);
}

/// Flat ground of 0 m with one cell set.
terrain::ElevationGrid wallAt(int column, int row, float height) {
  std::vector<float> values(20 * 20, 0.0F);
  values[static_cast<std::size_t>(row) * 20 + static_cast<std::size_t>(column)] = height;
  return terrain::ElevationGrid(0.0, 0.0, 100.0, 20, 20, values);
}

double highestUnder(const terrain::ElevationGrid& grid, const geo::Pose& start, const flight::Piece& piece) {
  safety::CellWalk walk(grid);
  walk.start(start, piece);
  double highest = -kInfinity;
  for (safety::Span span; walk.next(span);) {
    highest = std::max(highest, span.ground);
  }
  return highest;
}

/// Half of the cases lie on grid lines, through corners, or touch grid lines with a circle.
struct RandomPath {
  geo::Pose start;
  flight::Piece piece;

  RandomPath(std::mt19937_64& random, bool isArc) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const bool onGrid = unit(random) < 0.5;
    start = {-900.0 + 1700.0 * unit(random), -600.0 + 1200.0 * unit(random), 2.0 * Angle::kPi * unit(random)};
    piece.length = 1200.0 * unit(random) * unit(random);
    if (isArc) {
      piece.turn = unit(random) < 0.5 ? flight::Turn::Left : flight::Turn::Right;
      piece.radius = 5.0 + 400.0 * unit(random) * unit(random);
    }
    if (onGrid) {
      start.x = unit(random) < 0.5 ? 50.0 * std::round(start.x / 50.0) : start.x;
      start.y = unit(random) < 0.5 ? 50.0 * std::round(start.y / 50.0) : start.y;
      start.heading = Angle::kPi / 4.0 * std::floor(8.0 * unit(random));
      piece.radius = isArc ? 25.0 * std::ceil(piece.radius / 25.0) : 0.0;
      piece.length = 25.0 * std::floor(piece.length / 25.0);
      if (isArc && unit(random) < 0.2) {
        piece.length = 2.0 * Angle::kPi * piece.radius * std::ceil(3.0 * unit(random));
      }
    }
  }
};

/// A turn cut at every 45 degrees; where it starts at a multiple of that, at every point where it turns round in x or y.
std::vector<flight::Piece> eighthsOf(const flight::Piece& piece) {
  std::vector<flight::Piece> parts;
  const double part = piece.turn == flight::Turn::Straight ? 25.0 : piece.radius * Angle::kPi / 4.0;
  for (double from = 0.0; from < piece.length; from += part) {
    parts.push_back({piece.turn, piece.radius, std::min(part, piece.length - from)});
  }
  return parts;
}

/// True if the spans are nowhere below a cell that comes within a tenth of a micrometre of one of the points.
bool coversAll(const terrain::ElevationGrid& grid, const std::vector<safety::Span>& spans, const std::vector<test::FlownPoint>& points) {
  std::size_t at = 0;
  for (const test::FlownPoint& point : points) {
    while (at + 1 < spans.size() && spans[at].to < point.distance - 1e-6) {
      ++at;
    }
    double ground = -kInfinity;  // of the spans that meet the point, within the rounding of its distance
    for (std::size_t i = at; i < spans.size() && spans[i].from <= point.distance + 1e-6; ++i) {
      ground = std::max(ground, spans[i].ground);
    }
    if (!(ground >= test::groundNear(grid, point.x, point.y, 1e-7))) {
      return false;
    }
  }
  return true;
}

/// QVERIFY2 would describe every case that passes.
#define VERIFY_CASE(condition)     \
  if (!(condition)) {              \
    QFAIL(describe(number, path)); \
  }

QByteArray describe(int number, const RandomPath& path) {
  return QString("case %1 of seed %2: start (%3, %4, %5) turn %6 radius %7 length %8")
      .arg(number)
      .arg(kSeed)
      .arg(path.start.x, 0, 'g', 17)
      .arg(path.start.y, 0, 'g', 17)
      .arg(path.start.heading, 0, 'g', 17)
      .arg(static_cast<int>(path.piece.turn))
      .arg(path.piece.radius, 0, 'g', 17)
      .arg(path.piece.length, 0, 'g', 17)
      .toUtf8();
}

}  // namespace

class TestCellWalk : public QObject {
  Q_OBJECT

private slots:
  void randomPaths_data() {
    QTest::addColumn<bool>("isArc");
    QTest::newRow("straights") << false;
    QTest::newRow("turns") << true;
  }

  void randomPaths() {
    QFETCH(bool, isArc);
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    std::mt19937_64 random(kSeed);
    for (int number = 0; number < kCases; ++number) {
      const terrain::ElevationGrid grid = randomGrid(random, number % 2 == 0 ? 0.0 : 0.02);
      const RandomPath path(random, isArc);
      safety::CellWalk walk(grid);
      walk.start(path.start, path.piece);
      std::vector<safety::Span> spans;
      double end = 0.0;
      for (safety::Span span; walk.next(span);) {
        VERIFY_CASE(span.from == end && span.to >= span.from)
        end = span.to;
        spans.push_back(span);
      }
      VERIFY_CASE(end == path.piece.length && !spans.empty())

      // Never below the cells that contain a point of the path, ...
      VERIFY_CASE(coversAll(grid, spans, test::fly(path.start, {path.piece}, std::max(0.05, path.piece.length / 400.0))));
      // (with the points where a turn touches a grid line among them)
      VERIFY_CASE(coversAll(grid, spans, test::fly(path.start, eighthsOf(path.piece), 1e9)));
      // ... and never above the cells within ten micrometres of it.
      for (const safety::Span& span : spans) {
        const double middle = (span.from + span.to) / 2.0;
        const auto part = test::fly(path.start, {{path.piece.turn, path.piece.radius, middle}}, std::max(1.0, middle));
        VERIFY_CASE(span.ground <= test::groundNear(grid, part.back().x, part.back().y, 1e-5))
      }
    }
  }

  void thinWall_isFoundWhereverItIsTouched_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("heading_deg");
    QTest::addColumn<int>("turn");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("length");
    QTest::addColumn<bool>("touches");
    // The wall is the cell [500, 600] x [500, 600].
    QTest::newRow("straight across") << 50.0 << 550.0 << 0.0 << 0 << 0.0 << 1500.0 << true;
    QTest::newRow("straight ending before") << 50.0 << 550.0 << 0.0 << 0 << 0.0 << 449.9 << false;
    QTest::newRow("straight ending at its edge") << 50.0 << 550.0 << 0.0 << 0 << 0.0 << 450.0 << true;
    QTest::newRow("straight along its southern edge") << 50.0 << 500.0 << 0.0 << 0 << 0.0 << 1500.0 << true;
    QTest::newRow("straight along its eastern edge") << 600.0 << 50.0 << 90.0 << 0 << 0.0 << 1500.0 << true;
    QTest::newRow("straight a millimetre beside it") << 50.0 << 499.999 << 0.0 << 0 << 0.0 << 1500.0 << false;
    QTest::newRow("diagonal through its corner only") << 400.0 << 600.0 << 45.0 << 0 << 0.0 << 400.0 << false;
    QTest::newRow("diagonal touching its corner") << 450.0 << 550.0 << 45.0 << 0 << 0.0 << 400.0 << true;
    QTest::newRow("diagonal a centimetre off its corner") << 450.0 << 550.02 << 45.0 << 0 << 0.0 << 400.0 << false;
    QTest::newRow("turn across") << 450.0 << 450.0 << 90.0 << -1 << 150.0 << 400.0 << true;
    QTest::newRow("turn clipping a corner between samples") << 841.5 << 700.0 << 90.0 << 1 << 141.5 << 880.0 << true;
    QTest::newRow("turn passing a corner by 2 cm") << 841.4 << 700.0 << 90.0 << 1 << 141.4 << 880.0 << false;
    QTest::newRow("turn touching its western edge from outside") << 500.0 << 550.0 << 90.0 << 1 << 100.0 << 600.0 << true;
    QTest::newRow("turn touching mid-way") << 300.0 << 550.0 << 270.0 << 1 << 100.0 << 400.0 << true;
    QTest::newRow("turn a millimetre beside it") << 499.999 << 550.0 << 90.0 << 1 << 100.0 << 600.0 << false;
    QTest::newRow("piece of length 0 on its corner") << 600.0 << 600.0 << 10.0 << 0 << 0.0 << 0.0 << true;
    QTest::newRow("several circles") << 300.0 << 550.0 << 270.0 << 1 << 100.0 << 5000.0 << true;
  }

  void thinWall_isFoundWhereverItIsTouched() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, heading_deg);
    QFETCH(int, turn);
    QFETCH(double, radius);
    QFETCH(double, length);
    QFETCH(bool, touches);
    const geo::Pose start{x, y, Angle::degrees(heading_deg).radians()};
    const flight::Piece piece{static_cast<flight::Turn>(turn), radius, length};
    QCOMPARE(highestUnder(wallAt(5, 5, 777.0F), start, piece), touches ? 777.0 : 0.0);
    QCOMPARE(highestUnder(wallAt(5, 5, terrain::kUnknownUpper), start, piece), touches ? kInfinity : 0.0);
  }

  /// A turn that starts where it turns round in x touches the wall at the end of every circle, not only at its start.
  void severalCirclesFromATurningPoint_touchAtEachEnd() {
    const terrain::ElevationGrid grid = wallAt(5, 5, 777.0F);
    const double circle = 2.0 * Angle::kPi * 100.0;
    safety::CellWalk walk(grid);
    walk.start({500.0, 550.0, Angle::kPi / 2.0}, {flight::Turn::Left, 100.0, 3.5 * circle});
    std::vector<bool> found(4, false);
    for (safety::Span span; walk.next(span);) {
      for (std::size_t lap = 0; lap < found.size(); ++lap) {
        const double at = static_cast<double>(lap) * circle;
        found[lap] = found[lap] || (span.from <= at + 1e-6 && span.to >= at - 1e-6 && span.ground == 777.0);
      }
    }
    QCOMPARE(found, std::vector<bool>(4, true));
  }

  void outsideAndImpossibleGround_isUnknown() {
    const flight::Piece across{flight::Turn::Straight, 0.0, 3000.0};
    QCOMPARE(highestUnder(wallAt(5, 5, 1.0F), {1000.0, 1000.0, 0.3}, across), kInfinity);
    QCOMPARE(highestUnder(wallAt(5, 5, 1.0F), {-5000.0, 1000.0, 0.0}, {flight::Turn::Straight, 0.0, 10.0}), kInfinity);
    QCOMPARE(highestUnder(wallAt(5, 5, 1.0F), {1000.0, 0.0, 0.0}, {flight::Turn::Straight, 0.0, 10.0}), kInfinity);  // along the border
    const geo::Pose over{520.0, 520.0, 0.0};
    const flight::Piece within{flight::Turn::Straight, 0.0, 30.0};
    QCOMPARE(highestUnder(wallAt(5, 5, std::nanf("")), over, within), kInfinity);
    QCOMPARE(highestUnder(wallAt(5, 5, -std::numeric_limits<float>::infinity()), over, within), kInfinity);
    QCOMPARE(highestUnder(wallAt(5, 5, -9999.0F), over, within), kInfinity);
    QCOMPARE(highestUnder(wallAt(5, 5, -400.0F), over, within), -400.0);
  }

  void farPaths_endSoon() {
    const terrain::ElevationGrid grid = wallAt(5, 5, 1.0F);
    safety::CellWalk walk(grid);
    walk.start({-900000.0, 900000.0, 0.7}, {flight::Turn::Left, 1e6, 1e6});
    int spans = 0;
    for (safety::Span span; walk.next(span);) {
      ++spans;
    }
    QVERIFY(spans < 200);
  }
};

QTEST_APPLESS_MAIN(TestCellWalk)
#include "tst_cell_walk.moc"
