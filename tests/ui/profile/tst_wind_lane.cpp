// The wind as somebody on the tour feels it: its parts, its words, and the lane of arrows that only a windy profile has.
#include "tests/support/planned_tour.h"
#include "ui/profile/profile_renderer.h"
#include "ui/profile/wind_lane.h"

#include <QGuiApplication>
#include <QPainter>
#include <QTest>

#include <cmath>

using namespace vp;

namespace {

constexpr QSize kSize(1100, 320);

document::Situation windy(const document::Situation& situation, double spread, double least, double most) {
  return test::withChangedPlan(situation, [&](mission::Plan& plan) {
    plan.mission.wind = {{geo::HeightMsl::fromMetres(0.0), {270.0, spread, least * kMpsPerKnot, most * kMpsPerKnot}}};
  });
}

document::TourState onCourse(double heading) {
  document::TourState state;
  state.pose = {0.0, 0.0, heading};
  return state;
}

}  // namespace

class TestWindLane : public QObject {
  Q_OBJECT

  document::Situation calm_;

private slots:
  void initTestCase() { calm_ = test::plannedSituation(); }

  void stillAir_isNoWind() { QVERIFY(!profile::courseWind(*calm_.plan, onCourse(1.0))); }

  void wind_isTakenApartByTheCourse_data() {
    QTest::addColumn<double>("heading");
    QTest::addColumn<double>("tail");
    QTest::addColumn<double>("left");
    QTest::addColumn<QString>("words");
    QTest::newRow("east, with the wind") << 0.0 << 20.0 << 0.0 << QStringLiteral("20 kt tail");
    QTest::newRow("west, against it") << Angle::kPi << -20.0 << 0.0 << QStringLiteral("20 kt head");
    QTest::newRow("north") << 0.5 * Angle::kPi << 0.0 << -20.0 << QStringLiteral("20 kt from the left");
    QTest::newRow("south") << -0.5 * Angle::kPi << 0.0 << 20.0 << QStringLiteral("20 kt from the right");
    QTest::newRow("north-east") << 0.25 * Angle::kPi << 20.0 * std::sqrt(0.5) << -20.0 * std::sqrt(0.5)
                                << QStringLiteral("14 kt tail, 14 kt from the left");
  }

  void wind_isTakenApartByTheCourse() {
    QFETCH(double, heading);
    QFETCH(double, tail);
    QFETCH(double, left);
    QFETCH(QString, words);
    const document::Situation situation = windy(calm_, 0.0, 20.0, 20.0);
    const auto wind = profile::courseWind(*situation.plan, onCourse(heading));
    QVERIFY(wind);
    QVERIFY(std::abs(wind->tail - tail * kMpsPerKnot) < 1e-9);
    QVERIFY(std::abs(wind->left - left * kMpsPerKnot) < 1e-9);
    QCOMPARE(profile::courseWindText(*situation.plan, *wind, style::Units()), words);
  }

  void range_isSaidToBeAbout() {
    const document::Situation situation = windy(calm_, 20.0, 10.0, 20.0);
    const auto wind = profile::courseWind(*situation.plan, onCourse(0.0));
    QVERIFY(wind);
    QCOMPARE(profile::courseWindText(*situation.plan, *wind, style::Units()), QStringLiteral("about 15 kt tail"));
  }

  void lane_isThereInWindOnly() {
    const profile::ProfileStyle style{style::Theme::Light, style::Units(), QGuiApplication::font()};
    const document::Situation situation = windy(calm_, 20.0, 10.0, 20.0);
    const profile::ProfileRenderer still(calm_, style, kSize);
    const profile::ProfileRenderer blown(situation, style, kSize);
    QCOMPARE(blown.scale().area().top(), still.scale().area().top() + profile::kWindLane);
    const QImage picture = profile::renderProfile(situation, kSize, 1.0, style::Theme::Light, style::Units());
    test::keepPicture(picture, QStringLiteral("profile-wind"));
    test::keepPicture(profile::renderProfile(situation, kSize, 1.0, style::Theme::Dark, style::Units()), QStringLiteral("profile-wind-dark"));
    const QRectF lane(blown.scale().area().left(), blown.scale().area().top() - profile::kWindLane, blown.scale().area().width(), profile::kWindLane);
    int arrows = 0;
    for (int x = static_cast<int>(lane.left()); x < static_cast<int>(lane.right()); ++x) {
      for (int y = static_cast<int>(lane.top()) + 1; y < static_cast<int>(lane.bottom()); ++y) {
        arrows += picture.pixelColor(x, y) == style.colors().mutedText ? 1 : 0;
      }
    }
    QVERIFY2(arrows > 200, qPrintable(QString::number(arrows)));
  }

  void lowPlot_keepsItsHeight() {
    const profile::ProfileStyle style{style::Theme::Light, style::Units(), QGuiApplication::font()};
    const QSizeF low(1100.0, 150.0);
    QCOMPARE(profile::ProfileRenderer(windy(calm_, 0.0, 20.0, 20.0), style, low).scale().area(),
             profile::ProfileRenderer(calm_, style, low).scale().area());
  }
};

QTEST_MAIN(TestWindLane)
#include "tst_wind_lane.moc"
