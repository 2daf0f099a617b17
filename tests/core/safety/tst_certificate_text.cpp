// What a certificate says about the conditions that it holds for, and what it warns of.

#include "tests/core/safety/plan_fixture.h"

#include <QTest>

using namespace vp;

namespace {

using Fixture = test::PlanFixture;
using Change = std::function<void(Fixture&)>;

safety::SafetyReport certified(const Change& change) {
  Fixture fixture;
  change(fixture);
  fixture.refit();
  return test::checkedPlan(fixture);
}

std::string warningsOf(const safety::SafetyReport& report) {
  std::string all;
  for (const std::string& text : report.certificate->warnings) {
    all += text + "\n";
  }
  return all;
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestCertificateText : public QObject {
  Q_OBJECT

private slots:
  void settingsOfThePapers_sayNothingMore() {
    const safety::SafetyReport report = certified([](Fixture&) {});
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    QVERIFY2(report.certificate->statement.ends_with("rolling into turns is not modelled and is covered by the clearance only."),
             report.certificate->statement.c_str());
    QVERIFY(report.certificate->warnings.empty());
  }

  void statement_namesTheConditions_data() {
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, const char* text, Change change) { QTest::newRow(name) << change << QString(text); };
    row("air", " It holds from 0 to 600 m MSL in air 10.5 K warmer than the standard atmosphere under a QNH of 1003.5 hPa,", [](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{10.5, 1003.5};
    });
    row("standard air", " m MSL in air as warm as the standard atmosphere under a QNH of 1013.25 hPa,",
        [](Fixture& f) { f.mission().atmosphere = air::Atmosphere(); });
    row("cold air", " in air 20 K colder than the standard atmosphere", [](Fixture& f) { f.mission().atmosphere = air::Atmosphere{-20.0, 1013.25}; });
    row("airspeeds of the air", "gliding at 33.2 to 34.2 m/s in calm air", [](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{-3.0, 1013.25};
    });
    const Change setMasses = [](Fixture& f) {
      f.mission().aircraft.leastMass_kg = 900.0;
      f.mission().aircraft.mostMass_kg = 1157.0;
    };
    row("masses", " It holds for every mass from 900 to 1157 kg, at the best glide speed of the mass.", setMasses);
    row("airspeeds of the masses", "gliding at 30.1 to 34.1 m/s in calm air with the polar", setMasses);
    row("drag", " The drag is counted as 1.05 times that of the polar.", [](Fixture& f) { f.mission().safety.dragFactor = 1.05; });
    row("glide ratio with drag", "(glide ratio 10.8 straight ahead)", [](Fixture& f) { f.mission().safety.dragFactor = 1.05; });
    row("windmill", " The propeller is taken to windmill after the failure.", [](Fixture& f) {
      f.mission().aircraft.windmillingDrag = 0.036;
      f.mission().propeller = aircraft::Propeller::Windmilling;
    });
    row("stopped propeller", " The propeller is taken to stand still after the failure.", [](Fixture& f) {
      f.mission().aircraft.stoppedDrag = 0.033;
      f.mission().propeller = aircraft::Propeller::Stopped;
    });
    row("speed of the tour", " The tour is flown at a true airspeed of 55.0 m/s (65 %).", [](Fixture& f) {
      f.mission().aircraft.powerSettings = {{"65 %", Speed::fromSi(55.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
      f.mission().powerSetting = "65 %";
    });
    row("reaction", " the pilot may take 4 s to react: for 133 m every glide follows the tour or goes straight on.",
        [](Fixture& f) { f.mission().safety.reactionTime = Duration::fromSi(4.0); });
    row("reaction loss", " it may lose 25.5 m of height besides.", [](Fixture& f) { f.mission().safety.reactionLoss = Length::fromSi(25.5); });
    row("final", " Every glide ends in a straight final of 1000 m.", [](Fixture& f) { f.mission().approach.kind = mission::ApproachKind::Straight; });
    row("slope", " Every glide ends in a straight final of 1000 m, flown at 6.5 degrees.", [](Fixture& f) {
      f.mission().approach.kind = mission::ApproachKind::Straight;
      f.mission().approach.slope = Angle::degrees(6.5);
      f.mission().aircraft.steepestDescent = Angle::degrees(12.0);
    });
    row("overhead", " Every glide ends in one full circle from above the touchdown point, begun at least 200 m above it.", [](Fixture& f) {
      f.mission().approach.kind = mission::ApproachKind::Overhead;
      f.mission().approach.keyHeight = Length::fromSi(200.0);
    });
    row("obstacle surface", " an obstacle surface that begins 60 m before the touchdown point and rises by 5 %.", [](Fixture& f) {
      f.mission().approach.kind = mission::ApproachKind::Straight;
      f.mission().approach.surfaceSlope = 0.05;
    });
    row("hold", " Before every approach there is room for a hold, down to its altitude in the plan.", [](Fixture& f) {
      f.mission().approach.hold = true;
      f.plan().holds = {{0, flight::Turn::Left, 200.0, 200.0}};
    });
    row("runways", " long enough for an aircraft that lands in 400 m at sea level,",
        [](Fixture& f) { f.mission().aircraft.landingDistance = Length::fromSi(400.0); });
  }

  void statement_namesTheConditions() {
    QFETCH(Change, change);
    QFETCH(QString, text);
    const safety::SafetyReport report = certified(change);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    QVERIFY2(report.certificate->statement.find(text.toStdString()) != std::string::npos, report.certificate->statement.c_str());
  }

  void warnings_areGivenWhereTheyApply_data() {
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("text");
    QTest::newRow("cold air") << Change([](Fixture& f) {
      f.mission().atmosphere = air::Atmosphere{-35.0, 1013.25};
    }) << "shows about 84 m too much at the highest point (600 m MSL), and about 84 m where";
    QTest::newRow("propeller that the profile does not know")
        << Change([](Fixture& f) { f.mission().propeller = aircraft::Propeller::Windmilling; }) << "gives no drag for a windmilling propeller";
    QTest::newRow("faster than allowed") << Change([](Fixture& f) {
      f.mission().aircraft.maxSpeed = Speed::fromSi(34.0);
      f.mission().aircraft.mostMass_kg = 1200.0;
    }) << "above the aircraft's limit of 34.0 m/s";
  }

  void warnings_areGivenWhereTheyApply() {
    QFETCH(Change, change);
    QFETCH(QString, text);
    const safety::SafetyReport report = certified(change);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    QCOMPARE(report.certificate->warnings.size(), std::size_t{1});
    QVERIFY2(warningsOf(report).find(text.toStdString()) != std::string::npos, warningsOf(report).c_str());
  }

  void warmAir_needsNoWarning() {
    const safety::SafetyReport report = certified([](Fixture& f) { f.mission().atmosphere = air::Atmosphere{10.0, 1013.25}; });
    QVERIFY(report.isSafe() && report.certificate->warnings.empty());
  }
};

QTEST_APPLESS_MAIN(TestCertificateText)
#include "tst_certificate_text.moc"
