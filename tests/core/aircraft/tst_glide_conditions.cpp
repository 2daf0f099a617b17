// The glide model where masses, densities, drag, propeller and the speed of the tour are not the profile's, held against the
// equations of motion (tests/support/condition_flight.h).
#include "core/aircraft/glide_model.h"
#include "core/aircraft/wind_check.h"
#include "core/base/expect.h"
#include "tests/support/condition_flight.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using aircraft::AirRange;
using aircraft::GlideConditions;
using aircraft::GlideModel;

namespace {

aircraft::AircraftProfile rangingCessna() {
  aircraft::AircraftProfile profile = test::paperCessna();
  profile.leastMass_kg = 760.0;
  profile.mostMass_kg = 1111.0;
  profile.windmillingDrag = 0.042;
  profile.stoppedDrag = 0.038;
  return profile;
}

AirRange airBetween(double lowest, double highest) {
  return {{12.0, 1002.0}, geo::HeightMsl::fromMetres(lowest), geo::HeightMsl::fromMetres(highest)};
}

std::vector<air::WindLayer> someWinds() {
  return {{geo::HeightMsl(), {200.0, 15.0, 2.0, 6.0}}, {geo::HeightMsl::fromMetres(2000.0), {260.0, 20.0, 4.0, 9.0}}};
}

/// Losses on all courses, straight and at some radii over ground that every model of these tests allows.
std::vector<double> lossesOf(const GlideModel& model) {
  std::vector<double> losses{model.straightLoss(), model.mostStraightLoss()};
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double course = Angle::degrees(degrees).radians();
    losses.push_back(model.lossOver(std::cos(course), std::sin(course)));
    VP_EXPECT(model.leastLoss() <= losses.back() * (1.0 + 1e-12));  // a lower bound of all courses
    for (const double radius : {300.0, 500.0, 900.0}) {
      const auto byCourse = model.courseLoss(radius);
      losses.push_back(byCourse ? byCourse->turn(course, 1.0) : model.lossAt(radius) * radius);
      losses.push_back(model.mostTurnLoss(radius));
    }
  }
  return losses;
}

/// "" if no loss of `more` is below that of `less`, and one of them is above.
QString notDearer(const GlideModel& less, const GlideModel& more, bool isStrict) {
  const std::vector<double> a = lossesOf(less);
  const std::vector<double> b = lossesOf(more);
  bool isAnyDearer = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (b[i] < a[i] * (1.0 - 1e-12)) {
      return QString("loss %1 fell from %2 to %3").arg(i).arg(a[i]).arg(b[i]);
    }
    isAnyDearer = isAnyDearer || b[i] > a[i] * (1.0 + 1e-9);
  }
  return isAnyDearer || !isStrict ? QString() : QString("nothing became dearer");
}

}  // namespace

class TestGlideConditions : public QObject {
  Q_OBJECT

private slots:
  void noConditions_areTheProfileAlone() {
    const GlideModel plain(test::paperCessna());
    const GlideModel given(test::paperCessna(), GlideConditions{});
    QCOMPARE(given.airspeed(), test::paperCessna().bestGlideSpeed.si());
    QCOMPARE(given.tourAirspeed(), given.airspeed());
    QCOMPARE(given.mostGroundSpeed(), given.airspeed());
    QCOMPARE(given.mostTailwind(1.0), 0.0);
    QVERIFY(lossesOf(plain) == lossesOf(given) && plain.glideRadii() == given.glideRadii());
  }

  void massesAndAir_rangeTheAirspeed() {
    const GlideModel model(rangingCessna(), {.air = airBetween(300.0, 3000.0)});
    const double thin = air::density({12.0, 1002.0}, geo::HeightMsl::fromMetres(3000.0));
    QVERIFY(std::abs(model.airspeed() - 33.4 * std::sqrt(1.111 * 1.225 / thin)) < 1e-9);
    QCOMPARE(model.straightLoss(), GlideModel(test::paperCessna()).straightLoss());  // the same lift coefficient
    const GlideModel windy(rangingCessna(), {.winds = someWinds(), .air = airBetween(300.0, 3000.0)});
    const double dense = air::density({12.0, 1002.0}, geo::HeightMsl::fromMetres(300.0));
    QVERIFY(std::abs(windy.strongestWind() - 9.0 * std::sqrt(1.111 / 0.76 * dense / thin)) < 1e-9);
    QCOMPARE(windy.mostGroundSpeed(), windy.airspeed() + windy.strongestWind());
  }

