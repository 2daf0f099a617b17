// What sinking through a wind that changes with height costs: the bound against accelerations over ground, in winds, shears and turns of every
// direction, and the difference of two layers against a grid of their winds.

#include "core/safety/glide_rates.h"
#include "core/safety/wind_shear.h"
#include "tests/core/safety/layered_cases.h"
#include "tests/support/wind_flight.h"

#include <QTest>

#include <limits>

using namespace vp;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The Cessna's shape with another glide ratio, half of its drag induced.
aircraft::AircraftProfile withGlideRatio(double ratio) {
  aircraft::AircraftProfile profile = test::cessna();
  const double v = profile.bestGlideSpeed.si();
  const double share = 0.5 * profile.airDensity_kgm3 * v * v * profile.wingArea_m2 / (profile.mass_kg * kGravity.si());
  profile.zeroLiftDrag = 0.5 / ratio / share;
  profile.inducedDrag = 0.5 / ratio * share;
  return profile;
}

struct Shear {
  double strongest = 0.0;
  double most = 0.0;
};

/// Greatest of what is lost over what the bound says, over random winds, changes of the wind, courses and turns that the aircraft may fly.
double closest(test::WindCases& cases, const aircraft::AircraftProfile& profile, const Shear& shear, int count, double& lossWithout) {
  const safety::PlanConditions conditions = safety::conditionsOf(profile, {});
  const double v = profile.bestGlideSpeed.si();
  const safety::ShearCost cost = safety::shearCost(profile, conditions, {v, v}, shear.strongest, shear.most);
  if (!cost.isGlide()) {
    return 0.0;
  }
  const safety::WindGlide glide(profile, conditions, v, cost);
  const safety::WindGlide energyAlone(profile, conditions, v, {cost.straight, cost.straight, 1.0});
  const double least = (v + shear.strongest) * (v + shear.strongest) / (9.80665 * std::sqrt(3.0));
  double most = 0.0;
  for (int i = 0; i < count; ++i) {
    const double off = 2.0 * Angle::kPi * cases.unit();
    const double strength = cases.below(2) == 0 ? shear.strongest : shear.strongest * cases.unit();
    const test::SteadyWind wind{strength * std::cos(off), strength * std::sin(off)};
    const double to = 2.0 * Angle::kPi * cases.unit();
    const double changes = cases.below(2) == 0 ? shear.most : shear.most * cases.unit();
    const test::SteadyWind change{changes * std::cos(to), changes * std::sin(to)};
    const double radius = cases.below(4) == 0 ? 0.0 : least * std::pow(20.0, cases.unit());
    const double course = 2.0 * Angle::kPi * cases.unit();
    const double lost = test::lossInWind(test::polarOf(profile), wind, change, course, cases.below(2) == 0 ? 1.0 : -1.0, radius);
    const double along = wind.east * std::cos(course) + wind.north * std::sin(course);
    const double across = wind.north * std::cos(course) - wind.east * std::sin(course);
    const auto boundOf = [&](const safety::WindGlide& one) {
      return radius > 0.0 ? one.lossInTurn(along, across, radius) : one.lossAt(one.straightSine(), along, across);
    };
    most = std::max(most, lost / boundOf(glide));
    lossWithout = std::max(lossWithout, lost / boundOf(energyAlone));
  }
  return most;
}

}  // namespace

class TestWindShear : public QObject {
  Q_OBJECT

private slots:
  void accelerationsOverGround_inEveryWindAndShear_loseNoMoreThanTheBound_data() {
    QTest::addColumn<double>("ratio");
    QTest::newRow("Cessna 172") << 11.7;
    QTest::newRow("motor glider") << 27.0;
    QTest::newRow("sailplane") << 60.0;
  }

  void accelerationsOverGround_inEveryWindAndShear_loseNoMoreThanTheBound() {
    constexpr std::uint64_t kSeed = 20270101;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    QFETCH(double, ratio);
    test::WindCases cases(kSeed);
    const aircraft::AircraftProfile profile = withGlideRatio(ratio);
    const double v = profile.bestGlideSpeed.si();
    double most = 0.0;
    double energyAlone = 0.0;
    for (int set = 0; set < 100; ++set) {
      const Shear shear{0.7 * v * cases.unit(), 0.5 * cases.unit() * 9.80665 / v};
      most = std::max(most, closest(cases, profile, shear, 400, energyAlone));
    }
    qInfo("at most %.6f of the bound, %.6f of that of the energy alone", most, energyAlone);
    QVERIFY2(most <= 1.0 + 1e-9, QString::number(most, 'g', 12).toUtf8());
    QVERIFY(most > 0.99);
    QVERIFY(ratio < 20.0 || energyAlone > 1.0 + 1e-6);  // the force to the side is not covered by what the bound leaves out elsewhere
  }

