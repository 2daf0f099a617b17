// The greatest losses on circles: against the search that they were found by before, how the loss runs along winds of one speed and along chords, and
// tables that only know the courses that were asked for.

#include "core/base/expect.h"
#include "core/safety/glide_rates.h"
#include "core/safety/wind_chord.h"
#include "tests/core/safety/searched_loss.h"
#include "tests/core/safety/wind_cases.h"

#include <QTest>

using namespace vp;

namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;

/** An aircraft and its air: drag, airspeed and shear of many kinds. */
struct Setting {
  aircraft::AircraftProfile profile = test::cessna();
  double airspeed = 0.0;
  safety::WindGlide glide;
  std::vector<air::WindLayer> layers;
  safety::WindSet winds;
  double radius = 0.0;  // m, of a bank of 3 to 62 degrees in the strongest wind from behind
};

Setting settingOf(test::WindCases& cases, int number) {
  Setting one;
  one.profile.zeroLiftDrag *= 0.3 + 2.0 * cases.unit();
  one.profile.inducedDrag *= 0.3 + 2.0 * cases.unit();
  one.airspeed = one.profile.bestGlideSpeed.si() * (0.6 + 0.8 * cases.unit());
  safety::PlanConditions conditions = safety::conditionsOf(one.profile, {});
  conditions.dragFactor = 1.0 + cases.unit();
  const double shear = cases.below(2) == 0 ? 1.0 : 1.0 + 0.5 * cases.unit();
  one.glide = safety::WindGlide(one.profile, conditions, one.airspeed, safety::ShearCost{shear, shear * (1.0 + 0.01 * cases.unit()), 0.9});
  one.layers = cases.layers(1 + number % 3);
  one.winds = safety::WindSet(one.layers);
  const double fastest = one.airspeed + one.winds.strongest();
  one.radius = fastest * fastest / (9.80665 * std::tan(Angle::degrees(3.0 + 59.0 * cases.unit()).radians()));
  return one;
}

double lossOn(const Setting& one, const safety::Chord& chord, double at) {
  return one.glide.lossInTurn(chord.along + at * chord.alongBy, chord.across + at * chord.acrossBy, one.radius);
}

}  // namespace

class TestCourseLosses : public QObject {
  Q_OBJECT

private slots:
  /// Never less than the search that halves everything, and no more than what that one may leave out.
  void mostInTurn_againstTheSearch_isNeverLess() {
    constexpr std::uint64_t kSeed = 20270501;
    constexpr int kCases = 30000;
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    test::WindCases cases(kSeed);
    double above = 0.0;
    int infinite = 0;
    for (int number = 0; number < kCases; ++number) {
      Setting one = settingOf(cases, number);
      double from = kTwoPi * cases.unit();
      if (number % 2 == 0) {  // steep, and across a chord: the greatest may lie between its ends
        const air::Wind a = cases.wind(one.layers);
        const air::Wind b = cases.wind(one.layers);
        from = kTwoPi + std::atan2(b.north - a.north, b.east - a.east) + (cases.below(2) == 0 ? 0.5 : -0.5) * Angle::kPi;
        const double fastest = one.airspeed + one.winds.strongest();
        one.radius = fastest * fastest / (9.80665 * std::tan(Angle::degrees(45.0 + 17.0 * cases.unit()).radians()));
      }
      const double wide = cases.below(3) == 0 ? cases.unit() : kTwoPi / 2880.0;
      const double found = one.glide.mostInTurn(one.winds, one.radius, {from, from + wide});
      const double searched = test::searchedInTurn(one.glide, one.airspeed, one.winds, one.radius, {from, from + wide});
      QVERIFY2(found >= searched, QString("case %1: %2, searched %3").arg(number).arg(found, 0, 'g', 17).arg(searched, 0, 'g', 17).toUtf8());
      if (found < std::numeric_limits<double>::infinity()) {
        above = std::max(above, found / searched - 1.0);
      } else {
        ++infinite;
        QVERIFY(!(searched < found));
      }
    }
    qInfo("at most %.2g above; %d without a glide", above, infinite);
    QVERIFY(above < 1e-9 && infinite < kCases / 10);
  }

  /// Off the tail the loss of winds of one speed falls, then rises; or does only one of both.
  void lossOnWindsOfOneSpeed_isGreatestAtAnEnd() {
    constexpr std::uint64_t kSeed = 20270502;
    constexpr int kSteps = 200;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    int turning = 0;
    for (int number = 0; number < 10000; ++number) {
      const Setting one = settingOf(cases, 0);
      const double speed = one.winds.strongest();
      if (!one.glide.getsOn(speed, one.radius)) {
        continue;
      }
      double before = 0.0;
      bool rises = false;
      for (int i = 0; i <= kSteps; ++i) {
        const double off = Angle::kPi * i / kSteps;
        const double loss = one.glide.lossInTurn(speed * std::cos(off), speed * std::sin(off), one.radius);
        QVERIFY2(i == 0 || !rises || loss >= before * (1.0 - 1e-13), QString("case %1 at %2").arg(number).arg(off).toUtf8());
        turning += i > 1 && !rises && loss > before * (1.0 + 1e-12) ? 1 : 0;
        rises = rises || (i > 0 && loss > before * (1.0 + 1e-12));
        before = loss;
      }
    }
    QVERIFY(turning > 100);
  }