  /// From 260 degrees and 20 to each side some of it blows due East; from 200 and 15 to each side most along North, 5 degrees off.
  void mostTailwind_isOfTheNearestDirectionOfAnyLayer() {
    const GlideModel model(test::paperCessna(), {.winds = someWinds()});
    QVERIFY(std::abs(model.mostTailwind(0.0) - 9.0) < 1e-12);                                                         // East
    QVERIFY(std::abs(model.mostTailwind(0.5 * Angle::kPi) - 6.0 * std::cos(Angle::degrees(5.0).radians())) < 1e-12);  // North
    QCOMPARE(model.mostTailwind(Angle::kPi), 0.0);                                                                    // West
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> courses(0.0, 2.0 * Angle::kPi);
    for (int i = 0; i < 10'000; ++i) {
      const double course = courses(random);
      const test::SteadyWind wind = test::windOf(someWinds(), random);
      QVERIFY(wind.east * std::cos(course) + wind.north * std::sin(course) <= model.mostTailwind(course) + 1e-9);
    }
  }

  void tourSpeed_turnsWider_andGlidesAsBefore() {
    const GlideModel slow(test::paperCessna(), {.winds = someWinds()});
    const GlideModel fast(test::paperCessna(), {.winds = someWinds(), .tourSpeed = Speed::fromSi(55.0)});
    QVERIFY(std::abs(fast.tourRadius() - 64.0 * 64.0 / (kGravity.si() * std::tan(Angle::degrees(60.0).radians()))) < 1e-9);
    QVERIFY(lossesOf(slow) == lossesOf(fast) && slow.glideRadii() == fast.glideRadii());
    QCOMPARE(fast.mostGroundSpeed(), 64.0);
    const double slope = fast.slopeOf(Angle::degrees(10.0));
    QVERIFY(std::abs(slope - std::tan(Angle::degrees(10.0).radians()) * 55.0 / 64.0) < 1e-12);
  }

  void propeller_bringsItsOwnDrag() {
    const double asInPolar = GlideModel(rangingCessna()).straightLoss();
    const double stopped = GlideModel(rangingCessna(), {.propeller = aircraft::Propeller::Stopped}).straightLoss();
    const double windmilling = GlideModel(rangingCessna(), {.propeller = aircraft::Propeller::Windmilling}).straightLoss();
    QVERIFY(asInPolar < stopped && stopped < windmilling);
    QCOMPARE(GlideModel(test::paperCessna(), {.propeller = aircraft::Propeller::Stopped}).straightLoss(), asInPolar);  // the profile names none
  }

  void wideningAnything_neverLowersALoss() {
    for (const bool isWindy : {false, true}) {
      const std::vector<air::WindLayer> winds = isWindy ? someWinds() : std::vector<air::WindLayer>{};
      const GlideModel base(rangingCessna(), {.winds = winds, .air = airBetween(500.0, 2000.0)});
      const QString higher = notDearer(base, GlideModel(rangingCessna(), {.winds = winds, .air = airBetween(500.0, 4000.0)}), true);
      QVERIFY2(higher.isEmpty(), qPrintable(higher));
      const QString lower = notDearer(base, GlideModel(rangingCessna(), {.winds = winds, .air = airBetween(0.0, 2000.0)}), isWindy);
      QVERIFY2(lower.isEmpty(), qPrintable(lower));
      aircraft::AircraftProfile masses = rangingCessna();
      masses.leastMass_kg = 700.0;
      masses.mostMass_kg = 1200.0;
      const QString wider = notDearer(base, GlideModel(masses, {.winds = winds, .air = airBetween(500.0, 2000.0)}), true);
      QVERIFY2(wider.isEmpty(), qPrintable(wider));
      const QString drag = notDearer(base, GlideModel(rangingCessna(), {.winds = winds, .air = airBetween(500.0, 2000.0), .dragFactor = 1.2}), true);
      QVERIFY2(drag.isEmpty(), qPrintable(drag));
    }
  }

