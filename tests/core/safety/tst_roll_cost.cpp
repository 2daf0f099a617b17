// What rolling into turns may cost: against banks that change at a rate, by hand, in every wind, and in what the checker says about a plan.

#include "core/safety/descent.h"
#include "core/safety/ground_path.h"
#include "core/safety/roll_cost.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

#include <numeric>

using namespace vp;

namespace {

using flight::Piece;
using flight::Turn;

constexpr double kRate = 15.0;  // degrees per second

aircraft::AircraftProfile rolling() {
  aircraft::AircraftProfile profile = test::cessna();
  profile.rollRate_dps = kRate;
  return profile;
}

safety::RollCost costIn(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds) {
  const safety::PlanConditions conditions = safety::conditionsOf(profile, winds);
  return {conditions, profile, safety::GlideRates(conditions, profile)};
}

/// The aircraft as sin(gamma) = level + induced * tan^2(bank).
struct Polar {
  double v = 0.0;
  double level = 0.0;
  double induced = 0.0;
};

Polar polarOf(const aircraft::AircraftProfile& profile) {
  const safety::WindGlide glide(profile);
  return {profile.bestGlideSpeed.si(), glide.straightSine(), glide.inducedSine()};
}

/// Height and angle [rad] lost and turned while the bank goes from 0 to `bank` at a rate, in small steps.
std::pair<double, double> rollIn(const Polar& polar, double bank, double rate) {
  constexpr int kSteps = 2000;
  double lost = 0.0;
  double turned = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double tangent = std::tan(bank * (i + 0.5) / kSteps);
    lost += polar.v * (polar.level + polar.induced * tangent * tangent) * bank / rate / kSteps;
    turned += 9.80665 * tangent / polar.v * bank / rate / kSteps;
  }
  return {lost, turned};
}

/// A flight over straights and turns whose bank changes at the rate. Rolls into a turn begin late by this part of their time (-0.5: centred, as the
/// roll out of the straight's or the turn's end by as much); every turn is left so that its angle is right. @return what it loses beyond the model
double beyondTheModel(const Polar& polar, const std::vector<Piece>& pieces, double late) {
  const double rate = Angle::degrees(kRate).radians();
  double beyond = 0.0;
  for (const Piece& piece : pieces) {
    if (piece.turn == Turn::Straight) {
      continue;
    }
    const double tangent = polar.v * polar.v / (9.80665 * piece.radius);
    const double bank = std::atan(tangent);
    const auto [lost, turned] = rollIn(polar, bank, rate);
    const double sink = polar.v * (polar.level + polar.induced * tangent * tangent);
    beyond += 2.0 * lost - 2.0 * turned / (9.80665 * tangent / polar.v) * sink;  // in and out, instead of as much at the full bank
    const double before = bank / rate * (late < 0.0 ? 2.0 * late : late);        // of level flight more, or less at both ends
    beyond += before * polar.v * polar.level;
  }
  return beyond;
}

std::vector<Piece> randomPieces(test::WindCases& cases, double least) {
  std::vector<Piece> pieces;
  for (int count = 1 + cases.below(6); count > 0; --count) {
    const auto turn = static_cast<Turn>(cases.below(3) - 1);
    pieces.push_back({turn, turn == Turn::Straight ? 0.0 : least * (1.0 + 3.0 * cases.unit()), 200.0 + 500.0 * cases.unit()});
  }
  return pieces;
}

}  // namespace

