#include "core/safety/glide_rates.h"
#include "tests/core/safety/wind_cases.h"

#include <QTest>

using namespace vp;

namespace {

using Layers = std::vector<air::WindLayer>;

/// The greatest of a function of one wind over a set: many winds of it, then steps towards the best by mixing it with others.
template <typename Value>
double greatestOver(test::WindCases& cases, const Layers& layers, const Value& value) {
  double best = -1e300;
  air::Wind where;
  const auto attempt = [&](const air::Wind& wind) {
    if (const double found = value(wind); found > best) {
      best = found;
      where = wind;
    }
  };
  for (int i = 0; i < 4000; ++i) {
    attempt(cases.wind(layers));
  }
  for (int i = 0; i <= 15000; ++i) {  // all round the edge of each sector
    const double share = i / 15000.0;
    const auto blow = [&](double speed, double from_deg) {
      const double from = from_deg * Angle::kPi / 180.0;
      attempt({-speed * std::sin(from), -speed * std::cos(from)});
    };
    for (const air::WindLayer& layer : layers) {
      const air::WindSector& sector = layer.wind;
      blow(sector.mostSpeed, sector.from_deg + sector.spread_deg * (2.0 * share - 1.0));
      blow(sector.leastSpeed, sector.from_deg + sector.spread_deg * (2.0 * share - 1.0));
      blow(sector.leastSpeed + share * (sector.mostSpeed - sector.leastSpeed), sector.from_deg - sector.spread_deg);
      blow(sector.leastSpeed + share * (sector.mostSpeed - sector.leastSpeed), sector.from_deg + sector.spread_deg);
    }
  }
  for (int i = 0; layers.size() > 1 && i < 20000; ++i) {  // a convex set: between any two of its winds lie more
    const double step = std::pow(10.0, -5.0 * cases.unit());
    const air::Wind other = cases.wind(layers);
    attempt({where.east + step * (other.east - where.east), where.north + step * (other.north - where.north)});
  }
  return best;
}

/// A course at a right angle to the line between two winds.
double courseAcross(test::WindCases& cases, const Layers& layers) {
  const air::Wind a = cases.wind(layers);
  const air::Wind b = cases.wind(layers);
  return std::atan2(b.north - a.north, b.east - a.east) + (cases.below(2) == 0 ? 0.5 : -0.5) * Angle::kPi;
}

QByteArray labelOf(int number, const Layers& layers, double bound, double found) {
  QString text =
      QString("case %1: bound %2, found %3, relative %4;").arg(number).arg(bound, 0, 'g', 12).arg(found, 0, 'g', 12).arg(bound / found - 1.0);
  for (const air::WindLayer& layer : layers) {
    text += QString(" from %1 +- %2 at %3 to %4")
                .arg(layer.wind.from_deg)
                .arg(layer.wind.spread_deg)
                .arg(layer.wind.leastSpeed)
                .arg(layer.wind.mostSpeed);
  }
  return text.toUtf8();
}

flight::Piece leftTurn(double radius, double length) {
  return {flight::Turn::Left, radius, length};
}

}  // namespace

class TestWindGlide : public QObject {
  Q_OBJECT

private slots:
  void mostLoss_againstManyWinds_isNeverBelowAndTight() {
    constexpr std::uint64_t kSeed = 20240701;
    constexpr int kCases = 300;
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    test::WindCases cases(kSeed);
    const aircraft::AircraftProfile profile = test::cessna();
    const safety::WindGlide glide(profile);
    double loosest = 0.0;
    for (int number = 0; number < kCases; ++number) {
      const Layers layers = cases.layers(1 + number % 3);
      const safety::WindSet winds(layers);
      const bool isTurn = cases.below(4) > 0;
      // Steep turns may lose the most in the middle of an edge, between its corners: where the edge lies across the course.
      const bool isAcross = number % 2 == 0;
      const double course = isAcross ? courseAcross(cases, layers) : 2.0 * Angle::kPi * cases.unit();
      const double bank = isAcross ? 45.0 + 15.0 * cases.unit() : 5.0 + 55.0 * cases.unit();
      const double fastest = profile.bestGlideSpeed.si() + winds.strongest();
      const double radius = isTurn ? fastest * fastest / (9.80665 * std::tan(Angle::degrees(bank).radians())) : 0.0;
      const double bound = isTurn ? glide.mostInTurn(winds, radius, {course, course}) : glide.mostStraight(winds, course);
      const double found = greatestOver(cases, layers, [&](const air::Wind& wind) { return test::lossIn(profile, wind, course, radius); });
      QVERIFY2(bound >= found * (1.0 - 1e-12), labelOf(number, layers, bound, found));
      QVERIFY2(bound <= found * (1.0 + 1e-5), labelOf(number, layers, bound, found));
      loosest = std::max(loosest, bound / found - 1.0);
    }
    qInfo("at most %.2g above what was found", loosest);
  }

