// What changes of bank are charged, against closed forms.
#include "core/audit/roll_account.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <cmath>

using namespace vp;
using namespace vp::audit;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kRate = 15.0 * kDegree;  // rad/s
constexpr double kG = 9.80665;            // m/s^2

}  // namespace

class TestRollAccount : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { mission_.aircraft = test::cessna(); }

  /// The angle over the rate, at the sink of the steeper bank.
  void wholeRolls_costTheirTimeAtTheSteeperSink() {
    const AirTable table(mission_);
    const SampleAir air{{}, mission_.aircraft.mass_kg};
    const GlideMotion motion(mission_, air, table);
    const auto sink = [&](double degrees) { return motion.sinkRate(std::tan(degrees * kDegree), 0.0); };
    QVERIFY(std::abs(sink(0.0) / 33.4 - std::sin(5.0 * kDegree)) < 0.003);  // the 172's 4.9 degrees
    const Bend left{1, 200.0, 3.0, 600.0};
    const Bend right{-1, 200.0, 3.0, 600.0};
    RollAccount rolls(motion, kRate);
    rolls.begin(0.0);
    rolls.rollInto(left, true, 30.0 * kDegree, 33.0, 0.0);
    QVERIFY(std::abs(rolls.lost() - 2.0 * sink(30.0)) < 1e-9);
    rolls.rollInto(right, true, -45.0 * kDegree, 33.0, 0.0);
    QVERIFY(std::abs(rolls.lost() - 2.0 * sink(30.0) - 5.0 * sink(45.0)) < 1e-9);
    rolls.rollInto(right, false, -30.0 * kDegree, 33.0, 0.0);
    QVERIFY(std::abs(rolls.lost() - 2.0 * sink(30.0) - 6.0 * sink(45.0)) < 1e-9);
    rolls.rollLevel(0.0);
    QVERIFY(std::abs(rolls.lost() - 4.0 * sink(30.0) - 6.0 * sink(45.0)) < 1e-9);
    rolls.begin(30.0 * kDegree);
    rolls.rollInto(left, true, 30.0 * kDegree, 33.0, 0.0);
    QVERIFY(std::abs(rolls.lost()) < 1e-9);
  }

  /// Rolling in to a bank and out of it at the rate p turns the nose by 2 g/(v p) ln(1/cos bank).
  void shortArcs_costTheBankThatIsReached() {
    const AirTable table(mission_);
    const SampleAir air{{}, mission_.aircraft.mass_kg};
    const GlideMotion motion(mission_, air, table);
    for (const double degrees : {1.0, 3.0, 8.0}) {
      const double radius = 33.4 * 33.4 / (kG * std::tan(30.0 * kDegree));
      const Bend arc{1, radius, degrees * kDegree, radius * degrees * kDegree};
      RollAccount rolls(motion, kRate);
      rolls.begin(0.0);
      rolls.rollInto(arc, true, 30.0 * kDegree, 33.4, 0.0);
      const double in = rolls.lost();
      rolls.rollInto(Bend(), false, 0.0, 33.4, 0.0);
      const double reached = std::acos(std::exp(-degrees * kDegree * 33.4 * kRate / (2.0 * kG)));
      const double once = reached / kRate * motion.sinkRate(std::tan(reached), 0.0);
      const double whole = 2.0 * motion.sinkRate(std::tan(30.0 * kDegree), 0.0);
      const bool isShort = 1.5 * once < whole;
      QVERIFY2(std::abs(in - (isShort ? 1.5 * once : whole)) < 0.03 * whole, qPrintable(QString::number(in)));
      QVERIFY(std::abs(rolls.lost() - in - (isShort ? once : whole)) < 0.03 * whole);
      rolls.begin(0.0);
      rolls.rollInto(arc, false, 30.0 * kDegree, 33.4, 0.0);  // beside a turn to the same side it is none
      QVERIFY(std::abs(rolls.lost() - whole) < 1e-9);
    }
  }

private:
  mission::Mission mission_;
};

QTEST_APPLESS_MAIN(TestRollAccount)
#include "tst_roll_account.moc"
