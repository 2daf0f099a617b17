// What rolling may cost on arcs too short for their bank: against aircraft that bank at a rate, in wind that may change with height, at every
// airspeed and as fast as they like, and against the charge of whole banks.

#include "core/safety/roll_cost.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

using namespace vp;

namespace {

using flight::Piece;
using flight::Turn;

constexpr double kG = 9.80665;

/** An aircraft on a day: its polar as sin(gamma) = level + induced tan^2(bank), and how it rolls. */
struct Flyer {
  double airspeed = 0.0;  // m/s
  double level = 0.0;
  double induced = 0.0;
  double rate = 0.0;  // rad/s
  double late = 0.0;  // of the time of a roll

  [[nodiscard]] double sink(double tangent) const { return airspeed * (level + induced * tangent * tangent); }
};

/** What one arc over ground asks for in one wind when the bank changes at once, along the angle that the nose turns by. */
struct Arc {
  std::vector<double> nose;  // rad, ascending
  std::vector<double> tangents;
  double lost = 0.0;  // m

  [[nodiscard]] double tangentAt(double turned) const {
    const auto above = std::upper_bound(nose.begin(), nose.end(), turned);
    return tangents[std::min(static_cast<std::size_t>(above - nose.begin()), tangents.size() - 1)];
  }
};

/// In steps. What turns the nose because the wind changes with height asks for no bank, but for what it gains along the nose of who crabs (WHY.md
/// section 12), here always the wrong way.  @param change  of the wind per metre of height, as far down as `above` below the start
Arc arcOf(const Flyer& flyer, air::Wind wind, air::Wind change, double above, double course, const Piece& piece) {
  constexpr int kSteps = 100;
  const double side = static_cast<int>(piece.turn);
  Arc arc;
  double turned = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double chi = course + side * piece.length / piece.radius * (i + 0.5) / kSteps;
    const double along = wind.east * std::cos(chi) + wind.north * std::sin(chi);
    const double across = wind.north * std::cos(chi) - wind.east * std::sin(chi);
    const double ahead = std::sqrt(flyer.airspeed * flyer.airspeed - across * across);
    const double heading = chi - std::atan2(across, ahead);
    const double seconds = piece.length / kSteps / (ahead + along);
    double rate = (ahead + along) * (ahead + along) / (piece.radius * ahead);  // rad/s
    const double gain = change.east * std::cos(heading) + change.north * std::sin(heading);
    rate += std::abs(flyer.sink(rate * flyer.airspeed / kG) * gain * across / ahead) / flyer.airspeed;
    arc.tangents.push_back(rate * flyer.airspeed / kG);
    turned += rate * seconds;
    arc.nose.push_back(turned);
    const double down = flyer.sink(arc.tangents.back()) * seconds;
    arc.lost += down;
    change = arc.lost < above ? change : air::Wind();
    wind = {wind.east - change.east * down, wind.north - change.north * down};
  }
  return arc;
}

/** One arc flown from level to level: late, then banking at the rate up to what the arc asks for, or until it must roll out to leave it on its
 * heading.
 * @return height lost beyond the arc's own */
double beyondTheArc(const Flyer& flyer, const Arc& arc) {
  constexpr double kStep = 2e-3;  // s
  const double perTangent = kG / flyer.airspeed;
  double bank = 0.0;
  double most = 0.0;
  double turned = 0.0;
  double lost = 0.0;
  const auto leaves = [&] { return arc.nose.back() - turned <= -std::log(std::cos(bank)) * perTangent / flyer.rate; };
  while (!leaves()) {
    const double next = std::min(bank + flyer.rate * kStep, std::atan(arc.tangentAt(turned)));
    const double tangent = std::tan(0.5 * (bank + next));
    bank = next;
    most = std::max(most, bank);
    turned += perTangent * tangent * kStep;
    lost += flyer.sink(tangent) * kStep;
  }
  lost += (flyer.airspeed * flyer.level * bank + flyer.airspeed * flyer.induced * (std::tan(bank) - bank)) / flyer.rate;
  return lost + flyer.late * most / flyer.rate * flyer.sink(0.0) - arc.lost;
}

/// As every change of bank is charged where nothing is short.
double wholeBanks(const safety::RollCost& cost, const std::vector<Piece>& pieces) {
  double sum = 0.0;
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    sum += cost.between(i == 0 ? Piece() : pieces[i - 1], i == pieces.size() ? Piece() : pieces[i]);
  }
  return sum;
}

bool isTurning(const Piece& piece) {
  return piece.turn != Turn::Straight;
}

