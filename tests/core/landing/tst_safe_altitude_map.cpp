// The values of the safe-altitude map hold for whole cells: random places and courses in random cells are flown by an oracle.
#include "core/flight/dubins.h"
#include "core/landing/build_roadmap.h"
#include "core/landing/safe_altitude_map.h"
#include "tests/support/mountain.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace vp;
using namespace vp::landing;

namespace {

constexpr double kPi = Angle::kPi;

std::shared_ptr<const Roadmap> roadmapOf(const World& world) {
  RoadmapRequest request;
  request.area = world.terrain.grid().extent();
  return *buildRoadmap(world, mission::PlannerSettings{}, request, Job{});
}

MapRequest requestFor(const geo::Box& area, double cell, int courses) {
  MapRequest request;
  request.area = area;
  request.cell = cell;
  request.courseRange = kPi / courses;
  for (int h = 0; h < courses; ++h) {
    request.headings.push_back(2.0 * kPi * h / courses);
  }
  return request;
}

/// Altitude that a path needs at its start, by flying it in steps of 5 m: what lies within 5 m of a step counts as crossed.
double needOf(const World& world, const geo::Pose& start, const std::vector<flight::Piece>& pieces, double siteElevation) {
  const std::vector<test::FlownPoint> points = test::fly(start, pieces, 5.0);
  double lost = 0.0;
  double need = 0.0;
  double before = 0.0;
  for (const test::FlownPoint& point : points) {
    const flight::Piece& piece = pieces[point.piece];
    lost += (point.distance - before) * (piece.turn == flight::Turn::Straight ? world.glide.straightLoss() : world.glide.lossAt(piece.radius));
    before = point.distance;
    need = std::max(need, test::groundNear(world.terrain.grid(), point.x, point.y, 0.0) + world.clearance + lost);
  }
  return std::max(need, siteElevation + world.arrivalMargin + lost);
}

flight::Piece arc(double turn, double radius) {
  return {turn >= 0.0 ? flight::Turn::Left : flight::Turn::Right, radius, std::abs(turn) * radius};
}

geo::Pose after(const geo::Pose& start, const flight::Piece& piece) {
  const test::FlownPoint end = test::fly(start, {piece}, 1e9).back();
  return {end.x, end.y, end.heading};
}

/// The least need of the ways that the map promises, flown from one place on one course towards the poses of its cell.
double bestNeed(const World& world, const Roadmap& roadmap, const geo::Pose& place, const geo::Pose& start, double spread) {
  const flight::Piece straight{flight::Turn::Straight, 0.0, world.reactionLength};  // while the pilot reacts
  const geo::Pose centre = after(place, straight);
  const geo::Pose from = after(start, straight);
  const std::vector<double>& radii = world.glide.glideRadii();
  const double r =
      *std::min_element(radii.begin(), radii.end(), [&](double a, double b) { return a * world.glide.lossAt(a) < b * world.glide.lossAt(b); });
  const double least = spread < 2.0 * r ? std::sqrt(4.0 * r * spread - spread * spread) : 2.0 * r;
  const double distance = spread + 1.25 * least;
  double best = std::numeric_limits<double>::infinity();
  QueryScratch scratch;
  for (const double turn : {0.0, kPi / 2.0, -kPi / 2.0, kPi, -kPi}) {
    const flight::Piece onto = arc(centre.heading - from.heading, r);
    const flight::Piece around = arc(turn, r);
    const geo::Pose begin = after(after(from, onto), around);
    const geo::Pose middle = after(centre, around);
    const geo::Pose end{middle.x + distance * std::cos(middle.heading), middle.y + distance * std::sin(middle.heading), middle.heading};
    const std::optional<SafeAltitude> answer = roadmap.queryTurning(world, end, scratch);
    if (!answer) {
      continue;
    }
    for (const flight::Word word : {flight::Word::LSR, flight::Word::RSL}) {
      const std::optional<flight::DubinsPath> s = flight::dubinsWord(begin, end, r, word);
      if (!s || s->lengths[0] > 2.0 * r || s->lengths[2] > 2.0 * r) {
        continue;  // the other of the two S-curves
      }
      std::vector<flight::Piece> pieces{straight, onto, around, s->piece(0), s->piece(1), s->piece(2)};
      const std::vector<flight::Piece> rest = roadmap.witnessPieces(*answer);
      pieces.insert(pieces.end(), rest.begin(), rest.end());
      const double elevation = world.sites[static_cast<std::size_t>(answer->site)].site.elevation.metres();
      best = std::min(best, needOf(world, start, pieces, elevation) + world.reactionLoss);
    }
  }
  return best;
}

}  // namespace

