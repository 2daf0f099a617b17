// Fast marching trees on problems whose optimum is known: a plane with a wall and one gap, boxes with a wall, flat ground, terrain with a wall; and
// what the planners made of them do when they are stopped, early or for good.
#include "core/emergency/box_route.h"
#include "core/emergency/fmt_planner.h"
#include "core/emergency/fmt_star.h"
#include "core/emergency/landing_outcome.h"
#include "core/emergency/planners.h"
#include "core/emergency/sample_buckets.h"
#include "core/emergency/verified_answer.h"
#include "tests/support/landing_optima.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <stop_token>

using namespace vp;
using namespace vp::emergency;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The unit square; start at the middle of its west side, goal at the middle of the east side, a wall at x = 0.5 with a gap.
class Square final : public FmtSpace {
public:
  Square(std::size_t samples, double gapLow, double gapHigh, std::uint64_t seed) : points_(drawn(samples, seed)), low_(gapLow), high_(gapHigh) {}

  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  void near(int node, std::vector<int>& found) const override { buckets_.near(node, found); }
  [[nodiscard]] double arrival(int /*parent*/, int from, double cost, int to) const override { return cost + apart(from, to); }
  [[nodiscard]] bool isFree(int from, double /*cost*/, int to, double /*arrival*/) const override {
    const Point3& a = points_[static_cast<std::size_t>(from)];
    const Point3& b = points_[static_cast<std::size_t>(to)];
    if ((a.x - 0.5) * (b.x - 0.5) > 0.0) {
      return true;
    }
    const double y = a.y + (b.y - a.y) * (0.5 - a.x) / (b.x - a.x);
    return y > low_ && y < high_;
  }
  [[nodiscard]] bool isGoal(int node) const override { return node == 1; }
  [[nodiscard]] double apart(int a, int b) const {
    const Point3& p = points_[static_cast<std::size_t>(a)];
    const Point3& q = points_[static_cast<std::size_t>(b)];
    return std::hypot(q.x - p.x, q.y - p.y);
  }

private:
  static std::vector<Point3> drawn(std::size_t samples, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
    std::vector<Point3> points{{0.0, 0.5, 0.0}, {1.0, 0.5, 0.0}};
    while (points.size() < samples + 2) {
      const double x = unit();
      points.push_back({x, unit(), 0.0});
    }
    return points;
  }

  std::vector<Point3> points_;
  double low_;
  double high_;
  SampleBuckets buckets_{points_, fmtRadius(2, 1.0, points_.size())};
};

LandingRequest wallRequest(double south, double north) {
  return test::landingRequest(test::landingMission(test::oneBankCessna()), {test::placedSite("B/09", {2500.0, -1000.0, 0.0}, 0.0)},
                              test::wallGrid(south, north), {-2500.0, -500.0, 0.3}, 1500.0);
}

LandingRequest mountain(double altitude = 900.0) {
  return test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, altitude);
}

}  // namespace