  void mostLoss_overCourses_isThatOfTheWorstCourse() {
    constexpr std::uint64_t kSeed = 20240702;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    const safety::WindGlide glide(test::cessna());
    for (int number = 0; number < 2000; ++number) {
      const Layers layers = cases.layers(1 + number % 3);
      const safety::WindSet winds(layers);
      const double radius = 160.0 + 600.0 * cases.unit();
      const double from = 6.0 * cases.unit();
      const double to = from + 0.05 * cases.unit();
      const double bound = glide.mostInTurn(winds, radius, {from, to});
      double found = 0.0;
      for (int i = 0; i <= 40; ++i) {
        const double course = from + (to - from) * i / 40.0;
        found = std::max(found, glide.mostInTurn(winds, radius, {course, course}));
      }
      QVERIFY2(bound >= found * (1.0 - 2.1e-6), labelOf(number, layers, bound, found));
      QVERIFY2(bound <= found * (1.0 + 2e-5), labelOf(number, layers, bound, found));  // 40 courses are not all
    }
  }

  void arcs_againstFineSteps_areNeverBelowAndWithinAThousandth() {
    constexpr std::uint64_t kSeed = 20240703;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    const aircraft::AircraftProfile profile = test::cessna();
    double loosest = 0.0;
    for (int number = 0; number < 120; ++number) {
      const Layers layers = cases.layers(1 + number % 3);
      const safety::WindSet winds(layers);
      safety::GlideRates rates(profile, layers);
      const safety::WindGlide& glide = rates.glide();  // with what the change of the wind from layer to layer costs
      const double radius = rates.leastGlideRadius() * (1.0 + 3.0 * cases.unit());
      const double side = cases.below(2) == 0 ? 1.0 : -1.0;
      const double angle = 0.02 + 7.0 * cases.unit();
      const double course = 12.0 * cases.unit() - 6.0;
      const safety::LossAlong loss = rates.along(course, {side > 0.0 ? flight::Turn::Left : flight::Turn::Right, radius, angle * radius});
      const int steps = static_cast<int>(std::ceil(angle / 0.01));
      double sum = 0.0;
      for (int i = 0; i < steps; ++i) {  // rule of the middle
        const double at = course + side * angle * (i + 0.5) / steps;
        sum += glide.mostInTurn(winds, radius, {at, at}) * angle * radius / steps;
        const double bound = loss.upTo(angle * radius * (i + 1) / steps);
        QVERIFY2(bound >= sum * (1.0 - 5e-5), labelOf(number, layers, bound, sum));
      }
      const double bound = loss.upTo(angle * radius);
      QVERIFY2(bound >= sum * (1.0 - 1e-5) && bound <= sum * 1.001, labelOf(number, layers, bound, sum));
      loosest = std::max(loosest, bound / sum - 1.0);
    }
    qInfo("at most %.2g above", loosest);
  }