class TestRollCost : public QObject {
  Q_OBJECT

private slots:
  /// Between straights, so that each turn is rolled into from level and out of again.
  void rollsThatBeginLate_costNoMoreThanIsCharged_andCentredOnesNothing() {
    constexpr std::uint64_t kSeed = 20270201;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    const aircraft::AircraftProfile profile = rolling();
    const Polar polar = polarOf(profile);
    const safety::RollCost cost = costIn(profile, {});
    double most = 0.0;
    double centred = -1e9;
    for (int number = 0; number < 10000; ++number) {
      std::vector<Piece> pieces;
      for (const Piece& piece : randomPieces(cases, safety::GlideRates(aircraft::GlideModel(profile)).leastGlideRadius())) {
        pieces.push_back(piece);
        pieces.push_back({Turn::Straight, 0.0, 300.0});
      }
      const double charged = cost.along({}, pieces).back();
      const double lost = beyondTheModel(polar, pieces, 0.5 * cases.unit());
      QVERIFY2(lost <= charged * (1.0 + 1e-6), QString("case %1: %2, charged %3").arg(number).arg(lost).arg(charged).toUtf8());
      if (charged > 0.0) {
        most = std::max(most, lost / charged);
        centred = std::max(centred, beyondTheModel(polar, pieces, -0.5) / charged);
      }
    }
    qInfo("late rolls cost up to %.2f of what is charged, centred ones %.4f", most, centred);
    QVERIFY(most > 0.3 && centred < 0.01);
  }

  /// 60 degrees at 15 degrees per second take 4 s, sinking as at 60 degrees of bank.
  void changesOfBank_byHand() {
    const aircraft::AircraftProfile profile = rolling();
    const safety::RollCost cost = costIn(profile, {});
    const Polar polar = polarOf(profile);
    const double v = polar.v;
    const double tight = v * v / (9.80665 * std::sqrt(3.0));
    const double wide = v * v / 9.80665;
    const double atTight = v * (polar.level + 3.0 * polar.induced);
    const double atWide = v * (polar.level + polar.induced);
    const Piece straight{Turn::Straight, 0.0, 500.0};
    const Piece left{Turn::Left, tight, 500.0};
    const Piece right{Turn::Right, wide, 500.0};
    const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    QVERIFY(isNear(cost.between(straight, left), 4.0 * atTight) && isNear(cost.between(left, straight), 4.0 * atTight));
    QVERIFY(isNear(cost.between(straight, right), 3.0 * atWide) && cost.between(straight, straight) == 0.0);
    QVERIFY(isNear(cost.between(left, right), 7.0 * atTight));
    QVERIFY(isNear(cost.between(left, {Turn::Left, wide, 1.0}), 1.0 * atTight) && cost.between(left, left) == 0.0);
    const std::vector<double> sums = cost.along({}, {straight, left, right});
    QVERIFY(isNear(sums[0], 0.0) && isNear(sums[1], 4.0 * atTight) && isNear(sums[2], 11.0 * atTight + 3.0 * atWide));  // level at the end
    const std::vector<double> fromTour = cost.along(right, {straight, left, {Turn::Right, wide, 0.0}, straight});
    QVERIFY(isNear(fromTour[0], 3.0 * atWide) && isNear(fromTour[1], 3.0 * atWide + 4.0 * atTight) && fromTour[2] == fromTour[1]);
    QVERIFY(isNear(fromTour[3], 3.0 * atWide + 8.0 * atTight));
    QVERIFY(cost.along(left, {left, left, {Turn::Straight, 0.0, 0.0}}).front() == 0.0);
    QVERIFY(cost.along({}, {}).empty());
  }

  /// In every wind up to the strongest the change of bank and the bank are no more than what is charged for.
  void changesOfBank_inEveryWind() {
    constexpr std::uint64_t kSeed = 20270202;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    const aircraft::AircraftProfile profile = rolling();
    const Polar polar = polarOf(profile);
    double tightest = 0.0;
    for (int number = 0; number < 2000; ++number) {
      const double strongest = 12.0 * cases.unit();
      const safety::RollCost cost = costIn(profile, {test::layerOf(0.0, 0.0, 180.0, 0.0, strongest)});
      const double least = (polar.v + strongest) * (polar.v + strongest) / (9.80665 * std::sqrt(3.0));
      const std::vector<Piece> two{{static_cast<Turn>(cases.below(3) - 1), least * (1.0 + 2.0 * cases.unit()), 300.0},
                                   {static_cast<Turn>(cases.below(3) - 1), least * (1.0 + 2.0 * cases.unit()), 300.0}};
      const double charged = cost.between(two[0], two[1]);
      double most = 0.0;
      for (int i = 0; i <= 40; ++i) {
        const double speed = polar.v + strongest * (i / 20.0 - 1.0);  // over ground
        const auto bankOf = [&](const Piece& piece) { return static_cast<int>(piece.turn) * std::atan(speed * speed / (9.80665 * piece.radius)); };
        const double steeper = std::max(std::abs(bankOf(two[0])), std::abs(bankOf(two[1])));
        const double sink = polar.v * (polar.level + polar.induced * std::tan(steeper) * std::tan(steeper));
        most = std::max(most, std::abs(bankOf(two[0]) - bankOf(two[1])) / Angle::degrees(kRate).radians() * sink);
      }
      QVERIFY2(most <= charged + 1e-9, QString("case %1: %2, charged %3").arg(number).arg(most).arg(charged).toUtf8());
      tightest = std::max(tightest, charged > 0.0 ? most / charged : 0.0);
    }
    QVERIFY(tightest > 0.999);
  }

