// Against the test values that come with the model (NOAA NCEI, WMM2025_TEST_VALUES.txt), printed there to 0.01 degrees and 1e-6 nT.
#include "core/geo/magnetic_field.h"

#include <QTest>

#include <cmath>

using namespace vp;
using namespace vp::geo;

class TestMagneticField : public QObject {
  Q_OBJECT

private slots:
  void field_atPublishedPlaces_isPublishedValue_data() {
    QTest::addColumn<double>("year");
    QTest::addColumn<double>("height_km");
    QTest::addColumn<double>("latitude");
    QTest::addColumn<double>("longitude");
    QTest::addColumn<double>("variation_deg");
    QTest::addColumn<double>("north");
    QTest::addColumn<double>("east");
    QTest::addColumn<double>("down");
    QTest::newRow("near the pole") << 2025.0 << 28.0 << 89.0 << -121.0 << -99.77 << -255.388723 << -1482.460628 << 56194.288771;
    QTest::newRow("Mongolia") << 2025.0 << 65.0 << 43.0 << 93.0 << 0.50 << 24299.852822 << 210.517066 << 50037.923998;
    QTest::newRow("off Perth") << 2025.0 << 51.0 << -33.0 << 109.0 << -5.49 << 21737.778822 << -2090.274098 << -52710.00392;
    QTest::newRow("south Pacific") << 2025.5 << 6.0 << -36.0 << -137.0 << 20.28 << 23781.930678 << 8786.698927 << -32577.518648;
    QTest::newRow("off Antarctica") << 2025.5 << 8.0 << -66.0 << 17.0 << -33.14 << 15201.438652 << -9925.501123 << -30881.123197;
    QTest::newRow("south Atlantic") << 2026.0 << 74.0 << -57.0 << 3.0 << -22.51 << 13268.119649 << -5498.179626 << -23576.062921;
    QTest::newRow("Indian Ocean") << 2026.0 << 62.0 << -14.0 << 99.0 << -1.43 << 33437.82863 << -835.919473 << -33100.922253;
    QTest::newRow("equator") << 2026.5 << 14.0 << 0.0 << 80.0 << -3.10 << 39431.415992 << -2133.456168 << -12188.838466;
    QTest::newRow("Weddell Sea") << 2027.0 << 37.0 << -66.0 << -5.0 << -17.22 << 16390.771268 << -5079.626554 << -28608.243575;
    QTest::newRow("south magnetic pole") << 2027.5 << 73.0 << -72.0 << 95.0 << -102.64 << -2912.418045 << -12984.118939 << -55399.217725;
  }
  void field_atPublishedPlaces_isPublishedValue() {
    QFETCH(double, year);
    QFETCH(double, height_km);
    QFETCH(double, latitude);
    QFETCH(double, longitude);
    QFETCH(double, variation_deg);
    QFETCH(double, north);
    QFETCH(double, east);
    QFETCH(double, down);
    const MagneticField field = magneticField({latitude, longitude}, HeightMsl::fromMetres(1000.0 * height_km), year);
    QVERIFY2(std::abs(field.north - north) < 1e-3, qPrintable(QString::number(field.north, 'f', 6)));
    QVERIFY2(std::abs(field.east - east) < 1e-3, qPrintable(QString::number(field.east, 'f', 6)));
    QVERIFY2(std::abs(field.down - down) < 1e-3, qPrintable(QString::number(field.down, 'f', 6)));
    QVERIFY2(std::abs(field.variation().degrees() - variation_deg) <= 0.0051, qPrintable(QString::number(field.variation().degrees())));
    QVERIFY(std::abs(field.horizontal() - std::hypot(north, east)) < 2e-3);
  }

  void decimalYear_ofDays_countsTheYearsOwnLength() {
    using namespace std::chrono;
    QVERIFY(std::abs(decimalYear(2026y / January / 1) - (2026.0 + 0.5 / 365.0)) < 1e-9);
    QVERIFY(std::abs(decimalYear(2028y / December / 31) - (2028.0 + 365.5 / 366.0)) < 1e-9);
    QVERIFY(decimalYear(today()) > 2026.0);
  }

  void compass_atTheMagneticPole_isOfNoUse() {
    // two of the published places: 1504 and 39489 nT
    QVERIFY(!magneticField({89.0, -121.0}, HeightMsl::fromMetres(28000.0), 2025.0).movesACompass());
    QVERIFY(magneticField({0.0, 80.0}, HeightMsl::fromMetres(14000.0), 2026.5).movesACompass());
  }

  void covered_outsideTheModelsYears_isFalse() {
    QVERIFY(!isCoveredByMagneticModel(2024.9));
    QVERIFY(isCoveredByMagneticModel(2025.0));
    QVERIFY(isCoveredByMagneticModel(2029.99));
    QVERIFY(!isCoveredByMagneticModel(2030.0));
    QCOMPARE(magneticModelName(), std::string("World Magnetic Model WMM-2025 (NOAA NCEI, BGS), valid 2025 to 2029"));
  }
};

QTEST_APPLESS_MAIN(TestMagneticField)
#include "tst_magnetic_field.moc"