/// Corrections of the course, zigzags without anything between them, and turns. Two to one side have a straight between them.
std::vector<Piece> zigzag(test::WindCases& cases, double least) {
  std::vector<Piece> pieces;
  for (int count = 1 + cases.below(6); count > 0; --count) {
    const Turn turn = cases.below(2) == 0 ? Turn::Left : Turn::Right;
    if (!pieces.empty() && (pieces.back().turn == turn || cases.below(2) == 0)) {
      pieces.push_back({Turn::Straight, 0.0, 1.0 + 300.0 * cases.unit()});
    }
    const double radius = least * (1.0 + 9.0 * cases.unit() * cases.unit());
    const double angle = cases.below(4) == 0 ? 3.0 * cases.unit() : 0.6 * cases.unit() * cases.unit();
    pieces.push_back({turn, radius, std::max(1e-3, angle * radius)});
  }
  return pieces;
}

}  // namespace

class TestShortRolls : public QObject {
  Q_OBJECT

private slots:
  void flights_inEveryWindAndAirspeed_costNoMoreThanIsCharged() {
    constexpr std::uint64_t kSeed = 20270401;
    constexpr int kSets = 200;
    constexpr int kFlights = 50;
    qInfo("seed %llu, %d flights", static_cast<unsigned long long>(kSeed), kSets * kFlights);
    test::WindCases cases(kSeed);
    double nearest = 0.0;
    double spared = 0.0;
    int shortOnes = 0;
    for (int set = 0; set < kSets; ++set) {
      aircraft::AircraftProfile profile = test::cessna();
      profile.rollRate_dps = 4.0 + 40.0 * cases.unit();
      profile.leastMass_kg = profile.mass_kg * (1.0 - 0.2 * cases.below(2));
      profile.mostMass_kg = profile.mass_kg * (1.0 + 0.1 * cases.below(2));
      std::vector<air::WindLayer> layers;
      for (int i = set % 3; i > 0; --i) {
        layers.push_back(cases.layer(400.0 * static_cast<double>(layers.size())));
      }
      const safety::PlanConditions conditions = safety::conditionsOf(profile, layers);
      const safety::GlideRates rates(conditions, profile);
      const safety::RollCost cost(conditions, profile, rates);
      const safety::WindGlide polar(profile);
      for (int number = 0; number < kFlights; ++number) {
        const double airspeed = conditions.glide.least + (conditions.glide.most - conditions.glide.least) * cases.unit();
        const double rate = Angle::degrees(*profile.rollRate_dps).radians() * (cases.below(2) == 0 ? 1.0 : 1.0 + 2.0 * cases.unit());
        const Flyer flyer{airspeed, polar.straightSine() * rates.shear().turn, polar.inducedSine() * rates.shear().turn, rate, 0.5 * cases.unit()};
        air::Wind wind;
        air::Wind change;
        double above = 0.0;  // m, of the lower layer
        if (layers.size() == 1) {
          wind = cases.wind(layers);
        } else if (layers.size() == 2) {
          const air::Wind low = cases.wind({layers[0]});
          const air::Wind high = cases.wind({layers[1]});
          const double share = cases.unit();
          above = 400.0 * share;
          wind = {low.east + share * (high.east - low.east), low.north + share * (high.north - low.north)};
          change = {(high.east - low.east) / 400.0, (high.north - low.north) / 400.0};
        }
        const std::vector<Piece> pieces = zigzag(cases, rates.leastGlideRadius());
        double lost = 0.0;
        double course = 6.0 * cases.unit();
        for (const Piece& piece : pieces) {
          if (isTurning(piece)) {
            lost += beyondTheArc(flyer, arcOf(flyer, wind, change, above, course, piece));
            course += static_cast<int>(piece.turn) * piece.length / piece.radius;
          }
        }
        const double charged = cost.along({}, pieces).back();
        const double whole = wholeBanks(cost, pieces);
        const QByteArray label =
            QString("set %1, flight %2: %3, charged %4, whole %5").arg(set).arg(number).arg(lost).arg(charged).arg(whole).toUtf8();
        QVERIFY2(lost <= charged * (1.0 + 1e-3), label);  // steps of 2 ms
        QVERIFY2(charged <= whole * (1.0 + 1e-12), label);
        nearest = std::max(nearest, lost / charged);
        spared = std::max(spared, 1.0 - charged / whole);
        shortOnes += charged < whole * (1.0 - 1e-9) ? 1 : 0;
      }
    }
    qInfo("up to %.2f of what is charged; %d with short arcs, charged down to %.2f of whole banks", nearest, shortOnes, 1.0 - spared);
    QVERIFY(nearest > 0.8 && shortOnes > kSets * kFlights / 2);
  }