class TestSafeAltitudeMap : public QObject {
  Q_OBJECT

private slots:
  void cell_anyPlaceAndCourseInIt_isSafeAtItsValue_data() {
    QTest::addColumn<double>("cell");
    QTest::addColumn<int>("courses");
    QTest::addColumn<double>("reaction");
    QTest::newRow("50 m, 16 courses") << 50.0 << 16 << 0.0;
    QTest::newRow("100 m, 8 courses") << 100.0 << 8 << 0.0;
    QTest::newRow("300 m, 8 courses") << 300.0 << 8 << 0.0;
    QTest::newRow("100 m, 16 courses, 200 m to react") << 100.0 << 16 << 200.0;
  }
  void cell_anyPlaceAndCourseInIt_isSafeAtItsValue() {
    QFETCH(double, cell);
    QFETCH(int, courses);
    QFETCH(double, reaction);
    World world = test::mountainWorld();
    world.reactionLength = reaction;
    world.reactionLoss = 0.1 * reaction;
    const auto roadmap = roadmapOf(world);
    const unsigned seed = 8150;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int known = 0;
    std::vector<double> surplus;
    for (int i = 0; i < 3500; ++i) {  // three rows: 10,500
      const double x = -2400.0 + 4800.0 * unit(random);
      const double y = -2400.0 + 4800.0 * unit(random);
      MapRequest request = requestFor({x, y, x + cell, y + cell}, cell, courses);
      request.headings = {2.0 * kPi * unit(random)};
      const Result<SafeAltitudeMap> map = safeAltitudeMap(world, *roadmap, request, Job{});
      QVERIFY(map.has_value());
      const auto value = static_cast<double>(map->need[0][0]);
      if (!std::isfinite(value)) {
        continue;
      }
      ++known;
      const geo::Pose centre{x + 0.5 * cell, y + 0.5 * cell, request.headings[0]};
      const auto edge = [&](double u) { return u < 0.1 ? 0.0 : u > 0.9 ? 1.0 : u; };  // corners and edges too
      const geo::Pose from{x + cell * edge(unit(random)), y + cell * edge(unit(random)),
                           request.headings[0] + request.courseRange * (2.0 * edge(unit(random)) - 1.0)};
      const double r = 2.0 * [&] {
        const std::vector<double>& radii = world.glide.glideRadii();
        return *std::min_element(radii.begin(), radii.end(),
                                 [&](double a, double b) { return a * world.glide.lossAt(a) < b * world.glide.lossAt(b); });
      }();
      const double spread = std::sqrt(0.5) * cell + (r + 2.0 * reaction) * std::sin(0.5 * request.courseRange);
      const double need = bestNeed(world, *roadmap, centre, from, spread);
      QVERIFY2(need <= value + 1e-3, qPrintable(QString("case %1: needs %2, the map says %3").arg(i).arg(need).arg(value)));
      QueryScratch scratch;
      const std::optional<SafeAltitude> there = roadmap->query(world, from, scratch);
      if (there) {
        surplus.push_back(value - there->altitude);
      }
    }
    QVERIFY(known > 1000);
    std::sort(surplus.begin(), surplus.end());
    qInfo("%d cells, above the query at the place itself: median %.0f m, nine tenths below %.0f m", known, surplus[surplus.size() / 2],
          surplus[surplus.size() * 9 / 10]);
  }

  void worstAndBest_areThoseOfTheCourses() {
    const World world = test::mountainWorld();
    const auto roadmap = roadmapOf(world);
    const Result<SafeAltitudeMap> map = safeAltitudeMap(world, *roadmap, requestFor({-2000.0, -2000.0, -1000.0, -1000.0}, 250.0, 8), Job{});
    QVERIFY(map.has_value());
    const std::vector<float> worst = map->worst();
    const std::vector<float> best = map->best();
    for (std::size_t i = 0; i < worst.size(); ++i) {
      float highest = map->need[0][i];
      float lowest = highest;
      for (const std::vector<float>& need : map->need) {
        highest = std::max(highest, need[i]);
        lowest = std::min(lowest, need[i]);
      }
      QCOMPARE(worst[i], highest);
      QCOMPARE(best[i], lowest);
    }
  }

  void map_doesNotDependOnThreads() {
    const World world = test::mountainWorld();
    const auto roadmap = roadmapOf(world);
    MapRequest request = requestFor({-1500.0, -1500.0, 1500.0, 1500.0}, 300.0, 4);
    const Result<SafeAltitudeMap> one = safeAltitudeMap(world, *roadmap, request, Job{});
    request.threads = 3;
    const Result<SafeAltitudeMap> three = safeAltitudeMap(world, *roadmap, request, Job{});
    QCOMPARE(one->need, three->need);
  }

  void unknownGround_hasNoValue() {
    const World world = test::mountainWorld();
    const auto roadmap = roadmapOf(world);
    const Result<SafeAltitudeMap> map = safeAltitudeMap(world, *roadmap, requestFor({2400.0, 0.0, 2700.0, 100.0}, 100.0, 4), Job{});
    QVERIFY(std::isinf(map->worst()[2]));  // beyond the terrain
  }

  void nonsense_isRefused() {
    const World world = test::mountainWorld();
    const auto roadmap = roadmapOf(world);
    QVERIFY(!safeAltitudeMap(world, *roadmap, requestFor({}, 100.0, 8), Job{}).has_value());
    QVERIFY(!safeAltitudeMap(world, *roadmap, requestFor({0.0, 0.0, 1e6, 1e6}, 100.0, 8), Job{}).has_value());
    QVERIFY(!safeAltitudeMap(world, *roadmap, requestFor({0.0, 0.0, 100.0, 100.0}, 1.0, 8), Job{}).has_value());
  }

  void stop_isHeard() {
    const World world = test::mountainWorld();
    const auto roadmap = roadmapOf(world);
    std::stop_source stop;
    const Job job(stop.get_token(), [&](double, std::string_view) { stop.request_stop(); });
    const Result<SafeAltitudeMap> map = safeAltitudeMap(world, *roadmap, requestFor({-2000.0, -2000.0, 2000.0, 2000.0}, 20.0, 8), job);
    QVERIFY(!map.has_value());
    QCOMPARE(map.error().code, Errc::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestSafeAltitudeMap)
#include "tst_safe_altitude_map.moc"
