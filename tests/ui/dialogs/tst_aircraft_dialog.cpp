// The aircraft dialog: the chosen units, what nobody touched kept to the last bit, limits of wind on landing.
#include "core/formats/aircraft_file.h"
#include "ui/dialogs/aircraft_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <cmath>
#include <functional>
#include <optional>

using namespace vp;

namespace {

constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kFoot = 0.3048;
constexpr double kKmh = 1.0 / 3.6;

/// A profile of the mission whose numbers are round in no unit.
aircraft::AircraftProfile oddProfile() {
  aircraft::AircraftProfile profile = *formats::findAircraft("cessna172-handbook", "");
  profile.bestGlideSpeed = Speed::fromSi(33.45 * 1.0000001);
  profile.stallSpeed = Speed::fromSi(25.4321);
  profile.ceiling = geo::HeightMsl::fromMetres(4114.777);
  profile.maxTailwind = Speed::fromSi(0.0);  // none at all, which is not the same as no limit
  profile.maxCrosswind = Speed::fromSi(7.0123);
  return profile;
}

QDoubleSpinBox* box(const dialogs::AircraftDialog& dialog, const char* name) {
  return dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
}

}  // namespace

class TestAircraftDialog : public QObject {
  Q_OBJECT

private slots:
  void speedsAndCeiling_areInTheChosenUnits_data() {
    QTest::addColumn<int>("system");
    QTest::addColumn<QString>("speedUnit");
    QTest::addColumn<double>("speed");
    QTest::addColumn<QString>("heightUnit");
    QTest::addColumn<double>("height");
    QTest::newRow("aviation") << static_cast<int>(style::UnitSystem::Aviation) << " kt" << kKnot << " ft MSL" << kFoot;
    QTest::newRow("metric") << static_cast<int>(style::UnitSystem::Metric) << " km/h" << kKmh << " m MSL" << 1.0;
  }
  void speedsAndCeiling_areInTheChosenUnits() {
    QFETCH(int, system);
    QFETCH(QString, speedUnit);
    QFETCH(double, speed);
    QFETCH(QString, heightUnit);
    QFETCH(double, height);
    const aircraft::AircraftProfile profile = oddProfile();
    dialogs::AircraftDialog dialog(profile, {}, style::Units(static_cast<style::UnitSystem>(system)), style::Theme::Light);
    const std::vector<std::pair<const char*, double>> speeds{{"bestGlideSpeed", profile.bestGlideSpeed.si()},
                                                             {"stallSpeed", profile.stallSpeed->si()},
                                                             {"maxTailwind", 0.0},
                                                             {"maxCrosswind", profile.maxCrosswind->si()}};
    for (const auto& [name, si] : speeds) {
      QCOMPARE(box(dialog, name)->suffix(), speedUnit);
      QVERIFY2(std::abs(box(dialog, name)->value() - si / speed) <= 0.0501, name);
    }
    QCOMPARE(box(dialog, "ceiling")->suffix(), heightUnit);
    QVERIFY(std::abs(box(dialog, "ceiling")->value() - profile.ceiling->metres() / height) <= 0.501);
    if (const QString folder = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !folder.isEmpty()) {
      dialog.grab().save(folder + QStringLiteral("/aircraft-dialog-%1.png").arg(system));
    }
    // what was typed is taken in that unit, and nothing else changes
    box(dialog, "bestGlideSpeed")->setValue(120.0);
    box(dialog, "ceiling")->setValue(3000.0);
    aircraft::AircraftProfile expected = profile;
    expected.bestGlideSpeed = Speed::fromSi(dialog.profile().bestGlideSpeed.si());
    expected.ceiling = dialog.profile().ceiling;
    QVERIFY(std::abs(dialog.profile().bestGlideSpeed.si() - 120.0 * speed) < 1e-9);
    QVERIFY(std::abs(dialog.profile().ceiling->metres() - 3000.0 * height) < 1e-9);
    QVERIFY(dialog.profile() == expected);
  }

  void untouched_isKeptToTheLastBit() {
    for (const style::UnitSystem system : {style::UnitSystem::Aviation, style::UnitSystem::Metric}) {
      for (int hundredth = 0; hundredth < 100; ++hundredth) {  // halves of the last digit shown among them
        aircraft::AircraftProfile profile = oddProfile();
        const double value = 30.0 + 0.01 * hundredth;
        profile.bestGlideSpeed = Speed::fromSi(style::Units(system).speedToSi(value + 30.0));
        profile.stallSpeed = Speed::fromSi(style::Units(system).speedToSi(value));
        profile.ceiling = geo::HeightMsl::fromMetres(style::Units(system).heightToSi(3000.0 + 10.0 * value));
        profile.mass_kg = 1000.0 + 0.5 * hundredth;
        dialogs::AircraftDialog dialog(profile, {}, style::Units(system), style::Theme::Light);
        box(dialog, "zeroLiftDrag")->setValue(0.0444);
        profile.zeroLiftDrag = 0.0444;
        QVERIFY2(dialog.profile() == profile, qPrintable(QString::number(value)));
      }
    }
  }