  /// 3 degrees at 15 degrees per second: -ln cos(bank) = angle x v x rate/2g.
  void correctionOfThreeDegrees_byHand() {
    aircraft::AircraftProfile profile = test::cessna();
    profile.rollRate_dps = 15.0;
    const safety::PlanConditions conditions = safety::conditionsOf(profile, {});
    const safety::RollCost cost(conditions, profile, safety::GlideRates(conditions, profile));
    const safety::WindGlide polar(profile);
    const double v = profile.bestGlideSpeed.si();
    const double rate = Angle::degrees(15.0).radians();
    const double angle = Angle::degrees(3.0).radians();
    const double radius = v * v / kG;  // 45 degrees
    const double bank = std::acos(std::exp(-angle * v * rate / (2.0 * kG)));
    QVERIFY(std::abs(cost.bankWithin(angle, radius) - bank) < 1e-12);
    QVERIFY(std::abs(Angle::radians(bank).degrees() - 12.33) < 0.02 && std::abs(bank * bank / (angle * v * rate / kG) - 1.0) < 0.02);
    const double roll = bank / rate * v * (polar.straightSine() + polar.inducedSine() * std::tan(bank) * std::tan(bank));
    const double whole = 3.0 * v * (polar.straightSine() + polar.inducedSine());
    const Piece straight{Turn::Straight, 0.0, 300.0};
    const Piece left{Turn::Left, radius, angle * radius};
    const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    const std::vector<double> alone = cost.along({}, {straight, left, straight});
    QVERIFY(isNear(alone[0], 0.0) && isNear(alone[1], 1.5 * roll) && isNear(alone[2], 2.5 * roll) && alone[2] < 0.35 * (2.0 * whole));
    QVERIFY(isNear(cost.along({}, {straight, left}).back(), 2.5 * roll));  // level at the end
    const Piece right{Turn::Right, radius, angle * radius};
    const std::vector<double> zigzag = cost.along({}, {left, right, left});
    QVERIFY(isNear(zigzag[0], 1.5 * roll) && isNear(zigzag[1], 4.0 * roll) && isNear(zigzag[2], 7.5 * roll));
    // Out of a turn to the other side that is long enough, and into one.
    const Piece turn{Turn::Right, radius, 3.0 * radius};
    const std::vector<double> beside = cost.along({}, {turn, left, turn});
    QVERIFY(isNear(beside[0], whole) && isNear(beside[1], 2.0 * whole + 1.5 * roll) && isNear(beside[2], 4.0 * whole + 2.5 * roll));
    const std::vector<double> fromTour = cost.along(turn, {left, straight});
    QVERIFY(isNear(fromTour[0], whole + 1.5 * roll) && isNear(fromTour[1], whole + 2.5 * roll));
    // An arc in parts is one arc.
    const Piece third{Turn::Left, radius, angle * radius / 3.0};
    const std::vector<double> inParts = cost.along({}, {third, {Turn::Straight, 0.0, 0.0}, third, third, straight});
    QVERIFY(isNear(inParts[0], 1.5 * roll) && isNear(inParts[3], 1.5 * roll) && isNear(inParts[4], 2.5 * roll));
  }

  /// Beside a turn to the same side, of a glide or of the tour, whole banks are charged, and beyond a quarter of a circle.
  void arcsThatAreNoCorrections_areChargedWholeBanks() {
    aircraft::AircraftProfile profile = test::cessna();
    profile.rollRate_dps = 3.0;
    const safety::PlanConditions conditions = safety::conditionsOf(profile, {test::layerOf(0.0, 90.0, 20.0, 2.0, 5.0)});
    const safety::RollCost cost(conditions, profile, safety::GlideRates(conditions, profile));
    const Piece small{Turn::Left, 150.0, 10.0};
    const Piece wide{Turn::Left, 400.0, 20.0};
    const Piece straight{Turn::Straight, 0.0, 300.0};
    for (const std::vector<Piece>& pieces : {std::vector<Piece>{small, wide, straight}, {straight, wide, small}}) {
      QVERIFY(std::abs(cost.along({}, pieces).back() - wholeBanks(cost, pieces)) < 1e-9);
    }
    QVERIFY(std::abs(cost.along(wide, {small, straight}).back() - cost.afterTour(wide, small) - cost.between(small, straight)) < 1e-9);
    for (const double angle : {Angle::kPi / 2.0 - 1e-9, Angle::kPi / 2.0 + 1e-9}) {
      const std::vector<Piece> one{{Turn::Left, 110.0, 110.0 * angle}, straight};
      QVERIFY((cost.along({}, one).back() < 0.999 * wholeBanks(cost, one)) == (angle < Angle::kPi / 2.0));
    }
  }

  /// A longer arc never costs less.
  void charge_risesWithTheArc() {
    constexpr std::uint64_t kSeed = 20270402;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    aircraft::AircraftProfile profile = test::cessna();
    for (int number = 0; number < 100; ++number) {
      profile.rollRate_dps = 3.0 + 40.0 * cases.unit();
      const safety::PlanConditions conditions = safety::conditionsOf(profile, cases.layers(number % 3));
      const safety::GlideRates rates(conditions, profile);
      const safety::RollCost cost(conditions, profile, rates);
      const double radius = rates.leastGlideRadius() * (1.0 + 5.0 * cases.unit());
      double before = 0.0;
      for (double angle = 1e-4; angle < 4.0; angle *= 1.1) {
        const double charged = cost.along({}, {{Turn::Right, radius, angle * radius}}).back();
        QVERIFY2(charged >= before, QString("%1 rad: %2, before %3").arg(angle).arg(charged).arg(before).toUtf8());
        before = charged;
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestShortRolls)
#include "tst_short_rolls.moc"