  /// Straight into a headwind that falls on the way down: s = v S / (1 - v W'/g).
  void headwindThatFalls_byHand() {
    const aircraft::AircraftProfile profile = test::cessna();
    const double share = 33.4 * 0.02 / 9.80665;
    const safety::ShearCost cost = safety::shearCost(profile, safety::conditionsOf(profile, {}), {33.4, 33.4}, 5.0, 0.02);
    QVERIFY(cost.straight == 1.0 / (1.0 - share) && cost.turn == cost.straight && cost.least == 1.0 / (1.0 + share));
    const double still = test::lossInWind(test::polarOf(profile), {}, 0.0, 0.0);
    const double lost = test::lossInWind(test::polarOf(profile), {}, {-0.02, 0.0}, 0.0, 1.0, 0.0);
    QVERIFY(lost > 1.065 * still && lost <= still * cost.straight * (1.0 + still * still));
    QVERIFY(test::lossInWind(test::polarOf(profile), {}, {0.02, 0.0}, 0.0, 1.0, 0.0) > still * cost.least * (1.0 - still * still));
  }

  void noShear_changesNothing_toTheBit() {
    const aircraft::AircraftProfile profile = test::cessna();
    const safety::ShearCost cost = safety::shearCost(profile, safety::conditionsOf(profile, {}), {33.4, 33.4}, 15.0, 0.0);
    QVERIFY(cost.straight == 1.0 && cost.turn == 1.0 && cost.least == 1.0 && cost.isGlide());
  }

  void shearThatNoGlideCanSinkThrough_hasNoCost() {
    const aircraft::AircraftProfile profile = test::cessna();
    const safety::PlanConditions conditions = safety::conditionsOf(profile, {});
    QVERIFY(!safety::shearCost(profile, conditions, {33.4, 33.4}, 5.0, 9.80665 / 33.4).isGlide());
    QVERIFY(!safety::shearCost(profile, conditions, {33.4, 33.4}, 5.0, 0.9 * 9.80665 / 33.4).isGlide());  // what is left does not bank by 60 degrees
    QVERIFY(safety::shearCost(profile, conditions, {33.4, 33.4}, 5.0, 0.5 * 9.80665 / 33.4).isGlide());
    QVERIFY(safety::shearCost(profile, conditions, {33.4, 33.4}, 5.0, kInfinity).straight == kInfinity);
  }

  void differenceOfTwoLayers_isThatOfTheirFurthestWinds() {
    constexpr std::uint64_t kSeed = 20270102;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    double loosest = 0.0;
    for (int number = 0; number < 10000; ++number) {
      const air::WindSector a = cases.layer(0.0).wind;
      const air::WindSector b = cases.layer(0.0).wind;
      const double found = test::LayeredCases::furthestApart(a, b);
      const double bound = safety::greatestDifference(a, b);
      QVERIFY2(bound >= found * (1.0 - 1e-12), QString("case %1: %2, found %3").arg(number).arg(bound).arg(found).toUtf8());
      QVERIFY(bound <= found * 1.04 + 1e-9);  // the grid has a wind every 30 degrees
      QVERIFY(std::abs(safety::greatestDifference(b, a) - bound) < 1e-12 * (1.0 + bound));
      loosest = std::max(loosest, bound / std::max(1e-9, found) - 1.0);
    }
    qInfo("at most %.2g above what a grid finds", loosest);
    QVERIFY(std::abs(safety::greatestDifference({90.0, 0.0, 4.0, 4.0}, {270.0, 0.0, 3.0, 3.0}) - 7.0) < 1e-12);
    QVERIFY(std::abs(safety::shearBetween(test::layerOf(100.0, 0.0, 0.0, 3.0, 3.0), test::layerOf(300.0, 90.0, 0.0, 0.0, 4.0)) - 0.025) < 1e-15);
  }

  /// Each band has the shear of the layers around it, wherever the air cuts it; none below the lowest and above the highest layer.
  void bands_haveTheShearOfTheirLayers() {
    mission::Plan plan;
    plan.mission.aircraft = test::cessna();
    plan.mission.atmosphere = air::Atmosphere{};
    plan.mission.wind = {test::layerOf(300.0, 90.0, 0.0, 0.0, 0.0), test::layerOf(800.0, 90.0, 0.0, 5.0, 5.0),
                         test::layerOf(1000.0, 270.0, 0.0, 1.0, 5.0)};
    plan.sites.emplace_back().site.elevation = geo::HeightMsl::fromMetres(0.0);
    plan.tour.emplace_back().altitude = 1200.0;
    const safety::HeightBands bands = safety::heightBands(safety::conditionsOf(plan), plan.mission.aircraft);
    const std::vector<double> edges{250.0, 300.0, 500.0, 750.0, 800.0, 1000.0};
    const std::vector<double> shears{0.0, 0.0, 0.01, 0.01, 0.01, 0.05, 0.0};
    QVERIFY(bands.edges == edges);
    for (std::size_t i = 0; i < shears.size(); ++i) {
      QVERIFY2(std::abs(bands.bands[i].shear - shears[i]) < 1e-15, QString("band %1: %2").arg(i).arg(bands.bands[i].shear).toUtf8());
    }
  }
};

QTEST_APPLESS_MAIN(TestWindShear)
#include "tst_shear_rules.moc"
