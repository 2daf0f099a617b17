// Values as a pilot reads them: unit, datum, and rounding that never flatters.
#include "ui/style/units.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using style::Units;
using style::UnitSystem;

namespace {

constexpr double kFoot = 0.3048;  // m, international foot, exact
const Units kFeet(UnitSystem::Aviation);
const Units kMetres(UnitSystem::Metric);

/// The number of a text like "−1 230 ft", without its grouping.
double numberOf(QString text) {
  text.remove(QChar(0x2009));
  text.replace(QChar(0x2212), QLatin1Char('-'));
  const qsizetype end = text.indexOf(QLatin1Char(' '));
  return text.left(end).toDouble();
}

}  // namespace

class TestUnits : public QObject {
  Q_OBJECT

private slots:
  void words_data() {
    QTest::addColumn<QString>("shown");
    QTest::addColumn<QString>("expected");
    QTest::newRow("altitude ft") << kFeet.altitudeMsl(1975.104) << "6 480 ft MSL";
    QTest::newRow("altitude m") << kMetres.altitudeMsl(1975.4) << "1 975 m MSL";
    QTest::newRow("variation east") << Units::variation(3.14) << "3.1° E";
    QTest::newRow("variation west") << Units::variation(-12.96) << "13.0° W";
    QTest::newRow("below the sea") << kMetres.altitudeMsl(-12.0) << "−12 m MSL";
    QTest::newRow("large") << kMetres.altitudeMsl(1234567.0) << "1 234 567 m MSL";
    QTest::newRow("required up") << kMetres.requiredMsl(1000.01) << "1 001 m MSL";
    QTest::newRow("required whole") << kMetres.requiredMsl(1000.0) << "1 000 m MSL";
    QTest::newRow("above ground down") << kMetres.heightAboveGround(99.99) << "99 m AGL";
    QTest::newRow("margin down") << kMetres.margin(150.9) << "+150 m";
    QTest::newRow("no margin") << kMetres.margin(0.4) << "0 m";
    QTest::newRow("a little missing") << kMetres.margin(-0.2) << "−1 m";
    QTest::newRow("margin ft") << kFeet.margin(103.632) << "+340 ft";
    QTest::newRow("converted whole") << kFeet.margin(100.0 * kFoot) << "+100 ft";
    QTest::newRow("height") << kFeet.height(103.632) << "340 ft";
    QTest::newRow("distance NM") << kFeet.distance(12.4 * 1852.0) << "12.4 NM";
    QTest::newRow("distance km") << kMetres.distance(22'960.0) << "23.0 km";
    QTest::newRow("far") << kMetres.distance(345'678.0) << "346 km";
    QTest::newRow("runway ft") << kFeet.shortDistance(900.0) << "2 953 ft";
    QTest::newRow("runway m") << kMetres.shortDistance(900.0) << "900 m";
    QTest::newRow("speed kt") << kFeet.speed(35.0) << "68 kt";
    QTest::newRow("speed km/h") << kMetres.speed(35.0) << "126 km/h";
    QTest::newRow("sink ft/min") << kFeet.verticalSpeed(-3.25) << "−640 ft/min";
    QTest::newRow("sink m/s") << kMetres.verticalSpeed(-3.24) << "−3.2 m/s";
    QTest::newRow("no sink") << kMetres.verticalSpeed(-0.01) << "0.0 m/s";
    QTest::newRow("minutes") << Units::duration(245.0) << "4:05 min";
    QTest::newRow("next minute") << Units::duration(59.6) << "1:00 min";
    QTest::newRow("hours") << Units::duration(4320.0) << "1:12:00 h";
    QTest::newRow("course") << Units::course(43.2) << "043° T";
    QTest::newRow("north") << Units::course(0.0) << "360° T";
    QTest::newRow("almost north") << Units::course(359.7) << "360° T";
    QTest::newRow("position") << Units::position({46.0 + 36.02 / 60.0, 9.0 + 54.1 / 60.0}) << "46°36.02′ N  009°54.10′ E";
    QTest::newRow("south west") << Units::position({-0.5, -179.9999999}) << "00°30.00′ S  180°00.00′ W";
    QTest::newRow("next degree") << Units::position({9.99999999, 0.0}) << "10°00.00′ N  000°00.00′ E";
    QTest::newRow("sentence") << kFeet.inSentence("it is at 312.5 m MSL, 0.2 m below the 1524 m required.")
                              << "it is at 1 025.3 ft MSL, 0.7 ft below the 5 000 ft required.";
    QTest::newRow("sentence, far") << kFeet.inSentence("the closest is LSZS 03, 9.3 km away") << "the closest is LSZS 03, 5.0 NM away";
    QTest::newRow("sentence, pairs") << kFeet.inSentence("between 300 and 400 m, from -30 to 60 m, 46 x 67 km; 30 and 45 m")
                                     << "between 984 and 1 312 ft, from −98 to 197 ft, 24.8 x 36.2 NM; 30 and 148 ft";
    QTest::newRow("sentence, others") << kFeet.inSentence("12 m/s, 3 m2, 5 mm, 4 m² and 8 min stay, v1.5 m too")
                                      << "12 m/s, 3 m2, 5 mm, 4 m² and 8 min stay, v1.5 m too";
    QTest::newRow("sentence, metric") << kMetres.inSentence("it is 312.5 m MSL, 9.3 km away") << "it is 312.5 m MSL, 9.3 km away";
    QTest::newRow("angle") << Units::angle(4.904) << "4.9°";
  }

  void words() {
    QFETCH(QString, shown);
    QFETCH(QString, expected);
    shown.replace(QChar(0x2009), QLatin1Char(' '));  // grouping is a thin space
    QCOMPARE(shown, expected);
  }

  /// Sign and size: what is shown of a margin or clearance is never more than there is, of a required altitude never less.
  void rounding_neverFlatters() {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> metres(-3000.0, 9000.0);
    for (int i = 0; i < 20'000; ++i) {
      const double value = metres(random);
      for (const Units& units : {kFeet, kMetres}) {
        const double exact = units.heightFromSi(value);
        const double margin = numberOf(units.margin(value));
        QVERIFY(margin <= exact + 1e-5 && margin > exact - 1.0);
        const double above = numberOf(units.heightAboveGround(value));
        QVERIFY(above <= exact + 1e-5 && above > exact - 1.0);
        const double required = numberOf(units.requiredMsl(value));
        QVERIFY(required >= exact - 1e-5 && required < exact + 1.0);
        QVERIFY(std::abs(numberOf(units.altitudeMsl(value)) - exact) <= 0.5);
      }
    }
  }

  void margin_keepsItsSign() {
    for (const double missing : {1e-3, 0.1, 0.3, 0.9}) {
      QVERIFY(kFeet.margin(-missing).startsWith(QChar(0x2212)));
      QVERIFY(kMetres.margin(-missing).startsWith(QChar(0x2212)));
    }
  }

  void conversion_comesBack() {
    for (const Units& units : {kFeet, kMetres}) {
      QVERIFY(std::abs(units.heightToSi(units.heightFromSi(1234.5)) - 1234.5) < 1e-9);
      QVERIFY(std::abs(units.distanceToSi(units.distanceFromSi(98765.4)) - 98765.4) < 1e-9);
    }
    QCOMPARE(kFeet.heightUnit(), QStringLiteral("ft"));
    QCOMPARE(kMetres.distanceUnit(), QStringLiteral("km"));
    QVERIFY(kFeet == Units() && !(kFeet == kMetres));
  }
};

QTEST_APPLESS_MAIN(TestUnits)
#include "tst_units.moc"