  /// Two winds from the sides and a little from behind, as layers: a tight turn loses the most in one between them, right from behind.
  void mostLoss_betweenLayers_isFound() {
    const aircraft::AircraftProfile profile = test::cessna();
    const double from = Angle::radians(std::atan2(8.0, 3.0)).degrees();  // off the tail, eastbound
    const double speed = std::hypot(3.0, 8.0);
    const Layers layers{test::layerOf(0.0, 270.0 - from, 0.0, speed, speed), test::layerOf(500.0, 270.0 + from, 0.0, speed, speed)};
    const safety::WindSet winds(layers);
    const double radius = 90.0;
    const double between = test::lossIn(profile, {3.0, 0.0}, 0.0, radius);
    QVERIFY(between > 1.001 * test::lossIn(profile, {3.0, 8.0}, 0.0, radius));
    QVERIFY(safety::WindGlide(profile).mostInTurn(winds, radius, {0.0, 0.0}) >= between);
    QVERIFY(safety::WindGlide(profile).mostInTurn(winds, radius, {0.0, 0.0}) <= between * (1.0 + 1e-5));
  }

  /// Each cell of courses holds the greatest loss of all its courses, not that of its middle.
  void cells_holdTheirWorstCourse() {
    const aircraft::AircraftProfile profile = test::cessna();
    const Layers layers{test::layerOf(0.0, 250.0, 20.0, 3.0, 9.0)};
    safety::GlideRates rates(profile, layers);
    const safety::LossAlong loss = rates.along(0.0, leftTurn(300.0, 1900.0));
    const double cell = 2.0 * Angle::kPi / safety::CourseTable::kCells;
    for (int i = 0; i < safety::CourseTable::kCells; ++i) {
      const double held = (loss.upTo(300.0 * cell * (i + 1)) - loss.upTo(300.0 * cell * i)) / (300.0 * cell);
      for (const double course : {i * cell, (i + 1) * cell}) {
        QVERIFY(held >= rates.glide().mostInTurn(rates.winds(), 300.0, {course, course}) * (1.0 - 2.5e-6));
      }
    }
  }

  /// Breaks are where the slope changes, and nowhere else: halfway between two of them half is lost.
  void breaks_areAllOfThem() {
    safety::GlideRates rates(test::cessna(), {test::layerOf(0.0, 250.0, 20.0, 3.0, 9.0)});
    for (const flight::Turn turn : {flight::Turn::Left, flight::Turn::Right}) {
      const safety::LossAlong loss = rates.along(0.3, {turn, 300.0, 2500.0});
      double before = 0.0;
      int count = 0;
      for (double at = loss.nextBreak(0.0); at < 2500.0; at = loss.nextBreak(at)) {
        QVERIFY(at > before && at - before < 300.0 * 2.0 * Angle::kPi / 2880.0 + 1e-9);
        QVERIFY(std::abs(loss.upTo(0.5 * (before + at)) - 0.5 * (loss.upTo(before) + loss.upTo(at))) < 1e-9);
        before = at;
        ++count;
      }
      QVERIFY(std::abs(count - 2500.0 / 300.0 * 2880.0 / (2.0 * Angle::kPi)) < 2.0);
    }
  }

  void steepestBank_isWithTheStrongestWindBehind() {
    constexpr std::uint64_t kSeed = 20240704;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    const safety::WindGlide glide(test::cessna());
    for (int number = 0; number < 10000; ++number) {
      const double strongest = 30.0 * cases.unit();
      const double speed = strongest * cases.unit();
      const double off = 7.0 * cases.unit();
      const double behind = glide.bankTangent(strongest, 0.0);
      QVERIFY(glide.bankTangent(speed * std::cos(off), speed * std::sin(off)) <= behind * (1.0 + 1e-12));
      QVERIFY(std::abs(behind - (33.4 + strongest) * (33.4 + strongest) / 9.80665) < 1e-9 * behind);
    }
    const safety::GlideRates rates(test::cessna(), {test::layerOf(0.0, 250.0, 20.0, 3.0, 9.0)});
    QVERIFY(std::abs(rates.leastGlideRadius() - 42.4 * 42.4 / (9.80665 * std::sqrt(3.0))) < 1e-9);
    QVERIFY(std::abs(rates.leastTourRadius() - rates.leastGlideRadius()) < 1e-9);
  }