  void plan_withARateOfRoll_saysWhatRollingMayCost() {
    test::PlanFixture fixture;
    fixture.mission().aircraft.rollRate_dps = kRate;
    fixture.refit();
    claimWhatIsFlown(fixture);
    const safety::SafetyReport report = test::checkedPlan(fixture);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    const safety::PlanConditions conditions = safety::conditionsOf(fixture.plan());
    const safety::RollCost cost(conditions, fixture.mission().aircraft, safety::GlideRates(conditions, fixture.mission().aircraft));
    double whole = 0.0;
    const std::size_t count = fixture.plan().tour.size();
    for (std::size_t i = 0; i < count; ++i) {
      whole = std::max(whole, cost.along(fixture.point((i + count - 1) % count).onward, fixture.point(i).witness.pieces).back());
    }
    QVERIFY(whole > 20.0);
    const std::string said = fmtMetres("rolling into turns and out of them, at 15 degrees per second, may cost up to ", whole) +
                             " m, for which every glide has the height above the ground.";
    QVERIFY2(report.certificate->statement.find(said) != std::string::npos, report.certificate->statement.c_str());
  }

  /// The least of height above the ground and cost, looked for in steps along all glides from the tour.
  void margin_isTheLeastOverAllGlides_data() {
    QTest::addColumn<bool>("hasLayers");
    QTest::newRow("one air") << false;
    QTest::newRow("layers") << true;
  }
  void margin_isTheLeastOverAllGlides() {
    QFETCH(bool, hasLayers);
    test::PlanFixture fixture;
    fixture.mission().aircraft.rollRate_dps = kRate;
    if (hasLayers) {
      fixture.mission().wind = {test::layerOf(200.0, 250.0, 20.0, 1.0, 3.0), test::layerOf(900.0, 280.0, 20.0, 2.0, 6.0)};
    }
    fixture.terrain.setCell(275.0, 1625.0, 330.0F);
    fixture.builder.flyAt(900.0);
    fixture.refit();
    claimWhatIsFlown(fixture);
    const safety::SafetyReport report = test::checkedPlan(fixture);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    const safety::PlanConditions conditions = safety::conditionsOf(fixture.plan());
    safety::GlideRates rates(conditions, fixture.mission().aircraft);
    const safety::RollCost cost(conditions, fixture.mission().aircraft, rates);
    double least = 1e9;
    const std::size_t count = fixture.plan().tour.size();
    for (std::size_t i = 0; i < count; ++i) {
      const mission::DecisionPoint& point = fixture.point(i);
      const std::vector<double> costs = cost.along(fixture.point((i + count - 1) % count).onward, point.witness.pieces);
      geo::Pose pose = point.pose;
      double height = point.altitude;
      for (std::size_t k = 0; k < point.witness.pieces.size(); ++k) {
        const Piece& piece = point.witness.pieces[k];
        safety::Descent descent(rates, pose.heading, piece);
        const int steps = 1 + static_cast<int>(piece.length);
        for (int step = 0; step <= steps; ++step) {
          const double at = piece.length * step / steps;
          const double ground = fixture.terrain.grid().upperAt(safety::poseOn(pose, piece, at).point());
          least = std::min(least, descent.down(0.0, height, at) - ground - costs[k]);
        }
        height = descent.down(0.0, height, piece.length);
        pose = safety::endOfPiece(pose, piece);
      }
    }
    const double margin = test::marginOf(report, "glide.dynamics");
    QVERIFY2(margin <= least + 1e-6 && margin > least - 0.5, QString("%1, found %2").arg(margin).arg(least).toUtf8());
  }

