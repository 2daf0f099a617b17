// What happens between an engine failure and the glide: straights that a glide must begin with, and height that is lost at once.

#include "tests/core/safety/interval_cases.h"
#include "tests/core/safety/plan_fixture.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <limits>
#include <random>

using namespace vp;

namespace {

using Fixture = test::PlanFixture;
using Change = test::PlanChange;

constexpr double kSpeed = 33.4;  // m/s, of the test's aircraft

void react(Fixture& f, double seconds, double metres) {
  f.mission().safety.reactionTime = Duration::fromSi(seconds);
  f.mission().safety.reactionLoss = Length::fromSi(metres);
  f.refit();
}

/// With the glides as they are.
void loseAtOnce(Fixture& f, double metres) {
  f.mission().safety.reactionLoss = Length::fromSi(metres);
  for (mission::DecisionPoint& point : f.plan().tour) {
    point.safeAltitude += metres;
  }
}

safety::GlideRates ratesOf(Fixture& f) {
  return {safety::conditionsOf(f.plan()), f.mission().aircraft};
}

/// A glide that first flies these pieces and then to the runway.
void beginWith(Fixture& f, std::size_t index, std::vector<flight::Piece> pieces) {
  safety::GlideRates rates = ratesOf(f);
  const test::FlownPoint end = test::fly(f.point(index).pose, pieces, 1.0).back();
  const auto rest = test::glideTo({end.x, end.y, wrapTwoPi(end.heading)}, f.plan().sites[0].pose, rates.leastGlideRadius());
  pieces.insert(pieces.end(), rest.begin(), rest.end());
  f.setGlide(index, pieces, rates);
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestReactionRules : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

private slots:
  void plan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    row("glide that turns at once", "glide.reaction", [](Fixture& f) {
      react(f, 3.0, 0.0);
      beginWith(f, 4, {});
    });
    row("glide that turns a metre early", "glide.reaction", [](Fixture& f) {
      react(f, 3.0, 0.0);
      beginWith(f, 4, {{flight::Turn::Straight, 0.0, 3.0 * kSpeed - 1.0}});
    });
    row("glide that turns early for the strongest wind", "glide.reaction", [](Fixture& f) {
      f.mission().wind = {test::layerOf(0.0, 250.0, 20.0, 0.0, 3.0)};
      react(f, 3.0, 0.0);
      beginWith(f, 4, {{flight::Turn::Straight, 0.0, 3.0 * (kSpeed + 2.5)}});
    });
    row("glide that turns early for the speed of the tour", "glide.reaction", [](Fixture& f) {
      f.mission().aircraft.powerSettings = {{"65 %", Speed::fromSi(55.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
      f.mission().powerSetting = "65 %";
      react(f, 3.0, 0.0);
      beginWith(f, 4, {{flight::Turn::Straight, 0.0, 3.0 * 54.0}});
    });
    row("glide that turns away from the tour's turn", "glide.reaction", [](Fixture& f) {
      react(f, 3.0, 0.0);
      beginWith(f, 11, {{flight::Turn::Right, 300.0, 110.0}});
    });
    row("glide that turns tighter than the tour", "glide.reaction", [](Fixture& f) {
      react(f, 3.0, 0.0);
      beginWith(f, 11, {{flight::Turn::Left, 290.0, 110.0}});
    });
    row("glide that goes on turning where the tour goes straight", "glide.reaction", [](Fixture& f) {
      react(f, 10.0, 0.0);
      beginWith(f, 14, {{flight::Turn::Left, 300.0, 334.0}});  // the tour's turn ends 188.5 m on
    });
    row("glide that turns, goes straight and turns again", "glide.reaction", [](Fixture& f) {
      react(f, 10.0, 0.0);
      beginWith(f, 11, {{flight::Turn::Left, 300.0, 100.0}, {flight::Turn::Straight, 0.0, 100.0}, {flight::Turn::Left, 300.0, 134.0}});
    });
    row("safe altitudes without the loss", "glide.safeAltitude", [](Fixture& f) { f.mission().safety.reactionLoss = Length::fromSi(1.0); });
    row("arrival without the loss", "glide.arrival", [](Fixture& f) {
      f.mission().safety.arrivalMargin = Length::fromSi(150.0);
      react(f, 0.0, 40.0);
      f.flyLow(20.0);
      f.raise(f.highest(), -30.0);
    });
    row("clearance without the loss", "glide.clearance", [](Fixture& f) {
      react(f, 0.0, 40.0);
      f.flyLow(20.0);
      f.raise(f.highest(), -30.0);
    });
    row("too low between two points", "between.height", [](Fixture& f) {
      react(f, 0.0, 30.0);
      f.flyLow(5.0);
    });
    row("ground under the tour that the loss reaches", "between.clearance", [](Fixture& f) {
      loseAtOnce(f, 30.0);
      f.terrain.setCell(125.0, 1025.0, 471.0F);
    });
  }

  void plan_breaksExactlyItsRule() {
    QFETCH(QString, rule);
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyBreaksExactly(fixture, rule);
    if (QTest::currentTestFailed()) {
      return;
    }
    if (rule != "glide.arrival" && rule != "glide.clearance") {
      fixture.mission().safety.reactionTime = {};
      fixture.mission().safety.reactionLoss = {};
      const safety::SafetyReport without = test::checkedPlan(fixture);
      QVERIFY2(without.isSafe(), test::textsOfFindings(without));
    }
  }

  void plan_isCertified_data() {
    QTest::addColumn<Change>("change");
    QTest::newRow("straight first") << Change([](Fixture& f) { react(f, 10.0, 30.0); });
    QTest::newRow("along the tour's turn") << Change([](Fixture& f) {
      react(f, 3.0, 0.0);
      beginWith(f, 11, {{flight::Turn::Left, 300.0, 100.3}});
    });
    QTest::newRow("along the tour's turn and out of it") << Change([](Fixture& f) {
      react(f, 10.0, 0.0);
      beginWith(f, 14, {{flight::Turn::Left, 300.0, f.point(14).onward.length}, {flight::Turn::Straight, 0.0, 146.0}});
    });
    QTest::newRow("along the tour into its turn, then straight") << Change([](Fixture& f) {
      react(f, 10.0, 0.0);
      beginWith(f, 9, {{flight::Turn::Straight, 0.0, 200.0}, {flight::Turn::Left, 300.0, 60.0}, {flight::Turn::Straight, 0.0, 75.0}});
    });
    QTest::newRow("along all of a lap and more") << Change([](Fixture& f) {
      f.builder.flyAt(1500.0);
      react(f, 10.0, 0.0);
      std::vector<flight::Piece> lap;
      for (std::size_t i = 0; i < 40; ++i) {
        lap.push_back(f.point((4 + i) % f.plan().tour.size()).onward);
      }
      beginWith(f, 4, lap);
    });
    QTest::newRow("ground that the loss just does not reach") << Change([](Fixture& f) {
      loseAtOnce(f, 30.0);
      f.terrain.setCell(125.0, 1025.0, 450.0F);
    });
  }

  void plan_isCertified() {
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyIsCertified(fixture);
  }

  void loss_isTakenFromEveryMarginOfAGlide() {
    Fixture fixture;
    fixture.refit();
    const safety::SafetyReport before = test::checkedPlan(fixture);
    react(fixture, 0.0, 12.0);
    const safety::SafetyReport after = test::checkedPlan(fixture);
    for (const char* kind : {"tour.glide", "glide.clearance", "glide.arrival"}) {
      QVERIFY(std::abs(test::marginOf(before, kind) - test::marginOf(after, kind) - 12.0) < 1e-9);
    }
    QVERIFY(test::marginOf(before, "tour.clearance") == test::marginOf(after, "tour.clearance"));
  }

  void tourSlowerThanTheGlide_needsALoss() {
    Fixture fixture;
    fixture.mission().aircraft.powerSettings = {{"slow", Speed::fromSi(28.0), 20.0, aircraft::PowerSetting::Unit::Litres}};
    fixture.mission().powerSetting = "slow";
    const auto warns = [&] {
      const safety::SafetyReport report = test::checkedPlan(fixture);
      return std::any_of(report.findings.begin(), report.findings.end(), [](const safety::Finding& f) { return f.rule == "settings.reaction"; });
    };
    QVERIFY(warns());
    react(fixture, 0.0, (33.4 * 33.4 - 28.0 * 28.0) / (2.0 * 9.80665));
    QVERIFY(!warns());
  }

  void random_intervals_againstBruteForce_areJudgedAlike() { test::judgeRandomIntervals({20261201, 10000, 40.0, 15.0}); }
};

QTEST_APPLESS_MAIN(TestReactionRules)
#include "tst_reaction_rules.moc"