  void partsOfChordsThatAreOneWay_areSo() {
    constexpr std::uint64_t kSeed = 20270503;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    int oneWay = 0;
    for (int number = 0; number < 20000; ++number) {
      const Setting one = settingOf(cases, 0);
      const auto wind = [&] { return 0.5 * one.airspeed * (2.0 * cases.unit() - 1.0); };
      safety::Chord chord{wind(), wind(), 0.0, 0.0};
      const double size = std::pow(10.0, -3.0 * cases.unit());
      chord.alongBy = size * (wind() - chord.along);
      chord.acrossBy = size * (wind() - chord.across);
      const safety::Between along = safety::Between::of(chord.along, chord.along + chord.alongBy);
      const safety::Between across = safety::Between::of(chord.across, chord.across + chord.acrossBy);
      const double nearest = across.least * across.most <= 0.0 ? 0.0 : std::min(std::abs(across.least), std::abs(across.most));
      const double farthest = std::max(std::abs(across.least), std::abs(across.most));
      const double most = one.glide.sinkSine(along.most, nearest, one.radius);
      const double least = one.glide.sinkSine(along.least, farthest, one.radius);
      if (!(one.glide.lossAt(most, along.least, farthest) < 1e3)) {
        continue;
      }
      const double level = one.glide.sinkSine(0.0, 0.0, 1e300);
      const double square = one.airspeed * one.airspeed;
      const safety::ChordRanges ranges{
          along,
          across,
          {std::sqrt(square - farthest * farthest), std::sqrt(square - nearest * nearest)},
          {std::sqrt(square * (1.0 - most * most) - farthest * farthest), std::sqrt(square * (1.0 - least * least) - nearest * nearest)},
          {1.0 - level / least, 1.0 - level / most}};
      if (!safety::isOneWay(chord, ranges, square)) {
        continue;
      }
      ++oneWay;
      const double way = lossOn(one, chord, 1.0) > lossOn(one, chord, 0.0) ? 1.0 : -1.0;
      for (int i = 0; i < 50; ++i) {
        const double step = way * (lossOn(one, chord, (i + 1) / 50.0) - lossOn(one, chord, i / 50.0));
        QVERIFY2(step >= -1e-14, QString("case %1, step %2: %3").arg(number).arg(i).arg(step).toUtf8());
      }
    }
    qInfo("%d parts", oneWay);
    QVERIFY(oneWay > 2000);
  }

  /// Whatever was asked for before, of both sides, over several laps, and what was asked for while it was in use.
  void tablesThatKnowSomeCourses_sayWhatWholeOnesSay() {
    constexpr std::uint64_t kSeed = 20270504;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    for (int number = 0; number < 40; ++number) {
      const std::vector<air::WindLayer> layers = cases.layers(1 + number % 3);
      safety::GlideRates some(test::cessna(), layers);
      safety::GlideRates whole(test::cessna(), layers);
      const double radius = some.leastGlideRadius() * (1.0 + cases.unit());
      const safety::LossAlong all = whole.along(0.0, {flight::Turn::Left, radius, 3.0 * kTwoPi * radius});
      const auto integral = [&](double course) { return all.upTo(radius * (course + kTwoPi)) / radius; };  // from -2 pi on
      for (int i = 0; i < 50; ++i) {
        const double side = cases.below(2) == 0 ? 1.0 : -1.0;
        const double course = kTwoPi * cases.unit();
        const double angle = cases.below(8) == 0 ? kTwoPi : 0.5 * cases.unit();
        const flight::Piece piece{side > 0.0 ? flight::Turn::Left : flight::Turn::Right, radius, angle * radius};
        const safety::LossAlong loss = some.along(course, piece);
        const double other = kTwoPi * cases.unit();
        QVERIFY(some.along(other, {flight::Turn::Left, radius, 0.3 * radius}).isFinite());
        for (int k = 0; k <= 10; ++k) {
          const double at = angle * k / 10.0;
          const double lost = loss.upTo(at * radius);
          const double expected = side * radius * (integral(course + side * at) - integral(course));
          QVERIFY2(std::abs(lost - expected) <= 1e-11 * radius, QString("case %1: %2, whole %3").arg(number).arg(lost).arg(expected).toUtf8());
          QVERIFY(std::abs(loss.distanceOf(lost) - at * radius) < 1e-8);
          QVERIFY(k == 10 || loss.rateAt((at + 1e-4 * angle) * radius) > 0.0);
        }
      }
    }
  }

  void coursesThatWereNotAskedFor_areNoneToReadFrom() {
    safety::GlideRates rates(test::cessna(), {test::layerOf(0.0, 250.0, 20.0, 3.0, 9.0)});
    const safety::LossAlong loss = rates.along(1.0, {flight::Turn::Left, 300.0, 30.0});
    QVERIFY(loss.upTo(30.0) > 0.0);
    QVERIFY_EXCEPTION_THROWN(static_cast<void>(loss.upTo(300.0)), LogicError);
    QVERIFY_EXCEPTION_THROWN(static_cast<void>(loss.rateAt(300.0)), LogicError);
  }
};

QTEST_APPLESS_MAIN(TestCourseLosses)
#include "tst_course_losses.moc"