  /// Rolling comes out of the clearance; where it costs more, the tour must be so much higher.
  void plan_withoutTheHeightThatRollingMayCost_isRefused_data() { margin_isTheLeastOverAllGlides_data(); }
  void plan_withoutTheHeightThatRollingMayCost_isRefused() {
    QFETCH(bool, hasLayers);
    const auto made = [&](std::optional<double> rate, double clearance, double extra) {
      test::PlanFixture fixture;
      fixture.mission().aircraft.rollRate_dps = rate;
      fixture.mission().safety.clearance = Length::fromSi(clearance);
      if (hasLayers) {
        fixture.mission().wind = {test::layerOf(200.0, 250.0, 20.0, 1.0, 3.0), test::layerOf(900.0, 280.0, 20.0, 2.0, 6.0)};
      }
      fixture.refit();
      fixture.flyLow(extra);
      claimWhatIsFlown(fixture);
      return test::checkedPlan(fixture);
    };
    QVERIFY2(made(std::nullopt, 20.0, 20.0).isSafe(), test::textsOfFindings(made(std::nullopt, 20.0, 20.0)));
    double extra = 20.0;
    safety::SafetyReport report = made(kRate, 20.0, extra);
    QVERIFY2(test::textsOfFindings(report).contains("rolling into turns and out of them may cost"), test::textsOfFindings(report));
    for (int round = 0; round < 4 && !report.isSafe(); ++round) {  // what is missing at a point hides what is missing between two
      double missing = 0.0;
      for (const safety::Finding& finding : report.findings) {
        if (finding.severity == safety::Severity::Violated) {
          QVERIFY2(finding.rule == "glide.dynamics" || finding.rule == "between.height", test::textsOfFindings(report));
          missing = std::max(missing, -finding.margin.value_or(0.0));
        }
      }
      QVERIFY(missing > 0.0);
      extra += missing + 0.01;
      report = made(kRate, 20.0, extra);
    }
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    QVERIFY(extra > 40.0);
    QVERIFY(!made(kRate, 20.0, extra - (hasLayers ? 1.0 : 0.1)).isSafe());  // in layers a metre at the start is not quite one further on
    QVERIFY(made(360.0, 20.0, 20.0).isSafe());                              // rolls at once
    QVERIFY(made(kRate, 200.0, 20.0).isSafe());
  }

  /// Without a rate of roll: what was measured on another aircraft.
  void clearance_belowWhatWasMeasured_isWarnedOf() {
    const auto warnings = [](std::optional<double> rate, double clearance) {
      test::PlanFixture fixture;
      fixture.mission().aircraft.rollRate_dps = rate;
      fixture.mission().safety.clearance = Length::fromSi(clearance);
      fixture.refit();
      const safety::SafetyReport report = test::checkedPlan(fixture);
      return std::count_if(report.findings.begin(), report.findings.end(), [](const auto& one) { return one.rule == "settings.clearance"; });
    };
    QCOMPARE(warnings(std::nullopt, 29.0), 1);
    QCOMPARE(warnings(std::nullopt, 31.0), 0);
    QCOMPARE(warnings(kRate, 29.0), 0);
  }

private:
  /// Safe altitudes that claim no less than any glide of the tour may need.
  static void claimWhatIsFlown(test::PlanFixture& fixture) {
    for (std::size_t i = 0; i < fixture.plan().tour.size(); ++i) {
      fixture.point(i).safeAltitude = fixture.point(i).altitude;
    }
  }
  static std::string fmtMetres(const char* before, double metres) { return before + std::to_string(static_cast<int>(std::ceil(metres))); }
};

QTEST_APPLESS_MAIN(TestRollCost)
#include "tst_roll_cost.moc"
