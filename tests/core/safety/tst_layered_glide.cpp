// Start heights of glides whose winds and airspeeds depend on the altitude: against the equations of motion, against the hull of all winds at every
// height, and against the dearest metre of all bands that a piece meets.

#include "core/safety/descent.h"
#include "core/safety/ground_path.h"
#include "core/safety/witness_check.h"
#include "tests/core/safety/layered_cases.h"

#include <QTest>

#include <limits>

using namespace vp;

namespace {

constexpr double kClearance = 100.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Least height above what is asked for, over a whole flight begun at a height.
double leastLeft(const aircraft::AircraftProfile& profile, const std::function<test::AirThere(double)>& air, geo::Pose pose, double height,
                 const std::vector<flight::Piece>& pieces, double arrival, const terrain::ElevationGrid& grid, double& off) {
  double left = height - grid.upperAt(pose.point()) - kClearance;
  for (const flight::Piece& piece : pieces) {
    const double side = piece.turn == flight::Turn::Left ? 1.0 : piece.turn == flight::Turn::Right ? -1.0 : 0.0;
    test::MotionFlight flight(profile, air, height, pose.heading, side, piece.radius);
    const double lost = flight.fly(piece.length, [&](double flown, double lostThere) {
      left = std::min(left, height - lostThere - grid.upperAt(safety::poseOn(pose, piece, flown).point()) - kClearance);
    });
    off = std::max(off, flight.furthestOff());
    height -= lost;
    pose = safety::endOfPiece(pose, piece);
    left = std::min(left, height - grid.upperAt(pose.point()) - kClearance);
  }
  return std::min(left, height - arrival);
}

/// The start height of one piece for a height at its end, charging the dearest metre of all bands between both.
double dearest(safety::GlideRates& rates, double course, const flight::Piece& piece, double end) {
  double start = end;
  for (std::size_t rounds = 0; rounds <= rates.bandCount(); ++rounds) {
    double most = 0.0;
    for (std::size_t band = 0; band < rates.bandCount(); ++band) {
      const double bottom = band == 0 ? -kInfinity : rates.edges()[band - 1];
      const double top = band == rates.edges().size() ? kInfinity : rates.edges()[band];
      if (bottom <= start && top >= end) {
        most = std::max(most, rates.alongIn(band, course, piece).upTo(piece.length));
      }
    }
    start = end + most;
  }
  return start;
}

}  // namespace

class TestLayeredGlide : public QObject {
  Q_OBJECT

private slots:
  void equationsOfMotion_inRandomWeather_begunAtTheLowestStart_keepEverything() {
    constexpr std::uint64_t kSeed = 20261201;
    constexpr int kSets = 50;
    constexpr int kFlights = 200;
    qInfo("seed %llu, %d flights", static_cast<unsigned long long>(kSeed), kSets * kFlights);
    test::LayeredCases cases(kSeed);
    double off = 0.0;
    double nearest = kInfinity;
    int crossings = 0;
    for (int number = 0; number < kSets; ++number) {
      const mission::Plan plan = cases.plan();
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      const std::array<double, 2> radii{rates.leastGlideRadius(), rates.leastGlideRadius() * (1.0 + 2.0 * cases.unit())};
      const terrain::ElevationGrid grid = cases.ground(900.0);
      for (int i = 0; i < kFlights; ++i) {
        const geo::Pose start = cases.start();
        const std::vector<flight::Piece> pieces = cases.pieces(radii);
        const double arrival = 900.0 * cases.unit();
        const double height = safety::requiredStartHeight(start, pieces, arrival, grid, kClearance, rates);
        const auto air = cases.weather(plan.mission, cases.mass(plan.mission));
        const double left = leastLeft(plan.mission.aircraft, air, start, height, pieces, arrival, grid, off);
        nearest = std::min(nearest, left);
        for (const double edge : rates.edges()) {
          crossings += edge < height && edge > arrival ? 1 : 0;
        }
        QVERIFY2(left >= -1e-3, QString("set %1, flight %2: %3 m too low").arg(number).arg(i).arg(-left).toUtf8());
      }
    }
    qInfo("at most %.3f m off the track, nearest %.4f m, %d altitudes passed at which the loss changes", off, nearest, crossings);
    QVERIFY(off < 2.0 && crossings > kSets * kFlights / 2);
  }

