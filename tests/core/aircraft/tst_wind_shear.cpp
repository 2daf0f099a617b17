// Winds that change with height: how fast at most, and what sinking through them costs by Newton's law.
#include "core/air/wind_shear.h"
#include "core/aircraft/glide_bands.h"
#include "core/aircraft/wind_check.h"
#include "tests/support/mountain.h"
#include "tests/support/shear_flight.h"

#include <QTest>

#include <random>

using namespace vp;

namespace {

air::WindLayer layer(double altitude, double from, double spread, double least, double most) {
  return {geo::HeightMsl::fromMetres(altitude), {from, spread, least * test::kKnot, most * test::kKnot}};
}

template <typename Random>
air::WindLayer anyLayer(double altitude, Random& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double least = 20.0 * unit(random);
  return layer(altitude, 360.0 * unit(random), unit(random) < 0.3 ? 0.0 : 40.0 * unit(random), least,
               least + (unit(random) < 0.3 ? 0.0 : 10.0 * unit(random)));
}

}  // namespace

class TestWindShear : public QObject {
  Q_OBJECT

private slots:
  void mostShear_isReachedAndNeverExceeded() {
    std::mt19937_64 random(3);
    for (int i = 0; i < 2000; ++i) {
      const std::vector<air::WindLayer> layers{anyLayer(0.0, random), anyLayer(500.0, random)};
      const double most = air::mostShear(layers);
      double found = 0.0;
      for (int k = 0; k < 200; ++k) {
        const test::SteadyWind a = test::windOf(layers[0].wind, random);
        const test::SteadyWind b = test::windOf(layers[1].wind, random);
        found = std::max(found, std::hypot(b.east - a.east, b.north - a.north) / 500.0);
      }
      QVERIFY(found <= most * (1.0 + 1e-12));
      QVERIFY2(found > 0.7 * most, qPrintable(QString("%1 of %2").arg(found).arg(most)));
    }
  }

  void mostShear_knownCases() {
    QCOMPARE(air::mostShear({}), 0.0);
    QCOMPARE(air::mostShear({layer(0.0, 270.0, 20.0, 5.0, 15.0)}), 0.0);
    QCOMPARE(air::mostShear({layer(0.0, 270.0, 0.0, 10.0, 10.0), layer(1000.0, 270.0, 0.0, 10.0, 10.0)}), 0.0);
    // 10 kt from the north under 10 kt from the south: 20 kt in 1000 m; the order of layers does not matter
    const double opposed = air::mostShear({layer(1000.0, 0.0, 0.0, 10.0, 10.0), layer(0.0, 180.0, 0.0, 10.0, 10.0)});
    QVERIFY(std::abs(opposed - 20.0 * test::kKnot / 1000.0) < 1e-15);
    // 3 kt and 4 kt at a right angle
    const double right = air::mostShear({layer(0.0, 0.0, 0.0, 3.0, 3.0), layer(100.0, 90.0, 0.0, 4.0, 4.0), layer(200.0, 90.0, 0.0, 4.0, 4.0)});
    QVERIFY(std::abs(right - 5.0 * test::kKnot / 100.0) < 1e-15);
    QVERIFY(std::isinf(air::mostShear({layer(0.0, 0.0, 0.0, 3.0, 3.0), layer(0.0, 90.0, 0.0, 4.0, 4.0)})));
  }

  /// Without shear Newton's law gives what the other reference does, but for the vertical part of the airspeed.
  void reference_withoutShear_isTheSteadyOne() {
    const aircraft::GlidePolar polar = test::polarOf(test::paperCessna());
    for (double course = -3.0; course < 3.0; course += 0.5) {
      const test::SteadyWind wind{4.0, -6.0};
      const auto same = [wind](double) { return wind; };
      const double straight = test::lossInShear(polar, same, 500.0, course, 0.0);
      const double steady = test::lossInWind(polar, wind, course, 0.0);
      QVERIFY2(straight <= steady && straight > 0.99 * steady, qPrintable(QString("%1 against %2").arg(straight).arg(steady)));
      const double turn = test::lossInShear(polar, same, 500.0, course, 300.0);
      const double steadyTurn = test::lossInWind(polar, wind, course, 300.0);
      QVERIFY2(turn <= steadyTurn && turn > 0.97 * steadyTurn, qPrintable(QString("%1 against %2").arg(turn).arg(steadyTurn)));
    }
  }

