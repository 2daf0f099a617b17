// Weather cells as shown: their words, and which of them lies under the mouse.
#include "ui/document/weather_view.h"

#include <QTest>

using namespace vp;
using document::ShownWeather;

namespace {

const geo::LatLon kPlace{46.6, 9.9};
const style::Units kFeet(style::UnitSystem::Aviation);
const style::Units kMetres(style::UnitSystem::Metric);

mission::WeatherCell square(double halfSide) {
  const geo::LocalFrame frame(kPlace);
  mission::WeatherCell cell;
  for (const geo::Point corner : {geo::Point{-halfSide, -halfSide}, {halfSide, -halfSide}, {halfSide, halfSide}, {-halfSide, halfSide}}) {
    cell.outline.push_back(frame.toLatLon(corner));
  }
  return cell;
}

}  // namespace

class TestWeatherView : public QObject {
  Q_OBJECT

private slots:
  void words_areInTheUnitsOfThePilot() {
    mission::WeatherCell cell = square(1000.0);
    QCOMPARE(document::weatherTitle(cell, 2), QStringLiteral("Weather 3"));
    cell.name = "storm";
    QCOMPARE(document::weatherTitle(cell, 2), QStringLiteral("storm"));
    QCOMPARE(document::weatherAltitudes(cell, kFeet), QStringLiteral("GND to UNL"));
    cell.floor = 304.8;
    cell.top = 609.6;
    QCOMPARE(document::weatherAltitudes(cell, kFeet), QString::fromUtf8("1\u2009000 ft MSL to 2\u2009000 ft MSL"));
    QCOMPARE(document::weatherAltitudes(cell, kMetres), QStringLiteral("305 m MSL to 610 m MSL"));
    QCOMPARE(document::weatherSuccessText(cell, kFeet), QStringLiteral("90 % per NM"));
    QCOMPARE(document::weatherSuccessText(cell, kMetres), QStringLiteral("94.4 % per km"));  // 0.9^(1 / 1.852) = 0.9447
    cell.success = 0.5;
    cell.perDistance = 926.0;  // half a nautical mile
    QCOMPARE(document::weatherSuccessText(cell, kFeet), QStringLiteral("25 % per NM"));
  }

  void percent_isNeverRoundedUp() {
    QCOMPARE(document::percentText(1.0), QStringLiteral("100 %"));
    QCOMPARE(document::percentText(0.99999), QStringLiteral("99.9 %"));
    QCOMPARE(document::percentText(0.985), QStringLiteral("98.5 %"));
    QCOMPARE(document::percentText(0.9), QStringLiteral("90 %"));
    QCOMPARE(document::percentText(0.0), QStringLiteral("0 %"));
  }

  void smallestCell_underThePointer_isMeant() {
    const geo::LocalFrame frame(kPlace);
    const std::vector<ShownWeather> cells{document::shownWeather(square(500.0), frame), document::shownWeather(square(2000.0), frame)};
    QCOMPARE(document::weatherAt(cells, {0.0, 0.0}), 0);
    QCOMPARE(document::weatherAt(cells, {1500.0, 0.0}), 1);
    QCOMPARE(document::weatherAt(cells, {2500.0, 0.0}), -1);
  }

  void notch_isNotInside() {
    const geo::LocalFrame frame(kPlace);
    mission::WeatherCell cell;
    for (const geo::Point corner : {geo::Point{-1000, -1000}, {1000, -1000}, {1000, 1000}, {0, 0}, {-1000, 1000}}) {
      cell.outline.push_back(frame.toLatLon(corner));
    }
    const ShownWeather shown = document::shownWeather(cell, frame);
    QVERIFY(document::isInside(shown, {0.0, -500.0}));
    QVERIFY(document::isInside(shown, {800.0, 500.0}));
    QVERIFY(!document::isInside(shown, {0.0, 500.0}));
  }

  void problems_areSentences() {
    const geo::LocalFrame frame(kPlace);
    QVERIFY(document::weatherProblem(square(1000.0), frame).empty());
    mission::WeatherCell crossed = square(1000.0);
    std::swap(crossed.outline[0], crossed.outline[1]);
    QVERIFY(document::weatherProblem(crossed, frame).find("cross") != std::string::npos);
    mission::WeatherCell upsideDown = square(1000.0);
    upsideDown.floor = 2000.0;
    upsideDown.top = 1000.0;
    const std::string sentence = document::weatherProblem(upsideDown, frame);
    QVERIFY(!sentence.empty() && sentence.ends_with('.') && !sentence.ends_with(".."));
  }
};

QTEST_APPLESS_MAIN(TestWeatherView)
#include "tst_weather_view.moc"
