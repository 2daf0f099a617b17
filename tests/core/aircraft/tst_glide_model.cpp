// The glide model against the numbers that the source papers and the handbook formulas give.
#include "core/aircraft/glide_model.h"
#include "core/base/expect.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

double degreesOf(double tangent) {
  return Angle::radians(std::atan(tangent)).degrees();
}

}  // namespace

class TestGlideModel : public QObject {
  Q_OBJECT

private slots:
  void paperCessna_givesThePapersNumbers() {
    const aircraft::GlideModel glide(test::paperCessna());
    QVERIFY(std::abs(degreesOf(glide.straightLoss()) - 4.9) < 0.02);                                 // [1] section 8
    QVERIFY(std::abs(glide.radiusOf(Angle::degrees(60.0)) - 65.7) < 0.1);                            // [1] Table 1
    QVERIFY(std::abs(degreesOf(glide.lossAt(glide.radiusOf(Angle::degrees(60.0)))) - 13.1) < 0.05);  // worked out by hand from Table 1
    QCOMPARE(glide.leastLoss(), glide.straightLoss());
    QCOMPARE(glide.glideRadii().size(), std::size_t(4));
    QVERIFY(std::is_sorted(glide.glideRadii().rbegin(), glide.glideRadii().rend()));
    QCOMPARE(glide.minRadius(), glide.glideRadii().back());
  }

  void lossPerDegreeTurned_isLeastNear53Degrees() {
    const aircraft::GlideModel glide(test::paperCessna());
    double best = 1e9;
    double bestBank = 0.0;
    for (double bank = 20.0; bank <= 70.0; bank += 0.5) {
      const double radius = glide.radiusOf(Angle::degrees(bank));
      const double perRadian = glide.lossAt(radius) * radius;
      if (perRadian < best) {
        best = perRadian;
        bestBank = bank;
      }
    }
    QVERIFY2(bestBank > 50.0 && bestBank < 56.0, qPrintable(QString::number(bestBank)));
  }

  void loss_growsWithBankAndEndsWhereDragExceedsWeight() {
    const aircraft::GlideModel glide(test::paperCessna());
    double last = glide.straightLoss();
    for (double bank = 5.0; bank <= 75.0; bank += 5.0) {
      const double loss = glide.lossAt(glide.radiusOf(Angle::degrees(bank)));
      QVERIFY(loss > last);
      last = loss;
    }
    QVERIFY(std::isinf(glide.lossAt(glide.radiusOf(Angle::degrees(85.0)))));
    QVERIFY(glide.lossAt(1e9) - glide.straightLoss() < 1e-9);  // a very wide turn is a straight line
  }

  void bankOf_isTheInverseOfRadiusOf() {
    const aircraft::GlideModel glide(test::paperCessna());
    for (double bank = 1.0; bank < 89.0; bank += 1.0) {
      QVERIFY(std::abs(glide.bankOf(glide.radiusOf(Angle::degrees(bank))).degrees() - bank) < 1e-9);
    }
  }

  void heavierAircraft_atTheSameSpeed_sinksMore() {
    aircraft::AircraftProfile heavy = test::paperCessna();
    heavy.mass_kg = 1111.0;
    QVERIFY(aircraft::GlideModel(heavy).straightLoss() > 0.0);
    QVERIFY(aircraft::GlideModel(heavy).lossAt(65.7) > aircraft::GlideModel(test::paperCessna()).lossAt(65.7));
  }

  void bankThatStalls_isWarnedOf() {
    aircraft::AircraftProfile profile = test::paperCessna();
    QVERIFY(aircraft::profileWarnings(profile).empty());  // nothing known about its stall
    profile.stallSpeed = Speed::fromSi(25.4);
    const auto warnings = aircraft::profileWarnings(profile);
    QCOMPARE(warnings.size(), std::size_t(1));
    QVERIFY(warnings[0].find("stalls") != std::string::npos && warnings[0].find("60 degrees") != std::string::npos);
    profile.glideBanks = {Angle::degrees(45.0)};
    profile.tourBank = Angle::degrees(30.0);
    QVERIFY(aircraft::profileWarnings(profile).empty());
    profile.maxLoadFactor = 1.3;
    QCOMPARE(aircraft::profileWarnings(profile).size(), std::size_t(1));
  }

  void badProfile_isABugNotANumber() {
    aircraft::AircraftProfile profile = test::paperCessna();
    profile.mass_kg = 0.0;
    QVERIFY_EXCEPTION_THROWN(aircraft::GlideModel{profile}, LogicError);
    profile = test::paperCessna();
    profile.glideBanks.push_back(Angle::degrees(90.0));
    QVERIFY_EXCEPTION_THROWN(aircraft::GlideModel{profile}, LogicError);
  }
};

QTEST_APPLESS_MAIN(TestGlideModel)
#include "tst_glide_model.moc"