  void limitsOfWind_areSetAndTakenAway() {
    aircraft::AircraftProfile profile = oddProfile();
    profile.maxCrosswind.reset();
    dialogs::AircraftDialog dialog(profile, {}, style::Units(), style::Theme::Light);
    QCOMPARE(box(dialog, "maxCrosswind")->text(), QStringLiteral("no limit"));
    QCOMPARE(box(dialog, "maxTailwind")->text(), QStringLiteral("0.0 kt"));
    box(dialog, "maxCrosswind")->setValue(15.0);
    QVERIFY(std::abs(dialog.profile().maxCrosswind->si() - 15.0 * kKnot) < 1e-9);
    box(dialog, "maxTailwind")->stepDown();
    QVERIFY(!dialog.profile().maxTailwind.has_value());
    QCOMPARE(box(dialog, "maxTailwind")->text(), QStringLiteral("no limit"));
    box(dialog, "maxTailwind")->setValue(1000.0);  // the box ends at what a profile may say
    QVERIFY(dialog.profile().maxTailwind->si() <= 50.0);
    QVERIFY(formats::parseAircraft(formats::aircraftToText(dialog.profile()), "profile").has_value());
  }

  void whatAProfileNeedNotSay_isSetAndTakenAway_data() {
    using P = aircraft::AircraftProfile;
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("shown");
    QTest::addColumn<std::function<std::optional<double>(const P&)>>("value");
    QTest::addColumn<double>("si");
    const auto row = [](const char* name, double shown, std::function<std::optional<double>(const P&)> value, double si) {
      QTest::newRow(name) << QString(name) << shown << std::move(value) << si;
    };
    const auto number = [](const auto& quantity) { return quantity ? std::optional(quantity->si()) : std::nullopt; };
    row(
        "leastMass", 700.0, [](const P& p) { return p.leastMass_kg; }, 700.0);
    row(
        "mostMass", 1111.0, [](const P& p) { return p.mostMass_kg; }, 1111.0);
    row(
        "windmillingDrag", 0.0555, [](const P& p) { return p.windmillingDrag; }, 0.0555);
    row(
        "stoppedDrag", 0.0444, [](const P& p) { return p.stoppedDrag; }, 0.0444);
    row(
        "steepestDescent", 9.0, [](const P& p) { return p.steepestDescent ? std::optional(p.steepestDescent->degrees()) : std::nullopt; }, 9.0);
    row(
        "rollRate", 15.0, [](const P& p) { return p.rollRate_dps; }, 15.0);
    row(
        "maxSpeed", 150.0, [number](const P& p) { return number(p.maxSpeed); }, 150.0 * kKnot);
    row(
        "landingDistance", 1500.0, [number](const P& p) { return number(p.landingDistance); }, 1500.0 * kFoot);
    row(
        "climbRate", 600.0, [number](const P& p) { return number(p.climbRate); }, 600.0 * kFoot / 60.0);
    row(
        "serviceCeiling", 13000.0, [](const P& p) { return p.serviceCeiling ? std::optional(p.serviceCeiling->metres()) : std::nullopt; },
        13000.0 * kFoot);
  }
  void whatAProfileNeedNotSay_isSetAndTakenAway() {
    QFETCH(QString, name);
    QFETCH(double, shown);
    QFETCH(std::function<std::optional<double>(const aircraft::AircraftProfile&)>, value);
    QFETCH(double, si);
    dialogs::AircraftDialog dialog(oddProfile(), {}, style::Units(), style::Theme::Light);
    QDoubleSpinBox* field = box(dialog, name.toUtf8().constData());
    field->setValue(shown);
    QVERIFY(value(dialog.profile()) && std::abs(*value(dialog.profile()) - si) < 1e-9);
    field->setValue(0.0);
    QCOMPARE(field->text(), QStringLiteral("not given"));
    QVERIFY(!value(dialog.profile()));
  }

  void massOutOfItsRange_cannotBeTaken() {
    dialogs::AircraftDialog dialog(oddProfile(), {}, style::Units(), style::Theme::Light);
    box(dialog, "mostMass")->setValue(900.0);  // the polar is that of 1043 kg
    QVERIFY2(dialog.findChild<QLabel*>(QStringLiteral("aircraftProblem"))->text().contains("below the mass of the polar, 1043 kg"), "says why");
    QVERIFY(!dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
  }

  void bundledProfile_isNotChanged() {
    const aircraft::AircraftProfile profile = *formats::findAircraft("cessna172-handbook", "");
    dialogs::AircraftDialog dialog(profile, "cessna172-handbook", style::Units(), style::Theme::Light);
    QVERIFY(box(dialog, "maxTailwind")->isReadOnly());
    box(dialog, "maxTailwind")->setValue(20.0);
    QVERIFY(dialog.profile() == profile);
  }
};

QTEST_MAIN(TestAircraftDialog)
#include "tst_aircraft_dialog.moc"