  void slopesAndLeastLosses_boundEveryWind() {
    constexpr std::uint64_t kSeed = 20240705;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    const aircraft::AircraftProfile profile = test::cessna();
    for (int number = 0; number < 10000; ++number) {
      const Layers layers = cases.layers(1 + number % 3);
      const safety::GlideRates rates(profile, layers);
      const double radius = rates.leastGlideRadius() * (1.0 + cases.unit());
      const double side = cases.below(3) - 1.0;
      const double angle = 7.0 * cases.unit() * cases.unit();
      const flight::Piece piece{static_cast<flight::Turn>(side), side == 0.0 ? 0.0 : radius, angle * radius};
      const double course = 6.0 * cases.unit();
      const double share = rates.slopeShare(course, piece);
      QVERIFY(share >= 33.4 / (33.4 + rates.winds().strongest()) * (1.0 - 1e-12));
      for (int i = 0; i < 5; ++i) {
        const air::Wind wind = cases.wind(layers);
        const double at = course + side * angle * cases.unit();
        const double along = wind.east * std::cos(at) + wind.north * std::sin(at);
        const double across = wind.north * std::cos(at) - wind.east * std::sin(at);
        QVERIFY(std::sqrt(33.4 * 33.4 - across * across) + along <= 33.4 / share * (1.0 + 1e-9));
        QVERIFY(rates.leastAlong(course, piece) <= test::lossIn(profile, wind, at, piece.radius) * (1.0 + 1e-9));
      }
    }
  }

  void headwind_byHand() {
    const aircraft::AircraftProfile profile = test::cessna();
    safety::GlideRates rates(profile, {test::layerOf(0.0, 90.0, 0.0, 10.0, 10.0)});  // blows to the west
    const double still = aircraft::GlideModel(profile).straightLoss();
    const double horizontal = 33.4 / std::sqrt(1.0 + still * still);
    QVERIFY(std::abs(rates.along(0.0, {flight::Turn::Straight, 0.0, 100.0}).upTo(1.0) - still * horizontal / (horizontal - 10.0)) < 1e-12);
    QVERIFY(std::abs(rates.along(Angle::kPi, {flight::Turn::Straight, 0.0, 100.0}).upTo(1.0) - still * horizontal / (horizontal + 10.0)) < 1e-12);
    QVERIFY(std::abs(rates.mostStraight() - still * horizontal / (horizontal - 10.0)) < 1e-12);
    QVERIFY(std::abs(rates.slopeShare(Angle::kPi, {}) - 33.4 / 43.4) < 1e-12);
  }

  void calm_isTheModelToTheLastBit() {
    const aircraft::AircraftProfile profile = test::cessna();
    const aircraft::GlideModel model(profile);
    safety::GlideRates calm(model);
    safety::GlideRates none(profile, {});
    safety::GlideRates zero(profile, {test::layerOf(0.0, 90.0, 20.0, 0.0, 0.0), test::layerOf(500.0, 0.0, 180.0, 0.0, 0.0)});
    for (safety::GlideRates* rates : {&calm, &none, &zero}) {
      QVERIFY(rates->isCalm());
      QVERIFY(rates->leastGlideRadius() == model.glideRadii().back() && rates->leastTourRadius() == model.tourRadius());
      QVERIFY(rates->along(1.0, {flight::Turn::Straight, 0.0, 77.0}).upTo(77.0) == model.straightLoss() * 77.0);
      QVERIFY(rates->along(1.0, leftTurn(91.0, 77.0)).upTo(77.0) == model.lossAt(91.0) * 77.0);
      QVERIFY(rates->leastAlong(1.0, leftTurn(91.0, 77.0)) == model.lossAt(91.0) && rates->slopeShare(1.0, leftTurn(91.0, 77.0)) == 1.0);
      QVERIFY(rates->along(1.0, leftTurn(91.0, 77.0)).nextBreak(0.0) > 1e300);
    }
  }

  /// Radii that no plan may have must not be taken for ones that can be flown.
  void turnThatIsTooTight_hasNoGlide() {
    safety::GlideRates rates(test::cessna(), {test::layerOf(0.0, 90.0, 180.0, 0.0, 18.0)});
    QVERIFY(!(rates.along(0.0, leftTurn(30.0, 10.0)).upTo(10.0) < 1e300));
    QVERIFY(!(rates.along(0.0, leftTurn(0.0, 10.0)).upTo(10.0) < 1e300));
  }
};

QTEST_APPLESS_MAIN(TestWindGlide)
#include "tst_wind_glide.moc"
