#include "core/base/quantity.h"

#include <QTest>

#include <limits>
#include <random>
#include <type_traits>

using namespace vp;
using namespace vp::literals;

template <typename A, typename B>
concept Addable = requires(A a, B b) {
  a + b;
};

static_assert(sizeof(Length) == sizeof(double) && std::is_trivially_copyable_v<Length>);
static_assert(std::is_same_v<decltype(Speed{} * Speed{} / Acceleration{}), Length>);
static_assert(std::is_same_v<decltype(Length{} / Length{}), double>);
static_assert(std::is_same_v<decltype(Length{} * Length{}), Area>);
static_assert(std::is_same_v<decltype(Length{} / Duration{}), Speed>);
static_assert(Addable<Length, Length> && !Addable<Length, Duration> && !Addable<Length, Speed> && !Addable<Length, double>);
static_assert(!std::is_convertible_v<double, Length> && !std::is_constructible_v<Length, double>);
static_assert(!std::is_convertible_v<double, Angle> && !std::is_constructible_v<Angle, double>);

class TestQuantity : public QObject {
  Q_OBJECT

private slots:
  void literals_inOtherUnits_giveSi_data() {
    QTest::addColumn<double>("si");
    QTest::addColumn<double>("expected");
    QTest::newRow("metres") << (250.0_m).si() << 250.0;
    QTest::newRow("feet") << (3000.0_ft).si() << 914.4;
    QTest::newRow("nautical miles") << (1.5_nm).si() << 2778.0;
    QTest::newRow("metres per second") << (33.4_mps).si() << 33.4;
    QTest::newRow("knots") << (3600.0_kt).si() << 1852.0;
    QTest::newRow("seconds") << (20.0_s).si() << 20.0;
    QTest::newRow("degrees") << (180.0_deg).radians() << Angle::kPi;
    QTest::newRow("radians") << (1.25_rad).radians() << 1.25;
  }
  void literals_inOtherUnits_giveSi() {
    QFETCH(double, si);
    QFETCH(double, expected);
    QCOMPARE(si, expected);
  }

  void arithmetic_keepsDimensions() {
    const Length radius = 33.4_mps * 33.4_mps / (kGravity * tan(60.0_deg));
    QVERIFY(std::abs(radius.si() - 65.7) < 0.05);  // Vana, Faigl, Slama 2020, Table 1
    QCOMPARE((100.0_m + 20.0_m - 5.0_m).si(), 115.0);
    QCOMPARE((-(3.0_m)).si(), -3.0);
    QCOMPARE((2.0 * 3.0_m / 4.0).si(), 1.5);
    QCOMPARE(10.0_m / 4.0_m, 2.5);
    QVERIFY(1.0_nm > 1851.0_m && 1.0_ft < 1.0_m && 0.3048_m == 1.0_ft);
  }

  void angle_conversions_roundTrip() {
    QCOMPARE(Angle::degrees(4.9).degrees(), 4.9);
    QCOMPARE((30.0_deg + 60.0_deg - 45.0_deg).degrees(), 45.0);
    QVERIFY(std::abs(sin(30.0_deg) - 0.5) < 1e-15 && std::abs(cos(60.0_deg) - 0.5) < 1e-15 && std::abs(tan(45.0_deg) - 1.0) < 1e-15);
    QCOMPARE((-(15.0_deg) * 2.0).degrees(), -30.0);
  }

  void wrap_atItsEnds_staysInside() {
    constexpr double kTwoPi = 2.0 * Angle::kPi;
    QCOMPARE(wrapTwoPi(0.0), 0.0);
    QCOMPARE(wrapTwoPi(kTwoPi), 0.0);
    QCOMPARE(wrapTwoPi(-kTwoPi), 0.0);
    QVERIFY(wrapTwoPi(-1e-18) >= 0.0 && wrapTwoPi(-1e-18) < kTwoPi);
    QVERIFY(wrapTwoPi(-std::numeric_limits<double>::denorm_min()) < kTwoPi);
    QCOMPARE(wrapPi(Angle::kPi), -Angle::kPi);
    QCOMPARE(wrapPi(-Angle::kPi), -Angle::kPi);
    QVERIFY(std::abs(wrapPi(3.0 * Angle::kPi / 2.0) + Angle::kPi / 2.0) < 1e-15);
  }

  void wrap_ofRandomAngles_keepsDirectionAndRange() {
    constexpr unsigned kSeed = 20240601;
    qInfo("seed %u", kSeed);
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> angles(-1000.0, 1000.0);
    for (int k = 0; k < 10'000; ++k) {
      const double angle = angles(generator);
      const double positive = wrapTwoPi(angle);
      const double centred = wrapPi(angle);
      QVERIFY(positive >= 0.0 && positive < 2.0 * Angle::kPi);
      QVERIFY(centred >= -Angle::kPi && centred < Angle::kPi);
      QVERIFY(std::abs(std::sin(positive) - std::sin(angle)) < 1e-12 && std::abs(std::cos(positive) - std::cos(angle)) < 1e-12);
      QVERIFY(std::abs(std::sin(centred) - std::sin(angle)) < 1e-12 && std::abs(std::cos(centred) - std::cos(angle)) < 1e-12);
    }
  }
};

QTEST_APPLESS_MAIN(TestQuantity)
#include "tst_quantity.moc"