  /// Where the check finds nothing no loss is infinite; a little more wind, and it is refused, or some loss would be no number.
  void windThatPlansMayStartWith_givesFiniteLosses() {
    std::mt19937_64 random(77);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int accepted = 0;
    int refused = 0;
    for (int i = 0; i < 60; ++i) {
      GlideConditions conditions{.air = airBetween(1000.0 * unit(random), 1000.0 + 3000.0 * unit(random)), .dragFactor = 1.0 + 0.3 * unit(random)};
      if (i % 2 == 0) {
        conditions.tourSpeed = Speed::fromSi(30.0 + 20.0 * unit(random));
      }
      const double least = aircraft::glideSpeeds(rangingCessna(), conditions.air).least;
      const double speed = least * (0.85 + 0.15 * unit(random));
      conditions.winds = {{geo::HeightMsl(), {360.0 * unit(random), 10.0 * unit(random), speed, speed}}};
      const auto fault = aircraft::windFault(rangingCessna(), conditions);
      refused += fault ? 1 : 0;
      if (fault) {
        continue;
      }
      ++accepted;
      const GlideModel model(rangingCessna(), conditions);
      QVERIFY(std::isfinite(model.mostStraightLoss()) && std::isfinite(model.mostTurnLoss(model.tourRadius())));
      for (const double radius : model.glideRadii()) {
        QVERIFY(std::isfinite(model.mostTurnLoss(radius)));
      }
    }
    QVERIFY(accepted > 10 && refused > 5);
  }

  /// A wind that no turn gets past must not make turns free.
  void windThatHoldsTheAircraftUp_makesTurnsInfinite() {
    const GlideModel model(test::paperCessna(), {.winds = {{geo::HeightMsl(), {0.0, 0.0, 33.39, 33.39}}}});
    const auto byCourse = model.courseLoss(model.glideRadii().front());
    for (int i = 0; i < 360; i += 7) {
      const double around = byCourse->turn(Angle::degrees(i).radians(), 2.0 * Angle::kPi);
      QVERIFY(std::isinf(around));
      QVERIFY(byCourse->turn(Angle::degrees(i).radians(), -0.2) > 0.0);
    }
  }

  /// No mass, altitude, wind, course and bank of the set loses more than the model says.
  void pointMass_neverLosesMore_data() {
    QTest::addColumn<bool>("isWindy");
    QTest::newRow("calm") << false;
    QTest::newRow("two layers of wind") << true;
  }
  void pointMass_neverLosesMore() {
    QFETCH(bool, isWindy);
    const GlideConditions conditions{.winds = isWindy ? someWinds() : std::vector<air::WindLayer>{},
                                     .air = airBetween(200.0, 3500.0),
                                     .dragFactor = 1.15,
                                     .propeller = aircraft::Propeller::Windmilling};
    const aircraft::AircraftProfile profile = rangingCessna();
    const GlideModel model(profile, conditions);
    std::mt19937_64 random(20261);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    // these winds stand still as they are met; what sinking from one into another costs besides is held against Newton's law in tst_shear_loss
    const double still = 1.0 - model.airspeed() * model.shear() / kGravity.si();
    double closest = 0.0;
    for (int i = 0; i < 10'000; ++i) {
      const double mass = 760.0 + 351.0 * unit(random);
      const double altitude = 200.0 + 3300.0 * unit(random);
      const double course = 2.0 * Angle::kPi * unit(random);
      const test::SteadyWind wind = isWindy ? test::windOf(conditions.winds, random) : test::SteadyWind{};
      const double radius = i % 3 == 0 ? 0.0 : model.glideRadii()[static_cast<std::size_t>(i) % model.glideRadii().size()];
      const double lost = test::lossInWind(test::polarAt(profile, conditions, mass, altitude), wind, course, radius);
      const auto byCourse = radius > 0.0 ? model.courseLoss(radius) : nullptr;
      const double most = radius == 0.0 ? model.lossOver(std::cos(course), std::sin(course))
                          : byCourse    ? byCourse->mostInTurn(course, 1e-3)
                                        : model.lossAt(radius);
      QVERIFY2(lost <= most * (1.0 + 1e-9), qPrintable(QString("case %1: %2 above %3").arg(i).arg(lost).arg(most)));
      closest = std::max(closest, lost / (most * still));
    }
    QVERIFY2(closest > 0.97, qPrintable(QString::number(closest)));  // no blind upper bound
  }
};

QTEST_APPLESS_MAIN(TestGlideConditions)
#include "tst_glide_conditions.moc"