  /// In a headwind that is known at every height and falls on the way down, the flight comes near the lowest start. What is left is the bound's,
  /// which takes the lift for the weight (WHY.md section 8) and of each band the strongest headwind. What the change of the wind costs is much more.
  void equationsOfMotion_inTheWorstWeather_comeNear() {
    constexpr std::uint64_t kSeed = 20261202;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    double worst = 0.0;
    double cost = 0.0;
    for (int number = 0; number < 100; ++number) {
      mission::Plan plan = cases.plan();
      plan.mission.atmosphere.reset();
      plan.mission.aircraft.leastMass_kg.reset();
      plan.mission.aircraft.mostMass_kg.reset();
      plan.mission.wind.clear();
      const double change = 0.03 * cases.unit();
      for (double altitude = 199.0; altitude < 330.0; altitude += 2.0) {  // a headwind on course 0
        const double speed = change * (altitude - 199.0);
        plan.mission.wind.push_back(test::layerOf(altitude, 90.0, 0.0, speed, speed));
      }
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      const terrain::ElevationGrid grid = cases.ground(0.0);
      const std::vector<flight::Piece> pieces{{flight::Turn::Straight, 0.0, 1000.0}};
      const double height = safety::requiredStartHeight({-500.0, 0.0, 0.0}, pieces, 200.0, grid, kClearance, rates);
      QVERIFY(height < 330.0);
      double off = 0.0;
      const auto air = cases.weather(plan.mission, plan.mission.aircraft.mass_kg);
      const double left = leastLeft(plan.mission.aircraft, air, {-500.0, 0.0, 0.0}, height, pieces, 200.0, grid, off);
      const auto steady = [&](double there) { return test::AirThere{air(there).wind, air(there).airspeed, {}}; };
      const double steadyLeft = leastLeft(plan.mission.aircraft, steady, {-500.0, 0.0, 0.0}, height, pieces, 200.0, grid, off);
      worst = std::max(worst, left / (height - 200.0));
      cost = std::max(cost, steadyLeft - left);
      QVERIFY2(left >= -1e-3 && left < 0.006 * (height - 200.0), QString("case %1: %2").arg(number).arg(left).toUtf8());
    }
    qInfo("at most %.2g of the loss above what is needed, of which the change of the wind costs up to %.1f m", worst, cost);
    QVERIFY(cost > 8.0);
  }

  void lowestStart_isNeverAboveThatOfAllWindsEverywhere_andBelowWhereLayersDiffer() {
    constexpr std::uint64_t kSeed = 20261203;
    constexpr int kSets = 40;
    constexpr int kGlides = 250;
    qInfo("seed %llu, %d glides", static_cast<unsigned long long>(kSeed), kSets * kGlides);
    test::LayeredCases cases(kSeed);
    int lower = 0;
    double most = 0.0;
    double saved = 0.0;
    double lost = 0.0;
    for (int number = 0; number < kSets; ++number) {
      const mission::Plan plan = cases.plan();
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      const std::array<double, 2> radii{rates.leastGlideRadius(), 400.0};
      const terrain::ElevationGrid grid = cases.ground(900.0);
      for (int i = 0; i < kGlides; ++i) {
        const geo::Pose start = cases.start();
        const std::vector<flight::Piece> pieces = cases.pieces(radii);
        const double arrival = 900.0 * cases.unit();
        const double layered = safety::requiredStartHeight(start, pieces, arrival, grid, kClearance, rates);
        const double hull = test::addedUp(start, pieces, arrival, grid, kClearance, rates);
        QVERIFY2(layered <= hull + 2.1e-6 * hull, QString("set %1, glide %2: %3, %4").arg(number).arg(i).arg(layered).arg(hull).toUtf8());
        if (!rates.isLayered()) {
          QVERIFY(layered == hull);  // to the bit
        }
        lower += layered < hull - 0.1 ? 1 : 0;
        most = std::max(most, hull - layered);
        saved += hull - layered;
        lost += hull - arrival;
      }
    }
    qInfo("%d lower, by up to %.1f m, %.2g of what is above the arrival", lower, most, saved / lost);
    QVERIFY(lower > kSets * kGlides / 3 && most > 10.0);
  }