  /// Every wind that is linear between one of each layer, on every course, straight and turning.
  void sinkingThroughLayers_neverCostsMoreThanTheBound() {
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const aircraft::GlidePolar polar = test::polarOf(test::paperCessna());
    int costlier = 0;
    for (int i = 0; i < 500; ++i) {
      const double height = 150.0 + 1500.0 * unit(random);
      const std::vector<air::WindLayer> layers{anyLayer(0.0, random), anyLayer(height, random)};
      const aircraft::GlideModel model(test::paperCessna(), {.winds = layers});
      const aircraft::GlideModel& between = model.bands()->between(1, 1);
      for (int k = 0; k < 20; ++k) {
        const test::SteadyWind low = test::windOf(layers[0].wind, random);
        const test::SteadyWind high = test::windOf(layers[1].wind, random);
        const auto windAt = [&](double z) {
          return test::SteadyWind{low.east + z / height * (high.east - low.east), low.north + z / height * (high.north - low.north)};
        };
        const double z = height * unit(random);
        const double course = 2.0 * Angle::kPi * unit(random);
        const double straight = test::lossInShear(polar, windAt, z, course, 0.0);
        QVERIFY(straight <= between.lossOver(std::cos(course), std::sin(course)));
        costlier += straight > 1.002 * test::lossInWind(polar, windAt(z), course, 0.0) ? 1 : 0;
        for (std::size_t radius = 0; radius < model.glideRadii().size(); ++radius) {
          const double turn = test::lossInShear(polar, windAt, z, course, model.glideRadii()[radius]);
          QVERIFY2(turn <= between.courseLossOf(radius)->mostInTurn(course, 1e-6),
                   qPrintable(QString("%1 over %2").arg(turn).arg(between.courseLossOf(radius)->mostInTurn(course, 1e-6))));
        }
      }
    }
    QVERIFY2(costlier > 2000, qPrintable(QString::number(costlier)));
  }

  /// A headwind that falls by 10 m/s in 1000 m costs 3.4 % more height at 33 m/s; the bound says no more than 0.2 % beyond.
  void headwindThatFalls_costsWhatTheTextbookSays() {
    const std::vector<air::WindLayer> layers{layer(0.0, 90.0, 0.0, 0.0, 0.0), layer(1000.0, 90.0, 0.0, 10.0 / test::kKnot, 10.0 / test::kKnot)};
    const aircraft::AircraftProfile profile = test::paperCessna();
    const aircraft::GlidePolar polar = test::polarOf(profile);
    const double share = 1.0 / (1.0 - polar.airspeed * 0.01 / kGravity.si());
    const auto windAt = [](double z) { return test::SteadyWind{-0.01 * z, 0.0}; };
    const test::SteadyWind top = windAt(999.0);
    const double loss = test::lossInShear(polar, windAt, 999.0, 0.0, 0.0);
    const double steady = test::lossInShear(
        polar, [top](double) { return top; }, 999.0, 0.0, 0.0);
    QVERIFY2(std::abs(loss / steady / share - 1.0) < 2e-3, qPrintable(QString("%1, asked %2").arg(loss / steady).arg(share)));
    const double bound = aircraft::GlideModel(profile, {.winds = layers}).bands()->between(1, 1).lossOver(1.0, 0.0);
    QVERIFY(bound >= loss && bound < 1.005 * loss);
  }

  void calmOrOneLayer_hasNoShear() {
    QCOMPARE(aircraft::GlideModel(test::paperCessna()).shear(), 0.0);
    QCOMPARE(aircraft::GlideModel(test::paperCessna(), {.winds = {layer(100.0, 270.0, 20.0, 5.0, 15.0)}}).shear(), 0.0);
    const aircraft::GlideModel model(test::paperCessna(), {.winds = {layer(0.0, 0.0, 0.0, 5.0, 5.0), layer(500.0, 0.0, 0.0, 10.0, 10.0)}});
    QCOMPARE(model.bands()->between(0, 0).shear(), 0.0);
    QCOMPARE(model.bands()->between(2, 2).shear(), 0.0);
    QVERIFY(std::abs(model.bands()->between(1, 1).shear() - 5.0 * test::kKnot / 500.0) < 1e-15);
    QCOMPARE(model.bands()->between(0, 2).shear(), model.bands()->between(1, 1).shear());
  }

  void layersTooCloseForTheirWinds_areRefusedWithASentence() {
    const aircraft::GlideConditions sharp{
        .winds = {layer(0.0, 270.0, 0.0, 5.0, 5.0), layer(300.0, 270.0, 0.0, 5.0, 5.0), layer(310.0, 90.0, 0.0, 25.0, 25.0)}};
    const auto fault = aircraft::windFault(test::paperCessna(), sharp);
    QVERIFY(fault.has_value());
    QCOMPARE(fault->layer, std::size_t{2});
    QCOMPARE(fault->sentence,
             std::string("the wind may change by 30 kt between 984 ft and 1017 ft; sinking through that the aircraft makes no way in a steep turn"));
    QVERIFY(!aircraft::windFault(test::paperCessna(), {.winds = {layer(0.0, 270.0, 0.0, 5.0, 5.0), layer(1000.0, 270.0, 0.0, 30.0, 30.0)}}));
  }
};

QTEST_APPLESS_MAIN(TestWindShear)
#include "tst_wind_shear.moc"