class TestFmtStar : public QObject {
  Q_OBJECT

private slots:
  void buckets_findWhatBruteForceFinds() {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Point3> points;
    for (int i = 0; i < 800; ++i) {
      points.push_back({100.0 * unit(engine), 30.0 * unit(engine), i % 2 == 0 ? 0.0 : 10.0 * unit(engine)});
    }
    for (const double reach : {0.5, 7.0, 40.0, 500.0}) {
      const SampleBuckets buckets(points, reach);
      for (int i = 0; i < 800; i += 7) {
        std::vector<int> found;
        buckets.near(i, found);
        std::sort(found.begin(), found.end());
        std::vector<int> known;
        const Point3& p = points[static_cast<std::size_t>(i)];
        for (int j = 0; j < 800; ++j) {
          const Point3& q = points[static_cast<std::size_t>(j)];
          const double apart = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) + (q.z - p.z) * (q.z - p.z);
          if (j != i && apart <= reach * reach) {
            known.push_back(j);
          }
        }
        QVERIFY(found == known);
      }
    }
  }

  void wallWithOneGap_isPassedThroughTheGapNearTheOptimum() {
    constexpr double kLow = 0.85;
    constexpr double kHigh = 0.95;
    const double optimum = 2.0 * std::hypot(0.5, kLow - 0.5);
    double before = kInfinite;
    for (const std::size_t samples : {500, 4000, 16'000}) {
      double worst = 0.0;
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Square square(samples, kLow, kHigh, seed);
        FmtStar tree(square);
        QCOMPARE(tree.next(kInfinite), 1);
        const std::vector<int> way = tree.wayTo(1);
        QVERIFY(way.front() == 0 && way.back() == 1);
        double length = 0.0;
        for (std::size_t i = 1; i < way.size(); ++i) {
          QVERIFY(square.isFree(way[i - 1], 0.0, way[i], 0.0));
          length += square.apart(way[i - 1], way[i]);
        }
        QVERIFY(std::abs(length - tree.costOf(1)) < 1e-9 && length >= optimum - 1e-9);
        worst = std::max(worst, length / optimum - 1.0);
      }
      // the error falls as samples grow dense
      QVERIFY2(worst < before && worst < (samples == 500 ? 0.20 : samples == 4000 ? 0.08 : 0.05), qPrintable(QString::number(worst)));
      before = worst;
    }
  }

  void wallWithoutGap_givesNone() {
    const Square square(2000, 2.0, 3.0, 1);
    FmtStar tree(square);
    QCOMPARE(tree.next(kInfinite), -1);
    QVERIFY(tree.counts().visited > 500);  // all of the western half
  }

  void dearerThanAllowed_givesNone() {
    const Square square(2000, 0.0, 1.0, 1);
    FmtStar tree(square);
    QCOMPARE(tree.next(0.9), -1);
    QCOMPARE(FmtStar(square).next(1.2), 1);
  }

  void stopped_endsTheTree() {
    const Square square(20'000, 0.0, 1.0, 1);
    int asked = 0;
    FmtStar tree(square, [&asked] { return ++asked > 3; });
    QCOMPARE(tree.next(kInfinite), -1);
    QVERIFY(asked == 4 && tree.counts().visited < 10'000);
  }

  void boxRoute_throughTheGapOfAWall_isNearTheOptimum() {
    // a wall across 1000 x 1000 x 1000 with one gap, 100 x 100 cells wide
    const CellBox box{{}, {1.0, 1.0, 1.0}, {1000, 1000, 1000}};
    const Cuboid all{{}, {1000.0, 1000.0, 1000.0}};
    const std::vector<Cuboid> walls{{{490.25, 0.0, 0.0}, {509.75, 599.75, 1000.0}},
                                    {{490.25, 700.25, 0.0}, {509.75, 1000.0, 1000.0}},
                                    {{490.25, 600.0, 0.0}, {509.75, 700.0, 449.75}},
                                    {{490.25, 600.0, 550.25}, {509.75, 700.0, 1000.0}}};
    const LinearOctree octree = *LinearOctree::build(box, {}, walls, Job());
    const auto isFree = [&octree](const Point3& a, const Point3& b) { return octree.isFree(a, b); };
    // in the plane z = 500, along the edges of the gap
    const double optimum = 2.0 * std::hypot(240.0, 100.0) + 20.0;
    BoxRouteOptions options;
    options.first = 3000;
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      options.seed = seed;
      const auto route = boxRoute(all, {250.0, 500.0, 500.0}, {750.0, 500.0, 500.0}, isFree, options);
      QVERIFY(route.has_value());
      double length = 0.0;
      for (std::size_t i = 1; i < route->points.size(); ++i) {
        QVERIFY(octree.isFree(route->points[i - 1], route->points[i]));
        length += std::hypot(route->points[i].x - route->points[i - 1].x, route->points[i].y - route->points[i - 1].y,
                             route->points[i].z - route->points[i - 1].z);
      }
      QVERIFY(std::abs(length - route->length) < 1e-6 && length >= optimum - 1e-6);
      QVERIFY2(length <= 1.05 * optimum, qPrintable(QString::number(length / optimum)));
      sum += length / optimum - 1.0;
      const auto again = boxRoute(all, {250.0, 500.0, 500.0}, {750.0, 500.0, 500.0}, isFree, options);
      QVERIFY(again && again->points == route->points);
    }
    QVERIFY2(sum / 10.0 < 0.02, qPrintable(QString::number(sum / 10.0)));
  }

  void boxRoute_withoutAWay_isNone() {
    const LinearOctree octree = *LinearOctree::build({{}, {1.0, 1.0, 1.0}, {100, 100, 100}}, {}, {{{50.2, 0.0, 0.0}, {50.8, 100.0, 100.0}}}, Job());
    const auto isFree = [&octree](const Point3& a, const Point3& b) { return octree.isFree(a, b); };
    QVERIFY(!boxRoute({{}, {100.0, 100.0, 100.0}}, {10.0, 50.0, 50.0}, {90.0, 50.0, 50.0}, isFree, {}));
    const auto straight = boxRoute({{}, {100.0, 100.0, 100.0}}, {10.0, 50.0, 50.0}, {45.0, 60.0, 50.0}, isFree, {});
    QVERIFY(straight && std::abs(straight->length - std::hypot(35.0, 10.0)) < 1e-9);  // straight on, nothing left to shorten
  }

  void planners_haveTheirNames() {
    const std::vector<std::string> names = plannerNames();
    for (const char* name : {"fmt", "fmt-octree"}) {
      QVERIFY(std::find(names.begin(), names.end(), name) != names.end());
      QCOMPARE(makePlanner(name)->name(), std::string_view(name));
    }
  }

  void flatGround_givesTheClosedForm_data() { kinds(); }
  void flatGround_givesTheClosedForm() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 20; ++i) {
      const geo::Pose from{4000.0 * unit(random), 4000.0 * unit(random), Angle::kPi * unit(random)};
      const LandingRequest request = test::landingRequest(test::landingMission(test::oneBankCessna()),
                                                          {test::placedSite("A/09", {500.0, -300.0, 0.4}, 0.0)}, test::flatGrid(), from, 1500.0);
      const LandingAnswer answer = planner().plan(request);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      const double known = 1500.0 - 100.0 - test::closedForm(*request.world, from, request.world->sites[0].pose);  // 100 m clearance at the threshold
      QVERIFY2(std::abs(answer.heightInHand - known) < 0.01, qPrintable(QString::number(answer.heightInHand - known)));
      QVERIFY(verifiedAnswer(request, answer).verified);
    }
  }

  void wall_isPassedThroughItsGapNearTheLeastLoss_data() { kinds(); }
  void wall_isPassedThroughItsGapNearTheLeastLoss() {
    constexpr double kSouth = 1500.0;
    constexpr double kNorth = 1900.0;
    LandingRequest request = wallRequest(kSouth, kNorth);
    const landing::Approach approach = *landing::approachTo(*request.world, 0);
    const double known = test::bestThroughGap(request, approach, kSouth + 20.0, kNorth - 20.0);
    for (request.seed = 1; request.seed <= 5; ++request.seed) {
      const LandingAnswer answer = planner().plan(request);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      const double lost = 1500.0 - answer.heightInHand - approach.altitude;
      QVERIFY2(lost <= 1.02 * known && lost >= 0.97 * known, qPrintable(QString("%1 m lost, %2 m known").arg(lost).arg(known)));
      QVERIFY(answer.lowerBound && *answer.lowerBound <= answer.cost() + 1e-9);
      int crossings = 0;
      std::vector<flight::Piece> pieces;
      for (const mission::LandingLeg& leg : answer.path->legs) {
        pieces.push_back(leg.piece);
      }
      for (const test::FlownPoint& point : test::fly(answer.path->start, pieces, 2.0)) {
        crossings += std::abs(point.x) <= 10.0 ? 1 : 0;
        QVERIFY(std::abs(point.x) > 10.0 || (point.y > kSouth && point.y < kNorth));
      }
      QVERIFY(crossings > 0);
      QVERIFY(verifiedAnswer(request, answer).verified);
    }
  }

  void wallWithoutAGap_isSaidWithTheLongestGlide_data() { kinds(); }
  void wallWithoutAGap_isSaidWithTheLongestGlide() {
    LandingRequest request = wallRequest(9000.0, 9001.0);
    request.deadline = 1.0;
    const LandingAnswer answer = planner().plan(request);
    QVERIFY(!answer.reachesRunway() && answer.path && answer.path->site == -1);
    QVERIFY2(QByteArray::fromStdString(answer.whyNot).contains("stays clear of the ground"), answer.whyNot.c_str());
  }

  void faults_areSaid_data() { kinds(); }
  void faults_areSaid() {
    LandingRequest request = mountain();
    request.deadline = 0.0;
    QVERIFY2(QByteArray::fromStdString(planner().plan(request).whyNot).contains("deadline"), "deadline");
    request = mountain(10.0);
    QVERIFY(!planner().plan(request).path);
    request = wallRequest(1500.0, 1900.0);
    request.altitude = 300.0;
    const LandingAnswer tooLow = planner().plan(request);
    QVERIFY(!tooLow.reachesRunway() && tooLow.missing > 0.0 && tooLow.path && tooLow.path->site == -1);
  }

  void mountain_isFlownAroundAndAccepted_data() { kinds(); }
  void mountain_isFlownAroundAndAccepted() {
    std::mt19937_64 random(44);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int landings = 0;
    for (int i = 0; i < 30; ++i) {
      LandingRequest request = mountain();
      request.pose = {2300.0 * unit(random), 2300.0 * unit(random), Angle::kPi * unit(random)};
      request.altitude = request.world->terrain.grid().upperAt(request.pose.point()) + 300.0;
      const LandingAnswer answer = planner().plan(request);
      landings += answer.reachesRunway() ? 1 : 0;
      QVERIFY(answer.path);
      const LandingAnswer judged = verifiedAnswer(request, answer);
      QVERIFY2(judged.verified, judged.whyNot.c_str());
      QVERIFY(answer.reachesRunway() == answer.whyNot.empty());
    }
    QVERIFY2(landings >= 20, qPrintable(QString::number(landings)));
  }

  void sameSeed_givesTheSamePath_data() { kinds(); }
  void sameSeed_givesTheSamePath() {
    LandingRequest request = wallRequest(1500.0, 1900.0);
    const LandingAnswer first = planner().plan(request);
    const LandingAnswer second = planner().plan(request);
    QVERIFY(first.path && *first.path == *second.path && first.seed == 1);
    request.seed = 2;
    QVERIFY(*planner().plan(request).path != *first.path);
  }

  void stopped_returnsTheBestSoFarWithin100ms_data() { kinds(); }
  void stopped_returnsTheBestSoFarWithin100ms() {
    LandingRequest request = mountain();
    std::stop_source stop;
    request.job = Job(stop.get_token());
    double first = -1.0;
    request.better = [&](const LandingAnswer& answer) {
      first = answer.heightInHand;
      stop.request_stop();
    };
    const auto begin = std::chrono::steady_clock::now();
    const LandingAnswer answer = planner().plan(request);
    QVERIFY(answer.reachesRunway() && answer.heightInHand == first);
    QVERIFY(std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(100));
  }

  void deadline_isKept_data() { kinds(); }
  void deadline_isKept() {
    QFETCH(bool, octree);
    FmtOptions options = octree ? FmtOptions{} : FmtPlanner::plain();
    options.first = 100'000;
    LandingRequest request = wallRequest(9000.0, 9001.0);
    request.deadline = 0.15;
    const LandingAnswer answer = FmtPlanner(options).plan(request);
    QVERIFY2(answer.seconds < 0.35, qPrintable(QString::number(answer.seconds)));
  }

private:
  static void kinds() {
    QTest::addColumn<bool>("octree");
    QTest::newRow("fmt") << false;
    QTest::newRow("fmt-octree") << true;
  }
  static FmtPlanner planner() {
    QFETCH(bool, octree);
    return FmtPlanner(octree ? FmtOptions{} : FmtPlanner::plain());
  }
};

QTEST_APPLESS_MAIN(TestFmtStar)
#include "tst_fmt_star.moc"