  /// Without an atmosphere and with at most one layer, or within one band of the air: the sums of before, to the bit.
  void oneBand_isTheSumOfBefore_toTheBit() {
    constexpr std::uint64_t kSeed = 20261204;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    for (int number = 0; number < 40; ++number) {
      mission::Plan plan = cases.plan();
      plan.mission.wind.resize(static_cast<std::size_t>(number % 2));
      plan.sites[0].site.elevation = geo::HeightMsl::fromMetres(510.0);
      plan.tour[0].altitude = 740.0;
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      QVERIFY(!rates.isLayered());
      const terrain::ElevationGrid grid = cases.ground(900.0);
      for (int i = 0; i < 250; ++i) {
        const geo::Pose start = cases.start();
        const std::vector<flight::Piece> pieces = cases.pieces({rates.leastGlideRadius(), 400.0});
        const double arrival = 900.0 * cases.unit();
        QVERIFY(safety::requiredStartHeight(start, pieces, arrival, grid, kClearance, rates) ==
                test::addedUp(start, pieces, arrival, grid, kClearance, rates));
      }
    }
  }

  /// Layers of the same one wind are one layer.
  void sameWindInAllLayers_isOneLayer() {
    constexpr std::uint64_t kSeed = 20261205;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    for (int number = 0; number < 20; ++number) {
      mission::Plan plan = cases.plan();
      plan.mission.atmosphere.reset();
      const double from = 360.0 * cases.unit();
      const double speed = 12.0 * cases.unit();
      plan.mission.wind = {test::layerOf(0.0, from, 0.0, speed, speed)};
      safety::GlideRates one(safety::conditionsOf(plan), plan.mission.aircraft);
      plan.mission.wind = {test::layerOf(400.0, from, 0.0, speed, speed), test::layerOf(800.0, from, 0.0, speed, speed)};
      safety::GlideRates layered(safety::conditionsOf(plan), plan.mission.aircraft);
      QVERIFY(layered.isLayered());
      const terrain::ElevationGrid grid = cases.ground(900.0);
      for (int i = 0; i < 500; ++i) {
        const geo::Pose start = cases.start();
        const std::vector<flight::Piece> pieces = cases.pieces({one.leastGlideRadius(), 400.0});
        const double arrival = 900.0 * cases.unit();
        const double a = safety::requiredStartHeight(start, pieces, arrival, grid, kClearance, one);
        const double b = safety::requiredStartHeight(start, pieces, arrival, grid, kClearance, layered);
        QVERIFY2(std::abs(a - b) < 1e-8 + 4.2e-6 * (a - arrival), QString("case %1: %2 and %3").arg(i).arg(a).arg(b).toUtf8());
      }
    }
  }

  /// What a planner may count with a table over all bands between both ends of a piece is never less.
  void dearestMetreOfAllBandsBetween_isNeverCheaper() {
    constexpr std::uint64_t kSeed = 20261206;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    int lower = 0;
    for (int number = 0; number < 100; ++number) {
      const mission::Plan plan = cases.plan();
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      for (int i = 0; i < 100; ++i) {
        const flight::Piece piece{flight::Turn::Straight, 0.0, 6000.0 * cases.unit()};
        const double course = 6.0 * cases.unit();
        const double end = 1500.0 * cases.unit();
        const double found = safety::Descent(rates, course, piece).up(piece.length, end, 0.0);
        const double dear = dearest(rates, course, piece, end);
        QVERIFY2(found <= dear + 1e-9 * dear, QString("%1, %2").arg(found).arg(dear).toUtf8());
        lower += found < dear - 0.1 ? 1 : 0;
      }
    }
    QVERIFY(lower > 1000);
  }

  /// Down from the lowest start leads to exactly what was asked for, up again to where it began, and who begins higher stays higher.
  void heights_goDownAndUpTheSameWay() {
    constexpr std::uint64_t kSeed = 20261207;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    for (int number = 0; number < 30; ++number) {
      const mission::Plan plan = cases.plan();
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      for (int i = 0; i < 400; ++i) {
        const flight::Piece piece{static_cast<flight::Turn>(cases.below(3) - 1), rates.leastGlideRadius(), 3000.0 * cases.unit()};
        safety::Descent descent(rates, 12.0 * cases.unit() - 6.0, piece);
        const double from = piece.length * cases.unit();
        const double to = from + (piece.length - from) * cases.unit();
        const double height = cases.below(4) == 0 && rates.isLayered() ? rates.edges().front() : 3000.0 * cases.unit();
        const double end = descent.down(from, height, to);
        QVERIFY(std::abs(descent.up(to, end, from) - height) < 1e-6);
        QVERIFY(end <= height && descent.down(from, height + 1.0, to) > end);
        const double middle = 0.5 * (from + to);
        QVERIFY(std::abs(descent.down(middle, descent.down(from, height, middle), to) - end) < 1e-6);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestLayeredGlide)
#include "tst_layered_glide.moc"
